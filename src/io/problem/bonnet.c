/* bonnet.c -- the problem `bonnet`: minimal surfaces with planar curvature lines
 * (docs/format.md). */
#include "taut/bonnet.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"

static const char *const members[] = {"lambda", "sign",      "alpha", "beta",   "mesh", "segments",
                                      "theta",  "normalize", "start", "frames", NULL};

/* A number; left as it is where the member is missing and may be. */
static taut_status read_number(const taut_json *document, const char *key, int needed,
                               double *value, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    if (at.value == NULL && !needed) {
        return TAUT_OK;
    }
    return taut_json_number(&at, value, error);
}

/* One of two words: *value is 0 or 1. */
static taut_status read_word(const taut_json *document, const char *key, int needed,
                             const char *const *words, int *value, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    if (at.value == NULL && !needed) {
        return TAUT_OK;
    }
    return taut_json_word(&at, words, value, error);
}

/* A number, or with "frames" the first and the last. */
static taut_status read_lambda(const taut_json *document, taut_bonnet_problem *data,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, "lambda");
    const taut_json frames = taut_json_member(document, "frames");
    taut_status status = TAUT_OK;

    if (frames.value != NULL) {
        status = taut_json_integer(&frames, 2, TAUT_OBJECTS_MAX, &data->frames, error);
        return status == TAUT_OK ? taut_json_numbers(&at, 2, data->lambda, error) : status;
    }
    if (taut_json_kind_at(&at) == TAUT_JSON_ARRAY) {
        return taut_json_fail(&at, error, "value", taut_none, taut_none,
                              "found two numbers, expected one, or \"frames\": how many surfaces");
    }
    status = taut_json_number(&at, &data->lambda[0], error);
    data->lambda[1] = data->lambda[0];
    return status;
}

static taut_status read_segments(const taut_json *document, taut_bonnet_problem *data,
                                 taut_error *error)
{
    const taut_json at = taut_json_member(document, "segments");
    size_t count = 0;
    taut_status status = TAUT_OK;

    if (at.value == NULL) {
        return TAUT_OK;
    }
    status = taut_json_array(&at, 2, 2, "numbers", &count, error);
    for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(&at, i);
        status = taut_json_integer(&item, 1, TAUT_COUNT_MAX / 2, &data->segments[i], error);
    }
    return status;
}

static taut_status bonnet_read(const taut_json *document, taut_problem *problem, taut_error *error)
{
    static const char *const signs[] = {"+", "-", NULL}, *const meshes[] = {"bezier", "bspline",
                                                                            NULL};
    taut_bonnet_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    const taut_json start = taut_json_member(document, "start");
    int minus = 0;
    taut_status status =
        data != NULL ? read_lambda(document, data, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = read_word(document, "sign", 1, signs, &minus, error);
    }
    if (status == TAUT_OK) {
        status = read_number(document, "alpha", 1, &data->alpha, error);
    }
    if (status == TAUT_OK) {
        status = read_number(document, "beta", 1, &data->beta, error);
    }
    if (status == TAUT_OK) {
        status = read_word(document, "mesh", 0, meshes, &data->bspline, error);
    }
    if (status == TAUT_OK) {
        status = read_segments(document, data, error);
    }
    if (status == TAUT_OK) {
        status = read_number(document, "theta", 0, &data->theta, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_flag(document, "normalize", &data->normalize, error);
    }
    if (status == TAUT_OK && start.value != NULL) {
        status = taut_json_numbers(&start, 2, data->start, error);
    }
    if (status == TAUT_OK) {
        data->sign = minus ? -1 : 1;
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_bonnet = {
    .members = members,
    .read = bonnet_read,
};
