#include "numeric/tensor/apply.h"

#include "core/arena.h"
#include "numeric/kernel/kernel.h"

#include <math.h>
#include <string.h>

/* A matrix of the second direction by diagonals, each entry repeated for every coordinate:
 *     to[e + width][j * nrhs + c] = A(j, j + e),    zero outside the matrix. */
static void spread_diagonals(const taut_band *band, size_t nrhs, double *to)
{
    const ptrdiff_t n = band->n, w = band->width;
    for (ptrdiff_t e = -w; e <= w; e++) {
        for (ptrdiff_t j = 0; j < n; j++) {
            const int inside = j + e >= 0 && j + e < n;
            const double value = inside ? taut_band_at(band, (int)j, (int)(j + e)) : 0.0;
            for (size_t c = 0; c < nrhs; c++) {
                *to++ = value;
            }
        }
    }
}

/* Rows of y that a worker of several makes together; the rows of x beside them are looked at by both neighbours. */
enum { BLOCK_ROWS = 64 };

/* A walk over the rows of x: the products of one row with Mv and Kv are made once, and added with
 * the weights su Ku and sv Mu to the rows of y they reach. */
struct walk {
    const taut_tensor *tensor;
    const taut_kernel *kernel;
    size_t nrhs, length;  /* of a row: nv nrhs */
    size_t ring;          /* rows of sums that are kept in two parts: 2 wu + 1, or 0 */
    double *mass, *stiff; /* Mv, Kv by diagonals */
    double *by_m, *by_k;  /* row Mv, row Kv: double[2][length], the second half the low parts */
    double *high, *low;   /* those sums: double[ring][length]; these four of each worker */
    int workers, rows;    /* of y in a block */
    taut_pulse *pulse;    /* the caller's thread alone has one */
    const double *x, *right;
    double *y;
};

/* The arena's status tells whether all is there. */
static struct walk walk_of(const taut_tensor *tensor, int nrhs, int is_exact, taut_arena *arena)
{
    const int kv = tensor->kv->width, mv = tensor->mv->width;
    const int ku = tensor->ku->width, mu = tensor->mu->width;
    const size_t diagonals = 2 * (size_t)(kv > mv ? kv : mv) + 1;
    const size_t ring = is_exact ? 2 * (size_t)(ku > mu ? ku : mu) + 1 : 0;
    const size_t length = (size_t)tensor->kv->n * (size_t)nrhs, bytes = length * sizeof(double);
    const int workers = taut_crew_workers(tensor->crew, tensor->ku->n / BLOCK_ROWS + 1);
    struct walk walk = {.tensor = tensor,
                        .kernel = taut_kernel_best(),
                        .nrhs = (size_t)nrhs,
                        .length = length,
                        .ring = ring,
                        .mass = taut_arena_take_raw(arena, diagonals, bytes),
                        .stiff = taut_arena_take_raw(arena, diagonals, bytes),
                        .by_m = taut_arena_take_raw(arena, 2 * (size_t)workers, bytes),
                        .by_k = taut_arena_take_raw(arena, 2 * (size_t)workers, bytes),
                        .high = taut_arena_take(arena, ring * (size_t)workers, bytes),
                        .low = taut_arena_take(arena, ring * (size_t)workers, bytes),
                        .workers = workers,
                        .rows = workers > 1 ? BLOCK_ROWS : tensor->ku->n,
                        .pulse = tensor->crew != NULL ? tensor->crew->pulse : NULL};
    if (taut_arena_status(arena) == TAUT_OK) {
        spread_diagonals(tensor->mv, walk.nrhs, walk.mass);
        spread_diagonals(tensor->kv, walk.nrhs, walk.stiff);
    }
    return walk;
}

/* by_m and by_k of row x. */
static void make_row(const struct walk *walk, const taut_band *band, const double *diagonals,
                     int is_exact, const double *x, double *by)
{
    const ptrdiff_t w = band->width, c = (ptrdiff_t)walk->nrhs, length = (ptrdiff_t)walk->length;
    memset(by, 0, (is_exact ? 2 : 1) * walk->length * sizeof *by);
    for (ptrdiff_t e = -w; e <= w; e++) {
        const ptrdiff_t from = e < 0 ? -e * c : 0, upto = e > 0 ? length - e * c : length;
        const double *diagonal = diagonals + (e + w) * length;
        if (from >= upto) {
            continue;
        }
        if (is_exact) {
            walk->kernel->add_products_exactly((size_t)(upto - from), diagonal + from,
                                               x + from + e * c, by + from, by + length + from);
        } else {
            walk->kernel->add_products((size_t)(upto - from), diagonal + from, x + from + e * c,
                                       by + from);
        }
    }
}

/* The scratch of one worker. */
static struct walk part_of(const struct walk *walk, int worker)
{
    struct walk own = *walk;
    const size_t w = (size_t)worker;
    own.by_m += 2 * w * walk->length;
    own.by_k += 2 * w * walk->length;
    own.high += w * walk->ring * walk->length;
    own.low += w * walk->ring * walk->length;
    own.pulse = worker == 0 ? walk->pulse : NULL;
    return own;
}

/* Rows from..upto-1 of y, and rows begin..end-1 of x, which reach them. */
struct block {
    int from, upto, begin, end;
};

static struct block block_of(const struct walk *walk, int64_t task)
{
    const taut_tensor *tensor = walk->tensor;
    const int n = tensor->ku->n, wk = tensor->ku->width, wm = tensor->mu->width;
    const int wu = wk > wm ? wk : wm, from = (int)task * walk->rows;
    const int upto = n - from < walk->rows ? n : from + walk->rows;
    return (struct block){from, upto, from > wu ? from - wu : 0, n - upto > wu ? upto + wu : n};
}

/* The rows of a block that row i of x reaches through a matrix of this width. */
static int first_row(const struct block *block, int i, int width)
{
    return i - width > block->from ? i - width : block->from;
}

static int last_row(const struct block *block, int i, int width)
{
    return block->upto - 1 - i > width ? i + width : block->upto - 1;
}

/* Tells of a row that goes into others: `each` operations for a number and diagonal. */
static int beat_row(const struct walk *walk, double each)
{
    const taut_tensor *tensor = walk->tensor;
    const int diagonals =
        2 * (tensor->ku->width + tensor->mu->width + tensor->kv->width + tensor->mv->width) + 4;
    return taut_pulse_beat(walk->pulse, each * diagonals * (double)walk->length);
}

static taut_status run_blocks(struct walk *walk, taut_task *run)
{
    const int64_t blocks = (walk->tensor->ku->n + walk->rows - 1) / walk->rows;
    return taut_crew_run(walk->tensor->crew, walk->workers, blocks, 0, run, walk) ? TAUT_INTERRUPTED
                                                                                  : TAUT_OK;
}

static void apply_block(void *context, int worker, int64_t task)
{
    const struct walk walk = part_of(context, worker);
    const taut_tensor *tensor = walk.tensor;
    const struct block block = block_of(&walk, task);
    const int wk = tensor->ku->width, wm = tensor->mu->width;

    memset(walk.y + (size_t)block.from * walk.length, 0,
           (size_t)(block.upto - block.from) * walk.length * sizeof *walk.y);
    for (int i = block.begin; i < block.end && !beat_row(&walk, 2); i++) {
        const double *row = walk.x + (size_t)i * walk.length;
        make_row(&walk, tensor->mv, walk.mass, 0, row, walk.by_m);
        make_row(&walk, tensor->kv, walk.stiff, 0, row, walk.by_k);
        for (int r = first_row(&block, i, wk); r <= last_row(&block, i, wk); r++) {
            walk.kernel->add_scaled(walk.length, tensor->su * taut_band_at(tensor->ku, r, i),
                                    walk.by_m, walk.y + (size_t)r * walk.length);
        }
        for (int r = first_row(&block, i, wm); r <= last_row(&block, i, wm); r++) {
            walk.kernel->add_scaled(walk.length, tensor->sv * taut_band_at(tensor->mu, r, i),
                                    walk.by_k, walk.y + (size_t)r * walk.length);
        }
    }
}

taut_status taut_tensor_apply(const taut_tensor *tensor, int nrhs, const double *x, double *y)
{
    taut_arena *arena = taut_arena_new();
    struct walk walk = walk_of(tensor, nrhs, 0, arena);
    taut_status status = taut_arena_status(arena);

    walk.x = x;
    walk.y = y;
    status = status == TAUT_OK ? run_blocks(&walk, apply_block) : TAUT_NO_MEMORY;
    taut_arena_free(arena);
    return status;
}

/* Row r of the exact sums, in the ring. */
static void add_to_row(const struct walk *walk, int r, double factor, const double *by)
{
    const size_t at = (size_t)r % walk->ring * walk->length;
    walk->kernel->add_scaled_exactly(walk->length, factor, by, by + walk->length, walk->high + at,
                                     walk->low + at);
}

/* Row `done` of y, which no later row of x reaches. */
static void end_row(const struct walk *walk, int done)
{
    double *high = walk->high + (size_t)done % walk->ring * walk->length;
    double *low = walk->low + (size_t)done % walk->ring * walk->length;

    for (size_t j = 0; j < walk->length; j++) {
        const size_t at = (size_t)done * walk->length + j;
        walk->y[at] = (walk->right[at] + high[j]) + low[j];
        high[j] = low[j] = 0.0;
    }
}

static void residual_block(void *context, int worker, int64_t task)
{
    const struct walk walk = part_of(context, worker);
    const taut_tensor *tensor = walk.tensor;
    const struct block block = block_of(&walk, task);
    const int wk = tensor->ku->width, wm = tensor->mu->width, wu = wk > wm ? wk : wm;
    int done = block.from;

    for (int i = block.begin; i < block.end && !beat_row(&walk, 20); i++) {
        const double *row = walk.x + (size_t)i * walk.length;
        make_row(&walk, tensor->mv, walk.mass, 1, row, walk.by_m);
        make_row(&walk, tensor->kv, walk.stiff, 1, row, walk.by_k);
        for (int to = first_row(&block, i, wk); to <= last_row(&block, i, wk); to++) {
            add_to_row(&walk, to, -tensor->su * taut_band_at(tensor->ku, to, i), walk.by_m);
        }
        for (int to = first_row(&block, i, wm); to <= last_row(&block, i, wm); to++) {
            add_to_row(&walk, to, -tensor->sv * taut_band_at(tensor->mu, to, i), walk.by_k);
        }
        if (i - wu >= block.from) {
            end_row(&walk, done++);
        }
    }
    while (done < block.upto) {
        end_row(&walk, done++);
    }
}

static double sum_of_squares(size_t count, const double *x)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        sum += x[i] * x[i];
    }
    return sum;
}

taut_status taut_tensor_residual(const taut_tensor *tensor, int nrhs, const double *right,
                                 const double *x, double *r, double *norm)
{
    taut_arena *arena = taut_arena_new();
    struct walk walk = walk_of(tensor, nrhs, 1, arena);
    const size_t count = (size_t)tensor->ku->n * walk.length;
    taut_status status = taut_arena_status(arena);

    walk.x = x;
    walk.right = right;
    walk.y = r;
    const double before = norm != NULL && status == TAUT_OK ? sum_of_squares(count, right) : 0.0;
    status = status == TAUT_OK ? run_blocks(&walk, residual_block) : TAUT_NO_MEMORY;
    if (norm != NULL && status == TAUT_OK) {
        const double after = sum_of_squares(count, r);
        *norm = before > 0.0 ? sqrt(after / before) : after > 0.0 ? INFINITY : 0.0;
    }
    taut_arena_free(arena);
    return status;
}
