#include "core/fail.h"
#include "geometry/keep.h"
#include "io/geomdl/geomdl.h"
#include "io/model/surface.h"
#include "io/problem/net_document.h"
#include "taut/limits.h"

#include <assert.h>
#include <string.h>

int taut_geomdl_is(const taut_json *document)
{
    return taut_json_find(document->value, "shape") != NULL &&
           taut_json_find(document->value, "taut") == NULL;
}

/* A shape on its way into the model: the arena owns what belongs to it until then. */
typedef struct shape {
    taut_reader in;
    taut_arena *arena;
    taut_model *model;
    const char *name;
} shape;

/* One direction: its degree, knots, and how many points it has. */
static taut_basis *read_basis(shape *s, const char *degree_key, const char *knots_key, int count)
{
    const taut_json knots_at = taut_json_member(s->in.object, knots_key);
    taut_basis_spec spec = {.type = "bspline"};
    taut_basis *basis = NULL;
    size_t knot_count = 0;
    double *knots = NULL;
    taut_error found = {.status = TAUT_OK};
    taut_status status = TAUT_OK;

    taut_reader_integer(&s->in, degree_key, 1, TAUT_DEGREE_MAX, &spec.degree);
    taut_reader_array(&s->in, knots_key, 2, (size_t)count + (size_t)spec.degree + 1, "knots",
                      &knot_count);
    if (s->in.status != TAUT_OK) {
        return NULL;
    }
    knots = taut_arena_take(s->arena, knot_count, sizeof *knots);
    s->in.status = knots != NULL ? taut_json_numbers(&knots_at, knot_count, knots, s->in.error)
                                 : taut_fail_memory(s->in.error);
    if (s->in.status != TAUT_OK) {
        return NULL;
    }
    spec.knots = knots;
    spec.knot_count = (int)knot_count;
    status = taut_basis_new(&spec, count, &basis, &found);
    if (status == TAUT_BAD_INPUT) {
        s->in.status = taut_json_fail(&knots_at, s->in.error, found.reason, found.found,
                                      found.limit, "%s", found.message);
    } else if (status != TAUT_OK || !taut_keep_basis(s->arena, basis)) {
        s->in.status = taut_fail_memory(s->in.error);
    }
    assert(s->in.status != TAUT_OK || taut_basis_count(basis) == count); /* as asked of it */
    return s->in.status == TAUT_OK ? basis : NULL;
}

/* [x, y, z], or [x, y] of a plane curve. */
static taut_status read_point(const taut_json *at, double point[3], taut_error *error)
{
    point[2] = 0;
    if (taut_json_kind_at(at) == TAUT_JSON_ARRAY && taut_json_count_at(at) == 2) {
        return taut_json_numbers(at, 2, point, error);
    }
    return taut_net_document_point(at, point, error);
}

/* Points and weights of `count` control points. */
static taut_status read_points(shape *s, size_t count, double **points, double **weights)
{
    const taut_json net = taut_json_member(s->in.object, "control_points");
    const taut_json points_at = taut_json_member(&net, "points");
    const taut_json weights_at = taut_json_member(&net, "weights");
    const int is_weighted = weights_at.value != NULL;
    size_t found = 0;
    taut_status status = taut_json_array(&points_at, count, count, "points", &found, s->in.error);

    if (status != TAUT_OK) {
        return status;
    }
    *points = taut_arena_take(s->arena, count, 3 * sizeof(double));
    *weights = is_weighted ? taut_arena_take(s->arena, count, sizeof(double)) : NULL;
    if (taut_arena_status(s->arena) != TAUT_OK) {
        return taut_fail_memory(s->in.error);
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json at = taut_json_item(&points_at, i);
        status = read_point(&at, *points + 3 * i, s->in.error);
    }
    return status == TAUT_OK && is_weighted
               ? taut_net_document_weights(&weights_at, 0, (int)count, *weights, s->in.error)
               : status;
}

static taut_status add_surface(shape *s)
{
    taut_error *const error = s->in.error;
    taut_basis *u = NULL, *v = NULL;
    double *points = NULL, *weights = NULL;
    taut_surface *surface = NULL;
    int nu = 0, nv = 0;
    taut_status status = TAUT_OK;

    taut_reader_integer(&s->in, "size_u", 2, TAUT_COUNT_MAX, &nu);
    taut_reader_integer(&s->in, "size_v", 2, TAUT_COUNT_MAX, &nv);
    if (s->in.status != TAUT_OK) {
        return s->in.status;
    }
    if ((double)nu * nv > TAUT_POINTS_MAX) {
        return taut_json_fail(s->in.object, error, "size", (double)nu * nv, TAUT_POINTS_MAX,
                              "found a net of %d x %d points, expected at most %d points", nu, nv,
                              TAUT_POINTS_MAX);
    }
    s->in.status = read_points(s, (size_t)nu * (size_t)nv, &points, &weights);
    u = read_basis(s, "degree_u", "knotvector_u", nu);
    v = read_basis(s, "degree_v", "knotvector_v", nv);
    if (s->in.status != TAUT_OK) {
        return s->in.status;
    }
    status = taut_surface_new(s->name, u, v, points, weights, &surface, error);
    if (status == TAUT_OK && taut_model_add_surface(s->model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return taut_json_within(s->in.object, status, error);
}

static taut_status add_curve(shape *s)
{
    taut_error *const error = s->in.error;
    const taut_json net = taut_json_member(s->in.object, "control_points");
    const taut_json points_at = taut_json_member(&net, "points");
    taut_basis *t = NULL;
    double *points = NULL, *weights = NULL;
    taut_curve *curve = NULL;
    size_t count = 0;
    taut_status status = taut_json_array(&points_at, 2, TAUT_COUNT_MAX, "points", &count, error);

    if (status != TAUT_OK) {
        return status;
    }
    s->in.status = read_points(s, count, &points, &weights);
    t = read_basis(s, "degree", "knotvector", (int)count);
    if (s->in.status != TAUT_OK) {
        return s->in.status;
    }
    status = taut_curve_new(s->name, t, points, weights, &curve, error);
    if (status == TAUT_OK && taut_model_add_curve(s->model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return taut_json_within(s->in.object, status, error);
}

static taut_status check_spline(const taut_json *at, void *word, taut_error *error)
{
    static const char *const types[] = {"spline", NULL};
    return taut_json_word(at, types, word, error);
}

static taut_status add_item(const taut_json *at, taut_model *model, taut_status (*add)(shape *),
                            taut_error *error)
{
    shape s = {.in = taut_reader_of(at, NULL, error), .model = model, .name = ""};
    int word = 0;
    taut_status status = TAUT_OK;

    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "type", "an object");
    }
    taut_reader_optional(&s.in, "type", check_spline, &word);
    if (s.in.status != TAUT_OK) {
        return s.in.status;
    }
    status = taut_name_document_read(at, &s.name, error);
    if (status != TAUT_OK) {
        return status;
    }
    s.arena = taut_arena_new();
    status = add(&s);
    taut_arena_free(s.arena);
    return status;
}

static taut_status add_surface_item(const taut_json *at, void *model, taut_error *error)
{
    return add_item(at, model, add_surface, error);
}

static taut_status add_curve_item(const taut_json *at, void *model, taut_error *error)
{
    return add_item(at, model, add_curve, error);
}

/* The number of shapes that is stated must be that of the list. */
static taut_status check_count(const taut_json *at, void *count, taut_error *error)
{
    int stated = 0;
    const taut_status status = taut_json_integer(at, 1, TAUT_OBJECTS_MAX, &stated, error);
    if (status == TAUT_OK && (size_t)stated != *(const size_t *)count) {
        return taut_json_refuse(at, error, "value", "%zu, as many as in \"data\"",
                                *(const size_t *)count);
    }
    return status;
}

static taut_status read_shape(const taut_json *at, taut_model *model, taut_error *error)
{
    static const char *const types[] = {"surface", "curve", NULL};
    const taut_json data = taut_json_member(at, "data");
    taut_reader in = taut_reader_of(at, NULL, error);
    size_t count = 0;
    int word = 0;

    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "type", "an object");
    }
    taut_reader_word(&in, "type", types, &word);
    taut_reader_array(&in, "data", 1, TAUT_OBJECTS_MAX, "shapes", &count);
    taut_reader_optional(&in, "count", check_count, &count);
    if (in.status != TAUT_OK) {
        return in.status;
    }
    return taut_json_each(&data, 1, TAUT_OBJECTS_MAX, "shapes",
                          word == 0 ? add_surface_item : add_curve_item, model, error);
}

taut_status taut_geomdl_read(const taut_json *document, taut_model **model, taut_error *error)
{
    const taut_json at = taut_json_member(document, "shape");
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (taut_model_new(&made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = read_shape(&at, made, error);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}
