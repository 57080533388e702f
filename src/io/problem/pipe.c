/* pipe.c -- the problem `pipe`: two axes and what joins them, or a run (docs/format.md).
 *
 *     "run": [ [x, y, z], ... ]                                   corners, from end to end
 *            [ { "from": P, "to": Q }, ... ]                      straight pipes, in order of flow
 *            [ ..., { "point": P, "direction": D }, ... ]         one of no length
 */
#include "problem/pipe.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"

#include <string.h>

enum { LEGS_MAX = 10000 };

static const char *const members[] = {"radius",       "polygon", "from",     "to",     "axes",
                                      "run",          "closed",  "shape",    "domain", "frame",
                                      "pipe_lengths", "joint",   "sections", "radii",  "surface",
                                      "bend_radius",  "caps",    NULL};
static const char *const surface_words[] = {"canal", "naive-sweep", NULL};
static const char *const section_members[] = {"a", "b", "direction", NULL};
static const char *const end_members[] = {"point", "direction", "handle", NULL};
static const char *const leg_members[] = {"from", "to", "point", "direction", NULL};
static const char *const shape_members[] = {"alpha", "beta", "gamma", "auto", NULL};
static const char *const goal_words[] = {"bending", "curvature", NULL};
static const char *const domain_words[] = {"strict", "extended", NULL};
static const char *const joint_words[] = {"g1", "g2", NULL};
static const char *const frame_words[] = {"rotation-minimizing", "frenet", NULL};
/* What says of a single pipe that which a run settles itself. */
static const char *const not_of_runs[] = {"frame", "pipe_lengths", "sections",
                                          "radii", "surface",      NULL};

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

/* A member that is a positive length; `value` stays as it is where it is missing. */
static taut_status read_length(const taut_json *object, const char *key, double *value,
                               taut_error *error)
{
    const taut_json at = taut_json_member(object, key);
    return at.value == NULL ? TAUT_OK : read_positive(&at, value, error);
}

static taut_status read_direction(const taut_json *at, double direction[3], taut_error *error)
{
    const taut_status status = taut_json_numbers(at, 3, direction, error);
    const int is_zero = direction[0] == 0 && direction[1] == 0 && direction[2] == 0;
    return status == TAUT_OK && is_zero ? taut_json_expected(at, error, "a vector that is not zero")
                                        : status;
}

static taut_status read_polygon(const taut_json *at, double polygon[4][3], taut_error *error)
{
    size_t count = 0;
    taut_status status = taut_json_array(at, 4, 4, "points V_0 to V_3", &count, error);
    for (size_t i = 0; i < 4 && status == TAUT_OK; i++) {
        const taut_json point = taut_json_item(at, i);
        status = taut_json_numbers(&point, 3, polygon[i], error);
    }
    return status;
}

static taut_status read_end(const taut_json *at, taut_pipe_end *end, taut_error *error)
{
    const taut_json point = taut_json_member(at, "point");
    const taut_json direction = taut_json_member(at, "direction");
    taut_status status = taut_json_object(at, end_members, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_numbers(&point, 3, end->point, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_direction(&direction, end->direction, error);
    if (status != TAUT_OK) {
        return status;
    }
    return read_length(at, "handle", &end->handle, error);
}

/* Is there one of `polygon`, `from` and `to`, `axes`, `run`, and `closed` with the last only? */
static taut_status check_axis(const taut_json *document, taut_error *error)
{
    const taut_json run = taut_json_member(document, "run");
    const taut_json closed = taut_json_member(document, "closed");
    const taut_json polygon = taut_json_member(document, "polygon");
    const taut_json from = taut_json_member(document, "from");
    const taut_json to = taut_json_member(document, "to");
    const taut_json axes = taut_json_member(document, "axes");
    const int ends = from.value != NULL || to.value != NULL;
    const int given = (polygon.value != NULL) + ends + (axes.value != NULL) + (run.value != NULL);

    if (given != 1) {
        return taut_json_fail(
            document, error, given == 0 ? "missing" : "conflict", given, 1,
            "found %s of \"polygon\", \"from\" with \"to\", \"axes\" and \"run\", expected one: "
            "where the axis comes from",
            given == 0 ? "none" : "more than one");
    }
    if (run.value == NULL && closed.value != NULL) {
        return taut_json_fail(&closed, error, "conflict", taut_none, taut_none,
                              "found \"closed\" without \"run\": only a run comes round");
    }
    return TAUT_OK;
}

static taut_status read_axis(const taut_json *document, taut_pipe_axis *axis, taut_error *error)
{
    const taut_json polygon = taut_json_member(document, "polygon");
    const taut_json from = taut_json_member(document, "from");
    const taut_json to = taut_json_member(document, "to");
    const taut_json axes = taut_json_member(document, "axes");
    taut_status status = TAUT_OK;
    size_t count = 0;

    if (polygon.value != NULL) {
        axis->kind = TAUT_PIPE_POLYGON;
        return read_polygon(&polygon, axis->polygon, error);
    }
    if (axes.value == NULL) {
        axis->kind = TAUT_PIPE_ENDS;
        status = read_end(&from, &axis->ends[0], error);
        return status == TAUT_OK ? read_end(&to, &axis->ends[1], error) : status;
    }
    axis->kind = TAUT_PIPE_FEET;
    status = taut_json_array(&axes, 2, 2, "lines", &count, error);
    for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json line = taut_json_item(&axes, i);
        status = read_end(&line, &axis->ends[i], error);
    }
    return status;
}

/* "auto", { "auto": goal }, or the three numbers. */
static taut_status read_shape(const taut_json *document, taut_pipe_joint joint,
                              taut_pipe_shape *shape, taut_error *error)
{
    const taut_json at = taut_json_member(document, "shape");
    const taut_json chosen = taut_json_member(&at, "auto");
    double *const numbers[] = {&shape->alpha, &shape->beta, &shape->gamma};
    const char *text = taut_json_text_at(&at);
    int goal = 0;
    taut_status status = TAUT_OK;

    shape->kind = TAUT_PIPE_LEAST_BENDING;
    if (at.value == NULL || (text != NULL && strcmp(text, "auto") == 0)) {
        return TAUT_OK;
    }
    if (taut_json_kind_at(&at) != TAUT_JSON_OBJECT) {
        return taut_json_expected(&at, error, "\"auto\", or an object with alpha, beta and gamma");
    }
    status = taut_json_object(&at, shape_members, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (chosen.value != NULL) {
        if (taut_json_count_at(&at) != 1) {
            return taut_json_fail(&at, error, "conflict", taut_none, taut_none,
                                  "found shape numbers beside \"auto\", which chooses them");
        }
        status = taut_json_word(&chosen, goal_words, &goal, error);
        shape->kind = goal == 1 ? TAUT_PIPE_LEAST_CURVATURE : TAUT_PIPE_LEAST_BENDING;
        return status;
    }
    shape->kind = TAUT_PIPE_SHAPE_GIVEN;
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        const taut_json number = taut_json_member(&at, shape_members[k]);
        if (k != 1 || number.value != NULL || joint == TAUT_PIPE_G1) {
            status = taut_json_number(&number, numbers[k], error);
        }
    }
    return status;
}

/* `joint`, `shape` and `domain`. */
static taut_status read_blending(const taut_json *document, taut_pipe_joint *joint,
                                 taut_pipe_shape *shape, taut_error *error)
{
    int word = TAUT_PIPE_G1;
    taut_status status = read_word(document, "joint", joint_words, &word, error);
    if (status != TAUT_OK) {
        return status;
    }
    *joint = (taut_pipe_joint)word;
    status = read_shape(document, *joint, shape, error);
    if (status != TAUT_OK) {
        return status;
    }
    return read_word(document, "domain", domain_words, &shape->extended, error);
}

/* [l1, l2], each a length or null for a half line. */
static taut_status read_lengths(const taut_json *document, double lengths[2], taut_error *error)
{
    const taut_json at = taut_json_member(document, "pipe_lengths");
    size_t count = 0;
    taut_status status =
        at.value == NULL ? TAUT_OK : taut_json_array(&at, 2, 2, "lengths", &count, error);
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        const taut_json length = taut_json_item(&at, i);
        if (taut_json_kind_at(&length) != TAUT_JSON_NULL) {
            status = read_positive(&length, &lengths[i], error);
        }
    }
    return status;
}

static taut_status read_radii(const taut_json *document, const taut_json *at,
                              taut_pipe_section *section, taut_error *error)
{
    size_t count = 0;
    int word = 0;
    taut_status status = taut_json_array(at, 2, 2, "radii, of pipe 1 and pipe 2", &count, error);
    for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(at, i);
        status = read_positive(&item, &section->radii[i], error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = read_word(document, "surface", surface_words, &word, error);
    section->kind = word == 1 ? TAUT_PIPE_NAIVE_SWEEP : TAUT_PIPE_CANAL;
    return status;
}

static taut_status read_ellipse(const taut_json *at, taut_pipe_ellipse *ellipse, taut_error *error)
{
    const taut_json a = taut_json_member(at, "a"), b = taut_json_member(at, "b");
    const taut_json direction = taut_json_member(at, "direction");
    taut_status status = taut_json_object(at, section_members, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_positive(&a, &ellipse->a, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_positive(&b, &ellipse->b, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_json_numbers(&direction, 3, ellipse->direction, error);
}

/* `radius`, two `radii`, or two `sections`. */
static taut_status read_section(const taut_json *document, taut_pipe_section *section,
                                taut_error *error)
{
    const taut_json radius = taut_json_member(document, "radius");
    const taut_json at = taut_json_member(document, "sections");
    const taut_json radii = taut_json_member(document, "radii");
    size_t count = 0;
    taut_status status = TAUT_OK;
    if ((radius.value != NULL) + (at.value != NULL) + (radii.value != NULL) > 1) {
        return taut_json_fail(document, error, "conflict", taut_none, taut_none,
                              "found more than one of \"radius\", \"radii\" and \"sections\", "
                              "expected one: how wide the pipes are");
    }
    if (radii.value != NULL) {
        return read_radii(document, &radii, section, error);
    }
    if (at.value == NULL) {
        section->kind = TAUT_PIPE_ROUND;
        return read_positive(&radius, &section->radius, error);
    }
    section->kind = TAUT_PIPE_ELLIPTIC;
    status = taut_json_array(&at, 2, 2, "sections, of pipe 1 and pipe 2", &count, error);
    for (size_t i = 0; i < 2 && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(&at, i);
        status = read_ellipse(&item, &section->ellipses[i], error);
    }
    return status;
}

static taut_status read_span(const taut_json *at, taut_pipe_leg *leg, taut_error *error)
{
    const taut_json from = taut_json_member(at, "from"), to = taut_json_member(at, "to");
    taut_status status = taut_json_numbers(&from, 3, leg->from, error);
    if (status != TAUT_OK) {
        return status;
    }
    leg->kind = TAUT_PIPE_LEG_SPAN;
    status = taut_json_numbers(&to, 3, leg->to, error);
    if (status == TAUT_OK && memcmp(leg->from, leg->to, sizeof leg->to) == 0) {
        return taut_json_expected(&to, error,
                                  "another place than \"from\", or \"point\" with "
                                  "\"direction\" in place of both");
    }
    return status;
}

static taut_status read_leg(const taut_json *at, taut_pipe_leg *leg, taut_error *error)
{
    const taut_json from = taut_json_member(at, "from"), to = taut_json_member(at, "to");
    const taut_json point = taut_json_member(at, "point");
    const taut_json direction = taut_json_member(at, "direction");
    const int is_point = point.value != NULL || direction.value != NULL;
    taut_status status = taut_json_object(at, leg_members, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!is_point) {
        return read_span(at, leg, error);
    }
    if (from.value != NULL || to.value != NULL) {
        return taut_json_fail(at, error, "conflict", taut_none, taut_none,
                              "found both forms of a straight pipe, expected \"from\" and \"to\", "
                              "or \"point\" and \"direction\"");
    }
    leg->kind = TAUT_PIPE_LEG_POINT;
    status = taut_json_numbers(&point, 3, leg->from, error);
    return status == TAUT_OK ? read_direction(&direction, leg->direction, error) : status;
}

static taut_status check_run(const taut_json *document, taut_error *error)
{
    for (int i = 0; not_of_runs[i] != NULL; i++) {
        const taut_json other = taut_json_member(document, not_of_runs[i]);
        if (other.value != NULL) {
            return taut_json_fail(&other, error, "conflict", taut_none, taut_none,
                                  "found \"%s\" beside \"run\": a run is round, of one "
                                  "\"radius\", and carries its frame through: leave it out",
                                  not_of_runs[i]);
        }
    }
    return TAUT_OK;
}

static taut_status read_corners(const taut_json *run, size_t count, taut_arena *arena,
                                taut_pipe_route *route, taut_error *error)
{
    double *const corners = taut_arena_take(arena, count, 3 * sizeof *corners);
    taut_status status = corners != NULL ? TAUT_OK : taut_fail_memory(error);
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(run, i);
        status = taut_json_numbers(&item, 3, corners + 3 * i, error);
    }
    *route = (taut_pipe_route){.kind = TAUT_PIPE_CORNERS, .count = (int)count, .corners = corners};
    return status;
}

static taut_status read_legs(const taut_json *run, size_t count, taut_arena *arena,
                             taut_pipe_route *route, taut_error *error)
{
    taut_pipe_leg *const legs = taut_arena_take(arena, count, sizeof *legs);
    taut_status status = legs != NULL ? TAUT_OK : taut_fail_memory(error);
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(run, i);
        status = read_leg(&item, &legs[i], error);
    }
    *route = (taut_pipe_route){.kind = TAUT_PIPE_LEGS, .count = (int)count, .legs = legs};
    return status;
}

static taut_status read_route(const taut_json *document, taut_arena *arena, taut_pipe_route *route,
                              taut_error *error)
{
    const taut_json run = taut_json_member(document, "run");
    const taut_json first = taut_json_item(&run, 0);
    size_t count = 0;
    taut_status status =
        taut_json_array(&run, 2, LEGS_MAX, "corners or straight pipes", &count, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_run(document, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_json_kind_at(&first) == TAUT_JSON_ARRAY
                 ? read_corners(&run, count, arena, route, error)
                 : read_legs(&run, count, arena, route, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_json_flag(document, "closed", &route->closed, error);
}

static taut_status read_run(const taut_json *document, const taut_pipe_section *section,
                            taut_arena *arena, taut_pipe_run_problem *run, taut_error *error)
{
    taut_status status = read_route(document, arena, &run->route, error);
    if (status != TAUT_OK) {
        return status;
    }
    run->radius = section->radius; /* round: a run with other sections is refused */
    status = read_blending(document, &run->joint, &run->shape, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_length(document, "bend_radius", &run->bend_radius, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_json_flag(document, "caps", &run->caps, error);
}

static taut_status read_blend(const taut_json *document, const taut_pipe_section *section,
                              taut_pipe_problem *blend, taut_error *error)
{
    int frame = TAUT_PIPE_ROTATION_MINIMIZING;
    taut_status status = read_axis(document, &blend->axis, error);
    if (status != TAUT_OK) {
        return status;
    }
    blend->section = *section;
    status = read_blending(document, &blend->joint, &blend->shape, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_word(document, "frame", frame_words, &frame, error);
    if (status != TAUT_OK) {
        return status;
    }
    blend->frame = (taut_pipe_frame)frame;
    status = read_lengths(document, blend->lengths, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_length(document, "bend_radius", &blend->bend_radius, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_json_flag(document, "caps", &blend->caps, error);
}

static taut_status pipe_read(const taut_json *document, taut_problem *problem, taut_error *error)
{
    const taut_json run = taut_json_member(document, "run");
    taut_pipe_request *const request = taut_arena_take(problem->arena, 1, sizeof *request);
    taut_pipe_section section = {.kind = TAUT_PIPE_ROUND};
    taut_status status = TAUT_OK;

    if (request == NULL) {
        return taut_fail_memory(error);
    }
    status = read_section(document, &section, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_axis(document, error);
    if (status != TAUT_OK) {
        return status;
    }
    problem->data = request;
    request->is_run = run.value != NULL;
    return request->is_run ? read_run(document, &section, problem->arena, &request->run, error)
                           : read_blend(document, &section, &request->blend, error);
}

const taut_document_ops taut_document_pipe = {
    .members = members,
    .read = pipe_read,
};
