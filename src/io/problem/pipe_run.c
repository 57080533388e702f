/* pipe_run.c -- `run`: corners, or straight pipes, one after the other (docs/format.md).
 *
 *     [ [x, y, z], ... ]                                          corners, from end to end
 *     [ { "from": P, "to": Q }, ... ]                             straight pipes, in order of flow
 *     [ ..., { "point": P, "direction": D }, ... ]                one of no length
 */
#include "core/fail.h"
#include "io/problem/pipe.h"

#include <string.h>

enum { LEGS_MAX = 10000 };

static const char *const leg_members[] = {"from", "to", "point", "direction", NULL};
/* What says of a single pipe that which a run settles itself. */
static const char *const others[] = {"frame", "pipe_lengths", "sections", "radii", "surface", NULL};

taut_status taut_document_pipe_flag(const taut_json *object, const char *key, int *value,
                                    taut_error *error)
{
    const taut_json at = taut_json_member(object, key);
    const taut_json_kind kind = taut_json_kind_at(&at);
    if (at.value != NULL && kind != TAUT_JSON_TRUE && kind != TAUT_JSON_FALSE) {
        return taut_json_expected(&at, error, "true or false");
    }
    *value = kind == TAUT_JSON_TRUE ? 1 : kind == TAUT_JSON_FALSE ? 0 : *value;
    return TAUT_OK;
}

static taut_status read_leg(const taut_json *at, taut_pipe_leg *leg, taut_error *error)
{
    const taut_json from = taut_json_member(at, "from"), to = taut_json_member(at, "to");
    const taut_json point = taut_json_member(at, "point");
    const taut_json direction = taut_json_member(at, "direction");
    const int placed = point.value != NULL || direction.value != NULL;
    taut_status status = taut_json_object(at, leg_members, error);

    if (status == TAUT_OK && placed && (from.value != NULL || to.value != NULL)) {
        return taut_json_fail(at, error, "value", taut_none, taut_none,
                              "found both forms of a straight pipe, expected \"from\" and \"to\", "
                              "or \"point\" and \"direction\"");
    }
    if (status == TAUT_OK) {
        status = taut_json_numbers(placed ? &point : &from, 3, leg->from, error);
    }
    if (status == TAUT_OK && placed) {
        memcpy(leg->to, leg->from, sizeof leg->to);
        status = taut_json_numbers(&direction, 3, leg->direction, error);
    } else if (status == TAUT_OK) {
        status = taut_json_numbers(&to, 3, leg->to, error);
    }
    if (status == TAUT_OK && placed && leg->direction[0] == 0 && leg->direction[1] == 0 &&
        leg->direction[2] == 0) {
        status = taut_json_expected(&direction, error, "a vector that is not zero");
    }
    if (status == TAUT_OK && !placed && memcmp(leg->from, leg->to, sizeof leg->to) == 0) {
        status = taut_json_expected(&to, error,
                                    "another place than \"from\", or \"point\" with "
                                    "\"direction\" in place of both");
    }
    return status;
}

taut_status taut_document_pipe_run(const taut_json *document, taut_arena *arena,
                                   taut_pipe_problem *data, taut_error *error)
{
    const taut_json run = taut_json_member(document, "run");
    taut_pipe_leg *legs = NULL;
    size_t count = 0;
    taut_status status =
        taut_json_array(&run, 2, LEGS_MAX, "corners or straight pipes", &count, error);

    for (int i = 0; others[i] != NULL && status == TAUT_OK; i++) {
        const taut_json other = taut_json_member(document, others[i]);
        if (other.value != NULL) {
            status = taut_json_fail(&other, error, "value", taut_none, taut_none,
                                    "found \"%s\" beside \"run\": a run is round, of one "
                                    "\"radius\", and carries its frame through: leave it out",
                                    others[i]);
        }
    }
    if (status == TAUT_OK) {
        const taut_json first = taut_json_item(&run, 0);
        data->axis =
            taut_json_kind_at(&first) == TAUT_JSON_ARRAY ? TAUT_PIPE_CORNERS : TAUT_PIPE_LEGS;
        legs = taut_arena_take(arena, count, sizeof *legs);
        status = legs != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(&run, i);
        legs[i] = (taut_pipe_leg){.from = {0, 0, 0}};
        status = data->axis == TAUT_PIPE_CORNERS ? taut_json_numbers(&item, 3, legs[i].from, error)
                                                 : read_leg(&item, &legs[i], error);
    }
    data->leg_count = (int)count;
    data->legs = legs;
    return status == TAUT_OK ? taut_document_pipe_flag(document, "closed", &data->closed, error)
                             : status;
}
