#include "numeric/tensor/apply.h"

#include "core/memory.h"
#include "numeric/kernel/kernel.h"

#include <math.h>
#include <string.h>

/* A matrix of the second direction by diagonals, each entry repeated for every coordinate:
 *     at[e + width][j * nrhs + c] = A(j, j + e),    zero outside the matrix. */
static void spread(const taut_band *band, size_t nrhs, double *at)
{
    const ptrdiff_t n = band->n, w = band->width;
    for (ptrdiff_t e = -w; e <= w; e++) {
        for (ptrdiff_t j = 0; j < n; j++) {
            const int inside = j + e >= 0 && j + e < n;
            const double value = inside ? taut_band_at(band, (int)j, (int)(j + e)) : 0.0;
            for (size_t c = 0; c < nrhs; c++) {
                *at++ = value;
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

static taut_status walk_init(const taut_tensor *tensor, int nrhs, int is_exact, struct walk *walk)
{
    const size_t wv =
        (size_t)(tensor->kv->width > tensor->mv->width ? tensor->kv->width : tensor->mv->width);
    const size_t wu =
        (size_t)(tensor->ku->width > tensor->mu->width ? tensor->ku->width : tensor->mu->width);
    walk->tensor = tensor;
    walk->kernel = taut_kernel_best();
    walk->nrhs = (size_t)nrhs;
    walk->length = (size_t)tensor->kv->n * (size_t)nrhs;
    walk->mass = taut_alloc(2 * wv + 1, walk->length * sizeof(double));
    walk->stiff = taut_alloc(2 * wv + 1, walk->length * sizeof(double));
    walk->by_m = taut_alloc(4, walk->length * sizeof(double));
    walk->high = taut_alloc(is_exact ? 2 * (2 * wu + 1) : 1, walk->length * sizeof(double));
    if (walk->mass == NULL || walk->stiff == NULL || walk->by_m == NULL || walk->high == NULL) {
        return TAUT_NO_MEMORY;
    }
    walk->by_k = walk->by_m + 2 * walk->length;
    walk->low = walk->high + (2 * wu + 1) * walk->length;
    spread(tensor->mv, walk->nrhs, walk->mass);
    spread(tensor->kv, walk->nrhs, walk->stiff);
    return TAUT_OK;
}

static void walk_clear(struct walk *walk)
{
    taut_free(walk->high);
    taut_free(walk->by_m);
    taut_free(walk->stiff);
    taut_free(walk->mass);
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

taut_status taut_tensor_apply(const taut_tensor *tensor, int nrhs, const double *x, double *y)
{
    struct walk walk;
    const int nu = tensor->ku->n;
    const taut_status status = walk_init(tensor, nrhs, 0, &walk);
    if (status == TAUT_OK) {
        memset(y, 0, (size_t)nu * walk.length * sizeof *y);
    }
    for (int i = 0; i < nu && status == TAUT_OK; i++) {
        const double *row = x + (size_t)i * walk.length;
        make_row(&walk, tensor->mv, walk.mass, 0, row, walk.by_m);
        make_row(&walk, tensor->kv, walk.stiff, 0, row, walk.by_k);
        const int wk = tensor->ku->width, wm = tensor->mu->width;
        for (int r = first_row(i, wk); r <= last_row(i, wk, nu); r++) {
            walk.kernel->add_scaled(walk.length, tensor->su * taut_band_at(tensor->ku, r, i),
                                    walk.by_m, y + (size_t)r * walk.length);
        }
        for (int r = first_row(i, wm); r <= last_row(i, wm, nu); r++) {
            walk.kernel->add_scaled(walk.length, tensor->sv * taut_band_at(tensor->mu, r, i),
                                    walk.by_k, y + (size_t)r * walk.length);
        }
    }
    walk_clear(&walk);
    return status;
}

/* Row r of the exact sums, in a ring of `ring` rows. */
static void add_to_row(const struct walk *walk, int r, int ring, double factor, const double *by)
{
    const size_t at = (size_t)(r % ring) * walk->length;
    walk->kernel->add_scaled_exactly(walk->length, factor, by, by + walk->length, walk->high + at,
                                     walk->low + at);
}

taut_status taut_tensor_residual(const taut_tensor *tensor, int nrhs, const double *right,
                                 const double *x, double *r, double *norm)
{
    struct walk walk;
    const int nu = tensor->ku->n, wk = tensor->ku->width, wm = tensor->mu->width;
    const int wu = wk > wm ? wk : wm, ring = 2 * wu + 1;
    double before = 0.0, after = 0.0;
    const taut_status status = walk_init(tensor, nrhs, 1, &walk);
    if (status == TAUT_OK) {
        memset(walk.high, 0, 2 * (size_t)ring * walk.length * sizeof(double));
    }
    for (int i = 0; i < nu + wu && status == TAUT_OK; i++) {
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
    walk_clear(&walk);
    if (status == TAUT_OK && norm != NULL) {
        *norm = before > 0.0 ? sqrt(after / before) : after > 0.0 ? INFINITY : 0.0;
    }
    return status;
}
