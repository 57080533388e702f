/* refine.c -- finer spaces: all spans halved, or knots where the surface bends.
 *
 * Areas A_0, A_1, .. A_m of nested spaces fall like a geometric series, with
 *
 *     g_k = A_(k-1) - A_k,   r = g_m / g_(m-1):   A_m - g_m r / (1 - r)
 *
 * where it ends (Aitken). An estimate, not a bound: r is kept between bounds that hold for splines
 * of degree 2 and more on boundaries with corners, and 1/4 is taken for it after one step. */
#include "construct/plateau/refine.h"

#include "core/arena.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/operations.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    ROUNDS_MAX = 24, /* of knots that are put in */
    NODES = 4,       /* on a span, to measure how it bends */
};

/* What decides. */
static const struct {
    double tolerance_share;   /* of tolerance_area: areas need not be nearer to their least */
    double tolerance_loosest; /* of the gradient: an area is good to its square */
    double rate_slowest;  /* of the gains from one halving to the next: degree 2, with corners */
    double rate_adapted;  /* the same where only some spans are cut */
    double rate_fastest;  /* degree 3 and more, without corners */
    double rate_first;    /* taken after one step */
    double bending_share; /* of int |H|^2 W, in the spans that are cut */
    double normal_least;  /* of |x_u| |x_v|: less is no normal */
    double gap_share;     /* of the gap asked for: what the proof may find more */
    int points_along_normals; /* from which an estimate goes along normals: little above */
    int spans_over_chosen;    /* all spans are cut where fewer times those chosen are there */
} limits = {
    .tolerance_share = 1e-2,
    .tolerance_loosest = 1e-8,
    .rate_slowest = 0.5,
    .rate_adapted = 0.8,
    .rate_fastest = 1.0 / 64,
    .rate_first = 0.25,
    .bending_share = 0.7,
    .normal_least = 1e-12,
    .gap_share = 0.85,
    .points_along_normals = 700,
    .spans_over_chosen = 4,
};

typedef struct rounds {
    int count;
    int points[ROUNDS_MAX + 1][2];
    double areas[ROUNDS_MAX + 1], limits[ROUNDS_MAX + 1];
} rounds;

/* Where the areas seem to end. */
static double limit_of(const rounds *r, double slow)
{
    const double *a = r->areas + r->count - 1; /* the last one */
    double rate = limits.rate_first;

    if (r->count < 2) {
        return taut_none;
    }
    if (r->count > 2 && a[-2] - a[-1] != 0) {
        rate = fmin(slow, fmax(limits.rate_fastest, fabs((a[-1] - a[0]) / (a[-2] - a[-1]))));
    }
    return a[0] - fabs(a[-1] - a[0]) * rate / (1 - rate);
}

static void add_round(rounds *r, const taut_plateau_solution *solution, double slow)
{
    r->points[r->count][0] = taut_basis_count(taut_surface_u(solution->surface));
    r->points[r->count][1] = taut_basis_count(taut_surface_v(solution->surface));
    r->areas[r->count++] = solution->area;
    r->limits[r->count - 1] = limit_of(r, slow);
}

/* The member `refinement`; `of`: the round whose surface is the result. */
static void describe_rounds(const rounds *r, int of, taut_record *details)
{
    taut_record *refinement = taut_record_add_object(details, "refinement");
    taut_record *list = taut_record_add_list(refinement, "rounds");
    const double limit = r->limits[r->count - 1];

    for (int k = 0; k < r->count; k++) {
        taut_record *one = taut_record_add_object(list, NULL);
        const double points[2] = {r->points[k][0], r->points[k][1]};
        taut_record_add_numbers(one, "points", 2, points);
        taut_record_add_number(one, "area", r->areas[k]);
        if (isfinite(r->limits[k])) {
            taut_record_add_number(one, "estimated_gap", r->areas[k] / r->limits[k] - 1);
        } else {
            taut_record_add_null(one, "estimated_gap");
        }
    }
    taut_record_add_number(refinement, "estimated_least_area", limit);
    taut_record_add_number(refinement, "estimated_gap", r->areas[of] / limit - 1);
}

/* ---- where the surface bends ---- */

/* Nodes and weights over all spans of one direction. */
typedef struct line {
    int spans;
    double *t, *weight; /* [spans * NODES] */
    double *bending;    /* [spans] */
} line;

static taut_status line_init(const taut_basis *basis, taut_arena *arena, line *l)
{
    const double *breaks = taut_basis_breaks(basis);
    const double range = taut_basis_hi(basis) - taut_basis_lo(basis);
    double node[NODES], weight[NODES];

    l->spans = taut_basis_span_count(basis);
    l->t = taut_arena_take(arena, (size_t)l->spans * NODES, sizeof(double));
    l->weight = taut_arena_take(arena, (size_t)l->spans * NODES, sizeof(double));
    l->bending = taut_arena_take(arena, (size_t)l->spans, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(NODES, node, weight);
    for (int k = 0; k < l->spans * NODES; k++) {
        const double lo = breaks[k / NODES], hi = breaks[k / NODES + 1];
        l->t[k] = lo + (hi - lo) * (0.5 + 0.5 * node[k % NODES]);
        l->weight[k] = weight[k % NODES] * ((hi - lo) / range);
    }
    return TAUT_OK;
}

/* |H|^2 W from x, x_u, x_v, x_uu, x_uv, x_vv; 0 where there is no normal. */
static double bending_of(const double *jet)
{
    const double *xu = jet + 3, *xv = jet + 6;
    const double e = taut_dot(xu, xu), f = taut_dot(xu, xv), g = taut_dot(xv, xv);
    double normal[3];

    taut_cross(xu, xv, normal);
    const double w = taut_norm(normal);
    const double twice = (taut_dot(jet + 9, normal) * g - 2 * taut_dot(jet + 12, normal) * f +
                          taut_dot(jet + 15, normal) * e) /
                         (w * w * w); /* 2 H */
    return isfinite(twice) && w > limits.normal_least * sqrt(e * g) ? 0.25 * twice * twice * w : 0;
}

static taut_status measure_bending(const taut_surface *surface, taut_arena *arena, line *u, line *v)
{
    const size_t count = (size_t)v->spans * NODES;
    double *jets = taut_arena_take(arena, count, 18 * sizeof(double));
    taut_status status = jets != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int i = 0; status == TAUT_OK && i < u->spans * NODES; i++) {
        status = taut_surface_eval_grid(surface, 1, u->t + i, v->spans * NODES, v->t, 2, 1, jets);
        for (size_t j = 0; status == TAUT_OK && j < count; j++) {
            const double part = u->weight[i] * v->weight[j] * bending_of(jets + 18 * j);
            u->bending[i / NODES] += part;
            v->bending[j / NODES] += part;
        }
    }
    return status;
}

/* How few spans hold the share; their places in bending become -1. */
static int choose_spans(line *l)
{
    double left = 0;
    int chosen = 0;

    for (int s = 0; s < l->spans; s++) {
        left += limits.bending_share * l->bending[s];
    }
    for (; chosen < l->spans && (chosen == 0 || left > 0); chosen++) {
        int most = 0;
        for (int s = 1; s < l->spans; s++) {
            most = l->bending[s] > l->bending[most] ? s : most;
        }
        left -= l->bending[most];
        l->bending[most] = -1;
    }
    return chosen;
}

/* Cuts the spans chosen; all of them where those are many, since even knots serve better. */
static taut_status cut_spans(const taut_basis *basis, line *l, int direction,
                             taut_surface **surface, taut_error *error)
{
    const double *breaks = taut_basis_breaks(basis);
    const int all = limits.spans_over_chosen * choose_spans(l) > l->spans;

    for (int s = 0; s < l->spans; s++) {
        if (all || l->bending[s] < 0) {
            taut_surface *next = NULL;
            const taut_status status = taut_surface_insert(
                *surface, direction, 0.5 * breaks[s] + 0.5 * breaks[s + 1], 1, &next, error);
            if (status != TAUT_OK) {
                return status;
            }
            taut_surface_free(*surface);
            *surface = next;
        }
    }
    return TAUT_OK;
}

/* Sums of the density over rows and columns. */
static void sum_density(const double *density, line *u, line *v)
{
    for (int i = 0; i < u->spans; i++) {
        for (int j = 0; j < v->spans; j++) {
            const double part = density[(size_t)i * (size_t)v->spans + (size_t)j];
            u->bending[i] += part;
            v->bending[j] += part;
        }
    }
}

static taut_status cut_where_bent(const taut_surface *surface, const double *density,
                                  taut_arena *arena, taut_surface **finer, taut_error *error)
{
    const taut_basis *basis_u = taut_surface_u(surface), *basis_v = taut_surface_v(surface);
    line u, v;
    taut_status status = TAUT_OK;

    if (line_init(basis_u, arena, &u) != TAUT_OK || line_init(basis_v, arena, &v) != TAUT_OK ||
        (density == NULL && measure_bending(surface, arena, &u, &v) != TAUT_OK) ||
        taut_surface_copy(surface, finer) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (density != NULL) {
        sum_density(density, &u, &v);
    }
    status = cut_spans(basis_u, &u, TAUT_ALONG_U, finer, error);
    return status == TAUT_OK ? cut_spans(basis_v, &v, TAUT_ALONG_V, finer, error) : status;
}

taut_status taut_plateau_insert_knots(const taut_surface *surface, const double *density,
                                      taut_surface **finer, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_surface *made = NULL;
    const taut_status status = cut_where_bent(surface, density, arena, &made, error);

    taut_arena_free(arena);
    if (status != TAUT_OK) {
        taut_surface_free(made);
        return status;
    }
    *finer = made;
    return TAUT_OK;
}

/* ---- solving in finer spaces ---- */

/* The same surface with every span halved both ways. */
static taut_status halve_spans(const taut_surface *surface, taut_surface **halved,
                               taut_error *error)
{
    taut_surface *along_u = NULL;
    taut_status status = taut_surface_refine(surface, TAUT_ALONG_U, &along_u, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_refine(along_u, TAUT_ALONG_V, halved, error);
    taut_surface_free(along_u);
    return status;
}

/* Solves in the space of `finer`; *space is the new one. For an estimate the area that
 * it came to is good enough where the trust region does not converge. */
static taut_status solve_finer(const taut_plateau_problem *problem, const taut_surface *finer,
                               const taut_make_options *options, int is_estimate,
                               taut_plateau_space **space, taut_plateau_solution *solution,
                               taut_error *error)
{
    taut_status status = taut_plateau_space_new(problem, finer, space, error);
    taut_plateau_problem chosen;

    if (status != TAUT_OK) {
        return status;
    }
    chosen = (*space)->problem;
    if (is_estimate && problem->tolerance_area > 0) {
        chosen.tolerance =
            fmax(chosen.tolerance,
                 fmin(limits.tolerance_loosest, limits.tolerance_share * problem->tolerance_area));
    }
    if (is_estimate && taut_basis_count(chosen.net.u) * taut_basis_count(chosen.net.v) >
                           limits.points_along_normals) {
        chosen.method = TAUT_PLATEAU_NORMAL;
    }
    status = taut_plateau_solve(&chosen, options, solution, error);
    if (status == TAUT_NOT_CONVERGED && is_estimate && solution->surface != NULL) {
        status = TAUT_OK;
    }
    return status;
}

/* The same in the space of `surface` with all spans halved, for an estimate. */
static taut_status solve_halved(const taut_plateau_problem *problem, const taut_surface *surface,
                                const taut_make_options *options, taut_plateau_solution *solution,
                                taut_error *error)
{
    taut_plateau_space *space = NULL;
    taut_surface *finer = NULL;
    taut_status status = halve_spans(surface, &finer, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = solve_finer(problem, finer, options, 1, &space, solution, error);
    taut_surface_free(finer);
    taut_plateau_space_free(space);
    return status;
}

taut_status taut_plateau_estimate(const taut_plateau_problem *problem,
                                  const taut_make_options *options, taut_plateau_solution *solution,
                                  taut_error *error)
{
    taut_plateau_solution last = {NULL, NULL, 0};
    const taut_surface *surface = solution->surface;
    rounds r = {.count = 0};
    taut_status status = TAUT_OK;

    add_round(&r, solution, limits.rate_slowest);
    for (int k = 0; status == TAUT_OK && k < problem->refine; k++) {
        taut_plateau_solution next = {NULL, NULL, 0};
        status = solve_halved(problem, surface, options, &next, error);
        taut_plateau_solution_clear(&last);
        last = next;
        surface = last.surface;
        if (status == TAUT_OK) {
            add_round(&r, &last, limits.rate_slowest);
        }
    }
    taut_plateau_solution_clear(&last);
    if (status != TAUT_OK) {
        return status;
    }
    describe_rounds(&r, 0, solution->details);
    return TAUT_OK;
}

/* The estimate by rounds of few knots may flatter: a space with all spans halved has the last word.
 */
static taut_status look_ahead(const taut_plateau_problem *problem, const taut_make_options *options,
                              const taut_plateau_solution *solution, rounds *r, taut_error *error)
{
    double *limit = &r->limits[r->count - 1];
    taut_plateau_solution finest = {NULL, NULL, 0};
    const taut_status status = solve_halved(problem, solution->surface, options, &finest, error);
    const double area = finest.area;

    taut_plateau_solution_clear(&finest);
    if (status != TAUT_OK) {
        return status;
    }
    *limit = fmin(*limit, area - fabs(solution->area - area) * (1.0 / 3));
    return TAUT_OK;
}

static int is_near(const rounds *r, double tolerance)
{
    const double area = r->areas[r->count - 1], limit = r->limits[r->count - 1];
    return area - limit <= tolerance * limit;
}

static taut_status refuse_gap(const rounds *r, double tolerance, taut_error *error)
{
    const int last = r->count - 1;
    const double gap = r->areas[last] / r->limits[last] - 1;
    assert(last > 0); /* the first net takes knots: see taut_plateau_make */
    return taut_fail(error, TAUT_NOT_CONVERGED, "area-gap", "/tolerance_area", gap, tolerance,
                     "with %d by %d points the area is estimated %.2g above the least, expected at "
                     "most %.2g: raise the degree, or the tolerance",
                     r->points[last][0], r->points[last][1], gap, tolerance);
}

/* A failure in a finer space: which one it is goes before the reason. */
static void name_space(const taut_plateau_space *space, taut_error *error)
{
    enum { ROOM = 64 };
    const taut_dirichlet_problem *net = &space->problem.net;
    char why[sizeof error->message - ROOM];

    if (error != NULL) {
        memcpy(why, error->message, sizeof why);
        why[sizeof why - 1] = '\0';
        snprintf(error->message, sizeof error->message, "with %d by %d points, %s",
                 taut_basis_count(net->u), taut_basis_count(net->v), why);
    }
}

/* Knots where the solution bends, and the solution in that space in place of the one there is. */
static taut_status solve_next(const taut_plateau_problem *problem, const taut_make_options *options,
                              const double *density, taut_plateau_space **space,
                              taut_plateau_solution *solution, taut_error *error)
{
    taut_plateau_solution next = {NULL, NULL, 0};
    taut_plateau_space *finer_space = NULL;
    taut_surface *finer = NULL;
    taut_status status = taut_plateau_insert_knots(solution->surface, density, &finer, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = solve_finer(problem, finer, options, 0, &finer_space, &next, error);
    taut_surface_free(finer);
    if (status != TAUT_OK) {
        if (status == TAUT_NOT_CONVERGED && finer_space != NULL) {
            name_space(finer_space, error);
        }
        taut_plateau_space_free(finer_space);
        taut_plateau_solution_clear(&next);
        return status;
    }
    taut_plateau_space_free(*space);
    *space = finer_space;
    taut_plateau_solution_clear(solution);
    *solution = next;
    return TAUT_OK;
}

taut_status taut_plateau_adapt(const taut_plateau_problem *problem,
                               const taut_make_options *options, taut_plateau_space **space,
                               taut_plateau_solution *solution, taut_error *error)
{
    const double tolerance = problem->tolerance_area;
    rounds r = {.count = 0};

    add_round(&r, solution, limits.rate_adapted);
    for (;;) {
        const int last = r.count - 1;
        taut_status status = TAUT_OK;
        if (r.count > 2 && is_near(&r, tolerance)) {
            status = look_ahead(problem, options, solution, &r, error);
            if (status != TAUT_OK) {
                return status;
            }
            if (is_near(&r, tolerance)) {
                describe_rounds(&r, last, solution->details);
                return TAUT_OK;
            }
        }
        if (r.count > ROUNDS_MAX ||
            r.points[last][0] * r.points[last][1] > TAUT_PLATEAU_ADAPTED_MAX) {
            return refuse_gap(&r, tolerance, error);
        }
        status = solve_next(problem, options, NULL, space, solution, error);
        if (status != TAUT_OK) {
            return status;
        }
        add_round(&r, solution, limits.rate_adapted);
    }
}

/* ---- until the gap is closed ---- */

/* The member `refinement`: how the gap fell. */
static void describe_gaps(const rounds *r, taut_record *details)
{
    taut_record *list =
        taut_record_add_list(taut_record_add_object(details, "refinement"), "rounds");

    for (int k = 0; k < r->count; k++) {
        taut_record *one = taut_record_add_object(list, NULL);
        const double points[2] = {r->points[k][0], r->points[k][1]};
        taut_record_add_numbers(one, "points", 2, points);
        taut_record_add_number(one, "area", r->areas[k]);
        taut_record_add_number(one, "gap", r->limits[k]);
    }
}

static taut_status refuse_least(const rounds *r, double gap, taut_error *error)
{
    const int last = r->count - 1;
    return taut_fail(error, TAUT_NOT_CONVERGED, "gap", "/gap", r->limits[last], gap,
                     "with %d by %d points the area is shown to be within %.2g of the least, "
                     "expected %.2g: raise the degree, or the gap",
                     r->points[last][0], r->points[last][1], r->limits[last], gap);
}

/* The witness of the solution in place of the one there is. */
static taut_status find_witness(const taut_plateau_solution *solution, double gap,
                                const taut_monitor *monitor, taut_plateau_witness **witness,
                                taut_error *error)
{
    taut_plateau_witness_free(*witness);
    *witness = NULL;
    if (taut_basis_degree(taut_surface_u(solution->surface)) >= 0 &&
        taut_basis_degree(taut_surface_v(solution->surface)) >= 0) {
        const taut_status status = taut_plateau_witness_new(solution->surface, monitor, witness);
        if (status != TAUT_OK) {
            return taut_plateau_witness_fail(status, error);
        }
    }
    if (*witness == NULL) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "not-convex", "/gap", taut_none, gap,
                         "no direction is found along which the film is a graph over a convex "
                         "domain, on polynomial bases: a gap can not be proved");
    }
    return TAUT_OK;
}

taut_status taut_plateau_close_gap(const taut_plateau_problem *problem,
                                   const taut_make_options *options, taut_plateau_space **space,
                                   taut_plateau_solution *solution, taut_plateau_witness **witness,
                                   taut_error *error)
{
    rounds r = {.count = 0};

    for (;;) {
        taut_status status =
            find_witness(solution, problem->gap, &options->monitor, witness, error);
        if (status != TAUT_OK) {
            return status;
        }
        add_round(&r, solution, limits.rate_adapted);
        r.limits[r.count - 1] = (*witness)->gap;
        if ((*witness)->gap <= limits.gap_share * problem->gap) {
            describe_gaps(&r, solution->details);
            return TAUT_OK;
        }
        if (r.count > ROUNDS_MAX ||
            r.points[r.count - 1][0] * r.points[r.count - 1][1] > TAUT_PLATEAU_LEAST_MAX / 2) {
            return refuse_least(&r, problem->gap, error);
        }
        status = solve_next(problem, options, (*witness)->density, space, solution, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
}
