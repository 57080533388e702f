/* told.c -- what a finished net says, as structs: members of its details by their names. */
#include "taut/trace.h"

#include "construct/common/told.h"
#include "core/fail.h"

#include <math.h>

static const taut_record *list_of(const taut_model *net, const char *name)
{
    return taut_told_list(net, "trace", name);
}

int taut_trace_lath_count(const taut_model *net)
{
    return (int)taut_record_count(list_of(net, "laths"));
}

int taut_trace_node_count(const taut_model *net)
{
    return (int)taut_record_count(list_of(net, "nodes"));
}

int taut_trace_piece_count(const taut_model *net)
{
    return (int)taut_record_count(list_of(net, "pieces"));
}

/* Item i of a list, where there is a place for what is told of it. */
static taut_status find(const taut_model *net, const char *name, int i, const void *place,
                        const taut_record **found, taut_error *error)
{
    return taut_told_item(list_of(net, name), "net", name, i, place, found, error);
}

static taut_trace_bending bending(const taut_record *at, const char *name)
{
    const taut_record *one = taut_record_get(at, name);
    return (taut_trace_bending){taut_told_number(one, "seed"), taut_told_number(one, "max"),
                                taut_told_number(one, "max_at")};
}

taut_status taut_trace_lath_at(const taut_model *net, int i, taut_trace_lath *lath,
                               taut_error *error)
{
    const taut_record *at = NULL;
    const taut_status status = find(net, "laths", i, lath, &at, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_record *ended = taut_record_get(at, "ended");
    *lath = (taut_trace_lath){.name = taut_told_text(at, "name"),
                              .family = taut_told_text(at, "family"),
                              .from_word = taut_record_text(taut_record_at(ended, 0)),
                              .to_word = taut_record_text(taut_record_at(ended, 1)),
                              .length = taut_told_number(at, "length"),
                              .twist = taut_told_number(at, "twist"),
                              .turn = taut_told_number(at, "turn"),
                              .k_n = bending(at, "k_n"),
                              .k_g = bending(at, "k_g"),
                              .tau_g = bending(at, "tau_g"),
                              .steps = (int)taut_told_number(at, "steps"),
                              .node_count = (int)taut_record_count(taut_record_get(at, "nodes")),
                              .width = taut_told_number(at, "width"),
                              .thickness = taut_told_number(at, "thickness"),
                              .least_radius = taut_told_number(at, "least_radius"),
                              .edge_length = taut_told_number(at, "edge_length"),
                              .mean_stretch = taut_told_number(at, "mean_stretch"),
                              .cut_length = taut_told_number(at, "cut_length"),
                              .use = taut_told_number(taut_record_get(at, "stress"), "use")};
    taut_told_numbers(at, "seed", 2, lath->seed);
    taut_told_numbers(at, "from", 2, lath->from);
    taut_told_numbers(at, "to", 2, lath->to);
    taut_told_numbers(at, "pattern_end", 3, lath->pattern_end);
    return TAUT_OK;
}

taut_status taut_trace_node_at(const taut_model *net, int i, taut_trace_node *node,
                               taut_error *error)
{
    const taut_record *at = NULL;
    const taut_status status = find(net, "nodes", i, node, &at, error);
    if (status != TAUT_OK) {
        return status;
    }
    *node = (taut_trace_node){.name = taut_told_text(at, "node"),
                              .angle = taut_told_number(at, "angle"),
                              .tau = taut_told_number(at, "tau"),
                              .mean_curvature = taut_told_number(at, "H"),
                              .slot = taut_told_number(at, "slot"),
                              .slot_twisted = taut_told_number(at, "slot_twisted"),
                              .is_on_border = taut_record_bool(taut_record_get(at, "border"))};
    taut_told_numbers(at, "at", 2, node->at);
    taut_told_numbers(at, "point", 3, node->point);
    taut_told_numbers(at, "normal", 3, node->normal);
    taut_told_numbers(at, "s", 2, node->s);
    return TAUT_OK;
}

taut_status taut_trace_pattern(const taut_model *net, int i, int room, double *outline,
                               taut_trace_piece *piece, taut_error *error)
{
    const taut_record *at = NULL;
    const taut_status status = find(net, "pieces", i, piece, &at, error);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_record *points = taut_record_get(at, "outline");
    const taut_trace_piece found = {.name = taut_told_text(at, "name"),
                                    .lath = taut_told_text(at, "lath"),
                                    .sheet = (int)taut_told_number(at, "sheet"),
                                    .point_count = (int)taut_record_count(points),
                                    .slot_count =
                                        (int)taut_record_count(taut_record_get(at, "slots"))};
    if (outline != NULL && room < found.point_count) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, room, found.point_count,
                         "the outline of %s has %d points, and there is room for %d", found.name,
                         found.point_count, room);
    }
    for (int k = 0; outline != NULL && k < found.point_count; k++) {
        const taut_record *point = taut_record_at(points, (size_t)k);
        outline[2 * k] = taut_record_number(taut_record_at(point, 0));
        outline[2 * k + 1] = taut_record_number(taut_record_at(point, 1));
    }
    *piece = found;
    return TAUT_OK;
}
