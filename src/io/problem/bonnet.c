/* bonnet.c -- the problem `bonnet`: minimal surfaces with planar curvature lines
 * (docs/format.md). */
#include "taut/bonnet.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"

static const char *const members[] = {"lambda", "sign",      "alpha", "beta",   "mesh", "segments",
                                      "theta",  "normalize", "start", "frames", NULL};

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
        return taut_json_fail(&at, error, "size", 2, 1,
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

/* The family, its sign and its segments. */
static taut_status read_family(const taut_json *document, taut_bonnet_problem *data,
                               taut_error *error)
{
    static const char *const signs[] = {"+", "-", NULL};
    const taut_json sign = taut_json_member(document, "sign");
    const taut_json alpha = taut_json_member(document, "alpha");
    const taut_json beta = taut_json_member(document, "beta");
    int minus = 0;
    taut_status status = read_lambda(document, data, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_word(&sign, signs, &minus, error);
    if (status != TAUT_OK) {
        return status;
    }
    data->sign = minus ? -1 : 1;
    status = taut_json_number(&alpha, &data->alpha, error);
    return status == TAUT_OK ? taut_json_number(&beta, &data->beta, error) : status;
}

/* Members that may be missing. */
static taut_status read_choices(const taut_json *document, taut_bonnet_problem *data,
                                taut_error *error)
{
    static const char *const meshes[] = {"bezier", "bspline", NULL};
    const taut_json start = taut_json_member(document, "start");
    taut_status status = taut_member_word(document, "mesh", meshes, &data->bspline, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = read_segments(document, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_number(document, "theta", &data->theta, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_flag(document, "normalize", &data->normalize, error);
    return status == TAUT_OK && start.value != NULL
               ? taut_json_numbers(&start, 2, data->start, error)
               : status;
}

static taut_status bonnet_read(const taut_json *document, taut_problem *problem, taut_error *error)
{
    taut_bonnet_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    taut_status status = TAUT_OK;

    if (data == NULL) {
        return taut_fail_memory(error);
    }
    problem->data = data;
    status = read_family(document, data, error);
    return status == TAUT_OK ? read_choices(document, data, error) : status;
}

const taut_document_ops taut_document_bonnet = {
    .members = members,
    .read = bonnet_read,
};
