/* stronger.c -- where a film with the forces that are asked for is not found.
 *
 *     factor = 2, 4, ..: the start solved with all forces so many times, until one succeeds
 *     lower it, from film to film, or from the start anew, by steps that are halved where both fail
 *     1 is reached: done; no step is left: cable-too-weak, the last factor told
 *
 * Cables of given length are so much stronger by less excess over their chords, elastic ones by less length
 * (equilibrium.h).
 */
#include "construct/film/stronger.h"

#include "construct/film/coarse.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DOUBLINGS = 8, LOWERINGS = 64, ANEW = 6 };

static const double step_least = 0x1p-10; /* of the logarithm of the factor of all forces */

static taut_status refuse_weak(const taut_film_work *w, double least, taut_error *error)
{
    const taut_film_space *space = w->space;
    const taut_film_problem *problem = space->problem;
    const int unit = space->scaling.outer + space->scaling.inner;
    char where[32], strong[96];
    int e = w->edges[0];

    for (int k = w->functional->cable_count - 1; k >= 0;
         k--) { /* the first of given force, or the first */
        e = problem->edges[w->edges[k]].law == TAUT_FILM_FORCE || k == 0 ? w->edges[k] : e;
    }
    const taut_film_edge *edge = &problem->edges[e];
    const char *name = taut_film_edge_names[e];
    double found = edge->force, limit = least * edge->force;
    if (edge->law == TAUT_FILM_ELASTIC) {
        found = edge->unstressed;
        limit = found - ldexp((least - 1) * space->ratios[e] / space->cables[e].stiffness, unit);
        snprintf(strong, sizeof strong, "%.6g unstressed for edge %s", limit, name);
    } else if (edge->law == TAUT_FILM_FORCE) {
        snprintf(strong, sizeof strong, "%.6g for edge %s", limit, name);
    } else {
        found = ldexp(space->cables[e].length, unit);
        limit = ldexp(taut_film_strong_length(space, e, least), unit);
        snprintf(strong, sizeof strong, "a length of %.6g for edge %s", limit, name);
    }
    snprintf(where, sizeof where, "/edges/%s/cable", name);
    return taut_fail(
        error, TAUT_NO_SOLUTION, "cable-too-weak", where, found, limit,
        "the cables are too weak for this film: lowered together from where there is "
        "a film, the last found is at %.6g times their forces (%s); "
        "below it the film draws a cable into another edge, folds, or gets thinner at a "
        "corner than its knots can tell",
        least, strong);
}

/* net: the film with all forces so many times that the start leads to. */
static taut_status start_anew(taut_film_work *w, double factor, taut_error *error)
{
    memcpy(w->net, w->space->start, 3 * w->space->count * sizeof(double));
    const taut_status begun = taut_film_begin_coarse(w, factor);
    return begun == TAUT_OK ? taut_film_rest(w, factor, error) : taut_fail_status(error, begun);
}

/* net: a film with all forces *factor times, from the start. */
static taut_status find_strong(taut_film_work *w, double *factor, taut_error *error)
{
    taut_error inner = {.status = TAUT_NOT_CONVERGED};
    *factor = 1;
    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < DOUBLINGS; k++) {
        *factor *= 2;
        inner.status = start_anew(w, *factor, &inner);
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
        if (inner.status == TAUT_NOT_CONVERGED && k < ANEW) {
            inner.status = start_anew(w, next, &inner); /* from there, what is nearer may be lost */
        }
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
