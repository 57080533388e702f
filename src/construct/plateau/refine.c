/* refine.c -- areas A_0, A_1, .. A_m of nested spaces fall like a geometric series, with
 *
 *     g_k = A_(k-1) - A_k,   r = g_m / g_(m-1):   A_m - g_m r / (1 - r)
 *
 * where it ends (Aitken). An estimate, not a bound: r is kept between bounds that hold for splines
 * of degree 2 and more on boundaries with corners, and 1/4 is taken for it after one step. */
#include "construct/plateau/refine.h"

#include "construct/plateau/bend.h"
#include "core/fail.h"
#include "taut/operations.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROUNDS_MAX = 24 };
enum {
    MANY = 700
}; /* points from which an estimate goes along the normals: hardly above the least */
/* Areas need not be nearer to their least in one space than this part of what is asked for. */
static const double share = 1e-2, loosest = 1e-8;
static const double slowest = 0.5, slowest_adapted = 0.8, fastest = 1.0 / 64;

typedef struct rounds {
    int count;
    int points[ROUNDS_MAX + 1][2];
    double areas[ROUNDS_MAX + 1], limits[ROUNDS_MAX + 1];
} rounds;

/* Where the areas seem to end. */
static double limit_of(const rounds *r, double slow)
{
    const double *a = r->areas + r->count - 1; /* the last one */
    double rate = 0.25;

    if (r->count < 2) {
        return taut_none;
    }
    if (r->count > 2 && a[-2] - a[-1] != 0) {
        rate = fmin(slow, fmax(fastest, fabs((a[-1] - a[0]) / (a[-2] - a[-1]))));
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
static void describe(const rounds *r, int of, taut_record *details)
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

/* The same surface with every span halved both ways. */
static taut_status halve(const taut_surface *surface, taut_surface **halved, taut_error *error)
{
    taut_surface *along_u = NULL;
    taut_status status = taut_surface_refine(surface, TAUT_ALONG_U, &along_u, error);

    if (status == TAUT_OK) {
        status = taut_surface_refine(along_u, TAUT_ALONG_V, halved, error);
    }
    taut_surface_free(along_u);
    return status;
}

/* Solves in the space of `finer`; *space is the new one. For an estimate the area that
 * it came to is good enough where the film finds no rest. */
static taut_status solve_finer(const taut_plateau_problem *problem, const taut_surface *finer,
                               const taut_make_options *options, int is_estimate,
                               taut_plateau_space **space, taut_plateau_solution *solution,
                               taut_error *error)
{
    taut_status status = taut_plateau_space_new(problem, finer, space, error);
    taut_plateau_problem film;

    if (status != TAUT_OK) {
        return status;
    }
    film = (*space)->problem;
    if (is_estimate && problem->tolerance_area > 0) {
        film.tolerance = fmax(film.tolerance, fmin(loosest, share * problem->tolerance_area));
    }
    if (is_estimate && taut_basis_count(film.net.u) * taut_basis_count(film.net.v) > MANY) {
        film.method = TAUT_PLATEAU_NORMAL;
    }
    status = taut_plateau_solve(&film, options, solution, error);
    if (status == TAUT_NOT_CONVERGED && is_estimate && solution->surface != NULL) {
        status = TAUT_OK;
    }
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

    add_round(&r, solution, slowest);
    for (int k = 0; status == TAUT_OK && k < problem->refine; k++) {
        taut_plateau_solution next = {NULL, NULL, 0};
        taut_plateau_space *space = NULL;
        taut_surface *finer = NULL;
        status = halve(surface, &finer, error);
        if (status == TAUT_OK) {
            status = solve_finer(problem, finer, options, 1, &space, &next, error);
        }
        taut_surface_free(finer);
        taut_plateau_space_free(space);
        taut_plateau_solution_clear(&last);
        last = next;
        surface = last.surface;
        if (status == TAUT_OK) {
            add_round(&r, &last, slowest);
        }
    }
    if (status == TAUT_OK) {
        describe(&r, 0, solution->details);
    }
    taut_plateau_solution_clear(&last);
    return status;
}

/* The estimate by rounds of few knots may flatter: a space with all spans halved has the last word.
 */
static taut_status look_ahead(const taut_plateau_problem *problem, const taut_make_options *options,
                              const taut_plateau_solution *solution, rounds *r, taut_error *error)
{
    taut_plateau_solution finest = {NULL, NULL, 0};
    taut_plateau_space *space = NULL;
    taut_surface *finer = NULL;
    taut_status status = halve(solution->surface, &finer, error);

    if (status == TAUT_OK) {
        status = solve_finer(problem, finer, options, 1, &space, &finest, error);
    }
    if (status == TAUT_OK) {
        double *limit = &r->limits[r->count - 1];
        *limit = fmin(*limit, finest.area - fabs(solution->area - finest.area) * (1.0 / 3));
    }
    taut_plateau_solution_clear(&finest);
    taut_plateau_space_free(space);
    taut_surface_free(finer);
    return status;
}

static int is_near(const rounds *r, double tolerance)
{
    const double area = r->areas[r->count - 1], limit = r->limits[r->count - 1];
    return area - limit <= tolerance * limit;
}

static taut_status too_far(const rounds *r, double tolerance, taut_error *error)
{
    const int last = r->count - 1;
    const double gap = r->areas[last] / r->limits[last] - 1;
    assert(last > 0); /* the first net takes knots: see taut_plateau_make */
    return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", "/tolerance_area", gap, tolerance,
                     "with %d by %d points the area is estimated %.2g above the least, expected at "
                     "most %.2g: raise the degree, or the tolerance",
                     r->points[last][0], r->points[last][1], gap, tolerance);
}

/* A film that finds no rest in a finer space: which one it is goes before the reason. */
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

taut_status taut_plateau_adapt(const taut_plateau_problem *problem,
                               const taut_make_options *options, taut_plateau_space **space,
                               taut_plateau_solution *solution, taut_error *error)
{
    const double tolerance = problem->tolerance_area;
    rounds r = {.count = 0};
    taut_status status = TAUT_OK;

    add_round(&r, solution, slowest_adapted);
    while (status == TAUT_OK) {
        taut_plateau_solution next = {NULL, NULL, 0};
        taut_plateau_space *finer_space = NULL;
        taut_surface *finer = NULL;
        const int last = r.count - 1;
        if (r.count > 2 && is_near(&r, tolerance)) {
            status = look_ahead(problem, options, solution, &r, error);
            if (status != TAUT_OK || is_near(&r, tolerance)) {
                break;
            }
        }
        if (r.count > ROUNDS_MAX ||
            r.points[last][0] * r.points[last][1] > TAUT_PLATEAU_ADAPTED_MAX) {
            return too_far(&r, tolerance, error);
        }
        status = taut_plateau_insert(solution->surface, &finer, error);
        if (status == TAUT_OK) {
            status = solve_finer(problem, finer, options, 0, &finer_space, &next, error);
        }
        taut_surface_free(finer);
        if (status != TAUT_OK) {
            if (status == TAUT_NOT_CONVERGED && finer_space != NULL) {
                name_space(finer_space, error);
            }
            taut_plateau_space_free(finer_space);
            taut_plateau_solution_clear(&next);
            break;
        }
        taut_plateau_space_free(*space);
        *space = finer_space;
        taut_plateau_solution_clear(solution);
        *solution = next;
        add_round(&r, solution, slowest_adapted);
    }
    if (status == TAUT_OK) {
        describe(&r, r.count - 1, solution->details);
    }
    return status;
}
