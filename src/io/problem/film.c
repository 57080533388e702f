/* film.c -- the problem `film`: corners, edges that are held or drawn by cables (docs/format.md).
 *
 *     "corners": { "u0v0": [x, y, z], ... }       where no curve ends
 *     "edges":   { "u0": "fixed" | { "fixed": CURVE | SHAPE } | { "cable": LAW }, ... }
 *     SHAPE      { "arc": [P, Q, R] } | { "line": [P, R] }
 *     LAW        { "force": T } | { "length": L } | { "sag": f } | { "unstressed": L0, "stiffness": EA }
 *
 * Members and words that films will have are known by name and refused as not built yet, so that
 * nobody looks for a spelling mistake.
 */
#include "taut/film.h"

#include "core/fail.h"
#include "geometry/arc.h"
#include "geometry/keep.h"
#include "io/model/basis.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

#include <string.h>

enum { DEGREE = 4, COUNT = 12 };

static const char *const members[] = {
    "name",   "u",         "v",      "corners",        "edges",       "points",    "tension",
    "accept", "tolerance", "method", "max_iterations", "equilibrium", "least",     "patches",
    "curves", "boundary",  "degree", "count",          "seams",       "cables",    "cells",
    "images", "start",     "refine", "force_density",  "prestress",   "reference", "updates",
    NULL};
static const char *const not_yet[] = {
    "points",        "patches",   "curves",    "boundary", "degree", "count",
    "seams",         "cables",    "cells",     "images",   "start",  "refine",
    "force_density", "prestress", "reference", "updates",  NULL};
static const char *const corner_members[] = {"u0v0", "u1v0", "u0v1", "u1v1", NULL};
static const char *const edge_members[] = {"u0", "u1", "v0", "v1", NULL};
static const char *const kind_members[] = {"fixed",  "cable", "plane", "slide",
                                           "mirror", "pole",  NULL};
static const char *const kinds_not_yet[] = {"plane", "slide", "mirror", "pole", NULL};
static const char *const shape_members[] = {"circle", "arc", "line", NULL};
static const char *const shapes_not_yet[] = {"circle", NULL};
static const char *const law_members[] = {"force",      "length",    "sag",
                                          "unstressed", "stiffness", NULL};

static taut_status refuse_yet(const taut_json *at, const char *what, taut_error *error)
{
    return taut_json_fail(at, error, "not-yet", taut_none, taut_none,
                          "found %s, which films cannot have in this version: leave it out", what);
}

/* The first member of the list that is there. */
static void refuse_members(taut_reader *in, const char *const *list)
{
    for (int k = 0; in->status == TAUT_OK && list[k] != NULL; k++) {
        const taut_json at = taut_json_member(in->object, list[k]);
        if (at.value != NULL) {
            char what[64] = "\"";
            strncat(what, list[k], sizeof what - 3);
            strcat(what, "\"");
            in->status = refuse_yet(&at, what, in->error);
        }
    }
}

static taut_status read_positive(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    return status == TAUT_OK && !(*(double *)value > 0)
               ? taut_json_expected(at, error, "a positive number")
               : status;
}

static taut_status read_tolerance(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    const double found = *(double *)value;
    return status == TAUT_OK && !(found >= 1e-14 && found <= 1e-3)
               ? taut_json_expected(at, error, "a number from 1e-14 to 1e-3")
               : status;
}

static taut_status read_equilibrium(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    const double found = *(double *)value;
    return status == TAUT_OK && !(found > 0 && found < 1)
               ? taut_json_expected(at, error, "a number above 0 and below 1")
               : status;
}

/* A basis, or that of 12 points of degree 4 where there is none. */
static void read_basis(taut_reader *document, const char *key, taut_arena *arena,
                       const taut_basis **basis)
{
    const taut_basis_spec spec = {.type = "bspline", .degree = DEGREE, .count = COUNT};
    const taut_json at = taut_json_member(document->object, key);
    taut_basis *made = NULL;

    if (document->status != TAUT_OK) {
        return;
    }
    if (at.value != NULL) {
        document->status = taut_basis_document_keep(&at, 0, arena, basis, document->error);
        return;
    }
    document->status = taut_basis_new(&spec, COUNT, &made, document->error);
    if (document->status == TAUT_OK && !taut_keep_basis(arena, made)) {
        document->status = taut_fail_memory(document->error);
    }
    *basis = made;
}

static void read_corner(taut_reader *corners, const char *key, double corner[3],
                        unsigned char *is_there)
{
    const taut_json at = taut_json_member(corners->object, key);

    if (corners->status != TAUT_OK || at.value == NULL) {
        return;
    }
    const taut_json_kind kind = taut_json_kind_at(&at);
    if (kind == TAUT_JSON_NULL || kind == TAUT_JSON_OBJECT) {
        corners->status = refuse_yet(&at, "a corner that is free to move", corners->error);
        return;
    }
    corners->status = taut_net_document_point(&at, corner, corners->error);
    *is_there = 1;
}

static void read_corners(taut_reader *document, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "corners");

    if (at.value == NULL) {
        return;
    }
    taut_reader corners = taut_reader_inside(document, &at, corner_members);
    for (int c = 0; c < 4; c++) {
        read_corner(&corners, corner_members[c], data->corners[c], &data->has_corner[c]);
    }
    document->status = corners.status;
}

static taut_status read_sag(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    const double found = *(double *)value;
    return status == TAUT_OK && !(found > 0 && found < 0.5)
               ? taut_json_expected(at, error, "a number above 0 and below 1/2")
               : status;
}

/* Exactly one law: a force, a length, a sag, or an unstressed length with a stiffness. */
static void read_law(taut_reader *in, taut_film_edge *edge)
{
    const taut_json at = taut_json_member(in->object, "cable");
    taut_reader law = taut_reader_inside(in, &at, law_members);
    const int elastic = taut_reader_has(&law, "unstressed") || taut_reader_has(&law, "stiffness");
    const int laws = taut_reader_has(&law, "force") + taut_reader_has(&law, "length") +
                     taut_reader_has(&law, "sag") + elastic;

    if (law.status == TAUT_OK && laws != 1) {
        law.status = taut_json_fail(&at, law.error, laws == 0 ? "missing" : "conflict", laws, 1,
                                    "found %d laws of a cable, expected one: \"force\", "
                                    "\"length\", \"sag\", or \"unstressed\" with \"stiffness\"",
                                    laws);
    }
    if (elastic) {
        edge->law = TAUT_FILM_ELASTIC;
        taut_reader_member(&law, "unstressed", read_positive, &edge->unstressed);
        taut_reader_member(&law, "stiffness", read_positive, &edge->stiffness);
    } else if (taut_reader_has(&law, "length")) {
        edge->law = TAUT_FILM_LENGTH;
        taut_reader_member(&law, "length", read_positive, &edge->length);
    } else if (taut_reader_has(&law, "sag")) {
        edge->law = TAUT_FILM_SAG;
        taut_reader_member(&law, "sag", read_sag, &edge->sag);
    } else {
        taut_reader_member(&law, "force", read_positive, &edge->force);
    }
    in->status = law.status;
}

/* Points of a shape: `count` of them. */
static taut_status read_points(const taut_json *at, int count, double (*points)[3],
                               taut_error *error)
{
    if (taut_json_kind_at(at) != TAUT_JSON_ARRAY || taut_json_count_at(at) != (size_t)count) {
        return taut_json_refuse(at, error, "type",
                                count == 2 ? "two points" : "three points of the arc, in order");
    }
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        const taut_json item = taut_json_item(at, (size_t)k);
        status = taut_net_document_point(&item, points[k], error);
    }
    return status;
}

static taut_status make_line(const double points[2][3], taut_curve **curve)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 1};
    taut_basis *basis = NULL;
    taut_status status = taut_basis_new(&spec, 2, &basis, NULL);

    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, points[0], NULL, curve, NULL);
    }
    taut_basis_free(basis);
    return status;
}

static taut_status refuse_arc(const taut_json *at, taut_error *error)
{
    return taut_json_fail(at, error, "value", taut_none, taut_none,
                          "found three points that no arc runs through, expected three that are "
                          "apart and not on one line: give a \"line\", or move the middle one");
}

/* { "arc": [P, Q, R] } or { "line": [P, R] }. */
static void read_shape(taut_reader *edge, const taut_json *at, taut_arena *arena,
                       const taut_curve **curve)
{
    taut_reader in = taut_reader_inside(edge, at, shape_members);
    const int is_arc = taut_reader_has(&in, "arc"), is_line = taut_reader_has(&in, "line");
    const taut_json where = taut_json_member(at, is_arc ? "arc" : "line");
    taut_curve *made = NULL;
    double points[3][3];

    refuse_members(&in, shapes_not_yet);
    if (in.status == TAUT_OK && is_arc + is_line != 1) {
        in.status = taut_json_fail(at, in.error, "conflict", 2, 1,
                                   "found both \"arc\" and \"line\", expected one");
    }
    if (in.status == TAUT_OK) {
        in.status = read_points(&where, is_arc ? 3 : 2, points, in.error);
    }
    if (in.status == TAUT_OK) {
        in.status = is_arc ? taut_arc_new((const double(*)[3])points, &made)
                           : make_line((const double(*)[3])points, &made);
        in.status = in.status == TAUT_NO_SOLUTION ? refuse_arc(&where, in.error)
                    : in.status != TAUT_OK || !taut_keep_curve(arena, made)
                        ? taut_fail_memory(in.error)
                        : TAUT_OK;
    }
    *curve = made;
    edge->status = in.status;
}

/* A curve, or a shape. */
static void read_fixed(taut_reader *edge, taut_arena *arena, const taut_curve **curve)
{
    const taut_json at = taut_json_member(edge->object, "fixed");
    int is_shape = 0;

    for (int k = 0; taut_json_kind_at(&at) == TAUT_JSON_OBJECT && shape_members[k] != NULL; k++) {
        is_shape += taut_json_member(&at, shape_members[k]).value != NULL;
    }
    if (edge->status == TAUT_OK && is_shape) {
        read_shape(edge, &at, arena, curve);
    } else {
        taut_member_curve(edge, "fixed", arena, curve);
    }
}

/* { "fixed": CURVE or SHAPE } or { "cable": LAW }. */
static void read_edge_object(taut_reader *edges, const taut_json *at, taut_arena *arena,
                             taut_film_edge *edge)
{
    taut_reader in = taut_reader_inside(edges, at, kind_members);

    refuse_members(&in, kinds_not_yet);
    const int fixed = taut_reader_has(&in, "fixed"), cable = taut_reader_has(&in, "cable");
    if (in.status == TAUT_OK && fixed + cable != 1) {
        in.status =
            taut_json_fail(at, in.error, fixed + cable == 0 ? "missing" : "conflict", fixed + cable,
                           1, "found %s of \"fixed\" and \"cable\", expected one",
                           fixed + cable == 0 ? "none" : "both");
    }
    if (fixed) {
        read_fixed(&in, arena, &edge->curve);
    } else if (cable) {
        edge->kind = TAUT_FILM_CABLE;
        read_law(&in, edge);
    }
    edges->status = in.status;
}

static void read_edge(taut_reader *edges, const char *key, taut_arena *arena, taut_film_edge *edge)
{
    const taut_json at = taut_json_member(edges->object, key);
    const char *text = taut_json_text_at(&at);

    if (edges->status != TAUT_OK || at.value == NULL) {
        return;
    }
    if (taut_json_kind_at(&at) == TAUT_JSON_OBJECT) {
        read_edge_object(edges, &at, arena, edge);
    } else if (text == NULL || strcmp(text, "fixed") != 0) {
        edges->status = taut_json_refuse(
            &at, edges->error, text != NULL ? "name" : "type",
            "\"fixed\", { \"fixed\": a curve } or { \"cable\": { \"force\": a number } }");
    }
}

static void read_edges(taut_reader *document, taut_arena *arena, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "edges");

    if (at.value == NULL) {
        return;
    }
    taut_reader edges = taut_reader_inside(document, &at, edge_members);
    for (int e = 0; e < 4; e++) {
        read_edge(&edges, edge_members[e], arena, &data->edges[e]);
    }
    document->status = edges.status;
}

static void read_words(taut_reader *document, taut_film_problem *data)
{
    static const char *const methods[] = {"full", "normal", NULL};
    static const char *const accepts[] = {"minimum", "stationary", NULL};
    const taut_json method = taut_json_member(document->object, "method");
    const taut_json accept = taut_json_member(document->object, "accept");
    int least = 1, word = 0;

    taut_reader_optional_word(document, "method", methods, &word);
    if (document->status == TAUT_OK && word != 0) {
        document->status = refuse_yet(&method, "the method \"normal\"", document->error);
    }
    word = 0;
    taut_reader_optional_word(document, "accept", accepts, &word);
    if (document->status == TAUT_OK && word != 0) {
        document->status = refuse_yet(&accept, "\"stationary\"", document->error);
    }
    if (taut_reader_has(document, "least")) {
        taut_reader_flag(document, "least", &least);
    }
    data->without_least = !least;
}

static void film_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_film_problem *const data = into;

    refuse_members(document, not_yet);
    taut_member_name(document, problem->arena, &data->name);
    read_basis(document, "u", problem->arena, &data->u);
    read_basis(document, "v", problem->arena, &data->v);
    read_corners(document, data);
    read_edges(document, problem->arena, data);
    taut_reader_optional(document, "tension", read_positive, &data->tension);
    taut_reader_optional(document, "tolerance", read_tolerance, &data->tolerance);
    taut_reader_optional_integer(document, "max_iterations", 1, 1000000, &data->max_iterations);
    taut_reader_optional(document, "equilibrium", read_equilibrium, &data->equilibrium);
    read_words(document, data);
}

const taut_document_ops taut_document_film = {
    .members = members,
    .size = sizeof(taut_film_problem),
    .read = film_read,
};
