/* biharmonic.c -- construct `biharmonic`: the surface with four given rows. The 4 n biharmonic
 * polynomials of bidegree (n, n) against the 4 n boundary points ([NiWang2015] section 8.4). */
#include "construct/biharmonic/biharmonic.h"

#include "construct/construct_ops.h"
#include "construct/harmonic/frame.h"
#include "construct/harmonic/rim.h"
#include "core/fail.h"

#include <string.h>

/* Past this the wider format, in which the rows are solved for, has few digits to spare; past this
 * degree it can't even tell how many. */
enum { DEGREE_MAX = 24 };
static const double amplification_limit = 1e11, amplification_warning = 5e6;

static taut_status check_pattern(const taut_biharmonic_problem *problem, taut_error *error)
{
    const int nu = taut_basis_count(problem->u), nv = taut_basis_count(problem->v);
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            const int edge = i == 0 || i == nu - 1 || j == 0 || j == nv - 1;
            if ((problem->known[i * nv + j] != 0) != edge) {
                return taut_fail(error, TAUT_BAD_INPUT, "value", "/points", taut_none, taut_none,
                                 "expected the four boundary rows, and null inside");
            }
        }
    }
    if (nu != nv) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution",
                         nu < nv ? "/u/degree" : "/v/degree", nu < nv ? nu - 1 : nv - 1,
                         nu < nv ? nv - 1 : nu - 1,
                         "four rows determine a biharmonic surface of one degree both ways, found "
                         "%d and %d: raise the lower one",
                         nu - 1, nv - 1);
    }
    return TAUT_OK;
}

static taut_status check_amplification(int degree, double amplification, taut_error *error)
{
    if (!(amplification <= amplification_limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/u/degree", amplification,
                         amplification_limit,
                         "rounding in four rows of degree %d would grow more than %.0e times: the "
                         "result would mean nothing (a lower degree is better)",
                         degree, amplification_limit);
    }
    return TAUT_OK;
}

/* The net in the user's coordinates, its rows as they were given. */
static taut_status solve(const taut_biharmonic_problem *problem, taut_arena *arena, double *net,
                         double *amplification, taut_error *error)
{
    const int n = taut_basis_degree(problem->u);
    const size_t points = (size_t)(n + 1) * (size_t)(n + 1);
    const double across = taut_basis_hi(problem->u) - taut_basis_lo(problem->u);
    const double along = taut_basis_hi(problem->v) - taut_basis_lo(problem->v);
    const taut_frame frame = taut_frame_of(points, problem->points, problem->known);
    taut_space space;
    taut_rim boundary;
    taut_wide *scratch = NULL;
    taut_status status = TAUT_OK;

    if (n > DEGREE_MAX) {
        return check_amplification(n, 2 * amplification_limit, error);
    }
    if (!taut_space_biharmonic(n, across, along, arena, &space) ||
        !taut_rim_solve(&space, arena, &boundary)) {
        return taut_fail_memory(error);
    }
    *amplification = taut_rim_amplification(&boundary);
    status = check_amplification(n, *amplification, error);
    if (status != TAUT_OK) {
        return status;
    }
    scratch = taut_arena_take(arena, 3 * ((size_t)(8 * n) + points), sizeof *scratch);
    if (scratch == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(net, problem->points, 3 * points * sizeof(double));
    taut_frame_enter(&frame, points, net);
    taut_rim_net(&boundary, net, scratch, net);
    taut_frame_leave(&frame, points, net);
    for (size_t k = 0; k < points; k++) {
        if (problem->known[k]) {
            memcpy(net + 3 * k, problem->points + 3 * k, 3 * sizeof(double));
        }
    }
    return TAUT_OK;
}

void taut_biharmonic_tell(double amplification, taut_record *details)
{
    taut_record_add_number(details, "amplification", amplification);
    if (!(amplification < amplification_warning)) {
        taut_record_add_text(
            taut_record_add_list(details, "warnings"), NULL,
            "rounding in the data grows by the amplification: expect few true digits");
    }
}

taut_status taut_biharmonic_rows(const taut_biharmonic_problem *problem, taut_arena *arena,
                                 taut_model *model, taut_error *error)
{
    const size_t points =
        (size_t)taut_basis_count(problem->u) * (size_t)taut_basis_count(problem->v);
    double *net = taut_arena_take(arena, 3 * points, sizeof(double));
    taut_record *details = NULL;
    taut_surface *surface = NULL;
    double amplification = 0;
    taut_status status = net != NULL ? check_pattern(problem, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = solve(problem, arena, net, &amplification, error);
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(problem->name != NULL ? problem->name : "biharmonic", problem->u,
                                  problem->v, net, NULL, &surface, error);
    }
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        details = taut_record_new();
        taut_biharmonic_tell(amplification, details);
        taut_model_set_details(model, details);
        status = taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    return status;
}

static taut_status check_problem(const taut_biharmonic_problem *problem, taut_error *error)
{
    if (problem == NULL ||
        (problem->surface == NULL && (problem->u == NULL || problem->v == NULL ||
                                      problem->points == NULL || problem->known == NULL))) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a biharmonic problem needs two bases and points, or a surface");
    }
    if (problem->surface == NULL && (strcmp(taut_basis_type(problem->u), "bezier") != 0 ||
                                     strcmp(taut_basis_type(problem->v), "bezier") != 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value",
                         strcmp(taut_basis_type(problem->u), "bezier") != 0 ? "/u" : "/v",
                         taut_none, taut_none, "expected a basis of type \"bezier\"");
    }
    if (problem->surface != NULL && problem->contact != 1 && problem->contact != 2) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/contact", problem->contact, 2,
                         "contact of order %d, expected 1 or 2", problem->contact);
    }
    return TAUT_OK;
}

taut_status taut_biharmonic_make(const taut_biharmonic_problem *problem,
                                 const taut_make_options *options, taut_model **model,
                                 taut_error *error)
{
    taut_arena *arena = NULL;
    taut_model *made = NULL;
    taut_status status = check_problem(problem, error);

    (void)options; /* exact to rounding, and quick */
    if (status != TAUT_OK) {
        return status;
    }
    arena = taut_arena_new();
    status = arena != NULL && taut_model_new(&made) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = problem->surface != NULL ? taut_biharmonic_neighbour(problem, arena, made, error)
                                          : taut_biharmonic_rows(problem, arena, made, error);
    }
    taut_arena_free(arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_biharmonic_make(data, options, model, error);
}

const taut_construct_ops taut_construct_biharmonic = {.make = make};
