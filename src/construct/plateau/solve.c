/* solve.c -- the surface of least area in one spline space.
 *
 *     1. the Dirichlet surface of the same net (taut_dirichlet_make): the data are checked there
 *     2. move and scale the points to about unit size (construct/common/scaling.h)
 *     3. Gauss nodes enough that more of them do not change the area (construct/plateau/area.h)
 *     4. descend from the Dirichlet surface, or the one given (construct/plateau/trust_region.h)
 *     5. with more nodes: still at rest? Otherwise go on with those
 *     6. put the solution back between the known points, which stay bit for bit
 *
 * [WuWang2011] sections 6, 7.1, 7.2; docs/plateau.md.
 */
#include "construct/plateau/solve.h"

#include "construct/common/scaling.h"
#include "construct/plateau/approach.h"
#include "construct/plateau/directions.h"
#include "construct/plateau/hessian_band.h"
#include "construct/plateau/work.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ITERATIONS_DEFAULT = 500, RULES = 10 };
static const double tolerance_default = 1e-10;
/* Nodes on a panel beyond the functions alive there, each rule tried after the one before. */
static const int extras[RULES] = {2, 4, 6, 9, 13, 19, 28, 42, 63, 95};
/* Two rules agree when their areas do to this; where the last ones differ by more than `unsettled`
 * the film is none. */
static const double agreement = 2e-14;
/* Rules that draw near a smooth integral change it by much less each time; not so where it is
 * rough.
 */
static const double rough = 0.2, rough_points = 5e3;
static const double unsettled = 1e-9;
static const double points_max = 3e7; /* Gauss points of one film, but for what its net needs: */
static const double points_most = 6e7, points_each = 4e3; /* in all, or for each of its points */
/* Residuals that agree to this, by rules of so many points that more cost little. */
static const double sharp = 4e-15, sharp_points = 2e4;

/* What a film may cost, in flops: seconds of work, or so many of the first steps if that is more,
 * as if no span were cut for the sake of weights. */
static const double work_least = 2e10, steps_worth = 200;

typedef taut_plateau_work work;

static void work_clear(work *w)
{
    taut_dirichlet_form_clear(&w->form);
    taut_film_free(w->film);
    taut_model_free(w->first);
    taut_arena_free(w->arena);
}

static taut_status work_new(work *w, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);

    w->surface = taut_model_surface(w->first, 0);
    w->count = (size_t)nu * (size_t)nv;
    w->arena = taut_arena_new();
    if (w->arena != NULL) {
        w->net = taut_arena_take(w->arena, 3 * w->count, sizeof(double));
        w->descent.areas = taut_arena_take(w->arena, TAUT_PLATEAU_AREAS_MAX, sizeof(double));
        w->descent.areas_max = TAUT_PLATEAU_AREAS_MAX;
    }
    if (w->net == NULL || w->descent.areas == NULL ||
        taut_mask_new(nu, nv, net->known, w->arena, &w->mask) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (w->problem->method == TAUT_PLATEAU_NORMAL) {
        w->directions = taut_arena_take(w->arena, 3 * w->count, sizeof(double));
        if (w->directions == NULL ||
            taut_plateau_directions(w->surface, w->directions) != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    return TAUT_OK;
}

/* net = points in the scaled frame. */
static void scale(const work *w, const double *points, double *net)
{
    for (size_t i = 0; i < w->count; i++) {
        taut_scaling_apply(&w->scaling, points + 3 * i, net + 3 * i);
    }
}

/* The points back: known ones as given. */
static taut_status unscale(const work *w, double *points, taut_error *error)
{
    for (size_t i = 0; i < w->count; i++) {
        if (w->problem->net.known[i]) {
            memcpy(points + 3 * i, w->problem->net.points + 3 * i, 3 * sizeof(double));
        } else {
            taut_scaling_undo(&w->scaling, w->net + 3 * i, points + 3 * i);
        }
    }
    for (size_t i = 0; i < 3 * w->count; i++) {
        if (!isfinite(points[i])) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/points", taut_none,
                             taut_none,
                             "a point of the solution is beyond the range of double precision: "
                             "scale the points down");
        }
    }
    return TAUT_OK;
}

static double points_of(const taut_film *film)
{
    return (double)film->u.count * film->v.count;
}

/* Gauss points of the film after this one: on the same panels, with the nodes of the next rule. */
static double points_after(const work *w, const taut_film *film, int rule)
{
    const int next = rule + 1 < RULES ? rule + 1 : rule;
    const double u = taut_basis_local(w->problem->net.u) + extras[next];
    const double v = taut_basis_local(w->problem->net.v) + extras[next];
    return points_of(film) * u * v / (film->u.nodes * film->v.nodes);
}

static double points_allowed(const work *w)
{
    return fmax(points_most, points_each * (double)w->count);
}

/* The film with this rule; *is_last when a finer one would be too large. */
static taut_status film_with(work *w, int rule, taut_film **film, int *is_last, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    taut_film *made = NULL;
    double points = 0;

    if (taut_film_new(net->u, net->v, net->weights, extras[rule], &made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    points = points_of(made);
    *is_last = rule + 1 >= RULES || points_after(w, made, rule) > points_max;
    if (points > points_allowed(w)) {
        taut_film_free(made);
        return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", "/points", points,
                         points_allowed(w),
                         "the area asks for %.3g Gauss points, expected at most %.3g: the bases or "
                         "weights vary too fast for so small a net",
                         points, points_allowed(w));
    }
    *film = made;
    return TAUT_OK;
}

/* Raises the rule until the next one gives the same area of the net; the film is the coarser of
 * the two. *area is what the finer one gives. Before the first descent the rule is not raised on
 * and on for a net with points that have no tangent plane: no rule settles there, and the film may
 * come without them. */
static taut_status find_rule(work *w, const double *net, double *area, taut_error *error)
{
    const int is_first = w->descent.work_max == 0;
    double change = INFINITY;
    int is_last = w->film != NULL && points_after(w, w->film, w->rule) > points_allowed(w);
    taut_status status = TAUT_OK;

    if (w->film == NULL) {
        status = film_with(w, w->rule, &w->film, &is_last, error);
    }
    for (int settled = 0; status == TAUT_OK && !settled && !w->is_rough;) {
        const double before = taut_film_area(w->film, net).area;
        taut_film *finer = NULL;
        *area = before;
        if (w->rule + 1 >= RULES || is_last) {
            break;
        }
        status = film_with(w, w->rule + 1, &finer, &is_last, error);
        if (status == TAUT_OK) {
            const double earlier = change;
            *area = taut_film_area(finer, net).area;
            change = fabs(*area - before);
            settled = change <= agreement * *area;
            w->is_rough = !settled && is_first && change > rough * earlier &&
                          points_of(w->film) > rough_points;
        }
        if (status == TAUT_OK) {
            w->change = change / *area;
        }
        if (status == TAUT_OK && !settled && !w->is_rough) {
            taut_film_free(w->film);
            w->film = finer;
            w->rule++;
        } else {
            taut_film_free(finer);
        }
    }
    return status;
}

/* The stretch of u over that of v: fu / fv of the preconditioner. */
static double stretch(const work *w)
{
    double halves[2] = {0, 0};
    taut_dirichlet_form_energies(&w->form, w->net, halves);
    const double ratio = sqrt(halves[1] / halves[0]) / w->form.ratio;
    return ratio > 1e-4 && ratio < 1e4 ? ratio : 1;
}

static int has_free_edge(const taut_mask *p)
{
    const size_t nv = (size_t)p->nv, last = (size_t)(p->nu - 1) * nv;
    int found = 0;
    for (size_t j = 0; j < nv; j++) {
        found |= !p->known[j] || !p->known[last + j];
    }
    for (size_t i = 0; i < (size_t)p->nu; i++) {
        found |= !p->known[i * nv] || !p->known[i * nv + nv - 1];
    }
    return found;
}

/* Is it worth while to come near along normals first (construct/plateau/approach.h)? */
static int is_large(const work *w)
{
    return w->directions == NULL && w->problem->start == NULL && !w->descent.has_free_edge &&
           !w->is_rough && !taut_film_band_pays(w->film, &w->mask);
}

/* Spans over panels. Weights that vary from point to point cut the spans into thousands, and 200
 * steps there take hours. */
static double uncut(const work *w)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const double spans =
        (double)taut_basis_span_count(net->u) * (double)taut_basis_span_count(net->v);
    return spans * w->film->u.nodes * w->film->v.nodes / points_of(w->film);
}

/* Descends with the film of the moment. */
static taut_status descend(work *w, taut_error *error)
{
    taut_film_solver *solver = NULL;
    taut_status status = taut_film_solver_new(w->film, &w->form, &w->mask, w->directions, w->aspect,
                                              &w->options->monitor, &solver);

    if (status == TAUT_OK) {
        w->solver = taut_film_solver_name(solver);
        if (w->descent.work_max == 0) {
            w->descent.work_max =
                fmax(work_least, steps_worth * uncut(w) * taut_film_solver_step_cost(solver));
        }
        status = taut_film_descend(w->film, solver, &w->descent, w->net, error);
        w->products += taut_film_solver_products(solver);
    } else {
        status =
            status == TAUT_NO_MEMORY
                ? taut_fail_memory(error)
                : taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, taut_none, taut_none,
                            "the system is too ill-conditioned for double precision: the "
                            "knots, the degree or the weights are too extreme");
    }
    taut_film_solver_free(solver);
    return status;
}

/* The area of the Dirichlet surface, in the scaled frame, and a rule for it. */
static taut_status measure_first(work *w, taut_error *error)
{
    double halves[2] = {0, 0};
    taut_status status = TAUT_OK;

    scale(w, taut_surface_points(w->surface), w->net);
    status = find_rule(w, w->net, &w->dirichlet_area, error);
    taut_dirichlet_form_energies(&w->form, w->net, halves);
    if (status == TAUT_OK && !(w->dirichlet_area > 1e-12 * sqrt(halves[0] * halves[1]))) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/points", w->dirichlet_area,
                         taut_none,
                         "the known points span no area: every surface through them that has none "
                         "is a minimum; give a boundary that is not a point or a line");
    }
    w->aspect = stretch(w);
    return status;
}

/* Largest derivative along an unknown over the largest in the net, by this film. */
static taut_status residual_by(const work *w, taut_film *film, double *residual)
{
    double *gradient = taut_alloc_aligned(w->count, 3 * sizeof(double));
    double all = 0, unknown = 0;

    if (gradient == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_film_gradient(film, w->net, gradient);
    for (size_t i = 0; i < w->count; i++) {
        const double *g = gradient + 3 * i;
        const double size = fmax(fabs(g[0]), fmax(fabs(g[1]), fabs(g[2])));
        all = fmax(all, size);
        if (!w->mask.known[i]) {
            unknown = fmax(unknown,
                           w->directions == NULL ? size : fabs(taut_dot(w->directions + 3 * i, g)));
        }
    }
    *residual = all > 0 ? unknown / all : 0;
    taut_free(gradient);
    return TAUT_OK;
}

/* Rules that agree on the area to 2e-14 agree on its derivatives to fewer digits: where it costs
 * little, goes on to rules that do not see the residual change either. */
static taut_status sharpen(work *w, taut_error *error)
{
    taut_status status = TAUT_OK;

    for (int settled = 0; status == TAUT_OK && !settled;) {
        const double points = points_of(w->film);
        taut_film *finer = NULL;
        double residual = 0;
        int is_last = 0;
        if (w->rule + 1 >= RULES || points > sharp_points) {
            break;
        }
        status = film_with(w, w->rule + 1, &finer, &is_last, error);
        if (status == TAUT_OK && residual_by(w, finer, &residual) != TAUT_OK) {
            status = taut_fail_memory(error);
        }
        settled = is_last ||
                  fabs(residual - w->descent.residual) <= fmax(sharp, 0.1 * w->descent.residual);
        if (status != TAUT_OK || settled) {
            taut_film_free(finer);
            break;
        }
        taut_film_free(w->film);
        w->film = finer;
        w->rule++;
        status = descend(w, error);
    }
    return status;
}

/* Descends, and again with more nodes where they turn out to matter. A film that came from a rough
 * net and finds no rest may find it with more of them, while that is not too much work. */
static taut_status descend_by_rules(work *w, taut_error *error)
{
    taut_status status = TAUT_OK;
    double area = 0;

    for (int rule = -1; status == TAUT_OK && rule != w->rule;) {
        const int was_rough = w->is_rough;
        rule = w->rule;
        w->is_rough = 0;
        status = descend(w, error);
        if (status == TAUT_OK) {
            status = find_rule(w, w->net, &area, error);
        } else if (status == TAUT_NOT_CONVERGED && was_rough && rule + 1 < RULES &&
                   w->descent.work < w->descent.work_max &&
                   w->descent.iterations < w->descent.max_iterations) {
            int is_last = 0;
            taut_film *finer = NULL;
            status = film_with(w, rule + 1, &finer, &is_last, error);
            if (status == TAUT_OK) {
                taut_film_free(w->film);
                w->film = finer;
                w->rule++;
                w->is_rough = !is_last;
            }
        }
    }
    return status;
}

/* A film at rest by one rule is none where more nodes see another area. */
static taut_status check_rule(const work *w, taut_error *error)
{
    if (!(w->change > unsettled)) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, w->change, unsettled,
                     "the film folds: with %d Gauss nodes in a panel its area still changes by "
                     "%.2g of it; take fewer points, or give points inside",
                     w->film->v.nodes, w->change);
}

/* Fills points double[nu][nv][3]. */
static taut_status solve(work *w, double *points, taut_error *error)
{
    taut_status status = TAUT_OK;
    double area = 0;

    w->scaling = taut_scaling_of(w->count, w->problem->net.points, w->problem->net.known);
    status = taut_dirichlet_form_new(w->problem->net.u, w->problem->net.v, w->problem->net.weights,
                                     &w->form, error);
    if (status == TAUT_OK) {
        status = measure_first(w, error);
    }
    if (status == TAUT_OK && w->problem->start != NULL) {
        scale(w, w->problem->start, w->net);
        status = find_rule(w, w->net, &area, error);
    }
    w->descent.has_free_edge = has_free_edge(&w->mask);
    if (status == TAUT_OK && is_large(w)) {
        w->descent.work_max = work_least;
        status =
            taut_plateau_approach(w->film, &w->form, &w->mask, w->surface, w->aspect,
                                  &w->options->monitor, &w->descent, w->net, &w->products, error);
        w->descent.work_max = 0;
    }
    if (status == TAUT_OK) {
        status = descend_by_rules(w, error);
    }
    if (status == TAUT_OK && w->directions == NULL) { /* "normal" stops at the tolerance */
        status = sharpen(w, error);
    }
    if (status == TAUT_OK) {
        status = check_rule(w, error);
    }
    if (status == TAUT_OK || status == TAUT_NOT_CONVERGED) {
        const taut_status unscaled = unscale(w, points, error);
        status = unscaled != TAUT_OK ? unscaled : status;
    }
    return status;
}

/* Without unknowns the surface is the one given; its area is still told. */
static taut_status keep(work *w, double *points, taut_error *error)
{
    taut_status status = TAUT_OK;

    memcpy(points, w->problem->net.points, 3 * w->count * sizeof(double));
    w->solver = "none";
    w->scaling = taut_scaling_of(w->count, points, w->problem->net.known);
    scale(w, points, w->net);
    status = find_rule(w, w->net, &w->dirichlet_area, error);
    return status;
}

static taut_status finish(const work *w, const double *points, taut_plateau_solution *solution,
                          taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const char *name = net->name != NULL ? net->name : "plateau";
    taut_plateau_solution made = {NULL, NULL, 0};
    taut_status status =
        taut_surface_new(name, net->u, net->v, points, net->weights, &made.surface, error);

    if (status != TAUT_OK) {
        return status;
    }
    made.area = taut_scaling_undo_square(&w->scaling, w->mask.unknowns == 0 ? w->dirichlet_area
                                                                            : w->descent.area);
    made.details = taut_plateau_details(w);
    if (taut_record_status(made.details) != TAUT_OK) {
        taut_plateau_solution_clear(&made);
        return taut_fail_memory(error);
    }
    *solution = made;
    return TAUT_OK;
}

void taut_plateau_solution_clear(taut_plateau_solution *solution)
{
    taut_surface_free(solution->surface);
    taut_record_free(solution->details);
    memset(solution, 0, sizeof *solution);
}

taut_status taut_plateau_solve(const taut_plateau_problem *problem,
                               const taut_make_options *options, taut_plateau_solution *solution,
                               taut_error *error)
{
    work w;
    double *points = NULL;
    taut_status status = TAUT_OK;

    memset(&w, 0, sizeof w);
    w.problem = problem;
    w.options = options;
    w.descent.tolerance = problem->tolerance > 0 ? problem->tolerance : tolerance_default;
    w.descent.max_iterations =
        problem->max_iterations > 0 ? problem->max_iterations : ITERATIONS_DEFAULT;
    status = taut_dirichlet_make(&problem->net, w.options, &w.first, error);
    if (status == TAUT_OK) {
        status = work_new(&w, error);
    }
    if (status == TAUT_OK) {
        points = taut_arena_take(w.arena, 3 * w.count, sizeof(double));
        status = points == NULL         ? taut_fail_memory(error)
                 : w.mask.unknowns == 0 ? keep(&w, points, error)
                                        : solve(&w, points, error);
    }
    if (status == TAUT_OK || (status == TAUT_NOT_CONVERGED && w.descent.area > 0)) {
        const taut_status finished = finish(&w, points, solution, error);
        status = finished != TAUT_OK ? finished : status;
    }
    work_clear(&w);
    return status;
}
