/* regular.c -- the least sine between R_u and R_v over the closed patch: a grid, then a
 * compass search from its lowest points.
 */
#include "certify/asymptotic/parts.h"
#include "core/arena.h"
#include "core/vec3.h"

enum { GRID = 65, REFINED = 12, STEPS_MAX = 400 };
static const double least_step = 1e-13;

static double sine_of(const double *xu, const double *xv)
{
    double normal[3];
    const double size = taut_norm(xu) * taut_norm(xv);
    taut_cross(xu, xv, normal);
    return size > 0 ? taut_norm(normal) / size : 0.0;
}

static double sine_at(const taut_surface *patch, double u, double v)
{
    double x[3][3];
    (void)taut_surface_eval(patch, u, v, 1, &x[0][0]);
    return sine_of(x[TAUT_XU], x[TAUT_XV]);
}

static double clamp(double t)
{
    return fmin(fmax(t, 0.0), 1.0);
}

/* Steps to the lowest of eight neighbours, halving the step where none is lower. */
static double refine(const taut_surface *patch, double at[2], double value)
{
    double step = 0.5 / (GRID - 1);
    for (int k = 0; k < STEPS_MAX && step > least_step; k++) {
        double best[2] = {at[0], at[1]}, lowest = value;
        for (int i = -1; i <= 1; i++) {
            for (int j = -1; j <= 1; j++) {
                const double u = clamp(at[0] + i * step), v = clamp(at[1] + j * step);
                const double sine = sine_at(patch, u, v);
                if (sine < lowest) {
                    lowest = sine;
                    best[0] = u;
                    best[1] = v;
                }
            }
        }
        if (lowest < value) {
            value = lowest;
            at[0] = best[0];
            at[1] = best[1];
        } else {
            step *= 0.5;
        }
    }
    return value;
}

/* Is grid point (i, j) no higher than its neighbours? */
static int is_low(const double *sines, int i, int j)
{
    for (int a = -1; a <= 1; a++) {
        for (int b = -1; b <= 1; b++) {
            const int k = i + a, l = j + b;
            if (k >= 0 && k < GRID && l >= 0 && l < GRID &&
                sines[k * GRID + l] < sines[i * GRID + j]) {
                return 0;
            }
        }
    }
    return 1;
}

/* The REFINED lowest of the grid's local minima, lowest first. */
static int lowest_points(const double *sines, int places[REFINED])
{
    int count = 0;
    for (int k = 0; k < GRID * GRID; k++) {
        int at = count;
        if (!is_low(sines, k / GRID, k % GRID)) {
            continue;
        }
        for (; at > 0 && sines[places[at - 1]] > sines[k]; at--) {
            if (at < REFINED) {
                places[at] = places[at - 1];
            }
        }
        if (at < REFINED) {
            places[at] = k;
            count += count < REFINED;
        }
    }
    return count;
}

static taut_status find_least(const taut_surface *patch, int threads, taut_arena *arena,
                              double *sine, double at[2])
{
    double line[GRID];
    int places[REFINED], count = 0;
    double *const values = taut_arena_take(arena, (size_t)GRID * GRID * 9, sizeof *values);
    double *const sines = taut_arena_take(arena, (size_t)GRID * GRID, sizeof *sines);
    taut_status status = taut_arena_status(arena);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < GRID; k++) {
        line[k] = k / (GRID - 1.0);
    }
    status = taut_surface_eval_grid(patch, GRID, line, GRID, line, 1, threads, values);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < GRID * GRID; k++) {
        sines[k] = sine_of(values + 9 * k + 3, values + 9 * k + 6);
    }
    count = lowest_points(sines, places);
    *sine = INFINITY;
    for (int k = 0; k < count; k++) {
        double here[2] = {line[places[k] / GRID], line[places[k] % GRID]};
        const double value = refine(patch, here, sines[places[k]]);
        if (value < *sine) {
            *sine = value;
            at[0] = here[0];
            at[1] = here[1];
        }
    }
    return TAUT_OK;
}

taut_status taut_regular_least(const taut_surface *patch, int threads, double *sine, double at[2])
{
    taut_arena *const arena = taut_arena_new();
    const taut_status status = find_least(patch, threads, arena, sine, at);
    taut_arena_free(arena);
    return status;
}
