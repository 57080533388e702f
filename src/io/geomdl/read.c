#include "core/fail.h"
#include "io/geomdl/geomdl.h"
#include "io/model/keep.h"
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

/* One direction: its degree, knots, and how many points it has; the arena owns it. */
static taut_status read_basis(const taut_json *object, const char *degree_key,
                              const char *knots_key, int count, taut_arena *arena,
                              taut_basis **basis, taut_error *error)
{
    const taut_json degree_at = taut_json_member(object, degree_key);
    const taut_json knots_at = taut_json_member(object, knots_key);
    taut_basis_spec spec = {.type = "bspline"};
    size_t knot_count = 0;
    double *knots = NULL;
    taut_error found = {.status = TAUT_OK};
    taut_status status = taut_json_integer(&degree_at, 1, TAUT_DEGREE_MAX, &spec.degree, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_array(&knots_at, 2, (size_t)count + (size_t)spec.degree + 1, "knots",
                             &knot_count, error);
    if (status != TAUT_OK) {
        return status;
    }
    knots = taut_arena_take(arena, knot_count, sizeof *knots);
    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_json_numbers(&knots_at, knot_count, knots, error);
    if (status != TAUT_OK) {
        return status;
    }
    spec.knots = knots;
    spec.knot_count = (int)knot_count;
    status = taut_basis_new(&spec, count, basis, &found);
    if (status == TAUT_BAD_INPUT) {
        return taut_json_fail(&knots_at, error, found.reason, found.found, found.limit, "%s",
                              found.message);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    assert(taut_basis_count(*basis) == count); /* as asked of it */
    return taut_keep_basis(arena, *basis) ? TAUT_OK : taut_fail_memory(error);
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

/* Points and weights of `count` control points; the arena owns them. */
static taut_status read_points(const taut_json *object, size_t count, taut_arena *arena,
                               double **points, double **weights, taut_error *error)
{
    const taut_json net = taut_json_member(object, "control_points");
    const taut_json points_at = taut_json_member(&net, "points");
    const taut_json weights_at = taut_json_member(&net, "weights");
    const int is_weighted = weights_at.value != NULL;
    size_t found = 0;
    taut_status status = taut_json_array(&points_at, count, count, "points", &found, error);

    if (status != TAUT_OK) {
        return status;
    }
    *points = taut_arena_take(arena, count, 3 * sizeof(double));
    *weights = is_weighted ? taut_arena_take(arena, count, sizeof(double)) : NULL;
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json at = taut_json_item(&points_at, i);
        status = read_point(&at, *points + 3 * i, error);
    }
    return status == TAUT_OK && is_weighted
               ? taut_net_document_weights(&weights_at, 0, (int)count, *weights, error)
               : status;
}

/* Where the shapes of a document go. */
typedef struct shapes {
    taut_model *model;
    int are_surfaces;
    taut_arena *arena; /* of the present one */
} shapes;

static taut_status add_surface(const taut_json *at, const char *name, const shapes *to,
                               taut_error *error)
{
    const taut_json u_at = taut_json_member(at, "size_u"), v_at = taut_json_member(at, "size_v");
    taut_basis *u = NULL, *v = NULL;
    double *points = NULL, *weights = NULL;
    taut_surface *surface = NULL;
    int nu = 0, nv = 0;
    taut_status status = taut_json_integer(&u_at, 2, TAUT_COUNT_MAX, &nu, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_integer(&v_at, 2, TAUT_COUNT_MAX, &nv, error);
    if (status != TAUT_OK) {
        return status;
    }
    if ((double)nu * nv > TAUT_POINTS_MAX) {
        return taut_json_fail(at, error, "size", (double)nu * nv, TAUT_POINTS_MAX,
                              "found a net of %d x %d points, expected at most %d points", nu, nv,
                              TAUT_POINTS_MAX);
    }
    status = read_points(at, (size_t)nu * (size_t)nv, to->arena, &points, &weights, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(at, "degree_u", "knotvector_u", nu, to->arena, &u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(at, "degree_v", "knotvector_v", nv, to->arena, &v, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_new(name, u, v, points, weights, &surface, error);
    if (status == TAUT_OK && taut_model_add_surface(to->model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return taut_json_within(at, status, error);
}

static taut_status add_curve(const taut_json *at, const char *name, const shapes *to,
                             taut_error *error)
{
    const taut_json net = taut_json_member(at, "control_points");
    const taut_json points_at = taut_json_member(&net, "points");
    taut_basis *t = NULL;
    double *points = NULL, *weights = NULL;
    taut_curve *curve = NULL;
    size_t count = 0;
    taut_status status = taut_json_array(&points_at, 2, TAUT_COUNT_MAX, "points", &count, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = read_points(at, count, to->arena, &points, &weights, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(at, "degree", "knotvector", (int)count, to->arena, &t, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(name, t, points, weights, &curve, error);
    if (status == TAUT_OK && taut_model_add_curve(to->model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return taut_json_within(at, status, error);
}

static taut_status check_spline(const taut_json *at, void *word, taut_error *error)
{
    static const char *const types[] = {"spline", NULL};
    return taut_json_word(at, types, word, error);
}

static taut_status read_item(const taut_json *at, const shapes *to, taut_error *error)
{
    const char *name = "";
    int word = 0;
    taut_status status = TAUT_OK;
    taut_reader in = taut_reader_of(at, NULL, error);

    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "type", "an object");
    }
    taut_reader_optional(&in, "type", check_spline, &word);
    if (in.status != TAUT_OK) {
        return in.status;
    }
    status = taut_name_document_read(at, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    return (to->are_surfaces ? add_surface : add_curve)(at, name, to, error);
}

static taut_status add_item(const taut_json *at, void *into, taut_error *error)
{
    shapes *to = into;
    taut_status status = TAUT_OK;
    to->arena = taut_arena_new();
    status = read_item(at, to, error);
    taut_arena_free(to->arena);
    return status;
}

static taut_status read_shape(const taut_json *shape, taut_model *model, taut_error *error)
{
    static const char *const types[] = {"surface", "curve", NULL};
    const taut_json type = taut_json_member(shape, "type");
    const taut_json count_at = taut_json_member(shape, "count");
    const taut_json data = taut_json_member(shape, "data");
    size_t count = 0;
    int word = 0, stated = 0;
    taut_status status = TAUT_OK;

    if (taut_json_kind_at(shape) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(shape, error, "type", "an object");
    }
    status = taut_json_word(&type, types, &word, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_array(&data, 1, TAUT_OBJECTS_MAX, "shapes", &count, error);
    if (status == TAUT_OK && count_at.value != NULL) {
        status = taut_json_integer(&count_at, 1, TAUT_OBJECTS_MAX, &stated, error);
        if (status == TAUT_OK && (size_t)stated != count) {
            status = taut_json_expected(&count_at, error, "%zu, as many as in \"data\"", count);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    shapes to = {.model = model, .are_surfaces = word == 0};
    return taut_json_each(&data, 1, TAUT_OBJECTS_MAX, "shapes", add_item, &to, error);
}

taut_status taut_geomdl_read(const taut_json *document, taut_model **model, taut_error *error)
{
    const taut_json shape = taut_json_member(document, "shape");
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (taut_model_new(&made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = read_shape(&shape, made, error);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}
