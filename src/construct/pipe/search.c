#include "construct/pipe/search.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { ROUNDS_MAX = 600 };

/* The same directions on every machine: a linear congruence, its high bits. */
static double next(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-52 - 1;
}

/* Rows of an orthonormal matrix: the reflection at a plane normal to a turning vector. */
static void directions(int count, uint64_t *state, double (*d)[TAUT_PIPE_SEARCH_MAX])
{
    double v[TAUT_PIPE_SEARCH_MAX], square = 0;
    for (int i = 0; i < count; i++) {
        v[i] = next(state);
        square += v[i] * v[i];
    }
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            d[i][j] = (i == j ? 1.0 : 0.0) - (square > 0 ? 2 * v[i] * v[j] / square : 0.0);
        }
    }
}

double taut_pipe_search(int count, const double *lo, const double *hi, taut_pipe_objective f,
                        void *context, double *x, int *evaluations)
{
    double d[TAUT_PIPE_SEARCH_MAX][TAUT_PIPE_SEARCH_MAX];
    double best = f(context, x), step = 0.125;
    uint64_t state = 1;

    assert(count >= 1 && count <= TAUT_PIPE_SEARCH_MAX);
    for (int round = 0; round < ROUNDS_MAX && step > 1e-9; round++) {
        int better = 0;
        memset(d, 0, sizeof d);
        directions(count, &state, d);
        if (round % 2 == 0) { /* every other round along the axes, where the box's walls are */
            for (int i = 0; i < count; i++) {
                for (int j = 0; j < count; j++) {
                    d[i][j] = i == j ? 1 : 0;
                }
            }
        }
        for (int k = 0; k < 2 * count && !better; k++) {
            double trial[TAUT_PIPE_SEARCH_MAX];
            double value = 0;
            for (int j = 0; j < count; j++) {
                const double move = (k % 2 == 0 ? step : -step) * (hi[j] - lo[j]) * d[k / 2][j];
                trial[j] = fmin(hi[j], fmax(lo[j], x[j] + move));
            }
            if (memcmp(trial, x, (size_t)count * sizeof *x) == 0) {
                continue;
            }
            value = f(context, trial);
            *evaluations += 1;
            if (value < best) {
                best = value;
                memcpy(x, trial, (size_t)count * sizeof *x);
                better = 1;
            }
        }
        step = better ? fmin(0.25, 2 * step) : (round % 2 == 0 ? step : 0.5 * step);
    }
    return best;
}
