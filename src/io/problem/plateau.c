/* plateau.c -- the problem `plateau`: a net with holes, and how to go about it
 * (docs/format.md). */
#include "taut/plateau.h"
#include "core/fail.h"
#include "io/model/basis.h"
#include "io/model/surface.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

#include <limits.h>
#include <string.h>

static const char *const members[] = {"name",           "u",       "v",      "points",
                                      "weights",        "curves",  "start",  "tolerance",
                                      "max_iterations", "method",  "refine", "tolerance_area",
                                      "boundary",       "degree",  "least",  "gap",
                                      "regular",        "through", NULL};
static const char *const edge_members[] = {"u0", "u1", "v0", "v1", NULL};

static taut_status read_tolerance(const taut_json *at, void *tolerance, taut_error *error)
{
    const taut_status status = taut_json_number(at, tolerance, error);
    const double found = *(double *)tolerance;
    return status == TAUT_OK && !(found > 0 && found < 1)
               ? taut_json_expected(at, error, "a number above 0 and below 1")
               : status;
}

static taut_status read_tolerance_area(const taut_json *at, void *tolerance, taut_error *error)
{
    const taut_status status = taut_json_number(at, tolerance, error);
    const double found = *(double *)tolerance;
    return status == TAUT_OK && !(found >= TAUT_PLATEAU_AREA_MIN && found < 1)
               ? taut_json_expected(at, error, "a number from 1e-11 on and below 1")
               : status;
}

static taut_status read_gap(const taut_json *at, void *gap, taut_error *error)
{
    const taut_status status = taut_json_number(at, gap, error);
    const double found = *(double *)gap;
    return status == TAUT_OK && !(found > TAUT_PLATEAU_GAP_MIN && found < 1)
               ? taut_json_expected(at, error, "a number above 1e-12 and below 1")
               : status;
}

static void read_options(taut_reader *document, taut_plateau_problem *data)
{
    static const char *const methods[] = {"full", "normal", NULL};
    int word = 0, least = 1;

    taut_reader_optional(document, "tolerance", read_tolerance, &data->tolerance);
    taut_reader_optional_integer(document, "max_iterations", 1, INT_MAX, &data->max_iterations);
    word = taut_reader_has(document, "through") ? 1 : 0; /* "full" folds around a point */
    taut_reader_optional_word(document, "method", methods, &word);
    const int is_file = taut_boundary_document_is(document);
    const int is_own =
        (is_file || taut_reader_has(document, "curves")) && /* a net of taut's choice */
        !taut_reader_has(document, "method");
    data->method = word == 1 ? TAUT_PLATEAU_NORMAL
                   : is_own  ? TAUT_PLATEAU_EITHER
                             : TAUT_PLATEAU_FULL;
    if (!is_file) { /* else it is a pair */
        taut_reader_optional_integer(document, "refine", 0, TAUT_PLATEAU_REFINE_MAX, &data->refine);
    }
    taut_reader_optional(document, "tolerance_area", read_tolerance_area, &data->tolerance_area);
    taut_reader_optional(document, "gap", read_gap, &data->gap);
    if (taut_reader_has(document, "least")) {
        taut_reader_flag(document, "least", &least);
    }
    data->without_least = !least;
    taut_member_regular(document, &data->net.regular);
}

/* The points of `start`, which must be a surface of the same net. */
static taut_status read_start(const taut_json *document, taut_arena *arena,
                              taut_plateau_problem *data, taut_error *error)
{
    const taut_json at = taut_json_member(document, "start");
    const size_t count =
        (size_t)taut_basis_count(data->net.u) * (size_t)taut_basis_count(data->net.v);
    taut_surface *surface = NULL;
    taut_status status = TAUT_OK;

    status = taut_surface_document_read(&at, &surface, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_basis_equal(taut_surface_u(surface), data->net.u) ||
        !taut_basis_equal(taut_surface_v(surface), data->net.v)) {
        status = taut_json_fail(&at, error, "conflict", taut_none, taut_none,
                                "found a surface of %d by %d points on other bases, expected the "
                                "bases of the problem, %d by %d points",
                                taut_basis_count(taut_surface_u(surface)),
                                taut_basis_count(taut_surface_v(surface)),
                                taut_basis_count(data->net.u), taut_basis_count(data->net.v));
    } else {
        data->start =
            taut_arena_copy(arena, taut_surface_points(surface), count, 3 * sizeof(double));
        status = data->start != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    taut_surface_free(surface);
    return status;
}

/* The bases that say how finely curves are fitted. */
static void read_bases(taut_reader *document, taut_arena *arena, taut_plateau_problem *data)
{
    const taut_json u = taut_json_member(document->object, "u");
    const taut_json v = taut_json_member(document->object, "v");
    if (document->status == TAUT_OK) {
        document->status = taut_basis_document_keep(&u, 0, arena, &data->net.u, document->error);
    }
    if (document->status == TAUT_OK) {
        document->status = taut_basis_document_keep(&v, 0, arena, &data->net.v, document->error);
    }
}

/* Do the bases leave a point to find, or curves that are on others than polynomials nothing better? */
static int is_enough(const taut_plateau_problem *data)
{
    int polynomial = 1;
    for (int e = 0; e < 4; e++) {
        polynomial &= taut_basis_degree(taut_curve_t(data->curves[e])) >= 1;
    }
    return !polynomial || (taut_basis_count(data->net.u) > 2 && taut_basis_count(data->net.v) > 2);
}

/* Four curves, in place of points, fitted to the bases; without these, or where they leave nothing to find, kept as they are and
 * with points to find between them. */
static void read_curves(taut_reader *document, taut_problem *problem, taut_plateau_problem *data)
{
    static const char *const apart[] = {"points", "weights", "start", NULL};
    const taut_json at = taut_json_member(document->object, "curves");
    const int has_bases = taut_reader_has(document, "u") || taut_reader_has(document, "v");
    taut_reader curves = taut_reader_inside(document, &at, edge_members);

    document->status = curves.status;
    taut_member_refuse(document, apart,
                       "beside \"curves\": curves that are given are the boundary");
    if (has_bases) {
        read_bases(document, problem->arena, data);
    }
    curves.status = document->status;
    for (int e = 0; e < 4; e++) {
        taut_member_curve(&curves, edge_members[e], problem->arena, &data->curves[e]);
    }
    document->status = curves.status;
    if (document->status == TAUT_OK && !(has_bases && is_enough(data))) {
        taut_boundary_document_curves(document, problem, data->curves, &data->net);
        memset(data->curves, 0, sizeof data->curves);
    }
}

static void plateau_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_plateau_problem *const data = into;

    read_options(document, data);
    taut_member_name(document, problem->arena, &data->net.name);
    if (taut_reader_has(document, "curves")) {
        read_curves(document, problem, data);
    } else {
        taut_boundary_document_net(document, problem, &data->net);
    }
    taut_net_document_through(document, problem->arena, &data->net);
    taut_net_document_check_bases(document, data->net.u, data->net.v);
    if (document->status == TAUT_OK && taut_reader_has(document, "start")) {
        document->status = read_start(document->object, problem->arena, data, document->error);
    }
}

const taut_document_ops taut_document_plateau = {
    .members = members,
    .size = sizeof(taut_plateau_problem),
    .read = plateau_read,
};
