/* coarse.c -- the way from the start, in spaces whose spans are twice as long.
 *
 *     the same problem on every second knot, begun in the same way itself
 *     a few Newton steps there
 *     its net with the other knots is the same surface, and the start
 */
#include "construct/film/coarse.h"

#include "construct/plateau/newton_step.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { NODES = 1 /* beyond the functions alive on a span */, SPANS = 2, STEPS = 5, STEPS_MORE = 3 };
static const double middle = 1e-9; /* of a span: how near to its middle a knot is that halves it */

/* Is inner knot k one of the coarser basis: every second one from either end. */
static int stays(int k, int spans)
{
    return (k < spans - k ? k : spans - k) % 2 == 0;
}

/* Do the knots that go halve the spans of those that stay? */
static int is_halved(const taut_basis *basis)
{
    const double *t = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    int halved = spans % 2 == 0;

    for (int k = 1; halved && k < spans; k += 2) {
        const double span = t[k + 1] - t[k - 1];
        halved = fabs(t[k] - t[k - 1] - 0.5 * span) <= middle * span;
    }
    return halved;
}

/* The basis with every second inner knot, all of which are simple; NULL: there is none. */
static taut_status coarsen(const taut_basis *basis, taut_arena *arena, taut_basis **coarse)
{
    const int p = taut_basis_degree(basis), spans = taut_basis_span_count(basis);
    const double *t = taut_basis_breaks(basis);
    taut_basis_spec spec;
    int count = 0;

    *coarse = NULL;
    if (taut_basis_count(basis) != p + spans || spans < 2 * SPANS) {
        return TAUT_OK;
    }
    double *knots = taut_arena_take(arena, 2 * (size_t)p + (size_t)spans + 1, sizeof(double));
    if (knots == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k <= spans; k++) {
        const int is_end = k == 0 || k == spans;
        for (int times = is_end ? p + 1 : stays(k, spans); times > 0; times--) {
            knots[count++] = t[k];
        }
    }
    taut_basis_spec_of(basis, &spec);
    spec.count = 0;
    spec.knots = knots;
    spec.knot_count = count;
    const taut_status status = taut_basis_new(&spec, count - p - 1, coarse, NULL);
    return status == TAUT_NO_MEMORY ? status : TAUT_OK;
}

/* Does a film of this kind begin from chords, in no other way? */
static int begins_plainly(const taut_film_work *w)
{
    const taut_film_space *space = w->space;
    const taut_film_problem *problem = space->problem;

    return space->around == NULL && space->leader == NULL && !space->has_inside &&
           !problem->accepts_stationary && !taut_film_has_density(problem) &&
           memcmp(w->net, space->start, 3 * space->count * sizeof(double)) == 0;
}

/* Steps in the space of cw; *better: the net has come nearer. */
static taut_status step(taut_film_work *cw, double factor, int *better)
{
    const int steps = cw->region.theta > 0 ? STEPS_MORE : STEPS;
    taut_newton_step *newton = NULL;
    taut_error inner = {.status = TAUT_OK};
    taut_status status = taut_film_take_nodes(cw, NODES, factor);

    if (status == TAUT_OK) {
        status = taut_newton_step_new(cw->functional, &cw->form, &cw->space->mask, NULL, 1,
                                      cw->monitor, &newton);
    }
    if (status != TAUT_OK) {
        return status == TAUT_NOT_CONVERGED ? TAUT_OK : status;
    }
    const int most = cw->begun + steps, given = cw->region.max_iterations;
    cw->region.iterations = cw->begun;
    cw->region.max_iterations = most < given ? most : given;
    status = taut_trust_region_minimise(cw->functional, newton, &cw->region, cw->net, &inner);
    taut_newton_step_free(newton);
    *better = status == TAUT_OK ||
              (status == TAUT_NOT_CONVERGED && strcmp(inner.reason, "iterations") == 0);
    return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_OK;
}

/* *surface gets the knots of `fine` that are not there yet. */
static taut_status refine_to(taut_surface **surface, int along, const taut_basis *fine)
{
    const int spans = taut_basis_span_count(fine), is_whole = is_halved(fine);
    const double *t = taut_basis_breaks(fine);
    taut_status status = TAUT_OK;

    for (int k = 1; status == TAUT_OK && k < (is_whole ? 2 : spans); k++) {
        taut_surface *next = NULL;
        if (is_whole) {
            status = taut_surface_refine(*surface, along, &next, NULL);
        } else if (!stays(k, spans)) {
            status = taut_surface_insert(*surface, along, t[k], 1, &next, NULL);
        }
        if (next != NULL) {
            taut_surface_free(*surface);
            *surface = next;
        }
    }
    return status;
}

/* The net of cw, with the knots of that of w, becomes that of w where it is not held. */
static taut_status hand_over(const taut_film_work *cw, taut_film_work *w, taut_arena *arena)
{
    const taut_film_space *from = cw->space, *to = w->space;
    taut_surface *surface = NULL;
    double *points = taut_arena_take(arena, from->count, 3 * sizeof(double));
    double *scaled = taut_arena_take(arena, to->count, 3 * sizeof(double));
    taut_status status = scaled != NULL && points != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        status = taut_scaling_undo(&from->scaling, from->count, from->points, from->known, cw->net,
                                   points, NULL);
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(NULL, from->problem->u, from->problem->v, points, NULL, &surface,
                                  NULL);
    }
    if (status == TAUT_OK) {
        status = refine_to(&surface, TAUT_ALONG_U, to->problem->u);
    }
    if (status == TAUT_OK) {
        status = refine_to(&surface, TAUT_ALONG_V, to->problem->v);
    }
    if (status == TAUT_OK && taut_basis_count(taut_surface_u(surface)) == to->nu &&
        taut_basis_count(taut_surface_v(surface)) == to->nv) {
        taut_scaling_apply(&to->scaling, to->count, taut_surface_points(surface), NULL, scaled);
        for (size_t i = 0; i < to->count; i++) {
            if (!to->known[i]) {
                memcpy(w->net + 3 * i, scaled + 3 * i, 3 * sizeof(double));
            }
        }
        w->region.theta = cw->region.theta_next;
        w->begun = cw->region.iterations;
        w->region.work = cw->region.work;
    }
    taut_surface_free(surface);
    return status == TAUT_NO_MEMORY ? status : TAUT_OK;
}

/* The film in the coarser space, and what it leaves. */
static taut_status begin_in(const taut_film_problem *coarse, double factor, taut_film_work *w,
                            taut_arena *arena)
{
    taut_film_space space;
    taut_film_work cw = {
        .space = &space, .monitor = w->monitor, .threads = w->threads, .region = w->region};
    int better = 0;
    taut_status status = taut_film_space_new(coarse, arena, &space, NULL);

    if (status == TAUT_OK) {
        cw.net = taut_arena_copy(arena, space.start, space.count, 3 * sizeof(double));
        status = cw.net != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        status = taut_dirichlet_form_new(coarse->u, coarse->v, NULL, &cw.form, NULL);
    }
    if (status == TAUT_OK) {
        taut_film_start_laws(&cw, factor);
        status = taut_film_begin_coarse(&cw, factor);
    }
    if (status == TAUT_OK) {
        status = step(&cw, factor, &better);
    }
    if (status == TAUT_OK && better) {
        status = hand_over(&cw, w, arena);
    }
    taut_dirichlet_form_clear(&cw.form);
    taut_film_drop_rule(&cw);
    return status == TAUT_NO_MEMORY || status == TAUT_INTERRUPTED ? status : TAUT_OK;
}

taut_status taut_film_begin_coarse(taut_film_work *w, double factor)
{
    taut_film_problem coarse = *w->space->problem;
    taut_basis *u = NULL, *v = NULL;

    if (!begins_plainly(w)) {
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    taut_status status = taut_arena_status(arena);
    if (status == TAUT_OK) {
        status = coarsen(coarse.u, arena, &u);
    }
    if (status == TAUT_OK && u != NULL) {
        status = coarsen(coarse.v, arena, &v);
    }
    if (status == TAUT_OK && v != NULL) {
        coarse.method = TAUT_FILM_FULL;
        coarse.u = u;
        coarse.v = v;
        status = begin_in(&coarse, factor, w, arena);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    taut_arena_free(arena);
    return status;
}
