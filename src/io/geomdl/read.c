#include "core/fail.h"
#include "core/memory.h"
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

/* One direction: its degree, knots, and how many points it has. */
static taut_status read_basis(const taut_json *object, const char *degree_key,
                              const char *knots_key, int count, taut_basis **basis,
                              taut_error *error)
{
    const taut_json degree_at = taut_json_member(object, degree_key);
    const taut_json knots_at = taut_json_member(object, knots_key);
    taut_basis_spec spec = {.type = "bspline"};
    size_t knot_count = 0;
    double *knots = NULL;
    taut_error found = {.status = TAUT_OK};
    taut_status status = taut_json_integer(&degree_at, 1, TAUT_DEGREE_MAX, &spec.degree, error);

    if (status == TAUT_OK) {
        const size_t most = (size_t)count + (size_t)spec.degree + 1;
        status = taut_json_array(&knots_at, 2, most, "knots", &knot_count, error);
    }
    if (status == TAUT_OK) {
        knots = taut_alloc(knot_count, sizeof *knots);
        status = knots != NULL ? taut_json_numbers(&knots_at, knot_count, knots, error)
                               : taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        spec.knots = knots;
        spec.knot_count = (int)knot_count;
        status = taut_basis_new(&spec, count, basis, &found);
        if (status == TAUT_BAD_INPUT) {
            status = taut_json_fail(&knots_at, error, "value", found.found, found.limit, "%s",
                                    found.message);
        } else if (status != TAUT_OK && error != NULL) {
            *error = found;
        }
    }
    assert(status != TAUT_OK || taut_basis_count(*basis) == count); /* as asked of it */
    taut_free(knots);
    return status;
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

/* Points and weights of `count` control points, which the caller frees, also on failure. */
static taut_status read_points(const taut_json *object, size_t count, double **points,
                               double **weights, taut_error *error)
{
    const taut_json net = taut_json_member(object, "control_points");
    const taut_json points_at = taut_json_member(&net, "points");
    const taut_json weights_at = taut_json_member(&net, "weights");
    size_t found = 0;
    taut_status status = taut_json_array(&points_at, count, count, "points", &found, error);

    if (status == TAUT_OK) {
        *points = taut_alloc(3 * count, sizeof(double));
        status = *points != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json at = taut_json_item(&points_at, i);
        status = read_point(&at, *points + 3 * i, error);
    }
    if (status == TAUT_OK && weights_at.value != NULL) {
        *weights = taut_alloc(count, sizeof(double));
        status = *weights != NULL
                     ? taut_net_document_weights(&weights_at, 0, (int)count, *weights, error)
                     : taut_fail_memory(error);
    }
    return status;
}

static taut_status add_surface(const taut_json *at, const char *name, taut_model *model,
                               taut_error *error)
{
    const taut_json u_at = taut_json_member(at, "size_u"), v_at = taut_json_member(at, "size_v");
    taut_basis *u = NULL, *v = NULL;
    double *points = NULL, *weights = NULL;
    taut_surface *surface = NULL;
    int nu = 0, nv = 0;
    taut_status status = taut_json_integer(&u_at, 2, TAUT_COUNT_MAX, &nu, error);

    if (status == TAUT_OK) {
        status = taut_json_integer(&v_at, 2, TAUT_COUNT_MAX, &nv, error);
    }
    if (status == TAUT_OK && (double)nu * nv > TAUT_POINTS_MAX) {
        status = taut_json_fail(at, error, "value", (double)nu * nv, TAUT_POINTS_MAX,
                                "found a net of %d x %d points, expected at most %d points", nu, nv,
                                TAUT_POINTS_MAX);
    }
    if (status == TAUT_OK) {
        status = read_points(at, (size_t)nu * (size_t)nv, &points, &weights, error);
    }
    if (status == TAUT_OK) {
        status = read_basis(at, "degree_u", "knotvector_u", nu, &u, error);
    }
    if (status == TAUT_OK) {
        status = read_basis(at, "degree_v", "knotvector_v", nv, &v, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_within(
            at, taut_surface_new(name, u, v, points, weights, &surface, error), error);
    }
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        status = taut_fail_memory(error);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    taut_free(points);
    taut_free(weights);
    return status;
}

static taut_status add_curve(const taut_json *at, const char *name, taut_model *model,
                             taut_error *error)
{
    const taut_json net = taut_json_member(at, "control_points");
    const taut_json points_at = taut_json_member(&net, "points");
    taut_basis *t = NULL;
    double *points = NULL, *weights = NULL;
    taut_curve *curve = NULL;
    size_t count = 0;
    taut_status status = taut_json_array(&points_at, 2, TAUT_COUNT_MAX, "points", &count, error);

    if (status == TAUT_OK) {
        status = read_points(at, count, &points, &weights, error);
    }
    if (status == TAUT_OK) {
        status = read_basis(at, "degree", "knotvector", (int)count, &t, error);
    }
    if (status == TAUT_OK) {
        status =
            taut_json_within(at, taut_curve_new(name, t, points, weights, &curve, error), error);
    }
    if (status == TAUT_OK && taut_model_add_curve(model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        status = taut_fail_memory(error);
    }
    taut_basis_free(t);
    taut_free(points);
    taut_free(weights);
    return status;
}

static taut_status add_item(const taut_json *at, int is_surface, taut_model *model,
                            taut_error *error)
{
    static const char *const types[] = {"spline", NULL};
    const taut_json type = taut_json_member(at, "type");
    const char *name = "";
    int word = 0;
    taut_status status = TAUT_OK;

    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_expected(at, error, "an object");
    }
    if (type.value != NULL) {
        status = taut_json_word(&type, types, &word, error);
    }
    if (status == TAUT_OK) {
        status = taut_name_document_read(at, &name, error);
    }
    if (status == TAUT_OK) {
        status = (is_surface ? add_surface : add_curve)(at, name, model, error);
    }
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
        return taut_json_expected(shape, error, "an object");
    }
    status = taut_json_word(&type, types, &word, error);
    if (status == TAUT_OK) {
        status = taut_json_array(&data, 1, TAUT_OBJECTS_MAX, "shapes", &count, error);
    }
    if (status == TAUT_OK && count_at.value != NULL) {
        status = taut_json_integer(&count_at, 1, TAUT_OBJECTS_MAX, &stated, error);
        if (status == TAUT_OK && (size_t)stated != count) {
            status = taut_json_expected(&count_at, error, "%zu, as many as in \"data\"", count);
        }
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json item = taut_json_item(&data, i);
        status = add_item(&item, word == 0, model, error);
    }
    return status;
}

taut_status taut_geomdl_read(const taut_json *document, taut_model **model, taut_error *error)
{
    const taut_json shape = taut_json_member(document, "shape");
    taut_model *made = NULL;
    taut_status status = taut_model_new(&made) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = read_shape(&shape, made, error);
    }
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}
