#include "io/problem/net_document.h"

#include "core/fail.h"
#include "io/json/number_value.h"
#include "io/model/basis.h"
#include "taut/limits.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POINT_WORK = 40 }; /* operations of a point, as pulses count them */

taut_status taut_net_document_shape(const taut_json *points, int *rows, int *columns,
                                    taut_error *error)
{
    size_t count = 0, length = 0;
    taut_status status =
        taut_json_array(points, 1, TAUT_COUNT_MAX, "rows of points", &count, error);

    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json row = taut_json_item(points, i);
        const int is_array = taut_json_kind_at(&row) == TAUT_JSON_ARRAY;
        if (i == 0) {
            status = taut_json_array(&row, 1, TAUT_COUNT_MAX, "points", &length, error);
        } else if (!is_array || taut_json_count_at(&row) != length) {
            status = taut_json_refuse(&row, error, is_array ? "size" : "type",
                                      "an array of %zu points, as row 0 has", length);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    if ((double)count * (double)length > TAUT_POINTS_MAX) {
        return taut_json_fail(points, error, "size", (double)count * (double)length,
                              TAUT_POINTS_MAX,
                              "found a net of %zu x %zu points, expected at most %d points", count,
                              length, TAUT_POINTS_MAX);
    }
    *rows = (int)count;
    *columns = (int)length;
    return TAUT_OK;
}

/* A basis whose functions must be as many as the points along it. */
static taut_status read_basis(const taut_json *object, const char *key, int functions,
                              const char *things, const char *where, taut_arena *arena,
                              const taut_basis **basis, taut_error *error)
{
    const taut_json at = taut_json_member(object, key);
    const taut_json points = taut_json_member(object, "points");
    const taut_status status = taut_basis_document_keep(&at, functions, arena, basis, error);

    if (status == TAUT_OK && taut_basis_count(*basis) != functions) {
        return taut_json_fail(&points, error, "size", functions, taut_basis_count(*basis),
                              "found %d %s%s%s, expected %d, one for each function of \"%s\"",
                              functions, things, functions == 1 ? "" : "s", where,
                              taut_basis_count(*basis), key);
    }
    return status;
}

/* More numbers than three: some may be halves of 1,5. */
static taut_status refuse_point(const taut_json *at, taut_error *error)
{
    const taut_status status = taut_json_refuse(at, error, "type", "a point [x, y, z]");
    const taut_json first = taut_json_item(at, 0);
    const size_t used = error != NULL ? strlen(error->message) : 0;
    if (error != NULL && taut_json_kind_at(at) == TAUT_JSON_ARRAY && taut_json_count_at(at) > 3 &&
        taut_json_kind_at(&first) == TAUT_JSON_NUMBER) {
        snprintf(error->message + used, sizeof error->message - used,
                 " (decimal numbers have a point: 1.5, not 1,5)");
    }
    return status;
}

taut_status taut_net_document_point(const taut_json *at, double point[3], taut_error *error)
{
    if (taut_json_kind_at(at) != TAUT_JSON_ARRAY || taut_json_count_at(at) != 3) {
        return refuse_point(at, error);
    }
    double read[3];
    for (size_t c = 0; c < 3; c++) {
        const taut_json item = taut_json_item(at, c);
        const char *text = taut_json_text_at(&item);
        if (text == NULL) {
            const taut_status status = taut_json_number(&item, &read[c], error);
            if (status != TAUT_OK) {
                return status;
            }
        } else if (!taut_rational_value(text, &read[c]) || !isfinite(read[c])) {
            return taut_json_refuse(
                &item, error, "value",
                "a number, or a rational one as \"3/4\", not too large and in at most "
                "20000 bytes");
        }
    }
    memcpy(point, read, sizeof read);
    return TAUT_OK;
}

static int list_row_texts(const taut_json *row, int columns, const char **texts)
{
    int found = 0;
    for (int j = 0; j < columns; j++) {
        const taut_json point = taut_json_item(row, (size_t)j);
        for (int c = 0; c < 3; c++) {
            const taut_json at = taut_json_item(&point, (size_t)c);
            const char *text = taut_json_text_at(&at);
            found = found || text != NULL;
            if (texts != NULL) {
                texts[3 * j + c] = text;
            }
        }
    }
    return found;
}

void taut_net_document_texts(const taut_json *at, int rows, int columns, const char **texts,
                             int *found)
{
    *found = rows == 0 && list_row_texts(at, columns, texts);
    for (int i = 0; i < rows; i++) {
        const taut_json row = taut_json_item(at, (size_t)i);
        const char **of_row = texts != NULL ? texts + 3 * (size_t)i * (size_t)columns : NULL;
        *found = list_row_texts(&row, columns, of_row) || *found;
        taut_pulse_beat(at->pulse, POINT_WORK * (double)columns);
    }
}

/* A row of points, or of nulls where `known` is given. */
static taut_status read_row(const taut_json *row, int columns, double *points, unsigned char *known,
                            taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int j = 0; status == TAUT_OK && j < columns; j++) {
        const taut_json at = taut_json_item(row, (size_t)j);
        if (known != NULL && taut_json_kind_at(&at) == TAUT_JSON_NULL) {
            memset(points + 3 * j, 0, 3 * sizeof(double));
            known[j] = 0;
        } else if (known != NULL && taut_json_kind_at(&at) != TAUT_JSON_ARRAY) {
            status =
                taut_json_refuse(&at, error, "type", "a point [x, y, z], or null: to be found");
        } else {
            status = taut_net_document_point(&at, points + 3 * j, error);
            if (known != NULL) {
                known[j] = 1;
            }
        }
    }
    return status;
}

taut_status taut_net_document_points(const taut_json *at, int rows, int columns, double *points,
                                     unsigned char *known, taut_error *error)
{
    const size_t length = (size_t)columns;
    taut_status status = TAUT_OK;

    if (rows == 0) {
        return read_row(at, columns, points, known, error);
    }
    for (size_t i = 0; status == TAUT_OK && i < (size_t)rows; i++) {
        const taut_json row = taut_json_item(at, i);
        status = read_row(&row, columns, points + 3 * i * length,
                          known != NULL ? known + i * length : NULL, error);
        if (status == TAUT_OK && taut_pulse_beat(at->pulse, POINT_WORK * (double)columns)) {
            status = taut_fail_status(error, TAUT_INTERRUPTED);
        }
    }
    return status;
}

static taut_status read_weight_row(const taut_json *row, int columns, double *weights,
                                   taut_error *error)
{
    taut_status status = taut_json_numbers(row, (size_t)columns, weights, error);
    for (int j = 0; status == TAUT_OK && j < columns; j++) {
        if (!(weights[j] > 0)) {
            const taut_json at = taut_json_item(row, (size_t)j);
            status = taut_json_refuse(&at, error, "value", "a positive weight");
        }
    }
    return status;
}

taut_status taut_net_document_weights(const taut_json *at, int rows, int columns, double *weights,
                                      taut_error *error)
{
    const size_t length = (size_t)columns;
    taut_status status = TAUT_OK;
    size_t count = 0;

    if (rows == 0) {
        return read_weight_row(at, columns, weights, error);
    }
    status = taut_json_array(at, (size_t)rows, (size_t)rows, "rows of weights", &count, error);
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json row = taut_json_item(at, i);
        status = read_weight_row(&row, columns, weights + i * length, error);
    }
    return status;
}

static taut_status check_weighable(const taut_json *document, const taut_net_document *net,
                                   taut_error *error)
{
    const taut_json at = taut_json_member(document, "weights");
    const taut_basis *basis = taut_basis_allows_weights(net->u) ? net->v : net->u;
    if (!taut_basis_allows_weights(basis)) {
        return taut_json_fail(&at, error, "conflict", taut_none, taut_none,
                              "found weights, expected none: a basis of type \"%s\" carries no "
                              "weights",
                              taut_basis_type(basis));
    }
    return TAUT_OK;
}

/* Unknown points may be null where `net` is a problem's. */
static taut_status read_net(const taut_json *document, taut_arena *arena, int is_problem,
                            taut_net_document *net, taut_error *error)
{
    const taut_json points = taut_json_member(document, "points");
    const taut_json weights = taut_json_member(document, "weights");
    const int is_weighted = weights.value != NULL;
    taut_net_document read = {NULL, NULL, NULL, NULL, NULL};
    int rows = 0, columns = 0;
    taut_status status = taut_net_document_shape(&points, &rows, &columns, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(document, "u", rows, "row", "", arena, &read.u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(document, "v", columns, "point", " in each row", arena, &read.v, error);
    if (status == TAUT_OK && is_weighted && is_problem) {
        status = check_weighable(document, &read, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const size_t count = (size_t)rows * (size_t)columns;
    read.points = taut_arena_take(arena, 3 * count, sizeof(double));
    read.known = is_problem ? taut_arena_take(arena, count, 1) : NULL;
    read.weights = is_weighted ? taut_arena_take(arena, count, sizeof(double)) : NULL;
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_net_document_points(&points, rows, columns, read.points, read.known, error);
    if (status == TAUT_OK && is_weighted) {
        status = taut_net_document_weights(&weights, rows, columns, read.weights, error);
    }
    *net = read;
    return status;
}

void taut_net_document_read(taut_reader *document, taut_arena *arena, taut_net_document *net)
{
    if (document->status == TAUT_OK) {
        document->status = read_net(document->object, arena, 1, net, document->error);
    }
}

/* A ce-bezier basis is one for curves, the axes of pipes. */
void taut_net_document_check_bases(taut_reader *document, const taut_basis *u, const taut_basis *v)
{
    for (int d = 0; d < 2 && document->status == TAUT_OK; d++) {
        const taut_json at = taut_json_member(document->object, d == 0 ? "u" : "v");
        if (strcmp(taut_basis_type(d == 0 ? u : v), "ce-bezier") == 0) {
            document->status =
                taut_json_fail(&at, document->error, "basis", taut_none, taut_none,
                               "found a basis of type \"ce-bezier\", expected any other: it is a "
                               "basis of pipe axes, not of surfaces that are solved for");
        }
    }
}

taut_status taut_net_document_read_known(const taut_json *object, taut_arena *arena,
                                         taut_net_document *net, taut_error *error)
{
    return read_net(object, arena, 0, net, error);
}

static const char *const through_members[] = {"u", "v", "point", NULL};

static taut_status read_through_item(const taut_json *at, void *into, taut_error *error)
{
    taut_through *const to = into;
    taut_reader in = taut_reader_of(at, through_members, error);

    to->u = to->v = NAN;
    taut_reader_numbers(&in, "point", 3, to->point);
    if (taut_reader_has(&in, "u") || taut_reader_has(&in, "v")) {
        taut_reader_number(&in, "u", &to->u);
        taut_reader_number(&in, "v", &to->v);
    }
    return in.status;
}

void taut_net_document_through(taut_reader *document, taut_arena *arena,
                               taut_dirichlet_problem *data)
{
    size_t count = 0;

    if (!taut_reader_has(document, "through")) {
        return;
    }
    taut_reader_array(document, "through", 1, TAUT_THROUGH_MAX, "points to pass through", &count);
    if (document->status != TAUT_OK) {
        return;
    }
    taut_through *all = taut_arena_take(arena, count, sizeof *all);
    if (all == NULL) {
        document->status = taut_fail_memory(document->error);
        return;
    }
    taut_reader_items(document, "through", count, "points to pass through", read_through_item, all,
                      sizeof *all);
    data->through = all;
    data->through_count = document->status == TAUT_OK ? (int)count : 0;
}
