#include "trace/follow.h"

#include "core/vec3.h"
#include "numeric/runge.h"
#include "trace/parabolic.h"
#include "trace/seam.h"
#include "trace/straight.h"

#include <string.h>

/* How many surfaces may meet at a corner that a curve passes. */
enum {
    CORNER = 8,
    EVENT_ROUNDS = 120,
    SHORT_STEPS = 1000, /* in a row, of the least length or little more: no way on */
    MANY_STEPS =
        4096 /* that together come no farther than `slow` of the size a step: none either */
};

static const struct {
    double first, largest, least; /* steps over the size */
    double slow;
    double turn;         /* least cosine between tangents within a step */
    double corner;       /* over the size: two borders at once */
    double closing;      /* over the size: the seed again */
    double crease;       /* angle of normals */
    double along;        /* over a range: it runs on a break */
    double entering;     /* sine: the way into a cell */
    double rounding;     /* over the size: of the place of an event */
    double near, nearer; /* over the size: a step of Newton, and the next one, in its last rounds */
    double measure; /* its error counts so much: near R = 0 and K = 0 estimates are too small */
    /* Where R is round, over its largest value, it may change by this factor in a step that is not the least. */
    double round, change, least_round;
    /* A step's error over its length at most, as beside an umbilic what moves a curve turns it; and over the size, what is
     * rounding. */
    double sideways, noise;
    double blind; /* over the size: from where the normal vanishes */
} limits = {.first = 1e-2,
            .largest = 0.1,
            .least = 1e-12,
            .slow = 1e-8,
            .turn = 0.5,
            .corner = 1e-9,
            .closing = 1e-9,
            .crease = 1e-9,
            .along = 1e-12,
            .entering = 1e-9,
            .rounding = 2e-16,
            .near = 1e-7,
            .nearer = 1e-14,
            .measure = 30,
            .round = 0.1,
            .change = 1.25,
            .least_round = 1e-8,
            .sideways = 3e-9,
            .noise = 1e-16,
            .blind = 1e-5};

/* What steps from one state begin with, as events step from it again and again. */
typedef struct launch {
    int is_known;
    taut_walk_state from;
    double x[TAUT_CARRIER_VECTORS][3]; /* up to first derivatives */
    double slope[TAUT_RUNGE_MAX];
} launch;

/* The system of a cell, and what went wrong last. */
typedef struct cell_field {
    const taut_carrier *carrier;
    taut_linefield_kind kind;
    int is_bare; /* u and v alone, not what is integrated along */
    const int *span;
    const double *tangent;
    taut_linefield_fault fault;
    launch launch;
} cell_field;

/* (a, b) of a state, going its way; 0 where there is none, or it turned. */
static int direction_at(cell_field *field, const double x[TAUT_CARRIER_VECTORS][3],
                        const taut_form_pair *forms, const double *y, double ab[2])
{
    double tangent[3];

    if (field->kind.net == TAUT_TRACE_GEODESIC) {
        ab[0] = y[TAUT_WALK_A];
        ab[1] = y[TAUT_WALK_B];
        const int has_normal = taut_linefield_has_normal(field->carrier, forms);
        field->fault = has_normal ? TAUT_LINEFIELD_FINE : TAUT_LINEFIELD_SINGULAR;
        return has_normal;
    }
    field->fault = taut_linefield_direction(field->carrier, field->kind, forms, ab);
    if (field->fault != TAUT_LINEFIELD_FINE) {
        return 0;
    }
    taut_linefield_tangent(x, ab, tangent);
    const double cosine = taut_dot(tangent, field->tangent);
    if (cosine < 0) {
        ab[0] = -ab[0];
        ab[1] = -ab[1];
    }
    return fabs(cosine) >= limits.turn;
}

/* *x: the derivatives there. */
static int slope_at(cell_field *field, const double *y, double x[TAUT_CARRIER_VECTORS][3],
                    double *out)
{
    double ab[2];
    taut_form_pair forms;

    taut_carrier_at(field->carrier, field->span, y, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    if (!direction_at(field, (const double(*)[3])x, &forms, y, ab)) {
        return 0;
    }
    out[TAUT_WALK_U] = ab[0];
    out[TAUT_WALK_V] = ab[1];
    if (field->is_bare && field->kind.net != TAUT_TRACE_GEODESIC) {
        return 1;
    }
    out[TAUT_WALK_TWIST] = fabs(taut_linefield_torsion(&forms, ab));
    out[TAUT_WALK_MEASURE] = taut_linefield_measure(field->kind.net, &forms);
    if (field->kind.net == TAUT_TRACE_GEODESIC) {
        return taut_linefield_bend(TAUT_TRACE_GEODESIC, (const double(*)[3])x, &forms, ab,
                                   out + TAUT_WALK_A);
    }
    return 1;
}

static int slope(void *context, const double *y, double *out)
{
    double x[TAUT_CARRIER_VECTORS][3];
    return slope_at(context, y, x, out);
}

static taut_runge system_of(cell_field *field)
{
    const int count = field->kind.net == TAUT_TRACE_GEODESIC ? TAUT_WALK_COUNT
                      : field->is_bare                       ? TAUT_WALK_TWIST
                                                             : TAUT_WALK_A;
    return (taut_runge){count, slope, field};
}

static int is_same(const taut_walk_state *a, const taut_walk_state *b)
{
    return a->on == b->on && memcmp(a->y, b->y, sizeof a->y) == 0 &&
           memcmp(a->span, b->span, sizeof a->span) == 0 &&
           memcmp(a->tangent, b->tangent, sizeof a->tangent) == 0;
}

/* What is known of steps from a state; NULL where there is no slope. */
static const launch *launch_of(cell_field *field, const taut_walk_state *from)
{
    launch *l = &field->launch;
    if (!l->is_known || !is_same(&l->from, from)) {
        l->from = *from;
        l->is_known = slope_at(field, from->y, l->x, l->slope);
    }
    return l->is_known ? l : NULL;
}

/* The tangent of a state from its direction; geodesics are made of unit speed again. */
static int renew_tangent(cell_field *field, taut_walk_state *state)
{
    double x[TAUT_CARRIER_VECTORS][3], ab[2], tangent[3] = {0, 0, 0};
    taut_form_pair forms;

    taut_carrier_at(field->carrier, state->span, state->y, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    if (!direction_at(field, (const double(*)[3])x, &forms, state->y, ab)) {
        return 0;
    }
    taut_linefield_tangent((const double(*)[3])x, ab, tangent);
    const double length = taut_length(tangent);
    for (int c = 0; c < 3; c++) {
        state->tangent[c] = tangent[c] / length;
    }
    if (field->kind.net == TAUT_TRACE_GEODESIC) {
        state->y[TAUT_WALK_A] = ab[0] / length;
        state->y[TAUT_WALK_B] = ab[1] / length;
    }
    return 1;
}

/* One step; *error: its estimate in space. 0 where a stage fails; field->fault says why. */
static int try_step(cell_field *field, const taut_walk_state *from, double h, taut_walk_state *to,
                    double *error)
{
    double errors[2][TAUT_RUNGE_MAX], norms[2];
    const taut_runge system = system_of(field);

    field->span = from->span;
    field->tangent = from->tangent;
    *to = *from;
    const launch *first = launch_of(field, from);
    if (first == NULL || !taut_runge_step(&system, from->y, first->slope, h, to->y, errors)) {
        return 0;
    }
    to->s = from->s + h;
    for (int e = 0; e < 2; e++) {
        double vector[3];
        taut_linefield_tangent((const double(*)[3])first->x, errors[e], vector);
        norms[e] = taut_length(vector);
        if (field->kind.net == TAUT_TRACE_GEODESIC) {
            taut_linefield_tangent((const double(*)[3])first->x, errors[e] + TAUT_WALK_A, vector);
            norms[e] += field->carrier->size * taut_length(vector);
        }
    }
    *error = taut_runge_error(norms[0], norms[1]);
    if (!field->is_bare &&
        (field->kind.net == TAUT_TRACE_ASYMPTOTIC || field->kind.net == TAUT_TRACE_PRINCIPAL)) {
        const double unit = sqrt(field->carrier->roundest);
        *error = fmax(*error, limits.measure / unit *
                                  taut_runge_error(fabs(errors[0][TAUT_WALK_MEASURE]),
                                                   fabs(errors[1][TAUT_WALK_MEASURE])));
    }
    return renew_tangent(field, to) && isfinite(*error);
}

int taut_walk_step(taut_linefield_kind kind, const taut_walk_state *from, double h,
                   taut_walk_state *to)
{
    const taut_carrier *carrier = from->on;
    cell_field field = {.carrier = carrier, .kind = kind};
    double error = 0;
    if (taut_straight_way(carrier, kind) != NULL) {
        taut_straight_move(carrier, kind, from, taut_straight_reach(carrier, kind, from, h), to);
        return isfinite(to->s);
    }
    return try_step(&field, from, h, to, &error);
}

/* A tangent of the surface in x_u and x_v. */
static void in_window(const double x[TAUT_CARRIER_VECTORS][3], const taut_form_pair *forms,
                      const double tangent[3], double ab[2])
{
    const double p = taut_dot(tangent, x[1]), r = taut_dot(tangent, x[2]);
    ab[0] = (forms->g * p - forms->f * r) / (forms->w * forms->w);
    ab[1] = (forms->e * r - forms->f * p) / (forms->w * forms->w);
}

taut_linefield_fault taut_walk_start(const taut_carrier *carrier, taut_linefield_kind kind,
                                     const double at[2], const int span[2], const double along[3],
                                     taut_walk_state *state)
{
    double x[TAUT_CARRIER_VECTORS][3], ab[2], tangent[3] = {0, 0, 0};
    taut_form_pair forms;

    *state = (taut_walk_state){.on = carrier, .y = {at[0], at[1]}, .span = {span[0], span[1]}};
    taut_carrier_at(carrier, span, at, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    if (kind.net == TAUT_TRACE_GEODESIC) {
        if (!(forms.w > 0)) {
            return TAUT_LINEFIELD_SINGULAR;
        }
        memcpy(tangent, along, sizeof tangent);
        const double rest = taut_dot(tangent, forms.normal);
        taut_add_scaled(-rest, forms.normal, tangent);
        in_window((const double(*)[3])x, &forms, tangent, ab);
    } else {
        const taut_linefield_fault fault = taut_linefield_direction(carrier, kind, &forms, ab);
        if (fault != TAUT_LINEFIELD_FINE) {
            return fault;
        }
    }
    taut_linefield_tangent((const double(*)[3])x, ab, tangent);
    const double length = taut_length(tangent), sign = taut_dot(tangent, along) < 0 ? -1 : 1;
    for (int c = 0; c < 3; c++) {
        state->tangent[c] = sign * tangent[c] / length;
    }
    state->y[TAUT_WALK_A] = sign * ab[0] / length;
    state->y[TAUT_WALK_B] = sign * ab[1] / length;
    return TAUT_LINEFIELD_FINE;
}

void taut_walk_enter(taut_linefield_kind kind, int d, int up, taut_walk_state *state)
{
    double x[TAUT_CARRIER_VECTORS][3];
    taut_carrier_at(state->on, state->span, state->y, 1, x);
    const double in = (up ? 1 : -1) * state->y[TAUT_WALK_A + d] * taut_length(x[1 + d]);

    if (kind.net == TAUT_TRACE_GEODESIC || !(in < -limits.entering)) {
        return;
    }
    for (int c = 0; c < 3; c++) {
        state->tangent[c] = -state->tangent[c];
    }
    state->y[TAUT_WALK_A] = -state->y[TAUT_WALK_A];
    state->y[TAUT_WALK_B] = -state->y[TAUT_WALK_B];
}

int taut_walk_station(taut_linefield_kind kind, const taut_walk_state *state, taut_station *at)
{
    const taut_carrier *carrier = state->on;
    double x[TAUT_CARRIER_VECTORS][3], sideways[3];
    taut_form_pair forms;

    *at = (taut_station){.on = carrier,
                         .s = state->s,
                         .at = {state->y[TAUT_WALK_U], state->y[TAUT_WALK_V]},
                         .twist = state->y[TAUT_WALK_TWIST],
                         .measure = state->y[TAUT_WALK_MEASURE]};
    taut_carrier_at(carrier, state->span, state->y, 3, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    memcpy(at->x, x[0], sizeof at->x);
    memcpy(at->tangent, state->tangent, sizeof at->tangent);
    memcpy(at->normal, forms.normal, sizeof at->normal);
    if (!(forms.w > 0)) {
        return 0;
    }
    in_window((const double(*)[3])x, &forms, at->tangent, at->ab);
    at->k_n = taut_linefield_normal_curvature(&forms, at->ab);
    at->tau_g = taut_linefield_torsion(&forms, at->ab);
    const double *way = taut_straight_way(carrier, kind);
    if (way != NULL) {
        taut_straight_station(way, (const double(*)[3])x, at);
    } else if (!taut_linefield_bend(kind.net, (const double(*)[3])x, &forms, at->ab, at->bend)) {
        at->bend[0] = at->bend[1] = 0;
        return 0;
    }
    taut_linefield_acceleration((const double(*)[3])x, at->ab, at->bend, at->acceleration);
    taut_cross(forms.normal, at->tangent, sideways);
    at->k_g = taut_dot(at->acceleration, sideways);
    return 1;
}

const char *taut_walk_end_word(taut_walk_end end)
{
    static const char *const words[] = {"none",   "edge",    "corner",  "parabolic", "envelope",
                                        "flat",   "umbilic", "closed",  "crease",    "singular",
                                        "length", "seed",    "stalled", "sink"};
    return words[end];
}

/* ---- a curve ---- */

typedef struct follower {
    const taut_carrier *carrier;
    taut_linefield_kind kind;
    const taut_follow_options *options;
    taut_walk *walk;
    cell_field field;
    taut_walk_state state;
    taut_walk_state last; /* whose station is the last one */
    double h;
    double seed_x[3], seed_tangent[3];
    int short_steps; /* the last ones */
    int steps;       /* since the curve was at `milestone` */
    double milestone;
} follower;

static void end_at(follower *f, taut_walk_end end, const taut_walk_state *state)
{
    if (f->walk->end == TAUT_END_SINK) { /* whatever is there too */
        return;
    }
    f->walk->end = end;
    f->walk->end_at[0] = state->y[TAUT_WALK_U];
    f->walk->end_at[1] = state->y[TAUT_WALK_V];
    f->walk->end_on = state->on;
}

static taut_status add_piece(follower *f, const taut_walk_state *to, int near_parabolic)
{
    taut_walk *walk = f->walk;
    if (walk->count == walk->room) {
        const int room = walk->room > 0 ? 2 * walk->room : 32;
        taut_piece *pieces = taut_arena_take_raw(walk->arena, (size_t)room, sizeof *pieces);
        if (pieces == NULL) {
            return TAUT_NO_MEMORY;
        }
        if (walk->count > 0) {
            memcpy(pieces, walk->pieces, (size_t)walk->count * sizeof *pieces);
        }
        walk->pieces = pieces;
        walk->room = room;
    }
    const taut_piece *before = walk->count > 0 ? &walk->pieces[walk->count - 1] : NULL;
    taut_piece *piece = &walk->pieces[walk->count++];
    *piece =
        (taut_piece){.start = f->state, .h = to->s - f->state.s, .near_parabolic = near_parabolic};
    if (f->options->is_bare) {
        return TAUT_OK;
    }
    if (before != NULL && is_same(&f->last, &f->state)) {
        piece->from = before->to;
    } else {
        taut_walk_station(f->kind, &f->state, &piece->from);
    }
    taut_walk_station(f->kind, to, &piece->to);
    f->last = *to;
    if (f->options->sink != NULL && walk->end != TAUT_END_SINK &&
        f->options->sink(f->options->context, piece)) {
        end_at(f, TAUT_END_SINK, to);
    }
    return TAUT_OK;
}

/* What an event is told by: a coordinate that meets a break, or the plane through the seed. */
typedef struct event {
    int d; /* 0, 1; 2: the plane */
    double border;
    double h;
    taut_walk_state at;
    int is_cut; /* steps fail before it, as where a pole is: h is the longest that does not */
    taut_linefield_fault fault; /* why */
} event;

static double event_value(const follower *f, const event *e, const taut_walk_state *state,
                          double *rate)
{
    double x[TAUT_CARRIER_VECTORS][3], away[3];
    taut_carrier_at(f->carrier, state->span, state->y, 1, x);
    if (e->d < 2) {
        const double uu = taut_dot(x[1], x[1]), uv = taut_dot(x[1], x[2]),
                     vv = taut_dot(x[2], x[2]);
        const double p = taut_dot(state->tangent, x[1]), r = taut_dot(state->tangent, x[2]);
        const double area = uu * vv - uv * uv;
        *rate = e->d == 0 ? (vv * p - uv * r) / area : (uu * r - uv * p) / area;
        return state->y[e->d] - e->border;
    }
    taut_difference(x[0], f->seed_x, away);
    *rate = taut_dot(state->tangent, f->seed_tangent);
    return taut_dot(away, f->seed_tangent);
}

/* Where in [0, h] the cubic through two values and their rates vanishes: a first guess. */
static double guess_event(const double value[2], const double rate[2], double h)
{
    const double a = h * rate[0], b = h * rate[1], rise = value[1] - value[0];
    double low = 0, high = 1, t = value[0] / -rise;

    for (int round = 0; round < 8; round++) {
        const double p = 3 * rise - 2 * a - b, q = a + b - 2 * rise;
        const double here = value[0] + t * (a + t * (p + t * q));
        const double slope = a + t * (2 * p + 3 * t * q);
        *((here > 0) == (value[1] > 0) ? &high : &low) = t;
        t -= here / slope;
        if (!(t > low) || !(t < high)) {
            t = (low + high) / 2;
        }
    }
    return h * t;
}

/* The length of the step at which the event happens, by Newton between 0 and h, each a full step; where steps fail before
 * it, the longest that does not. */
static void solve_event(follower *f, double h, const taut_walk_state *end, event *e)
{
    const double size = f->carrier->size;
    double low = 0, high = h, rates[2], values[2];
    taut_walk_state state = *end, before = f->state;

    values[0] = event_value(f, e, &f->state, &rates[0]);
    values[1] = event_value(f, e, end, &rates[1]);
    double value = values[1], rate = rates[1];
    const double side = value > 0 ? 1 : -1;
    double next =
        value != 0 && values[0] * side < 0 ? guess_event(values, rates, h) : h - value / rate;

    e->h = h;
    e->is_cut = 0;
    for (int round = 0; round < EVENT_ROUNDS && value != 0; round++) {
        double error = 0;
        if (high - low <= limits.rounding * size) {
            break;
        }
        if (!(next > low) || !(next < high)) {
            next = (low + high) / 2;
        }
        const double moved = fabs(next - e->h);
        if (!try_step(&f->field, &f->state, next, &state, &error)) {
            e->is_cut = 1;
            e->fault = f->field.fault;
            e->h = low;
            state = before;
            high = next;
            next = low;
            continue;
        }
        e->h = next;
        value = event_value(f, e, &state, &rate);
        if (value * side > 0) {
            high = next;
            e->is_cut = 0;
        } else {
            low = next;
            before = state;
        }
        next -= value / rate;
        /* Newton's last step was so small that the next one is rounding */
        const int is_settled =
            moved <= limits.near * size && fabs(next - e->h) <= limits.nearer * size;
        e->is_cut = e->is_cut && !is_settled && value != 0;
        if (is_settled || moved <= limits.rounding * size) {
            break;
        }
    }
    e->at = state;
}

/* The first border of the cell that a step ends beyond by more than `room` of the window; 0 where none. */
static int border_before(follower *f, double h, const taut_walk_state *end, double room,
                         event *first)
{
    int found = 0;
    for (int d = 0; d < 2; d++) {
        const double *breaks = taut_basis_breaks(f->carrier->basis[d]) + f->state.span[d];
        const double over = room * (f->carrier->hi[d] - f->carrier->lo[d]);
        event e = {.d = d, .border = end->y[d] < breaks[0] ? breaks[0] : breaks[1]};
        if (end->y[d] >= breaks[0] - over && end->y[d] <= breaks[1] + over) {
            continue;
        }
        solve_event(f, h, end, &e);
        if (!found || e.h < first->h) {
            e.at.y[d] = e.is_cut ? e.at.y[d] : e.border;
            *first = e;
            found = 1;
        }
    }
    return found;
}

/* The first border of the cell that the step crosses; 0 where none. It may have come back over another one, which is the
 * first then. */
static int first_border(follower *f, double h, const taut_walk_state *end, event *first)
{
    event before;
    if (!border_before(f, h, end, 0, first)) {
        return 0;
    }
    if (border_before(f, first->h, &first->at, limits.along, &before) && before.h < first->h) {
        *first = before;
    }
    return 1;
}

/* A curve that ran on a break stays there: rounding does not count. */
static void hold_on_breaks(const follower *f, taut_walk_state *end)
{
    for (int d = 0; d < 2; d++) {
        const double *breaks = taut_basis_breaks(f->carrier->basis[d]) + f->state.span[d];
        const double room = limits.along * (f->carrier->hi[d] - f->carrier->lo[d]);
        for (int k = 0; k < 2; k++) {
            if (f->state.y[d] == breaks[k] && fabs(end->y[d] - breaks[k]) <= room) {
                end->y[d] = breaks[k];
            }
        }
    }
}

/* Is the other coordinate at a border of the window too? Then it is set to it. */
static int meets_corner(const taut_carrier *carrier, int d, taut_walk_state *state, int *edge)
{
    double x[TAUT_CARRIER_VECTORS][3];
    const int other = 1 - d;
    int found = 0;

    taut_carrier_at(carrier, state->span, state->y, 1, x);
    const double speed = taut_length(x[1 + other]);
    for (int k = 0; k < 2; k++) {
        const double border = k == 0 ? carrier->lo[other] : carrier->hi[other];
        if (fabs(state->y[other] - border) * speed <= limits.corner * carrier->size) {
            state->y[other] = border;
            *edge = 2 * other + k;
            found = 1;
        }
    }
    return found;
}

/* Ends on the window's border d at its low (0) or high (1) side; a corner where the other one is met
 * too. */
static void end_on_border(follower *f, int d, int side, taut_walk_state *state)
{
    f->walk->edges[0] = 2 * d + side;
    meets_corner(f->carrier, d, state, &f->walk->edges[1]);
    end_at(f, f->walk->edges[1] >= 0 ? TAUT_END_CORNER : TAUT_END_EDGE, state);
}

/* A corner of the curve at a place: the angle between the tangents before and behind it. */
static void add_kink(follower *f, const taut_walk_state *state, const double before[3],
                     const double behind[3])
{
    double across[3];
    taut_cross(before, behind, across);
    const double angle = taut_atan2(taut_length(across), taut_dot(before, behind));
    if (angle > TAUT_LEAST_KINK && f->walk->kink_count < TAUT_KINKS_MAX) {
        f->walk->kinks[f->walk->kink_count++] =
            (taut_kink){state->on, {state->y[TAUT_WALK_U], state->y[TAUT_WALK_V]}, angle};
    }
}

int taut_walk_carry(taut_linefield_kind kind, taut_walk_state *state)
{
    const double before[3] = {state->tangent[0], state->tangent[1], state->tangent[2]};
    double x[TAUT_CARRIER_VECTORS][3];
    taut_form_pair forms;
    taut_walk_state now = *state;

    taut_carrier_at(now.on, now.span, now.y, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    in_window((const double(*)[3])x, &forms, before, now.y + TAUT_WALK_A);
    for (int turns = 0; turns < 2 * CORNER; turns++) {
        const int edge = taut_seam_out(now.on, now.y, now.y + TAUT_WALK_A);
        taut_walk_state next;
        double at[2];
        int span[2];
        if (edge < 0) {
            memcpy(now.y + TAUT_WALK_TWIST, state->y + TAUT_WALK_TWIST, 2 * sizeof(double));
            now.s = state->s;
            *state = now;
            return turns > 0;
        }
        const taut_carrier *to = taut_seam_cross(now.on, edge, now.y, at);
        if (to == NULL) {
            return 0;
        }
        taut_carrier_cell(to, at, NULL, span);
        if (taut_walk_start(to, kind, at, span, before, &next) != TAUT_LINEFIELD_FINE) {
            return 0;
        }
        taut_carrier_cell(to, at, next.y + TAUT_WALK_A, span);
        if (taut_walk_start(to, kind, at, span, before, &now) != TAUT_LINEFIELD_FINE) {
            return 0;
        }
    }
    return 0;
}

/* Onto the surface that joins at side `up` of direction d; 0 where the curve ends there. */
static int cross_seam(follower *f, int d, int up, taut_walk_state *state)
{
    const taut_walk_state before = *state;
    int corner = -1;

    if (f->carrier->seams[2 * d + up] != NULL && f->kind.net != TAUT_TRACE_ISOPARAMETRIC) {
        meets_corner(f->carrier, d, state, &corner);
        if (taut_walk_carry(f->kind, state)) {
            add_kink(f, &before, before.tangent, state->tangent);
            f->carrier = f->field.carrier = state->on;
            return 1;
        }
        *state = before;
    }
    end_on_border(f, d, up, state);
    return 0;
}

/* Into the neighbour across the border of direction d; 0 where the curve ends there. */
static int cross_border(follower *f, int d, taut_walk_state *state)
{
    const double *breaks = taut_basis_breaks(f->carrier->basis[d]);
    const int spans = taut_basis_span_count(f->carrier->basis[d]);
    const int up = state->y[d] == breaks[state->span[d] + 1];
    double x[2][TAUT_CARRIER_VECTORS][3], before[3];
    taut_form_pair forms[2];
    taut_walk_state next = *state;

    next.span[d] += up ? 1 : -1;
    if (next.span[d] < 0 || next.span[d] >= spans) {
        if (!f->carrier->wraps[d]) {
            return cross_seam(f, d, up, state);
        }
        next.span[d] = up ? 0 : spans - 1;
        next.y[d] = up ? f->carrier->lo[d] : f->carrier->hi[d];
    }
    taut_carrier_at(f->carrier, state->span, state->y, 2, x[0]);
    taut_carrier_at(f->carrier, next.span, next.y, 2, x[1]);
    for (int k = 0; k < 2; k++) {
        taut_carrier_forms((const double(*)[3])x[k], &forms[k]);
    }
    if (!(taut_length_between(forms[0].normal, forms[1].normal) <= limits.crease)) {
        end_at(f, TAUT_END_CREASE, state);
        return 0;
    }
    memcpy(before, state->tangent, sizeof before);
    if (taut_walk_start(f->carrier, f->kind, next.y, next.span, before, &next) !=
        TAUT_LINEFIELD_FINE) {
        end_at(f, TAUT_END_CREASE, state);
        return 0;
    }
    memcpy(next.y + TAUT_WALK_TWIST, state->y + TAUT_WALK_TWIST, 2 * sizeof(double));
    next.s = state->s;
    taut_walk_enter(f->kind, d, up, &next);
    add_kink(f, state, before, next.tangent);
    *state = next;
    return 1;
}

/* Beside a place without a normal that is rounding, and so are bends. */
static void blind_before(follower *f)
{
    taut_walk *walk = f->walk;
    const double room = limits.blind * f->carrier->size;
    for (int k = walk->count - 1; k >= 0 && !f->options->is_bare; k--) {
        taut_piece *piece = &walk->pieces[k];
        const double rest = f->state.s - piece->from.s;
        piece->to.blind = room - (f->state.s - piece->to.s);
        if (!(rest < room)) {
            break;
        }
        piece->from.blind = room - rest;
    }
}

/* What a fault means where the step has become nothing. */
static void end_by_fault(follower *f)
{
    taut_walk_end end = TAUT_END_STALLED;
    if (f->field.fault == TAUT_LINEFIELD_ELLIPTIC) {
        end = TAUT_END_PARABOLIC;
    } else if (f->field.fault == TAUT_LINEFIELD_SINGULAR) {
        end = TAUT_END_SINGULAR;
        blind_before(f);
    } else if (f->field.fault == TAUT_LINEFIELD_ROUND) {
        double x[TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms;
        taut_carrier_at(f->carrier, f->state.span, f->state.y, 2, x);
        taut_carrier_forms((const double(*)[3])x, &forms);
        end = fabs(taut_form_pair_mean(&forms)) <= 1e-6 * f->carrier->roundest ? TAUT_END_FLAT
                                                                               : TAUT_END_UMBILIC;
    }
    end_at(f, end, &f->state);
}

/* Does a step beside an umbilic come nearer to it by so much, or away from it, that it may err by more than it
 * estimates? The field turns within the distance from there, which R is proportional to. */
static int is_too_long(const follower *f, const taut_walk_state *end)
{
    double radius[2];
    if (f->kind.net != TAUT_TRACE_PRINCIPAL) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        const taut_walk_state *at = k == 0 ? &f->state : end;
        double x[TAUT_CARRIER_VECTORS][3];
        taut_form_pair forms;
        taut_carrier_at(f->carrier, at->span, at->y, 2, x);
        taut_carrier_forms((const double(*)[3])x, &forms);
        radius[k] = taut_form_pair_radius(&forms);
    }
    const double least = fmin(radius[0], radius[1]), most = fmax(radius[0], radius[1]);
    return least < limits.round * f->carrier->roundest && most > limits.change * least;
}

/* A step that is small enough; 0 where the curve ends. */
static int next_step(follower *f, taut_walk_state *end, double *step)
{
    const double size = f->carrier->size, tolerance = f->options->tolerance * size;

    f->h = fmin(f->h, limits.largest * size);
    for (;;) {
        const double rest = f->options->max_length - fabs(f->state.s);
        double error = 0;
        *step = fmin(f->h, rest);
        const double room = fmin(tolerance, fmax(limits.sideways * *step, limits.noise * size));
        if (!try_step(&f->field, &f->state, *step, end, &error)) {
            f->h = *step / 4;
        } else if (is_too_long(f, end) && *step > limits.least_round * size) {
            f->h = *step / 2;
        } else if (error > room) {
            f->h = *step * fmax(0.2, 0.9 * sqrt(sqrt(sqrt(room / error))));
        } else {
            const double grow = error > 0 ? 0.9 * sqrt(sqrt(sqrt(room / error))) : 5;
            f->h = fmax(f->h, *step * fmin(5, fmax(0.2, grow)));
            f->walk->drift += error;
            return 1;
        }
        if (f->h < limits.least * size) {
            end_by_fault(f);
            return 0;
        }
    }
}

/* The derivative at the last of some places of what is given there, by Lagrange's polynomial. */
static double last_slope(int count, const double *s, const double *value)
{
    double sum = 0;
    for (int j = 0; j < count; j++) {
        double weight = 0;
        for (int m = 0; m < count; m++) {
            if (m == j) {
                continue;
            }
            double product = 1 / (s[j] - s[m]);
            for (int k = 0; k < count; k++) {
                product *= k == j || k == m ? 1 : (s[count - 1] - s[k]) / (s[j] - s[k]);
            }
            weight += product;
        }
        sum += weight * value[j];
    }
    return sum;
}

/* Where K = 0 the bend is 0 / 0, and at a cusp infinite. An envelope's is that of the polynomial
 * through the last tangents; a cusp's last piece is too short to matter. */
static void bend_at_end(taut_walk *walk, int is_envelope)
{
    enum { LAST = 6 };
    taut_station *end = &walk->pieces[walk->count - 1].to;
    const taut_station *before = &walk->pieces[walk->count - 1].from;
    double s[LAST], value[LAST];

    memcpy(end->acceleration, before->acceleration, sizeof end->acceleration);
    memcpy(end->bend, before->bend, sizeof end->bend);
    end->k_g = before->k_g;
    if (!is_envelope || walk->count < LAST) {
        return;
    }
    for (int c = 0; c < 5; c++) {
        for (int k = 0; k < LAST; k++) {
            const taut_station *at = &walk->pieces[walk->count - LAST + k].to;
            s[k] = at->s;
            value[k] = c < 3 ? at->tangent[c] : at->ab[c - 3];
        }
        *(c < 3 ? &end->acceleration[c] : &end->bend[c - 3]) = last_slope(LAST, s, value);
    }
}

static taut_status finish_parabolic(follower *f, int *done)
{
    taut_parabolic found;
    taut_status status = TAUT_OK;

    taut_parabolic_finish(f->carrier, f->kind, &f->state, &found);
    *done = found.count > 0;
    for (int k = 0; status == TAUT_OK && k < found.count; k++) {
        status = add_piece(f, &found.states[k], 1);
        f->state = found.states[k];
    }
    if (*done && status == TAUT_OK) {
        if (!f->options->is_bare) {
            bend_at_end(f->walk, found.is_envelope);
        }
        end_at(f, found.is_envelope ? TAUT_END_ENVELOPE : TAUT_END_PARABOLIC, &f->state);
    }
    return status;
}

/* Does the step pass the seed again? Then *end is there. */
static int closes(follower *f, double step, taut_walk_state *end)
{
    event e = {.d = 2};
    double rate = 0, x[TAUT_CARRIER_VECTORS][3];

    if (!(f->state.s > 2 * limits.first * f->carrier->size * 1e-3) ||
        !(event_value(f, &e, &f->state, &rate) < 0) || !(event_value(f, &e, end, &rate) >= 0) ||
        !(rate > 0)) {
        return 0;
    }
    taut_carrier_at(f->carrier, end->span, end->y, 0, x);
    if (taut_length_between(x[0], f->seed_x) > 2 * step) {
        return 0;
    }
    solve_event(f, step, end, &e);
    taut_carrier_at(f->carrier, e.at.span, e.at.y, 0, x);
    if (!(taut_length_between(x[0], f->seed_x) <= limits.closing * f->carrier->size)) {
        return 0;
    }
    *end = e.at;
    return 1;
}

/* Is a place on the border the seed again? Behind a seam the curve would only begin anew there. */
static int is_back(const follower *f, const taut_walk_state *end)
{
    double x[TAUT_CARRIER_VECTORS][3];

    taut_carrier_at(f->carrier, end->span, end->y, 0, x);
    return end->s > 2 * limits.first * f->carrier->size * 1e-3 &&
           taut_dot(end->tangent, f->seed_tangent) > 0 &&
           taut_length_between(x[0], f->seed_x) <= limits.closing * f->carrier->size;
}

/* Where a straight line leaves the cell: how far along it, and across which break. */
static double leave_cell(const follower *f, const double *way, double sign, int *d, double *border)
{
    double least = INFINITY;
    for (int k = 0; k < 2; k++) {
        const double *breaks = taut_basis_breaks(f->carrier->basis[k]) + f->state.span[k];
        const double there = sign * way[k] > 0 ? breaks[1] : breaks[0];
        const double t = way[k] != 0 ? (there - f->state.y[k]) / way[k] : INFINITY;
        if (way[k] != 0 && fabs(t) < fabs(least)) {
            least = sign * fmax(sign * t, 0);
            *d = k;
            *border = there;
        }
    }
    return least;
}

/* One cell of a straight line, in steps no longer than the largest. */
static taut_status advance_straight(follower *f, const double *way)
{
    double x[TAUT_CARRIER_VECTORS][3], along[3], border = 0;
    taut_walk_state end;
    taut_status status = TAUT_OK;
    int d = 0;

    taut_carrier_at(f->carrier, f->state.span, f->state.y, 1, x);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    const double sign = taut_dot(along, f->state.tangent) < 0 ? -1 : 1;
    const double whole = leave_cell(f, way, sign, &d, &border);
    taut_straight_move(f->carrier, f->kind, &f->state, whole, &end);
    const double length = end.s - f->state.s, rest = f->options->max_length - f->state.s;
    const int is_last = length >= rest;
    const double t = is_last ? taut_straight_reach(f->carrier, f->kind, &f->state, rest) : whole;
    const double parts = ceil(fmin(length, rest) / (limits.largest * f->carrier->size));
    const taut_walk_state from = f->state;

    for (double part = 1; status == TAUT_OK && part <= parts; part++) {
        const double before = (part - 1) / parts * t, after = part < parts ? part / parts * t : t;
        taut_straight_move(f->carrier, f->kind, &f->state, after - before, &end);
        end.y[TAUT_WALK_U] = from.y[TAUT_WALK_U] + after * way[0];
        end.y[TAUT_WALK_V] = from.y[TAUT_WALK_V] + after * way[1];
        if (part == parts && !is_last) {
            end.y[d] = border;
        }
        if (end.s - f->state.s > limits.least * f->carrier->size) {
            status = add_piece(f, &end, 0);
        }
        f->state = end;
    }
    if (parts < 1) { /* it begins on the border */
        f->state.y[d] = border;
    }
    if (status == TAUT_OK && is_last) {
        end_at(f, TAUT_END_LENGTH, &f->state);
    } else if (status == TAUT_OK) {
        cross_border(f, d, &f->state);
    }
    return status;
}

/* Do steps lead nowhere? */
static int creeps(follower *f, double step)
{
    const double size = f->carrier->size;
    int is_slow = 0;

    f->short_steps = step < 4 * limits.least * size ? f->short_steps + 1 : 0;
    if (++f->steps == MANY_STEPS) {
        is_slow = f->state.s - f->milestone < MANY_STEPS * limits.slow * size;
        f->milestone = f->state.s;
        f->steps = 0;
    }
    return is_slow || f->short_steps > SHORT_STEPS;
}

/* One step and what comes of it; f->walk->end says whether it was the last. */
static taut_status advance(follower *f)
{
    taut_walk_state end;
    event border = {.d = 0};
    double step = 0;
    taut_status status = TAUT_OK;

    if (f->kind.net == TAUT_TRACE_ASYMPTOTIC) {
        int done = 0;
        status = finish_parabolic(f, &done);
        if (status != TAUT_OK || done) {
            return status;
        }
    }
    if (!next_step(f, &end, &step)) {
        return TAUT_OK;
    }
    hold_on_breaks(f, &end);
    const int crosses = first_border(f, step, &end, &border);
    if (crosses) {
        end = border.at;
        step = border.h;
        hold_on_breaks(f, &end);
    }
    const int closed = closes(f, step, &end) || (crosses && is_back(f, &end));
    if (end.s - f->state.s > limits.least * f->carrier->size) {
        status = add_piece(f, &end, 0);
    }
    if (status != TAUT_OK) {
        return status;
    }
    f->state = end;
    const int creeping = creeps(f, step);
    if (closed) {
        end_at(f, TAUT_END_CLOSED, &end);
    } else if (crosses && border.is_cut && border.fault != TAUT_LINEFIELD_FINE) {
        f->field.fault = border.fault;
        end_by_fault(f);
    } else if (crosses && !border.is_cut) {
        cross_border(f, border.d, &f->state);
    } else if (end.s >= f->options->max_length) {
        end_at(f, TAUT_END_LENGTH, &end);
    } else if (creeping) {
        end_at(f, TAUT_END_STALLED, &end);
    }
    return TAUT_OK;
}

static int is_stopped(const taut_follow_options *options)
{
    const taut_monitor *monitor = options->monitor;
    return monitor != NULL && monitor->progress != NULL &&
           monitor->progress(monitor->context, options->done, "tracing") != TAUT_GO_ON;
}

taut_status taut_follow(taut_linefield_kind kind, const taut_walk_state *start,
                        const taut_follow_options *options, taut_arena *arena, taut_walk *walk)
{
    const taut_carrier *carrier = start->on;
    follower f = {.carrier = carrier,
                  .kind = kind,
                  .options = options,
                  .walk = walk,
                  .field = {.carrier = carrier, .kind = kind, .is_bare = options->is_bare},
                  .state = *start,
                  .h = limits.first * carrier->size};
    double x[TAUT_CARRIER_VECTORS][3];
    taut_status status = TAUT_OK;

    *walk = (taut_walk){.arena = arena, .edges = {-1, -1}};
    taut_carrier_at(carrier, start->span, start->y, 0, x);
    memcpy(f.seed_x, x[0], sizeof f.seed_x);
    memcpy(f.seed_tangent, start->tangent, sizeof f.seed_tangent);
    while (status == TAUT_OK && walk->end == TAUT_END_NONE) {
        const double *way = taut_straight_way(f.carrier, kind);
        status = is_stopped(options) ? TAUT_INTERRUPTED
                 : way != NULL       ? advance_straight(&f, way)
                                     : advance(&f);
    }
    walk->last = f.state;
    return status;
}
