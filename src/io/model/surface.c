#include "io/model/surface.h"

#include "core/arena.h"
#include "core/fail.h"
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
    const taut_status status = at.value != NULL ? taut_json_text(&at, &text, error) : TAUT_OK;
    if (status == TAUT_OK && strlen(text) > TAUT_NAME_MAX) {
        return taut_json_fail(&at, error, "size", (double)strlen(text), TAUT_NAME_MAX,
                              "found a name of %zu bytes, expected at most %d", strlen(text),
                              TAUT_NAME_MAX);
    }
    *name = text;
    return status;
}

/* What objects begin with: no other members, and a name. */
static taut_status read_head(const taut_json *at, const char *const *members, const char **name,
                             taut_error *error)
{
    const taut_status status = taut_json_object(at, members, error);
    return status == TAUT_OK ? taut_name_document_read(at, name, error) : status;
}

static taut_status read_surface(const taut_json *at, taut_arena *arena, taut_surface **surface,
                                taut_error *error)
{
    const taut_json points = taut_json_member(at, "points");
    const char *name = "", **texts = NULL;
    taut_net_document net;
    int rows = 0, columns = 0, has_texts = 0;
    taut_status status = read_head(at, surface_members, &name, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_net_document_read_known(at, arena, &net, error);
    if (status != TAUT_OK) {
        return status;
    }
    rows = taut_basis_count(net.u);
    columns = taut_basis_count(net.v);
    taut_net_document_texts(&points, rows, columns, NULL, &has_texts);
    if (taut_pulse_is_stopped(at->pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (has_texts) {
        texts = taut_arena_take(arena, 3 * (size_t)rows * (size_t)columns, sizeof *texts);
        if (texts == NULL) {
            return taut_fail_memory(error);
        }
        taut_net_document_texts(&points, rows, columns, texts, &has_texts);
    }
    status =
        taut_surface_new_exact(name, net.u, net.v, net.points, net.weights, texts, surface, error);
    return taut_json_within(at, status, error);
}

taut_status taut_surface_document_read(const taut_json *at, taut_surface **surface,
                                       taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = read_surface(at, arena, surface, error);
    taut_arena_free(arena);
    return status;
}

/* The basis of a polygon of `count` points. */
static taut_status read_parameter(const taut_json *at, int count, taut_arena *arena,
                                  const taut_basis **t, taut_error *error)
{
    const taut_json basis_at = taut_json_member(at, "t");
    const taut_json points_at = taut_json_member(at, "points");
    const taut_status status = taut_basis_document_keep(&basis_at, count, arena, t, error);
    if (status == TAUT_OK && taut_basis_count(*t) != count) {
        return taut_json_fail(&points_at, error, "size", count, taut_basis_count(*t),
                              "found %d point%s, expected %d, one for each function of \"t\"",
                              count, count == 1 ? "" : "s", taut_basis_count(*t));
    }
    return status;
}

static taut_status read_curve(const taut_json *at, taut_arena *arena, taut_curve **curve,
                              taut_error *error)
{
    const taut_json points_at = taut_json_member(at, "points");
    const taut_json weights_at = taut_json_member(at, "weights");
    const int is_weighted = weights_at.value != NULL;
    const char *name = "";
    const taut_basis *t = NULL;
    double *points = NULL, *weights = NULL;
    size_t count = 0;
    taut_status status = read_head(at, curve_members, &name, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_array(&points_at, 1, TAUT_COUNT_MAX, "points", &count, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_parameter(at, (int)count, arena, &t, error);
    if (status != TAUT_OK) {
        return status;
    }
    points = taut_arena_take(arena, 3 * count, sizeof(double));
    weights = is_weighted ? taut_arena_take(arena, count, sizeof(double)) : NULL;
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_net_document_points(&points_at, 0, (int)count, points, NULL, error);
    if (status == TAUT_OK && is_weighted) {
        status = taut_net_document_weights(&weights_at, 0, (int)count, weights, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    return taut_json_within(at, taut_curve_new(name, t, points, weights, curve, error), error);
}

taut_status taut_curve_document_read(const taut_json *at, taut_curve **curve, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = read_curve(at, arena, curve, error);
    taut_arena_free(arena);
    return status;
}

/* The points with their texts, a row a line. */
static void write_exact(taut_json_out *out, size_t rows, size_t columns,
                        const taut_surface *surface)
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
    taut_json_pair_text(out, "name", taut_surface_name(surface));
    taut_json_key(out, "u");
    taut_basis_document_write(out, u);
    taut_json_key(out, "v");
    taut_basis_document_write(out, v);
    taut_json_key(out, "points");
    if (taut_surface_exact(surface) != NULL) {
        write_exact(out, rows, columns, surface);
    } else {
        taut_json_put_net(out, rows, columns, 3, taut_surface_points(surface));
    }
    if (taut_surface_weights(surface) != NULL) {
        taut_json_pair_net(out, "weights", rows, columns, 1, taut_surface_weights(surface));
    }
    taut_json_close(out, '}');
}

void taut_curve_document_write(taut_json_out *out, const taut_curve *curve)
{
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve));

    taut_json_open(out, '{');
    taut_json_pair_text(out, "name", taut_curve_name(curve));
    taut_json_key(out, "t");
    taut_basis_document_write(out, taut_curve_t(curve));
    taut_json_pair_net(out, "points", 0, count, 3, taut_curve_points(curve));
    if (taut_curve_weights(curve) != NULL) {
        taut_json_pair_net(out, "weights", 0, count, 1, taut_curve_weights(curve));
    }
    taut_json_close(out, '}');
}
