#include "io/surface_document.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/basis_document.h"
#include "io/net_document.h"
#include "taut/limits.h"

#include <string.h>

static const char *const surface_members[] = {"name", "u", "v", "points", "weights", NULL};
static const char *const curve_members[] = {"name", "t", "points", "weights", NULL};

taut_status taut_name_document_read(const taut_json *object, const char **name, taut_error *error)
{
    const taut_json at = taut_json_member(object, "name");
    const char *text = "";
    taut_status status = at.value != NULL ? taut_json_text(&at, &text, error) : TAUT_OK;
    if (status == TAUT_OK && strlen(text) > TAUT_NAME_MAX) {
        status = taut_json_fail(&at, error, (double)strlen(text), TAUT_NAME_MAX,
                                "found a name of %zu bytes, expected at most %d", strlen(text),
                                TAUT_NAME_MAX);
    }
    if (status == TAUT_OK) {
        *name = text;
    }
    return status;
}

/* The points and, if there are any, the weights of a net (rows 0: of a polygon), into memory that
 * the caller frees, also on failure. */
static taut_status read_net(const taut_json *object, int rows, int columns, double **points,
                            double **weights, taut_error *error)
{
    const taut_json at = taut_json_member(object, "points");
    const taut_json weighted = taut_json_member(object, "weights");
    const size_t count = (size_t)(rows > 0 ? rows : 1) * (size_t)columns;
    taut_status status = TAUT_OK;

    *points = taut_alloc(3 * count, sizeof(double));
    if (*points == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_net_document_points(&at, rows, columns, *points, NULL, error);
    if (status == TAUT_OK && weighted.value != NULL) {
        *weights = taut_alloc(count, sizeof(double));
        status = *weights != NULL
                     ? taut_net_document_weights(&weighted, rows, columns, *weights, error)
                     : taut_fail_memory(error);
    }
    return status;
}

taut_status taut_surface_document_read(const taut_json *at, taut_surface **surface,
                                       taut_error *error)
{
    taut_status status = taut_json_object(at, surface_members, error);
    const taut_json points_at = taut_json_member(at, "points");
    const char *name = "";
    taut_basis *u = NULL, *v = NULL;
    double *points = NULL, *weights = NULL;
    int rows = 0, columns = 0;

    if (status == TAUT_OK) {
        status = taut_name_document_read(at, &name, error);
    }
    if (status == TAUT_OK) {
        status = taut_net_document_shape(&points_at, &rows, &columns, error);
    }
    if (status == TAUT_OK) {
        status = taut_net_document_bases(at, rows, columns, &u, &v, error);
    }
    if (status == TAUT_OK) {
        status = read_net(at, rows, columns, &points, &weights, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_within(at, taut_surface_new(name, u, v, points, weights, surface, error),
                                  error);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    taut_free(points);
    taut_free(weights);
    return status;
}

/* The basis of a polygon of `count` points. */
static taut_status read_parameter(const taut_json *at, int count, taut_basis **t, taut_error *error)
{
    const taut_json basis_at = taut_json_member(at, "t");
    const taut_json points_at = taut_json_member(at, "points");
    taut_status status = taut_basis_document_read(&basis_at, count, t, error);
    if (status == TAUT_OK && taut_basis_count(*t) != count) {
        status = taut_json_fail(&points_at, error, count, taut_basis_count(*t),
                                "found %d points, expected %d, one for each function of \"t\"",
                                count, taut_basis_count(*t));
    }
    return status;
}

taut_status taut_curve_document_read(const taut_json *at, taut_curve **curve, taut_error *error)
{
    taut_status status = taut_json_object(at, curve_members, error);
    const taut_json points_at = taut_json_member(at, "points");
    const char *name = "";
    taut_basis *t = NULL;
    double *points = NULL, *weights = NULL;
    size_t count = 0;

    if (status == TAUT_OK) {
        status = taut_name_document_read(at, &name, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_array(&points_at, 1, TAUT_COUNT_MAX, "points", &count, error);
    }
    if (status == TAUT_OK) {
        status = read_parameter(at, (int)count, &t, error);
    }
    if (status == TAUT_OK) {
        status = read_net(at, 0, (int)count, &points, &weights, error);
    }
    if (status == TAUT_OK) {
        status =
            taut_json_within(at, taut_curve_new(name, t, points, weights, curve, error), error);
    }
    taut_basis_free(t);
    taut_free(points);
    taut_free(weights);
    return status;
}

void taut_surface_document_write(taut_json_out *out, const taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t rows = (size_t)taut_basis_count(u), columns = (size_t)taut_basis_count(v);

    taut_json_open(out, '{');
    taut_json_key(out, "name");
    taut_json_put_text(out, taut_surface_name(surface));
    taut_json_key(out, "u");
    taut_basis_document_write(out, u);
    taut_json_key(out, "v");
    taut_basis_document_write(out, v);
    taut_json_key(out, "points");
    taut_json_put_net(out, rows, columns, 3, taut_surface_points(surface));
    if (taut_surface_weights(surface) != NULL) {
        taut_json_key(out, "weights");
        taut_json_put_net(out, rows, columns, 1, taut_surface_weights(surface));
    }
    taut_json_close(out, '}');
}

void taut_curve_document_write(taut_json_out *out, const taut_curve *curve)
{
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve));

    taut_json_open(out, '{');
    taut_json_key(out, "name");
    taut_json_put_text(out, taut_curve_name(curve));
    taut_json_key(out, "t");
    taut_basis_document_write(out, taut_curve_t(curve));
    taut_json_key(out, "points");
    taut_json_put_net(out, 0, count, 3, taut_curve_points(curve));
    if (taut_curve_weights(curve) != NULL) {
        taut_json_key(out, "weights");
        taut_json_put_net(out, 0, count, 1, taut_curve_weights(curve));
    }
    taut_json_close(out, '}');
}
