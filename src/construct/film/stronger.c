/* stronger.c -- where a film with the forces that are asked for is not found.
 *
 *     factor = the rungs of a ladder above 1, then two below: the start solved with all forces so many times, until one
 *     succeeds
 *     it is led towards 1, from film to film, or from the start anew, by steps that are halved where both fail
 *     1 is reached: done; no step is left: the start anew with 0.95, 0.9, .. of the last factor, and on from there
 *     at last, from the rungs below; else cable-too-weak, the last factor told
 *
 * The rungs are the same whatever multiple of its forces a document gives, and steps down from one of them do not depend on
 * where 1 lies: so a sail whose forces are those that were told, or more, comes the same way down. A film that a tenth more
 * force loses again was a lucky start, and is not told of.
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

enum { RUNGS = 33 /* to 256 times */, BELOW_ONE = 2, LOWERINGS = 64, ANEW = 6, BELOW = 4 };

static const double rungs[4] = {0.5, 0.59460355750136051, 0.70710678118654757, 0.84089641525371461};
static const double step_least = 0x1p-10; /* of the logarithm of the factor of all forces */
static const double above_told = 1.1;     /* a film is there, too, of all that is told */
static const double digits_told = 5e-6;   /* share: enough for a message of six digits */

static taut_status refuse_weak(const taut_film_work *w, double least, taut_error *error)
{
    const taut_film_space *space = w->space;
    const taut_film_problem *problem = space->problem;
    const int unit = space->scaling.outer + space->scaling.inner;
    char where[32], strong[96], note[200] = "";
    const int is_crossed = taut_film_order_note(problem, note, sizeof note);
    int e = w->edges[0];

    least *= 1 + digits_told;
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
        snprintf(strong, sizeof strong, "%.9g unstressed for edge %s", limit, name);
    } else if (edge->law == TAUT_FILM_FORCE) {
        snprintf(strong, sizeof strong, "%.6g for edge %s", limit, name);
    } else {
        found = ldexp(space->cables[e].length, unit);
        limit = ldexp(taut_film_strong_length(space, e, least), unit);
        snprintf(strong, sizeof strong, "a length of %.9g for edge %s", limit, name);
    }
    snprintf(where, sizeof where, "/edges/%s/cable", name);
    return taut_fail(
        error, TAUT_NO_SOLUTION, "cable-too-weak", where, found, limit,
        "the cables are too weak for this film of tension %g: lowered together from stronger "
        "ones, the last film is found at %.6g times their forces (%s); "
        "below that it draws a cable into another edge, folds, or gets thinner at a "
        "corner than its knots can resolve%s%s",
        taut_film_tension(problem), least, strong, is_crossed ? "; " : "", note);
}

/* net: the film with all forces so many times that the start leads to. */
static taut_status start_anew(taut_film_work *w, double factor, taut_error *error)
{
    memcpy(w->net, w->space->start, 3 * w->space->count * sizeof(double));
    const taut_status begun = taut_film_begin_coarse(w, factor);
    return begun == TAUT_OK ? taut_film_rest(w, factor, error) : taut_fail_status(error, begun);
}

/* How strong the weakest cable is by itself: so many times the forces are so many times that. */
static double strength_of(const taut_film_space *space)
{
    double least = INFINITY;

    for (int e = 0; e < 4; e++) {
        if (space->ratios[e] > 0) {
            const double chord = taut_film_chord(space, e);
            const double length = space->cables[e].length;
            least = fmin(least, length > 0 ? sqrt(chord / (24 * fmax(length - chord, 0)))
                                           : space->ratios[e] / chord);
        }
    }
    return least > 0 && least < INFINITY ? least : 1;
}

/* Rung k of the ladder, over the forces; rung 0 is the first at 1 or above. */
static double rung_of(const taut_film_space *space, int k)
{
    const double strength = strength_of(space);
    int power = 0, first = 0;
    const double share = frexp(strength, &power);

    for (; first < 4 && rungs[first] < share; first++) {
    }
    const int at = first + k + 4 * RUNGS;
    return ldexp(rungs[at % 4] / strength, at / 4 - RUNGS + power);
}

/* net: a film with all forces *factor times, from the start, by so many rungs from one on. */
static taut_status find_strong(taut_film_work *w, int from, int count, int step, double *factor,
                               taut_error *error)
{
    taut_error first = {.status = TAUT_OK}, inner = {.status = TAUT_NOT_CONVERGED};

    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < count; k++) {
        *factor = rung_of(w->space, from + k * step);
        inner.status = start_anew(w, *factor, &inner);
        first = k == 0 ? inner : first;
    }
    return inner.status == TAUT_NOT_CONVERGED ? taut_film_pass_on(&first, error)
           : inner.status == TAUT_OK          ? TAUT_OK
                                              : taut_film_pass_on(&inner, error);
}

static taut_status find_above(taut_film_work *w, double *factor, taut_error *error)
{
    return find_strong(w, 0, RUNGS, 1, factor, error);
}

static taut_status find_below(taut_film_work *w, double *factor, taut_error *error)
{
    return find_strong(w, -1, BELOW_ONE, -1, factor, error);
}

/* Is that the end of films that get weaker: a fold, or one that is at rest by every rule, and another by each? */
static int is_end(const taut_film_work *w, const taut_error *inner)
{
    return strcmp(inner->reason, "folds") == 0 || (strcmp(inner->reason, "not-converged") == 0 &&
                                                   w->region.residual <= w->region.tolerance);
}

/* The next factor on the way to 1, which steps down may pass. */
static double next_of(double factor, double step)
{
    return factor > 1 ? factor * (1 - step) : fmin(1, factor / (1 - step));
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
        if (*factor > 1 && next < 1) {
            inner->status = taut_film_rest(w, 1, inner);
            if (inner->status != TAUT_NOT_CONVERGED) {
                *factor = inner->status == TAUT_OK ? 1 : *factor;
                break;
            }
            memcpy(w->net, saved, bytes);
        }
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

/* The way ends at the film of w->net, another one afterwards: *holds where there is one with a tenth more force. */
static taut_status try_above(taut_film_work *w, double factor, int *holds, taut_error *above)
{
    above->status = taut_film_rest(w, above_told * factor, above);
    if (above->status == TAUT_NOT_CONVERGED) {
        above->status = start_anew(w, above_told * factor, above);
    }
    *holds = above->status == TAUT_OK;
    return above->status == TAUT_NOT_CONVERGED ? TAUT_OK : above->status;
}

/* come_nearer; *ends: it ends above 1, for all that can be known, since the cables are too weak. */
static taut_status follow(taut_film_work *w, double *factor, double step, double *saved, int *ends,
                          taut_error *inner)
{
    taut_error above = {.status = TAUT_OK};
    const taut_status status = come_nearer(w, factor, step, saved, inner);

    *ends = status == TAUT_NOT_CONVERGED && *factor > 1 && is_end(w, inner);
    if (*ends && try_above(w, *factor, ends, &above) != TAUT_OK) {
        *inner = above;
        return above.status;
    }
    return status;
}

/* From the film at *factor to 1. */
static taut_status come_to(taut_film_work *w, double *factor, double *saved, int *ends,
                           taut_error *inner)
{
    taut_error below = {.status = TAUT_OK};
    taut_status status = follow(w, factor, 0.5, saved, ends, inner);

    for (int k = 1; status == TAUT_NOT_CONVERGED && *factor > 1 && k <= BELOW; k++) {
        const double next = *factor * (1 - 0.05 * k);
        below.status = start_anew(w, next, &below);
        if (below.status == TAUT_OK) {
            *factor = next;
            status = follow(w, factor, 0.25, saved, ends, inner);
            k = 0;
        } else if (below.status != TAUT_NOT_CONVERGED) {
            *inner = below;
            status = below.status;
        }
    }
    return status;
}

taut_status taut_film_lower_forces(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    double factor = 1, least = 1;
    int ends = 0, other = 0;
    taut_error first = {.status = TAUT_OK}, second = {.status = TAUT_OK};
    double *saved = taut_arena_take(arena, w->space->count, 3 * sizeof(double));

    if (saved == NULL) {
        return taut_fail_memory(error);
    }
    first.status = find_above(w, &least, &first);
    if (first.status == TAUT_OK) {
        first.status = come_to(w, &least, saved, &ends, &first);
    }
    if (first.status != TAUT_NOT_CONVERGED) {
        return first.status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&first, error);
    }
    second.status = find_below(w, &factor, &second);
    if (second.status == TAUT_OK) {
        second.status = come_to(w, &factor, saved, &other, &second);
    }
    if (second.status != TAUT_NOT_CONVERGED) {
        return second.status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&second, error);
    }
    return ends ? refuse_weak(w, least, error) : taut_film_pass_on(&first, error);
}
