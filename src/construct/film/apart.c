/* apart.c -- where the film of a ring is not found from its start.
 *
 *     share = 1/2, 1/4, ..: the start with its edges at so much of their distance, until one succeeds
 *     lead them apart, from film to film, by steps that are halved where one fails
 *     1 is reached: done; no step is left and the neck has shrunk: collapses or slides-away, the last share told
 */
#include "construct/film/apart.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { HALVINGS = 8, LEADS = 128 };

static const double lead_least = 0x1p-15; /* of the distance of a ring's edges */
static const double neck_most = 0.95;     /* of the shorter edge: it is half where films part */

/* The edges across which a ring is led: its second ones. */
static int far_edge(const taut_film_work *w)
{
    return w->space->problem->ring == TAUT_FILM_RING_U ? 3 : 1;
}

/* The mean of the points of an edge that goes around. */
static void find_middle(const taut_film_work *w, const double *net, int e, double middle[3])
{
    const int period = w->space->around->period;
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(w->space->nu, w->space->nv, e, &first, &step, &count);
    memset(middle, 0, 3 * sizeof(double));
    for (int k = 0; k < period; k++) {
        taut_add_scaled(1.0 / period, net + 3 * (first + (size_t)k * step), middle);
    }
}

/* Moves the second edge by `share` of the way between both at the start, and what is between them along with it. */
static void shift_edge(const taut_film_work *w, double share, double *net)
{
    const int along_u = w->space->problem->ring == TAUT_FILM_RING_U;
    const int across = along_u ? w->space->nv : w->space->nu;
    double from[3], way[3];

    find_middle(w, w->space->start, far_edge(w) - 1, from);
    find_middle(w, w->space->start, far_edge(w), way);
    taut_add_scaled(-1, from, way);
    for (size_t i = 0; i < w->space->count; i++) {
        const int at = along_u ? (int)i % w->space->nv : (int)i / w->space->nv;
        taut_add_scaled(share * at / (across - 1), way, net + 3 * i);
    }
}

/* The shortest closed line of a net's control polygons; *edge: of the shorter edge. */
static double shortest_line(const taut_film_work *w, const double *net, double *edge)
{
    const int along_u = w->space->problem->ring == TAUT_FILM_RING_U;
    const int across = along_u ? w->space->nv : w->space->nu, period = w->space->around->period;
    const size_t nv = (size_t)w->space->nv, line = along_u ? 1 : nv, step = along_u ? nv : 1;
    double shortest = INFINITY;

    *edge = INFINITY;
    for (int k = 0; k < across; k++) {
        double length = 0;
        for (int i = 0; i < period; i++) {
            const double *x = net + 3 * ((size_t)k * line + (size_t)i * step);
            length += taut_length_between(x, x + 3 * step);
        }
        shortest = fmin(shortest, length);
        *edge = k == 0 || k == across - 1 ? fmin(*edge, length) : *edge;
    }
    return shortest;
}

/* The neck of the net over the shorter edge that it began with. */
static double find_neck(const taut_film_work *w)
{
    double edge = 0, now = 0;
    (void)shortest_line(w, w->space->start, &edge);
    return shortest_line(w, w->net, &now) / edge;
}

/* Did the film come near to parting? Else it is the net that folds. */
static int may_part(const taut_film_work *w)
{
    return find_neck(w) < neck_most;
}

static taut_status refuse_far(const taut_film_work *w, double share, taut_error *error)
{
    const int e = far_edge(w), slides = w->space->problem->edges[e].kind == TAUT_FILM_SLIDE ||
                                        w->space->problem->edges[e - 1].kind == TAUT_FILM_SLIDE;
    char where[32];

    snprintf(where, sizeof where, "/edges/%s", taut_film_edge_names[e]);
    return taut_fail(
        error, TAUT_NO_SOLUTION, slides ? "slides-away" : "collapses", where, 1, share,
        "no film connects the edges: as they are moved apart, a film is found up to "
        "%.6g of their distance, where its neck is %.3g of the shorter edge at the start%s",
        share, find_neck(w),
        slides ? "; it slides off, bring the plane nearer" : "; bring them together");
}

/* net: a film with the edges at *share of their distance, from the start. */
static taut_status find_near(taut_film_work *w, double *share, taut_error *error)
{
    taut_error inner = {.status = TAUT_NOT_CONVERGED};

    *share = 1;
    for (int k = 0; inner.status == TAUT_NOT_CONVERGED && k < HALVINGS; k++) {
        *share *= 0.5;
        memcpy(w->net, w->space->start, 3 * w->space->count * sizeof(double));
        shift_edge(w, *share - 1, w->net);
        inner.status = taut_film_rest(w, 1, &inner);
    }
    if (inner.status == TAUT_NOT_CONVERGED && may_part(w)) {
        return refuse_far(w, *share, error);
    }
    return inner.status == TAUT_OK ? TAUT_OK : taut_film_pass_on(&inner, error);
}

taut_status taut_film_lead_apart(taut_film_work *w, taut_arena *arena, taut_error *error)
{
    const size_t bytes = 3 * w->space->count * sizeof(double);
    double *saved = taut_arena_take(arena, w->space->count, 3 * sizeof(double));
    double share = 1, step = 0.5;
    taut_status status = saved != NULL ? find_near(w, &share, error) : taut_fail_memory(error);
    taut_error inner = {.status = TAUT_OK};

    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; share < 1 && k < LEADS && step > lead_least; k++) {
        const double next = fmin(1, share + step);
        memcpy(saved, w->net, bytes);
        shift_edge(w, next - share, w->net);
        inner.status = taut_film_rest(w, 1, &inner);
        if (inner.status == TAUT_OK) {
            share = next;
            continue;
        }
        memcpy(w->net, saved, bytes);
        if (inner.status != TAUT_NOT_CONVERGED) {
            return taut_film_pass_on(&inner, error);
        }
        step *= 0.5;
    }
    if (share < 1 && may_part(w)) {
        return refuse_far(w, share, error);
    }
    return share < 1 ? taut_film_pass_on(&inner, error) : TAUT_OK;
}
