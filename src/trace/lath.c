#include "trace/lath.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "trace/straight.h"

#include <string.h>

enum { DEPTH = 8 /* halvings of a piece */, PLACES = 3, LOOKS = 8 };
/* Of geodesics k_g times the size is to be so much less than the residual, as it is summed up. */
static const double geodesic_share = 5;
/* Pieces shorter than this, over the size, are as good as doubles let them be: the rounding of points turns tangents
 * by 2e-16 over it, below what a net is off at most, and bends geodesics by 2e-16 over its square. Beside an umbilic
 * a curve turns within its distance from it, so that pieces of the nets have to be as short. */
static const double short_enough = 5e-9, short_geodesic = 1e-4;
/* And how far the speed of any quintic may be from 1. */
static const double uneven = 1e-9;
/* Of points, over the size. */
static const double rounding = 1e-15;
/* A piece as short that turns is looked at again: what its quintic may be off the net. And how near to where the net ends, over
 * the size, nobody asks. */
static const double does_turn = 0.02, most_off = 1e-6, at_end = 1e-3;
/* Below this angle with a border (sine), a curve that starts on it runs along it. */
static const double along_border = 1e-9;
/* Pieces shorter than this, over the size, become part of their neighbour; and those in another cell. */
static const double shortest = 2e-9, short_beside = 1e-7;
/* Over the size: ends of two ways to go that are one. */
static const double one_end = 1e-12;
/* A corner that need not be told. */
static const double no_corner = 9.5e-7;
/* Over the window's side: a corner of a curve that is its end. */
static const double same_end = 1e-9;

/* ---- quintics ---- */

static void quintic(int dim, double h, const double *x0, const double *v0, const double *a0,
                    const double *x1, const double *v1, const double *a1, double *points)
{
    for (int c = 0; c < dim; c++) {
        points[c] = x0[c];
        points[dim + c] = x0[c] + h / 5 * v0[c];
        points[2 * dim + c] = x0[c] + 2 * h / 5 * v0[c] + h * h / 20 * a0[c];
        points[3 * dim + c] = x1[c] - 2 * h / 5 * v1[c] + h * h / 20 * a1[c];
        points[4 * dim + c] = x1[c] - h / 5 * v1[c];
        points[5 * dim + c] = x1[c];
    }
}

static void space_between(const taut_station *from, const taut_station *to,
                          double points[TAUT_QUINTIC][3])
{
    quintic(3, to->s - from->s, from->x, from->tangent, from->acceleration, to->x, to->tangent,
            to->acceleration, points[0]);
}

static void window_between(const taut_station *from, const taut_station *to,
                           double points[TAUT_QUINTIC][2])
{
    quintic(2, to->s - from->s, from->at, from->ab, from->bend, to->at, to->ab, to->bend,
            points[0]);
}

void taut_segment_space(const taut_segment *segment, double points[TAUT_QUINTIC][3])
{
    space_between(&segment->from, &segment->to, points);
}

void taut_segment_window(const taut_segment *segment, double points[TAUT_QUINTIC][2])
{
    window_between(&segment->from, &segment->to, points);
}

void taut_quintic_at(int dim, const double *points, double t, double *value, double *step,
                     double *bend)
{
    double work[TAUT_QUINTIC * 3];
    memcpy(work, points, (size_t)(TAUT_QUINTIC * dim) * sizeof(double));
    for (int level = TAUT_QUINTIC - 1; level > 0; level--) {
        for (int c = 0; c < dim && level == 2; c++) {
            bend[c] = work[2 * dim + c] - 2 * work[dim + c] + work[c];
        }
        for (int c = 0; c < dim && level == 1; c++) {
            step[c] = work[dim + c] - work[c];
        }
        for (int k = 0; k < level * dim; k++) {
            work[k] += t * (work[k + dim] - work[k]);
        }
    }
    memcpy(value, work, (size_t)dim * sizeof(double));
}

/* A jump of the parameters over the window's width is a seam. */
static const double seam = 0.5;

int taut_station_passes_seam(const taut_station *a, const taut_station *b)
{
    const taut_carrier *carrier = a->on;
    for (int d = 0; a->on == b->on && d < 2; d++) {
        if (fabs(a->at[d] - b->at[d]) > seam * (carrier->hi[d] - carrier->lo[d])) {
            return 1;
        }
    }
    return a->on != b->on;
}

/* ---- pieces that are good enough ---- */

/* How far the quintic at t is from the surface, what its own tangent says of the net, and its speed. */
static void judge(taut_linefield_kind kind, const taut_piece *piece, double t, double *distance,
                  double *residual, double *speed)
{
    const taut_carrier *carrier = piece->start.on;
    double space[TAUT_QUINTIC][3], window[TAUT_QUINTIC][2], at[2], ab[2], x[3], tangent[3];
    double second[3], sideways[3];
    double on[TAUT_CARRIER_VECTORS][3];
    taut_form_pair forms;

    space_between(&piece->from, &piece->to, space);
    window_between(&piece->from, &piece->to, window);
    taut_quintic_at(2, window[0], t, at, ab, second);
    taut_quintic_at(3, space[0], t, x, tangent, second);
    for (int c = 0; c < 3; c++) {
        tangent[c] *= 5;
        second[c] *= 20;
    }
    taut_carrier_at(carrier, piece->start.span, at, 2, on);
    taut_carrier_forms((const double(*)[3])on, &forms);
    *distance = taut_length_between(x, on[0]);
    const double length = taut_length(tangent);
    *speed = length / (piece->to.s - piece->from.s);
    const double p = taut_dot(tangent, on[1]) / length, r = taut_dot(tangent, on[2]) / length;
    ab[0] = (forms.g * p - forms.f * r) / (forms.w * forms.w);
    ab[1] = (forms.e * r - forms.f * p) / (forms.w * forms.w);
    const double radius = taut_form_pair_radius(&forms);
    *residual = 0;
    if (kind.net == TAUT_TRACE_ASYMPTOTIC) {
        *residual = fabs(taut_linefield_normal_curvature(&forms, ab)) / radius;
    } else if (kind.net == TAUT_TRACE_PRINCIPAL) {
        *residual = fabs(taut_linefield_torsion(&forms, ab)) / radius;
    } else if (kind.net == TAUT_TRACE_GEODESIC) {
        taut_cross(forms.normal, tangent, sideways);
        *residual = geodesic_share * carrier->size * fabs(taut_dot(second, sideways)) /
                    (length * length * length);
    }
}

static int is_good(taut_linefield_kind kind, const taut_piece *piece,
                   const taut_lath_options *options)
{
    const taut_carrier *carrier = piece->start.on;
    const double least = kind.net == TAUT_TRACE_GEODESIC ? short_geodesic : short_enough;
    if (piece->h < least * carrier->size) {
        return 1;
    }
    for (int k = 1; k <= PLACES; k++) {
        double distance = 0, residual = 0, speed = 1;
        judge(kind, piece, (double)k / (PLACES + 1), &distance, &residual, &speed);
        if (!(fabs(speed - 1) <= uneven + rounding * carrier->size / piece->h) ||
            !(distance <= options->tolerance / 4 * carrier->size) ||
            !(residual <= options->residual)) {
            return 0;
        }
    }
    return 1;
}

typedef struct pieces {
    taut_arena *arena;
    taut_piece *list;
    int count, room;
} pieces;

static taut_status push(pieces *p, const taut_piece *piece)
{
    if (p->count == p->room) {
        const int room = p->room > 0 ? 2 * p->room : 64;
        taut_piece *list = taut_arena_take_raw(p->arena, (size_t)room, sizeof *list);
        if (list == NULL) {
            return TAUT_NO_MEMORY;
        }
        if (p->count > 0) {
            memcpy(list, p->list, (size_t)p->count * sizeof *list);
        }
        p->list = list;
        p->room = room;
    }
    p->list[p->count++] = *piece;
    return TAUT_OK;
}

/* The state at half of a piece, of the length or, of a straight line, of the window, and how far it is; 0 where there
 * is none. */
static int half_way(taut_linefield_kind kind, const taut_piece *piece, taut_walk_state *middle,
                    double *h)
{
    const double *way = taut_straight_way(piece->start.on, kind);
    *h = piece->h / 2;
    if (way == NULL) {
        return taut_walk_step(kind, &piece->start, piece->h / 2, middle);
    }
    const int d = fabs(way[0]) > fabs(way[1]) ? 0 : 1;
    const double t = (piece->to.at[d] - piece->start.y[d]) / way[d];
    taut_straight_move(piece->start.on, kind, &piece->start, t / 2, middle);
    *h = middle->s - piece->start.s;
    return isfinite(middle->s);
}

/* Does a step over the other half come to where the piece ends? Near K = 0 the method of steps fails. */
static int comes_to(taut_linefield_kind kind, const taut_piece *piece,
                    const taut_walk_state *middle, double h)
{
    double x[TAUT_CARRIER_VECTORS][3];
    taut_walk_state end;
    if (!taut_walk_step(kind, middle, piece->h - h, &end)) {
        return 0;
    }
    taut_carrier_at(end.on, end.span, end.y, 0, x);
    return taut_length_between(x[0], piece->to.x) <= one_end * end.on->size;
}

/* The piece, or its halves, each by a full step from where it begins. */
static taut_status refine(taut_linefield_kind kind, const taut_piece *piece,
                          const taut_lath_options *options, int depth, pieces *out)
{
    taut_piece low = *piece, high = *piece;
    taut_walk_state middle = {.s = 0};
    double h = 0;

    if (depth == 0 || is_good(kind, piece, options) || !half_way(kind, piece, &middle, &h) ||
        (piece->near_parabolic && !comes_to(kind, piece, &middle, h))) {
        return push(out, piece);
    }
    low.h = h;
    high.h = piece->h - h;
    high.start = middle;
    taut_walk_station(kind, &middle, &low.to);
    low.to.blind = fmax(piece->to.blind - high.h, 0);
    high.from = low.to;
    const taut_status status = refine(kind, &low, options, depth - 1, out);
    return status == TAUT_OK ? refine(kind, &high, options, depth - 1, out) : status;
}

/* ---- both ways ---- */

static void reverse_station(const taut_station *from, taut_station *to)
{
    *to = *from;
    for (int c = 0; c < 3; c++) {
        to->tangent[c] = -from->tangent[c];
    }
    to->ab[0] = -from->ab[0];
    to->ab[1] = -from->ab[1];
    to->k_g = -from->k_g;
}

/* Counts from the beginning of the lath, which lies `back` before the seed. */
static void shift_station(taut_station *at, int way, double s, double twist, double measure)
{
    at->s = s + way * at->s;
    at->twist = twist + way * at->twist;
    at->measure = measure + way * at->measure;
}

/* What lies behind the seed, last piece first, then what lies before it. */
static taut_status join(const pieces *behind, const pieces *ahead, taut_arena *arena,
                        taut_lath *lath)
{
    const taut_piece *last = behind->count > 0 ? &behind->list[behind->count - 1] : NULL;
    const double s = last != NULL ? last->to.s : 0, twist = last != NULL ? last->to.twist : 0;
    const double measure = last != NULL ? last->to.measure : 0;

    lath->segments =
        taut_arena_take(arena, (size_t)(behind->count + ahead->count + 1), sizeof(taut_segment));
    if (lath->segments == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = behind->count - 1; k >= 0; k--) {
        const taut_piece *piece = &behind->list[k];
        taut_segment *segment = &lath->segments[lath->count++];
        *segment = (taut_segment){.start = piece->start,
                                  .h = piece->h,
                                  .first = s,
                                  .way = -1,
                                  .near_parabolic = piece->near_parabolic};
        reverse_station(&piece->to, &segment->from);
        reverse_station(&piece->from, &segment->to);
        shift_station(&segment->from, -1, s, twist, measure);
        shift_station(&segment->to, -1, s, twist, measure);
        segment->twist = segment->to.twist;
        segment->measure = segment->to.measure;
    }
    for (int k = 0; k < ahead->count; k++) {
        const taut_piece *piece = &ahead->list[k];
        taut_segment *segment = &lath->segments[lath->count++];
        *segment = (taut_segment){.from = piece->from,
                                  .to = piece->to,
                                  .start = piece->start,
                                  .h = piece->h,
                                  .first = s,
                                  .way = 1,
                                  .near_parabolic = piece->near_parabolic};
        shift_station(&segment->from, 1, s, twist, measure);
        shift_station(&segment->to, 1, s, twist, measure);
        segment->twist = segment->from.twist;
        segment->measure = segment->from.measure;
    }
    lath->seed_s = s;
    if (lath->count > 0) {
        const taut_station *end = &lath->segments[lath->count - 1].to;
        lath->length = end->s;
        lath->twist = end->twist;
        lath->measure = end->measure;
    }
    return TAUT_OK;
}

/* On a border of the window, and out of it? Then the walk ends where it begins. */
static int leaves(const taut_carrier *carrier, const double at[2], const double ab[2],
                  taut_walk *walk)
{
    double x[TAUT_CARRIER_VECTORS][3];
    int span[2];

    *walk = (taut_walk){.edges = {-1, -1}, .end_at = {at[0], at[1]}, .end_on = carrier};
    taut_carrier_cell(carrier, at, NULL, span);
    taut_carrier_at(carrier, span, at, 1, x);
    for (int d = 0; d < 2; d++) {
        const int side = at[d] == carrier->hi[d];
        const double out = (side ? 1 : -1) * ab[d] * taut_length(x[1 + d]);
        if ((at[d] == carrier->lo[d] || side) && !carrier->wraps[d]) {
            walk->edges[walk->edges[0] >= 0] = 2 * d + side;
            walk->end = out > along_border ? TAUT_END_EDGE : walk->end;
        }
    }
    if (walk->end != TAUT_END_NONE && walk->edges[1] >= 0) {
        walk->end = TAUT_END_CORNER;
    }
    return walk->end != TAUT_END_NONE;
}

/* The direction of a break that a place lies on, of one only; -1: on none, or where two of them cross. */
static int break_at(const taut_carrier *carrier, const double at[2])
{
    int span[2], on[2];
    taut_carrier_cell(carrier, at, NULL, span);
    for (int d = 0; d < 2; d++) {
        on[d] = span[d] > 0 && at[d] == taut_basis_breaks(carrier->basis[d])[span[d]];
    }
    return on[0] == on[1] ? -1 : on[1];
}

/* One way from the seed; the pieces in `out` cut until they are good enough. */
static taut_status go(const taut_carrier *carrier, taut_linefield_kind kind, const double at[2],
                      const double along[3], const taut_lath_options *options, taut_walk *walk,
                      pieces *out, taut_linefield_fault *fault)
{
    const int knot = break_at(carrier, at);
    taut_walk_state state;
    int span[2];

    taut_carrier_cell(carrier, at, NULL, span);
    *fault = taut_walk_start(carrier, kind, at, span, along, &state);
    if (*fault != TAUT_LINEFIELD_FINE) {
        return TAUT_OK;
    }
    const double ab[2] = {state.y[TAUT_WALK_A], state.y[TAUT_WALK_B]};
    taut_carrier_cell(carrier, at, ab, span);
    *fault = taut_walk_start(carrier, kind, at, span, along, &state);
    if (*fault != TAUT_LINEFIELD_FINE) {
        return TAUT_OK;
    }
    if (knot >= 0) {
        taut_walk_enter(kind, knot, !(ab[knot] < 0), &state);
    }
    if (leaves(carrier, at, state.y + TAUT_WALK_A, walk) &&
        (kind.net == TAUT_TRACE_ISOPARAMETRIC || !taut_walk_carry(kind, &state))) {
        return TAUT_OK;
    }
    taut_status status = taut_follow(kind, &state, &options->follow, out->arena, walk);
    for (int k = 0; status == TAUT_OK && k < walk->count; k++) {
        status = refine(kind, &walk->pieces[k], options, DEPTH, out);
    }
    return status;
}

static void take_end(taut_lath *lath, int end, const taut_walk *walk)
{
    lath->ended[end] = walk->end;
    memcpy(lath->edges[end], walk->edges, sizeof walk->edges);
    memcpy(lath->ends[end], walk->end_at, sizeof walk->end_at);
    lath->end_on[end] = walk->end_on;
    lath->steps += walk->count;
    lath->drift += walk->drift;
}

/* Where a seed lies on a knot line at which curvatures jump the two ways from it make a corner: the one between segments
 * k - 1 and k. */
static int seed_kink(const taut_lath *lath, const taut_carrier *carrier, int k, taut_kink *kink)
{
    double across[3];
    if (k == 0 || k == lath->count) {
        return 0;
    }
    const double *before = lath->segments[k - 1].to.tangent;
    const double *behind = lath->segments[k].from.tangent;
    taut_cross(before, behind, across);
    *kink = (taut_kink){carrier,
                        {lath->seed[0], lath->seed[1]},
                        taut_atan2(taut_length(across), taut_dot(before, behind))};
    return kink->angle > TAUT_LEAST_KINK;
}

/* Is it where the curve begins or ends? Then the curve leaves the window there, or comes in, and has no corner. */
static int is_at_end(const taut_lath *lath, const taut_kink *kink)
{
    int is_there = 0;
    for (int end = 0; end < 2; end++) {
        int is_near = kink->on == lath->end_on[end];
        for (int d = 0; is_near && d < 2; d++) {
            const double range = kink->on->hi[d] - kink->on->lo[d];
            is_near = fabs(kink->at[d] - lath->ends[end][d]) <= same_end * range;
        }
        is_there |= is_near;
    }
    return is_there;
}

static void add_kinks(taut_lath *lath, const taut_kink *kinks, int count)
{
    for (int k = 0; k < count; k++) {
        if (!is_at_end(lath, &kinks[k])) {
            lath->kinks[lath->kink_count++] = kinks[k];
        }
    }
}

/* Of the way back, at the seed, before segment `seed`, and of the way on. */
static taut_status take_kinks(taut_lath *lath, const taut_carrier *carrier, const taut_walk *back,
                              int seed, const taut_walk *on, taut_arena *arena)
{
    taut_kink corner;
    const int has_corner = seed_kink(lath, carrier, seed, &corner);
    const int count = back->kink_count + has_corner + on->kink_count;
    if (count == 0) {
        return TAUT_OK;
    }
    lath->kinks = taut_arena_take(arena, (size_t)count, sizeof(taut_kink));
    if (lath->kinks == NULL) {
        return TAUT_NO_MEMORY;
    }
    add_kinks(lath, back->kinks, back->kink_count);
    add_kinks(lath, &corner, has_corner);
    add_kinks(lath, on->kinks, on->kink_count);
    return TAUT_OK;
}

static int is_same_cell(const taut_segment *a, const taut_segment *b)
{
    return a->start.on == b->start.on &&
           memcmp(a->start.span, b->start.span, sizeof a->start.span) == 0;
}

/* A station that goes on and bends as another one of its curve. */
static taut_station bent_as(const taut_station *bent, const taut_station *at)
{
    taut_station bends = *at;
    memcpy(bends.tangent, bent->tangent, sizeof bends.tangent);
    memcpy(bends.ab, bent->ab, sizeof bends.ab);
    memcpy(bends.acceleration, bent->acceleration, sizeof bends.acceleration);
    memcpy(bends.bend, bent->bend, sizeof bends.bend);
    bends.k_g = bent->k_g;
    return bends;
}

/* A curve that passes close by where two breaks cross has a piece in the cell beside, too short to bend by the
 * curvature of that cell; what it told there, and its quintic, would be rounding. So it becomes part of the next one,
 * the last one of that before, and these bend as they do, where the corner that it leaves is next to nothing. Others
 * become part of them as they are, if they are as short as rounding. */
static void drop_short(const taut_carrier *carrier, taut_lath *lath)
{
    int count = 0;
    for (int k = 0; k < lath->count; k++) {
        const taut_segment here = lath->segments[k];
        const double length = (here.to.s - here.from.s) / carrier->size;
        taut_segment *next = k + 1 < lath->count ? &lath->segments[k + 1] : NULL;
        taut_segment *before = count > 0 ? &lath->segments[count - 1] : NULL;
        next = next != NULL && taut_station_passes_seam(&here.to, &next->from) ? NULL : next;
        before =
            before != NULL && taut_station_passes_seam(&before->to, &here.from) ? NULL : before;
        const taut_segment *into = next != NULL ? next : before;
        const double *one = before != NULL ? before->to.tangent : here.from.tangent;
        const double *other = next != NULL ? next->from.tangent : here.to.tangent;
        const int is_beside = into != NULL && !is_same_cell(&here, into) &&
                              taut_length_between(one, other) < no_corner;
        if (into == NULL || here.near_parabolic ||
            !(length < (is_beside ? short_beside : shortest))) {
            lath->segments[count++] = here;
        } else if (next != NULL) {
            next->from = is_beside ? bent_as(&next->from, &here.from) : here.from;
        } else {
            before->to = is_beside ? bent_as(&before->to, &here.to) : here.to;
        }
    }
    lath->count = count;
}

static int is_soft(taut_walk_end end)
{
    return end == TAUT_END_FLAT || end == TAUT_END_UMBILIC || end == TAUT_END_PARABOLIC ||
           end == TAUT_END_SINGULAR;
}

/* How far the quintic of a segment is off the net. */
static double segment_off(taut_linefield_kind kind, const taut_segment *segment)
{
    const taut_piece piece = {.start = segment->start, .from = segment->from, .to = segment->to};
    double largest = 0;
    for (int k = 0; k < LOOKS; k++) {
        double distance = 0, residual = 0, speed = 1;
        judge(kind, &piece, (k + 0.5) / LOOKS, &distance, &residual, &speed);
        largest = fmax(largest, residual);
    }
    return largest;
}

/* A curve that passes by an umbilic, or by where K = 0, and turns within less than doubles resolve, ends there: it could not be
 * followed on. */
static void end_before_turn(const taut_carrier *carrier, taut_linefield_kind kind, taut_lath *lath)
{
    const double room = at_end * carrier->size;
    const double first = is_soft(lath->ended[0]) ? room : -1;
    const double last = is_soft(lath->ended[1]) ? lath->length - room : lath->length;
    for (int k = 0; k < lath->count; k++) {
        const taut_segment *segment = &lath->segments[k];
        const double h = segment->to.s - segment->from.s;
        if (h < short_enough * carrier->size && segment->from.s >= first && segment->to.s <= last &&
            taut_length_between(segment->from.tangent, segment->to.tangent) > does_turn &&
            segment_off(kind, segment) > most_off) {
            lath->ended[1] = TAUT_END_STALLED;
            lath->end_on[1] = segment->start.on;
            memcpy(lath->ends[1], segment->from.at, sizeof lath->ends[1]);
            return;
        }
    }
}

taut_status taut_lath_trace(const taut_carrier *carrier, taut_linefield_kind kind,
                            const double at[2], const double along[3], int both,
                            const taut_lath_options *options, taut_arena *arena, taut_lath *lath,
                            taut_linefield_fault *fault)
{
    const double back[3] = {-along[0], -along[1], -along[2]};
    taut_walk *walks = taut_arena_take(arena, 2, sizeof *walks);
    pieces behind = {.arena = arena}, ahead = {.arena = arena};
    taut_walk_state state;
    int span[2];

    *lath = (taut_lath){.family = kind.family, .seed = {at[0], at[1]}};
    if (walks == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_status status = go(carrier, kind, at, along, options, &walks[1], &ahead, fault);
    if (status != TAUT_OK || *fault != TAUT_LINEFIELD_FINE) {
        return status;
    }
    if (both && walks[1].end != TAUT_END_CLOSED) {
        status = go(carrier, kind, at, back, options, &walks[0], &behind, fault);
    } else {
        walks[0] =
            (taut_walk){.end = walks[1].end == TAUT_END_CLOSED ? TAUT_END_CLOSED : TAUT_END_SEED,
                        .edges = {-1, -1},
                        .end_at = {at[0], at[1]},
                        .end_on = carrier};
    }
    if (status == TAUT_OK && *fault == TAUT_LINEFIELD_FINE) {
        status = join(&behind, &ahead, arena, lath);
    }
    if (status != TAUT_OK || *fault != TAUT_LINEFIELD_FINE) {
        return status;
    }
    take_end(lath, 0, &walks[0]);
    take_end(lath, 1, &walks[1]);
    taut_carrier_cell(carrier, at, NULL, span);
    taut_walk_start(carrier, kind, at, span, along, &state);
    taut_carrier_cell(carrier, at, state.y + TAUT_WALK_A, span); /* the one that it goes on into */
    taut_walk_start(carrier, kind, at, span, along, &state);
    memcpy(lath->seed_tangent, state.tangent, sizeof lath->seed_tangent);
    taut_walk_station(kind, &state, &lath->at_seed);
    lath->at_seed.s = lath->seed_s;
    status = take_kinks(lath, carrier, &walks[0], behind.count, &walks[1], arena);
    drop_short(carrier, lath);
    if (kind.net == TAUT_TRACE_PRINCIPAL || kind.net == TAUT_TRACE_ASYMPTOTIC) {
        end_before_turn(carrier, kind, lath);
    }
    return status;
}

void taut_segment_station(taut_linefield_kind kind, const taut_segment *segment,
                          const taut_walk_state *state, taut_station *station)
{
    taut_station own;

    taut_walk_station(kind, state, &own);
    if (segment->way > 0) {
        *station = own;
    } else {
        reverse_station(&own, station);
    }
    station->s = segment->first + segment->way * state->s;
    station->twist =
        segment->twist + segment->way * (own.twist - segment->start.y[TAUT_WALK_TWIST]);
    station->measure =
        segment->measure + segment->way * (own.measure - segment->start.y[TAUT_WALK_MEASURE]);
}

int taut_segment_state(taut_linefield_kind kind, const taut_segment *segment, double s,
                       taut_station *station)
{
    const double h = segment->way * (s - segment->first) - segment->start.s;
    taut_walk_state state;

    if (!taut_walk_step(kind, &segment->start, h, &state)) {
        return 0;
    }
    taut_segment_station(kind, segment, &state, station);
    station->s = s;
    return 1;
}
