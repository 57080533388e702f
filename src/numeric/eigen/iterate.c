/* Rayleigh quotient iteration, TAUT_LANES eigenpairs at a time:
 *     (K - s M) y = M x,    s' = s + y.(M x) / y.(M y),    x' = y / sqrt(y.(M y))
 * converges cubically ([Parlett1998] 4.6). Each factorisation also counts the eigenvalues below s,
 * so a step that would leave the bracket of its eigenvalue is replaced by bisection of the bracket.
 */
#include "numeric/eigen/internal.h"

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

/* splitmix64 */
static uint64_t mix_bits(uint64_t seed)
{
    uint64_t x = seed * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* The number in [-1, 1) of these bits. */
static double number_of(uint64_t bits)
{
    const uint64_t pattern = bits >> 12 | 0x4000000000000000u; /* [2, 4) */
    double x;
    memcpy(&x, &pattern, sizeof x);
    return x - 3.0;
}

double taut_eigen_scatter(uint64_t seed)
{
    return number_of(mix_bits(seed));
}

/* Random right-hand sides, a different one for each eigenvalue. */
static void scatter_start(const taut_eigen_block *block, const struct lane *lane)
{
    const size_t n = (size_t)block->pencil->k.n, lanes = TAUT_LANES;
    uint64_t own[TAUT_LANES];
    for (size_t l = 0; l < lanes; l++) {
        own[l] = mix_bits((uint64_t)lane[l].index + n);
    }
    for (size_t i = 0; i < n; i++) {
        const uint64_t row = mix_bits(i);
        for (size_t l = 0; l < lanes; l++) {
            block->m[i * lanes + l] = number_of(row ^ own[l]);
        }
    }
}

static double middle_of(double low, double high)
{
    return low + 0.5 * (high - low);
}

/* What one step tells about one eigenvalue: `below` eigenvalues lie under the shift, and the
 * quotient moved by `step`. */
static void advance_lane(struct lane *lane, int below, double step)
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
        lane->shift = middle_of(lane->low, lane->high);
    }
}

/* One step of all lanes from the right-hand sides in m, which are M x afterwards. Returns 1 when
 * all are done. */
static int step_lanes(const taut_eigen_block *block, struct lane *lane)
{
    const taut_pencil *p = block->pencil;
    const taut_kernel *kernel = p->kernel;
    const int n = p->k.n, w = p->k.width, lanes = TAUT_LANES;
    const size_t entries = (size_t)n * (size_t)lanes;
    double shift[TAUT_LANES], minus[TAUT_LANES], negative[TAUT_LANES] = {0};
    double dot[3 * TAUT_LANES], scale[TAUT_LANES];

    for (int l = 0; l < lanes; l++) {
        shift[l] = lane[l].shift;
        minus[l] = -shift[l];
    }
    kernel->band_factor(0, n, w, p->k.a, p->m.a, 1.0, minus, p->tiny, block->factor, negative);
    memcpy(block->x, block->m, entries * sizeof(double));
    kernel->band_substitute(n, w, 1, block->factor, block->x);
    kernel->band_pencil(n, w, p->k.a, p->m.a, shift, block->x, block->r, block->m, dot);

    int done = 1;
    for (int l = 0; l < lanes; l++) {
        scale[l] = 1.0 / sqrt(dot[l]);
        if (!lane[l].is_done) {
            advance_lane(&lane[l], (int)negative[l], dot[lanes + l] / dot[l]);
        }
        done = done && lane[l].is_done;
    }
    for (size_t i = 0; i < entries; i += (size_t)lanes) {
        for (int l = 0; l < lanes; l++) {
            block->x[i + (size_t)l] *= scale[l];
            block->m[i + (size_t)l] *= scale[l];
        }
    }
    return done;
}

static void iterate_block(taut_eigen_block *block, int first, const taut_bracket *bracket,
                          taut_eigenpairs *pairs)
{
    const int n = pairs->n, lanes = TAUT_LANES;
    struct lane lane[TAUT_LANES];

    for (int l = 0; l < lanes; l++) {
        const int j = first + l < n ? first + l : n - 1;
        const taut_bracket *b = &bracket[j];
        const double gap = taut_eigen_gap(n, bracket, j);
        lane[l] = (struct lane){b->guess, b->low, b->high, gap, j, 0};
        block->gap[l] = fmax(gap, 0x1p-44 * fabs(b->guess));
    }
    scatter_start(block, lane);
    for (int i = 0;
         i < STEPS_MAX && !taut_pencil_beat(block->pencil, 2) && !step_lanes(block, lane); i++) {
    }
    for (int l = 0; l < lanes; l++) {
        block->lambda[l] = lane[l].shift;
    }
    taut_eigen_block_polish(block, first, n - first < lanes ? n - first : lanes, pairs);
}

taut_status taut_eigen_iterate(const taut_pencil *pencil, taut_arena *arena,
                               const taut_bracket *bracket, taut_eigenpairs *pairs)
{
    taut_eigen_block block = taut_eigen_block_of(pencil, arena);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int first = 0; first < pairs->n && !taut_pulse_is_stopped(pencil->pulse);
         first += TAUT_LANES) {
        iterate_block(&block, first, bracket, pairs);
    }
    return TAUT_OK;
}
