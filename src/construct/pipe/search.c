#include "construct/pipe/search.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum {
    ROUNDS_MAX = 600,
    ROUNDS_MAX_CREASED = 1200,
    PATIENCE = 8 /* failed rounds at a step before it is halved where there are creases */
};

/* The same directions on every machine: a linear congruence, its high bits. */
static double next_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-52 - 1;
}

/* Rows of an orthonormal matrix: the reflection at a plane normal to v. */
static void set_directions(int count, const double *v, double (*d)[TAUT_PIPE_SEARCH_MAX])
{
    double square = 0;
    for (int i = 0; i < count; i++) {
        square += v[i] * v[i];
    }
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            d[i][j] = (i == j ? 1.0 : 0.0) - (square > 0 ? 2 * v[i] * v[j] / square : 0.0);
        }
    }
}

/* Normal to a plane whose reflection turns the first axis along `way`; a turning one without way.
 */
static void find_normal(int count, const double *way, uint64_t *state, double *v)
{
    double square = 0;
    for (int i = 0; i < count; i++) {
        square += way[i] * way[i];
    }
    for (int i = 0; i < count; i++) {
        v[i] = square > 0 ? way[i] - (i == 0 ? sqrt(square) : 0) : next_random(state);
    }
}

double taut_pipe_search(int count, const double *lo, const double *hi, int is_creased,
                        taut_pipe_objective f, void *context, double *x, int *evaluations)
{
    double d[TAUT_PIPE_SEARCH_MAX][TAUT_PIPE_SEARCH_MAX];
    double best = f(context, x), step = 0.125;
    double mark[TAUT_PIPE_SEARCH_MAX];
    const int rounds = is_creased ? ROUNDS_MAX_CREASED : ROUNDS_MAX;
    uint64_t state = 1;
    int failed = 0;

    memcpy(mark, x, (size_t)count * sizeof *x);
    assert(count >= 1 && count <= TAUT_PIPE_SEARCH_MAX);
    for (int round = 0; round < rounds && step > 1e-9; round++) {
        int better = 0;
        double v[TAUT_PIPE_SEARCH_MAX] = {0}, way[TAUT_PIPE_SEARCH_MAX] = {0};
        if (is_creased &&
            round % 4 == 3) { /* on along what was gained: a crease may lead that way */
            for (int j = 0; j < count; j++) {
                way[j] = (x[j] - mark[j]) / (hi[j] - lo[j]);
            }
            memcpy(mark, x, (size_t)count * sizeof *x);
        }
        if (round % 2 == 1) { /* every other round along the axes, where the box's walls are */
            find_normal(count, way, &state, v);
        }
        set_directions(count, v, d);
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
        failed = better ? 0 : failed + 1;
        if (better) {
            step = fmin(0.25, 2 * step);
        } else if (is_creased ? failed % PATIENCE == 0 : round % 2 == 1) {
            step *= 0.5;
        }
    }
    return best;
}
