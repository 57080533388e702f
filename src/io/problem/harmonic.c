/* harmonic.c -- the problem `harmonic`: two opposite rows, or a row and the derivative
 * across it (docs/format.md). */
#include "taut/harmonic.h"
#include "basis/basis_ops.h"
#include "core/fail.h"
#include "io/model/basis.h"
#include "io/model/surface.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/harmonic_boundary.h"
#include "io/problem/net_document.h"

#include <string.h>

static const char *const members[] = {
    "name", "u",      "v",        "points", "from",   "edge", "cross_derivative",
    "even", "insist", "boundary", "known",  "widths", "fit",  NULL};

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

static taut_status check_basis(const taut_json *document, const char *key, const taut_basis *basis,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    if (strcmp(taut_basis_type(basis), "bezier") != 0) {
        return taut_json_fail(&at, error, "value", taut_none, taut_none,
                              "found a basis of type \"%s\", expected \"bezier\"",
                              taut_basis_type(basis));
    }
    return TAUT_OK;
}

/* A bezier basis says itself how many functions it has. */
static taut_status read_basis(const taut_json *document, const char *key, taut_arena *arena,
                              const taut_basis **basis, taut_error *error)
{
    static const char *const any[] = {"type", "degree", "range", NULL};
    const taut_json at = taut_json_member(document, key);
    const taut_json degree = taut_json_member(&at, "degree");
    taut_basis *made = NULL;
    int n = 0;
    taut_status status = taut_json_object(&at, any, error);

    if (status == TAUT_OK) {
        status = taut_json_integer(&degree, 1, TAUT_DEGREE_MAX, &n, error);
    }
    if (status == TAUT_OK) {
        status = taut_basis_document_read(&at, n + 1, &made, error);
    }
    if (status == TAUT_OK && !taut_arena_keep(arena, made, release_basis)) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        *basis = made;
    }
    return status;
}

/* The texts of rational coordinates; NULL where all are numbers. */
static taut_status read_texts(const taut_json *at, int rows, int columns, taut_arena *arena,
                              const char *const **texts, taut_error *error)
{
    const size_t count = 3 * (size_t)(rows > 0 ? rows : 1) * (size_t)columns;
    const char **found = taut_arena_take(arena, count, sizeof *found);
    int any = 0;

    if (found == NULL) {
        return taut_fail_memory(error);
    }
    taut_net_document_texts(at, rows, columns, found, &any);
    for (size_t k = 0; any && k < count; k++) {
        if (found[k] != NULL) {
            found[k] = taut_arena_text(arena, found[k]);
            if (found[k] == NULL) {
                return taut_fail_memory(error);
            }
        }
    }
    *texts = any ? found : NULL;
    return TAUT_OK;
}

/* A list of `count` points. */
static taut_status read_row(const taut_json *document, const char *key, int count,
                            taut_arena *arena, const double **row, const char *const **texts,
                            taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    double *points = taut_arena_take(arena, 3 * (size_t)count, sizeof(double));
    size_t found = 0;
    taut_status status = points != NULL ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = taut_json_array(&at, (size_t)count, (size_t)count, "points", &found, error);
    }
    if (status == TAUT_OK) {
        status = taut_net_document_points(&at, 0, count, points, NULL, error);
    }
    if (status == TAUT_OK) {
        status = read_texts(&at, 0, count, arena, texts, error);
    }
    *row = points;
    return status;
}

static taut_status read_derivative(const taut_json *document, taut_arena *arena,
                                   taut_harmonic_problem *data, taut_error *error)
{
    const taut_json points = taut_json_member(document, "points");
    taut_status status = TAUT_OK;

    if (points.value != NULL) {
        return taut_json_fail(
            &points, error, "value", taut_none, taut_none,
            "found \"points\" beside \"from\": the edge and the derivative across "
            "it say all");
    }
    data->from_derivative = 1;
    status = read_basis(document, "u", arena, &data->u, error);
    if (status == TAUT_OK) {
        status = read_basis(document, "v", arena, &data->v, error);
    }
    if (status == TAUT_OK) {
        status = read_row(document, "edge", taut_basis_count(data->v), arena, &data->edge,
                          &data->exact_edge, error);
    }
    if (status == TAUT_OK) {
        status = read_row(document, "cross_derivative", taut_basis_count(data->v), arena,
                          &data->cross_derivative, &data->exact_cross_derivative, error);
    }
    return status;
}

static taut_status read_net(const taut_json *document, taut_arena *arena,
                            taut_harmonic_problem *data, taut_error *error)
{
    static const char *const strangers[] = {"edge", "cross_derivative"};
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    taut_status status = taut_net_document_read(document, arena, &net, error);

    for (int i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json at = taut_json_member(document, strangers[i]);
        if (at.value != NULL) {
            status = taut_json_fail(&at, error, "value", taut_none, taut_none,
                                    "found \"%s\" without \"from\": \"derivative\"", strangers[i]);
        }
    }
    if (status == TAUT_OK) {
        status = check_basis(document, "u", net.u, error);
    }
    if (status == TAUT_OK) {
        status = check_basis(document, "v", net.v, error);
    }
    if (status == TAUT_OK) {
        const taut_json points = taut_json_member(document, "points");
        status = read_texts(&points, taut_basis_count(net.u), taut_basis_count(net.v), arena,
                            &data->exact_points, error);
    }
    data->u = net.u;
    data->v = net.v;
    data->points = net.points;
    data->known = net.known;
    return status;
}

/* A member that is true or false. */
static taut_status read_choices(const taut_json *document, taut_arena *arena,
                                taut_harmonic_problem *data, taut_error *error)
{
    static const char *const repairs[] = {"refuse", "corner", "project", "raise", NULL};
    const taut_json at = taut_json_member(document, "even");
    const taut_json fit = taut_json_member(document, "fit");
    const char *name = "";
    int word = TAUT_EVEN_REFUSE;
    taut_status status = taut_name_document_read(document, &name, error);

    if (status == TAUT_OK) {
        status = taut_json_flag(document, "fit", &data->fit, error);
    }
    if (status == TAUT_OK && data->fit && (data->from_derivative || at.value != NULL)) {
        status = taut_json_fail(&fit, error, "value", taut_none, taut_none,
                                "found \"fit\" beside \"%s\": it takes four boundary rows as they "
                                "are",
                                data->from_derivative ? "from" : "even");
    }
    if (status == TAUT_OK && at.value != NULL) {
        status = taut_json_word(&at, repairs, &word, error);
    }
    if (status == TAUT_OK && data->from_derivative &&
        (word == TAUT_EVEN_CORNER || word == TAUT_EVEN_PROJECT)) {
        status = taut_json_expected(&at, error, "\"refuse\" or \"raise\", with a derivative");
    }
    if (status == TAUT_OK) {
        data->even = (taut_harmonic_even)word;
        status = taut_json_flag(document, "insist", &data->insist, error);
    }
    if (status == TAUT_OK && name[0] != '\0') {
        data->name = taut_arena_text(arena, name);
        status = data->name != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    return status;
}

static taut_status harmonic_read(const taut_json *document, taut_problem *problem,
                                 taut_error *error)
{
    static const char *const sources[] = {"derivative", NULL};
    taut_harmonic_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    const taut_json from = taut_json_member(document, "from");
    int word = 0;
    taut_status status = data != NULL ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK && from.value != NULL) {
        status = taut_json_word(&from, sources, &word, error);
    }
    if (status == TAUT_OK) {
        status = taut_boundary_document_is(document)
                     ? taut_harmonic_boundary_read(document, problem, data, error)
                 : from.value != NULL ? read_derivative(document, problem->arena, data, error)
                                      : read_net(document, problem->arena, data, error);
    }
    if (status == TAUT_OK) {
        status = read_choices(document, problem->arena, data, error);
    }
    if (status == TAUT_OK) {
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_harmonic = {
    .members = members,
    .read = harmonic_read,
};
