/* plateau.c -- derivatives through the surface of least area.
 *
 * Method "full": the area does not change with the points found, so dA/dk is its derivative at
 * constant p: nothing is solved.
 *
 * Method "normal": p = x + z n, x the Dirichlet surface and n its normals at the Greville points,
 * both functions of k, and z from n . A_p = 0. With a number F and Z the rows n of the unknowns,
 *
 *     (Z A_pp Z^T) l = Z F_p,       s = F_P - A_PP Z^T l,       t = z s_p - l A_p
 *
 * s acts on x and on k, t on n; through n = x_u x x_v / W, with m = (t - n (n.t)) / W,
 *
 *     t . dn = (x_v x m) . dx_u + (m x x_u) . dx_v
 *
 * they come together at the Dirichlet surface (dirichlet.c). For the area itself l = 0.
 */
#include "construct/common/mask.h"
#include "construct/common/scaling.h"
#include "construct/dirichlet/form.h"
#include "construct/gradient/gradient.h"
#include "construct/plateau/area.h"
#include "construct/plateau/directions.h"
#include "construct/plateau/newton_step.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { FIRST_RULE = 2 }; /* of those for second derivatives */

/* What decides. */
static const struct {
    double rest;    /* of the largest derivative of the area: unknowns at rest have less ... */
    double asked;   /* ... or so many times the tolerance of the problem */
    double tangent; /* of the largest |x_u x x_v|: no tangent plane below (directions.c) */
    double forcing; /* of steps by conjugate gradients */
    double
        settled; /* two rules agree, as a share of the largest derivative: more is rounding of the solve */
    double points; /* Gauss points: a finer rule is not tried where there are more */
} limits = {
    .rest = 1e-7, .asked = 10, .tangent = 1e-9, .forcing = 1e-14, .settled = 1e-11, .points = 1e7};

/* What is pulled back. */
typedef struct pulling {
    const taut_plateau_problem *problem;
    const taut_surface *surface;
    const taut_gradient_request *request;
    taut_arena *arena;
    taut_mask mask;
    size_t count;
    const taut_surface *first; /* the Dirichlet surface, or NULL */
    double *directions;        /* [nu][nv][3], or NULL: "full" */
    double *slope;             /* [nu][nv][3]: A_P */
    double *turn;              /* [nu][nv][3]: t */
} pulling;

/* ---- at rest ---- */

static taut_status check_rest(const pulling *p, taut_error *error)
{
    const double limit = fmax(limits.rest, limits.asked * p->problem->tolerance);
    double all = 0, unknown = 0;

    for (size_t i = 0; i < p->count; i++) {
        const double *g = p->slope + 3 * i;
        const double size = taut_largest_coordinate(g);
        all = fmax(all, size);
        if (!p->mask.known[i]) {
            unknown = fmax(unknown,
                           p->directions == NULL ? size : fabs(taut_dot(p->directions + 3 * i, g)));
        }
    }
    if (!(unknown <= limit * all)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-at-rest", NULL, unknown / all, limit,
                         "the area still changes with the points found, by %.3g of its largest "
                         "derivative, expected at most %.3g: make the surface to a smaller "
                         "tolerance",
                         unknown / all, limit);
    }
    return TAUT_OK;
}

/* ---- "normal": the second derivatives ---- */

/* l by one solve, then seed -= A_PP Z^T l and turn = -l A_p; the state of the functional is that of
 * the surface. The second derivatives are the same in any unit. */
static taut_status apply_steps(const pulling *p, taut_area_functional *functional,
                               taut_newton_step *newton, double *seed)
{
    double *b = taut_arena_take(p->arena, p->count, sizeof(double));
    double *l = taut_arena_take(p->arena, p->count, sizeof(double));
    double *move = taut_arena_take(p->arena, p->count, 3 * sizeof(double));
    double *product = taut_arena_take(p->arena, p->count, 3 * sizeof(double));
    double gain = 0;
    taut_status status = TAUT_OK;

    if (taut_arena_status(p->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_newton_step_reduce(newton, seed, b);
    status = taut_newton_step_solve(newton, 0, limits.forcing, b, l, &gain);
    if (status != TAUT_OK) {
        return status;
    }
    taut_newton_step_expand(newton, l, move);
    taut_area_functional_product(functional, 0, move, product);
    for (size_t i = 0; i < p->count; i++) {
        taut_add_scaled(-1, product + 3 * i, seed + 3 * i);
        if (!p->mask.known[i]) {
            taut_add_scaled(-l[i], p->slope + 3 * i, p->turn + 3 * i);
        }
    }
    return TAUT_OK;
}

/* The functional of a rule at the surface, scaled. */
static taut_status open_functional(const pulling *p, int rule, taut_area_functional **functional)
{
    const taut_dirichlet_problem *net = &p->problem->net;
    const double *points = taut_surface_points(p->surface);
    double *scaled = taut_arena_take(p->arena, p->count, 3 * sizeof(double));
    double *scratch = taut_arena_take(p->arena, p->count, 3 * sizeof(double));
    taut_status status = TAUT_NO_MEMORY;

    if (scratch != NULL && scaled != NULL) {
        const taut_scaling scaling = taut_scaling_of(p->count, net->points, net->known);
        taut_scaling_apply(&scaling, p->count, points, NULL, scaled);
        status = taut_area_functional_new(net->u, net->v, net->weights, taut_gradient_nodes[rule],
                                          functional);
    }
    if (status == TAUT_OK) {
        (void)taut_area_functional_gradient(*functional, scaled, scratch);
    }
    return status;
}

/* seed and turn by one rule, and how many Gauss points it has. */
static taut_status solve_by_rule(const pulling *p, const taut_dirichlet_form *form, int rule,
                                 double *seed, double *points)
{
    taut_area_functional *functional = NULL;
    taut_newton_step *newton = NULL;
    taut_status status = open_functional(p, rule, &functional);

    if (status == TAUT_OK) {
        *points = (double)functional->u.count * functional->v.count;
        status = taut_newton_step_new(functional, form, &p->mask, p->directions, 1,
                                      &p->request->monitor, &newton);
    }
    if (status == TAUT_OK) {
        status = apply_steps(p, functional, newton, seed);
    }
    taut_newton_step_free(newton);
    taut_area_functional_free(functional);
    return status;
}

/* By rules one after the other until two agree; what is no minimum by one may be one by the next. */
static taut_status settle_steps(const pulling *p, const taut_dirichlet_form *form, double *seed,
                                taut_error *error)
{
    const size_t size = 3 * p->count;
    const double *given = taut_arena_copy(p->arena, seed, size, sizeof(double));
    double *before = taut_arena_take(p->arena, size, sizeof(double));
    double *turned = taut_arena_take(p->arena, size, sizeof(double));
    double change = INFINITY, points = 0;
    taut_status status = TAUT_OK, last = TAUT_NO_SOLUTION;

    if (taut_arena_status(p->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int rule = FIRST_RULE;
         rule < TAUT_GRADIENT_RULES && change > limits.settled && points <= limits.points; rule++) {
        memcpy(before, seed, size * sizeof(double));
        memcpy(turned, p->turn, size * sizeof(double));
        memcpy(seed, given, size * sizeof(double));
        memset(p->turn, 0, size * sizeof(double));
        status = solve_by_rule(p, form, rule, seed, &points);
        if (status != TAUT_OK && status != TAUT_NO_SOLUTION) {
            return taut_fail_status(error, status);
        }
        change = status == TAUT_OK && last == TAUT_OK
                     ? fmax(taut_gradient_change(size, before, seed),
                            taut_gradient_change(size, turned, p->turn))
                     : INFINITY;
        last = status;
    }
    if (last == TAUT_NO_SOLUTION) {
        return taut_fail(error, last, "saddle", NULL, taut_none, taut_none,
                         "the second derivative of the area along the normals is not positive: "
                         "there is no derivative to be had");
    }
    return taut_gradient_check_settled(change, error);
}

static taut_status solve_steps(const pulling *p, double *seed, taut_error *error)
{
    const taut_dirichlet_problem *net = &p->problem->net;
    taut_dirichlet_form form;
    taut_status status = taut_dirichlet_form_new(net->u, net->v, net->weights, &form, error);

    if (status == TAUT_OK) {
        status = settle_steps(p, &form, seed, error);
        taut_dirichlet_form_clear(&form);
    }
    return status;
}

/* ---- "normal": the normals ---- */

/* Basis functions alive at t, and their slopes. */
typedef struct alive {
    int first, local;
    double value[2][TAUT_DEGREE_MAX + 1];
} alive;

static void find_alive(const taut_basis *basis, double t, alive *found)
{
    double values[2 * (TAUT_DEGREE_MAX + 1)];
    const int span = taut_basis_span(basis, t);

    found->first = taut_basis_first(basis, span);
    found->local = taut_basis_local(basis);
    (void)taut_basis_eval(basis, span, t, 1, values);
    for (int k = 0; k < 2 * found->local; k++) {
        found->value[k / found->local][k % found->local] = values[k];
    }
}

/* seed += (dx_u by each point) a + (dx_v by each point) b, at one place. With weights
 * x = sum w N p / W: dx_u/dp = w (N_u W - N W_u) / W^2. */
static void spread(const taut_dirichlet_problem *net, const alive *u, const alive *v,
                   const double a[3], const double b[3], double *seed)
{
    const size_t nv = (size_t)taut_basis_count(net->v);
    double sum[3] = {0, 0, 0}; /* W, W_u, W_v */

    for (int k = 0; k < u->local * v->local; k++) {
        const int i = k / v->local, j = k % v->local;
        const size_t at = (size_t)(u->first + i) * nv + (size_t)(v->first + j);
        const double w = net->weights != NULL ? net->weights[at] : 1;
        sum[0] += w * u->value[0][i] * v->value[0][j];
        sum[1] += w * u->value[1][i] * v->value[0][j];
        sum[2] += w * u->value[0][i] * v->value[1][j];
    }
    for (int k = 0; k < u->local * v->local; k++) {
        const int i = k / v->local, j = k % v->local;
        const size_t at = (size_t)(u->first + i) * nv + (size_t)(v->first + j);
        const double w = (net->weights != NULL ? net->weights[at] : 1) / sum[0];
        const double value = u->value[0][i] * v->value[0][j] / sum[0];
        taut_add_scaled(w * (u->value[1][i] * v->value[0][j] - value * sum[1]), a, seed + 3 * at);
        taut_add_scaled(w * (u->value[0][i] * v->value[1][j] - value * sum[2]), b, seed + 3 * at);
    }
}

/* The Dirichlet surface at the Greville points: position, x_u, x_v. */
static double *find_jets(const pulling *p, const double *u, const double *v)
{
    double *jets = taut_arena_take(p->arena, p->count, 9 * sizeof(double));
    if (jets == NULL ||
        taut_surface_eval_grid(p->first, p->mask.nu, u, p->mask.nv, v, 1, 1, jets) != TAUT_OK) {
        return NULL;
    }
    return jets;
}

/* Carries t at one unknown point to the points of the Dirichlet surface. *largest: see limits. */
static taut_status turn_one(const pulling *p, const double *jet, double largest, const double *t,
                            const alive *u, const alive *v, double *seed, taut_error *error)
{
    double normal[3], m[3], a[3], b[3];
    taut_cross(jet + 3, jet + 6, normal);
    const double w = taut_norm(normal);

    if (!(w > limits.tangent * largest)) {
        return taut_gradient_refuse("the Dirichlet surface has no tangent plane at the place of a "
                                    "point that is to be found",
                                    error);
    }
    for (int c = 0; c < 3; c++) {
        normal[c] /= w;
    }
    const double along = taut_dot(normal, t);
    for (int c = 0; c < 3; c++) {
        m[c] = (t[c] - along * normal[c]) / w;
    }
    taut_cross(jet + 6, m, a);
    taut_cross(m, jet + 3, b);
    spread(&p->problem->net, u, v, a, b, seed);
    return TAUT_OK;
}

static taut_status turn_all(const pulling *p, double *seed, taut_error *error)
{
    const taut_dirichlet_problem *net = &p->problem->net;
    double *u = taut_arena_take(p->arena, (size_t)p->mask.nu, sizeof(double));
    double *v = taut_arena_take(p->arena, (size_t)p->mask.nv, sizeof(double));
    alive *across = taut_arena_take(p->arena, (size_t)p->mask.nv, sizeof *across);
    double *jets = NULL, largest = 0;
    taut_status status = TAUT_OK;

    if (taut_arena_status(p->arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_plateau_greville(net->u, u);
    taut_plateau_greville(net->v, v);
    jets = find_jets(p, u, v);
    if (jets == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < p->count; i++) {
        double normal[3];
        taut_cross(jets + 9 * i + 3, jets + 9 * i + 6, normal);
        largest = fmax(largest, taut_norm(normal));
    }
    for (int j = 0; j < p->mask.nv; j++) {
        find_alive(net->v, v[j], &across[j]);
    }
    for (int i = 0; i < p->mask.nu; i++) {
        alive here;
        find_alive(net->u, u[i], &here);
        for (int j = 0; j < p->mask.nv && status == TAUT_OK; j++) {
            const size_t at = (size_t)i * (size_t)p->mask.nv + (size_t)j;
            if (!p->mask.known[at]) {
                status = turn_one(p, jets + 9 * at, largest, p->turn + 3 * at, &here, &across[j],
                                  seed, error);
            }
        }
    }
    return status;
}

/* turn += z s: how far a point is from the Dirichlet surface. */
static void add_lengths(const pulling *p, const double *seed)
{
    const double *points = taut_surface_points(p->surface);
    const double *from = taut_surface_points(p->first);

    for (size_t i = 0; i < p->count; i++) {
        double d[3];
        if (!p->mask.known[i]) {
            taut_difference(points + 3 * i, from + 3 * i, d);
            taut_add_scaled(taut_dot(d, p->directions + 3 * i), seed + 3 * i, p->turn + 3 * i);
        }
    }
}

static taut_status pull_normal(pulling *p, double *seed, taut_error *error)
{
    taut_status status = TAUT_OK;

    if (p->request->of != TAUT_GRADIENT_AREA) {
        status = solve_steps(p, seed, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    add_lengths(p, seed);
    status = turn_all(p, seed, error);
    return status == TAUT_OK ? taut_gradient_pull_dirichlet(&p->problem->net, &p->request->monitor,
                                                            p->arena, seed, error)
                             : status;
}

/* ---- both ---- */

static taut_status open_normal(pulling *p, taut_model **first, taut_error *error)
{
    const taut_make_options options = {.monitor = p->request->monitor};
    const taut_status status = taut_dirichlet_make(&p->problem->net, &options, first, error);

    if (status != TAUT_OK) {
        return status;
    }
    p->directions = taut_arena_take(p->arena, p->count, 3 * sizeof(double));
    p->turn = taut_arena_take(p->arena, p->count, 3 * sizeof(double));
    if (taut_arena_status(p->arena) != TAUT_OK ||
        taut_plateau_directions(taut_model_surface(*first, 0), p->directions) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

static taut_status pull_open(pulling *p, double *seed, taut_error *error)
{
    const taut_gradient_request area = {.of = TAUT_GRADIENT_AREA, .monitor = p->request->monitor};
    taut_status status = taut_gradient_of_surface(p->surface, &area, p->arena, p->slope, error);

    status = status == TAUT_OK ? check_rest(p, error) : status;
    if (status != TAUT_OK) {
        return status;
    }
    if (p->directions != NULL) {
        return pull_normal(p, seed, error);
    }
    for (size_t i = 0; i < 3 * p->count; i++) {
        seed[i] = p->mask.known[i / 3] ? seed[i] : 0;
    }
    return TAUT_OK;
}

static taut_status pull(const void *context, const taut_surface *surface,
                        const taut_gradient_request *request, taut_arena *arena, double *seed,
                        taut_error *error)
{
    pulling p = {.problem = context, .surface = surface, .request = request, .arena = arena};
    const taut_dirichlet_problem *net = &p.problem->net;
    const int nu = taut_basis_count(net->u), nv = taut_basis_count(net->v);
    taut_model *first = NULL;
    taut_status status = TAUT_OK;

    p.count = (size_t)nu * (size_t)nv;
    p.slope = taut_arena_take(arena, p.count, 3 * sizeof(double));
    if (p.slope == NULL || taut_mask_new(nu, nv, net->known, arena, &p.mask) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (p.mask.unknowns == 0) {
        return TAUT_OK;
    }
    if (p.problem->method == TAUT_PLATEAU_NORMAL) {
        status = open_normal(&p, &first, error);
        p.first = status == TAUT_OK ? taut_model_surface(first, 0) : NULL;
    }
    status = status == TAUT_OK ? pull_open(&p, seed, error) : status;
    taut_model_free(first);
    return status;
}

taut_status taut_plateau_gradient(const taut_plateau_problem *problem, const taut_model *model,
                                  const taut_gradient_request *request, double *gradient,
                                  taut_error *error)
{
    if (problem == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_plateau_gradient needs a problem");
    }
    if (problem->curves[0] != NULL) {
        return taut_gradient_refuse("curves are fitted: give the boundary as points of the net",
                                    error);
    }
    if (problem->net.aspect_auto) {
        return taut_gradient_refuse("an aspect that is searched for moves with the points", error);
    }
    if (problem->net.through_count > 0) {
        return taut_gradient_refuse(
            "points to pass through hold the surface besides those that are known: "
            "leave them out",
            error);
    }
    if (problem->method == TAUT_PLATEAU_FULL && request != NULL &&
        request->of != TAUT_GRADIENT_AREA) {
        return taut_gradient_refuse("with the method \"full\" only the area is determined, not "
                                    "where the points lie within the surface: take \"normal\"",
                                    error);
    }
    const taut_gradient_net net = {problem->net.u, problem->net.v, problem->net.points,
                                   problem->net.known, 0};
    return taut_gradient_run(&net, model, request, pull, problem, gradient, error);
}
