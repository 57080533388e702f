/* pipe.c -- the problem `pipe`: two axes and what joins them (docs/format.md). */
#include "io/problem/pipe.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "taut/pipe.h"

#include <string.h>

static const char *const members[] = {"radius",       "polygon", "from",     "to",     "axes",
                                      "run",          "closed",  "shape",    "domain", "frame",
                                      "pipe_lengths", "joint",   "sections", "radii",  "surface",
                                      "bend_radius",  "caps",    NULL};
static const char *const surface_words[] = {"canal", "naive-sweep", NULL};
static const char *const section_members[] = {"a", "b", "direction", NULL};
static const char *const end_members[] = {"point", "direction", "handle", NULL};
static const char *const shape_members[] = {"alpha", "beta", "gamma", "auto", NULL};
static const char *const goal_words[] = {"bending", "curvature", NULL};
static const char *const domain_words[] = {"strict", "extended", NULL};
static const char *const joint_words[] = {"g1", "g2", NULL};
static const char *const frame_words[] = {"rotation-minimizing", "frenet", NULL};

/* A member that is one of a few words; `value` stays as it is where it is missing. */
static taut_status read_word(const taut_json *object, const char *key, const char *const *words,
                             int *value, taut_error *error)
{
    const taut_json at = taut_json_member(object, key);
    return at.value == NULL ? TAUT_OK : taut_json_word(&at, words, value, error);
}

static taut_status read_positive(const taut_json *at, double *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    return status == TAUT_OK && !(*value > 0) ? taut_json_expected(at, error, "a positive length")
                                              : status;
}

static taut_status read_polygon(const taut_json *at, taut_pipe_problem *data, taut_error *error)
{
    size_t count = 0;
    taut_status status = taut_json_array(at, 4, 4, "points V_0 to V_3", &count, error);
    for (size_t i = 0; i < 4 && status == TAUT_OK; i++) {
        const taut_json point = taut_json_item(at, i);
        status = taut_json_numbers(&point, 3, data->polygon[i], error);
    }
    return status;
}

static taut_status read_end(const taut_json *at, taut_pipe_end *end, taut_error *error)
{
    const taut_json point = taut_json_member(at, "point");
    const taut_json direction = taut_json_member(at, "direction");
    const taut_json handle = taut_json_member(at, "handle");
    taut_status status = taut_json_object(at, end_members, error);
    if (status == TAUT_OK) {
        status = taut_json_numbers(&point, 3, end->point, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_numbers(&direction, 3, end->direction, error);
    }
    if (status == TAUT_OK && end->direction[0] == 0 && end->direction[1] == 0 &&
        end->direction[2] == 0) {
        status = taut_json_expected(&direction, error, "a vector that is not zero");
    }
    if (status == TAUT_OK && handle.value != NULL) {
        status = read_positive(&handle, &end->handle, error);
    }
    return status;
}

/* One of `polygon`, `from` and `to`, `axes`, `run`. */
static taut_status read_axis(const taut_json *document, taut_arena *arena, taut_pipe_problem *data,
                             taut_error *error)
{
    const taut_json run = taut_json_member(document, "run");
    const taut_json closed = taut_json_member(document, "closed");
    const taut_json polygon = taut_json_member(document, "polygon");
    const taut_json from = taut_json_member(document, "from");
    const taut_json to = taut_json_member(document, "to");
    const taut_json axes = taut_json_member(document, "axes");
    const int ends = from.value != NULL || to.value != NULL;
    const int given = (polygon.value != NULL) + ends + (axes.value != NULL) + (run.value != NULL);
    taut_status status = TAUT_OK;
    size_t count = 0;

    if (given != 1) {
        return taut_json_fail(
            document, error, "value", given, 1,
            "found %s of \"polygon\", \"from\" with \"to\", \"axes\" and \"run\", expected one: "
            "where the axis comes from",
            given == 0 ? "none" : "more than one");
    }
    if (run.value != NULL) {
        return taut_document_pipe_run(document, arena, data, error);
    }
    if (closed.value != NULL) {
        return taut_json_fail(&closed, error, "value", taut_none, taut_none,
                              "found \"closed\" without \"run\": only a run comes round");
    }
    if (polygon.value != NULL) {
        data->axis = TAUT_PIPE_POLYGON;
        return read_polygon(&polygon, data, error);
    }
    if (ends) {
        data->axis = TAUT_PIPE_ENDS;
        status = read_end(&from, &data->ends[0], error);
        return status == TAUT_OK ? read_end(&to, &data->ends[1], error) : status;
    }
    data->axis = TAUT_PIPE_FEET;
    status = taut_json_array(&axes, 2, 2, "lines", &count, error);
    for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json line = taut_json_item(&axes, i);
        status = read_end(&line, &data->ends[i], error);
    }
    return status;
}

/* "auto", { "auto": goal }, or the three numbers. */
static taut_status read_shape(const taut_json *document, taut_pipe_problem *data, taut_error *error)
{
    const taut_json at = taut_json_member(document, "shape");
    const taut_json chosen = taut_json_member(&at, "auto");
    double *const numbers[] = {&data->alpha, &data->beta, &data->gamma};
    const char *text = taut_json_text_at(&at);
    int goal = 0;
    taut_status status = TAUT_OK;

    data->shape = TAUT_PIPE_LEAST_BENDING;
    if (at.value == NULL || (text != NULL && strcmp(text, "auto") == 0)) {
        return TAUT_OK;
    }
    if (taut_json_kind_at(&at) != TAUT_JSON_OBJECT) {
        return taut_json_expected(&at, error, "\"auto\", or an object with alpha, beta and gamma");
    }
    status = taut_json_object(&at, shape_members, error);
    if (status == TAUT_OK && chosen.value != NULL) {
        if (taut_json_count_at(&at) != 1) {
            return taut_json_fail(&at, error, "value", taut_none, taut_none,
                                  "found shape numbers beside \"auto\", which chooses them");
        }
        status = taut_json_word(&chosen, goal_words, &goal, error);
        data->shape = goal == 1 ? TAUT_PIPE_LEAST_CURVATURE : TAUT_PIPE_LEAST_BENDING;
        return status;
    }
    data->shape = TAUT_PIPE_SHAPE_GIVEN;
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        const taut_json number = taut_json_member(&at, shape_members[k]);
        if (k != 1 || number.value != NULL || data->joint == TAUT_PIPE_TANGENT) {
            status = taut_json_number(&number, numbers[k], error);
        }
    }
    return status;
}

/* [l1, l2], each a length or null for a half line. */
static taut_status read_lengths(const taut_json *document, taut_pipe_problem *data,
                                taut_error *error)
{
    const taut_json at = taut_json_member(document, "pipe_lengths");
    size_t count = 0;
    taut_status status =
        at.value == NULL ? TAUT_OK : taut_json_array(&at, 2, 2, "lengths", &count, error);
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        const taut_json length = taut_json_item(&at, i);
        if (taut_json_kind_at(&length) != TAUT_JSON_NULL) {
            status = read_positive(&length, &data->lengths[i], error);
        }
    }
    return status;
}

/* `radius`, two `radii`, or two `sections`. */
static taut_status read_sections(const taut_json *document, taut_pipe_problem *data,
                                 taut_error *error)
{
    const taut_json radius = taut_json_member(document, "radius");
    const taut_json at = taut_json_member(document, "sections");
    const taut_json radii = taut_json_member(document, "radii");
    size_t count = 0;
    taut_status status = TAUT_OK;
    if ((radius.value != NULL) + (at.value != NULL) + (radii.value != NULL) > 1) {
        return taut_json_fail(document, error, "value", taut_none, taut_none,
                              "found more than one of \"radius\", \"radii\" and \"sections\", "
                              "expected one: how wide the pipes are");
    }
    if (radii.value != NULL) {
        status = taut_json_array(&radii, 2, 2, "radii, of pipe 1 and pipe 2", &count, error);
        for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
            const taut_json item = taut_json_item(&radii, i);
            status = read_positive(&item, &data->radii[i], error);
        }
        return status == TAUT_OK
                   ? read_word(document, "surface", surface_words, &data->naive, error)
                   : status;
    }
    if (at.value == NULL) {
        return read_positive(&radius, &data->radius, error);
    }
    status = taut_json_array(&at, 2, 2, "sections, of pipe 1 and pipe 2", &count, error);
    for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(&at, i);
        const taut_json a = taut_json_member(&item, "a"), b = taut_json_member(&item, "b");
        const taut_json direction = taut_json_member(&item, "direction");
        status = taut_json_object(&item, section_members, error);
        if (status == TAUT_OK) {
            status = read_positive(&a, &data->sections[i].a, error);
        }
        if (status == TAUT_OK) {
            status = read_positive(&b, &data->sections[i].b, error);
        }
        if (status == TAUT_OK) {
            status = taut_json_numbers(&direction, 3, data->sections[i].direction, error);
        }
    }
    return status;
}

static taut_status read_bend_radius(const taut_json *document, taut_pipe_problem *data,
                                    taut_error *error)
{
    const taut_json at = taut_json_member(document, "bend_radius");
    return at.value == NULL ? TAUT_OK : read_positive(&at, &data->bend_radius, error);
}

static taut_status pipe_read(const taut_json *document, taut_problem *problem, taut_error *error)
{
    taut_pipe_problem *const data = taut_arena_take(problem->arena, 1, sizeof *data);
    int frame = TAUT_PIPE_ROTATION_MINIMIZING, joint = TAUT_PIPE_TANGENT;
    taut_status status =
        data != NULL ? read_sections(document, data, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = read_axis(document, problem->arena, data, error);
    }
    if (status == TAUT_OK) {
        status = read_word(document, "joint", joint_words, &joint, error);
    }
    if (status == TAUT_OK) {
        data->joint = (taut_pipe_joint)joint;
        status = read_shape(document, data, error);
    }
    if (status == TAUT_OK) {
        status = read_word(document, "domain", domain_words, &data->extended, error);
    }
    if (status == TAUT_OK) {
        status = read_word(document, "frame", frame_words, &frame, error);
    }
    if (status == TAUT_OK) {
        status = read_lengths(document, data, error);
    }
    if (status == TAUT_OK) {
        status = read_bend_radius(document, data, error);
    }
    if (status == TAUT_OK) {
        status = taut_document_pipe_flag(document, "caps", &data->caps, error);
    }
    if (status == TAUT_OK) {
        data->frame = (taut_pipe_frame)frame;
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_pipe = {
    .members = members,
    .read = pipe_read,
};
