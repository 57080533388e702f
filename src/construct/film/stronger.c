/* stronger.c -- where a film with the forces that are asked for is not found.
 *
 *     factor = 2, 4, ..: the start solved with all forces so many times, until one succeeds
 *     lower it, from film to film, by steps that are halved where one fails
 *     1 is reached: done; no step is left: cable-too-weak, the last factor told
 */
#include "construct/film/stronger.h"

#include "core/fail.h"

#include <math.h>
#include <string.h>

enum { DOUBLINGS = 8, LOWERINGS = 64 };

static const double step_least = 0x1p-10; /* of the logarithm of the factor of all forces */

static taut_status refuse_weak(const taut_film_work *w, double least, taut_error *error)
{
    const taut_film_problem *problem = w->space->problem;
    const int e = w->edges[0];
    char where[32] = "/edges/u0/cable";
    memcpy(where + 7, taut_film_edge_names[e], 2);
    return taut_fail(
        error, TAUT_NO_SOLUTION, "cable-too-weak", where, problem->edges[e].force,
        least * problem->edges[e].force,
        "the cables are too weak for this film: lowered together from where there is "
        "a film, the last found is at %.6g times their forces (%.6g for edge %s); "
        "below it the film draws a cable into another edge, folds, or gets thinner at a "
        "corner than its knots can tell",
        least, least * problem->edges[e].force, taut_film_edge_names[e]);
}

/* net: a film with all forces *factor times, from the start. */
static taut_status find_strong(taut_film_work *w, double *factor, taut_error *error)
{
    taut_error inner = {.status = TAUT_NOT_CONVERGED};
    *factor = 1;
    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < DOUBLINGS; k++) {
        *factor *= 2;
        memcpy(w->net, w->space->start, 3 * w->space->count * sizeof(double));
        inner.status = taut_film_rest(w, *factor, &inner);
    }
    return inner.status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&inner, error);
}

/* Is that the end of films that get weaker: a fold, or one that is at rest by every rule, and another by each? */
static int is_end(const taut_film_work *w, const taut_error *inner)
{
    return strcmp(inner->reason, "folds") == 0 || (strcmp(inner->reason, "not-converged") == 0 &&
                                                   w->region.residual <= w->region.tolerance);
}

/* From the film at `factor` down to 1. `saved` is a net of scratch. */
static taut_status come_down(taut_film_work *w, double factor, double *saved, taut_error *error)
{
    const size_t bytes = 3 * w->space->count * sizeof(double);
    double step = 0.5; /* the factor is multiplied by 1 - step */
    taut_error inner = {.status = TAUT_OK};

    for (int k = 0; factor > 1 && k < LOWERINGS && step > step_least; k++) {
        const double next = fmax(1, factor * (1 - step));
        memcpy(saved, w->net, bytes);
        inner.status = taut_film_rest(w, next, &inner);
        if (inner.status == TAUT_OK) {
            factor = next;
            continue;
        }
        if (inner.status != TAUT_NOT_CONVERGED) {
            break;
        }
        memcpy(w->net, saved, bytes);
        step *= 0.5;
    }
    if (factor > 1 && is_end(w, &inner)) {
        return refuse_weak(w, factor, error);
    }
    return factor > 1 ? taut_film_pass_on(&inner, error) : TAUT_OK;
}

taut_status taut_film_lower_forces(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    double factor = 1;
    double *saved = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    taut_status status = saved != NULL ? find_strong(w, &factor, error) : taut_fail_memory(error);

    return status == TAUT_OK ? come_down(w, factor, saved, error) : status;
}
