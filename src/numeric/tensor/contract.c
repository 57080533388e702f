/* contract.c -- products of modes with nets, in tiles that stay in registers. */
#include "numeric/tensor/internal.h"

#include <string.h>

/* A packed work of this many numbers stays in the second-level cache while all of V passes by. */
enum { PANEL_SIZE = 64 * 1024, COLUMNS_MAX = 240, UNITS_MIN = 4, UNITS_MAX = 60 };

static const double zeros[COLUMNS_MAX];

taut_unfolding taut_unfolding_first(size_t nu, size_t nv, size_t nrhs)
{
    (void)nu;
    return (taut_unfolding){nv * nrhs, nv * nrhs, nv * nrhs, 0};
}

taut_unfolding taut_unfolding_second(size_t nu, size_t nv, size_t nrhs)
{
    return (taut_unfolding){nu * nrhs, nrhs, nrhs, nv * nrhs};
}

taut_contraction taut_contraction_of(const taut_modes *modes, size_t columns, const taut_crew *crew,
                                     taut_arena *arena)
{
    const size_t unit = (size_t)modes->kernel->tile_columns, n = (size_t)modes->n;
    const size_t least = (n + 1) * UNITS_MIN * unit, panels = columns / (UNITS_MIN * unit) + 1;
    const size_t in_size = least > PANEL_SIZE ? least : PANEL_SIZE;
    const size_t out_size = 2 * (size_t)modes->kernel->tile_rows * COLUMNS_MAX;
    const int workers = taut_crew_workers(crew, (int64_t)panels);
    return (taut_contraction){
        .modes = modes,
        .crew = *crew,
        .pulse = crew->pulse,
        .workers = workers,
        .in_size = in_size,
        .out_size = out_size,
        .in = taut_arena_take_raw(arena, (size_t)workers * in_size, sizeof(double)),
        .out = taut_arena_take_raw(arena, (size_t)workers * out_size, sizeof(double)),
        .panels = taut_arena_take_raw(arena, panels + 1, sizeof(size_t))};
}

/* One worker's scratch. */
static taut_contraction part_of(const taut_contraction *work, int worker)
{
    taut_contraction own = *work;
    own.in += (size_t)worker * work->in_size;
    own.out += (size_t)worker * work->out_size;
    own.pulse = worker == 0 ? work->pulse : NULL;
    return own;
}

/* The columns to take from `first` on, when `depth` numbers of each are packed. */
static size_t columns_for(const taut_contraction *work, const taut_unfolding *unfolding,
                          size_t first, size_t depth)
{
    const size_t unit = (size_t)work->modes->kernel->tile_columns;
    size_t units = PANEL_SIZE / unit / (depth > 0 ? depth : 1);
    units = units < UNITS_MIN ? UNITS_MIN : units > COLUMNS_MAX / unit ? COLUMNS_MAX / unit : units;
    const size_t left = unfolding->columns - first;
    return left < units * unit ? left : units * unit;
}

static size_t round_up(size_t count, size_t unit)
{
    return (count + unit - 1) / unit * unit;
}

/* ---- rows of the net to and from contiguous rows ---- */

static size_t offset_of(const taut_unfolding *unfolding, size_t column)
{
    return column / unfolding->inner * unfolding->outer + column % unfolding->inner;
}

/* The columns from `column` on that are neighbours in memory, `limit` at most. */
static size_t run_of(const taut_unfolding *unfolding, size_t column, size_t limit)
{
    const size_t run = unfolding->inner - column % unfolding->inner;
    return run < limit ? run : limit;
}

/* to[q] = x(row, first + q), q < count */
static void read_row(const taut_unfolding *unfolding, const double *x, size_t row, size_t first,
                     size_t count, double *to)
{
    for (size_t q = 0; q < count;) {
        const size_t run = run_of(unfolding, first + q, count - q);
        const double *from = x + row * unfolding->stride + offset_of(unfolding, first + q);
        for (size_t r = 0; r < run; r++) {
            to[q++] = from[r];
        }
    }
}

/* Some rows of a product, double[rows][width], on their way to rows first_row, first_row + step, ..
 * of a net. */
struct target_rows {
    const taut_unfolding *unfolding;
    size_t first, count, width; /* columns */
    int is_new;                 /* replaces what is there, else is added */
};

static void write_rows(const struct target_rows *target, size_t rows, const double *from,
                       size_t first_row, ptrdiff_t step, double *x)
{
    const ptrdiff_t stride = step * (ptrdiff_t)target->unfolding->stride;
    for (size_t q = 0; q < target->count;) {
        const size_t run = run_of(target->unfolding, target->first + q, target->count - q);
        double *to = x + first_row * target->unfolding->stride +
                     offset_of(target->unfolding, target->first + q);
        for (size_t r = 0; r < rows; r++, to += stride) {
            const double *row = from + r * target->width + q;
            for (size_t c = 0; c < run; c++) {
                to[c] = target->is_new ? row[c] : to[c] + row[c];
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
static void operands_open(const double *a, size_t a_depth, double *b, size_t b_depth, size_t depth,
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

/* work->out, or what stands behind it: out[tile_rows][width] = rows r, r + 1, .. of A B */
static void multiply_rows(const taut_contraction *work, const struct operands *o, size_t r,
                          size_t width, double *out)
{
    const taut_kernel *kernel = work->modes->kernel;
    const size_t t = (size_t)kernel->tile_rows, unit = (size_t)kernel->tile_columns;
    memset(out, 0, t * width * sizeof *out);
    if (taut_pulse_beat(work->pulse, 2.0 * (double)(t * width) * (double)o->b_depth)) {
        return;
    }
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
static void fold_rows(size_t count, double *sum, double *difference)
{
    for (size_t q = 0; q < count; q++) {
        const double here = sum[q], there = difference[q];
        sum[q] = here + there;
        difference[q] = here - there;
    }
}

/* V^T B, mode by mode. */
static void write_modes(const taut_contraction *work, int p, const struct operands *operands,
                        const struct target_rows *target, double *x)
{
    const taut_modes_part *part = &work->modes->part[p];
    const size_t t = (size_t)work->modes->kernel->tile_rows, count = (size_t)part->count;
    for (size_t j = 0; j < count; j += t) {
        multiply_rows(work, operands, j, target->width, work->out);
        write_rows(target, count - j < t ? count - j : t, work->out, (size_t)part->first + j, 1, x);
    }
}

/* V B, point by point: of mirrored points one is the sum, one the difference of the even and the
 * odd part. */
static void write_points(const taut_contraction *work, const struct operands *operands,
                         const struct target_rows *target, double *x)
{
    const taut_modes *modes = work->modes;
    const size_t t = (size_t)modes->kernel->tile_rows, n = (size_t)modes->n;
    const size_t pairs = modes->parts == 2 ? n / 2 : 0, rows = (size_t)modes->part[0].rows;
    double *even = work->out, *odd = work->out + t * target->width;
    for (size_t i = 0; i < rows; i += t) {
        multiply_rows(work, &operands[0], i, target->width, even);
        if (i < pairs) {
            const size_t mirrored = pairs - i < t ? pairs - i : t;
            multiply_rows(work, &operands[1], i, target->width, odd);
            fold_rows(mirrored * target->width, even, odd);
            write_rows(target, mirrored, odd, n - 1 - i, -1, x);
        }
        write_rows(target, rows - i < t ? rows - i : t, even, i, 1, x);
    }
}

/* Packs columns of x, folded about the middle for modes of two parts. */
static void pack_points(const taut_contraction *work, const struct target_rows *target,
                        const double *x, struct operands *operands)
{
    const taut_modes *modes = work->modes;
    const size_t n = (size_t)modes->n, pairs = modes->parts == 2 ? n / 2 : 0;
    const size_t unit = (size_t)modes->kernel->tile_columns;
    double here[COLUMNS_MAX] = {0}, there[COLUMNS_MAX] = {0};

    for (size_t i = 0; i < n - pairs; i++) {
        read_row(target->unfolding, x, i, target->first, target->count, here);
        if (i < pairs) {
            read_row(target->unfolding, x, n - 1 - i, target->first, target->count, there);
            fold_rows(target->count, here, there);
            pack_row(modes->kernel, there, target->width, i, &operands[1]);
        }
        pack_row(modes->kernel, here, target->width, i, &operands[0]);
        for (size_t q = 0; q < target->width; q += unit) {
            if (!is_zero(here + q, unit)) {
                note_row(&operands[0].runs[q / unit], i);
            }
            if (i < pairs && !is_zero(there + q, unit)) {
                note_row(&operands[1].runs[q / unit], i);
            }
        }
    }
}

/* A product of a net, panel by panel: each has columns of its own, so that they may be made in any order. */
struct job {
    const taut_contraction *work;
    const taut_unfolding *unfolding;
    const taut_tails *tails; /* of taut_contract_tails */
    int is_new;
    double *x;
};

static struct target_rows target_of(const struct job *job, int64_t panel)
{
    const size_t unit = (size_t)job->work->modes->kernel->tile_columns;
    const size_t first = job->work->panels[panel], count = job->work->panels[panel + 1] - first;
    return (struct target_rows){job->unfolding, first, count, round_up(count, unit), job->is_new};
}

/* Panels as wide as what is packed of each column allows: all of `depth` numbers. */
static int64_t divide_evenly(const taut_contraction *work, const taut_unfolding *unfolding,
                             size_t depth)
{
    int64_t panels = 0;
    for (size_t first = 0; first < unfolding->columns;) {
        work->panels[panels++] = first;
        first += columns_for(work, unfolding, first, depth);
    }
    work->panels[panels] = unfolding->columns;
    return panels;
}

static void contract_points(void *context, int worker, int64_t panel)
{
    const struct job *job = context;
    const taut_contraction work = part_of(job->work, worker);
    const struct target_rows target = target_of(job, panel);
    struct operands operands[2];
    double *b = work.in;

    for (int p = 0; p < work.modes->parts; p++) {
        const size_t rows = (size_t)work.modes->part[p].rows;
        operands_open(work.modes->part[p].analysis, rows, b, rows, 0, &operands[p]);
        b += rows * target.width;
    }
    pack_points(&work, &target, job->x, operands);
    for (int p = 0; p < work.modes->parts; p++) {
        write_modes(&work, p, &operands[p], &target, job->x);
    }
}

void taut_contract_points(const taut_contraction *work, const taut_unfolding *unfolding, double *x)
{
    struct job job = {work, unfolding, NULL, 1, x};
    const int64_t panels = divide_evenly(work, unfolding, (size_t)work->modes->n);
    taut_crew_run(&work->crew, work->workers, panels, 0, contract_points, &job);
}

static void contract_modes(void *context, int worker, int64_t panel)
{
    const struct job *job = context;
    const taut_contraction work = part_of(job->work, worker);
    const taut_modes *modes = work.modes;
    const struct target_rows target = target_of(job, panel);
    struct operands operands[2];
    double row[COLUMNS_MAX] = {0}, *b = work.in;

    for (int p = 0; p < modes->parts; p++) {
        const taut_modes_part *part = &modes->part[p];
        const size_t depth = (size_t)part->count;
        operands_open(part->synthesis, depth, b, depth, depth, &operands[p]);
        for (size_t j = 0; j < depth; j++) {
            read_row(job->unfolding, job->x, (size_t)part->first + j, target.first, target.count,
                     row);
            pack_row(modes->kernel, row, target.width, j, &operands[p]);
        }
        b += depth * target.width;
    }
    write_points(&work, operands, &target, job->x);
}

void taut_contract_modes(const taut_contraction *work, const taut_unfolding *unfolding, double *x)
{
    struct job job = {work, unfolding, NULL, 1, x};
    const int64_t panels = divide_evenly(work, unfolding, (size_t)work->modes->n);
    taut_crew_run(&work->crew, work->workers, panels, 0, contract_modes, &job);
}

/* ---- tails ---- */

taut_tails taut_tails_of(const taut_modes *modes, size_t points, size_t rhs, taut_arena *arena)
{
    const size_t lanes = TAUT_LANES;
    taut_tails tails = {{0, 0}, {NULL, NULL}, points, rhs};
    for (int p = 0; p < modes->parts; p++) {
        tails.blocks[p] = ((size_t)modes->part[p].count + lanes - 1) / lanes;
        tails.block[p] = taut_arena_take(arena, tails.blocks[p], sizeof *tails.block[p]);
        for (size_t b = 0; tails.block[p] != NULL && b < tails.blocks[p]; b++) {
            const size_t left = (size_t)modes->part[p].count - b * lanes;
            tails.block[p][b].first = modes->part[p].first + (int)(b * lanes);
            tails.block[p][b].used = (int)(left < lanes ? left : lanes);
        }
    }
    return tails;
}

/* Columns first..first+count-1 of the row of mode `l` of a block. Returns 0, row untouched, when
 * all are zero. */
static int read_tail(const taut_tails *tails, const taut_tail_block *block, size_t l, size_t first,
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
                       const struct target_rows *target, const struct operands *operands)
{
    double row[COLUMNS_MAX] = {0};
    size_t j = 0;
    for (const taut_tail_block *block = tails->block[p]; j < operands->b_depth; block++) {
        for (size_t l = 0; l < (size_t)block->used; l++) {
            const int kept = read_tail(tails, block, l, target->first, target->count, row);
            pack_row(kernel, kept ? row : zeros, target->width, j++, operands);
        }
    }
}

/* Panels as wide as the tails in them allow. */
static int64_t divide_by_tails(const taut_contraction *work, const taut_unfolding *unfolding,
                               const taut_tails *tails)
{
    int64_t panels = 0;
    for (size_t first = 0; first < unfolding->columns;) {
        const size_t most = columns_for(work, unfolding, first, 0);
        size_t depth = 0;
        for (int p = 0; p < work->modes->parts; p++) {
            depth += depth_of(tails, p, first, most);
        }
        work->panels[panels++] = first;
        first += columns_for(work, unfolding, first, depth);
    }
    work->panels[panels] = unfolding->columns;
    return panels;
}

static void contract_tails(void *context, int worker, int64_t panel)
{
    const struct job *job = context;
    const taut_contraction work = part_of(job->work, worker);
    const taut_modes *modes = work.modes;
    const size_t unit = (size_t)modes->kernel->tile_columns;
    const struct target_rows target = target_of(job, panel);
    struct operands operands[2];
    double *b = work.in;

    for (int p = 0; p < modes->parts; p++) {
        const taut_modes_part *part = &modes->part[p];
        const size_t depth = depth_of(job->tails, p, target.first, target.count);
        operands_open(part->synthesis, (size_t)part->count, b, depth, depth, &operands[p]);
        for (size_t q = 0; q < target.width; q += unit) {
            const size_t some = target.count - q < unit ? target.count - q : unit;
            operands[p].runs[q / unit].end[1] = depth_of(job->tails, p, target.first + q, some);
        }
        pack_tails(modes->kernel, job->tails, p, &target, &operands[p]);
        b += depth * target.width;
    }
    write_points(&work, operands, &target, job->x);
}

void taut_contract_tails(const taut_contraction *work, const taut_unfolding *unfolding,
                         const taut_tails *tails, int is_new, double *x)
{
    struct job job = {work, unfolding, tails, is_new, x};
    const int64_t panels = divide_by_tails(work, unfolding, tails);
    taut_crew_run(&work->crew, work->workers, panels, 0, contract_tails, &job);
}
