/* strip.c
 *
 *     of each lath: the axis of its pattern with what the twist stretches (trace/unroll.h), and by samples of its
 *                   segments the largest stress
 *     of each node: a slot in both laths, its place on the pattern
 *
 * The stresses are those of bending, of Saint-Venant's torsion of a thin rectangle, and of the fibres that
 * the twist has made longer than the mean. */
#include "trace/strip.h"

#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/bracket.h"
#include "trace/bending.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A width that is found, less what a message rounds. */
static const double below = 1 - 1e-5;
enum {
    NODES = TAUT_BENDING_NODES,
    HEIGHTS = 16,
    HALVINGS = 30,
    PARTS_MAX = 4096 /* of a segment */
};
/* ---- how it is cut ---- */

/* What a strip is, in the carrier's unit. */
typedef struct cut {
    const taut_net *net;
    const taut_trace_laths *laths;
    double width, thickness, play;
    int weak, flat;  /* which of a bending it bends by, which one its pattern has */
    int is_straight; /* the pattern: what it would have vanishes on this net */
    int only_bends;  /* about its rulings */
} cut;

int taut_strip_lies(taut_trace_strip strip)
{
    return strip == TAUT_TRACE_PLANK || strip == TAUT_TRACE_ENVELOPE;
}

int taut_strip_only_bends(taut_trace_strip strip)
{
    return strip == TAUT_TRACE_DEVELOPABLE || strip == TAUT_TRACE_ENVELOPE;
}

static cut cut_of(const taut_net *net, double play)
{
    const taut_trace_laths *laths = net->problem->laths;
    const int scale = net->carrier->scale, is_plank = taut_strip_lies(laths->strip);
    return (cut){.net = net,
                 .laths = laths,
                 .width = ldexp(laths->width, -scale),
                 .thickness = ldexp(laths->thickness, -scale),
                 .play = ldexp(play, -scale),
                 .weak = is_plank ? TAUT_K_N : TAUT_K_G,
                 .flat = is_plank ? TAUT_K_G : TAUT_K_N,
                 .is_straight =
                     net->problem->net == (is_plank ? TAUT_TRACE_GEODESIC : TAUT_TRACE_ASYMPTOTIC),
                 .only_bends = taut_strip_only_bends(laths->strip)};
}

static double flat_curvature(const cut *c, const taut_lath_bending *b)
{
    return c->is_straight ? 0 : b->value[c->flat];
}

/* ---- strips that only bend ---- */

/* Of a place on a segment. */
typedef struct ruled {
    double skew; /* eta, or -zeta: what the ruling goes along the axis for each length across */
    double
        rate; /* at height h the strip is 1 + h rate as long as the axis, measured along its rulings */
    double bend; /* on the axis, about the ruling */
    double edge; /* length of the edge at +width/2 per length of the axis */
} ruled;

static double skew_at(const cut *c, const taut_lath_samples *at, double t)
{
    const taut_lath_bending b = taut_lath_bending_at(at->kind, at->segment, t);
    const double ratio = b.value[TAUT_TAU_G] / b.value[c->weak];
    return c->weak == TAUT_K_N ? -ratio : ratio;
}

/* skew' by differences of order 4, which may leave the segment: its cell's polynomial goes on. */
static ruled ruled_at(const cut *c, const taut_lath_samples *at, double t)
{
    static const double d = 0.02;
    const double length = at->segment->to.s - at->segment->from.s;
    const taut_lath_bending b = taut_lath_bending_at(at->kind, at->segment, t);
    const double skew = skew_at(c, at, t);
    const double slope = (8 * (skew_at(c, at, t + d) - skew_at(c, at, t - d)) -
                          (skew_at(c, at, t + 2 * d) - skew_at(c, at, t - 2 * d))) /
                         (12 * d * length);
    const double k = flat_curvature(c, &b), h = c->width / 2, round = 1 + skew * skew;
    return (ruled){.skew = skew,
                   .rate = slope - k * round,
                   .bend = fabs(b.value[c->weak]) * round,
                   .edge = taut_hypot(1 + h * (slope - k), h * skew * k)};
}

/* |rate|, or the curvature over the width, along a segment. */
typedef struct ruled_course {
    const cut *c;
    const taut_lath_samples *at;
    int of_bend;
} ruled_course;

static double ruled_size(const void *context, double t)
{
    const ruled_course *on = context;
    const ruled r = ruled_at(on->c, on->at, t);
    return on->of_bend ? r.bend / (1 - on->c->width / 2 * fabs(r.rate)) : fabs(r.rate);
}

/* The largest one, from samples and between them. */
static void take_ruled(const cut *c, const taut_lath_samples *at, int of_bend, taut_lath_most *most)
{
    const ruled_course on = {c, at, of_bend};
    const double length = at->segment->to.s - at->segment->from.s;
    double value[NODES + 2];
    for (int i = 0; i < NODES + 2; i++) {
        value[i] = ruled_size(&on, at->t[i]);
    }
    for (int i = 0; i < NODES + 2; i++) {
        const int before = i > 0 ? i - 1 : i, after = i < NODES + 1 ? i + 1 : i;
        double t = at->t[i], best = value[i], top_at;
        if (value[i] < value[before] || value[i] < value[after] || !(best > 0.9 * most->value)) {
            continue;
        }
        const double top = taut_bracket_most(ruled_size, &on, at->t[before], at->t[after], &top_at);
        t = top > best ? top_at : t;
        best = fmax(best, top);
        if (best > most->value) {
            *most = (taut_lath_most){best, at->segment->from.s + t * length};
        }
    }
}

/* Does the curvature that the strip bends by vanish on the segment? */
static int is_inflected(const cut *c, const taut_lath_samples *at)
{
    const double first = at->at[0].value[c->weak];
    int is = first == 0 || !(fabs(first) > 1e-9 / c->net->carrier->size);
    for (int i = 1; i < NODES + 2; i++) {
        is |= !(at->at[i].value[c->weak] * first > 0);
    }
    return is;
}

static taut_status refuse_developable(const cut *c, const taut_lath *lath, double at, double widest,
                                      taut_error *error)
{
    const int scale = c->net->carrier->scale;
    if (widest == 0) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "developable", "/laths/strip", c->laths->width, 0,
            "%s has no curvature to bend by %.6g along it: a strip there is 0 wide, take "
            "one that twists",
            lath->name, ldexp(at, scale));
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "developable", "/laths/width", c->laths->width,
                     ldexp(widest, scale),
                     "the rulings of %s meet within its width, %.6g along it: take less than %.6g",
                     lath->name, ldexp(at, scale), ldexp(widest, scale));
}

/* What a strip that only bends has beside the sums. */
static taut_status make_ruled(const cut *c, const taut_lath *lath, taut_strip *strip,
                              taut_error *error)
{
    const taut_linefield_kind kind = {c->net->problem->net, lath->family};
    const taut_trace_material *m = &c->laths->material;
    taut_lath_most rate = {0}, bend = {0};
    taut_lath_samples at;

    strip->edge_length = 0;
    for (int k = 0; k < lath->count; k++) {
        const taut_segment *on = &lath->segments[k];
        taut_lath_bending_sample(kind, on, &at);
        if (is_inflected(c, &at)) {
            return refuse_developable(c, lath, on->from.s, 0, error);
        }
        take_ruled(c, &at, 0, &rate);
        for (int i = 1; i <= NODES; i++) {
            strip->edge_length +=
                at.weight[i] * (on->to.s - on->from.s) * ruled_at(c, &at, at.t[i]).edge;
        }
    }
    if (!(c->width * rate.value < 2)) {
        return refuse_developable(c, lath, rate.at, 2 / rate.value, error);
    }
    for (int k = 0; k < lath->count; k++) {
        taut_lath_bending_sample(kind, &lath->segments[k], &at);
        take_ruled(c, &at, 1, &bend);
    }
    strip->least_radius = bend.value > 0 ? 1 / bend.value : INFINITY;
    strip->has_stress = c->thickness > 0 && m->e > 0;
    if (strip->has_stress) {
        const double stress = m->e * (c->thickness * bend.value) / 2;
        strip->stress = (taut_strip_stress){.bending = stress,
                                            .combined = stress,
                                            .use = stress / m->strength,
                                            .at = bend.at,
                                            .thickest = 2 * m->strength / (m->e * bend.value),
                                            .widest = INFINITY};
    }
    return TAUT_OK;
}

/* ---- the axis of the pattern ---- */

/* How many parts of a segment a polyline needs. */
static int parts_of(const cut *c, const taut_lath_samples *at, double sagitta)
{
    const double length = at->segment->to.s - at->segment->from.s;
    double most = 0;
    for (int k = 0; k < NODES + 2; k++) {
        most = fmax(most, fabs(flat_curvature(c, &at->at[k])));
    }
    const double edge = 1 + most * c->width / 2;
    const double parts = ceil(length * sqrt(1.5 * most * edge / (8 * sagitta)));
    return parts < 1 ? 1 : parts > PARTS_MAX ? PARTS_MAX : (int)parts;
}

taut_status taut_strip_axis(const taut_net *net, const taut_strip *strip, const taut_lath *lath,
                            double sagitta, int stop_count, const double *stops,
                            taut_axis_point **points, int *count)
{
    const cut c = cut_of(net, 0);
    const taut_linefield_kind kind = {net->problem->net, lath->family};
    size_t most = (size_t)stop_count + 2;
    taut_lath_samples at;
    int stop = 0;

    for (int k = 0; k < lath->count; k++) {
        taut_lath_bending_sample(kind, &lath->segments[k], &at);
        most += c.is_straight ? 0 : (size_t)parts_of(&c, &at, sagitta);
    }
    taut_axis_point *list = taut_arena_take(net->arena, most, sizeof *list);
    if (list == NULL) {
        return TAUT_NO_MEMORY;
    }
    *points = list;
    *count = 1; /* the origin */
    if (c.only_bends && lath->count > 0) {
        taut_lath_bending_sample(kind, &lath->segments[0], &at);
        list[0].skew = skew_at(&c, &at, 0);
    }
    for (int k = 0; k < lath->count; k++) {
        const taut_segment *on = &lath->segments[k];
        const double from = on->from.s, length = on->to.s - from;
        taut_lath_bending_sample(kind, on, &at);
        const int parts = c.is_straight ? 1 : parts_of(&c, &at, sagitta);
        for (int part = 1; part <= parts;) {
            const double t = (double)part / parts, s = part == parts ? on->to.s : from + t * length;
            const int is_stop = stop < stop_count && stops[stop] <= s;
            const double here = is_stop ? fmax((stops[stop] - from) / length, 0) : t;
            const int is_kept = is_stop || !c.is_straight || k == lath->count - 1;
            if (is_kept) {
                const taut_unrolled_point there = taut_unrolled_at(&strip->unrolled, k, here);
                list[(*count)++] = (taut_axis_point){is_stop ? stops[stop] : s,
                                                     there.cut,
                                                     there.x,
                                                     there.y,
                                                     there.theta,
                                                     c.only_bends ? skew_at(&c, &at, here) : 0};
            }
            stop += is_stop;
            part += !is_stop;
        }
    }
    return TAUT_OK;
}

/* ---- stresses ---- */

static double weak_size(const taut_lath_bending *b, const void *context)
{
    const cut *c = context;
    return fabs(b->value[c->weak]);
}

static double flat_size(const taut_lath_bending *b, const void *context)
{
    return fabs(flat_curvature(context, b));
}

static double twist_size(const taut_lath_bending *b, const void *context)
{
    (void)context;
    return fabs(b->value[TAUT_TAU_G]);
}

/* Of the ribbon: the largest curvature of a line in it. */
static double ribbon_size(const taut_lath_bending *b, const void *context)
{
    const double half = weak_size(b, context) / 2;
    return half + taut_hypot(half, b->value[TAUT_TAU_G]);
}

static taut_strip_stress stress_of(const cut *c, double k, double tau)
{
    const taut_trace_material *m = &c->laths->material;
    taut_strip_stress s = {.bending = m->e * (c->thickness * k) / 2,
                           .torsion = m->g * (c->thickness * tau),
                           .helix = m->e * (c->width * tau) * (c->width * tau) / 12};
    s.combined = taut_hypot(s.bending + s.helix, sqrt(3) * s.torsion);
    s.use = s.combined / m->strength;
    return s;
}

static double combined_size(const taut_lath_bending *b, const void *context)
{
    return stress_of(context, weak_size(b, context), twist_size(b, context)).combined;
}

/* The bending at s of a lath. */
static taut_lath_bending bending_at(const taut_net *net, const taut_lath *lath, double s,
                                    int *segment)
{
    const taut_linefield_kind kind = {net->problem->net, lath->family};
    int k = 0;
    while (k + 1 < lath->count && s > lath->segments[k].to.s) {
        k++;
    }
    const taut_segment *on = &lath->segments[k];
    const double length = on->to.s - on->from.s;
    const double t = length > 0 ? fmin(fmax((s - on->from.s) / length, 0), 1) : 0;
    if (segment != NULL) {
        *segment = k;
    }
    return taut_lath_bending_at(kind, on, t);
}

/* ---- one lath ---- */

/* A place that is a station's, over the length of the lath. */
static const double at_station = 1e-12;

typedef struct extremes {
    taut_lath_most weak, flat, twist, ribbon, combined;
} extremes;

static void take_stress(const cut *c, const taut_lath *lath, const extremes *most,
                        taut_strip *strip)
{
    const taut_trace_material *m = &c->laths->material;
    int segment = 0;
    taut_lath_bending b = bending_at(c->net, lath, most->combined.at, &segment);
    strip->has_stress = c->thickness > 0 && m->e > 0;
    if (!strip->has_stress) {
        return;
    }
    strip->stress = stress_of(c, weak_size(&b, c), twist_size(&b, c));
    for (int k = segment; k < segment + 2 && k < lath->count; k++) {
        /* stations know more: a surface may bend more beyond a knot, and at its end a net has no direction */
        const taut_station *at = k == segment ? &lath->segments[k].to : &lath->segments[k].from;
        b = (taut_lath_bending){{at->k_n, at->k_g, at->tau_g}};
        const taut_strip_stress there = stress_of(c, weak_size(&b, c), twist_size(&b, c));
        if (fabs(at->s - most->combined.at) <= at_station * lath->length &&
            there.combined > strip->stress.combined) {
            strip->stress = there;
        }
    }
    strip->stress.at = most->combined.at;
    strip->stress.thickest =
        most->weak.value > 0 ? 2 * m->strength / (m->e * most->weak.value) : INFINITY;
    strip->stress.widest =
        most->twist.value > 0 ? sqrt(12 * m->strength / m->e) / most->twist.value : INFINITY;
}

static taut_status make_strip(const cut *c, const taut_lath *lath, taut_strip *strip,
                              taut_error *error)
{
    const taut_linefield_kind kind = {c->net->problem->net, lath->family};
    const taut_unroll_rule rule = {.flat = c->is_straight ? -1 : c->flat,
                                   .width = c->only_bends ? 0 : c->width,
                                   .is_stretched = c->laths->cut != TAUT_TRACE_CUT_AXIS};
    extremes most = {0};

    if (taut_unroll(c->net->arena, kind, lath, &rule, &strip->unrolled) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < lath->count; k++) {
        taut_lath_samples at;
        taut_lath_bending_sample(kind, &lath->segments[k], &at);
        taut_lath_take_most(&at, weak_size, c, 1, &most.weak);
        taut_lath_take_most(&at, flat_size, c, 1, &most.flat);
        taut_lath_take_most(&at, twist_size, c, 1, &most.twist);
        taut_lath_take_most(&at, ribbon_size, c, 1, &most.ribbon);
        taut_lath_take_most(&at, combined_size, c, 1, &most.combined);
        if (taut_pulse_beat(c->net->pulse, TAUT_LATH_BENDING_WORK)) {
            return taut_fail_status(error, TAUT_INTERRUPTED);
        }
    }
    if (!c->only_bends && most.flat.value * c->width >= 2) {
        const int scale = c->net->carrier->scale;
        return taut_fail(
            error, TAUT_NO_SOLUTION, "folds", "/laths/width", c->laths->width,
            ldexp(2 / most.flat.value, scale),
            "%s folds over itself %.6g along it: it is %.6g wide, and bends in its own "
            "plane on a radius of %.6g",
            lath->name, ldexp(most.flat.at, scale), c->laths->width,
            ldexp(1 / most.flat.value, scale));
    }
    const taut_unrolled_point end = lath->count > 0
                                        ? taut_unrolled_at(&strip->unrolled, lath->count - 1, 1)
                                        : (taut_unrolled_point){0};
    strip->edge_length = lath->length + end.edge;
    strip->mean_stretch = end.stretch;
    strip->cut_length = end.cut;
    strip->end[0] = end.x;
    strip->end[1] = end.y;
    strip->end[2] = end.theta;
    if (c->only_bends) {
        return make_ruled(c, lath, strip, error);
    }
    strip->least_radius = most.ribbon.value > 0 ? 1 / most.ribbon.value : INFINITY;
    take_stress(c, lath, &most, strip);
    return TAUT_OK;
}

/* ---- slots ---- */

/* The angle about n from the first lath of a node to the second, at height h. */
static double angle_at(const taut_lath_bending b[2], double angle, double h)
{
    double turned[2];
    for (int i = 0; i < 2; i++) {
        turned[i] = taut_atan2(-h * b[i].value[TAUT_TAU_G], 1 - h * b[i].value[TAUT_K_N]);
    }
    return angle + turned[1] - turned[0];
}

/* The signed angle on the surface, from 0 to pi: the tangents by their segments. */
static double directed_angle(const taut_net *net, const taut_node *node, taut_lath_bending b[2])
{
    double tangent[2][3], across[3];
    for (int i = 0; i < 2; i++) {
        const taut_lath *lath = &net->laths[node->laths[i]];
        const taut_linefield_kind kind = {net->problem->net, lath->family};
        taut_station at = {0};
        int segment = 0;
        b[i] = bending_at(net, lath, node->s[i], &segment);
        if (!taut_segment_state(kind, &lath->segments[segment], node->s[i], &at)) {
            at = lath->segments[segment].from;
        }
        memcpy(tangent[i], at.tangent, sizeof at.tangent);
    }
    taut_cross(tangent[0], tangent[1], across);
    const double angle =
        taut_atan2(taut_dot(across, node->normal), taut_dot(tangent[0], tangent[1]));
    return angle < 0 ? angle + TAUT_PI : angle;
}

double taut_slot_twisted(const taut_net *net, const taut_node *node, int side, double width)
{
    taut_lath_bending b[2];
    const double angle = directed_angle(net, node, b);
    double least = TAUT_PI / 2;

    for (int k = 0; k <= HEIGHTS; k++) {
        const double h = (side == 0 ? 1 : -1) * width / 2 * k / HEIGHTS;
        const double here = angle_at(b, angle, h);
        if (!(here > 0) || !(here < TAUT_PI)) {
            return 0;
        }
        least = fmin(least, fmin(here, TAUT_PI - here));
    }
    return taut_cos(least / 2) / taut_sin(least / 2);
}

/* How far along the pattern s of the lath is. */
static double place_on(const taut_strip *strip, const taut_lath *lath, double s)
{
    int k = 0;
    while (k + 1 < lath->count && lath->segments[k].to.s < s) {
        k++;
    }
    const taut_segment *on = &lath->segments[k];
    const double t = (s - on->from.s) / (on->to.s - on->from.s);
    return taut_unrolled_at(&strip->unrolled, k, fmin(fmax(t, 0), 1)).cut;
}

/* Sorts a slot into its strip. 0: none, as the two laths turn into each other within their width. */
static int add_slot(const cut *c, int index, int side, double at, taut_strip *strip)
{
    const taut_node *node = &c->net->nodes.list[index];
    const double twisted = taut_slot_twisted(c->net, node, side, c->width);
    int k = strip->slot_count;

    if (twisted == 0) {
        return 0;
    }
    for (; k > 0 && strip->slots[k - 1].s > node->s[side]; k--) {
        strip->slots[k] = strip->slots[k - 1];
    }
    strip->slots[k] = (taut_slot){.node = index,
                                  .side = side,
                                  .s = node->s[side],
                                  .at = at,
                                  .width = twisted * c->thickness + c->play,
                                  .depth = c->width / 2};
    strip->slot_count++;
    return 1;
}

/* Do laths of this width have slots with something between them? By lengths on the axis, which are not longer than what
 * is cut. The strips' slots are lost. */
static int is_narrow_enough(const cut *c, double width, taut_strip *strips)
{
    const taut_nodes *nodes = &c->net->nodes;
    cut tried = *c;
    int is_so = 1;

    tried.width = width;
    for (int lath = 0; lath < c->net->count; lath++) {
        strips[lath].slot_count = 0;
    }
    for (int k = 0; is_so && k < 2 * nodes->count; k++) {
        const taut_node *node = &nodes->list[k / 2];
        is_so = add_slot(&tried, k / 2, k % 2, node->s[k % 2], &strips[node->laths[k % 2]]);
    }
    for (int lath = 0; is_so && lath < c->net->count; lath++) {
        for (int k = 1; k < strips[lath].slot_count; k++) {
            const taut_slot *a = &strips[lath].slots[k - 1], *b = &strips[lath].slots[k];
            is_so &= (a->width + b->width) / 2 < b->at - a->at;
        }
    }
    return is_so;
}

/* Two laths that turn into each other, with the width that works, if one does. */
static taut_status turn_into(const cut *c, const taut_node *node, int side, taut_strip *strips,
                             taut_error *error)
{
    const taut_lath *laths = c->net->laths;
    const char *one = laths[node->laths[0]].name, *other = laths[node->laths[1]].name;
    double low = 0, high = c->width;

    for (int round = 0; round < HALVINGS; round++) {
        const double width = (low + high) / 2;
        *(is_narrow_enough(c, width, strips) ? &low : &high) = width;
    }
    const double works = ldexp(low * below, c->net->carrier->scale);
    char remedy[64] = "thinner laths, or fewer";
    if (low > 0) {
        snprintf(remedy, sizeof remedy, "laths of a width of %.6g", works);
    }
    return taut_fail(
        error, TAUT_NO_SOLUTION, "slots", "/laths/width", c->laths->width,
        low > 0 ? works : taut_none,
        "%s and %s turn into each other between their node and the edge of %s: take %s", one, other,
        laths[node->laths[side]].name, remedy);
}

/* The thickness below which two slots leave something between them; of a play that is not given no
 * more than the thickness. */
static double thickness_between(const cut *c, double gap, double need)
{
    const double slope = (need - c->play) / c->thickness, by_play = (gap - c->play) / slope;
    return fmax(c->laths->has_play ? by_play : fmax(by_play, gap / (slope + 1)), 0);
}

/* Slots side by side must leave something between them, on all laths. */
static taut_status check_slots(const cut *c, const taut_strip *strips, taut_error *error)
{
    const int scale = c->net->carrier->scale;
    double least = INFINITY, where = 0;
    int worst = 0;

    for (int lath = 0; lath < c->net->count; lath++) {
        for (int k = 1; k < strips[lath].slot_count; k++) {
            const taut_slot *a = &strips[lath].slots[k - 1], *b = &strips[lath].slots[k];
            const double gap = b->at - a->at, need = (a->width + b->width) / 2;
            const double thickness = thickness_between(c, gap, need);
            if (need >= gap && thickness < least) {
                least = thickness;
                worst = lath;
                where = a->s;
            }
        }
    }
    if (least == INFINITY) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "slots", "/laths/thickness", c->laths->thickness,
                     ldexp(least, scale),
                     "slots of %s overlap, %.6g along it: take laths thinner than %.6g, or fewer",
                     c->net->laths[worst].name, ldexp(where, scale), ldexp(least, scale));
}

static taut_status make_slots(const cut *c, taut_strip *strips, taut_error *error)
{
    const taut_net *net = c->net;
    taut_status status = TAUT_OK;
    int *count = taut_arena_take(net->arena, (size_t)net->count + 1, sizeof *count);

    if (count == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < net->nodes.count; k++) {
        for (int side = 0; side < 2; side++) {
            count[net->nodes.list[k].laths[side]]++;
        }
    }
    for (int k = 0; k < net->count; k++) {
        strips[k].slots =
            taut_arena_take(net->arena, (size_t)count[k] + 1, sizeof *strips[k].slots);
        if (strips[k].slots == NULL) {
            return taut_fail_memory(error);
        }
    }
    for (int k = 0; status == TAUT_OK && k < 2 * net->nodes.count; k++) {
        const taut_node *node = &net->nodes.list[k / 2];
        taut_strip *strip = &strips[node->laths[k % 2]];
        const double at = place_on(strip, &net->laths[node->laths[k % 2]], node->s[k % 2]);
        if (!add_slot(c, k / 2, k % 2, at, strip)) {
            status = turn_into(c, node, k % 2, strips, error);
        }
    }
    return status == TAUT_OK ? check_slots(c, strips, error) : status;
}

taut_status taut_strips_new(const taut_net *net, double play, taut_strip **strips,
                            taut_error *error)
{
    const cut c = cut_of(net, play);
    taut_strip *list = taut_arena_take(net->arena, (size_t)net->count + 1, sizeof *list);
    taut_status status = list != NULL ? TAUT_OK : taut_fail_memory(error);

    for (int k = 0; status == TAUT_OK && k < net->count; k++) {
        status = make_strip(&c, &net->laths[k], &list[k], error);
    }
    if (status == TAUT_OK && !taut_strip_lies(c.laths->strip) && c.width > 0 && c.thickness > 0) {
        status = make_slots(&c, list, error);
    }
    *strips = list;
    return status;
}
