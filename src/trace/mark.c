#include "trace/mark.h"

#include <math.h>
#include <string.h>

/* t of a place on an edge: u0, u1, v0, v1. */
static double border_of(const taut_carrier *carrier, const double at[2], int edge)
{
    const double u = (at[0] - carrier->lo[0]) / (carrier->hi[0] - carrier->lo[0]);
    const double v = (at[1] - carrier->lo[1]) / (carrier->hi[1] - carrier->lo[1]);
    const double t[4] = {4 - v, 1 + v, u, 3 - u};
    return t[edge] >= 4 ? 0 : t[edge];
}

/* Of a place on an edge; *passing as of the mark. */
static taut_status mark(taut_marks *marks, const taut_carrier *on, int family, const double at[2],
                        int edge, int passing)
{
    if (marks->count == marks->room) {
        const int room = marks->room > 0 ? 2 * marks->room : 64;
        taut_mark *list = taut_arena_take_raw(marks->arena, (size_t)room, sizeof *list);
        if (list == NULL) {
            return TAUT_NO_MEMORY;
        }
        if (marks->count > 0) {
            memcpy(list, marks->list, (size_t)marks->count * sizeof *list);
        }
        marks->list = list;
        marks->room = room;
    }
    marks->list[marks->count++] = (taut_mark){on, family, border_of(on, at, edge), passing};
    return TAUT_OK;
}

static double side(const taut_carrier *carrier, int edge)
{
    return edge % 2 == 0 ? carrier->lo[edge / 2] : carrier->hi[edge / 2];
}

/* Over the seam of a carrier that closes: both sides of it. */
static taut_status mark_turn(taut_marks *marks, int family, const taut_station *a,
                             const taut_station *b, int passing)
{
    const taut_carrier *on = a->on;
    taut_status status = TAUT_OK;
    for (int edge = 0; status == TAUT_OK && edge < 4; edge++) {
        const int d = edge / 2;
        if (on->wraps[d] && a->at[d] == side(on, edge) && b->at[d] == side(on, edge ^ 1)) {
            status = mark(marks, on, family, a->at, edge, passing);
            status = status == TAUT_OK ? mark(marks, on, family, b->at, edge ^ 1, passing) : status;
        }
    }
    return status;
}

/* From one surface to another: the border of both. */
static taut_status mark_passing(taut_marks *marks, int family, const taut_station *a,
                                const taut_station *b, int passing)
{
    taut_status status = TAUT_OK;
    if (a->on == b->on) {
        return mark_turn(marks, family, a, b, passing);
    }
    for (int k = 0; k < 2; k++) {
        const taut_station *here = k == 0 ? a : b;
        for (int edge = 0; status == TAUT_OK && edge < 4; edge++) {
            if (here->at[edge / 2] == side(here->on, edge)) {
                status = mark(marks, here->on, family, here->at, edge, passing);
            }
        }
    }
    return status;
}

static taut_status mark_closing(taut_marks *marks, int family, const taut_station *at)
{
    const taut_carrier *on = at->on;
    taut_status status = TAUT_OK;
    for (int d = 0; d < 2; d++) {
        const int is_there = on->wraps[d] && (at->at[d] == on->lo[d] || at->at[d] == on->hi[d]);
        for (int up = 0; status == TAUT_OK && is_there && up < 2; up++) {
            status = mark(marks, on, family, at->at, 2 * d + up, -1);
        }
    }
    return status;
}

taut_status taut_marks_add(taut_marks *marks, const taut_lath *lath)
{
    const int family = lath->family;
    taut_status status = TAUT_OK;

    for (int k = 0; k < 4; k++) { /* both edges of a corner */
        const int end = k / 2, edge = lath->edges[end][k % 2];
        if (edge < 0) {
            k |= 1;
        } else if (status == TAUT_OK) {
            status = mark(marks, lath->end_on[end], family, lath->ends[end], edge, 0);
        }
    }
    for (int i = 1; status == TAUT_OK && i < lath->count; i++) {
        status = mark_passing(marks, family, &lath->segments[i - 1].to, &lath->segments[i].from,
                              ++marks->passings);
    }
    if (status == TAUT_OK && lath->ended[1] == TAUT_END_CLOSED && lath->count > 0) {
        status = mark_closing(marks, family, &lath->segments[0].from);
    }
    return status;
}

static int is_of(const taut_mark *mark, const taut_carrier *on, int family)
{
    return mark->on == on && mark->family == family;
}

double taut_marks_last(const taut_marks *marks, const taut_carrier *on, int family, double from,
                       double to)
{
    double last = -1;
    for (int k = 0; k < marks->count; k++) {
        for (int turn = 0; is_of(&marks->list[k], on, family) && turn < 2; turn++) {
            const double t = marks->list[k].t + 4 * turn;
            last = t > from && t <= to ? fmax(last, t) : last;
        }
    }
    return last;
}

double taut_marks_first(const taut_marks *marks, const taut_carrier *on, int family)
{
    int k = 0;
    while (k < marks->count &&
           (!is_of(&marks->list[k], on, family) || marks->list[k].passing < 0)) {
        k++;
    }
    if (k == marks->count) {
        return -1;
    }
    double first = marks->list[k].t;
    if (marks->list[k].passing > 0) { /* of both sides of a seam the later one */
        const int passing = marks->list[k].passing;
        first = first > 0 ? first : 4;
        for (k++; k < marks->count && marks->list[k].passing == passing; k++) {
            const double t = marks->list[k].t > 0 ? marks->list[k].t : 4;
            first = is_of(&marks->list[k], on, family) ? fmax(first, t) : first;
        }
    }
    return first;
}
