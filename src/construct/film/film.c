/* film.c -- the construction `film`.
 *
 *     1. check the data
 *     2. corners, held edges, the start (construct/film/space.h)
 *     3. flat sails that are none are refused (construct/film/flat.h)
 *     4. Newton steps to the least energy (construct/film/solve.h)
 *     5. the surface, and each cable as a curve: the row of points at its edge, bit for bit
 */
#include "taut/film.h"

#include "construct/common/build.h"
#include "construct/construct_ops.h"
#include "construct/film/complex/complex.h"
#include "construct/film/draft.h"
#include "construct/film/edges.h"
#include "construct/film/flat.h"
#include "construct/film/images.h"
#include "construct/film/order.h"
#include "construct/film/refine.h"
#include "construct/film/ring.h"
#include "construct/film/solve.h"
#include "construct/film/threads.h"
#include "construct/film/witness.h"
#include "construct/plateau/witness.h"
#include "core/fail.h"
#include "core/pace.h"
#include "core/vec3.h"
#include "problem/film_complex.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double parallel = 1e-9; /* sine: below it two directions are one */
static const double tolerance_least = 1e-14, tolerance_most = 1e-3;

/* Is an inner knot repeated so often that nothing but the energy keeps the film from a crease? */
static int has_crease(const taut_basis *basis)
{
    const int p = taut_basis_degree(basis), n = taut_basis_count(basis);
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    for (int k = p + 1; spec.knots != NULL && k + p - 1 < n; k++) {
        if (spec.knots[k] == spec.knots[k + p - 1]) {
            return 1;
        }
    }
    return 0;
}

static taut_status check_basis(const taut_basis *basis, const char *where, taut_error *error)
{
    const char *type = taut_basis_type(basis);
    const int degree = taut_basis_degree(basis);
    if ((strcmp(type, "bezier") != 0 && strcmp(type, "bspline") != 0) || degree < 2) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "basis", where, taut_none,
                                  "bezier or bspline of degree 2 or more",
                                  "found a basis of type \"%s\" and degree %d", type, degree);
    }
    if (has_crease(basis)) {
        return taut_fail_expected(
            error, TAUT_BAD_INPUT, "basis", where, degree,
            "inner knots that are repeated less often",
            "found a knot repeated as often as the degree, %d, where the film "
            "could crease",
            degree);
    }
    return TAUT_OK;
}

static taut_status check_number(double value, double least, double most, const char *where,
                                taut_error *error)
{
    if (!(value >= least && value <= most)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, value, value < least ? least : most,
                         "found %.17g, expected a number from %.3g to %.3g", value, least, most);
    }
    return TAUT_OK;
}

static taut_status check_positive(double value, const char *member, int e, double most,
                                  taut_error *error)
{
    char where[48];

    if (value > 0 && value < most) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/edges/%s/cable/%s", taut_film_edge_names[e], member);
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, value, value > 0 ? most : 0,
                     "the %s of cable %s is %.17g, expected a number above 0%s", member,
                     taut_film_edge_names[e], value, isfinite(most) ? " and below 1/2" : "");
}

static taut_status check_law(const taut_film_edge *edge, int e, taut_error *error)
{
    switch (edge->law) {
    case TAUT_FILM_FORCE:
        return check_positive(edge->force, "force", e, INFINITY, error);
    case TAUT_FILM_LENGTH:
        return check_positive(edge->length, "length", e, INFINITY, error);
    case TAUT_FILM_SAG:
        return check_positive(edge->sag, "sag", e, 0.5, error);
    case TAUT_FILM_ELASTIC: {
        const taut_status status =
            check_positive(edge->unstressed, "unstressed", e, INFINITY, error);
        return status == TAUT_OK ? check_positive(edge->stiffness, "stiffness", e, INFINITY, error)
                                 : status;
    }
    }
    return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                     "cable %s has no law", taut_film_edge_names[e]);
}

static taut_status check_guide(const taut_film_guide *guide, const char *where, taut_error *error)
{
    const double size = taut_norm(guide->direction), from = taut_norm(guide->point);

    if (size > 0 && isfinite(size) && isfinite(from)) {
        return TAUT_OK;
    }
    return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, size,
                              "a finite point, and a direction of a length above 0",
                              "found a direction of length %.3g", size);
}

static int moves(const taut_film_problem *problem, int e, int end)
{
    return problem->corner_kinds[taut_film_corner_of(e, end)] != TAUT_FILM_HELD;
}

static taut_status check_edge(const taut_film_problem *problem, int e, taut_error *error)
{
    const taut_film_edge *edge = &problem->edges[e];
    const int is_seam = !taut_film_has_edge(problem, e);
    char where[32];
    taut_status status = TAUT_OK;

    snprintf(where, sizeof where, "/edges/%s", taut_film_edge_names[e]);
    if (is_seam && (edge->kind != TAUT_FILM_FIXED || edge->curve != NULL)) {
        return taut_fail(error, TAUT_BAD_INPUT, "edge-conflict", where, taut_none, taut_none,
                         "edge %s is in a seam, and held or drawn too: leave out one of them",
                         taut_film_edge_names[e]);
    }
    if (taut_film_has_plane(edge)) {
        status = check_guide(&edge->plane, where, error);
    }
    if (status != TAUT_OK || edge->kind == TAUT_FILM_FIXED) {
        return status;
    }
    if (edge->kind < TAUT_FILM_FIXED || edge->kind > TAUT_FILM_POLE || edge->curve != NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "edge %s has a curve and is not fixed, or is of no kind",
                         taut_film_edge_names[e]);
    }
    if (edge->kind == TAUT_FILM_CABLE && edge->law == TAUT_FILM_SAG &&
        (problem->ring != TAUT_FILM_OPEN || moves(problem, e, 0) || moves(problem, e, 1))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, edge->sag, taut_none,
                         "cable %s %s, and has no chord to sag from: give its length or force",
                         taut_film_edge_names[e],
                         problem->ring != TAUT_FILM_OPEN ? "closes" : "has an end that moves");
    }
    return edge->kind == TAUT_FILM_CABLE ? check_law(edge, e, error) : TAUT_OK;
}

/* Corners of rings are none, and those of a straight edge are held. */
static taut_status check_moving(const taut_film_problem *problem, int c, taut_error *error)
{
    const taut_film_edge *edges[2] = {&problem->edges[c % 2], &problem->edges[2 + c / 2]};
    char where[32];

    snprintf(where, sizeof where, "/corners/%s", taut_film_corner_names[c]);
    if (problem->ring != TAUT_FILM_OPEN &&
        (problem->has_corner[c] || problem->corner_kinds[c] != TAUT_FILM_HELD)) {
        return taut_fail(error, TAUT_BAD_INPUT, "corner-conflict", where, taut_none, taut_none,
                         "corner %s is given, and the film goes around there: leave it out",
                         taut_film_corner_names[c]);
    }
    if (problem->corner_kinds[c] == TAUT_FILM_HELD) {
        return TAUT_OK;
    }
    if (edges[0]->kind == TAUT_FILM_FIXED || edges[1]->kind == TAUT_FILM_FIXED) {
        return taut_fail(error, TAUT_BAD_INPUT, "corner-conflict", where, taut_none, taut_none,
                         "corner %s moves, and an edge that is held ends there: hold the corner",
                         taut_film_corner_names[c]);
    }
    if (problem->corner_kinds[c] != TAUT_FILM_FREE) {
        return check_guide(&problem->guides[c], where, error);
    }
    if (edges[0]->kind == TAUT_FILM_CABLE && edges[1]->kind == TAUT_FILM_CABLE) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "no-corner", where, taut_none, taut_none,
            "corner %s has no place, so the two cables that meet in it draw it straight, and it is "
            "none: hold it (\"%s\": [x, y, z]), or keep it on a line or in a plane",
            taut_film_corner_names[c], taut_film_corner_names[c]);
    }
    return TAUT_OK;
}

/* One direction more that something is held along: the part across those that are there. */
static void add_hold(const double direction[3], double holds[3][3], int *count)
{
    double x[3] = {direction[0], direction[1], direction[2]};
    const double whole = taut_norm(x);

    for (int k = 0; k < *count; k++) {
        taut_add_scaled(-taut_dot(x, holds[k]), holds[k], x);
    }
    const double size = taut_norm(x);
    for (int c = 0; *count < 3 && size > parallel * whole && c < 3; c++) {
        holds[*count][c] = x[c] / size;
    }
    *count += *count < 3 && size > parallel * whole;
}

/* Of a line the two across it. */
static void add_line(const double direction[3], double holds[3][3], int *count)
{
    for (int c = 0; c < 3; c++) {
        const double axis[3] = {c == 0, c == 1, c == 2};
        double across[3];
        taut_cross(direction, axis, across);
        if (taut_norm(across) > 0.1 * taut_norm(direction)) {
            add_hold(across, holds, count);
        }
    }
}

/* Do held points, lines and planes leave a translation? Nothing about a film is known where they do. */
static taut_status check_support(const taut_film_problem *problem, taut_error *error)
{
    double holds[3][3], free[3] = {1, 0, 0};
    int count = 0;

    for (int k = 0; k < 4; k++) {
        const taut_film_edge *edge = &problem->edges[k];
        if (problem->corner_kinds[k] == TAUT_FILM_HELD ||
            (taut_film_has_edge(problem, k) && edge->kind == TAUT_FILM_FIXED)) {
            return TAUT_OK;
        }
        if (taut_film_has_plane(edge)) {
            add_hold(edge->plane.direction, holds, &count);
        }
        if (problem->corner_kinds[k] == TAUT_FILM_ON_PLANE) {
            add_hold(problem->guides[k].direction, holds, &count);
        } else if (problem->corner_kinds[k] == TAUT_FILM_ON_LINE) {
            add_line(problem->guides[k].direction, holds, &count);
        }
    }
    if (count == 3) {
        return TAUT_OK;
    }
    for (int k = 0, none = count; k < 3 && count == none; k++) { /* an axis that is not held */
        const double axis[3] = {k == 0, k == 1, k == 2};
        add_hold(axis, holds, &count);
        memcpy(free, count > none ? holds[none] : free, sizeof free);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "floating", "/edges", count - 1, 3,
                     "nothing holds the film along (%.6g, %.6g, %.6g): hold a corner or an edge",
                     free[0], free[1], free[2]);
}

static taut_status check_ring(const taut_film_problem *problem, taut_error *error)
{
    const int along_u = problem->ring == TAUT_FILM_RING_U;
    const taut_basis *basis = along_u ? problem->u : problem->v;
    const int least = taut_loop_least(taut_basis_degree(basis)), count = taut_basis_count(basis);

    if (problem->ring == TAUT_FILM_OPEN) {
        return TAUT_OK;
    }
    if (strcmp(taut_basis_type(basis), "bspline") != 0) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "basis", along_u ? "/u" : "/v", taut_none,
                                  "a bspline", "found a basis of type \"%s\" that goes around",
                                  taut_basis_type(basis));
    }
    return count >= least
               ? TAUT_OK
               : taut_fail(error, TAUT_BAD_INPUT, "basis", along_u ? "/u" : "/v", count, least,
                           "%d points around, expected at least 2 degree + 1 = %d: give more",
                           count, least);
}

static taut_status check_corner(const taut_film_problem *problem, int c, taut_error *error)
{
    for (int k = 0; problem->has_corner[c] && k < 3; k++) {
        if (!isfinite(problem->corners[c][k])) {
            char where[32];
            snprintf(where, sizeof where, "/corners/%s/%d", taut_film_corner_names[c], k);
            return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, problem->corners[c][k],
                                      "a finite number", "found %.17g", problem->corners[c][k]);
        }
    }
    return TAUT_OK;
}

static double finer_count(const taut_basis *basis, int refine)
{
    return taut_basis_count(basis) + (ldexp(1, refine) - 1) * taut_basis_span_count(basis);
}

static taut_status check_refine(const taut_film_problem *problem, taut_error *error)
{
    const taut_status status =
        check_number(problem->refine, 1, TAUT_FILM_REFINE_MAX, "/refine", error);
    const double count =
        finer_count(problem->u, problem->refine) * finer_count(problem->v, problem->refine);

    if (status == TAUT_OK && count > TAUT_FILM_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/refine", count, TAUT_FILM_POINTS_MAX,
                         "refine is %d, and makes a net of %.0f points, expected at most %d",
                         problem->refine, count, TAUT_FILM_POINTS_MAX);
    }
    return status;
}

static taut_status check_options(const taut_film_problem *problem, taut_error *error)
{
    taut_status status = taut_film_threads_check(problem, error);

    if (status != TAUT_OK) {
        return status;
    }

    if (problem->tension != 0 && !(problem->tension > 0 && isfinite(problem->tension))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/tension", problem->tension, 0,
                         "the tension is %.17g, expected a positive number", problem->tension);
    }
    if (problem->tolerance != 0) {
        status =
            check_number(problem->tolerance, tolerance_least, tolerance_most, "/tolerance", error);
    }
    if (status == TAUT_OK && problem->max_iterations != 0) {
        status = check_number(problem->max_iterations, 1, 1e6, "/max_iterations", error);
    }
    if (status == TAUT_OK && problem->refine != 0) {
        status = check_refine(problem, error);
    }
    if (status == TAUT_OK && !(problem->equilibrium >= 0 && problem->equilibrium < 1)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/equilibrium", problem->equilibrium, 1,
                         "found %.17g, expected a number above 0 and below 1",
                         problem->equilibrium);
    }
    return status;
}

static taut_status check_problem(const taut_film_problem *problem, taut_error *error)
{
    if (problem == NULL || problem->u == NULL || problem->v == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a film problem needs two bases");
    }
    taut_status status = check_basis(problem->u, "/u", error);
    if (status == TAUT_OK) {
        status = check_basis(problem->v, "/v", error);
    }
    const double count =
        (double)taut_basis_count(problem->u) * (double)taut_basis_count(problem->v);
    if (status == TAUT_OK && count > TAUT_FILM_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/u", count, TAUT_FILM_POINTS_MAX,
                         "%.0f control points, expected at most %d: give fewer to u or v", count,
                         TAUT_FILM_POINTS_MAX);
    }
    for (int k = 0; status == TAUT_OK && k < 4; k++) {
        status = check_edge(problem, k, error);
    }
    if (status == TAUT_OK && problem->ring == TAUT_FILM_OPEN) {
        status = check_support(problem, error);
    }
    for (int k = 0; status == TAUT_OK && k < 4; k++) {
        status = check_corner(problem, k, error);
        status = status == TAUT_OK ? check_moving(problem, k, error) : status;
    }
    if (status == TAUT_OK) {
        status = check_ring(problem, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_images_check(problem, count, error);
    }
    return status == TAUT_OK ? check_options(problem, error) : status;
}

/* ---- the model ---- */

/* What the document need not say: the tension, and how edges are held of which it says nothing. */
static void describe_defaults(const taut_film_space *space, taut_record *details)
{
    const taut_film_problem *problem = space->problem;
    taut_record *straight = NULL;
    char note[200];

    for (int e = 0; e < 4 && problem->ring == TAUT_FILM_OPEN; e++) {
        if (problem->edges[e].kind == TAUT_FILM_FIXED && problem->edges[e].curve == NULL) {
            straight = straight != NULL ? straight : taut_record_add_list(details, "held_straight");
            taut_record_add_text(straight, NULL, taut_film_edge_names[e]);
        }
    }
    if (!taut_film_has_density(problem)) {
        taut_record_add_number(details, "tension", taut_film_tension(problem));
    }
    if (taut_film_order_note(problem, note, sizeof note)) {
        taut_record_add_text(taut_record_add_list(details, "notes"), NULL, note);
    }
}

static void describe_cables(const taut_film_space *space, const taut_film_solution *solution,
                            taut_record *details)
{
    taut_record *cables = taut_record_add_list(details, "cables");
    for (int e = 0; e < 4; e++) {
        if (space->ratios[e] > 0) {
            taut_record *cable = taut_record_add_object(cables, NULL);
            taut_record_add_text(cable, "edge", taut_film_edge_names[e]);
            taut_record_add_number(cable, "force", solution->forces[e]);
            taut_record_add_number(cable, "length", solution->lengths[e]);
            if (space->problem->edges[e].law == TAUT_FILM_ELASTIC) {
                taut_record_add_number(cable, "unstressed", space->problem->edges[e].unstressed);
            }
        }
    }
    taut_record *supports = taut_record_add_list(details, "supports");
    for (int c = 0; c < 4 && space->around == NULL; c++) {
        if (space->problem->corner_kinds[c] == TAUT_FILM_HELD) {
            taut_record_add_text(supports, NULL, taut_film_corner_names[c]);
        }
    }
}

static taut_record *details_of(const taut_film_space *space, const taut_film_solution *solution)
{
    taut_record *details = taut_record_new();
    const taut_film_problem *problem = space->problem;
    int fitted = 0;

    taut_record_add_number(details, "unknowns", 3 * (double)space->mask.unknowns);
    taut_record_add_number(details, "iterations", solution->iterations);
    taut_record_add_text(details, "method", solution->by_moves ? "normal" : "full");
    taut_record_add_text(details, "solver", solution->method);
    taut_record_add_number(details, "residual", solution->residual);
    describe_defaults(space, details);
    describe_cables(space, solution, details);
    taut_record *verdict = taut_record_add_object(details, "verdict");
    taut_record_add_text(verdict, "exists", "found");
    if (solution->negative > 0) {
        taut_record_add_bool(verdict, "stable", 0);
    } else {
        taut_record_add_text(verdict, "stable", "found");
    }
    const int is_beaten = solution->rival > 0 && solution->rival < solution->area;
    if (is_beaten) {
        taut_record_add_bool(verdict, "least", 0);
    } else {
        taut_record_add_null(verdict, "least");
    }
    taut_record *rivals = space->around != NULL ? taut_record_add_list(details, "rivals") : NULL;
    if (is_beaten) {
        taut_record *rival = taut_record_add_object(rivals, NULL);
        taut_record_add_text(rival, "kind", "discs");
        taut_record_add_number(rival, "area", solution->rival);
    }
    if (solution->changes != NULL) {
        taut_record_add_numbers(details, "updates", problem->updates, solution->changes);
    }
    for (int e = 0; e < 4; e++) {
        fitted += problem->edges[e].curve != NULL;
    }
    if (fitted > 0) {
        taut_record_add_number(details, "deviation", space->deviation);
    }
    return details;
}

static taut_status add_cable(const taut_film_space *space, int e, const double *points,
                             taut_arena *arena, taut_model *model, taut_error *error)
{
    const taut_basis *basis = e < 2 ? space->problem->v : space->problem->u;
    size_t first = 0, step = 0;
    int count = 0;
    taut_curve *curve = NULL;

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    double *row = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    if (row == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < count; k++) {
        memcpy(row + 3 * k, points + 3 * (first + (size_t)k * step), 3 * sizeof(double));
    }
    const taut_status status =
        taut_curve_new(taut_film_edge_names[e], basis, row, NULL, &curve, error);
    return status == TAUT_OK ? taut_construct_add_curve(model, curve, error) : status;
}

/* The surface, and each cable. */
static taut_status add_net(const taut_film_space *space, const taut_film_solution *solution,
                           taut_arena *arena, taut_model *model, taut_error *error)
{
    const taut_film_problem *problem = space->problem;
    taut_surface *surface = NULL;
    taut_status status =
        taut_surface_new(problem->name != NULL ? problem->name : "film", problem->u, problem->v,
                         solution->points, NULL, &surface, error);

    if (status == TAUT_OK) {
        status = taut_construct_add_surface(model, surface, error);
    }
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        if (space->ratios[e] > 0) {
            status = add_cable(space, e, solution->points, arena, model, error);
        }
    }
    return status;
}

/* What a make is given. */
typedef struct request {
    const taut_film_problem *problem;
    const taut_make_options *options;
    const taut_pace *pace;
} request;

/* The witness speaks of the surface as the model has it. */
static taut_status add_details(const request *r, const taut_film_space *space,
                               const taut_film_solution *solution, taut_model *model,
                               taut_error *error)
{
    const double tension = r->problem->tension > 0 ? r->problem->tension : 1;
    taut_record *details = details_of(space, solution);
    double radii[4];

    for (int e = 0; e < 4; e++) {
        radii[e] = space->ratios[e] > 0 ? solution->forces[e] / tension : 0;
    }
    const taut_surface *surface = taut_model_surface(model, 0);
    taut_status status = TAUT_OK;
    if (r->problem->refine > 0) {
        status =
            taut_film_refine(r->problem, surface, solution->energy, r->options, details, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_witness_add(r->problem, surface, radii, &r->options->monitor, details);
        status = status == TAUT_OK ? TAUT_OK : taut_plateau_witness_fail(status, error);
    }
    if (status == TAUT_OK || taut_pace_ends(r->pace, status, details)) {
        return taut_construct_set_details(model, details, error);
    }
    taut_record_free(details);
    return status;
}

static taut_status build(void *context, taut_arena *arena, taut_model *model, taut_error *error)
{
    const request *r = context;
    const taut_film_problem *problem = r->problem;
    taut_film_space space;
    taut_film_solution solution;
    taut_status status = taut_film_space_new(problem, arena, &space, error);

    if (status == TAUT_OK) {
        status = space.around != NULL ? taut_film_ring_cone(&space, error)
                                      : taut_film_flat_check(&space, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_solve(&space, r->options, arena, &solution, error);
    }
    if (status == TAUT_OK) {
        status = add_net(&space, &solution, arena, model, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_images_add(problem, arena, model, error);
    }
    return status == TAUT_OK ? add_details(r, &space, &solution, model, error) : status;
}

taut_status taut_film_make(const taut_film_problem *problem, const taut_make_options *options,
                           taut_model **model, taut_error *error)
{
    static const taut_make_options none;
    taut_pace pace;
    if (problem != NULL && taut_film_is_complex(problem)) {
        return taut_film_complex_make(problem, options, model, error);
    }
    const taut_status status = check_problem(problem, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_film_make needs a place for the model");
    }
    const taut_make_options own = taut_pace_options(&pace, options != NULL ? options : &none);
    request r = {.problem = problem, .options = &own, .pace = &pace};
    return taut_pace_end(&pace, taut_construct_build(build, &r, model, error), error);
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_film_make(data, options, model, error);
}

/* ---- drafts ---- */

typedef struct draft_request {
    const taut_film_problem *problem;
    const taut_model *before;
    int steps;
} draft_request;

/* What the cables of the film before drew with, as its details say; else 0. */
static void find_forces(const taut_model *before, double forces[4])
{
    const taut_record *details = taut_model_details(before);
    const taut_record *cables = details != NULL ? taut_record_get(details, "cables") : NULL;

    memset(forces, 0, 4 * sizeof *forces);
    for (size_t k = 0; cables != NULL && k < taut_record_count(cables); k++) {
        const taut_record *cable = taut_record_at(cables, k);
        const char *edge = taut_record_text(taut_record_get(cable, "edge"));
        for (int e = 0; e < 4; e++) {
            if (strcmp(edge, taut_film_edge_names[e]) == 0) {
                forces[e] = taut_record_number(taut_record_get(cable, "force"));
            }
        }
    }
}

static taut_status build_draft(void *context, taut_arena *arena, taut_model *model,
                               taut_error *error)
{
    const draft_request *r = context;
    const taut_surface *before = taut_model_surface(r->before, 0);
    taut_film_problem begun;
    taut_film_space space;
    taut_film_solution solution;
    double forces[4];

    find_forces(r->before, forces);
    if (taut_film_draft_begin(r->problem, before, arena, &begun) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_status status = taut_film_space_new(&begun, arena, &space, error);
    if (status == TAUT_OK) {
        status = taut_film_draft(&space, before, forces, r->steps, arena, &solution, error);
    }
    if (status == TAUT_OK) {
        status = add_net(&space, &solution, arena, model, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    taut_record *details = taut_record_new();
    describe_cables(&space, &solution, details);
    return taut_construct_set_details(model, details, error);
}

static taut_status draft(const void *data, const taut_model *before, int steps, taut_model **model,
                         taut_error *error)
{
    const taut_film_problem *problem = data;
    draft_request r = {.problem = problem, .before = before, .steps = steps};
    const taut_surface *surface = taut_model_surface(before, 0);

    if (!taut_film_has_draft(problem) || surface == NULL || taut_surface_weights(surface) != NULL ||
        !taut_basis_equal(taut_surface_u(surface), problem->u) ||
        !taut_basis_equal(taut_surface_v(surface), problem->v)) {
        return TAUT_OK;
    }
    const taut_status status = check_problem(problem, error);
    return status == TAUT_OK ? taut_construct_build(build_draft, &r, model, error) : status;
}

const taut_construct_ops taut_construct_film = {.make = make, .draft = draft, .ends_early = 1};
