#include "io/model/surface.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/model/basis.h"
#include "io/problem/net_document.h"
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
        status = taut_json_fail(&at, error, "value", (double)strlen(text), TAUT_NAME_MAX,
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

/* Is there a text in the net? */
static int has_text(const taut_json *points, int rows, int columns)
{
    for (int i = 0; i < rows; i++) {
        const taut_json row = taut_json_item(points, (size_t)i);
        for (int j = 0; j < columns; j++) {
            const taut_json point = taut_json_item(&row, (size_t)j);
            for (size_t c = 0; c < 3; c++) {
                const taut_json at = taut_json_item(&point, c);
                if (taut_json_text_at(&at) != NULL) {
                    return 1;
                }
            }
        }
    }
    return 0;
}

/* The texts of rational coordinates, the caller's to free; NULL where all are numbers. */
static taut_status read_texts(const taut_json *points, int rows, int columns, const char ***texts,
                              taut_error *error)
{
    int found = has_text(points, rows, columns);
    if (found) {
        *texts = taut_alloc(3 * (size_t)rows * (size_t)columns, sizeof **texts);
        if (*texts == NULL) {
            return taut_fail_memory(error);
        }
        taut_net_document_texts(points, rows, columns, *texts, &found);
    }
    return TAUT_OK;
}

taut_status taut_surface_document_read(const taut_json *at, taut_surface **surface,
                                       taut_error *error)
{
    taut_status status = taut_json_object(at, surface_members, error);
    const taut_json points_at = taut_json_member(at, "points");
    const char *name = "";
    taut_basis *u = NULL, *v = NULL;
    double *points = NULL, *weights = NULL;
    const char **texts = NULL;
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
        status = read_texts(&points_at, rows, columns, &texts, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_within(
            at, taut_surface_new_exact(name, u, v, points, weights, texts, surface, error), error);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    taut_free(points);
    taut_free(weights);
    taut_free(texts);
    return status;
}

/* The basis of a polygon of `count` points. */
static taut_status read_parameter(const taut_json *at, int count, taut_basis **t, taut_error *error)
{
    const taut_json basis_at = taut_json_member(at, "t");
    const taut_json points_at = taut_json_member(at, "points");
    taut_status status = taut_basis_document_read(&basis_at, count, t, error);
    if (status == TAUT_OK && taut_basis_count(*t) != count) {
        status = taut_json_fail(&points_at, error, "value", count, taut_basis_count(*t),
                                "found %d point%s, expected %d, one for each function of \"t\"",
                                count, count == 1 ? "" : "s", taut_basis_count(*t));
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

/* The points with their texts, a row a line. */
static void put_exact(taut_json_out *out, size_t rows, size_t columns, const taut_surface *surface)
{
    const double *points = taut_surface_points(surface);
    const char *const *texts = taut_surface_exact(surface);
    taut_json_open(out, '[');
    for (size_t i = 0; i < rows; i++) {
        taut_json_open_inline(out, '[');
        for (size_t j = 0; j < columns; j++) {
            taut_json_open(out, '[');
            for (size_t c = 0; c < 3; c++) {
                const size_t at = 3 * (i * columns + j) + c;
                if (texts[at] != NULL) {
                    taut_json_put_text(out, texts[at]);
                } else {
                    taut_json_put_number(out, points[at]);
                }
            }
            taut_json_close(out, ']');
        }
        taut_json_close(out, ']');
    }
    taut_json_close(out, ']');
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
    if (taut_surface_exact(surface) != NULL) {
        put_exact(out, rows, columns, surface);
    } else {
        taut_json_put_net(out, rows, columns, 3, taut_surface_points(surface));
    }
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
