#include "io/problem/film_net.h"

#include "core/fail.h"
#include "geometry/keep.h"
#include "io/model/model.h"
#include "io/problem/net_document.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};

taut_status taut_film_document_none(const taut_json *at, const char *reason, const char *message,
                                    taut_error *error)
{
    (void)taut_json_fail(at, error, reason, taut_none, taut_none, "%s", message);
    if (error != NULL) {
        error->status = TAUT_NO_SOLUTION;
    }
    return TAUT_NO_SOLUTION;
}

/* A net as it was read. */
typedef struct net {
    int nu, nv;
    double *points;       /* [nu][nv][3] */
    unsigned char *known; /* [nu][nv] */
} net;

static int has_edge(const taut_film_problem *data, int e)
{
    return data->ring == TAUT_FILM_OPEN || (data->ring == TAUT_FILM_RING_U) == (e >= 2);
}

static size_t place_of(const net *n, int e, int k)
{
    const size_t nv = (size_t)n->nv;
    return e < 2 ? (e == 1 ? (size_t)(n->nu - 1) * nv : 0) + (size_t)k
                 : (size_t)k * nv + (e == 3 ? nv - 1 : 0);
}

/* How many points of the row of edge e are given, its ends left out where it has corners. */
static int count_row(const taut_film_problem *data, const net *n, int e, int *most)
{
    const int count = e < 2 ? n->nv : n->nu, ends = data->ring == TAUT_FILM_OPEN;
    int known = 0;
    for (int k = ends; k < count - ends; k++) {
        known += n->known[place_of(n, e, k)];
    }
    *most = count - 2 * ends;
    return known;
}

/* The row of an edge as a curve, which holds it. */
static taut_status hold_row(const net *n, int e, taut_arena *arena, taut_film_problem *data,
                            taut_error *error)
{
    const int count = e < 2 ? n->nv : n->nu;
    double *row = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_curve *curve = NULL;

    if (row == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < count; k++) {
        memcpy(row + 3 * k, n->points + 3 * place_of(n, e, k), 3 * sizeof(double));
    }
    const taut_status status =
        taut_curve_new(NULL, e < 2 ? data->v : data->u, row, NULL, &curve, error);
    if (status == TAUT_OK && !taut_keep_curve(arena, curve)) {
        return taut_fail_memory(error);
    }
    data->edges[e].curve = curve;
    return status;
}

/* What the row of an edge says of it. */
static taut_status take_row(const taut_json *at, const net *n, int e, int is_named,
                            taut_arena *arena, taut_film_problem *data, taut_error *error)
{
    taut_film_edge *edge = &data->edges[e];
    int most = 0;
    const int known = count_row(data, n, e, &most);
    const int corners =
        n->known[place_of(n, e, 0)] && n->known[place_of(n, e, (e < 2 ? n->nv : n->nu) - 1)];
    char message[128];

    if (edge->kind != TAUT_FILM_FIXED || is_named == TAUT_FILM_EDGE_JOINED) {
        return TAUT_OK; /* a start */
    }
    if (edge->curve != NULL) {
        return known == 0 ? TAUT_OK
                          : taut_json_fail(at, error, "edge-conflict", known, 0,
                                           "found points on edge %s, which is held on a curve: "
                                           "leave out one of them",
                                           edge_names[e]);
    }
    if (known == most && corners) {
        return hold_row(n, e, arena, data, error);
    }
    if (is_named && known == 0 && corners && data->ring == TAUT_FILM_OPEN) {
        return TAUT_OK; /* the line between its corners */
    }
    snprintf(message, sizeof message,
             "edge %s is neither held, drawn nor kept in a plane: give it a cable or a plane, or "
             "all its points",
             edge_names[e]);
    const taut_json edges = taut_json_member(at->up, "edges");
    const taut_json here = taut_json_member(&edges, edge_names[e]);
    return taut_film_document_none(&here, "free-edge", message, error);
}

static void take_corners(const net *n, taut_film_problem *data)
{
    for (int c = 0; c < 4 && data->ring == TAUT_FILM_OPEN; c++) {
        const size_t at = place_of(n, c % 2, c / 2 * (n->nv - 1));
        data->has_corner[c] = n->known[at];
        data->corner_kinds[c] = n->known[at] ? TAUT_FILM_HELD : TAUT_FILM_FREE;
        memcpy(data->corners[c], n->points + 3 * at, sizeof data->corners[c]);
    }
}

/* A point inside holds nothing; of the first: exit 4. */
static taut_status check_inside(const taut_json *points, const net *n,
                                const taut_film_problem *data, taut_error *error)
{
    for (int i = 0; i < n->nu; i++) {
        for (int j = 0; j < n->nv; j++) {
            const int at_u = (i == 0 || i == n->nu - 1) && data->ring != TAUT_FILM_RING_U;
            const int at_v = (j == 0 || j == n->nv - 1) && data->ring != TAUT_FILM_RING_V;
            if (!at_u && !at_v && n->known[i * n->nv + j]) {
                const taut_json row = taut_json_item(points, (size_t)i);
                const taut_json at = taut_json_item(&row, (size_t)j);
                return taut_film_document_none(
                    &at, "point-support",
                    "a point inside holds no film: use a ring, or cables that end there; where "
                    "the net is to begin is \"start\"",
                    error);
            }
        }
    }
    return TAUT_OK;
}

static taut_status read_net(const taut_json *at, taut_arena *arena, const taut_film_problem *data,
                            net *n, taut_error *error)
{
    int rows = 0, columns = 0;
    taut_status status = taut_net_document_shape(at, &rows, &columns, error);

    n->nu = taut_basis_count(data->u);
    n->nv = taut_basis_count(data->v);
    if (status == TAUT_OK && (rows != n->nu || columns != n->nv)) {
        status = taut_json_fail(at, error, "size", (double)rows * columns, (double)n->nu * n->nv,
                                "found %d by %d points, expected those of u and v, %d by %d", rows,
                                columns, n->nu, n->nv);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const size_t count = (size_t)rows * (size_t)columns;
    n->points = taut_arena_take(arena, count, 3 * sizeof(double));
    n->known = taut_arena_take(arena, count, 1);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_net_document_points(at, rows, columns, n->points, n->known, error);
}

static taut_status take_net(const taut_json *at, const net *n, taut_arena *arena,
                            const unsigned char named[4], taut_film_problem *data,
                            taut_error *error)
{
    const size_t count = (size_t)n->nu * (size_t)n->nv;
    taut_status status = check_inside(at, n, data, error);

    take_corners(n, data);
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        if (has_edge(data, e)) {
            status = take_row(at, n, e, named[e], arena, data, error);
        }
    }
    for (size_t i = 0; i < count; i++) {
        for (int c = 0; c < 3 && !n->known[i]; c++) {
            n->points[3 * i + (size_t)c] = NAN;
        }
    }
    data->start = n->points;
    return status;
}

void taut_film_document_points(taut_reader *document, taut_arena *arena,
                               const unsigned char named[4], taut_film_problem *data)
{
    const taut_json at = taut_json_member(document->object, "points");
    net n = {.points = NULL};

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    if (taut_reader_has(document, "corners")) {
        const taut_json corners = taut_json_member(document->object, "corners");
        document->status =
            taut_json_fail(&corners, document->error, "conflict", 2, 1,
                           "found \"corners\" beside \"points\", which have them: expected one");
        return;
    }
    document->status = read_net(&at, arena, data, &n, document->error);
    if (document->status == TAUT_OK) {
        document->status = take_net(&at, &n, arena, named, data, document->error);
    }
}

static const taut_surface *find_surface(const taut_model *model, const char *name)
{
    for (int k = 0; k < taut_model_surface_count(model); k++) {
        if (strcmp(taut_surface_name(taut_model_surface(model, k)), name) == 0) {
            return taut_model_surface(model, k);
        }
    }
    return NULL;
}

static taut_status take_start(const taut_json *at, const taut_model *model, taut_arena *arena,
                              taut_film_problem *part, taut_error *error)
{
    const char *name = part->name != NULL ? part->name : "film";
    const taut_surface *surface = find_surface(model, name);

    if (surface == NULL || taut_surface_weights(surface) != NULL ||
        !taut_basis_equal(taut_surface_u(surface), part->u) ||
        !taut_basis_equal(taut_surface_v(surface), part->v)) {
        return taut_json_fail(at, error, "start", taut_none, taut_none,
                              surface == NULL ? "found no surface \"%s\", expected one of that name"
                                              : "found a surface \"%s\" on other bases, expected "
                                                "those of the film",
                              name);
    }
    const size_t count = (size_t)taut_basis_count(part->u) * (size_t)taut_basis_count(part->v);
    part->start = taut_arena_copy(arena, taut_surface_points(surface), count, 3 * sizeof(double));
    return part->start != NULL ? TAUT_OK : taut_fail_memory(error);
}

void taut_film_document_start(taut_reader *document, taut_arena *arena, int count,
                              taut_film_problem *parts)
{
    const taut_json at = taut_json_member(document->object, "start");
    taut_model *model = NULL;

    if (document->status != TAUT_OK || at.value == NULL) {
        return;
    }
    document->status = taut_model_document_read(&at, &model, document->error);
    for (int k = 0; document->status == TAUT_OK && k < count; k++) {
        document->status = take_start(&at, model, arena, &parts[k], document->error);
    }
    taut_model_free(model);
}
