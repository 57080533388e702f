/* solve.c -- the surface of least area in one spline space.
 *
 *     x     = the Dirichlet surface of the same net (taut_dirichlet_make), which checks the data
 *     net   = its points, moved and scaled to about unit size (construct/common/scaling.h)
 *     rule  = the first number of Gauss nodes that the next one agrees with on the area of net
 *     hardly any area: no solution
 *     net   = the points to start from, if they are given, and a rule for them
 *     come near along normals (construct/plateau/approach.h), unless the net to start from is given, an edge is
 *         free, or points are passed through: then steps leave the surface there (construct/plateau/held.h)
 *     repeat
 *         minimise the area from net, by rule (construct/plateau/trust_region.h)
 *         rule = the first from here on that the next one agrees with on the area of net
 *     until the rule stays
 *     where it costs little, raise the rule and minimise until the residual stays too
 *     that leads nowhere from what is near along the normals: the same from the Dirichlet surface
 *     the rules still disagree on the area: the surface folds
 *     points = net in the user's units, between the known ones, which stay bit for bit
 *
 * [WuWang2011] sections 6, 7.1, 7.2; docs/plateau.md.
 */
#include "construct/plateau/solve.h"

#include "construct/common/scaling.h"
#include "construct/plateau/approach.h"
#include "construct/plateau/directions.h"
#include "construct/plateau/hessian_band.h"
#include "construct/plateau/newton_step.h"
#include "construct/plateau/trust_region.h"
#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/nurbs/spread.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    ITERATIONS_DEFAULT = 500,
    RULES = 10,
    AREAS_MAX = 64, /* areas of iterations that are told */
};
static const double tolerance_default = 1e-10;
/* Of the metric operator in every step in all coordinates: without it the net goes on sliding within the surface,
 * rougher and rougher, for gains far below what its space misses of the least area. */
static const double theta_smooth = 0x1p-15;
static const double rest_step =
    0.05; /* of the tolerance: a step in all coordinates that gains less is the last */
/* Nodes on a cell beyond the functions alive there, each rule tried after the one before. */
static const int extra_nodes[RULES] = {2, 4, 6, 9, 13, 19, 28, 42, 63, 95};

/* What decides. */
static const struct {
    double area_agreement; /* share of the area: two rules agree where they differ by no more */
    double area_unsettled; /* the same: where the last rules differ by more there is no surface */
    double change_rough;   /* of one change to the next: a smooth integral settles much faster */
    double points_rough;   /* Gauss points: only beyond them a rough net costs enough to matter */
    double points_next;    /* Gauss points: a finer rule is not tried where it had more */
    double points_most;    /* Gauss points that any net may have ... */
    double points_each;    /* ... or for each of its control points */
    double residual_sharp; /* residual: rules that agree to this see the same derivatives */
    double points_sharp;   /* Gauss points: beyond them residuals are not made to agree */
    double work_least;     /* flops: seconds, that any surface may cost ... */
    double work_steps;   /* ... or so many of the first steps, as if no span were cut for weights */
    double area_none;    /* of sqrt(iint |x_u|^2 iint |x_v|^2): no area at all, but rounding */
    double stretch_most; /* of the preconditioner either way: beyond it the net is no guide */
    double held_most;    /* numbers of steps that places to pass through answer with: 400 MB */
} limits = {
    .area_agreement = 2e-14,
    .area_unsettled = 1e-9,
    .change_rough = 0.2,
    .points_rough = 5e3,
    .points_next = 3e7,
    .points_most = 6e7,
    .points_each = 4e3,
    .residual_sharp = 4e-15,
    .points_sharp = 2e4,
    .work_least = 2e10,
    .work_steps = 200,
    .area_none = 1e-12,
    .stretch_most = 1e4,
    .held_most = 5e7,
};

/* What is being made. */
typedef struct work {
    const taut_plateau_problem *problem;
    const taut_make_options *options;
    taut_model *first; /* the Dirichlet surface */
    taut_model *free;  /* the same that passes through no points; NULL where that is `first` */
    const taut_surface *surface;
    taut_arena *arena;
    taut_mask mask;
    taut_scaling scaling;
    taut_dirichlet_form form;
    taut_area_functional *functional;
    size_t count;
    double *net;                /* scaled */
    double *points;             /* the same in the user's units, in the end */
    double *directions;         /* or NULL */
    taut_conditions conditions; /* points to pass through, */
    taut_held *held;            /* and the moves that leave them alone; NULL: none */
    double *first_net;          /* with them: that of the Dirichlet surface, scaled */
    double dirichlet_area, aspect;
    double first_area; /* of the net that the steps begin from; 0 before there is one */
    taut_trust_region region;
    const char *solver;
    taut_pulse pulse; /* of the functionals */
    int rule, products;
    int is_rough;  /* no rule settles on the first net */
    double change; /* of the area from one of the last rules to the next, over the area */
} work;

static void work_clear(work *w)
{
    taut_dirichlet_form_clear(&w->form);
    taut_area_functional_free(w->functional);
    taut_model_free(w->first);
    taut_model_free(w->free);
    taut_arena_free(w->arena);
}

/* What directions are normals of: normals of a surface that is pulled to a point meet above it. */
static const taut_surface *guide_of(const work *w)
{
    return w->free != NULL ? taut_model_surface(w->free, 0) : w->surface;
}

static taut_status make_free(work *w, taut_error *error)
{
    taut_dirichlet_problem net = w->problem->net;

    if (net.through_count == 0 || w->problem->method != TAUT_PLATEAU_NORMAL) {
        return TAUT_OK;
    }
    net.through_count = 0;
    return taut_dirichlet_make(&net, w->options, &w->free, error);
}

/* What holds the surface at the points it passes through. Every one has its parameters. */
static taut_status hold_points(work *w, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const double numbers = taut_held_numbers(net->through_count, w->count, w->directions != NULL);
    const double most = floor(limits.held_most * net->through_count / numbers);

    if (numbers > limits.held_most) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/through", net->through_count, most,
                         "%d points to pass through in a net of %zu points, expected at most %.0f",
                         net->through_count, w->count, most);
    }
    w->held = taut_arena_take(w->arena, 1, sizeof *w->held);
    w->first_net = taut_arena_take(w->arena, 3 * w->count, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK ||
        taut_conditions_new(net->u, net->v, net->weights, net->through, net->through_count,
                            w->arena, &w->conditions) != TAUT_OK ||
        taut_held_new(&w->conditions, &w->mask, w->directions, w->arena, w->held) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

/* What is needed beside the Dirichlet surface. */
static taut_status prepare(work *w, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);

    w->surface = taut_model_surface(w->first, 0);
    w->count = (size_t)nu * (size_t)nv;
    w->arena = taut_arena_new();
    w->net = taut_arena_take(w->arena, 3 * w->count, sizeof(double));
    w->points = taut_arena_take(w->arena, 3 * w->count, sizeof(double));
    w->region.areas = taut_arena_take(w->arena, AREAS_MAX, sizeof(double));
    w->region.areas_max = AREAS_MAX;
    if (taut_arena_status(w->arena) != TAUT_OK ||
        taut_mask_new(nu, nv, net->known, w->arena, &w->mask) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (w->problem->method == TAUT_PLATEAU_NORMAL) {
        w->directions = taut_arena_take(w->arena, 3 * w->count, sizeof(double));
        if (w->directions == NULL ||
            taut_plateau_directions(guide_of(w), w->directions) != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    return w->problem->net.through_count > 0 ? hold_points(w, error) : TAUT_OK;
}

/* The net moved as little as lets it pass through the points that the Dirichlet surface passes through. */
static void settle_net(work *w)
{
    const size_t size = 3 * w->count;

    if (w->held == NULL || w->directions != NULL) { /* along directions it does not drift */
        return;
    }
    for (size_t i = 0; i < size; i++) {
        w->net[i] -= w->first_net[i];
    }
    taut_held_project(w->held, w->net);
    for (size_t i = 0; i < size; i++) {
        w->net[i] += w->first_net[i];
    }
}

/* net = points, scaled. */
static void scale_points(work *w, const double *points)
{
    taut_scaling_apply(&w->scaling, w->count, points, NULL, w->net);
}

/* ---- rules of quadrature ---- */

static double points_of(const taut_area_functional *functional)
{
    return (double)functional->u.count * functional->v.count;
}

/* Gauss points of the rule after this one: on the same cells, with the nodes of the next rule. */
static double points_after(const work *w, const taut_area_functional *functional, int rule)
{
    const int next = rule + 1 < RULES ? rule + 1 : rule;
    const double u = taut_basis_local(w->problem->net.u) + extra_nodes[next];
    const double v = taut_basis_local(w->problem->net.v) + extra_nodes[next];
    return points_of(functional) * u * v / (functional->u.nodes * functional->v.nodes);
}

static double points_allowed(const work *w)
{
    return fmax(limits.points_most, limits.points_each * (double)w->count);
}

/* The functional with this rule; *is_last when a finer one would be too large. */
static taut_status make_functional(work *w, int rule, taut_area_functional **functional,
                                   int *is_last, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    taut_area_functional *made = NULL;
    double points = 0;

    if (taut_area_functional_new(net->u, net->v, net->weights, extra_nodes[rule], &made) !=
        TAUT_OK) {
        return taut_fail_memory(error);
    }
    made->pulse = &w->pulse;
    made->threads = w->options->threads;
    points = points_of(made);
    *is_last = rule + 1 >= RULES || points_after(w, made, rule) > limits.points_next;
    if (points > points_allowed(w)) {
        taut_area_functional_free(made);
        return taut_fail(error, TAUT_NOT_CONVERGED, "gauss-points", "/points", points,
                         points_allowed(w),
                         "the area asks for %.3g Gauss points, expected at most %.3g: the bases or "
                         "weights vary too fast for so small a net",
                         points, points_allowed(w));
    }
    *functional = made;
    return TAUT_OK;
}

/* The finer functional takes the place of the one there is. */
static void replace_functional(work *w, taut_area_functional *finer)
{
    taut_area_functional_free(w->functional);
    w->functional = finer;
    w->rule++;
}

/* Raises the rule until the next one gives the same area of the net; the functional is the coarser
 * of the two. *area is what the finer one gives. At first the rule is not raised on and on for a
 * net with points that have no tangent plane: no rule settles there, and the surface may come
 * without them. */
static taut_status find_rule(work *w, double *area, taut_error *error)
{
    const int is_first = w->region.work_max == 0;
    double change = INFINITY;
    int is_last =
        w->functional != NULL && points_after(w, w->functional, w->rule) > points_allowed(w);
    taut_status status = TAUT_OK;

    if (w->functional == NULL) {
        status = make_functional(w, w->rule, &w->functional, &is_last, error);
    }
    while (status == TAUT_OK && !w->is_rough) {
        const double before = taut_area_functional_value(w->functional, w->net).area;
        const double earlier = change;
        taut_area_functional *finer = NULL;
        *area = before;
        if (w->rule + 1 >= RULES || is_last) {
            return TAUT_OK;
        }
        status = make_functional(w, w->rule + 1, &finer, &is_last, error);
        if (status != TAUT_OK) {
            return status;
        }
        *area = taut_area_functional_value(finer, w->net).area;
        change = fabs(*area - before);
        w->change = change / *area;
        if (change <= limits.area_agreement * *area) {
            taut_area_functional_free(finer);
            return TAUT_OK;
        }
        w->is_rough = is_first && change > limits.change_rough * earlier &&
                      points_of(w->functional) > limits.points_rough;
        if (w->is_rough) {
            taut_area_functional_free(finer);
            return TAUT_OK;
        }
        replace_functional(w, finer);
    }
    return status;
}

/* The rule after this one, whatever it sees. */
static taut_status raise_rule(work *w, taut_error *error)
{
    taut_area_functional *finer = NULL;
    int is_last = 0;
    const taut_status status = make_functional(w, w->rule + 1, &finer, &is_last, error);

    if (status != TAUT_OK) {
        return status;
    }
    replace_functional(w, finer);
    w->is_rough = !is_last;
    return TAUT_OK;
}

/* ---- the minimum by one rule, and by all ---- */

/* The stretch of u over that of v: fu / fv of the preconditioner. */
static double stretch_of_net(const work *w)
{
    double halves[2] = {0, 0};
    taut_dirichlet_form_energies(&w->form, w->net, halves);
    const double ratio = sqrt(halves[1] / halves[0]) / w->form.ratio;
    return ratio > 1 / limits.stretch_most && ratio < limits.stretch_most ? ratio : 1;
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

/* May it come near along normals first (construct/plateau/approach.h)? */
static int has_approach(const work *w)
{
    return w->directions == NULL && w->problem->start == NULL && !w->region.has_free_edge &&
           w->held == NULL && !w->is_rough;
}

/* Spans over cells. Weights that vary from point to point cut the spans into thousands, and 200
 * steps there take hours. */
static double uncut_share(const work *w)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const double spans =
        (double)taut_basis_span_count(net->u) * (double)taut_basis_span_count(net->v);
    return spans * w->functional->u.nodes * w->functional->v.nodes / points_of(w->functional);
}

/* Minimises by the rule of the moment. */
static taut_status minimise(work *w, taut_error *error)
{
    taut_newton_step *newton = NULL;
    taut_status status = taut_newton_step_new(w->functional, &w->form, &w->mask, w->directions,
                                              w->aspect, &w->options->monitor, &newton);

    if (status == TAUT_OK && w->held != NULL) {
        status = taut_newton_step_hold(newton, &w->conditions, w->held);
    }
    if (status == TAUT_NO_MEMORY) {
        taut_newton_step_free(newton);
        return taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        taut_newton_step_free(newton);
        return taut_fail(error, TAUT_NOT_CONVERGED, "ill-conditioned", NULL, taut_none, taut_none,
                         "the system is too ill-conditioned for double precision: the "
                         "knots, the degree or the weights are too extreme");
    }
    w->solver = taut_newton_step_method(newton);
    if (w->region.work_max == 0) {
        w->region.work_max = fmax(limits.work_least, limits.work_steps * uncut_share(w) *
                                                         taut_newton_step_cost(newton));
    }
    status = taut_trust_region_minimise(w->functional, newton, &w->region, w->net, error);
    w->products += taut_newton_step_products(newton);
    taut_newton_step_free(newton);
    settle_net(w);
    return status;
}

/* The area of the Dirichlet surface, scaled, and a rule for it. */
static taut_status measure_first(work *w, taut_error *error)
{
    const double spread = taut_weight_spread(w->surface);
    double halves[2] = {0, 0};
    taut_status status = TAUT_OK;

    if (spread > TAUT_SPREAD_MAX) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "weights-vary", "/weights", spread,
                         TAUT_SPREAD_MAX,
                         "two weights of one span are a factor of %.3g apart, expected at most "
                         "%.3g: the surface turns in a layer thinner than any rule sees, and its "
                         "area is not known; bring the weights nearer to each other",
                         spread, TAUT_SPREAD_MAX);
    }
    scale_points(w, taut_surface_points(w->surface));
    if (w->held != NULL) {
        memcpy(w->first_net, w->net, 3 * w->count * sizeof(double));
    }
    status = find_rule(w, &w->dirichlet_area, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_dirichlet_form_energies(&w->form, w->net, halves);
    if (!(w->dirichlet_area > limits.area_none * sqrt(halves[0] * halves[1]))) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-area", "/points", w->dirichlet_area,
                         taut_none,
                         "the known points span no area: every surface through them that has none "
                         "is a minimum; give a boundary that is not a point or a line");
    }
    w->aspect = stretch_of_net(w);
    return TAUT_OK;
}

/* Largest derivative along an unknown over the largest in the net, by this functional. */
static taut_status find_residual(const work *w, taut_area_functional *functional, double *residual)
{
    double *gradient = taut_alloc_aligned(w->count, 3 * sizeof(double));
    double all = 0, unknown = 0;

    if (gradient == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_area_functional_gradient(functional, w->net, gradient);
    for (size_t i = 0; i < w->count; i++) {
        all = fmax(all, taut_largest_coordinate(gradient + 3 * i));
    }
    if (w->held != NULL) { /* "full": "normal" does not come here */
        taut_mask_clear_known(&w->mask, gradient);
        taut_held_project(w->held, gradient);
    }
    for (size_t i = 0; i < w->count; i++) {
        const double *g = gradient + 3 * i;
        const double size = taut_largest_coordinate(g);
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
static taut_status sharpen_residual(work *w, taut_error *error)
{
    while (w->rule + 1 < RULES && points_of(w->functional) <= limits.points_sharp) {
        taut_area_functional *finer = NULL;
        double residual = 0;
        int is_last = 0;
        taut_status status = make_functional(w, w->rule + 1, &finer, &is_last, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (find_residual(w, finer, &residual) != TAUT_OK) {
            taut_area_functional_free(finer);
            return taut_fail_memory(error);
        }
        if (is_last || fabs(residual - w->region.residual) <=
                           fmax(limits.residual_sharp, 0.1 * w->region.residual)) {
            taut_area_functional_free(finer);
            return TAUT_OK;
        }
        replace_functional(w, finer);
        status = minimise(w, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* Minimises, and again with more nodes where they turn out to matter. What came from a rough net
 * and did not converge may do so with more of them, while that is not too much work. */
static taut_status minimise_by_rules(work *w, taut_error *error)
{
    double area = 0;

    for (int rule = -1; rule != w->rule;) {
        const int was_rough = w->is_rough;
        taut_status status = TAUT_OK;
        rule = w->rule;
        w->is_rough = 0;
        status = minimise(w, error);
        if (status == TAUT_OK) {
            status = find_rule(w, &area, error);
        } else if (status == TAUT_NOT_CONVERGED && was_rough && rule + 1 < RULES &&
                   w->region.work < w->region.work_max &&
                   w->region.iterations < w->region.max_iterations) {
            status = raise_rule(w, error);
        }
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* At rest by one rule is not at rest where more nodes see another area. */
static taut_status check_rule(const work *w, taut_error *error)
{
    if (!(w->change > limits.area_unsettled)) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "folds", NULL, w->change, limits.area_unsettled,
                     "the film folds: with %d Gauss nodes in a panel its area still changes by "
                     "%.2g of it; take a higher degree, fewer points, or give points inside",
                     w->functional->v.nodes, w->change);
}

/* ---- the whole ---- */

/* Along normals, to where the whole net has little left to gain. What is left is within the surface: steps by
 * factors begin with as much of the metric as they keep, those by conjugate gradients, each dearer with less of it, as ever. */
static taut_status come_near(work *w, taut_error *error)
{
    const int before = w->region.iterations;

    w->region.work_max = limits.work_least;
    const taut_status status =
        taut_plateau_approach(w->functional, &w->form, &w->mask, w->surface, w->aspect,
                              &w->options->monitor, &w->region, w->net, &w->products, error);
    w->region.work_max = 0;
    if (status == TAUT_OK && w->region.iterations > before) {
        const int pays = taut_area_hessian_pays(w->functional, &w->mask);
        w->region.theta = pays ? theta_smooth : 0;
        w->region.is_minimum = !pays; /* else a look at the factors tells, and costs little */
        w->region.rest_from = taut_area_functional_value(w->functional, w->net).area;
    }
    return status;
}

/* From the net at hand to rest. */
static taut_status settle(work *w, taut_error *error)
{
    taut_status status = minimise_by_rules(w, error);

    if (status == TAUT_OK && w->directions == NULL) { /* "normal" stops at the tolerance */
        status = sharpen_residual(w, error);
    }
    return status == TAUT_OK ? check_rule(w, error) : status;
}

/* Are all steps made that are allowed, or all that their work allows? */
static int is_spent(const work *w)
{
    return w->region.iterations >= w->region.max_iterations || w->region.work >= w->region.work_max;
}

/* What lies near along the normals may fold as it goes on: from the Dirichlet surface in all coordinates, then. */
static void begin_anew(work *w)
{
    scale_points(w, taut_surface_points(w->surface));
    w->region.theta = 0;
    w->region.rest_from = 0;
    w->region.is_minimum = 0;
    w->region.areas_count = 0; /* those told are of the way to the film */
}

/* Fills net. */
static taut_status find_net(work *w, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    double area = 0;
    taut_status status = TAUT_OK;

    w->scaling = taut_scaling_of(w->count, net->points, net->known);
    status = taut_dirichlet_form_new(net->u, net->v, net->weights, &w->form, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = measure_first(w, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (w->problem->start != NULL) {
        scale_points(w, w->problem->start);
        settle_net(w);
        status = find_rule(w, &area, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    w->first_area = w->problem->start != NULL ? area : w->dirichlet_area;
    w->region.has_free_edge = has_free_edge(&w->mask);
    if (has_approach(w)) {
        status = come_near(w, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    status = settle(w, error);
    if (status == TAUT_NOT_CONVERGED && w->region.rest_from > 0 && !is_spent(w)) {
        begin_anew(w);
        status = settle(w, error);
    }
    return status;
}

/* Is there a net to show, though the work is not done? */
static int is_partial(const work *w, taut_status status)
{
    return (status == TAUT_NOT_CONVERGED || status == TAUT_INTERRUPTED) && w->region.area > 0;
}

/* An end that was asked for while the last look at the area went on. */
static taut_status check_stop(const work *w, taut_status status, taut_error *error)
{
    return status == TAUT_OK && taut_pulse_is_stopped(&w->pulse)
               ? taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                           "stopped on request")
               : status;
}

/* Fills points, as far as it came where it does not converge or is stopped; known ones as given. */
static taut_status find_points(work *w, taut_error *error)
{
    const taut_status status = check_stop(w, find_net(w, error), error);
    taut_status unscaled = TAUT_OK;

    if (status == TAUT_INTERRUPTED && !(w->region.area > 0)) { /* before the first step */
        w->region.area = w->first_area;
        w->region.residual = taut_none;
    }

    if (status != TAUT_OK && !is_partial(w, status)) {
        return status;
    }
    unscaled = taut_scaling_undo(&w->scaling, w->count, w->problem->net.points,
                                 w->problem->net.known, w->net, w->points, error);
    return unscaled != TAUT_OK ? unscaled : status;
}

/* Without unknowns the surface is the one given; its area is still told. */
static taut_status keep_points(work *w, taut_error *error)
{
    memcpy(w->points, w->problem->net.points, 3 * w->count * sizeof(double));
    w->solver = "none";
    w->scaling = taut_scaling_of(w->count, w->points, w->problem->net.known);
    scale_points(w, w->points);
    return check_stop(w, find_rule(w, &w->dirichlet_area, error), error);
}

/* A list of rows of vectors, one for each point. */
static void add_vectors(const work *w, taut_record *details, const char *name,
                        const double *vectors)
{
    taut_record *rows = taut_record_add_list(details, name);
    for (int i = 0; i < w->mask.nu; i++) {
        taut_record *row = taut_record_add_list(rows, NULL);
        for (int j = 0; j < w->mask.nv; j++) {
            const size_t at = (size_t)i * (size_t)w->mask.nv + (size_t)j;
            taut_record_add_numbers(row, NULL, 3, vectors + 3 * at);
        }
    }
}

/* The member `details`; taut_record_status tells whether memory ran out. */
static taut_record *details_of(const work *w)
{
    const taut_mask *p = &w->mask;
    taut_record *details = taut_record_new();
    const int is_normal = w->problem->method == TAUT_PLATEAU_NORMAL;

    taut_record_add_number(details, "iterations", w->region.iterations);
    taut_record_add_number(details, "dirichlet_area",
                           taut_scaling_undo_square(&w->scaling, w->dirichlet_area));
    taut_record_add_number(details, "unknowns", (double)p->unknowns);
    taut_record_add_text(details, "known",
                         p->unknowns == 0 ? "all"
                         : p->is_interior ? "boundary"
                                          : "pattern");
    taut_record_add_text(details, "method", is_normal ? "normal" : "full");
    taut_record_add_text(details, "solver", w->solver);
    taut_record_add_number(details, "products", w->products);
    taut_record_add_number(details, "residual", w->region.residual);
    taut_record_add_number(details, "tolerance", w->region.tolerance);
    if (is_normal && p->unknowns > 0) {
        add_vectors(w, details, "dirichlet", taut_surface_points(guide_of(w)));
        add_vectors(w, details, "directions", w->directions);
    }
    taut_record *areas = taut_record_add_list(details, "areas");
    for (int k = 0; k < w->region.areas_count; k++) {
        taut_record_add_number(areas, NULL,
                               taut_scaling_undo_square(&w->scaling, w->region.areas[k]));
    }
    return details;
}

static taut_status make_solution(const work *w, taut_plateau_solution *solution, taut_error *error)
{
    const taut_dirichlet_problem *net = &w->problem->net;
    const char *name = net->name != NULL ? net->name : "plateau";
    taut_plateau_solution made = {NULL, NULL, 0};
    taut_status status =
        taut_surface_new(name, net->u, net->v, w->points, net->weights, &made.surface, error);

    if (status != TAUT_OK) {
        return status;
    }
    made.area = taut_scaling_undo_square(&w->scaling, w->mask.unknowns == 0 ? w->dirichlet_area
                                                                            : w->region.area);
    made.details = details_of(w);
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

static taut_status solve(work *w, taut_plateau_solution *solution, taut_error *error)
{
    taut_status made = TAUT_OK;
    taut_status status = taut_dirichlet_make(&w->problem->net, w->options, &w->first, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = make_free(w, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = prepare(w, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = w->mask.unknowns == 0 ? keep_points(w, error) : find_points(w, error);
    if (status != TAUT_OK && !is_partial(w, status)) {
        return status;
    }
    made = make_solution(w, solution, error);
    return made != TAUT_OK ? made : status;
}

taut_status taut_plateau_solve(const taut_plateau_problem *problem,
                               const taut_make_options *options, taut_plateau_solution *solution,
                               taut_error *error)
{
    work w = {.problem = problem, .options = options, .solver = "none"};
    w.pulse = (taut_pulse){.monitor = &options->monitor, .what = "least area", .done = taut_none};
    taut_status status = TAUT_OK;

    w.region.tolerance = problem->tolerance > 0 ? problem->tolerance : tolerance_default;
    w.region.max_iterations =
        problem->max_iterations > 0 ? problem->max_iterations : ITERATIONS_DEFAULT;
    if (problem->method == TAUT_PLATEAU_FULL) {
        w.region.theta_least = theta_smooth;
        w.region.rest_step = rest_step * w.region.tolerance;
    }
    status = solve(&w, solution, error);
    work_clear(&w);
    return status;
}
