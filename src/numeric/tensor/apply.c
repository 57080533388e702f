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

/* A walk over the rows of x: the products of one row with Mv and Kv are made once, and added with
 * the weights su Ku and sv Mu to the rows of y they reach. */
struct walk {
    const taut_tensor *tensor;
    const taut_kernel *kernel;
    size_t nrhs, length;  /* of a row: nv nrhs */
    double *mass, *stiff; /* Mv, Kv by diagonals */
    double *by_m, *by_k;  /* row Mv, row Kv: double[2][length], the second half the low parts */
    double *high, *low;   /* sums that are kept in two parts: double[2 wu + 1][length] */
};

/* The arena's status tells whether all is there. */
static struct walk walk_of(const taut_tensor *tensor, int nrhs, int is_exact, taut_arena *arena)
{
    const int kv = tensor->kv->width, mv = tensor->mv->width;
    const int ku = tensor->ku->width, mu = tensor->mu->width;
    const size_t diagonals = 2 * (size_t)(kv > mv ? kv : mv) + 1;
    const size_t ring = is_exact ? 2 * (size_t)(ku > mu ? ku : mu) + 1 : 0;
    const size_t length = (size_t)tensor->kv->n * (size_t)nrhs, bytes = length * sizeof(double);
    struct walk walk = {.tensor = tensor,
                        .kernel = taut_kernel_best(),
                        .nrhs = (size_t)nrhs,
                        .length = length,
                        .mass = taut_arena_take_raw(arena, diagonals, bytes),
                        .stiff = taut_arena_take_raw(arena, diagonals, bytes),
                        .by_m = taut_arena_take_raw(arena, 2, bytes),
                        .by_k = taut_arena_take_raw(arena, 2, bytes),
                        .high = taut_arena_take(arena, ring, bytes),
                        .low = taut_arena_take(arena, ring, bytes)};
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

/* The rows of Ku or Mu that meet row i. */
static int first_row(int i, int width)
{
    return i > width ? i - width : 0;
}

static int last_row(int i, int width, int n)
{
    return n - 1 - i > width ? i + width : n - 1;
}

/* Tells of a row that goes into others: `each` operations for a number and diagonal. */
static int beat_row(const taut_tensor *tensor, double each, size_t length)
{
    const int diagonals =
        2 * (tensor->ku->width + tensor->mu->width + tensor->kv->width + tensor->mv->width) + 4;
    return taut_pulse_beat(tensor->pulse, each * diagonals * (double)length);
}

static taut_status apply_with(const taut_tensor *tensor, int nrhs, const double *x,
                              taut_arena *arena, double *y)
{
    const struct walk walk = walk_of(tensor, nrhs, 0, arena);
    const int nu = tensor->ku->n, wk = tensor->ku->width, wm = tensor->mu->width;
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    memset(y, 0, (size_t)nu * walk.length * sizeof *y);
    for (int i = 0; i < nu; i++) {
        if (beat_row(tensor, 2, walk.length)) {
            return TAUT_INTERRUPTED;
        }
        const double *row = x + (size_t)i * walk.length;
        make_row(&walk, tensor->mv, walk.mass, 0, row, walk.by_m);
        make_row(&walk, tensor->kv, walk.stiff, 0, row, walk.by_k);
        for (int r = first_row(i, wk); r <= last_row(i, wk, nu); r++) {
            walk.kernel->add_scaled(walk.length, tensor->su * taut_band_at(tensor->ku, r, i),
                                    walk.by_m, y + (size_t)r * walk.length);
        }
        for (int r = first_row(i, wm); r <= last_row(i, wm, nu); r++) {
            walk.kernel->add_scaled(walk.length, tensor->sv * taut_band_at(tensor->mu, r, i),
                                    walk.by_k, y + (size_t)r * walk.length);
        }
    }
    return TAUT_OK;
}

taut_status taut_tensor_apply(const taut_tensor *tensor, int nrhs, const double *x, double *y)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = apply_with(tensor, nrhs, x, arena, y);
    taut_arena_free(arena);
    return status;
}

/* Row r of the exact sums, in a ring of `ring` rows. */
static void add_to_row(const struct walk *walk, int r, int ring, double factor, const double *by)
{
    const size_t at = (size_t)(r % ring) * walk->length;
    walk->kernel->add_scaled_exactly(walk->length, factor, by, by + walk->length, walk->high + at,
                                     walk->low + at);
}

static taut_status find_residual(const taut_tensor *tensor, int nrhs, const double *right,
                                 const double *x, taut_arena *arena, double *r, double *norm)
{
    const struct walk walk = walk_of(tensor, nrhs, 1, arena);
    const int nu = tensor->ku->n, wk = tensor->ku->width, wm = tensor->mu->width;
    const int wu = wk > wm ? wk : wm, ring = 2 * wu + 1;
    double before = 0.0, after = 0.0;
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < nu + wu; i++) {
        if (beat_row(tensor, 20, walk.length)) {
            return TAUT_INTERRUPTED;
        }
        if (i < nu) {
            const double *row = x + (size_t)i * walk.length;
            make_row(&walk, tensor->mv, walk.mass, 1, row, walk.by_m);
            make_row(&walk, tensor->kv, walk.stiff, 1, row, walk.by_k);
            for (int to = first_row(i, wk); to <= last_row(i, wk, nu); to++) {
                add_to_row(&walk, to, ring, -tensor->su * taut_band_at(tensor->ku, to, i),
                           walk.by_m);
            }
            for (int to = first_row(i, wm); to <= last_row(i, wm, nu); to++) {
                add_to_row(&walk, to, ring, -tensor->sv * taut_band_at(tensor->mu, to, i),
                           walk.by_k);
            }
        }
        const int done = i - wu; /* no later row reaches it */
        if (done >= 0) {
            double *high = walk.high + (size_t)(done % ring) * walk.length;
            double *low = walk.low + (size_t)(done % ring) * walk.length;
            for (size_t j = 0; j < walk.length; j++) {
                const size_t at = (size_t)done * walk.length + j;
                const double given = right[at];
                r[at] = (given + high[j]) + low[j];
                before += given * given;
                after += r[at] * r[at];
                high[j] = low[j] = 0.0;
            }
        }
    }
    if (norm != NULL) {
        *norm = before > 0.0 ? sqrt(after / before) : after > 0.0 ? INFINITY : 0.0;
    }
    return TAUT_OK;
}

taut_status taut_tensor_residual(const taut_tensor *tensor, int nrhs, const double *right,
                                 const double *x, double *r, double *norm)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = find_residual(tensor, nrhs, right, x, arena, r, norm);
    taut_arena_free(arena);
    return status;
}
