/* film.c -- the problem `film`: corners, edges that are held or drawn by cables (docs/format.md).
 *
 *     "corners": { "u0v0": P | null | { "near": P } | { "line": LINE, "near": P } | { "plane": PLANE, "near": P }, ... }
 *     "edges":   { "u0": "fixed" | { "fixed": CURVE | SHAPE } | { "cable": LAW, "plane": PLANE }
 *                        | { "slide": PLANE } | { "mirror": PLANE } | { "pole": null }, ... }
 *     "seams":   [["u0", "u1"]]                   a film that goes around
 *     "points":  [[P | null, ..], ..]             in place of corners; "start": a model
 *     SHAPE      { "arc": [P, Q, R] } | { "line": [P, R] } | { "circle": { "center", "normal", "radius", "start" } }
 *     LINE       { "point": P, "direction": D }    PLANE  { "point": P, "normal": N }
 *     "cables":  [CABLE, ..]                      io/problem/film_along.h
 *     "images":  [IMAGE, ..]
 *     IMAGE      { "mirror": PLANE } | { "half_turn": LINE } | { "turn": LINE, "angle": t } | { "translate": V }; "count": k
 *     LAW        { "force": T } | { "length": L } | { "sag": f } | { "unstressed": L0, "stiffness": EA }
 */
#include "taut/film.h"

#include "core/fail.h"
#include "geometry/arc.h"
#include "geometry/keep.h"
#include "io/model/basis.h"
#include "io/model/surface.h"
#include "io/problem/document_ops.h"
#include "io/problem/film_along.h"
#include "io/problem/film_curves.h"
#include "io/problem/film_net.h"
#include "io/problem/film_patches.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

#include <stdio.h>
#include <string.h>

enum { DEGREE = 4, COUNT = 12, IMAGES = 64 };

/* Images that are being read. */
typedef struct image_list {
    taut_film_image *images;
    int count;
} image_list;

static const char *const members[] = {
    "name",          "u",         "v",         "corners",  "edges",          "points",
    "tension",       "accept",    "tolerance", "method",   "max_iterations", "equilibrium",
    "least",         "patches",   "curves",    "boundary", "degree",         "count",
    "seams",         "cables",    "cells",     "images",   "start",          "refine",
    "force_density", "prestress", "reference", "updates",  "through",        NULL};
static const char *const corner_members[] = {"u0v0", "u1v0", "u0v1", "u1v1", NULL};
static const char *const edge_members[] = {"u0", "u1", "v0", "v1", NULL};
static const char *const kind_members[] = {"fixed",  "cable", "plane", "slide",
                                           "mirror", "pole",  NULL};
static const char *const shape_members[] = {"circle", "arc", "line", NULL};
static const char *const circle_members[] = {"center", "normal", "radius", "start", NULL};
static const char *const plane_members[] = {"point", "normal", NULL};
static const char *const line_members[] = {"point", "direction", NULL};
static const char *const near_members[] = {"near", "line", "plane", NULL};
static const char *const image_members[] = {"mirror", "half_turn", "turn", "translate",
                                            "angle",  "count",     NULL};
static const char *const seam_members[] = {"edges", "cable", "plane", NULL};
static const char *const law_members[] = {"force",      "length",    "sag",
                                          "unstressed", "stiffness", NULL};

static taut_status refuse_yet(const taut_json *at, const char *what, taut_error *error)
{
    return taut_json_fail(at, error, "not-yet", taut_none, taut_none,
                          "found %s, which films cannot have in this version: leave it out", what);
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

static taut_status read_point(const taut_json *at, void *value, taut_error *error)
{
    return taut_net_document_point(at, value, error);
}

/* A line or a plane: a point of it and a direction. */
static void read_guide(taut_reader *in, const char *key, const char *const *names,
                       taut_film_guide *guide)
{
    const taut_json at = taut_json_member(in->object, key);
    taut_reader inside = taut_reader_inside(in, &at, names);

    taut_reader_member(&inside, names[0], read_point, guide->point);
    taut_reader_member(&inside, names[1], read_point, guide->direction);
    if (inside.status == TAUT_OK && guide->direction[0] == 0 && guide->direction[1] == 0 &&
        guide->direction[2] == 0) {
        const taut_json wrong = taut_json_member(&at, names[1]);
        inside.status = taut_json_expected(&wrong, inside.error, "a direction of a length above 0");
    }
    in->status = inside.status;
}

/* null, { "near": P }, { "line": LINE, "near": P } or { "plane": PLANE, "near": P }. */
static void read_moving(taut_reader *corners, const taut_json *at, int c, taut_film_problem *data)
{
    taut_film_corner_kind *kind = &data->corner_kinds[c];

    *kind = TAUT_FILM_FREE;
    if (taut_json_kind_at(at) == TAUT_JSON_NULL) {
        return;
    }
    taut_reader in = taut_reader_inside(corners, at, near_members);
    const int line = taut_reader_has(&in, "line"), plane = taut_reader_has(&in, "plane");
    if (in.status == TAUT_OK && line + plane == 2) {
        in.status = taut_json_fail(at, in.error, "conflict", 2, 1,
                                   "found both \"line\" and \"plane\", expected one");
    }
    if (line) {
        *kind = TAUT_FILM_ON_LINE;
        read_guide(&in, "line", line_members, &data->guides[c]);
    } else if (plane) {
        *kind = TAUT_FILM_ON_PLANE;
        read_guide(&in, "plane", plane_members, &data->guides[c]);
    }
    data->has_corner[c] = (unsigned char)taut_reader_has(&in, "near");
    if (data->has_corner[c]) {
        taut_reader_member(&in, "near", read_point, data->corners[c]);
    } else if (in.status == TAUT_OK && line + plane == 0) {
        in.status = taut_json_fail(at, in.error, "missing", 0, 1,
                                   "found none of \"near\", \"line\" and \"plane\"");
    }
    corners->status = in.status;
}

static void read_corner(taut_reader *corners, int c, taut_film_problem *data)
{
    const taut_json at = taut_json_member(corners->object, corner_members[c]);

    if (corners->status != TAUT_OK || at.value == NULL) {
        return;
    }
    const taut_json_kind kind = taut_json_kind_at(&at);
    if (kind == TAUT_JSON_NULL || kind == TAUT_JSON_OBJECT) {
        read_moving(corners, &at, c, data);
        return;
    }
    corners->status = taut_net_document_point(&at, data->corners[c], corners->error);
    data->has_corner[c] = 1;
}

static void read_corners(taut_reader *document, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "corners");

    if (at.value == NULL) {
        return;
    }
    taut_reader corners = taut_reader_inside(document, &at, corner_members);
    for (int c = 0; c < 4; c++) {
        read_corner(&corners, c, data);
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
static void read_law(taut_reader *law, const taut_json *at, taut_film_edge *edge)
{
    const int elastic = taut_reader_has(law, "unstressed") || taut_reader_has(law, "stiffness");
    const int laws = taut_reader_has(law, "force") + taut_reader_has(law, "length") +
                     taut_reader_has(law, "sag") + elastic;

    if (law->status == TAUT_OK && laws != 1) {
        law->status = taut_json_fail(at, law->error, laws == 0 ? "missing" : "conflict", laws, 1,
                                     "found %d laws of a cable, expected one: \"force\", "
                                     "\"length\", \"sag\", or \"unstressed\" with \"stiffness\"",
                                     laws);
    }
    edge->kind = TAUT_FILM_CABLE;
    if (elastic) {
        edge->law = TAUT_FILM_ELASTIC;
        taut_reader_member(law, "unstressed", read_positive, &edge->unstressed);
        taut_reader_member(law, "stiffness", read_positive, &edge->stiffness);
    } else if (taut_reader_has(law, "length")) {
        edge->law = TAUT_FILM_LENGTH;
        taut_reader_member(law, "length", read_positive, &edge->length);
    } else if (taut_reader_has(law, "sag")) {
        edge->law = TAUT_FILM_SAG;
        taut_reader_member(law, "sag", read_sag, &edge->sag);
    } else {
        taut_reader_member(law, "force", read_positive, &edge->force);
    }
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

/* { "center", "normal", "radius", "start" }. */
static void read_circle(taut_reader *shape, taut_curve **curve)
{
    const taut_json at = taut_json_member(shape->object, "circle");
    taut_reader in = taut_reader_inside(shape, &at, circle_members);
    double center[3], normal[3], start[3], radius = 0;
    const int starts = taut_reader_has(&in, "start");

    taut_reader_member(&in, "center", read_point, center);
    taut_reader_member(&in, "normal", read_point, normal);
    taut_reader_member(&in, "radius", read_positive, &radius);
    if (starts) {
        taut_reader_member(&in, "start", read_point, start);
    }
    if (in.status == TAUT_OK) {
        in.status = taut_circle_new(center, normal, radius, starts ? start : NULL, curve);
        in.status =
            in.status == TAUT_NO_SOLUTION
                ? taut_json_fail(&at, in.error, "value", taut_none, taut_none,
                                 "found a circle without a plane or a beginning, expected a "
                                 "\"normal\" of a length above 0 and a \"start\" that is not "
                                 "along it")
            : in.status != TAUT_OK ? taut_fail_memory(in.error)
                                   : TAUT_OK;
    }
    shape->status = in.status;
}

/* { "arc": [P, Q, R] }, { "line": [P, R] } or { "circle": .. }. */
static void read_shape(taut_reader *edge, const taut_json *at, taut_arena *arena,
                       const taut_curve **curve)
{
    taut_reader in = taut_reader_inside(edge, at, shape_members);
    const int is_arc = taut_reader_has(&in, "arc"), is_line = taut_reader_has(&in, "line"),
              is_circle = taut_reader_has(&in, "circle");
    const taut_json where = taut_json_member(at, is_arc ? "arc" : "line");
    taut_curve *made = NULL;
    double points[3][3];

    if (in.status == TAUT_OK && is_arc + is_line + is_circle != 1) {
        in.status = taut_json_fail(at, in.error, "conflict", is_arc + is_line + is_circle, 1,
                                   "found %d of \"arc\", \"line\" and \"circle\", expected one",
                                   is_arc + is_line + is_circle);
    }
    if (in.status == TAUT_OK && is_circle) {
        read_circle(&in, &made);
        in.status = in.status == TAUT_OK && !taut_keep_curve(arena, made)
                        ? taut_fail_memory(in.error)
                        : in.status;
        *curve = made;
        edge->status = in.status;
        return;
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
static void read_curve(taut_reader *document, const taut_json *at, taut_arena *arena,
                       const taut_curve **curve)
{
    taut_curve *read = NULL;
    int is_shape = 0;

    for (int k = 0; taut_json_kind_at(at) == TAUT_JSON_OBJECT && shape_members[k] != NULL; k++) {
        is_shape += taut_json_member(at, shape_members[k]).value != NULL;
    }
    if (document->status != TAUT_OK) {
        return;
    }
    if (is_shape) {
        read_shape(document, at, arena, curve);
        return;
    }
    document->status = taut_curve_document_read(at, &read, document->error);
    if (document->status == TAUT_OK && !taut_keep_curve(arena, read)) {
        document->status = taut_fail_memory(document->error);
    }
    *curve = read;
}

static void read_fixed(taut_reader *edge, taut_arena *arena, const taut_curve **curve)
{
    const taut_json at = taut_json_member(edge->object, "fixed");
    read_curve(edge, &at, arena, curve);
}

static const char no_support[] = "a point holds no film: use a ring, or cables that end there";

/* { "pole": null }, or where it is held, which its corners take (take_poles). */
static void read_pole(taut_reader *in, taut_film_edge *edge)
{
    const taut_json at = taut_json_member(in->object, "pole");

    edge->kind = TAUT_FILM_POLE;
    if (in->status == TAUT_OK && taut_json_kind_at(&at) != TAUT_JSON_NULL &&
        taut_json_kind_at(&at) != TAUT_JSON_ARRAY) {
        in->status = taut_json_refuse(&at, in->error, "type", "null or a point");
    }
}

static void read_cable(taut_reader *in, taut_film_edge *edge)
{
    const taut_json at = taut_json_member(in->object, "cable");
    if (in->status == TAUT_OK && taut_json_kind_at(&at) != TAUT_JSON_OBJECT) {
        in->status = taut_json_refuse(&at, in->error, "type", "a law, such as { \"force\": 2 }");
    }
    taut_reader law = taut_reader_inside(in, &at, law_members);

    edge->has_plane = (unsigned char)taut_reader_has(in, "plane");
    read_law(&law, &at, edge);
    in->status = law.status;
    if (edge->has_plane) {
        read_guide(in, "plane", plane_members, &edge->plane);
    }
}

/* What an edge is, by its member. */
static void read_kind(taut_reader *in, const char *kind, taut_arena *arena, taut_film_edge *edge)
{
    if (strcmp(kind, "fixed") == 0) {
        read_fixed(in, arena, &edge->curve);
    } else if (strcmp(kind, "cable") == 0) {
        read_cable(in, edge);
    } else if (strcmp(kind, "pole") == 0) {
        read_pole(in, edge);
    } else {
        edge->kind = TAUT_FILM_SLIDE;
        edge->is_mirror = strcmp(kind, "mirror") == 0;
        read_guide(in, kind, plane_members, &edge->plane);
    }
}

/* One of fixed, cable, slide, mirror and pole; a plane beside a cable. */
/* The law of a cable is inside "cable". */
static taut_status refuse_law(const taut_json *at, taut_error *error)
{
    for (int k = 0; law_members[k] != NULL; k++) {
        const taut_json law = taut_json_member(at, law_members[k]);
        if (law.value != NULL) {
            const taut_status status =
                taut_json_fail(&law, error, "unknown-member", taut_none, taut_none,
                               "\"%s\" is of a cable, and inside it: { \"cable\": { \"%s\": .. } }",
                               law_members[k], law_members[k]);
            if (error != NULL) {
                snprintf(error->expected, sizeof error->expected, "\"cable\"");
            }
            return status;
        }
    }
    return TAUT_OK;
}

static void read_edge_object(taut_reader *edges, const taut_json *at, taut_arena *arena,
                             taut_film_edge *edge)
{
    static const char *const kinds[] = {"fixed", "cable", "slide", "mirror", "pole", NULL};
    edges->status = edges->status == TAUT_OK ? refuse_law(at, edges->error) : edges->status;
    taut_reader in = taut_reader_inside(edges, at, kind_members);
    const char *kind = NULL;
    int count = 0;

    for (int k = 0; kinds[k] != NULL; k++) {
        if (taut_json_member(in.object, kinds[k]).value != NULL) {
            kind = kinds[k];
            count++;
        }
    }
    if (in.status == TAUT_OK && count != 1) {
        in.status = taut_json_fail(at, in.error, count == 0 ? "missing" : "conflict", count, 1,
                                   "found %d of \"fixed\", \"cable\", \"slide\", \"mirror\" and "
                                   "\"pole\", expected one",
                                   count);
    }
    if (in.status == TAUT_OK && taut_reader_has(&in, "plane") && strcmp(kind, "cable") != 0) {
        in.status =
            taut_json_fail(at, in.error, "conflict", 2, 1,
                           "found \"plane\" beside \"%s\", expected it beside \"cable\"", kind);
    }
    if (in.status == TAUT_OK) {
        read_kind(&in, kind, arena, edge);
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

/* path: /edges/e/pole. Its end where the pole of edge e is held, else NULL. */
static const taut_json *held_pole(const taut_reader *document, int e, taut_json path[3])
{
    path[0] = taut_json_member(document->object, "edges");
    path[1] = taut_json_member(&path[0], edge_members[e]);
    path[2] = taut_json_member(&path[1], "pole");
    return path[2].value != NULL && taut_json_kind_at(&path[2]) == TAUT_JSON_ARRAY ? &path[2]
                                                                                   : NULL;
}

/* Both corners of a pole that is held are where it is. */
static void take_poles(taut_reader *document, taut_film_problem *data)
{
    for (int k = 0; document->status == TAUT_OK && k < 8; k++) {
        const int e = k / 2, c = e < 2 ? e + 2 * (k % 2) : 2 * (e - 2) + k % 2;
        taut_json path[3];
        const taut_json *at = held_pole(document, e, path);
        double point[3];
        if (at == NULL) {
            continue;
        }
        document->status = taut_net_document_point(at, point, document->error);
        if (document->status == TAUT_OK &&
            (data->corner_kinds[c] != TAUT_FILM_HELD ||
             (data->has_corner[c] && memcmp(data->corners[c], point, sizeof point) != 0))) {
            document->status = taut_json_fail(
                at, document->error, "corner-conflict", taut_none, taut_none,
                "found a pole at one place and its corner %s elsewhere: leave out the corner",
                corner_members[c]);
        }
        data->has_corner[c] = 1;
        memcpy(data->corners[c], point, sizeof point);
    }
}

/* The edge that an item of a seam names, 0 to 3; 4 to 7: with a minus sign; -1: none. */
static int edge_named(const char *text)
{
    const int is_reversed = text != NULL && text[0] == '-';
    for (int e = 0; text != NULL && e < 4; e++) {
        if (strcmp(text + is_reversed, edge_members[e]) == 0) {
            return e + 4 * is_reversed;
        }
    }
    return -1;
}

/* ["u0", "u1"] or ["v0", "v1"], both run one way: *ring. */
static taut_status read_pair_of_edges(const taut_json *seam, taut_film_ring *ring,
                                      taut_error *error)
{
    if (taut_json_kind_at(seam) != TAUT_JSON_ARRAY || taut_json_count_at(seam) < 2) {
        return taut_json_refuse(seam, error, "type", "two names of edges");
    }
    if (taut_json_count_at(seam) > 2) {
        return refuse_yet(seam, "a seam of more than two edges", error);
    }
    const taut_json first = taut_json_item(seam, 0), second = taut_json_item(seam, 1);
    const int a = edge_named(taut_json_text_at(&first)), b = edge_named(taut_json_text_at(&second));
    if (a < 0 || b < 0 || (a ^ 1) != b) {
        return taut_json_fail(seam, error, "seam-mismatch", taut_none, taut_none,
                              "found a seam of edges that are not opposite ones, run alike: "
                              "expected [\"u0\", \"u1\"] or [\"v0\", \"v1\"]");
    }
    *ring = a % 4 < 2 ? TAUT_FILM_RING_U : TAUT_FILM_RING_V;
    return TAUT_OK;
}

/* A pair, or { "edges": pair }; a cable along it comes with patches. */
static taut_status read_seam(const taut_json *seam, taut_film_ring *ring, taut_error *error)
{
    if (taut_json_kind_at(seam) != TAUT_JSON_OBJECT) {
        return read_pair_of_edges(seam, ring, error);
    }
    const taut_status status = taut_json_object(seam, seam_members, error);
    const taut_json cable = taut_json_member(seam, "cable"),
                    edges = taut_json_member(seam, "edges");
    if (status == TAUT_OK && cable.value != NULL) {
        return refuse_yet(&cable, "a cable along a seam", error);
    }
    return status == TAUT_OK ? read_pair_of_edges(&edges, ring, error) : status;
}

/* [["u0", "u1"]] or [["v0", "v1"]]; both make a torus, which nothing holds. */
static void read_seams(taut_reader *document, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "seams");
    taut_film_ring rings[2] = {TAUT_FILM_OPEN, TAUT_FILM_OPEN};

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    if (taut_json_kind_at(&at) != TAUT_JSON_ARRAY || taut_json_count_at(&at) == 0) {
        document->status = taut_json_refuse(&at, document->error, "type", "a list of seams");
        return;
    }
    if (taut_json_count_at(&at) > 2) {
        document->status = refuse_yet(&at, "more than two seams", document->error);
        return;
    }
    for (size_t k = 0; k < taut_json_count_at(&at) && document->status == TAUT_OK; k++) {
        const taut_json seam = taut_json_item(&at, k);
        document->status = read_seam(&seam, &rings[k], document->error);
    }
    data->ring = rings[0];
    if (document->status != TAUT_OK || rings[1] == TAUT_FILM_OPEN) {
        return;
    }
    document->status =
        rings[0] == rings[1]
            ? taut_json_fail(&at, document->error, "edge-conflict", 2, 1,
                             "found an edge in two seams, expected one")
            : taut_film_document_none(&at, "floating",
                                      "a film that goes around both ways has no edge that holds "
                                      "it: leave out one of the seams",
                                      document->error);
}

static void read_words(taut_reader *document, taut_film_problem *data)
{
    static const char *const methods[] = {"full", "normal", NULL};
    static const char *const accepts[] = {"minimum", "stationary", NULL};
    int least = 1, word = 0;

    taut_reader_optional_word(document, "method", methods, &word);
    data->method = word == 1 ? TAUT_FILM_NORMAL : TAUT_FILM_FULL;
    taut_reader_optional_word(document, "accept", accepts, &data->accepts_stationary);
    if (taut_reader_has(document, "least")) {
        taut_reader_flag(document, "least", &least);
    }
    data->without_least = !least;
}

/* Two positive numbers. */
static void read_pair(taut_reader *document, const char *key, double pair[2])
{
    if (taut_reader_has(document, key)) {
        taut_reader_items(document, key, 2, "positive numbers, along u and v", read_positive, pair,
                          sizeof pair[0]);
    }
}

/* What draws the film along its threads in place of a tension. */
static void read_threads(taut_reader *document, taut_problem *problem, taut_film_problem *data)
{
    read_pair(document, "force_density", data->force_density);
    read_pair(document, "prestress", data->prestress);
    if (taut_reader_has(document, "reference")) {
        taut_member_surface(document, "reference", problem->arena, &data->reference);
    }
    taut_reader_optional_integer(document, "updates", 0, TAUT_FILM_UPDATES_MAX, &data->updates);
}

static void read_film_tension(taut_reader *patch, taut_film_problem *data)
{
    taut_reader_optional(patch, "tension", read_positive, &data->tension);
}

static void read_tension(taut_reader *patch, taut_problem *problem, taut_film_problem *data)
{
    read_film_tension(patch, data);
    read_threads(patch, problem, data);
}

/* A corner that nothing is said of is one that its edges draw, but at an end of one that is held. */
static void free_corners(const taut_reader *document, taut_film_problem *data)
{
    const taut_json corners = taut_json_member(document->object, "corners");

    for (int c = 0; c < 4 && data->ring == TAUT_FILM_OPEN; c++) {
        const int is_held = data->edges[c % 2].kind == TAUT_FILM_FIXED ||
                            data->edges[2 + c / 2].kind == TAUT_FILM_FIXED;
        if (!is_held && !data->has_corner[c] &&
            taut_json_member(&corners, corner_members[c]).value == NULL) {
            data->corner_kinds[c] = TAUT_FILM_FREE;
        }
    }
}

/* What may stand in the place of corners, and where the net begins. */
static void read_nets(taut_reader *document, taut_arena *arena, taut_film_problem *data)
{
    const taut_json edges = taut_json_member(document->object, "edges");
    unsigned char named[4];

    for (int e = 0; e < 4; e++) {
        named[e] = taut_json_member(&edges, edge_members[e]).value != NULL;
    }
    if (taut_reader_has(document, "points")) {
        taut_film_document_points(document, arena, named, data);
    } else if (document->status == TAUT_OK) {
        free_corners(document, data);
    }
    taut_film_document_start(document, arena, 1, data);
}

/* Names of patches stand before those of their edges, "NAME.u0", "-NAME.u0". */
static void check_name(taut_reader *document, const char *name)
{
    const taut_json at = taut_json_member(document->object, "name");

    if (document->status == TAUT_OK && name != NULL &&
        (name[0] == '-' || strchr(name, '.') != NULL)) {
        document->status = taut_json_refuse(&at, document->error, "name",
                                            "a name without \".\" that does not begin with \"-\"");
    }
}

static void read_one(taut_reader *patch, taut_problem *problem, taut_film_problem *data)
{
    taut_member_name(patch, problem->arena, &data->name);
    check_name(patch, data->name);
    read_basis(patch, "u", problem->arena, &data->u);
    read_basis(patch, "v", problem->arena, &data->v);
    read_corners(patch, data);
    read_edges(patch, problem->arena, data);
    take_poles(patch, data);
}

/* A pole of a ring has no corners to hold it by. */
static void check_poles(taut_reader *document, const taut_film_problem *data)
{
    for (int e = 0; document->status == TAUT_OK && data->ring != TAUT_FILM_OPEN && e < 4; e++) {
        taut_json path[3];
        const taut_json *at = held_pole(document, e, path);
        if (at != NULL) {
            document->status =
                taut_film_document_none(at, "point-support", no_support, document->error);
        }
    }
}

/* What goes around is no edge, and not held. */
static void check_rims(taut_reader *document, const taut_film_problem *data)
{
    const taut_json edges = taut_json_member(document->object, "edges");

    for (int e = 0; document->status == TAUT_OK && edges.value != NULL && e < 4; e++) {
        const taut_json at = taut_json_member(&edges, edge_members[e]);
        if (at.value != NULL && taut_json_text_at(&at) != NULL &&
            e / 2 == (data->ring == TAUT_FILM_RING_V) && data->ring != TAUT_FILM_OPEN) {
            document->status = taut_json_refuse(&at, document->error, "edge-conflict",
                                                "no such edge: it is in a seam");
        }
    }
}

/* What one patch has that is the whole film. */
static void read_alone(taut_reader *document, taut_problem *problem, taut_film_problem *data)
{
    read_one(document, problem, data);
    read_seams(document, data);
    check_poles(document, data);
    check_rims(document, data);
    read_nets(document, problem->arena, data);
    read_tension(document, problem, data);
}

/* One of a mirror, a turn, a translation. */
static taut_status read_image(const taut_json *at, void *into, taut_error *error)
{
    static const char *const kinds[] = {"mirror", "half_turn", "turn", "translate", NULL};
    image_list *list = into;
    taut_film_image *image = &list->images[list->count++];
    taut_reader in = taut_reader_of(at, image_members, error);
    int count = 0;

    for (int k = 0; in.status == TAUT_OK && kinds[k] != NULL; k++) {
        if (taut_reader_has(&in, kinds[k])) {
            image->kind = (taut_film_image_kind)k;
            count++;
        }
    }
    if (in.status == TAUT_OK && count != 1) {
        in.status = taut_json_fail(at, error, count == 0 ? "missing" : "conflict", count, 1,
                                   "found %d of \"mirror\", \"half_turn\", \"turn\" and "
                                   "\"translate\", expected one",
                                   count);
    }
    if (in.status != TAUT_OK) {
        return in.status;
    }
    if (image->kind == TAUT_FILM_TRANSLATE) {
        taut_reader_member(&in, "translate", read_point, image->vector);
    } else {
        read_guide(&in, kinds[image->kind],
                   image->kind == TAUT_FILM_MIRROR ? plane_members : line_members, &image->guide);
    }
    if (image->kind == TAUT_FILM_TURN) {
        taut_reader_number(&in, "angle", &image->angle);
    } else if (in.status == TAUT_OK && taut_reader_has(&in, "angle")) {
        const taut_json angle = taut_json_member(at, "angle");
        in.status =
            taut_json_fail(&angle, error, "conflict", 1, 0, "found \"angle\" without \"turn\"");
    }
    taut_reader_optional_integer(&in, "count", 1, TAUT_FILM_IMAGES_MAX, &image->count);
    return in.status;
}

static void read_images(taut_reader *document, taut_arena *arena, taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "images");
    image_list list = {NULL, 0};

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    list.images = taut_arena_take(arena, IMAGES + 1, sizeof *list.images);
    document->status = list.images == NULL ? taut_fail_memory(document->error)
                                           : taut_json_each(&at, 0, IMAGES, "images", read_image,
                                                            &list, document->error);
    data->images = list.images;
    data->image_count = list.count;
}

static void refuse_supports(taut_reader *document)
{
    const taut_json through = taut_json_member(document->object, "through");

    if (document->status == TAUT_OK && through.value != NULL) {
        document->status =
            taut_film_document_none(&through, "point-support", no_support, document->error);
    }
}

/* What only curves have. */
static void refuse_without_curves(taut_reader *document)
{
    static const char *const theirs[] = {"degree", "count", NULL};

    for (int k = 0; document->status == TAUT_OK && theirs[k] != NULL; k++) {
        const taut_json at = taut_json_member(document->object, theirs[k]);
        if (at.value != NULL && !taut_reader_has(document, "curves") &&
            !taut_reader_has(document, "boundary")) {
            document->status =
                taut_json_fail(&at, document->error, "conflict", 1, 0,
                               "found \"%s\" without \"curves\": bases have their own", theirs[k]);
        }
    }
}

static void film_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_film_problem *const data = into;
    taut_film_parts parts = {.patches = data};

    refuse_without_curves(document);
    if (taut_reader_has(document, "patches")) {
        static const taut_film_patch_readers readers = {read_one, read_tension, read_cable};
        taut_film_document_patches(document, problem, &readers, data, &parts);
    } else if (taut_reader_has(document, "curves") || taut_reader_has(document, "boundary")) {
        taut_member_name(document, problem->arena, &data->name);
        check_name(document, data->name);
        read_film_tension(document, data);
        taut_film_document_curves(document, problem, read_curve, data, &parts);
        taut_film_document_start(document, problem->arena,
                                 data->patch_count > 0 ? data->patch_count : 1, parts.patches);
    } else {
        read_alone(document, problem, data);
    }
    refuse_supports(document);
    taut_reader_optional_integer(document, "refine", 0, TAUT_FILM_REFINE_MAX, &data->refine);
    if (taut_reader_has(document, "cables")) {
        taut_film_document_along(document, problem, &parts, read_law, data);
    }
    read_images(document, problem->arena, data);
    if (taut_reader_has(document, "cells")) {
        taut_film_document_cells(document, problem, data);
    }
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
