/* solve.c -- Newton's method in all coordinates, between the metric operator and the Hessian.
 *
 *     theta = 1
 *     until the free derivatives are below the aim, or no step lowers energy or derivatives any more:
 *         d = - B(theta)^-1 g;  theta is raised eightfold while B has negative pivots
 *         d is cut to a share of the size
 *         taken where E falls by a tenth of what d promises, or, where that is lost in rounding, the derivatives
 *         get less; then theta / 8, else theta * 8
 *     the same with more Gauss nodes, until these leave the derivatives below the aim
 *
 * At theta = 1 every step lowers E: L is above H (construct/plateau/area.h). Moves within the sheets, which E does not see, are held back by
 * theta alone. Where it is at rest the film is looked at with theta = 1e-5: negative pivots there are a saddle.
 */
#include "construct/film/complex/solve.h"

#include "construct/film/complex/energy.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { RULES = 5, ITERATIONS = 200, STALLS = 4 };
static const int extra_nodes[RULES] = {2, 4, 8, 15, 27};
static const double theta_least = 1e-9, theta_saddle = 1e-5;
static const double theta_rounding =
    1e-6; /* where energies tell nothing any more: moves within sheets are let be */
static const double longest_step = 0.15; /* of the size, which scaled is between 1 and 2 */
static const double fold = 0.02; /* least area element over its mean, or over what it began with */
static const double share_promised = 0.1, rounding = 1e-13;
static const double aim_share = 0.1; /* of the tolerance */

typedef struct work {
    const taut_film_layout *layout;
    const taut_monitor *monitor;
    taut_error *error;
    taut_film_energy *energy;
    size_t nodes;
    double *x, *next, *gradient, *after, *d, *right;
    double value, largest, residual, theta, least_start, aim;
    int iterations, most;
} work;

static int must_stop(const work *w)
{
    return w->monitor->progress != NULL &&
           w->monitor->progress(w->monitor->context, taut_none, "film") != TAUT_GO_ON;
}

/* The largest derivative along what is free, over the largest. */
static double residual_of(const work *w, const double *gradient, double largest)
{
    double most = 0;

    for (size_t a = 0; a < w->nodes; a++) {
        for (int k = 0; k < w->energy->size[a]; k++) {
            most = fmax(most,
                        fabs(taut_dot(gradient + 3 * a, w->energy->free + 9 * a + 3 * (size_t)k)));
        }
    }
    return most / largest;
}

static void look(work *w)
{
    w->value = taut_film_energy_value(w->energy, w->x, w->gradient, &w->largest);
    for (int k = 0; k < w->layout->complex.strand_count; k++) {
        w->largest = fmax(w->largest, w->layout->ratios[k]);
    }
    w->residual = residual_of(w, w->gradient, w->largest);
}

/* d by the least theta from here on whose pivots are positive. */
static taut_status find_step(work *w, double *promised)
{
    int negative = 1;

    while (negative > 0) {
        const taut_status status = taut_film_energy_factor(w->energy, w->theta, &negative);
        if (status != TAUT_OK) {
            return status;
        }
        if (negative > 0 && w->theta >= 1) {
            return TAUT_NOT_CONVERGED;
        }
        w->theta = negative > 0 ? fmin(1, 8 * w->theta) : w->theta;
    }
    taut_film_energy_step(w->energy, w->gradient, w->right, w->d);
    double longest = 0;
    for (size_t a = 0; a < w->nodes; a++) {
        longest = fmax(longest, taut_norm(w->d + 3 * a));
    }
    const double cut = longest > longest_step ? longest_step / longest : 1;
    *promised = 0;
    for (size_t k = 0; k < 3 * w->nodes; k++) {
        w->d[k] *= cut;
        *promised -= w->gradient[k] * w->d[k];
    }
    return isfinite(longest) ? TAUT_OK : TAUT_NOT_CONVERGED;
}

/* Is x + d better? Then it is x. */
static int try_step(work *w, double promised)
{
    double largest = 0;

    for (size_t k = 0; k < 3 * w->nodes; k++) {
        w->next[k] = w->x[k] + w->d[k];
    }
    const int by_energy = promised > rounding * w->value;
    const double value = taut_film_energy_value(w->energy, w->next, w->after, &largest);
    const int better = by_energy ? value <= w->value - share_promised * promised
                                 : residual_of(w, w->after, w->largest) < w->residual;
    if (better) {
        memcpy(w->x, w->next, 3 * w->nodes * sizeof(double));
    }
    return better;
}

static taut_status refuse_fold(const work *w)
{
    return taut_fail(w->error, TAUT_NOT_CONVERGED, "folds", "/patches", w->energy->least, fold,
                     "after %d steps the least area element is %.3g of the mean: a patch folds or "
                     "shrinks to a line on its way to the least energy; give another layout, or "
                     "bring its edges together",
                     w->iterations, w->energy->least);
}

/* With this rule; TAUT_NOT_CONVERGED without a reason: no step is better. */
static taut_status descend(work *w)
{
    int stalls = 0;

    look(w);
    while (w->residual > w->aim && stalls < STALLS) {
        double promised = 0;
        if (w->iterations >= w->most) {
            return taut_fail(w->error, TAUT_NOT_CONVERGED, "not-converged", "/max_iterations",
                             w->residual, w->aim,
                             "after %d steps the largest derivative is %.3g of the largest, "
                             "expected %.3g",
                             w->iterations, w->residual, w->aim);
        }
        if (must_stop(w)) {
            return taut_fail(w->error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                             "stopped before the film was at rest");
        }
        taut_film_energy_second(w->energy);
        int taken = 0;
        const double before = w->residual;
        while (!taken) {
            const taut_status status = find_step(w, &promised);
            if (status == TAUT_NO_MEMORY) {
                return status;
            }
            if (status == TAUT_OK && promised <= rounding * w->value && w->theta < theta_rounding) {
                w->theta = theta_rounding;
                continue;
            }
            taken = status == TAUT_OK && try_step(w, promised);
            if (!taken && w->theta >= 1) {
                break;
            }
            w->theta = taken ? fmax(theta_least, w->theta / 8) : fmin(1, 8 * w->theta);
        }
        w->iterations++;
        look(w);
        if (w->energy->least < fold * fmin(1, w->least_start)) {
            return refuse_fold(w);
        }
        stalls = !taken                           ? STALLS
                 : promised > rounding * w->value ? 0
                 : w->residual > 0.5 * before     ? stalls + 1
                                                  : 0;
    }
    return TAUT_OK;
}

/* Rules, until a finer one agrees that the film is at rest. */
static taut_status settle(work *w)
{
    taut_status status = TAUT_OK;

    for (int rule = 0; status == TAUT_OK && rule < RULES; rule++) {
        taut_film_energy_free(w->energy);
        w->energy = NULL;
        status = taut_film_energy_new(w->layout, extra_nodes[rule], &w->energy);
        if (status != TAUT_OK) {
            return status;
        }
        look(w);
        if (rule == 0) {
            w->least_start = w->energy->least;
        } else if (w->residual <= 4 * w->aim) {
            break;
        }
        w->theta = rule == 0 ? 1 : fmin(w->theta, 1e-6);
        status = descend(w);
    }
    return status;
}

static taut_status check_saddle(work *w, taut_film_rest *rest)
{
    taut_film_energy_second(w->energy);
    taut_status status = taut_film_energy_factor(w->energy, theta_saddle, &rest->negative);

    if (status == TAUT_OK && rest->negative > 0 &&
        !w->layout->complex.problem->accepts_stationary) {
        status =
            taut_fail(w->error, TAUT_NO_SOLUTION, "unstable", "/patches", rest->negative, 0,
                      "the film is at rest, and %d ways lead down from it: begin elsewhere, or "
                      "accept what is stationary",
                      rest->negative);
    }
    return status;
}

taut_status taut_film_rest_find(const taut_film_layout *layout, const taut_monitor *monitor,
                                taut_arena *arena, taut_film_rest *rest, taut_error *error)
{
    const taut_film_problem *problem = layout->complex.problem;
    const size_t nodes = (size_t)layout->complex.nodes, bytes = 3 * sizeof(double);
    const double tolerance = problem->tolerance > 0 ? problem->tolerance : 1e-10;
    work w = {.layout = layout,
              .monitor = monitor,
              .error = error,
              .nodes = nodes,
              .x = taut_arena_copy(arena, layout->start, nodes, bytes),
              .next = taut_arena_take(arena, nodes, bytes),
              .gradient = taut_arena_take(arena, nodes, bytes),
              .after = taut_arena_take(arena, nodes, bytes),
              .d = taut_arena_take(arena, nodes, bytes),
              .right = taut_arena_take(arena, nodes, bytes),
              .aim = fmin(aim_share * tolerance, 1e-7),
              .most = problem->max_iterations > 0 ? problem->max_iterations : ITERATIONS};

    rest->points = taut_arena_take(arena, nodes, bytes);
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        status = settle(&w);
    }
    if (status == TAUT_OK) {
        status = check_saddle(&w, rest);
    }
    if (status == TAUT_OK) {
        rest->unknowns = taut_sparse_rows(w.energy->sparse);
        rest->iterations = w.iterations;
        rest->residual = w.residual;
        status = taut_scaling_undo(&layout->scaling, nodes, layout->points, layout->known, w.x,
                                   rest->points, error);
    }
    for (size_t a = 0; status == TAUT_OK && a < nodes; a++) {
        if (!layout->known[a]) {
            taut_film_hold_onto(&layout->complex.holds[a], rest->points + 3 * a);
        }
    }
    taut_film_energy_free(w.energy);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}
