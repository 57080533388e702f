/* pipe.c -- the problem `pipe`: two axes and what joins them, or a run (docs/format.md).
 *
 *     "run": [ [x, y, z], ... ]                                   corners, from end to end
 *            [ { "from": P, "to": Q }, ... ]                      straight pipes, in order of flow
 *            [ ..., { "point": P, "direction": D }, ... ]         one of no length
 */
#include "problem/pipe.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"

#include <string.h>

enum { LEGS_MAX = 10000 };

static const char *const members[] = {"radius",       "polygon", "from",     "to",     "axes",
                                      "run",          "closed",  "shape",    "domain", "frame",
                                      "pipe_lengths", "joint",   "sections", "radii",  "surface",
                                      "bend_radius",  "caps",    "elbow",    "wall",   NULL};
static const char *const surface_words[] = {"canal", "naive-sweep", NULL};
static const char *const section_members[] = {"a", "b", "direction", NULL};
static const char *const end_members[] = {"point", "direction", "handle", NULL};
static const char *const leg_members[] = {"from", "to", "point", "direction", NULL};
static const char *const shape_members[] = {"alpha", "beta", "gamma", "auto", NULL};
static const char *const goal_words[] = {"bending", "curvature", NULL};
static const char *const domain_words[] = {"strict", "extended", NULL};
static const char *const elbow_words[] = {"blend", "arc", NULL};
static const char *const joint_words[] = {"g1", "g2", NULL};
static const char *const frame_words[] = {"rotation-minimizing", "frenet", NULL};
static const char *const of_runs[] = {"elbow", "wall", NULL};
static const char *const not_of_arcs[] = {"shape", "domain", NULL};
/* What says of a single pipe that which a run settles itself. */
static const char *const not_of_runs[] = {"frame", "pipe_lengths", "sections",
                                          "radii", "surface",      NULL};

static taut_status read_positive(const taut_json *at, void *value, taut_error *error)
{
    const taut_status status = taut_json_number(at, value, error);
    return status == TAUT_OK && !(*(double *)value > 0)
               ? taut_json_expected(at, error, "a positive length")
               : status;
}

/* Of a half line it is null. */
static taut_status read_length(const taut_json *at, void *value, taut_error *error)
{
    return taut_json_kind_at(at) == TAUT_JSON_NULL ? TAUT_OK : read_positive(at, value, error);
}

static taut_status read_point(const taut_json *at, void *point, taut_error *error)
{
    return taut_json_numbers(at, 3, point, error);
}

static taut_status read_direction(const taut_json *at, void *into, taut_error *error)
{
    const double *const direction = into;
    const taut_status status = taut_json_numbers(at, 3, into, error);
    const int is_zero = direction[0] == 0 && direction[1] == 0 && direction[2] == 0;
    return status == TAUT_OK && is_zero ? taut_json_expected(at, error, "a vector that is not zero")
                                        : status;
}

static taut_status read_end(const taut_json *at, void *into, taut_error *error)
{
    taut_pipe_end *const end = into;
    taut_reader in = taut_reader_of(at, end_members, error);

    taut_reader_numbers(&in, "point", 3, end->point);
    taut_reader_member(&in, "direction", read_direction, end->direction);
    taut_reader_optional(&in, "handle", read_positive, &end->handle);
    return in.status;
}

/* Is there one of `polygon`, `from` and `to`, `axes`, `run`, and `closed` with the last only? */
static void check_axis(taut_reader *document)
{
    const taut_json closed = taut_json_member(document->object, "closed");
    const int ends = taut_reader_has(document, "from") || taut_reader_has(document, "to");
    const int is_run = taut_reader_has(document, "run");
    const int given =
        taut_reader_has(document, "polygon") + ends + taut_reader_has(document, "axes") + is_run;

    if (document->status == TAUT_OK && given != 1) {
        document->status = taut_json_fail(
            document->object, document->error, given == 0 ? "missing" : "conflict", given, 1,
            "found %s of \"polygon\", \"from\" with \"to\", \"axes\" and \"run\", expected one: "
            "where the axis comes from",
            given == 0 ? "none" : "more than one");
    } else if (document->status == TAUT_OK && !is_run && closed.value != NULL) {
        document->status =
            taut_json_fail(&closed, document->error, "conflict", taut_none, taut_none,
                           "found \"closed\" without \"run\": only a run comes round");
    }
}

static void read_axis(taut_reader *document, taut_pipe_axis *axis)
{
    if (taut_reader_has(document, "polygon")) {
        axis->kind = TAUT_PIPE_POLYGON;
        taut_reader_items(document, "polygon", 4, "points V_0 to V_3", read_point, axis->polygon,
                          sizeof axis->polygon[0]);
    } else if (taut_reader_has(document, "axes")) {
        axis->kind = TAUT_PIPE_FEET;
        taut_reader_items(document, "axes", 2, "lines", read_end, axis->ends, sizeof axis->ends[0]);
    } else {
        axis->kind = TAUT_PIPE_ENDS;
        taut_reader_member(document, "from", read_end, &axis->ends[0]);
        taut_reader_member(document, "to", read_end, &axis->ends[1]);
    }
}

/* { "auto": goal }, or the three numbers. */
static taut_status read_shape_members(const taut_json *at, taut_pipe_joint joint,
                                      taut_pipe_shape *shape, taut_error *error)
{
    taut_reader in = taut_reader_of(at, shape_members, error);
    int goal = 0;

    if (taut_reader_has(&in, "auto")) {
        if (in.status == TAUT_OK && taut_json_count_at(at) != 1) {
            return taut_json_fail(at, error, "conflict", taut_none, taut_none,
                                  "found shape numbers beside \"auto\", which chooses them");
        }
        taut_reader_word(&in, "auto", goal_words, &goal);
        shape->kind = goal == 1 ? TAUT_PIPE_LEAST_CURVATURE : TAUT_PIPE_LEAST_BENDING;
        return in.status;
    }
    shape->kind = TAUT_PIPE_SHAPE_GIVEN;
    taut_reader_number(&in, "alpha", &shape->alpha);
    if (joint == TAUT_PIPE_G1 || taut_reader_has(&in, "beta")) {
        taut_reader_number(&in, "beta", &shape->beta);
    }
    taut_reader_number(&in, "gamma", &shape->gamma);
    return in.status;
}

/* `joint`, `shape`, which may be "auto", and `domain`. */
static void read_blending(taut_reader *document, taut_pipe_joint *joint, taut_pipe_shape *shape)
{
    const taut_json at = taut_json_member(document->object, "shape");
    const char *text = taut_json_text_at(&at);
    int word = TAUT_PIPE_G1;

    taut_reader_optional_word(document, "joint", joint_words, &word);
    *joint = (taut_pipe_joint)word;
    shape->kind = TAUT_PIPE_LEAST_BENDING;
    if (document->status == TAUT_OK && at.value != NULL &&
        !(text != NULL && strcmp(text, "auto") == 0)) {
        document->status =
            taut_json_kind_at(&at) == TAUT_JSON_OBJECT
                ? read_shape_members(&at, *joint, shape, document->error)
                : taut_json_expected(&at, document->error,
                                     "\"auto\", or an object with alpha, beta and gamma");
    }
    taut_reader_optional_word(document, "domain", domain_words, &shape->extended);
}

static taut_status read_ellipse(const taut_json *at, void *into, taut_error *error)
{
    taut_pipe_ellipse *const ellipse = into;
    taut_reader in = taut_reader_of(at, section_members, error);

    taut_reader_member(&in, "a", read_positive, &ellipse->a);
    taut_reader_member(&in, "b", read_positive, &ellipse->b);
    taut_reader_numbers(&in, "direction", 3, ellipse->direction);
    return in.status;
}

/* `radius`, two `radii`, or two `sections`. */
static void read_section(taut_reader *document, taut_pipe_section *section)
{
    const int radii = taut_reader_has(document, "radii");
    const int sections = taut_reader_has(document, "sections");
    int word = 0;

    if (taut_reader_has(document, "radius") + sections + radii > 1) {
        document->status =
            taut_json_fail(document->object, document->error, "conflict", taut_none, taut_none,
                           "found more than one of \"radius\", \"radii\" and \"sections\", "
                           "expected one: how wide the pipes are");
    } else if (radii) {
        taut_reader_items(document, "radii", 2, "radii, of pipe 1 and pipe 2", read_positive,
                          section->radii, sizeof section->radii[0]);
        taut_reader_optional_word(document, "surface", surface_words, &word);
        section->kind = word == 1 ? TAUT_PIPE_NAIVE_SWEEP : TAUT_PIPE_CANAL;
    } else if (sections) {
        section->kind = TAUT_PIPE_ELLIPTIC;
        taut_reader_items(document, "sections", 2, "sections, of pipe 1 and pipe 2", read_ellipse,
                          section->ellipses, sizeof section->ellipses[0]);
    } else {
        section->kind = TAUT_PIPE_ROUND;
        taut_reader_member(document, "radius", read_positive, &section->radius);
    }
}

static taut_status read_leg(const taut_json *at, void *into, taut_error *error)
{
    taut_pipe_leg *const leg = into;
    taut_reader in = taut_reader_of(at, leg_members, error);
    const taut_json to = taut_json_member(at, "to");

    if (in.status != TAUT_OK) {
        return in.status;
    }
    if (!taut_reader_has(&in, "point") && !taut_reader_has(&in, "direction")) {
        leg->kind = TAUT_PIPE_LEG_SPAN;
        taut_reader_numbers(&in, "from", 3, leg->from);
        taut_reader_numbers(&in, "to", 3, leg->to);
        if (in.status == TAUT_OK && memcmp(leg->from, leg->to, sizeof leg->to) == 0) {
            return taut_json_expected(&to, error,
                                      "another place than \"from\", or \"point\" with "
                                      "\"direction\" in place of both");
        }
        return in.status;
    }
    if (to.value != NULL || taut_reader_has(&in, "from")) {
        return taut_json_fail(at, error, "conflict", taut_none, taut_none,
                              "found both forms of a straight pipe, expected \"from\" and \"to\", "
                              "or \"point\" and \"direction\"");
    }
    leg->kind = TAUT_PIPE_LEG_POINT;
    taut_reader_numbers(&in, "point", 3, leg->from);
    taut_reader_member(&in, "direction", read_direction, leg->direction);
    return in.status;
}

static void read_route(taut_reader *document, taut_arena *arena, taut_pipe_route *route)
{
    const taut_json run = taut_json_member(document->object, "run");
    const taut_json first = taut_json_item(&run, 0);
    const int corners = taut_json_kind_at(&first) == TAUT_JSON_ARRAY;
    const size_t size = corners ? sizeof(double[3]) : sizeof(taut_pipe_leg);
    size_t count = 0;

    taut_reader_array(document, "run", 2, LEGS_MAX, "corners or straight pipes", &count);
    taut_member_refuse(document, not_of_runs,
                       "beside \"run\": a run is round, of one \"radius\", and carries its frame "
                       "through: leave it out");
    if (document->status != TAUT_OK) {
        return;
    }
    void *const items = taut_arena_take(arena, count, size);
    if (items == NULL) {
        document->status = taut_fail_memory(document->error);
    }
    taut_reader_items(document, "run", count, "", corners ? read_point : read_leg, items, size);
    route->kind = corners ? TAUT_PIPE_CORNERS : TAUT_PIPE_LEGS;
    route->count = (int)count;
    if (corners) {
        route->corners = items;
    } else {
        route->legs = items;
    }
    taut_reader_flag(document, "closed", &route->closed);
}

/* A length, or one of the standard ones, in diameters. */
static void read_bend_radius(taut_reader *document, double radius, double *bend_radius)
{
    static const char *const words[] = {"1D", "1.5D", "2D", "2.5D", "3D", "5D", NULL};
    static const double diameters[] = {1, 1.5, 2, 2.5, 3, 5};
    const taut_json at = taut_json_member(document->object, "bend_radius");
    int word = 0;

    if (taut_json_kind_at(&at) != TAUT_JSON_STRING) {
        taut_reader_optional(document, "bend_radius", read_positive, bend_radius);
        return;
    }
    taut_reader_word(document, "bend_radius", words, &word);
    if (document->status == TAUT_OK && !(radius > 0)) {
        document->status = taut_json_expected(&at, document->error,
                                              "a length: a pipe that is not "
                                              "round has no one diameter");
    }
    *bend_radius = 2 * radius * diameters[word];
}

static void read_run(taut_reader *document, const taut_pipe_section *section, taut_arena *arena,
                     taut_pipe_run_problem *run)
{
    int elbow = TAUT_PIPE_ELBOW_BLEND;

    read_route(document, arena, &run->route);
    run->radius = section->radius; /* round: a run with other sections is refused */
    read_blending(document, &run->joint, &run->shape);
    read_bend_radius(document, run->radius, &run->bend_radius);
    taut_reader_flag(document, "caps", &run->caps);
    taut_reader_optional(document, "wall", read_positive, &run->wall);
    taut_reader_optional_word(document, "elbow", elbow_words, &elbow);
    run->elbow = (taut_pipe_elbow_kind)elbow;
    if (run->elbow == TAUT_PIPE_ELBOW_ARC) {
        taut_member_refuse(document, not_of_arcs, "beside arcs, which have no other shape");
    }
}

static void read_blend(taut_reader *document, const taut_pipe_section *section,
                       taut_pipe_problem *blend)
{
    int frame = TAUT_PIPE_ROTATION_MINIMIZING;

    taut_member_refuse(document, of_runs, "without \"run\": only a run has it");
    read_axis(document, &blend->axis);
    blend->section = *section;
    read_blending(document, &blend->joint, &blend->shape);
    taut_reader_optional_word(document, "frame", frame_words, &frame);
    blend->frame = (taut_pipe_frame)frame;
    if (taut_reader_has(document, "pipe_lengths")) {
        taut_reader_items(document, "pipe_lengths", 2, "lengths", read_length, blend->lengths,
                          sizeof blend->lengths[0]);
    }
    read_bend_radius(document, section->kind == TAUT_PIPE_ROUND ? section->radius : 0,
                     &blend->bend_radius);
    taut_reader_flag(document, "caps", &blend->caps);
}

static void pipe_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_pipe_request *const request = into;
    taut_pipe_section section = {.kind = TAUT_PIPE_ROUND};

    read_section(document, &section);
    check_axis(document);
    request->is_run = taut_reader_has(document, "run");
    if (request->is_run) {
        read_run(document, &section, problem->arena, &request->run);
    } else {
        read_blend(document, &section, &request->blend);
    }
}

const taut_document_ops taut_document_pipe = {
    .members = members,
    .size = sizeof(taut_pipe_request),
    .read = pipe_read,
};
