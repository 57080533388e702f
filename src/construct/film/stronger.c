/* stronger.c -- where a film with the forces that are asked for is not found.
 *
 *     factor = 2, 4, ..: the start solved with all forces so many times, until one succeeds; then factors between these, and a
 *     little below 1
 *     lead it to 1, from film to film, or from the start anew, by steps that are halved where both fail
 *     1 is reached: done; no step is left: the start anew with 0.95, 0.9, .. of the last factor, and on from there
 *     at last: cable-too-weak, the last factor told
 *
 * Cables of given length are so much stronger by less excess over their chords, elastic ones by less length
 * (equilibrium.h).
 */
#include "construct/film/stronger.h"

#include "construct/film/coarse.h"
#include "construct/film/order.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TRIES = 19, LOWERINGS = 64, ANEW = 6, BELOW = 4 };

/* Where the start may lead to a film. */
static const double tries[TRIES] = {2,    4,    8,    16,   32,   64,   128,  256,  1.41, 2.83,
                                    5.66, 11.3, 1.19, 1.68, 2.38, 3.36, 4.76, 0.92, 0.84};

static const double step_least = 0x1p-10; /* of the logarithm of the factor of all forces */

static taut_status refuse_weak(const taut_film_work *w, double least, taut_error *error)
{
    const taut_film_space *space = w->space;
    const taut_film_problem *problem = space->problem;
    const int unit = space->scaling.outer + space->scaling.inner;
    char where[32], strong[96], note[200] = "";
    const int is_crossed = taut_film_order_note(problem, note, sizeof note);
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
        "the cables are too weak for this film of tension %g: lowered together from where there "
        "is a film, the last found is at %.6g times their forces (%s); "
        "below it the film draws a cable into another edge, folds, or gets thinner at a "
        "corner than its knots can tell%s%s",
        taut_film_tension(problem), least, strong, is_crossed ? "; " : "", note);
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
    taut_error first = {.status = TAUT_OK}, inner = {.status = TAUT_NOT_CONVERGED};

    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < TRIES; k++) {
        *factor = tries[k];
        inner.status = start_anew(w, *factor, &inner);
        first = k == 0 ? inner : first;
    }
    return inner.status == TAUT_NOT_CONVERGED ? taut_film_pass_on(&first, error)
           : inner.status == TAUT_OK          ? TAUT_OK
                                              : taut_film_pass_on(&inner, error);
}

/* Is that the end of films that get weaker: a fold, or one that is at rest by every rule, and another by each? */
static int is_end(const taut_film_work *w, const taut_error *inner)
{
    return strcmp(inner->reason, "folds") == 0 || (strcmp(inner->reason, "not-converged") == 0 &&
                                                   w->region.residual <= w->region.tolerance);
}

/* The next factor on the way to 1. */
static double next_of(double factor, double step)
{
    return factor > 1 ? fmax(1, factor * (1 - step)) : fmin(1, factor / (1 - step));
}

/* From the film at *factor towards 1, by steps of `step` at first. `saved` is a net of scratch. */
static taut_status come_nearer(taut_film_work *w, double *factor, double step, double *saved,
                               taut_error *inner)
{
    const size_t bytes = 3 * w->space->count * sizeof(double);

    inner->status = TAUT_OK;
    for (int k = 0; *factor != 1 && k < LOWERINGS && step > step_least; k++) {
        const double next = next_of(*factor, step);
        memcpy(saved, w->net, bytes);
        inner->status = taut_film_rest(w, next, inner);
        if (inner->status == TAUT_NOT_CONVERGED && k < ANEW) {
            inner->status = start_anew(w, next, inner); /* what is nearer may be lost from there */
        }
        if (inner->status == TAUT_OK) {
            *factor = next;
            continue;
        }
        if (inner->status != TAUT_NOT_CONVERGED) {
            break;
        }
        memcpy(w->net, saved, bytes);
        step *= 0.5;
    }
    if (*factor != 1 && inner->status == TAUT_OK) {
        return taut_fail(inner, TAUT_NOT_CONVERGED, "not-converged", "", *factor, 1,
                         "so many steps lead only to %.6g times the forces", *factor);
    }
    return inner->status;
}

/* From the film at `factor` to 1. */
static taut_status come_to(taut_film_work *w, double factor, double *saved, taut_error *error)
{
    taut_error inner = {.status = TAUT_OK}, below = {.status = TAUT_OK};
    taut_status status = come_nearer(w, &factor, 0.5, saved, &inner);
    int ends = is_end(w, &inner); /* now: attempts that follow say nothing of it */

    for (int k = 1; status == TAUT_NOT_CONVERGED && factor > 1 && k <= BELOW; k++) {
        const double next = fmax(1, factor * (1 - 0.05 * k));
        below.status = start_anew(w, next, &below);
        if (below.status == TAUT_OK) {
            factor = next;
            status = come_nearer(w, &factor, 0.25, saved, &inner);
            ends = is_end(w, &inner);
            k = 0;
        } else if (below.status != TAUT_NOT_CONVERGED) {
            return taut_film_pass_on(&below, error);
        }
    }
    if (status == TAUT_NOT_CONVERGED && factor > 1 && ends) {
        return refuse_weak(w, factor, error);
    }
    return status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&inner, error);
}

taut_status taut_film_lower_forces(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    double factor = 1;
    double *saved = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    taut_status status = saved != NULL ? find_strong(w, &factor, error) : taut_fail_memory(error);

    return status == TAUT_OK ? come_to(w, factor, saved, error) : status;
}
