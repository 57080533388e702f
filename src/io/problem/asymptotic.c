/* asymptotic.c -- the problem `asymptotic`: corner data or four curves (docs/format.md).
 */
#include "taut/asymptotic.h"
#include "core/fail.h"
#include "io/model/surface.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"

#include <string.h>

static const char *const members[] = {"degree",  "corners",  "edges", "curves",   "branch",
                                      "surface", "singular", "free",  "boundary", NULL};
static const char *const edge_members[] = {"v0", "u0", "v1", "u1", NULL};
static const char *const corner_members[] = {"u0v0", "u1v0", "u0v1", "u1v1", NULL};
static const char *const edge_data[] = {"legs", "curvature", "weights", NULL};
static const char *const surface_words[] = {"5n-7", "n+3", NULL};
static const char *const singular_words[] = {"refuse", "report", NULL};
static const char *const free_words[] = {"points", "all", NULL};

static taut_status read_points(const taut_json *document, taut_asymptotic_corners *corners,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, "corners");
    taut_status status = taut_json_object(&at, corner_members, error);
    for (int c = 0; c < 4 && status == TAUT_OK; c++) {
        const taut_json corner = taut_json_member(&at, corner_members[c]);
        status = taut_json_numbers(&corner, 3, corners->points[c], error);
    }
    return status;
}

/* The legs: two of them, or only the first for degree 3. */
static taut_status read_legs(const taut_json *edge, int degree, taut_asymptotic_edge *data,
                             taut_error *error)
{
    const taut_json at = taut_json_member(edge, "legs");
    const size_t wanted = degree == 3 ? 1 : 2;
    size_t count = 0;
    taut_status status = taut_json_array(&at, wanted, wanted, "legs", &count, error);
    for (size_t k = 0; k < wanted && status == TAUT_OK; k++) {
        const taut_json leg = taut_json_item(&at, k);
        status = taut_json_numbers(&leg, 3, data->legs[k], error);
    }
    return status;
}

static taut_status read_curvature(const taut_json *edge, int degree, taut_asymptotic_edge *data,
                                  taut_error *error)
{
    const taut_json at = taut_json_member(edge, "curvature");
    if (degree > 3) {
        return taut_json_numbers(&at, 2, data->curvature, error);
    }
    return at.value == NULL
               ? TAUT_OK
               : taut_json_fail(&at, error, "conflict", taut_none, taut_none,
                                "degree 3 takes no curvature: legs and weights determine it");
}

static taut_status read_edge(const taut_json *edge, int degree, taut_asymptotic_edge *data,
                             taut_error *error)
{
    const taut_json weights = taut_json_member(edge, "weights");
    taut_status status = taut_json_object(edge, edge_data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_legs(edge, degree, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_curvature(edge, degree, data, error);
    return status == TAUT_OK
               ? taut_json_numbers(&weights, degree == 3 ? 4 : 2, data->weights, error)
               : status;
}

/* degree, corners, edges */
static taut_status read_corners(const taut_json *document, taut_asymptotic_corners *corners,
                                taut_error *error)
{
    const taut_json degree = taut_json_member(document, "degree");
    const taut_json edges = taut_json_member(document, "edges");
    taut_status status =
        taut_json_integer(&degree, 3, TAUT_ASYMPTOTIC_DEGREE_MAX, &corners->degree, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_points(document, corners, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_object(&edges, edge_members, error);
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        const taut_json edge = taut_json_member(&edges, edge_members[e]);
        status = read_edge(&edge, corners->degree, &corners->edges[e], error);
    }
    return status;
}

static void release_curve(void *curve)
{
    taut_curve_free(curve);
}

static taut_status read_curves(const taut_json *document, taut_arena *arena,
                               const taut_curve *curves[4], taut_error *error)
{
    static const char *const strangers[] = {"degree", "corners", "edges", "branch", NULL};
    const taut_json at = taut_json_member(document, "curves");
    taut_status status = taut_json_object(&at, edge_members, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_refuse(
        document, strangers,
        "beside \"curves\": curves that are given say all there is to say of the boundary", error);
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        const taut_json curve = taut_json_member(&at, edge_members[e]);
        taut_curve *made = NULL;
        status = taut_curve_document_read(&curve, &made, error);
        if (status == TAUT_OK && !taut_arena_keep(arena, made, release_curve)) {
            return taut_fail_memory(error);
        }
        curves[e] = made;
    }
    return status;
}

/* The four curves out of a file, each under its name. */
static taut_status read_boundary(const taut_json *document, taut_problem *problem,
                                 const taut_curve *curves[4], taut_error *error)
{
    static const char *const others[] = {"degree", "corners", "edges", "curves", "branch", NULL};
    const taut_curve *sides[TAUT_SIDES];
    const taut_status status =
        taut_boundary_document_bezier(document, problem, others, 1, sides, error);
    if (status != TAUT_OK) {
        return status;
    }
    curves[TAUT_ASYMPTOTIC_U0] = sides[TAUT_SIDE_U0];
    curves[TAUT_ASYMPTOTIC_U1] = sides[TAUT_SIDE_U1];
    curves[TAUT_ASYMPTOTIC_V0] = sides[TAUT_SIDE_V0];
    curves[TAUT_ASYMPTOTIC_V1] = sides[TAUT_SIDE_V1];
    return TAUT_OK;
}

/* "lowest", or the signs of v0, v1, u0, u1 such as "+-+-", 0 for a straight edge. */
static taut_status read_branch(const taut_json *document, taut_asymptotic_corners *corners,
                               taut_error *error)
{
    static const int order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                 TAUT_ASYMPTOTIC_U1};
    const taut_json at = taut_json_member(document, "branch");
    const char *text = NULL;
    taut_status status = at.value == NULL ? TAUT_OK : taut_json_text(&at, &text, error);
    if (text == NULL || strcmp(text, "lowest") == 0) {
        return status;
    }
    if (strlen(text) != 4 || strspn(text, "+-0") != 4) {
        return taut_json_expected(
            &at, error, "\"lowest\", or four of +, - and 0 (the sides of v0, v1, u0, u1)");
    }
    corners->has_branch = 1;
    for (int k = 0; k < 4; k++) {
        corners->branch[order[k]] = text[k] == '+' ? 1 : text[k] == '-' ? -1 : 0;
    }
    return TAUT_OK;
}

static taut_status read_choices(const taut_json *document, taut_asymptotic_problem *data,
                                taut_error *error)
{
    int surface = TAUT_BIDEGREE_5N_MINUS_7;
    taut_status status = taut_member_word(document, "surface", surface_words, &surface, error);
    if (status != TAUT_OK) {
        return status;
    }
    data->surface = surface == 1 ? TAUT_BIDEGREE_N_PLUS_3 : TAUT_BIDEGREE_5N_MINUS_7;
    status = taut_member_word(document, "singular", singular_words, &data->report_singular, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_member_word(document, "free", free_words, &data->free_all, error);
}

static taut_status read_given(const taut_json *document, taut_problem *problem,
                              taut_asymptotic_problem *data, taut_error *error)
{
    taut_asymptotic_corners corners = {.has_branch = 0};
    taut_status status = read_branch(document, &corners, error);
    if (status != TAUT_OK) {
        return status;
    }
    data->given = TAUT_ASYMPTOTIC_CURVES;
    if (taut_boundary_document_is(document)) {
        return read_boundary(document, problem, data->curves, error);
    }
    if (taut_json_member(document, "curves").value != NULL) {
        return read_curves(document, problem->arena, data->curves, error);
    }
    status = read_corners(document, &corners, error);
    data->given = TAUT_ASYMPTOTIC_CORNERS;
    data->corners = corners;
    return status;
}

static taut_status asymptotic_read(const taut_json *document, taut_problem *problem,
                                   taut_error *error)
{
    taut_asymptotic_problem *const data = taut_arena_take(problem->arena, 1, sizeof *data);
    taut_status status = TAUT_OK;
    if (data == NULL) {
        return taut_fail_memory(error);
    }
    problem->data = data;
    status = read_choices(document, data, error);
    return status == TAUT_OK ? read_given(document, problem, data, error) : status;
}

const taut_document_ops taut_document_asymptotic = {
    .members = members,
    .read = asymptotic_read,
};
