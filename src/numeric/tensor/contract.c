#include "numeric/tensor/contract.h"

#include "core/memory.h"

#include <string.h>

/* A packed panel of this many numbers stays in the second-level cache while all of V passes by. */
enum { PANEL_SIZE = 64 * 1024, COLUMNS_MAX = 240, UNITS_MIN = 4, UNITS_MAX = 60 };

static const double zeros[COLUMNS_MAX];

taut_lines taut_lines_first(size_t nu, size_t nv, size_t nrhs)
{
    (void)nu;
    return (taut_lines){nv * nrhs, nv * nrhs, nv * nrhs, 0};
}

taut_lines taut_lines_second(size_t nu, size_t nv, size_t nrhs)
{
    return (taut_lines){nu * nrhs, nrhs, nrhs, nv * nrhs};
}

taut_status taut_panel_init(const taut_modes *modes, taut_panel *panel)
{
    const size_t unit = (size_t)modes->kernel->tile_columns, n = (size_t)modes->n;
    const size_t least = (n + 1) * UNITS_MIN * unit;
    panel->modes = modes;
    panel->in = taut_alloc_aligned(least > PANEL_SIZE ? least : PANEL_SIZE, sizeof(double));
    panel->out =
        taut_alloc_aligned(2 * (size_t)modes->kernel->tile_rows * COLUMNS_MAX, sizeof(double));
    return panel->in == NULL || panel->out == NULL ? TAUT_NO_MEMORY : TAUT_OK;
}

void taut_panel_clear(taut_panel *panel)
{
    taut_free(panel->in);
    taut_free(panel->out);
    *panel = (taut_panel){NULL, NULL, NULL};
}

/* The columns to take from `first` on, when `depth` numbers of each are packed. */
static size_t columns_for(const taut_panel *panel, const taut_lines *lines, size_t first,
                          size_t depth)
{
    const size_t unit = (size_t)panel->modes->kernel->tile_columns;
    size_t units = PANEL_SIZE / unit / (depth > 0 ? depth : 1);
    units = units < UNITS_MIN ? UNITS_MIN : units > COLUMNS_MAX / unit ? COLUMNS_MAX / unit : units;
    const size_t left = lines->columns - first;
    return left < units * unit ? left : units * unit;
}

static size_t round_up(size_t count, size_t unit)
{
    return (count + unit - 1) / unit * unit;
}

/* ---- rows of the net to and from contiguous rows ---- */

static size_t offset_of(const taut_lines *lines, size_t column)
{
    return column / lines->inner * lines->outer + column % lines->inner;
}

/* The columns from `column` on that are neighbours in memory, `limit` at most. */
static size_t run_of(const taut_lines *lines, size_t column, size_t limit)
{
    const size_t run = lines->inner - column % lines->inner;
    return run < limit ? run : limit;
}

/* to[q] = x(row, first + q), q < count */
static void read_row(const taut_lines *lines, const double *x, size_t row, size_t first,
                     size_t count, double *to)
{
    for (size_t q = 0; q < count;) {
        const size_t run = run_of(lines, first + q, count - q);
        const double *from = x + row * lines->stride + offset_of(lines, first + q);
        for (size_t r = 0; r < run; r++) {
            to[q++] = from[r];
        }
    }
}

/* Some rows of a product, double[rows][width], on their way to rows first_row, first_row + step, ..
 * of a net. */
struct put {
    const taut_lines *lines;
    size_t first, count, width; /* columns */
    int is_new;                 /* replaces what is there, else is added */
};

static void put_rows(const struct put *put, size_t rows, const double *from, size_t first_row,
                     ptrdiff_t step, double *x)
{
    const ptrdiff_t stride = step * (ptrdiff_t)put->lines->stride;
    for (size_t q = 0; q < put->count;) {
        const size_t run = run_of(put->lines, put->first + q, put->count - q);
        double *to = x + first_row * put->lines->stride + offset_of(put->lines, put->first + q);
        for (size_t r = 0; r < rows; r++, to += stride) {
            const double *row = from + r * put->width + q;
            for (size_t c = 0; c < run; c++) {
                to[c] = put->is_new ? row[c] : to[c] + row[c];
            }
        }
        q += run;
    }
}

/* ---- packed operands and their products ---- */

/* Rows of a sliver that are not all zero: up to two runs, the longest run of zeros between them. */
struct depth_runs {
    size_t start[2], end[2];
    size_t zeros_from; /* start of the current run of zeros */
};

static void note_row(struct depth_runs *runs, size_t row)
{
    const size_t gap = row - runs->zeros_from;
    if (gap > runs->start[1] - runs->end[0]) {
        runs->end[0] = runs->zeros_from;
        runs->start[1] = row;
    }
    runs->zeros_from = row + 1;
    runs->end[1] = row + 1;
}

static int is_zero(const double *row, size_t count)
{
    for (size_t q = 0; q < count; q++) {
        if (row[q] != 0.0) {
            return 0;
        }
    }
    return 1;
}

/* A in slivers double[rows/t][a_depth][t], B in slivers double[width/unit][b_depth][unit]. */
struct operands {
    const double *a;
    double *b;
    size_t a_depth, b_depth;
    struct depth_runs runs[UNITS_MAX];
};

/* Nothing packed yet; every sliver reaches down to `depth`. */
static void operands_init(const double *a, size_t a_depth, double *b, size_t b_depth, size_t depth,
                          struct operands *out)
{
    out->a = a;
    out->b = b;
    out->a_depth = a_depth;
    out->b_depth = b_depth;
    for (int q = 0; q < UNITS_MAX; q++) {
        out->runs[q] = (struct depth_runs){{0, 0}, {0, depth}, 0};
    }
}

static void pack_row(const taut_kernel *kernel, const double *from, size_t width, size_t row,
                     const struct operands *to)
{
    const size_t unit = (size_t)kernel->tile_columns;
    kernel->pack(width / unit, from, to->b_depth * unit, to->b + row * unit);
}

/* out[tile_rows][width] = rows r, r + 1, .. of A B */
static void multiply_rows(const taut_kernel *kernel, const struct operands *o, size_t r,
                          size_t width, double *out)
{
    const size_t t = (size_t)kernel->tile_rows, unit = (size_t)kernel->tile_columns;
    memset(out, 0, t * width * sizeof *out);
    for (size_t q = 0; q < width; q += unit) {
        const struct depth_runs *runs = &o->runs[q / unit];
        for (int run = 0; run < 2; run++) {
            const size_t start = runs->start[run], length = runs->end[run] - start;
            if (length > 0) {
                kernel->tile(length, o->a + r * o->a_depth + start * t,
                             o->b + q * o->b_depth + start * unit, out + q, width);
            }
        }
    }
}

/* sum[q], difference[q] <- sum[q] + difference[q], sum[q] - difference[q] */
static void fold(size_t count, double *sum, double *difference)
{
    for (size_t q = 0; q < count; q++) {
        const double here = sum[q], there = difference[q];
        sum[q] = here + there;
        difference[q] = here - there;
    }
}

/* V^T B, mode by mode. */
static void put_modes(const taut_panel *panel, int p, const struct operands *operands,
                      const struct put *put, double *x)
{
    const taut_modes_part *part = &panel->modes->part[p];
    const size_t t = (size_t)panel->modes->kernel->tile_rows, count = (size_t)part->count;
    for (size_t j = 0; j < count; j += t) {
        multiply_rows(panel->modes->kernel, operands, j, put->width, panel->out);
        put_rows(put, count - j < t ? count - j : t, panel->out, (size_t)part->first + j, 1, x);
    }
}

/* V B, point by point: of mirrored points one is the sum, one the difference of the even and the
 * odd part. */
static void put_points(const taut_panel *panel, const struct operands *operands,
                       const struct put *put, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t t = (size_t)modes->kernel->tile_rows, n = (size_t)modes->n;
    const size_t pairs = modes->parts == 2 ? n / 2 : 0, rows = (size_t)modes->part[0].rows;
    double *even = panel->out, *odd = panel->out + t * put->width;
    for (size_t i = 0; i < rows; i += t) {
        multiply_rows(modes->kernel, &operands[0], i, put->width, even);
        if (i < pairs) {
            const size_t mirrored = pairs - i < t ? pairs - i : t;
            multiply_rows(modes->kernel, &operands[1], i, put->width, odd);
            fold(mirrored * put->width, even, odd);
            put_rows(put, mirrored, odd, n - 1 - i, -1, x);
        }
        put_rows(put, rows - i < t ? rows - i : t, even, i, 1, x);
    }
}

/* Packs columns of x, folded about the middle for modes of two parts. */
static void pack_points(const taut_panel *panel, const struct put *put, const double *x,
                        struct operands *operands)
{
    const taut_modes *modes = panel->modes;
    const size_t n = (size_t)modes->n, pairs = modes->parts == 2 ? n / 2 : 0;
    const size_t unit = (size_t)modes->kernel->tile_columns;
    double here[COLUMNS_MAX] = {0}, there[COLUMNS_MAX] = {0};

    for (size_t i = 0; i < n - pairs; i++) {
        read_row(put->lines, x, i, put->first, put->count, here);
        if (i < pairs) {
            read_row(put->lines, x, n - 1 - i, put->first, put->count, there);
            fold(put->count, here, there);
            pack_row(modes->kernel, there, put->width, i, &operands[1]);
        }
        pack_row(modes->kernel, here, put->width, i, &operands[0]);
        for (size_t q = 0; q < put->width; q += unit) {
            if (!is_zero(here + q, unit)) {
                note_row(&operands[0].runs[q / unit], i);
            }
            if (i < pairs && !is_zero(there + q, unit)) {
                note_row(&operands[1].runs[q / unit], i);
            }
        }
    }
}

void taut_analyse(const taut_panel *panel, const taut_lines *lines, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t unit = (size_t)modes->kernel->tile_columns;
    for (size_t first = 0; first < lines->columns;) {
        const size_t count = columns_for(panel, lines, first, (size_t)modes->n);
        const struct put put = {lines, first, count, round_up(count, unit), 1};
        struct operands operands[2];
        double *b = panel->in;
        for (int p = 0; p < modes->parts; p++) {
            const size_t rows = (size_t)modes->part[p].rows;
            operands_init(modes->part[p].analysis, rows, b, rows, 0, &operands[p]);
            b += rows * put.width;
        }
        pack_points(panel, &put, x, operands);
        for (int p = 0; p < modes->parts; p++) {
            put_modes(panel, p, &operands[p], &put, x);
        }
        first += count;
    }
}

void taut_synthesise(const taut_panel *panel, const taut_lines *lines, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t unit = (size_t)modes->kernel->tile_columns;
    double row[COLUMNS_MAX] = {0};
    for (size_t first = 0; first < lines->columns;) {
        const size_t count = columns_for(panel, lines, first, (size_t)modes->n);
        const struct put put = {lines, first, count, round_up(count, unit), 1};
        struct operands operands[2];
        double *b = panel->in;
        for (int p = 0; p < modes->parts; p++) {
            const taut_modes_part *part = &modes->part[p];
            const size_t depth = (size_t)part->count;
            operands_init(part->synthesis, depth, b, depth, depth, &operands[p]);
            for (size_t j = 0; j < depth; j++) {
                read_row(lines, x, (size_t)part->first + j, first, count, row);
                pack_row(modes->kernel, row, put.width, j, &operands[p]);
            }
            b += depth * put.width;
        }
        put_points(panel, operands, &put, x);
        first += count;
    }
}

/* ---- tails ---- */

taut_status taut_tails_init(const taut_modes *modes, size_t points, size_t rhs, taut_tails *out)
{
    const int lanes = modes->kernel->lanes;
    size_t total = 0;
    *out = (taut_tails){{0, 0}, {NULL, NULL}, points, rhs};
    for (int p = 0; p < modes->parts; p++) {
        out->blocks[p] = ((size_t)modes->part[p].count + (size_t)lanes - 1) / (size_t)lanes;
        total += out->blocks[p];
    }
    taut_tail_block *block = taut_alloc_zero(total, sizeof *block);
    if (block == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int p = 0; p < modes->parts; p++) {
        const int first = modes->part[p].first, end = first + modes->part[p].count;
        out->block[p] = block;
        for (int j = first; j < end; j += lanes, block++) {
            block->first = j;
            block->used = end - j < lanes ? end - j : lanes;
        }
    }
    return TAUT_OK;
}

void taut_tails_clear(taut_tails *tails)
{
    for (int p = 0; p < 2 && tails->block[0] != NULL; p++) {
        for (size_t b = 0; b < tails->blocks[p]; b++) {
            taut_free(tails->block[p][b].values[0]);
            taut_free(tails->block[p][b].values[1]);
        }
    }
    taut_free(tails->block[0]);
    tails->block[0] = tails->block[1] = NULL;
}

/* Columns first..first+count-1 of the row of mode `l` of a block. Returns 0, row untouched, when
 * all are zero. */
static int take_tail(const taut_tails *tails, const taut_tail_block *block, size_t l, size_t first,
                     size_t count, double *row)
{
    const size_t end = first + count, whole = tails->points * tails->rhs;
    const size_t head = block->keep[0] * tails->rhs, tail = block->keep[1] * tails->rhs,
                 start = whole - tail;
    if (first >= head && end <= start) {
        return 0;
    }
    memset(row, 0, count * sizeof *row);
    if (first < head) {
        memcpy(row, block->values[0] + l * head + first,
               ((end < head ? end : head) - first) * sizeof *row);
    }
    if (end > start) {
        const size_t from = first > start ? first : start;
        memcpy(row + (from - first), block->values[1] + l * tail + (from - start),
               (end - from) * sizeof *row);
    }
    return 1;
}

/* Modes of part p up to the last that is not zero in these columns. */
static size_t depth_of(const taut_tails *tails, int p, size_t first, size_t count)
{
    size_t b = tails->blocks[p];
    while (b > 0) {
        const taut_tail_block *block = &tails->block[p][b - 1];
        if (first < block->keep[0] * tails->rhs ||
            first + count > (tails->points - block->keep[1]) * tails->rhs) {
            return (size_t)(block->first + block->used - tails->block[p][0].first);
        }
        b--;
    }
    return 0;
}

/* Packs these columns of the tails of part p, operands->b_depth modes of them. */
static void pack_tails(const taut_kernel *kernel, const taut_tails *tails, int p,
                       const struct put *put, const struct operands *operands)
{
    double row[COLUMNS_MAX] = {0};
    size_t j = 0;
    for (const taut_tail_block *block = tails->block[p]; j < operands->b_depth; block++) {
        for (size_t l = 0; l < (size_t)block->used; l++) {
            const int kept = take_tail(tails, block, l, put->first, put->count, row);
            pack_row(kernel, kept ? row : zeros, put->width, j++, operands);
        }
    }
}

void taut_synthesise_tails(const taut_panel *panel, const taut_lines *lines,
                           const taut_tails *tails, int is_new, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t unit = (size_t)modes->kernel->tile_columns;
    for (size_t first = 0; first < lines->columns;) {
        size_t count = columns_for(panel, lines, first, 0), depth = 0;
        for (int p = 0; p < modes->parts; p++) {
            depth += depth_of(tails, p, first, count);
        }
        count = columns_for(panel, lines, first, depth);
        const struct put put = {lines, first, count, round_up(count, unit), is_new};
        struct operands operands[2];
        double *b = panel->in;
        for (int p = 0; p < modes->parts; p++) {
            const taut_modes_part *part = &modes->part[p];
            depth = depth_of(tails, p, first, count);
            operands_init(part->synthesis, (size_t)part->count, b, depth, depth, &operands[p]);
            for (size_t q = 0; q < put.width; q += unit) {
                const size_t some = count - q < unit ? count - q : unit;
                operands[p].runs[q / unit].end[1] = depth_of(tails, p, first + q, some);
            }
            pack_tails(modes->kernel, tails, p, &put, &operands[p]);
            b += depth * put.width;
        }
        put_points(panel, operands, &put, x);
        first += count;
    }
}
