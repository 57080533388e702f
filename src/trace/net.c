#include "trace/net.h"

#include "core/crew.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "trace/between.h"
#include "trace/divide.h"

#include <stdio.h>
#include <string.h>

enum { BORDER_PIECES = 64 /* a span */, LOOK = 101 };
/* Sine of the angle below which a curve runs along the line that seeds it; seeds nearer than this,
 * over the size, are one; a lath that ends so near to where the next would begin, over the size, is that one. */
static const double least_sine = 1e-6, same_seed = 1e-9, same_end = 1e-6;
static const double same_curve =
    1e-8; /* of the length: ends, middles and lengths of two curves that are one */
static const double same_part = 1e-9;  /* of a part: multiples of it that end a curve */
static const double on_border = 1e-15; /* of the window: rounding */
static const double no_way = 1e-6; /* of the window: a curve that comes no farther from its seed */
static const double no_lath =
    1e-6; /* of the size: a curve of several as short touches the window alone */

static const double no_normal =
    1e-11; /* of the size, ten of the least steps: so near to where there is none */

static const char *const letters[] = {"AB", "AB", "GG", "AB"};

static taut_status fault_of(const taut_net *net, int seed, const double at[2],
                            taut_linefield_fault fault, taut_error *error);

/* ---- laths ---- */

static taut_status make_room(taut_net *net)
{
    if (net->count < net->room) {
        return TAUT_OK;
    }
    const int room = net->room > 0 ? 2 * net->room : 32;
    taut_lath *laths = taut_arena_take_raw(net->arena, (size_t)room, sizeof *laths);
    if (laths == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (net->count > 0) {
        memcpy(laths, net->laths, (size_t)net->count * sizeof *laths);
    }
    net->laths = laths;
    net->room = room;
    return TAUT_OK;
}

/* A place that is to have a lath, and what becomes of it. */
typedef struct planned {
    const taut_carrier *on;
    int family;
    double at[2];
    const double *direction; /* of a geodesic, or NULL */
    int both;
    int seed;      /* whose curve must be there, or -1: the place may be left out */
    int may_touch; /* its curve is no lath if it only touches the window */
    int may_turn; /* on a seam of a surface that closes it may be on either side, and is where the curve goes on inside */
    int is_held;  /* on the border, which its curve runs along there */
    int is_known; /* a lath goes through it already */
    double x[3], along[3], tangent[3];
    taut_linefield_fault fault;
    taut_status status;
    taut_lath lath;
} planned;

/* Is a lath of the family seeded there already, or is one of `count` that are planned? */
static int is_seeded(const taut_net *net, const planned *list, int count, int family,
                     const double x[3])
{
    const double room = same_seed * net->carrier->size;
    for (int k = 0; net->problem->net != TAUT_TRACE_GEODESIC && k < net->count; k++) {
        if (net->laths[k].family == family &&
            taut_length_between(net->laths[k].at_seed.x, x) <= room) {
            return 1;
        }
    }
    for (int k = 0; net->problem->net != TAUT_TRACE_GEODESIC && k < count; k++) {
        if (list[k].family == family && !list[k].is_known && list[k].fault == TAUT_LINEFIELD_FINE &&
            taut_length_between(list[k].x, x) <= room) {
            return 1;
        }
    }
    return 0;
}

/* Which way the lath is to run: as the last one of its family, of `count` that are planned or else of the net, or with
 * growing u (v if du = 0). */
static void way_of(const taut_net *net, const planned *list, int count, int family,
                   const double at[2], double along[3])
{
    const taut_linefield_kind kind = {net->problem->net, family};
    const double up[3] = {0, 0, 0};
    double x[TAUT_CARRIER_VECTORS][3];
    taut_walk_state state;
    int span[2];

    for (int k = count - 1; k >= 0; k--) {
        if (list[k].family == family && !list[k].is_known && list[k].fault == TAUT_LINEFIELD_FINE) {
            memcpy(along, list[k].tangent, 3 * sizeof(double));
            return;
        }
    }
    for (int k = net->count - 1; k >= 0; k--) {
        if (net->laths[k].family == family) {
            memcpy(along, net->laths[k].seed_tangent, 3 * sizeof(double));
            return;
        }
    }
    taut_carrier_cell(net->carrier, at, NULL, span);
    taut_carrier_at(net->carrier, span, at, 1, x);
    memcpy(along, x[1], 3 * sizeof(double));
    if (taut_walk_start(net->carrier, kind, at, span, up, &state) != TAUT_LINEFIELD_FINE) {
        return;
    }
    const double *ab = state.y + TAUT_WALK_A;
    const double sign = fabs(ab[0]) * taut_length(x[1]) > least_sine ? ab[0] : ab[1];
    for (int c = 0; c < 3; c++) {
        along[c] = sign < 0 ? -state.tangent[c] : state.tangent[c];
    }
}

static void leave_out_on(taut_net *net, const taut_carrier *on, int family, const double at[2],
                         taut_linefield_fault fault, int is_along)
{
    if (net->left_count < TAUT_TRACE_LATHS_MAX) {
        net->left_out[net->left_count++] =
            (taut_left_out){on, family, {at[0], at[1]}, fault, is_along, 0};
    }
}

static void leave_out(taut_net *net, int family, const double at[2], taut_linefield_fault fault,
                      int is_along)
{
    leave_out_on(net, net->carrier, family, at, fault, is_along);
}

static taut_status too_many(double count, taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "too-many-laths", "/seeds", count,
                     TAUT_TRACE_LATHS_MAX, "the net has more than %d curves: ask for fewer",
                     TAUT_TRACE_LATHS_MAX);
}

/* Where a curve leaves the window over a seam at its very place, the place on the other side of the seam. */
static void turn_inside(planned *p, const double x[TAUT_CARRIER_VECTORS][3])
{
    const taut_carrier *on = p->on;
    const double e = taut_dot(x[1], x[1]), f = taut_dot(x[1], x[2]), g = taut_dot(x[2], x[2]);
    const double a = taut_dot(x[1], p->tangent), b = taut_dot(x[2], p->tangent);
    const double way[2] = {g * a - f * b, e * b - f * a}; /* times a positive number */

    for (int d = 0; d < 2 && p->may_turn; d++) {
        if (on->wraps[d] && p->at[d] == on->lo[d] && way[d] < 0) {
            p->at[d] = on->hi[d];
        } else if (on->wraps[d] && p->at[d] == on->hi[d] && way[d] > 0) {
            p->at[d] = on->lo[d];
        }
    }
}

/* What is known of place k of a list before it is followed. */
static void plan(const taut_net *net, planned *list, int k)
{
    planned *p = &list[k];
    const taut_linefield_kind kind = {net->problem->net, p->family};
    double x[TAUT_CARRIER_VECTORS][3];
    taut_walk_state state;
    int span[2];

    taut_carrier_cell(p->on, p->at, NULL, span);
    taut_carrier_at(p->on, span, p->at, 1, x);
    memcpy(p->x, x[0], sizeof p->x);
    p->is_known = is_seeded(net, list, k, p->family, p->x);
    if (p->is_known) {
        return;
    }
    if (taut_carrier_is_crease(p->on, p->at)) {
        p->fault = TAUT_LINEFIELD_CREASE;
        return;
    }
    if (p->direction != NULL) {
        taut_linefield_tangent((const double(*)[3])x, p->direction, p->along);
    } else {
        way_of(net, list, k, p->family, p->at, p->along);
    }
    p->fault = taut_walk_start(p->on, kind, p->at, span, p->along, &state);
    memcpy(p->tangent, state.tangent, sizeof p->tangent);
    turn_inside(p, (const double(*)[3])x);
}

/* The threads that follow places of a list. */
typedef struct followers {
    const taut_net *net;
    planned *list;
    taut_arena **arenas; /* a worker's own */
    taut_pulse *pulse;   /* of the first worker */
} followers;

static void follow_one(void *context, int worker, int64_t task)
{
    const followers *f = context;
    planned *p = &f->list[task];
    const taut_linefield_kind kind = {f->net->problem->net, p->family};
    const taut_monitor monitor = taut_pulse_monitor(f->pulse);
    taut_lath_options options = f->net->options;

    options.follow.monitor = worker == 0 ? &monitor : NULL;
    if (!p->is_known && p->fault == TAUT_LINEFIELD_FINE) {
        p->status = taut_lath_trace(p->on, kind, p->at, p->along, p->both, &options,
                                    f->arenas[worker], &p->lath, &p->fault);
    }
}

static void free_arena(void *arena)
{
    taut_arena_free(arena);
}

/* All places of a list, each by one thread: the same laths for any number of them. */
static taut_status follow_all(const taut_net *net, planned *list, int count)
{
    const int workers = taut_parallel_workers(net->threads, count);
    taut_pulse pulse = {.monitor = net->options.follow.monitor,
                        .what = "tracing",
                        .done = net->options.follow.done};
    const taut_crew crew = {.threads = net->threads, .pulse = &pulse};
    followers f = {.net = net,
                   .list = list,
                   .arenas = taut_arena_take(net->arena, (size_t)workers, sizeof *f.arenas),
                   .pulse = &pulse};
    if (f.arenas == NULL) {
        return TAUT_NO_MEMORY;
    }
    f.arenas[0] = net->arena;
    for (int k = 1; k < workers; k++) {
        f.arenas[k] = taut_arena_new();
        if (!taut_arena_keep(net->arena, f.arenas[k], free_arena)) {
            return TAUT_NO_MEMORY;
        }
    }
    return taut_crew_run(&crew, workers, count, 0, follow_one, &f) ? TAUT_INTERRUPTED : TAUT_OK;
}

static void point_of(const taut_lath *lath, double s, double x[3])
{
    double points[TAUT_QUINTIC][3], step[3], bend[3];
    int k = 0;

    while (k < lath->count - 1 && s > lath->segments[k].to.s) {
        k++;
    }
    const taut_segment *segment = &lath->segments[k];
    taut_segment_space(segment, points);
    taut_quintic_at(3, points[0], (s - segment->from.s) / (segment->to.s - segment->from.s), x,
                    step, bend);
}

/* Do two laths run over one curve, either way? Each that comes back to the edge it is seeded on is met twice there. */
static int are_one(const taut_lath *a, const taut_lath *b)
{
    const double room = same_curve * a->length;
    double x[2][3][3];

    if (!(fabs(a->length - b->length) <= room)) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        point_of(a, a->segments[0].from.s + a->length * i / 2, x[0][i]);
        point_of(b, b->segments[0].from.s + b->length * i / 2, x[1][i]);
    }
    const int same = taut_length_between(x[0][0], x[1][0]) <= room &&
                     taut_length_between(x[0][2], x[1][2]) <= room;
    const int turned = taut_length_between(x[0][0], x[1][2]) <= room &&
                       taut_length_between(x[0][2], x[1][0]) <= room;
    return (same || turned) && taut_length_between(x[0][1], x[1][1]) <= room;
}

static int is_there(const taut_net *net, const taut_lath *lath)
{
    int there = 0;
    for (int k = 0; !there && k < net->count; k++) {
        there = net->laths[k].family == lath->family && are_one(&net->laths[k], lath);
    }
    return there;
}

/* Is that where a curve began, about? */
static int is_begun(const taut_carrier *carrier, const double at[2], const double end[2])
{
    int near = 1;
    for (int d = 0; d < 2; d++) {
        near &= fabs(end[d] - at[d]) <= no_way * (carrier->hi[d] - carrier->lo[d]);
    }
    return near;
}

/* Does a curve of several only touch the window, in a corner or along the border, or what has the net? */
static int only_touches(const taut_net *net, const planned *p)
{
    const taut_lath *lath = &p->lath;
    int leaves = p->may_touch && lath->length <= no_lath * net->carrier->size;
    for (int end = 0; end < 2; end++) {
        leaves &= lath->edges[end][0] >= 0 || lath->ended[end] == TAUT_END_PARABOLIC;
    }
    return leaves;
}

/* Such a curve is told once, though the walk round the border comes to it again. */
static void leave_out_short(taut_net *net, const planned *p)
{
    int is_told = net->left_count >= TAUT_TRACE_LATHS_MAX;
    for (int k = 0; !is_told && k < net->left_count; k++) {
        const taut_left_out *left = &net->left_out[k];
        is_told = left->is_short && left->on == p->on && left->family == p->family &&
                  is_begun(p->on, left->at, p->at);
    }
    if (!is_told) {
        leave_out(net, p->family, p->at, TAUT_LINEFIELD_FINE, 0);
        net->left_out[net->left_count - 1].is_short = 1;
    }
}

/* How far a place is from where there is no normal: |x_u x x_v| over its slope n . (x_ud x x_v + x_u x x_vd), in space. */
static double singular_away(const taut_carrier *carrier, const double at[2])
{
    double x[TAUT_CARRIER_VECTORS][3], away = INFINITY;
    taut_form_pair forms;

    taut_carrier_forms_at(carrier, at, x, &forms);
    for (int d = 0; d < 2; d++) {
        double cross[2][3];
        taut_cross(x[3 + d], x[2], cross[0]);
        taut_cross(x[1], x[4 + d], cross[1]);
        const double slope = taut_dot(forms.normal, cross[0]) + taut_dot(forms.normal, cross[1]);
        away = fmin(away, forms.w / fabs(slope) * taut_length(x[1 + d]));
    }
    return away;
}

/* Why a curve could not be followed on: beside where the surface has no normal, as at a fold, curves bend and twist without
 * bound. */
static taut_status stalled(const planned *p, int end, taut_error *error)
{
    const taut_carrier *on = p->lath.end_on[end];
    const double *to = p->lath.ends[end];

    if (singular_away(on, to) < no_normal * on->size) {
        return taut_fail(error, TAUT_NO_SOLUTION, "singular", "/seeds", taut_none, taut_none,
                         "the surface has no normal near (%.6g, %.6g), where a curve from (%.6g, "
                         "%.6g) comes to",
                         to[0], to[1], p->at[0], p->at[1]);
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "stalled", NULL, taut_none, taut_none,
                     "a curve from (%.6g, %.6g) could not be followed beyond (%.6g, %.6g)",
                     p->at[0], p->at[1], to[0], to[1]);
}

/* The lath that was followed from a place becomes one of the net, if its curve is none of it. */
static taut_status take_lath(taut_net *net, planned *p, taut_error *error)
{
    const taut_lath *lath = &p->lath;

    if (p->status != TAUT_OK) {
        return taut_fail_status(error, p->status);
    }
    if (p->is_known) {
        return TAUT_OK;
    }
    if (p->seed >= 0 && (p->fault != TAUT_LINEFIELD_FINE || lath->count == 0)) {
        return fault_of(net, p->seed, p->at, p->fault, error);
    }
    if (p->fault != TAUT_LINEFIELD_FINE) {
        leave_out(net, p->family, p->at, p->fault, 0);
    }
    if (p->fault == TAUT_LINEFIELD_FINE && lath->count == 0 && p->is_held) {
        leave_out_short(net, p);
    }
    if (p->fault != TAUT_LINEFIELD_FINE || lath->count == 0) {
        return TAUT_OK;
    }
    for (int end = 0; end < 2; end++) {
        if (lath->ended[end] == TAUT_END_STALLED && p->seed < 0 &&
            is_begun(p->on, p->at, lath->ends[end])) {
            leave_out(net, p->family, p->at,
                      net->problem->net == TAUT_TRACE_ASYMPTOTIC ? TAUT_LINEFIELD_ELLIPTIC
                                                                 : TAUT_LINEFIELD_ROUND,
                      0);
            return TAUT_OK;
        }
        if (lath->ended[end] == TAUT_END_STALLED) {
            return stalled(p, end, error);
        }
    }
    if (is_there(net, lath)) {
        return TAUT_OK;
    }
    if (only_touches(net, p)) {
        leave_out_short(net, p);
        return TAUT_OK;
    }
    if (net->count >= TAUT_TRACE_LATHS_MAX) {
        return too_many(net->count, error);
    }
    if (make_room(net) != TAUT_OK || taut_marks_add(&net->marks, lath) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    net->laths[net->count] = *lath;
    snprintf(net->laths[net->count].name, sizeof lath->name, "%c%d",
             letters[net->problem->net][p->family], ++net->of_family[p->family]);
    net->count++;
    return TAUT_OK;
}

/* The laths of the places of a list: followed all at once, taken in order. */
static taut_status add_laths(taut_net *net, planned *list, int count, taut_error *error)
{
    const taut_carrier *here = net->carrier;

    for (int k = 0; k < count; k++) {
        net->carrier = list[k].on;
        plan(net, list, k);
    }
    net->carrier = here;
    taut_status status = follow_all(net, list, count);
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        net->carrier = list[k].on;
        status = take_lath(net, &list[k], error);
    }
    net->carrier = here;
    return status;
}

/* Room for so many places; NULL where there is none. */
static planned *new_list(const taut_net *net, int count)
{
    return taut_arena_take(net->arena, (size_t)count + 1, sizeof(planned));
}

/* One of several places: where there is no curve it is left out. */
static planned place_of(const taut_carrier *on, int family, const double at[2])
{
    return (planned){.on = on, .family = family, .at = {at[0], at[1]}, .both = 1, .seed = -1};
}

/* A place that was reckoned: rounding takes it out of the window. */
static void hold_in_window(const taut_carrier *carrier, double at[2])
{
    for (int d = 0; d < 2; d++) {
        at[d] = fmin(fmax(at[d], carrier->lo[d]), carrier->hi[d]);
    }
}

/* The same of a place of a lath, which may lie on another surface. */
static planned place_on(taut_station *at, int family)
{
    hold_in_window(at->on, at->at);
    return place_of(at->on, family, at->at);
}

/* ---- seeds on lines ---- */

/* The sine of the angle between the family and a direction of the window. */
static double sine_between(const taut_net *net, int family, const double at[2],
                           const double direction[2])
{
    const taut_linefield_kind kind = {net->problem->net, family};
    double x[TAUT_CARRIER_VECTORS][3], along[3], across[3];
    taut_walk_state state;
    int span[2];

    taut_carrier_cell(net->carrier, at, NULL, span);
    taut_carrier_at(net->carrier, span, at, 1, x);
    taut_linefield_tangent((const double(*)[3])x, direction, along);
    if (taut_walk_start(net->carrier, kind, at, span, along, &state) != TAUT_LINEFIELD_FINE) {
        return 1;
    }
    taut_cross(state.tangent, along, across);
    return taut_length(across) / taut_length(along);
}

static taut_status seed_line(taut_net *net, const taut_trace_seed *seed, int family, int index,
                             const double from[2], const double to[2], taut_error *error)
{
    taut_ruler ruler;
    const double way[2] = {to[0] - from[0], to[1] - from[1]};
    const int first = seed->ends ? 0 : 1, last = seed->ends ? seed->count + 1 : seed->count;
    double sine = 0;

    if (taut_ruler_new(net->arena, net->carrier, net->problem->net, seed->by, from, to, &ruler) !=
        TAUT_OK) {
        return taut_fail_memory(error);
    }
    const double whole = ruler.sum[ruler.count];
    double *places = taut_arena_take(net->arena, (size_t)seed->count + 2, 2 * sizeof(double));
    if (places == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = first; k <= last; k++) {
        taut_ruler_at(&ruler, whole * k / (seed->count + 1), places + 2 * k);
        sine = fmax(sine, sine_between(net, family, places + 2 * k, way));
    }
    if (sine < least_sine) {
        if (seed->family == family + 1 || net->problem->families == family + 1) {
            char where[32];
            snprintf(where, sizeof where, "/seeds/%d", index);
            return taut_fail(error, TAUT_NO_SOLUTION, "along", where, sine, least_sine,
                             "every curve of family %c runs along the line that seeds it",
                             letters[net->problem->net][family]);
        }
        leave_out(net, family, places + 2 * first, TAUT_LINEFIELD_FINE, 1);
        return TAUT_OK;
    }
    planned *list = new_list(net, seed->count + 2);
    if (list == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = first; k <= last; k++) {
        list[k - first] = place_of(net->carrier, family, places + 2 * k);
        list[k - first].may_touch = 1;
    }
    return add_laths(net, list, last - first + 1, error);
}

static taut_status seed_edge(taut_net *net, const taut_trace_seed *seed, int family, int index,
                             taut_error *error)
{
    const double *lo = net->carrier->lo, *hi = net->carrier->hi;
    const int d = seed->edge == TAUT_EDGE_U0 || seed->edge == TAUT_EDGE_U1 ? 0 : 1;
    const int high = seed->edge == TAUT_EDGE_U1 || seed->edge == TAUT_EDGE_V1;
    double from[2] = {lo[0], lo[1]}, to[2] = {hi[0], hi[1]};

    from[d] = to[d] = high ? hi[d] : lo[d];
    return seed_line(net, seed, family, index, from, to, error);
}

/* A place of a lath at whose measure it ends because the net does, as at an umbilic, is left out: a curve from there would begin
 * beside it. */
static int leave_round_end(taut_net *net, const taut_lath *lath, int family, double target,
                           double whole, double part)
{
    const int end = target > whole / 2;
    const int is_round = lath->ended[end] == TAUT_END_FLAT || lath->ended[end] == TAUT_END_UMBILIC;
    const int is_there = is_round && fabs(target - (end ? whole : 0)) <= same_part * part;
    if (is_there) {
        leave_out_on(net, lath->end_on[end], family, lath->ends[end], TAUT_LINEFIELD_ROUND, 0);
    }
    return is_there;
}

static taut_status seed_lath(taut_net *net, const taut_trace_seed *seed, int index,
                             taut_error *error)
{
    int found = -1;
    for (int k = 0; k < net->count; k++) {
        found = strcmp(net->laths[k].name, seed->lath) == 0 ? k : found;
    }
    if (found < 0) {
        char where[32];
        snprintf(where, sizeof where, "/seeds/%d/lath", index);
        return taut_fail(error, TAUT_BAD_INPUT, "name", where, taut_none, taut_none,
                         "found \"%.40s\", expected the name of a curve that an earlier seed makes",
                         seed->lath);
    }
    const taut_linefield_kind kind = {net->problem->net, net->laths[found].family};
    const int other = net->problem->net == TAUT_TRACE_GEODESIC ? 0 : 1 - kind.family;
    const double whole =
        seed->by == TAUT_TRACE_CONFORMAL ? net->laths[found].measure : net->laths[found].length;
    const int first = seed->ends ? 0 : 1, last = seed->ends ? seed->count + 1 : seed->count;
    planned *list = new_list(net, seed->count + 2);
    int count = 0;
    for (int k = first; list != NULL && k <= last; k++) {
        const taut_lath *lath = &net->laths[found];
        const double target = whole * k / (seed->count + 1);
        taut_station at;
        if (!leave_round_end(net, lath, other, target, whole, whole / (seed->count + 1)) &&
            taut_lath_at(kind, lath, seed->by, target, &at)) {
            list[count++] = place_on(&at, other);
        }
    }
    return list != NULL ? add_laths(net, list, count, error) : taut_fail_memory(error);
}

/* ---- cells ---- */

/* The border of the window, once around: place and direction at t in [0, 4). */
static void border_at(const taut_carrier *carrier, double t, double at[2], double way[2])
{
    const int side = t < 1 ? 0 : t < 2 ? 1 : t < 3 ? 2 : 3;
    const double part = t - side;
    const double du = carrier->hi[0] - carrier->lo[0], dv = carrier->hi[1] - carrier->lo[1];
    const double u[4] = {carrier->lo[0] + part * du, carrier->hi[0], carrier->hi[0] - part * du,
                         carrier->lo[0]};
    const double v[4] = {carrier->lo[1], carrier->lo[1] + part * dv, carrier->hi[1],
                         carrier->hi[1] - part * dv};
    const double ways[4][2] = {{du, 0}, {0, dv}, {-du, 0}, {0, -dv}};
    at[0] = fmin(fmax(u[side], carrier->lo[0]), carrier->hi[0]);
    at[1] = fmin(fmax(v[side], carrier->lo[1]), carrier->hi[1]);
    memcpy(way, ways[side], 2 * sizeof(double));
}

/* A walk along the border. */
typedef struct border_walk {
    taut_net *net;
    int family;
    taut_trace_by by;
    double tangent[3]; /* of the family, carried on */
    int is_left;       /* the net did not exist somewhere */
} border_walk;

/* The measure across the family per t; 0 where there is none. */
static double border_rate(border_walk *w, double t)
{
    const taut_net *net = w->net;
    const taut_linefield_kind kind = {net->problem->net, w->family};
    double at[2], way[2], x[TAUT_CARRIER_VECTORS][3], along[3], sideways[3];
    taut_form_pair forms;
    taut_walk_state state;
    int span[2];

    border_at(net->carrier, t, at, way);
    taut_carrier_cell(net->carrier, at, NULL, span);
    taut_carrier_at(net->carrier, span, at, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    if (taut_walk_start(net->carrier, kind, at, span, w->tangent, &state) != TAUT_LINEFIELD_FINE) {
        w->is_left = 1;
        return 0;
    }
    memcpy(w->tangent, state.tangent, sizeof w->tangent);
    taut_cross(forms.normal, state.tangent, sideways);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    return taut_dot(sideways, along) *
           (w->by == TAUT_TRACE_CONFORMAL ? taut_linefield_measure(net->problem->net, &forms) : 1);
}

static double border_measure(border_walk *w, double from, double to)
{
    enum { NODES = 8 };
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES; k++) {
        sum += weights[k] * border_rate(w, (from + to) / 2 + (to - from) / 2 * nodes[k]);
    }
    return sum * (to - from) / 2;
}

/* The last place in (from, to] where the border has a lath of the family, as t; -1 where there is none. */
static double last_end(const taut_net *net, int family, double from, double to)
{
    return taut_marks_last(&net->marks, net->carrier, family, from, to);
}

/* Where in [low, high] the measure from low reaches the rest. */
static double reach(border_walk *w, double low, double high, double rest)
{
    const double begin = low;
    const border_walk before = *w;
    for (int round = 0; round < 50; round++) {
        const double t = (low + high) / 2;
        border_walk copy = before;
        if (fabs(border_measure(&copy, begin, t)) < rest) {
            low = t;
        } else {
            high = t;
        }
    }
    return high;
}

static double wrapped(double t)
{
    return t >= 4 ? t - 4 : t;
}

/* The end of a piece of the border that begins at t, no piece around a corner. */
static double piece_end(double t, double piece)
{
    return fmin(t + piece, floor(t) + 1);
}

/* The first end of a lath of the family in (from, to], as last_end has them; -1 where there is none. */
static double next_end(const taut_net *net, int family, double from, double to)
{
    double first = last_end(net, family, from, to), before = first;
    while (before >= 0) {
        first = before;
        before = last_end(net, family, from, nextafter(first, from));
    }
    return first;
}

/* Is there an end of the family as near to t as rounding explains? */
static int ends_near(const taut_net *net, int family, double t)
{
    double at[2], way[2], x[2][TAUT_CARRIER_VECTORS][3];
    int span[2];
    if (next_end(net, family, t - same_end, t + same_end) >= 0) {
        return 1;
    }
    border_at(net->carrier, t >= 4 ? t - 4 : t, at, way);
    taut_carrier_cell(net->carrier, at, NULL, span);
    taut_carrier_at(net->carrier, span, at, 0, x[0]);
    for (int k = 0; k < net->count; k++) {
        const taut_lath *lath = &net->laths[k];
        for (int end = 0; lath->family == family && end < 2; end++) {
            if (lath->edges[end][0] < 0) {
                continue;
            }
            taut_carrier_cell(lath->end_on[end], lath->ends[end], NULL, span);
            taut_carrier_at(lath->end_on[end], span, lath->ends[end], 0, x[1]);
            if (taut_length_between(x[0][0], x[1][0]) <= same_end * net->carrier->size) {
                return 1;
            }
        }
    }
    return 0;
}

/* Where a lath of the family ends behind t, nearer than `most` on the way: one at t would be the same once more but for
 * that. -1: none does, before the net ends there. */
static double end_ahead(border_walk w, double t, double piece, double most)
{
    double sum = 0;
    w.is_left = 0;
    for (const double last = t + 4; t < last;) {
        const double next = piece_end(t, piece), end = next_end(w.net, w.family, t, next);
        const double to = end >= 0 ? end : next;
        const double turn = t - wrapped(t);
        sum += border_measure(&w, t - turn, to - turn);
        if (!(fabs(sum) < most) || w.is_left || end >= 0) {
            return fabs(sum) < most && !w.is_left ? end : -1;
        }
        t = next;
    }
    return -1;
}

/* Once around the border: a seed wherever it is a part away from the last lath, and half a part before the next one. */
static taut_status seed_border(taut_net *net, int family, taut_trace_by by, double part,
                               taut_error *error)
{
    border_walk w = {.net = net, .family = family, .by = by, .tangent = {0, 0, 0}};
    const double start = taut_marks_first(&net->marks, net->carrier, family);
    const int spans = taut_basis_span_count(net->carrier->basis[0]) +
                      taut_basis_span_count(net->carrier->basis[1]);
    const int pieces = 4 * BORDER_PIECES * (spans < 16 ? 1 : spans / 16);
    double sum = 0, t = start;
    planned *one = new_list(net, 1);

    if (one == NULL) {
        return taut_fail_memory(error);
    }
    if (start < 0) {
        return TAUT_OK;
    }
    for (int k = 0; k < pieces; k++) {
        double next = start + 4 * (k + 1.0) / pieces;
        const double side = floor(t) + 1;
        next = t < side && next > side ? side : next; /* no piece around a corner */
        k -= next == side && next < start + 4 * (k + 1.0) / pieces;
        while (t < next) {
            const border_walk before = w;
            const double turn = t - wrapped(t), end = next_end(net, family, t, next);
            const double to = end >= 0 ? end : next;
            const double more = border_measure(&w, t - turn, to - turn);
            if (fabs(sum + more) < part * (1 - 1e-9)) {
                sum = end >= 0 ? 0 : sum + more;
                t = to;
                continue;
            }
            w = before;
            const double at = reach(&w, t - turn, to - turn, part - fabs(sum)) + turn;
            border_measure(&w, t - turn, at - turn);
            const double ahead = end_ahead(w, at, 4.0 / pieces, part / 2);
            if (ahead < 0 && !ends_near(net, family, at)) {
                double place[2], way[2];
                border_at(net->carrier, wrapped(at), place, way);
                *one = place_of(net->carrier, family, place);
                one->may_touch = one->may_turn = 1;
                const taut_status status = add_laths(net, one, 1, error);
                if (status != TAUT_OK) {
                    return status;
                }
            }
            sum = 0;
            t = at > t ? at : next;
        }
    }
    return TAUT_OK;
}

/* A curve along the border is not to begin beside it by rounding. */
static void hold_on_border(const taut_net *net, planned *p)
{
    for (int d = 0; d < 2; d++) {
        const double lo = p->on->lo[d], hi = p->on->hi[d], room = on_border * (hi - lo);
        const double border = p->at[d] - lo <= room ? lo : hi, direction[2] = {d, 1 - d};
        if (p->on == net->carrier && fabs(p->at[d] - border) <= room &&
            sine_between(net, p->family, p->at, direction) <= least_sine) {
            p->at[d] = border;
            p->is_held = 1;
        }
    }
}

/* Seeds of a family at all multiples of the part from s0 of a lath of the other one. */
static taut_status seed_lattice(taut_net *net, int family, const taut_lath *other, taut_trace_by by,
                                double part, taut_error *error)
{
    const taut_linefield_kind kind = {net->problem->net, other->family};
    taut_station at;
    int count = 0;

    if (!taut_lath_at(kind, other, TAUT_TRACE_LENGTH, other->seed_s, &at)) {
        return TAUT_OK;
    }
    const double middle = by == TAUT_TRACE_CONFORMAL ? at.measure : at.s;
    const double whole = by == TAUT_TRACE_CONFORMAL ? other->measure : other->length;
    const double lowest = ceil(-middle / part - same_part),
                 highest = floor((whole - middle) / part + same_part);
    if (!(highest - lowest < TAUT_TRACE_LATHS_MAX)) {
        return too_many(highest - lowest, error);
    }
    planned *list = new_list(net, (int)(highest - lowest) + 1);
    for (double k = lowest; list != NULL && k <= highest; k++) {
        const double target = fmin(fmax(middle + k * part, 0), whole);
        if (k == 0) {
            list[count++] = place_of(net->carrier, family, other->seed);
        } else if (!leave_round_end(net, other, family, target, whole, part) &&
                   taut_lath_at(kind, other, by, target, &at)) {
            list[count] = place_on(&at, family);
            hold_on_border(net, &list[count]);
            list[count++].may_touch = 1;
        }
    }
    return list != NULL ? add_laths(net, list, count, error) : taut_fail_memory(error);
}

/* The two curves through the node, for measuring only. */
static taut_status cross_through(taut_net *net, const double at[2], int index, taut_lath through[2],
                                 taut_error *error)
{
    if (taut_carrier_is_crease(net->carrier, at)) {
        return fault_of(net, index, at, TAUT_LINEFIELD_CREASE, error);
    }
    for (int family = 0; family < 2; family++) {
        const taut_linefield_kind kind = {net->problem->net, family};
        taut_linefield_fault fault = TAUT_LINEFIELD_FINE;
        double along[3];
        way_of(net, NULL, 0, family, at, along);
        const taut_status status = taut_lath_trace(net->carrier, kind, at, along, 1, &net->options,
                                                   net->arena, &through[family], &fault);
        if (status != TAUT_OK) {
            return taut_fail_status(error, status);
        }
        if (fault != TAUT_LINEFIELD_FINE || through[family].count == 0) {
            return fault_of(net, index, at, fault, error);
        }
    }
    return TAUT_OK;
}

static taut_status seed_cells(taut_net *net, const taut_trace_seed *seed, int families, int index,
                              taut_error *error)
{
    double at[2] = {seed->at[0], seed->at[1]};
    taut_lath through[2];
    const int by_measure = seed->by == TAUT_TRACE_CONFORMAL;

    for (int d = 0; d < 2 && !seed->has_at; d++) {
        at[d] = net->carrier->lo[d] + (net->carrier->hi[d] - net->carrier->lo[d]) / 2;
    }
    taut_status status = cross_through(net, at, index, through, error);
    if (status != TAUT_OK) {
        return status;
    }
    double part = 0;
    if (seed->kind == TAUT_TRACE_CELLS) {
        const double longer = by_measure ? fmax(through[0].measure, through[1].measure)
                                         : fmax(through[0].length, through[1].length);
        part = longer / seed->count;
    } else {
        double x[TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms;
        taut_carrier_forms_at(net->carrier, at, x, &forms);
        part = ldexp(seed->cell, -net->carrier->scale) *
               (by_measure ? taut_linefield_measure(net->problem->net, &forms) : 1);
    }
    for (int family = 0; status == TAUT_OK && family < 2; family++) {
        if (families & (1 << family)) {
            status = seed_lattice(net, family, &through[1 - family], seed->by, part, error);
            if (status == TAUT_OK) {
                status = seed_border(net, family, seed->by, part, error);
            }
        }
    }
    return status;
}

/* ---- single places, and what is wrong with them ---- */

/* A place of a grid where K < 0 that is nearest to `at`; 0 where there is none. *saddles: how many. */
static int nearest_saddle(const taut_net *net, const double at[2], double found[2])
{
    double best = INFINITY;
    for (int i = 0; i < LOOK; i++) {
        for (int j = 0; j < LOOK; j++) {
            const taut_carrier *carrier = net->carrier;
            const double place[2] = {
                carrier->lo[0] + (carrier->hi[0] - carrier->lo[0]) * i / (LOOK - 1),
                carrier->lo[1] + (carrier->hi[1] - carrier->lo[1]) * j / (LOOK - 1)};
            double x[TAUT_CARRIER_VECTORS][3];
            taut_form_pair forms;
            taut_carrier_forms_at(carrier, place, x, &forms);
            const double square = forms.m * forms.m - forms.l * forms.n;
            const double away = taut_hypot(place[0] - at[0], place[1] - at[1]);
            const double radius = taut_form_pair_radius(&forms);
            if (square > 1e-10 * radius * radius * forms.w * forms.w &&
                radius > 1e-8 * carrier->roundest && away < best) {
                best = away;
                memcpy(found, place, sizeof place);
            }
        }
    }
    return best < INFINITY;
}

static taut_status elliptic(const taut_net *net, const char *where, const double at[2],
                            taut_error *error)
{
    double x[TAUT_CARRIER_VECTORS][3], found[2];
    taut_form_pair forms;
    taut_carrier_forms_at(net->carrier, at, x, &forms);
    const double gauss = ldexp(taut_form_pair_gauss(&forms), -2 * net->carrier->scale);
    if (!nearest_saddle(net, at, found)) {
        const double radius = taut_form_pair_radius(&forms);
        const int is_flat = fabs(taut_form_pair_gauss(&forms)) <= 1e-10 * radius * radius;
        return taut_fail(error, TAUT_NO_SOLUTION, is_flat ? "parabolic" : "elliptic", where, gauss,
                         0,
                         is_flat ? "the Gauss curvature vanishes everywhere: there is one "
                                   "asymptotic direction and no net"
                                 : "the Gauss curvature is nowhere negative: there are no "
                                   "asymptotic curves");
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "elliptic", where, gauss, 0,
                     "the Gauss curvature at (%.6g, %.6g) is %.3g, and asymptotic curves need a "
                     "negative one; the nearest place of a grid that has it is (%.6g, %.6g)",
                     at[0], at[1], gauss, found[0], found[1]);
}

static taut_status fault_of(const taut_net *net, int seed, const double at[2],
                            taut_linefield_fault fault, taut_error *error)
{
    char where[32] = "/seeds";
    if (seed >= 0 && net->problem->seed_count > 0) {
        snprintf(where, sizeof where, "/seeds/%d", seed);
    }
    if (fault == TAUT_LINEFIELD_ELLIPTIC) {
        return elliptic(net, where, at, error);
    }
    if (fault == TAUT_LINEFIELD_ROUND) {
        double x[TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms;
        taut_carrier_forms_at(net->carrier, at, x, &forms);
        const int is_flat = !(fabs(taut_form_pair_mean(&forms)) * net->carrier->size > 1e-9);
        return taut_fail(error, TAUT_NO_SOLUTION, is_flat ? "flat" : "umbilic", where, taut_none,
                         taut_none,
                         is_flat ? "the surface is flat at (%.6g, %.6g)"
                                 : "both principal curvatures are equal at (%.6g, %.6g)",
                         at[0], at[1]);
    }
    if (fault == TAUT_LINEFIELD_CREASE) {
        return taut_fail(error, TAUT_NO_SOLUTION, "crease", where, taut_none, taut_none,
                         "the normal of the surface jumps at (%.6g, %.6g): seed beside it", at[0],
                         at[1]);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "singular", where, taut_none, taut_none,
                     "the surface has no normal, or the curve no length, at (%.6g, %.6g)", at[0],
                     at[1]);
}

/* The geodesic from one place to another. */
static taut_status seed_between(taut_net *net, const taut_trace_seed *seed, int index,
                                taut_error *error)
{
    const taut_linefield_kind kind = {TAUT_TRACE_GEODESIC, 0};
    taut_linefield_fault fault = TAUT_LINEFIELD_FINE;
    taut_lath_options options = net->options;
    taut_between way;
    char where[32];

    snprintf(where, sizeof where, "/seeds/%d", index);
    taut_status status = make_room(net);
    if (status == TAUT_OK) {
        status = taut_geodesic_between(net->carrier, seed->at, seed->to, &net->options.follow,
                                       net->arena, &way);
    }
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    if (net->count >= TAUT_TRACE_LATHS_MAX) {
        return too_many(net->count, error);
    }
    if (way.is_found) {
        options.follow.max_length = way.length;
        status = taut_lath_trace(net->carrier, kind, seed->at, way.along, 0, &options, net->arena,
                                 &net->laths[net->count], &fault);
        if (status != TAUT_OK) {
            return taut_fail_status(error, status);
        }
    }
    taut_lath *lath = &net->laths[net->count];
    if (!way.is_found || fault != TAUT_LINEFIELD_FINE || lath->count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-geodesic", where, taut_none, taut_none,
                         "no geodesic from (%.6g, %.6g) to (%.6g, %.6g) was found inside the "
                         "window: bring them nearer to each other",
                         seed->at[0], seed->at[1], seed->to[0], seed->to[1]);
    }
    lath->ended[1] = TAUT_END_SEED;
    memcpy(lath->ends[1], seed->to, sizeof seed->to);
    lath->is_longer = !way.is_shortest;
    snprintf(lath->name, sizeof lath->name, "G%d", ++net->of_family[0]);
    net->count++;
    return TAUT_OK;
}

static taut_status check_inside(const taut_net *net, const double at[2], int index,
                                const char *member, taut_error *error)
{
    for (int d = 0; d < 2; d++) {
        if (!(at[d] >= net->carrier->lo[d]) || !(at[d] <= net->carrier->hi[d])) {
            char where[48];
            snprintf(where, sizeof where, "/seeds/%d/%s/%d", index, member, d);
            return taut_fail(error, TAUT_BAD_INPUT, "outside", where, at[d],
                             at[d] < net->carrier->lo[d] ? net->carrier->lo[d]
                                                         : net->carrier->hi[d],
                             "found %s = %.17g, expected a number from %.17g to %.17g",
                             d == 0 ? "u" : "v", at[d], net->carrier->lo[d], net->carrier->hi[d]);
        }
    }
    return TAUT_OK;
}

static int goes_to(const taut_net *net, const taut_trace_seed *seed)
{
    return net->problem->net == TAUT_TRACE_GEODESIC && seed->kind == TAUT_TRACE_AT && seed->has_to;
}

static taut_status check_seed(const taut_net *net, const taut_trace_seed *seed, int index,
                              taut_error *error)
{
    const int has_at = seed->kind == TAUT_TRACE_AT || seed->kind == TAUT_TRACE_LINE || seed->has_at;
    taut_status status = TAUT_OK;
    if (has_at) {
        status = check_inside(net, seed->at, index, seed->kind == TAUT_TRACE_LINE ? "line/0" : "at",
                              error);
    }
    if (status == TAUT_OK && (seed->kind == TAUT_TRACE_LINE || goes_to(net, seed))) {
        status = check_inside(net, seed->to, index, seed->kind == TAUT_TRACE_LINE ? "line/1" : "to",
                              error);
    }
    return status;
}

/* The surface that a seed lies on: the one that it names, or the one of the problem. */
static taut_status choose_carrier(taut_net *net, const taut_trace_seed *seed, int index,
                                  const taut_carrier *usual, taut_error *error)
{
    char where[48];
    net->carrier = usual;
    for (int k = 0; seed->surface != NULL && k < net->carrier_count; k++) {
        if (strcmp(taut_surface_name(net->carriers[k]->surface), seed->surface) == 0) {
            net->carrier = net->carriers[k];
            return TAUT_OK;
        }
    }
    if (seed->surface == NULL) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/seeds/%d/surface", index);
    return taut_fail(error, TAUT_BAD_INPUT, "no-such-object", where, taut_none, taut_none,
                     "no surface that curves are traced on has the name \"%.60s\"", seed->surface);
}

static int families_of(const taut_trace_problem *problem, const taut_trace_seed *seed)
{
    int families = problem->net == TAUT_TRACE_GEODESIC ? 1 : 3;
    families &= problem->families != 0 ? problem->families : 3;
    return families & (seed->family != 0 ? seed->family : 3);
}

static taut_status trace_seed(taut_net *net, const taut_trace_seed *seed, int index,
                              taut_error *error)
{
    const int families = families_of(net->problem, seed);
    taut_status status = check_seed(net, seed, index, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (goes_to(net, seed)) {
        return seed_between(net, seed, index, error);
    }
    if (seed->kind == TAUT_TRACE_LATH) {
        return seed_lath(net, seed, index, error);
    }
    if (seed->kind == TAUT_TRACE_CELL || seed->kind == TAUT_TRACE_CELLS) {
        return seed_cells(net, seed, families, index, error);
    }
    for (int family = 0; status == TAUT_OK && family < 2; family++) {
        if (families & (1 << family)) {
            status = seed->kind == TAUT_TRACE_EDGE
                         ? seed_edge(net, seed, family, index, error)
                         : seed_line(net, seed, family, index, seed->at, seed->to, error);
        }
    }
    return status;
}

/* Of seed `first` and those that follow it, as many as are single places: *next is the one behind. */
static taut_status trace_places(taut_net *net, int first, const taut_carrier *home, int *next,
                                taut_error *error)
{
    const taut_trace_problem *problem = net->problem;
    const int is_geodesic = problem->net == TAUT_TRACE_GEODESIC;
    planned *list = new_list(net, 2 * (problem->seed_count - first));
    int count = 0, k = first;

    if (list == NULL) {
        return taut_fail_memory(error);
    }
    for (; k < problem->seed_count; k++) {
        const taut_trace_seed *seed = &problem->seeds[k];
        taut_error later = {.status = TAUT_OK};
        if (seed->kind != TAUT_TRACE_AT || goes_to(net, seed) ||
            choose_carrier(net, seed, k, home, &later) != TAUT_OK ||
            check_seed(net, seed, k, &later) != TAUT_OK) {
            break; /* what is wrong with it is said when it is its turn */
        }
        const int families = families_of(problem, seed);
        for (int family = 0; family < 2; family++) {
            if (families & (1 << family)) {
                list[count] = place_of(net->carrier, family, seed->at);
                list[count].direction = is_geodesic ? seed->direction : NULL;
                list[count].both = !is_geodesic || seed->both;
                list[count++].seed = k;
            }
        }
    }
    *next = k;
    return add_laths(net, list, count, error);
}

static taut_status find_nodes(taut_net *net, taut_error *error)
{
    net->nodes.arena = net->arena;
    return taut_nodes_find(net->problem->net, net->laths, net->count, &net->nodes) == TAUT_OK
               ? TAUT_OK
               : taut_fail_memory(error);
}

taut_status taut_net_trace(taut_net *net, const taut_monitor *monitor, taut_error *error)
{
    static const taut_trace_seed usual = {.kind = TAUT_TRACE_CELLS, .count = 8};
    const int count = net->problem->seed_count > 0 ? net->problem->seed_count : 1;
    const taut_carrier *home = net->carrier;
    taut_status status = TAUT_OK;

    net->left_out = taut_arena_take(net->arena, TAUT_TRACE_LATHS_MAX, sizeof *net->left_out);
    if (net->left_out == NULL) {
        return taut_fail_memory(error);
    }
    net->marks.arena = net->arena;
    net->options.follow.monitor = monitor;
    for (int k = 0; status == TAUT_OK && k < count; k++) {
        const taut_trace_seed *seed =
            net->problem->seed_count > 0 ? &net->problem->seeds[k] : &usual;
        int next = k;
        net->options.follow.done = (double)k / count;
        if (net->problem->seed_count > 0) {
            status = trace_places(net, k, home, &next, error);
        }
        if (next > k) {
            k = next - 1;
            continue;
        }
        status = choose_carrier(net, seed, k, home, error);
        if (status == TAUT_OK) {
            status = trace_seed(net, seed, k, error);
        }
    }
    net->carrier = home;
    if (status == TAUT_OK && net->count == 0) {
        const taut_linefield_fault fault =
            net->left_count > 0 ? net->left_out[0].fault : TAUT_LINEFIELD_SINGULAR;
        if (net->left_count > 0 && net->left_out[0].is_along) {
            return taut_fail(error, TAUT_NO_SOLUTION, "along", "/seeds", taut_none, taut_none,
                             "every curve runs along the line that seeds it");
        }
        const double nowhere[2] = {net->carrier->lo[0], net->carrier->lo[1]};
        return fault_of(net, -1, net->left_count > 0 ? net->left_out[0].at : nowhere, fault, error);
    }
    return status == TAUT_OK ? find_nodes(net, error) : status;
}
