/* cover.c -- proof that a surface is the tube of circles about its axis, all of it and once.
 *
 * With R = x - P(s), m the least of |P'|^2 - (x - P) . P'' from s to the foot of x on the axis, and
 * eta = (R . P')^2 / m, the distance r of x from the axis there is bounded by
 *
 *     |R|^2 - eta <= r^2 <= |R|^2
 *
 * as (x - P(s))^2 / 2 has the slope -R . P' and bends by m at least. The numerators of R . R - a^2,
 * R . P' and the bend are polynomials with Bernstein coefficients around their values; patches are
 * halved until |r - a| is bounded near the largest that is seen.
 *
 * Where the radius a(s) changes, 2 f = |x - P|^2 - a^2 is at its least, in s, at the sphere that x
 * touches or is nearest to: of a canal surface the same holds with f' = -(R . P' + a a') in place of
 * -R . P', and m bounds the bend of f. The circle of a naive sweep is that of the foot, to which
 * a^2 / 2 changes by a a' delta, delta = R . P' / (|P'|^2 - R . P'') but for terms of second order,
 * which are bounded.
 *
 * That the tube is near the surface too, and is gone around once: the rings close, the first one
 * winds once about the axis, and P' . (R x R_v) has one sign, so that the angle about the axis grows
 * all around every ring; R never vanishes, so that every ring winds as often as the first.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/sweep.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>

enum { DEPTH = 14, PATCHES = 64, PATCHES_PER_SPAN = 24, SPANS_AT_ONCE = 2 };

/* A bound is good enough when it is this near to what is seen, or this small a part of what is
 * asked for. */
static const double near_enough = 1.06, small_enough = 1.0 / 64;
static const double negligible = 1.0 / 64; /* of what is wanted */
static const double rounded = 1 + 64 * TAUT_UNIT_ROUNDOFF;

typedef struct prover {
    const taut_pipe_sweep *sweep;
    taut_pipe_cover *cover;
    int winding;
    int left;     /* patches that may still be looked at */
    double noise; /* what rounding makes of what is seen */
} prover;

/* What a bound should come down to. */
static double wanted_of(const prover *p)
{
    return fmax(near_enough * p->cover->found, small_enough * p->sweep->tolerance);
}

/* What is known of a patch because it is known of the one that it is a part of. */
typedef struct known {
    int turned;         /* the rings turn about the axis as a whole does */
    double slope, bend; /* the largest |f'|, and m; bend 0: not known yet */
    double move, third; /* how far the foot is at most, and the largest change of the bend by s */
} known;

/* R . P', and of a canal surface R . P' + a a'. */
static taut_field slope_field(taut_arena *arena, const prover *p, const taut_pipe_patch *patch)
{
    const taut_field along = taut_field_dot(arena, patch->way, patch->first);
    if (!p->sweep->changes || !p->sweep->parts->canal) {
        return along;
    }
    const taut_field growth = taut_field_product(arena, &patch->w, &patch->half[1]);
    return taut_field_sum(arena, &along, &growth);
}

/* w times the bend of f. */
static taut_field bend_field(taut_arena *arena, const prover *p, const taut_pipe_patch *patch)
{
    const taut_field speed = taut_field_dot(arena, patch->first, patch->first);
    const taut_field turn = taut_field_dot(arena, patch->way, patch->second);
    const taut_field weighted = taut_field_product(arena, &patch->w, &speed);
    const taut_field bend = taut_field_difference(arena, &weighted, &turn);
    if (!p->sweep->changes || !p->sweep->parts->canal) {
        return bend;
    }
    const taut_field growth = taut_field_product(arena, &patch->w, &patch->half[2]);
    return taut_field_difference(arena, &bend, &growth);
}

/* The least bend of f from s to the foot, and the largest |f'|. */
static void find_least_bend(taut_arena *arena, const prover *p, const taut_pipe_patch *patch,
                            double longest, known *k)
{
    const double *most = p->sweep->most;
    const taut_field along = slope_field(arena, p, patch);
    const taut_field bend = bend_field(arena, p, patch);
    const double here = taut_field_low(&bend) / taut_field_high(&patch->w);
    double least = 0;
    k->slope = taut_field_largest(&along) / taut_field_low(&patch->w) * rounded;
    k->move = 2 * k->slope / here; /* the foot is nearer, if the bend halves at most on the way */
    const double first = taut_pipe_longest(patch->first) + k->move * most[2];
    const double second = taut_pipe_longest(patch->second) + k->move * most[3];
    k->third = 3 * first * second + (longest + k->move * first) * most[3] +
               (p->sweep->changes ? p->sweep->half_most[1] : 0);
    least = here - k->move * k->third;
    k->bend = here > 0 && least > 0.5 * here ? least / rounded : NAN;
}

/* The distance from the point of the tube that looks the same way from the same place of the axis,
 * where the foot is not bounded. */
static double at_same_place(taut_arena *arena, const taut_pipe_patch *patch, double slope,
                            double square, double below, double above, double a)
{
    const taut_field speed = taut_field_dot(arena, patch->first, patch->first);
    const double along = slope / sqrt(taut_field_low(&speed));
    const double least = square + fmin(below, 0) - along * along;
    return least > 0 ? taut_hypot(along, fmax(a - sqrt(least), sqrt(square + fmax(above, 0)) - a))
                     : INFINITY;
}

/* w^2 (|R|^2 - a^2). */
static taut_field apart_field(taut_arena *arena, const prover *p, const taut_pipe_patch *patch)
{
    const double a = p->sweep->radius, square = a * a;
    const taut_field rr = taut_field_dot(arena, patch->way, patch->way);
    const taut_field ww = taut_field_product(arena, &patch->w, &patch->w);
    if (!p->sweep->changes) {
        return taut_field_combine(arena, 1, &rr, -square, &ww);
    }
    const taut_field wide = taut_field_product(arena, &ww, &patch->half[0]);
    return taut_field_combine(arena, 1, &rr, -2, &wide);
}

/* The range of f / g, g > 0: about its value in the middle, so that what f has in common with g cancels.
 * NAN where g is not known to be positive. */
static void range_of(taut_arena *arena, const taut_field *f, const taut_field *g, double range[2])
{
    const double least = taut_field_low(g), most = taut_field_high(g);
    const double middle = taut_field_value(f, 0.5, 0.5) / taut_field_value(g, 0.5, 0.5);
    const taut_field rest = taut_field_combine(arena, 1, f, -middle, g);
    const double low = taut_field_low(&rest), high = taut_field_high(&rest);
    const double below = low / (low < 0 ? least : most), above = high / (high > 0 ? least : most);
    range[0] = middle + below - 8 * TAUT_UNIT_ROUNDOFF * (fabs(middle) + fabs(below));
    range[1] = middle + above + 8 * TAUT_UNIT_ROUNDOFF * (fabs(middle) + fabs(above));
    if (!(least > 0)) {
        range[0] = range[1] = NAN;
    }
}

/* |R|^2 - a^2 less what a^2 gains to the foot, to first order. */
static void gain_to_foot(taut_arena *arena, const prover *p, const taut_pipe_patch *patch,
                         const taut_field *apart, const taut_field *ww, double range[2])
{
    const taut_field bend = bend_field(arena, p, patch), along = slope_field(arena, p, patch);
    const taut_field bent = taut_field_product(arena, &bend, apart);
    const taut_field gain = taut_field_product(arena, &along, &patch->half[1]);
    const taut_field gained = taut_field_product(arena, ww, &gain);
    const taut_field all = taut_field_combine(arena, 1, &bent, -2, &gained);
    const taut_field weighted = taut_field_product(arena, ww, &bend);
    range_of(arena, &all, &weighted, range);
}

/* bound_of where the radius changes. */
static double changing_bound(taut_arena *arena, const prover *p, const taut_pipe_patch *patch,
                             const taut_field *apart, known *k)
{
    const taut_field ww = taut_field_product(arena, &patch->w, &patch->w);
    const double widest = 2 * taut_field_high(&patch->half[0]);
    const double narrowest = 2 * taut_field_low(&patch->half[0]);
    double range[2], a = 0, over = 0;
    range_of(arena, apart, &ww, range);
    const double longest = sqrt(fmax(widest + range[1], 0)) * rounded;
    if (!(narrowest > 0)) {
        return INFINITY;
    }
    if (!(k->slope * k->slope < negligible * wanted_of(p) * narrowest * k->bend)) {
        find_least_bend(arena, p, patch, longest, k);
    }
    if (!p->sweep->parts->canal && !(k->bend > 0)) {
        const double far =
            at_same_place(arena, patch, k->slope, narrowest, range[0], range[1], sqrt(narrowest));
        return far / p->sweep->radius * rounded;
    }
    if (!p->sweep->parts->canal) {
        gain_to_foot(arena, p, patch, apart, &ww, range);
        over =
            k->move * k->move *
            (2 * taut_field_largest(&patch->half[1]) * k->third / k->bend + p->sweep->half_most[0]);
    }
    a = sqrt(narrowest) - k->move * p->sweep->rate;
    const double below = range[0] - k->slope * k->slope / k->bend - over;
    const double square = a > 0 ? a * a : 0;
    const double above = range[1] + over;
    const double bound =
        taut_certify_max(above / (2 * a), -below / (sqrt(fmax(square + below, 0)) + a));
    return a > 0 && isfinite(bound)
               ? fmax(bound / p->sweep->radius * rounded, 4 * TAUT_UNIT_ROUNDOFF)
               : INFINITY;
}

/* |r - a| / a at most; INFINITY where it is not bounded. */
static double bound_of(taut_arena *arena, const prover *p, const taut_pipe_patch *patch, known *k)
{
    const double a = p->sweep->radius, square = a * a;
    const double low = taut_field_low(&patch->w), high = taut_field_high(&patch->w);
    const taut_field apart = apart_field(arena, p, patch);
    const double least = taut_field_low(&apart), most = taut_field_high(&apart);
    double bound = 0;

    if (!(low > 0) || !isfinite(least) || !isfinite(most)) {
        return INFINITY;
    }
    if (p->sweep->changes) {
        return changing_bound(arena, p, patch, &apart, k);
    }
    const double above = most / (most > 0 ? low * low : high * high);
    const double longest = sqrt(fmax(square + above, 0)) * rounded;
    if (!(k->slope * k->slope < negligible * wanted_of(p) * square * k->bend)) {
        find_least_bend(arena, p, patch, longest, k);
    }
    const double below =
        least / (least < 0 ? low * low : high * high) - k->slope * k->slope / k->bend;
    bound = fmax(above / (longest + a), -below / (sqrt(square + below) + a));
    if (!isfinite(below) || !(square + below > 0)) {
        bound = at_same_place(arena, patch, k->slope, square, least / (low * low), above, a);
    }
    if (p->sweep->straight) { /* where it is along the line counts there */
        const taut_field speed = taut_field_dot(arena, patch->first, patch->first);
        bound = taut_certify_max(bound, k->slope / sqrt(taut_field_low(&speed)));
    }
    return bound > 0 ? bound / a * rounded : 4 * TAUT_UNIT_ROUNDOFF;
}

/* |r - a| / a at a place, and along a straight pipe how far the place is off. */
static double miss_at(const prover *p, double u, double v, const taut_pipe_patch *patch)
{
    const taut_pipe_sweep *s = p->sweep;
    const taut_pipe_line *line = &s->parts->line;
    double x[3], local[3], offset[3], foot = 0;
    int piece = 0;
    if (s->straight) {
        const double w = taut_field_value(&patch->w, 0.5, 0.5);
        double way[3], along[3];
        for (int k = 0; k < 3; k++) {
            way[k] = taut_field_value(&patch->way[k], 0.5, 0.5) / w;
            along[k] = taut_field_value(&patch->first[k], 0.5, 0.5);
        }
        const double length = taut_norm(along), move = taut_dot(way, along) / length;
        taut_add_scaled(-move / length, along, way);
        return fmax(fabs(move), fabs(taut_norm(way) - s->radius)) / s->radius;
    }
    const taut_basis *basis = taut_surface_u(s->surface);
    const double part = (u - taut_basis_lo(basis)) / (taut_basis_hi(basis) - taut_basis_lo(basis));
    taut_surface_eval(s->surface, u, v, 0, x);
    taut_pipe_to_local(line, x, local);
    if (s->changes && s->parts->canal) {
        double convex = 0;
        return taut_pipe_canal_miss(s->parts, local, u, &convex);
    }
    taut_pipe_find_foot(line, local, s->from + part * (s->to - s->from), &piece, &foot, offset);
    if (s->changes) {
        return taut_pipe_section_miss(s->parts, piece, foot, offset);
    }
    return fabs(taut_norm(offset) - s->radius) / s->radius;
}

static void see(const prover *p, const taut_pipe_patch *patch)
{
    taut_pipe_cover *const cover = p->cover;
    const double u = 0.5 * (patch->u[0] + patch->u[1]), v = 0.5 * (patch->v[0] + patch->v[1]);
    const double miss = miss_at(p, u, v, patch);
    if (miss > cover->found || cover->where[0] == '\0') {
        cover->found = fmax(miss, cover->found);
        snprintf(cover->where, sizeof cover->where, "%.32s, u = %.6g, v = %.6g", p->sweep->name, u,
                 v);
    }
    if (miss > p->sweep->tolerance + p->noise) {
        cover->fault = "";
    }
}

/* How the rings turn about the axis over a patch: +1 the way they do as a whole, -1 where they are
 * seen to turn back, 0 where it is not decided. */
static int turn_of(taut_arena *arena, const prover *p, const taut_pipe_patch *patch)
{
    taut_field around[3], across[3], turn;
    for (int k = 0; k < 3; k++) {
        around[k] = taut_field_dv(arena, &patch->way[k]);
    }
    taut_field_cross(arena, patch->way, around, across);
    turn = taut_field_dot(arena, patch->first, across);
    const double low = taut_field_low(&turn), high = taut_field_high(&turn);
    if (p->winding > 0 ? low > 0 : high < 0) {
        return 1;
    }
    return (p->winding > 0 ? high < 0 : low > 0) ? -1 : 0;
}

static void visit(taut_arena *arena, prover *p, const taut_pipe_patch *patch, known k, int depth)
{
    taut_pipe_cover *const cover = p->cover;
    taut_pipe_patch halves[2];
    const double bound = bound_of(arena, p, patch, &k);
    const int turn = k.turned ? 1 : turn_of(arena, p, patch);

    k.turned = turn > 0;
    if (cover->fault != NULL) {
        return;
    }
    if (turn < 0) {
        snprintf(cover->where, sizeof cover->where, "%.32s, u = %.6g, v = %.6g", p->sweep->name,
                 0.5 * (patch->u[0] + patch->u[1]), 0.5 * (patch->v[0] + patch->v[1]));
        cover->fault = "the surface turns back about the axis";
        return;
    }
    if (turn > 0 && bound <= wanted_of(p)) {
        cover->bound = fmax(cover->bound, bound);
        return;
    }
    see(p, patch);
    if (depth == DEPTH || p->left <= 0) {
        cover->bound = taut_certify_max(cover->bound, bound);
        cover->open = turn > 0 ? cover->open : "that the rings turn one way is not decided";
        return;
    }
    p->left--;
    taut_pipe_patch_halve(arena, patch, depth % 2, halves);
    for (int half = 0; half < 2; half++) {
        visit(arena, p, &halves[half], k, depth + 1);
    }
}

/* All patches of span i along the axis, seen or bounded. */
static void go_over(taut_arena *arena, prover *p, int i, int only_see)
{
    const taut_basis *v = taut_surface_v(p->sweep->surface);
    for (int j = 0; j < taut_basis_span_count(v) && p->cover->fault == NULL; j++) {
        taut_pipe_patch patch;
        if (only_see && !p->sweep->straight) {
            see(p, taut_pipe_patch_place(p->sweep, i, j, &patch));
        } else if (!taut_pipe_patch_of(arena, p->sweep, i, j, &patch)) {
            p->cover->open = "it is on a basis that is no polynomial's";
            p->cover->bound = INFINITY;
        } else if (only_see) {
            see(p, &patch);
        } else {
            visit(arena, p, &patch, (known){.turned = 0}, 0);
        }
    }
}

/* What rounding of the coordinates makes of a distance, over the radius. */
static double noise_of(const taut_pipe_sweep *sweep)
{
    return 16 * TAUT_UNIT_ROUNDOFF * sweep->parts->size /
           (sweep->radius * sweep->parts->line.scale);
}

int taut_pipe_cover_rings(taut_arena *arena, const taut_pipe_sweep *sweep, taut_pipe_cover *cover)
{
    const double gap = taut_pipe_ring_gap(arena, sweep);
    int winding = 0;
    cover->bound = cover->found = gap;
    if (gap > sweep->tolerance + noise_of(sweep)) {
        cover->fault = "its rings do not close";
    } else {
        winding = taut_pipe_winding(arena, sweep, cover);
    }
    if (winding == 0) {
        cover->bound = cover->found = taut_certify_max(gap, 1);
        snprintf(cover->where, sizeof cover->where, "%.32s", sweep->name);
    }
    return winding;
}

taut_status taut_pipe_cover_round(const taut_pipe_sweep *sweep, taut_pipe_cover *cover)
{
    const int spans = taut_basis_span_count(taut_surface_u(sweep->surface));
    const int around = taut_basis_span_count(taut_surface_v(sweep->surface));
    prover p = {.sweep = sweep,
                .cover = cover,
                .left = PATCHES + PATCHES_PER_SPAN * spans * around,
                .noise = noise_of(sweep)};
    *cover = (taut_pipe_cover){.bound = 0, .where = ""};
    taut_arena *const first = taut_arena_new();
    p.winding = taut_pipe_cover_rings(first, sweep, cover);
    taut_status status = taut_arena_status(first);
    taut_arena_free(first);
    for (int n = 0; n < 2 * spans && status == TAUT_OK; n += SPANS_AT_ONCE) {
        taut_arena *const arena = taut_arena_new();
        for (int i = n; i < n + SPANS_AT_ONCE && i < 2 * spans; i++) {
            if (cover->fault == NULL && p.winding != 0) {
                go_over(arena, &p, i % spans, i < spans);
            }
        }
        status = taut_arena_status(arena);
        taut_arena_free(arena);
        if (taut_crew_beat(sweep->parts->crew, TAUT_PULSE_WORK)) {
            return TAUT_INTERRUPTED;
        }
    }
    return status;
}
