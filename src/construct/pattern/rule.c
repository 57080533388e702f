#include "construct/pattern/rule.h"

#include "construct/pattern/pole.h"
#include "construct/pattern/trail.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "trace/divide.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of the window, and of lengths: places that are one. */
static const double same_place = 1e-9;

typedef struct rule_work {
    const taut_pattern_ground *ground;
    const taut_pattern_rule *rule;
    int index;
    taut_pattern_seams *seams;
    taut_error *error;
    char where[48]; /* in the document */
} rule_work;

/* ---- places ---- */

int taut_pattern_is_on(const taut_carrier *carrier, const double at[2], int border)
{
    const int held = border / 2;
    return at[held] == (border % 2 == 0 ? carrier->lo[held] : carrier->hi[held]);
}

int taut_pattern_is_place(const taut_carrier *carrier, int border)
{
    enum { PLACES = 16 };
    const int held = border / 2, along = 1 - held;
    double first[3], most = 0;
    for (int k = 0; k <= PLACES; k++) {
        double at[2], x[TAUT_CARRIER_VECTORS][3];
        int span[2];
        at[held] = border % 2 == 0 ? carrier->lo[held] : carrier->hi[held];
        at[along] = carrier->lo[along] + (carrier->hi[along] - carrier->lo[along]) * k / PLACES;
        taut_carrier_cell(carrier, at, NULL, span);
        taut_carrier_at(carrier, span, at, 0, x);
        if (k == 0) {
            memcpy(first, x[0], sizeof first);
        }
        most = fmax(most, taut_length_between(first, x[0]));
    }
    return most <= same_place * carrier->size;
}

static void ends_of(const taut_carrier *carrier, int edge, double ends[2][2])
{
    const int held = edge / 2, along = 1 - held;
    for (int end = 0; end < 2; end++) {
        ends[end][held] = edge % 2 == 0 ? carrier->lo[held] : carrier->hi[held];
        ends[end][along] = end == 0 ? carrier->lo[along] : carrier->hi[along];
    }
}

static taut_status ruler_of(const taut_pattern_ground *ground, int edge, taut_trace_by by,
                            taut_ruler *ruler, taut_error *error)
{
    double ends[2][2];
    ends_of(ground->carrier, edge, ends);
    return taut_ruler_new(ground->arena, ground->carrier, TAUT_TRACE_GEODESIC, by, ends[0], ends[1],
                          ruler) == TAUT_OK
               ? TAUT_OK
               : taut_fail_memory(error);
}

/* Places [count + 1] on an edge, as u or v grows. */
static taut_status divide(const taut_pattern_ground *ground, int edge, taut_pattern_by by,
                          int count, double (*at)[2], taut_error *error)
{
    const taut_trace_by measure =
        by == TAUT_PATTERN_BY_PARAMETER ? TAUT_TRACE_PARAMETER : TAUT_TRACE_LENGTH;
    taut_ruler ruler;
    double ends[2][2];
    const taut_status status = ruler_of(ground, edge, measure, &ruler, error);

    if (status != TAUT_OK) {
        return status;
    }
    ends_of(ground->carrier, edge, ends);
    memcpy(at[0], ends[0], sizeof ends[0]);
    memcpy(at[count], ends[1], sizeof ends[1]);
    for (int k = 1; k < count; k++) {
        taut_ruler_at(&ruler, ruler.sum[ruler.count] * k / count, at[k]);
    }
    return TAUT_OK;
}

static taut_status fail_outside(const rule_work *w, double found, double low, double high,
                                const char *what)
{
    return taut_fail(w->error, TAUT_BAD_INPUT, "outside", w->where, found, found < low ? low : high,
                     "found %s %.17g, expected one from %.17g to %.17g", what, found, low, high);
}

/* Onto a border that is within rounding. */
static void snap(const taut_carrier *carrier, double at[2])
{
    for (int d = 0; d < 2; d++) {
        const double room = same_place * (carrier->hi[d] - carrier->lo[d]);
        at[d] = fabs(at[d] - carrier->lo[d]) <= room ? carrier->lo[d] : at[d];
        at[d] = fabs(at[d] - carrier->hi[d]) <= room ? carrier->hi[d] : at[d];
    }
}

static taut_status place_on_edge(const rule_work *w, const taut_pattern_at *asked, double at[2])
{
    const taut_carrier *carrier = w->ground->carrier;
    const int edge = (int)asked->edge, along = 1 - edge / 2;
    double ends[2][2];
    taut_ruler ruler;

    ends_of(carrier, edge, ends);
    if (asked->place == TAUT_PATTERN_PARAMETER) {
        memcpy(at, ends[0], sizeof ends[0]);
        at[along] = asked->value;
        return asked->value >= carrier->lo[along] && asked->value <= carrier->hi[along]
                   ? TAUT_OK
                   : fail_outside(w, asked->value, carrier->lo[along], carrier->hi[along],
                                  "a parameter");
    }
    const taut_status status = ruler_of(w->ground, edge, TAUT_TRACE_LENGTH, &ruler, w->error);
    if (status != TAUT_OK) {
        return status;
    }
    const double whole = ruler.sum[ruler.count];
    const double length = asked->place == TAUT_PATTERN_PART ? asked->value * whole
                                                            : ldexp(asked->value, -carrier->scale);
    if (!(length >= 0) || !(length <= whole * (1 + same_place))) {
        const int is_part = asked->place == TAUT_PATTERN_PART;
        return fail_outside(w, asked->value, 0, is_part ? 1 : ldexp(whole, carrier->scale),
                            is_part ? "a part" : "a length");
    }
    taut_ruler_at(&ruler, length, at);
    return TAUT_OK;
}

static taut_status place_of(const rule_work *w, const taut_pattern_at *asked, double at[2])
{
    const taut_carrier *carrier = w->ground->carrier;
    if (asked->is_on_edge) {
        const taut_status status = place_on_edge(w, asked, at);
        snap(carrier, at);
        return status;
    }
    memcpy(at, asked->uv, 2 * sizeof(double));
    snap(carrier, at);
    for (int d = 0; d < 2; d++) {
        if (!(at[d] >= carrier->lo[d]) || !(at[d] <= carrier->hi[d])) {
            return fail_outside(w, at[d], carrier->lo[d], carrier->hi[d], d == 0 ? "u" : "v");
        }
    }
    return TAUT_OK;
}

static taut_status check_border(const rule_work *w, const double at[2])
{
    int any = 0;
    for (int b = 0; b < 4; b++) {
        any |= taut_pattern_is_on(w->ground->carrier, at, b);
    }
    return any ? TAUT_OK
               : taut_fail(w->error, TAUT_BAD_INPUT, "outside", w->where, taut_none, taut_none,
                           "found a seam that ends at (%.6g, %.6g), inside the window, expected a "
                           "place on its border",
                           at[0], at[1]);
}

/* ---- which way ---- */

/* Turns two places so that the first is on ends[0]. Where these are not known they become those of the places. */
static taut_status orient(const rule_work *w, double at[2][2])
{
    const taut_carrier *carrier = w->ground->carrier;
    static const int pairs[4][2] = {{2, 3}, {3, 2}, {0, 1}, {1, 0}};
    int *ends = w->seams->ends;

    for (int k = 0; ends[0] < 0 && k < 4; k++) {
        if (taut_pattern_is_on(carrier, at[0], pairs[k][0]) &&
            taut_pattern_is_on(carrier, at[1], pairs[k][1])) {
            memcpy(ends, pairs[k], sizeof pairs[k]);
        }
    }
    if (ends[0] < 0) {
        return taut_fail(w->error, TAUT_NO_SOLUTION, "shape", w->where, taut_none, taut_none,
                         "a seam from (%.6g, %.6g) to (%.6g, %.6g) leaves a piece of five sides: "
                         "run the first seam between opposite edges",
                         at[0][0], at[0][1], at[1][0], at[1][1]);
    }
    const int is_forward =
        taut_pattern_is_on(carrier, at[0], ends[0]) && taut_pattern_is_on(carrier, at[1], ends[1]);
    const int is_backward =
        taut_pattern_is_on(carrier, at[1], ends[0]) && taut_pattern_is_on(carrier, at[0], ends[1]);
    if (is_backward && !is_forward) {
        double first[2];
        memcpy(first, at[0], sizeof first);
        memcpy(at[0], at[1], sizeof first);
        memcpy(at[1], first, sizeof first);
    }
    return TAUT_OK;
}

/* ---- the rules ---- */

static taut_pattern_side *next_seam(const rule_work *w)
{
    taut_pattern_side *side = &w->seams->list[w->seams->count++];
    side->border = side->twin = -1;
    side->is_seam = 1;
    return side;
}

static taut_status take_room(const rule_work *w, double count)
{
    if (!(count < TAUT_PATTERN_PIECES_MAX)) {
        return taut_fail(w->error, TAUT_BAD_INPUT, "count", w->where, count,
                         TAUT_PATTERN_PIECES_MAX - 1, "found %.6g seams, expected at most %d",
                         count, TAUT_PATTERN_PIECES_MAX - 1);
    }
    w->seams->list = taut_arena_take(w->ground->arena, (size_t)count + 1, sizeof *w->seams->list);
    return w->seams->list != NULL ? TAUT_OK : taut_fail_memory(w->error);
}

/* One place of the line that closes a ring, from either side? */
static int is_same_place(const taut_pattern_ground *ground, const double a[2], const double b[2])
{
    const taut_carrier *carrier = ground->carrier;
    for (int d = 0; d < 2; d++) {
        const double width = carrier->hi[d] - carrier->lo[d],
                     other = carrier->hi[1 - d] - carrier->lo[1 - d];
        if (ground->is_ring[d] && fabs(a[d] - b[d]) >= width * (1 - same_place) &&
            fabs(a[1 - d] - b[1 - d]) <= same_place * other) {
            return 1;
        }
    }
    return 0;
}

static taut_status add_geodesic(const rule_work *w, const double from[2], const double to[2])
{
    const taut_pattern_ground *g = w->ground;
    double at[2][2] = {{from[0], from[1]}, {to[0], to[1]}};
    if (is_same_place(g, from, to)) {
        return taut_fail(w->error, TAUT_NO_SOLUTION, "no-geodesic", w->where, taut_none, taut_none,
                         "the seam from (%.6g, %.6g) to (%.6g, %.6g) would end where it begins, as "
                         "these edges are one line: run it between the other two",
                         from[0], from[1], to[0], to[1]);
    }
    taut_status status = orient(w, at);
    return status == TAUT_OK ? taut_pattern_geodesic(g->carrier, at[0], at[1], g->monitor, g->arena,
                                                     next_seam(w), w->error)
                             : status;
}

/* From a pole, where all directions begin, along a parameter line. */
static taut_status add_meridian(const rule_work *w, const double at[2])
{
    const int held = 1 - (int)w->rule->edges[0] / 2, along = 1 - held;
    const taut_carrier *carrier = w->ground->carrier;
    double ends[2][2];
    for (int end = 0; end < 2; end++) {
        ends[end][held] = at[held];
        ends[end][along] = end == 0 ? carrier->lo[along] : carrier->hi[along];
    }
    const taut_status status = orient(w, ends);
    return status == TAUT_OK
               ? taut_pattern_trail_line(w->ground, held, at[held], NULL,
                                         ends[0][along] > ends[1][along], next_seam(w), w->error)
               : status;
}

/* Across, radial. */
static taut_status lay_strips(const rule_work *w, int count)
{
    const taut_pattern_ground *g = w->ground;
    const size_t places = (size_t)count + 1;
    double(*from)[2] = taut_arena_take(g->arena, places, sizeof *from);
    double(*to)[2] = taut_arena_take(g->arena, places, sizeof *to);

    if (from == NULL || to == NULL) {
        return taut_fail_memory(w->error);
    }
    if (w->seams->ends[0] < 0) {
        w->seams->ends[0] = (int)w->rule->edges[0];
        w->seams->ends[1] = (int)w->rule->edges[1];
    }
    taut_status status = take_room(w, count - 1);
    if (status == TAUT_OK) {
        status = divide(g, (int)w->rule->edges[0], w->rule->by, count, from, w->error);
    }
    if (status == TAUT_OK) {
        status = divide(g, (int)w->rule->edges[1], w->rule->by, count, to, w->error);
    }
    const int poles[2] = {g->is_pole[(int)w->rule->edges[0]], g->is_pole[(int)w->rule->edges[1]]};
    for (int k = 1; status == TAUT_OK && k < count; k++) {
        status = poles[0] || poles[1] ? add_meridian(w, poles[0] ? to[k] : from[k])
                                      : add_geodesic(w, from[k], to[k]);
    }
    return status;
}

/* Of a piece of a cap. The sides of a whole turn would meet beside the pole, or run over each other; halves need finer splines at their
 * T-joints than thirds, and seven times the time. */
static const double turn_most = 0.7 * TAUT_PI;
/* A circle is so much nearer than the border, over its distance. */
static const double room_most = 1 - 1e-3;

/* From a circle around the pole (edges[which]) to it or to the opposite edge, along a parameter line. */
static taut_status add_spoke(const rule_work *w, const taut_pattern_side *circle, int which,
                             int is_inside, double value)
{
    const int pole = (int)w->rule->edges[which], held = pole / 2, around = 1 - held;
    const taut_carrier *carrier = w->ground->carrier;
    double at[2];
    taut_pattern_circle_at(circle, around, value, at);
    const int is_low = (pole % 2 == 0) == is_inside;
    const double range[2] = {is_low ? carrier->lo[held] : at[held],
                             is_low ? at[held] : carrier->hi[held]};
    const int is_back = w->seams->ends[0] % 2; /* they run from it */
    return taut_pattern_trail_line(w->ground, around, value, range, is_back, next_seam(w),
                                   w->error);
}

/* Radial, from a circle around a pole: that one first, then what cuts the cap, then what cuts the rest. */
static taut_status lay_trimmed(const rule_work *w, int count)
{
    const taut_pattern_ground *g = w->ground;
    const int edges[2] = {(int)w->rule->edges[0], (int)w->rule->edges[1]};
    const int which = !g->is_pole[edges[0]], pole = edges[which], around = 1 - pole / 2;
    const double distance = ldexp(w->rule->trim, -g->carrier->scale);
    double(*at)[2] = taut_arena_take(g->arena, (size_t)count + 1, sizeof *at);

    if (at == NULL) {
        return taut_fail_memory(w->error);
    }
    if (!g->is_pole[pole]) {
        return taut_fail(w->error, TAUT_BAD_INPUT, "rule", w->where, taut_none, taut_none,
                         "found \"trim\" where neither %s nor %s is one place",
                         taut_edge_name((taut_edge)edges[0]), taut_edge_name((taut_edge)edges[1]));
    }
    const double reach = taut_pattern_pole_reach(g, pole) * room_most;
    if (!(distance < reach)) {
        return fail_outside(w, w->rule->trim, 0, ldexp(reach, g->carrier->scale), "a trim of");
    }
    if (w->seams->ends[0] < 0) {
        memcpy(w->seams->ends, edges, sizeof edges);
    }
    /* to the left of what runs up v, or down u, u falls, or v */
    const int first = w->seams->ends[0];
    const int is_back = first == TAUT_EDGE_V0 || first == TAUT_EDGE_U1;
    const int parts = (int)fmax(ceil(taut_pattern_pole_turn(g, pole) / turn_most - same_place), 1);
    taut_status status = take_room(w, count + parts - 1);
    if (status == TAUT_OK) {
        status = divide(g, edges[!which], w->rule->by, count, at, w->error);
    }
    const taut_pattern_side *circle = status == TAUT_OK ? next_seam(w) : NULL;
    if (status == TAUT_OK) {
        status = taut_pattern_pole_circle(g, pole, distance, is_back, w->where, &w->seams->list[0],
                                          w->error);
    }
    for (int k = 1; status == TAUT_OK && k < parts; k++) {
        double place[3][2];
        taut_pattern_side_at(circle, (double)k / parts, place);
        status = add_spoke(w, circle, which, 1, place[0][around]);
    }
    for (int k = 1; status == TAUT_OK && k < count; k++) {
        status = add_spoke(w, circle, which, 0, at[k][around]);
    }
    return status;
}

static taut_status lay_geodesic(const rule_work *w)
{
    double at[2][2];
    taut_status status = take_room(w, 1);
    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        status = place_of(w, &w->rule->at[k], at[k]);
        if (status == TAUT_OK) {
            status = check_border(w, at[k]);
        }
    }
    if (status == TAUT_OK && at[0][0] == at[1][0] && at[0][1] == at[1][1]) {
        return taut_fail(w->error, TAUT_BAD_INPUT, "outside", w->where, taut_none, taut_none,
                         "found a seam that begins and ends at one place, expected two");
    }
    return status == TAUT_OK ? add_geodesic(w, at[0], at[1]) : status;
}

/* Geodesics square to the one between two places. */
static taut_status lay_parallel(const rule_work *w)
{
    static const taut_linefield_kind kind = {TAUT_TRACE_GEODESIC, 0};
    const taut_pattern_ground *g = w->ground;
    const double spacing = ldexp(w->rule->spacing, -g->carrier->scale);
    double at[2][2];
    taut_lath base;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        status = place_of(w, &w->rule->at[k], at[k]);
    }
    if (status == TAUT_OK) {
        status = taut_pattern_geodesic_lath(g->carrier, at[0], at[1], g->monitor, g->arena, &base,
                                            w->error);
    }
    if (status == TAUT_OK) {
        status = take_room(w, ceil(base.length * (1 - same_place) / spacing));
    }
    for (int k = 1; status == TAUT_OK && k * spacing < base.length * (1 - same_place); k++) {
        taut_station station;
        taut_pattern_side *side = next_seam(w);
        if (!taut_lath_at(kind, &base, TAUT_TRACE_LENGTH, k * spacing, &station)) {
            return taut_fail(w->error, TAUT_NO_SOLUTION, "no-geodesic", w->where, taut_none,
                             taut_none, "the geodesic that seams are square to has no place %d", k);
        }
        double ways[2][3], ends[2][2], length;
        status = taut_pattern_square_ends(g->carrier, &station, g->monitor, g->arena, ends, ways,
                                          &length, w->error);
        const double first[2] = {ends[0][0], ends[0][1]};
        if (status == TAUT_OK) {
            status = orient(w, ends);
        }
        if (status == TAUT_OK) {
            const int is_turned = first[0] != ends[0][0] || first[1] != ends[0][1];
            status =
                taut_pattern_geodesic_along(g->carrier, (const double(*)[2])ends, ways[is_turned],
                                            length, g->monitor, g->arena, side, w->error);
        }
    }
    return status;
}

static taut_status lay_lines(const rule_work *w)
{
    const taut_pattern_ground *g = w->ground;
    const int held = w->rule->held, along = 1 - held;
    const double lo = g->carrier->lo[held], hi = g->carrier->hi[held];
    taut_status status = take_room(w, w->rule->value_count);

    for (int k = 0; status == TAUT_OK && k < w->rule->value_count; k++) {
        const double value = w->rule->values[k];
        if (!(value > lo) || !(value < hi)) {
            return taut_fail(w->error, TAUT_BAD_INPUT, "outside", w->where, value,
                             value > lo ? hi : lo,
                             "found %s = %.17g, expected one between %.17g and %.17g",
                             held == 0 ? "u" : "v", value, lo, hi);
        }
        double at[2][2];
        for (int end = 0; end < 2; end++) {
            at[end][held] = value;
            at[end][along] = end == 0 ? g->carrier->lo[along] : g->carrier->hi[along];
        }
        status = orient(w, at);
        if (status == TAUT_OK) {
            status =
                taut_pattern_parameter_line(g->carrier, held, value, at[0][along] > at[1][along],
                                            g->monitor, g->arena, next_seam(w), w->error);
        }
    }
    return status;
}

static taut_status lay_curve(const rule_work *w)
{
    const taut_pattern_ground *g = w->ground;
    taut_pattern_trail trail;
    double at[2][2];
    taut_status status = take_room(w, 1);

    if (status == TAUT_OK) {
        status = taut_pattern_trail_find(g, w->rule->curve, w->where, &trail, w->error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (int end = 0; end < 2; end++) {
        memcpy(at[end], trail.ends[end], sizeof at[end]);
        snap(g->carrier, at[end]);
        status = status == TAUT_OK ? check_border(w, at[end]) : status;
    }
    if (status == TAUT_OK) {
        status = orient(w, at);
    }
    if (status != TAUT_OK) {
        return status;
    }
    double first[2] = {trail.ends[0][0], trail.ends[0][1]};
    snap(g->carrier, first);
    trail.is_back = first[0] != at[0][0] || first[1] != at[0][1];
    taut_pattern_side *side = next_seam(w);
    memcpy(side->ends, at, sizeof side->ends);
    side->kind = TAUT_SIDE_CURVE;
    return taut_pattern_trail_side(g, &trail, w->where, side, w->error);
}

taut_status taut_pattern_rule_seams(const taut_pattern_ground *ground,
                                    const taut_pattern_rule *rule, int index, int count,
                                    taut_pattern_seams *seams, taut_error *error)
{
    rule_work w = {ground, rule, index, seams, error, ""};
    snprintf(w.where, sizeof w.where, "/seams/%d", index);
    seams->list = NULL;
    seams->count = 0;
    switch (rule->kind) {
    case TAUT_PATTERN_PARALLEL:
        return lay_parallel(&w);
    case TAUT_PATTERN_GEODESIC:
        return lay_geodesic(&w);
    case TAUT_PATTERN_LINE:
        return lay_lines(&w);
    case TAUT_PATTERN_CURVE:
        return lay_curve(&w);
    default:
        return rule->trim > 0 ? lay_trimmed(&w, rule->count > 0 ? rule->count : count)
                              : lay_strips(&w, rule->count > 0 ? rule->count : count);
    }
}
