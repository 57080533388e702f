#include "numeric/contract.h"

#include "core/memory.h"

#include <assert.h>
#include <string.h>

/* Panels of this many bytes stay in the second-level cache; so does a block of DEPTH rows of one.
 */
enum { PANEL_BYTES = 512 * 1024, PANEL_COLUMNS_MAX = 240, DEPTH = 416 };

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
typedef struct depth_runs {
    size_t start[2], end[2];
    size_t zeros_from; /* start of the current run of zeros */
} depth_runs;

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
static void multiply(const taut_panel *panel, size_t rows, size_t depth, const depth_runs *runs,
                     size_t width, const double *a, const double *b, double *out)
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
    depth_runs runs = {{0, 0}, {0, 0}, 0};

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
        depth_runs limited = runs;
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

void taut_panel_synthesise(const taut_panel *panel, const taut_lines *lines, size_t first,
                           size_t count, double *x)
{
    const taut_modes *modes = panel->modes;
    const size_t n = (size_t)modes->n, unit = (size_t)modes->kernel->tile_columns;
    const size_t t = (size_t)modes->kernel->tile_rows, width = round_up(count, unit);
    double *in[2] = {panel->in, panel->in + (size_t)modes->part[0].count * width};
    double *out[2] = {panel->out, panel->out + round_up((size_t)modes->part[0].rows, t) * width};
    double row[PANEL_COLUMNS_MAX] = {0};

    assert(count <= panel->width && width <= PANEL_COLUMNS_MAX);
    for (int p = 0; p < modes->parts; p++) {
        const taut_modes_part *part = &modes->part[p];
        const size_t depth = (size_t)part->count;
        for (size_t j = 0; j < depth; j++) {
            read_row(lines, x, (size_t)part->first + j, first, count, row);
            pack_row(row, width, unit, depth, j, in[p]);
        }
        const depth_runs all = {{0, 0}, {0, depth}, 0};
        multiply(panel, (size_t)part->rows, depth, &all, width, part->synthesis, in[p], out[p]);
    }
    const size_t pairs = modes->parts == 2 ? n / 2 : 0;
    for (size_t i = 0; i < (size_t)modes->part[0].rows; i++) {
        double *even = out[0] + i * width, *odd = out[1] + i * width;
        if (i < pairs) {
            fold(width, even, odd);
            write_row(lines, x, n - 1 - i, first, count, odd);
        }
        write_row(lines, x, i, first, count, even);
    }
}
