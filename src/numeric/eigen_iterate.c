/* Rayleigh quotient iteration, kernel->lanes eigenpairs at a time:
 *     (K - s M) y = M x,    s' = s + y.(M x) / y.(M y),    x' = y / sqrt(y.(M y))
 * converges cubically ([Parlett1998] 4.6). Each factorisation also counts the eigenvalues below s,
 * so a step that would leave the bracket of its eigenvalue is replaced by bisection of the bracket.
 */
#include "numeric/eigen_internal.h"

#include "core/memory.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { STEPS_MAX = 24 };

/* A step shorter than this share of the bracket is the last: it leaves an error in the vector of
 * about its power 3/2, for taut_eigen_polish to remove. */
static const double last_step = 0x1p-12;

/* The state of one eigenvalue on the way. */
struct lane {
    double shift, low, high;
    double width; /* the scale of the gaps to its neighbours */
    int index;
    int is_done;
};

struct block {
    const taut_pencil *pencil;
    double *factor; /* double[width + n][width + 1][lanes], the first rows zero */
    double *y, *z;  /* double[n][lanes] */
};

/* splitmix64 */
double taut_eigen_scatter(unsigned long long seed)
{
    uint64_t x = seed * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    x ^= x >> 31;
    return (double)(x >> 11) * 0x1p-52 - 1.0;
}

static void start(const struct block *block, const struct lane *lane)
{
    const int n = block->pencil->k.n, lanes = block->pencil->kernel->lanes;
    for (int i = 0; i < n; i++) {
        for (int l = 0; l < lanes; l++) {
            block->z[(size_t)i * (size_t)lanes + (size_t)l] =
                taut_eigen_scatter((uint64_t)lane[l].index * (uint64_t)n + (uint64_t)i + 1);
        }
    }
}

static double middle(double low, double high)
{
    return low + 0.5 * (high - low);
}

/* What one step tells about one eigenvalue: `below` eigenvalues lie under the shift, and the
 * quotient moved by `step`. */
static void advance(struct lane *lane, int below, double step)
{
    if (below <= lane->index) {
        lane->low = fmax(lane->low, lane->shift);
    } else {
        lane->high = fmin(lane->high, lane->shift);
    }
    const double next = lane->shift + step;
    const double slack = last_step * lane->width;
    if (fabs(step) <= fmax(slack, 0x1p-50 * fabs(lane->shift))) {
        lane->is_done = next > lane->low - slack && next < lane->high + slack;
    }
    if (lane->is_done || (next > lane->low && next < lane->high)) {
        lane->shift = next;
    } else {
        lane->shift = middle(lane->low, lane->high);
    }
}

/* One step of all lanes. Returns 1 when all are done. */
static int step(const struct block *block, struct lane *lane)
{
    const taut_pencil *p = block->pencil;
    const taut_kernel *kernel = p->kernel;
    const int n = p->k.n, w = p->k.width, lanes = kernel->lanes;
    const size_t entries = (size_t)n * (size_t)lanes;
    double minus[TAUT_LANES_MAX], negative[TAUT_LANES_MAX] = {0};
    double yg[TAUT_LANES_MAX], yy[TAUT_LANES_MAX], unused[TAUT_LANES_MAX];

    for (int l = 0; l < lanes; l++) {
        minus[l] = -lane[l].shift;
    }
    kernel->band_factor(0, n, w, p->k.a, p->m.a, 1.0, minus, p->tiny, block->factor, negative);
    memcpy(block->y, block->z, entries * sizeof(double));
    kernel->band_substitute(n, w, 1, block->factor, block->y);
    kernel->lane_dot(n, block->y, block->z, yg, unused);
    kernel->band_multiply(n, w, p->m.a, block->y, block->z);
    kernel->lane_dot(n, block->y, block->z, yy, unused);

    int done = 1;
    double scale[TAUT_LANES_MAX];
    for (int l = 0; l < lanes; l++) {
        scale[l] = 1.0 / sqrt(yy[l]);
        if (!lane[l].is_done) {
            advance(&lane[l], (int)negative[l], yg[l] / yy[l]);
        }
        done = done && lane[l].is_done;
    }
    for (size_t i = 0; i < entries; i += (size_t)lanes) {
        for (int l = 0; l < lanes; l++) {
            block->y[i + (size_t)l] *= scale[l];
            block->z[i + (size_t)l] *= scale[l];
        }
    }
    return done;
}

static void iterate_block(const struct block *block, int first, const taut_bracket *bracket,
                          taut_eigenpairs *pairs)
{
    const int n = block->pencil->k.n, lanes = block->pencil->kernel->lanes;
    struct lane lane[TAUT_LANES_MAX];

    for (int l = 0; l < lanes; l++) {
        const int j = first + l < n ? first + l : n - 1;
        const taut_bracket *b = &bracket[j];
        lane[l].index = j;
        lane[l].low = b->low;
        lane[l].high = b->high;
        lane[l].width = taut_eigen_gap(n, bracket, j);
        lane[l].shift = b->guess;
        lane[l].is_done = 0;
    }
    start(block, lane);
    for (int i = 0; i < STEPS_MAX && !step(block, lane); i++) {
    }
    for (int l = 0; l < lanes && first + l < n; l++) {
        pairs->values[first + l] = lane[l].shift;
        double *x = pairs->vectors + (size_t)(first + l) * (size_t)n;
        for (int i = 0; i < n; i++) {
            x[i] = block->y[(size_t)i * (size_t)lanes + (size_t)l];
        }
    }
}

taut_status taut_eigen_iterate(const taut_pencil *pencil, const taut_bracket *bracket,
                               taut_eigenpairs *pairs)
{
    const size_t n = (size_t)pencil->k.n, w = (size_t)pencil->k.width;
    const size_t lanes = (size_t)pencil->kernel->lanes;
    taut_status status = TAUT_NO_MEMORY;
    struct block block = {pencil, taut_alloc_aligned((n + w) * (w + 1), lanes * sizeof(double)),
                          taut_alloc_aligned(n, lanes * sizeof(double)),
                          taut_alloc_aligned(n, lanes * sizeof(double))};
    if (block.factor == NULL || block.y == NULL || block.z == NULL) {
        goto done;
    }
    memset(block.factor, 0, w * (w + 1) * lanes * sizeof(double));
    for (int first = 0; first < pencil->k.n; first += pencil->kernel->lanes) {
        iterate_block(&block, first, bracket, pairs);
    }
    status = TAUT_OK;

done:
    taut_free(block.z);
    taut_free(block.y);
    taut_free(block.factor);
    return status;
}
