#include "numeric/contract.h"

#include "core/memory.h"

#include <assert.h>
#include <string.h>

/* Panels of this many bytes stay in the second-level cache; so does a block of DEPTH rows of one.
 */
enum { PANEL_BYTES = 512 * 1024, PANEL_COLUMNS_MAX = 240, DEPTH = 416 };

static const double zeros[PANEL_COLUMNS_MAX];

taut_lines taut_lines_first(size_t nu, size_t nv, size_t nrhs)
{
    (void)nu;
    return (taut_lines){nv * nrhs, nv * nrhs, nv * nrhs, 0};
}

taut_lines taut_lines_second(size_t nu, size_t nv, size_t nrhs)
{
    return (taut_lines){nu * nrhs, nrhs, nrhs, nv * nrhs};
}

static size_t round_up(size_t count, size_t unit)
{
    return (count + unit - 1) / unit * unit;
}

taut_status taut_panel_init(const taut_modes *modes, size_t columns, taut_panel *panel)
{
    const size_t unit = (size_t)modes->kernel->tile_columns, n = (size_t)modes->n;
    const size_t rows = n + 2 * (size_t)modes->kernel->tile_rows;
    size_t width = PANEL_BYTES / sizeof(double) / n / unit * unit;
    width = width < 4 * unit            ? 4 * unit
            : width > PANEL_COLUMNS_MAX ? PANEL_COLUMNS_MAX / unit * unit
                                        : width;
    width = width > round_up(columns, unit) ? round_up(columns, unit) : width;
    *panel = (taut_panel){modes, width, taut_alloc_aligned((n + 1) * width, sizeof(double)),
                          taut_alloc_aligned(rows * width, sizeof(double))};
    return panel->in == NULL || panel->out == NULL ? TAUT_NO_MEMORY : TAUT_OK;
}

void taut_panel_clear(taut_panel *panel)
{
    taut_free(panel->in);
    taut_free(panel->out);
    *panel = (taut_panel){NULL, 0, NULL, NULL};
}

/* ---- rows of the net to and from contiguous rows
 * ------------------------------------------------------- */

static size_t offset_of(const taut_lines *lines, size_t column)
{
    return column / lines->inner * lines->outer + column % lines->inner;
}

/* to[q] = x(row, first + q) */
static void read_row(const taut_lines *lines, const double *x, size_t row, size_t first,
                     size_t count, double *to)
{
    const double *from = x + row * lines->stride;
    if (lines->inner == lines->columns) {
        memcpy(to, from + first, count * sizeof *to);
        return;
    }
    for (size_t q = 0; q < count;) {
        const size_t run = lines->inner - (first + q) % lines->inner;
        const double *at = from + offset_of(lines, first + q);
        for (size_t r = 0; r < run && q < count; r++) {
            to[q++] = at[r];
        }
    }
}

static void write_row(const taut_lines *lines, double *x, size_t row, size_t first, size_t count,
                      const double *from)
{
    double *to = x + row * lines->stride;
    if (lines->inner == lines->columns) {
        memcpy(to + first, from, count * sizeof *to);
        return;
    }
    for (size_t q = 0; q < count;) {
        const size_t run = lines->inner - (first + q) % lines->inner;
        double *at = to + offset_of(lines, first + q);
        for (size_t r = 0; r < run && q < count; r++) {
            at[r] = from[q++];
        }
    }
}

/* x(row, first + q) += from[q] */
static void add_row(const taut_lines *lines, double *x, size_t row, size_t first, size_t count,
                    const double *from)
{
    double *to = x + row * lines->stride;
    if (lines->inner == lines->columns) {
        for (size_t q = 0; q < count; q++) {
            to[first + q] += from[q];
        }
        return;
    }
    for (size_t q = 0; q < count;) {
        const size_t run = lines->inner - (first + q) % lines->inner;
        double *at = to + offset_of(lines, first + q);
        for (size_t r = 0; r < run && q < count; r++) {
            at[r] += from[q++];
        }
    }
}

/* Row `row` of `rows` rows of a packed part, double[width / unit][rows][unit]. */
static void pack_row(const double *from, size_t width, size_t unit, size_t rows, size_t row,
                     double *packed)
{
    for (size_t q = 0; q < width; q += unit) {
        memcpy(packed + q * rows + row * unit, from + q, unit * sizeof *from);
    }
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

/* ---- products
 * ------------------------------------------------------------------------------------------ */

/* Rows of the packed operand that are not all zero: up to two runs, the longest run of zeros
 * between them. */
struct depth_runs {
    size_t start[2], end[2];
    size_t zeros_from; /* start of the current run of zeros */
};

static void note_row(struct depth_runs *runs, size_t row, int zero)
{
    if (zero) {
        return;
    }
    const size_t gap = row - runs->zeros_from;
    if (gap > runs->start[1] - runs->end[0]) {
        runs->end[0] = runs->zeros_from;
        runs->start[1] = row;
    }
    runs->zeros_from = row + 1;
    runs->end[1] = row + 1;
}

/* out[rows][width] = A B over the runs; A in slivers double[rows/t][depth][t], B in slivers
 * double[width/unit][depth][unit]. One block of B at a time, so that it stays in cache while A
 * passes by. */
static void multiply(const taut_panel *panel, size_t rows, size_t depth,
                     const struct depth_runs *runs, size_t width, const double *a, const double *b,
                     double *out)
{
    const taut_kernel *kernel = panel->modes->kernel;
    const size_t t = (size_t)kernel->tile_rows, unit = (size_t)kernel->tile_columns;

    memset(out, 0, round_up(rows, t) * width * sizeof *out);
    for (int run = 0; run < 2; run++) {
        const size_t length = runs->end[run] - runs->start[run];
        const size_t blocks = (length + DEPTH - 1) / DEPTH;
        for (size_t block = 0; block < blocks; block++) {
            const size_t from = runs->start[run] + length * block / blocks;
            const size_t upto = runs->start[run] + length * (block + 1) / blocks;
            for (size_t r = 0; r < rows; r += t) {
                for (size_t q = 0; q < width; q += unit) {
                    kernel->tile(upto - from, a + r * depth + from * t, b + q * depth + from * unit,
                                 out + r * width + q, width);
                }
            }
        }
    }
}

/* x(i) and its mirror image become their sum and difference halves: sum goes to the even part. */
static void fold(size_t count, double *sum, double *difference)
{
    for (size_t q = 0; q < count; q++) {
        const double here = sum[q], there = difference[q];
        sum[q] = here + there;
        difference[q] = here - there;
    }
}

void taut_panel_analyse(const taut_panel *panel, const taut_lines *lines, size_t first,
                        size_t count, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t n = (size_t)modes->n, unit = (size_t)modes->kernel->tile_columns;
    const size_t width = round_up(count, unit), pairs = modes->parts == 2 ? n / 2 : 0;
    const size_t rows = modes->parts == 2 ? n - pairs : n;
    double *odd = panel->in + rows * width;
    double here[PANEL_COLUMNS_MAX] = {0}, there[PANEL_COLUMNS_MAX] = {0};
    struct depth_runs runs = {{0, 0}, {0, 0}, 0};

    assert(count <= panel->width && width <= PANEL_COLUMNS_MAX);
    for (size_t i = 0; i < rows; i++) {
        read_row(lines, x, i, first, count, here);
        int zero = is_zero(here, count);
        if (i < pairs) {
            read_row(lines, x, n - 1 - i, first, count, there);
            zero = zero && is_zero(there, count);
            fold(count, here, there);
            pack_row(there, width, unit, pairs, i, odd);
        }
        pack_row(here, width, unit, rows, i, panel->in);
        note_row(&runs, i, zero);
    }
    for (int p = 0; p < modes->parts; p++) {
        const taut_modes_part *part = &modes->part[p];
        struct depth_runs limited = runs;
        for (int run = 0; run < 2; run++) { /* the odd part has no middle row */
            limited.end[run] =
                runs.end[run] < (size_t)part->rows ? runs.end[run] : (size_t)part->rows;
            limited.start[run] =
                runs.start[run] < limited.end[run] ? runs.start[run] : limited.end[run];
        }
        multiply(panel, (size_t)part->count, (size_t)part->rows, &limited, width, part->analysis,
                 p == 0 ? panel->in : odd, panel->out);
        for (size_t j = 0; j < (size_t)part->count; j++) {
            write_row(lines, x, (size_t)part->first + j, first, count, panel->out + j * width);
        }
    }
}

/* Where part p of the operand and of the product are. */
static double *part_in(const taut_panel *panel, int p, size_t width)
{
    return panel->in + (p == 0 ? 0 : (size_t)panel->modes->part[0].count * width);
}

static double *part_out(const taut_panel *panel, int p, size_t width)
{
    const size_t rows =
        round_up((size_t)panel->modes->part[0].rows, (size_t)panel->modes->kernel->tile_rows);
    return panel->out + (p == 0 ? 0 : rows * width);
}

/* Hands the products of all parts to the net by `put`: mirrored points are the sum and the
 * difference of the even and the odd part. */
static void
unfold(const taut_panel *panel, const taut_lines *lines, size_t first, size_t count, size_t width,
       void (*put)(const taut_lines *, double *, size_t, size_t, size_t, const double *), double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t n = (size_t)modes->n, pairs = modes->parts == 2 ? n / 2 : 0;
    for (size_t i = 0; i < (size_t)modes->part[0].rows; i++) {
        double *even = part_out(panel, 0, width) + i * width;
        if (i < pairs) {
            double *odd = part_out(panel, 1, width) + i * width;
            fold(width, even, odd);
            put(lines, x, n - 1 - i, first, count, odd);
        }
        put(lines, x, i, first, count, even);
    }
}

void taut_panel_synthesise(const taut_panel *panel, const taut_lines *lines, size_t first,
                           size_t count, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t unit = (size_t)modes->kernel->tile_columns, width = round_up(count, unit);
    double row[PANEL_COLUMNS_MAX] = {0};

    assert(count <= panel->width && width <= PANEL_COLUMNS_MAX);
    for (int p = 0; p < modes->parts; p++) {
        const taut_modes_part *part = &modes->part[p];
        const size_t depth = (size_t)part->count;
        for (size_t j = 0; j < depth; j++) {
            read_row(lines, x, (size_t)part->first + j, first, count, row);
            pack_row(row, width, unit, depth, j, part_in(panel, p, width));
        }
        const struct depth_runs all = {{0, 0}, {0, depth}, 0};
        multiply(panel, (size_t)part->rows, depth, &all, width, part->synthesis,
                 part_in(panel, p, width), part_out(panel, p, width));
    }
    unfold(panel, lines, first, count, width, write_row, x);
}

/* ---- tails
 * --------------------------------------------------------------------------------------------- */

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

void taut_panel_add_tails(const taut_panel *panel, const taut_lines *lines, size_t first,
                          size_t count, const taut_tails *tails, int is_new, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t unit = (size_t)modes->kernel->tile_columns, width = round_up(count, unit);
    double row[PANEL_COLUMNS_MAX] = {0};

    assert(count <= panel->width && width <= PANEL_COLUMNS_MAX);
    for (int p = 0; p < modes->parts; p++) {
        const taut_modes_part *part = &modes->part[p];
        double *in = part_in(panel, p, width);
        size_t used = 0; /* modes up to the last that is not zero here */
        for (size_t b = 0; b < tails->blocks[p]; b++) {
            const taut_tail_block *block = &tails->block[p][b];
            const size_t at = (size_t)(block->first - part->first);
            for (size_t l = 0; l < (size_t)block->used; l++) {
                if (!take_tail(tails, block, l, first, count, row)) {
                    break;
                }
                for (; used < at; used++) { /* blocks between that are zero here */
                    pack_row(zeros, width, unit, (size_t)part->count, used, in);
                }
                pack_row(row, width, unit, (size_t)part->count, at + l, in);
                used = at + l + 1;
            }
        }
        const struct depth_runs runs = {{0, 0}, {0, used}, 0};
        multiply(panel, (size_t)part->rows, (size_t)part->count, &runs, width, part->synthesis, in,
                 part_out(panel, p, width));
    }
    unfold(panel, lines, first, count, width, is_new ? write_row : add_row, x);
}
