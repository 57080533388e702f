/* asymptotic.c -- the problem `asymptotic`: corner data or four curves (docs/format.md).
 */
#include "taut/asymptotic.h"
#include "core/fail.h"
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

static void read_points(taut_reader *document, taut_asymptotic_corners *corners)
{
    const taut_json at = taut_json_member(document->object, "corners");
    taut_reader in = taut_reader_inside(document, &at, corner_members);

    for (int c = 0; c < 4; c++) {
        taut_reader_numbers(&in, corner_members[c], 3, corners->points[c]);
    }
    document->status = in.status;
}

static taut_status read_leg(const taut_json *at, void *leg, taut_error *error)
{
    return taut_json_numbers(at, 3, leg, error);
}

static taut_status refuse_curvature(const taut_json *at, void *unused, taut_error *error)
{
    (void)unused;
    return taut_json_fail(at, error, "conflict", taut_none, taut_none,
                          "degree 3 takes no curvature: legs and weights determine it");
}

/* Of degree 3 there is one leg, no curvature, and every weight. */
static taut_status read_edge(const taut_json *at, int degree, taut_asymptotic_edge *data,
                             taut_error *error)
{
    taut_reader in = taut_reader_of(at, edge_data, error);

    taut_reader_items(&in, "legs", degree == 3 ? 1 : 2, "legs", read_leg, data->legs,
                      sizeof data->legs[0]);
    if (degree > 3) {
        taut_reader_numbers(&in, "curvature", 2, data->curvature);
    } else {
        taut_reader_optional(&in, "curvature", refuse_curvature, NULL);
    }
    taut_reader_numbers(&in, "weights", degree == 3 ? 4 : 2, data->weights);
    return in.status;
}

/* degree, corners, edges */
static void read_corners(taut_reader *document, taut_asymptotic_corners *corners)
{
    const taut_json edges = taut_json_member(document->object, "edges");

    taut_reader_integer(document, "degree", 3, TAUT_ASYMPTOTIC_DEGREE_MAX, &corners->degree);
    read_points(document, corners);
    document->status = taut_reader_inside(document, &edges, edge_members).status;
    for (int e = 0; e < 4 && document->status == TAUT_OK; e++) {
        const taut_json edge = taut_json_member(&edges, edge_members[e]);
        document->status = read_edge(&edge, corners->degree, &corners->edges[e], document->error);
    }
}

static void read_curves(taut_reader *document, taut_arena *arena, const taut_curve *curves[4])
{
    static const char *const strangers[] = {"degree", "corners", "edges", "branch", NULL};
    const taut_json at = taut_json_member(document->object, "curves");
    taut_reader in = taut_reader_inside(document, &at, edge_members);

    document->status = in.status;
    taut_member_refuse(
        document, strangers,
        "beside \"curves\": curves that are given say all there is to say of the boundary");
    in.status = document->status;
    for (int e = 0; e < 4; e++) {
        taut_member_curve(&in, edge_members[e], arena, &curves[e]);
    }
    document->status = in.status;
}

/* The four curves out of a file, each under its name. */
static void read_boundary(taut_reader *document, taut_problem *problem, const taut_curve *curves[4])
{
    static const char *const others[] = {"degree", "corners", "edges", "curves", "branch", NULL};
    const taut_curve *sides[TAUT_SIDES] = {NULL, NULL, NULL, NULL};

    taut_boundary_document_bezier(document, problem, others, 1, sides);
    curves[TAUT_ASYMPTOTIC_U0] = sides[TAUT_SIDE_U0];
    curves[TAUT_ASYMPTOTIC_U1] = sides[TAUT_SIDE_U1];
    curves[TAUT_ASYMPTOTIC_V0] = sides[TAUT_SIDE_V0];
    curves[TAUT_ASYMPTOTIC_V1] = sides[TAUT_SIDE_V1];
}

/* "lowest", or the signs of v0, v1, u0, u1 such as "+-+-", 0 for a straight edge. */
static taut_status read_branch(const taut_json *at, void *into, taut_error *error)
{
    static const int order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                 TAUT_ASYMPTOTIC_U1};
    taut_asymptotic_corners *const corners = into;
    const char *text = NULL;
    const taut_status status = taut_json_text(at, &text, error);

    if (text == NULL || strcmp(text, "lowest") == 0) {
        return status;
    }
    if (strlen(text) != 4 || strspn(text, "+-0") != 4) {
        return taut_json_expected(
            at, error, "\"lowest\", or four of +, - and 0 (the sides of v0, v1, u0, u1)");
    }
    corners->has_branch = 1;
    for (int k = 0; k < 4; k++) {
        corners->branch[order[k]] = text[k] == '+' ? 1 : text[k] == '-' ? -1 : 0;
    }
    return TAUT_OK;
}

static void asymptotic_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_asymptotic_problem *const data = into;
    taut_asymptotic_corners corners = {.has_branch = 0};
    int surface = 0;

    taut_reader_optional_word(document, "surface", surface_words, &surface);
    data->surface = surface == 1 ? TAUT_BIDEGREE_N_PLUS_3 : TAUT_BIDEGREE_5N_MINUS_7;
    taut_reader_optional_word(document, "singular", singular_words, &data->report_singular);
    taut_reader_optional_word(document, "free", free_words, &data->free_all);
    taut_reader_optional(document, "branch", read_branch, &corners);
    data->given = TAUT_ASYMPTOTIC_CURVES;
    if (taut_boundary_document_is(document)) {
        read_boundary(document, problem, data->curves);
    } else if (taut_reader_has(document, "curves")) {
        read_curves(document, problem->arena, data->curves);
    } else {
        read_corners(document, &corners);
        data->given = TAUT_ASYMPTOTIC_CORNERS;
        data->corners = corners;
    }
}

const taut_document_ops taut_document_asymptotic = {
    .members = members,
    .size = sizeof(taut_asymptotic_problem),
    .read = asymptotic_read,
};
