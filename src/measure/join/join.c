/* join.c -- matching the two edges, and the worst of what is found along them.
 *
 * The edge of the first surface is cut at its own knots and at those of the second; each piece is
 * sampled closed, seen from inside; where both edges are polynomials of one parameter, gap and
 * parametric order are then proved all along (proof.c).
 */
#include "taut/join.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "geometry/exponent.h"
#include "measure/join/side.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 100 }; /* along the whole edge, at least */

static const char *const names[4] = {"u0", "u1", "v0", "v1"};

const char *taut_edge_name(taut_edge edge)
{
    return (int)edge >= 0 && (int)edge < 4 ? names[edge] : "";
}

taut_status taut_edge_of_name(const char *name, taut_edge *edge)
{
    for (int i = 0; name != NULL && edge != NULL && i < 4; i++) {
        if (strcmp(name, names[i]) == 0) {
            *edge = (taut_edge)i;
            return TAUT_OK;
        }
    }
    return TAUT_BAD_ARGUMENT;
}

/* `leaves`: the parameter across is to grow out of the surface (the first) or into it. */
static taut_join_side side_of(const taut_surface *surface, taut_edge edge, int leaves)
{
    taut_join_side side = {
        .surface = surface, .edge = edge, .held = (int)edge / 2, .sign_along = 1};
    side.along = side.held == 0 ? taut_surface_v(surface) : taut_surface_u(surface);
    side.across = side.held == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    side.sign_across = ((int)edge % 2 == 1) == (leaves != 0) ? 1 : -1;
    side.scale =
        taut_exponent(taut_half_size(taut_point_count(surface), taut_surface_points(surface))) + 1;
    side.shift_across = taut_range_exponent(side.across);
    return side;
}

/* Both sides at the scale of the larger one. */
static void share_scales(taut_join_side sides[2])
{
    for (int s = 0; s < 2; s++) {
        if (sides[s].scale < sides[1 - s].scale) {
            sides[s].scale = sides[1 - s].scale;
        }
        if (sides[s].shift_across < sides[1 - s].shift_across) {
            sides[s].shift_across = sides[1 - s].shift_across;
        }
    }
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The parts at which either edge has a knot, in order, without those that fall together: double
 * [*count], ends included; NULL when memory runs out. The caller frees it. */
static double *common_breaks(const taut_join_side *a, const taut_join_side *b, int *count)
{
    const taut_join_side *sides[2] = {a, b};
    const size_t most =
        (size_t)taut_basis_span_count(a->along) + (size_t)taut_basis_span_count(b->along) + 2;
    double *parts = taut_alloc(most, sizeof(double));
    int made = 0, kept = 1;

    if (parts == NULL) {
        return NULL;
    }
    for (int s = 0; s < 2; s++) {
        const double *breaks = taut_basis_breaks(sides[s]->along);
        const int spans = taut_basis_span_count(sides[s]->along);
        for (int i = 0; i <= spans; i++) {
            const double part = (breaks[i] - breaks[0]) / (breaks[spans] - breaks[0]);
            parts[made++] = sides[s]->sign_along > 0 ? part : 1 - part;
        }
    }
    qsort(parts, (size_t)made, sizeof(double), compare_numbers);
    for (int i = 1; i < made; i++) {
        /* knots of both sides that are meant to be the same differ by a few roundings */
        if (parts[i] - parts[kept - 1] > 1e-12) {
            parts[kept++] = parts[i];
        }
    }
    parts[0] = 0;
    parts[kept - 1] = 1;
    *count = kept;
    return parts;
}

/* A piece of the first edge between two common breaks, and where on the second it lies. */
typedef struct piece {
    double from, to; /* parts */
    int span_a, span_b;
    int steps;
    int is_affine;
} piece;

static double clamp_to_span(const taut_basis *basis, int span, double t)
{
    const double *breaks = taut_basis_breaks(basis);
    return fmin(breaks[span + 1], fmax(breaks[span], t));
}

/* Takes one pair of points into the worst of all; returns the gap there. */
static double compare_pair(const taut_join_side *a, const taut_join_side *b, const piece *p,
                           int step, taut_join *join)
{
    const double part = step == p->steps ? p->to : p->from + (p->to - p->from) * step / p->steps;
    const double ta = clamp_to_span(a->along, p->span_a, taut_join_parameter(a, part));
    double tb = taut_join_parameter(b, part);
    taut_spot sa, sb;

    taut_join_spot(a, p->span_a, ta, 3, &sa);
    const double x[3] = {sa.x[0].c[0], sa.x[1].c[0], sa.x[2].c[0]};
    if (!p->is_affine) {
        taut_join_foot(b, x, part, SAMPLES, &tb);
    }
    tb = clamp_to_span(b->along, p->span_b, tb);
    taut_join_spot(b, p->span_b, tb, 3, &sb);
    const taut_join_contact contact = taut_join_contact_of(&sa, &sb);
    join->c_order = contact.c < join->c_order ? contact.c : join->c_order;
    join->g_order = contact.g < join->g_order ? contact.g : join->g_order;
    join->max_tangent_angle = fmax(join->max_tangent_angle, contact.tangent_angle);
    join->max_normal_angle = fmax(join->max_normal_angle, contact.normal_angle);
    return taut_hypot(taut_hypot(x[0] - sb.x[0].c[0], x[1] - sb.x[1].c[0]), x[2] - sb.x[2].c[0]);
}

/* Along the whole edge; angles and orders go to *join, the largest gap is returned. */
static double compare_along(const taut_join_side *a, const taut_join_side *b, int break_count,
                            const double *breaks, int is_affine, taut_join *join)
{
    const int degrees = taut_basis_local(a->along) + taut_basis_local(b->along);
    double gap = 0;

    join->c_order = join->g_order = 3;
    join->max_tangent_angle = join->max_normal_angle = nan("");
    for (int i = 0; i + 1 < break_count; i++) {
        const double middle = breaks[i] + (breaks[i + 1] - breaks[i]) / 2;
        const int steps = SAMPLES / (break_count - 1) + 1;
        piece p = {.from = breaks[i], .to = breaks[i + 1], .is_affine = is_affine};
        double ta = taut_join_parameter(a, middle), tb = taut_join_parameter(b, middle);
        p.span_a = taut_basis_span(a->along, ta);
        p.steps = steps > degrees ? steps : degrees;
        if (!is_affine) {
            double x[3];
            taut_join_position(a, ta, x);
            taut_join_foot(b, x, middle, SAMPLES, &tb);
        }
        p.span_b = taut_basis_span(b->along, tb);
        for (int step = 0; step <= p.steps; step++) {
            gap = fmax(gap, compare_pair(a, b, &p, step, join));
        }
    }
    return gap;
}

/* The largest distance of a point of b's edge from a's. */
static double gap_back(const taut_join_side *a, const taut_join_side *b)
{
    double gap = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        const double part = (double)i / SAMPLES;
        double x[3], t = 0;
        taut_join_position(b, taut_join_parameter(b, part), x);
        gap = fmax(gap, taut_join_foot(a, x, part, SAMPLES, &t));
    }
    return gap;
}

/* What a gap may be: 1e-9 of the larger net, or the rounding of the coordinates. */
static double gap_limit(const taut_join_side *a, const taut_join_side *b)
{
    const taut_join_side *sides[2] = {a, b};
    double size = 0, offset = 0;
    for (int s = 0; s < 2; s++) {
        const taut_surface *surface = sides[s]->surface;
        const double *points = taut_surface_points(surface);
        const double half = taut_half_size(taut_point_count(surface), points);
        size = fmax(size, ldexp(half, 1 - a->scale));
        for (int c = 0; c < 3; c++) {
            offset = fmax(offset, ldexp(fabs(points[c]), -a->scale));
        }
    }
    return taut_join_tolerance * size + 16 * DBL_EPSILON * offset;
}

/* Scales, direction, orders and angles. */
static taut_status judge_join(taut_join_side *a, taut_join_side *b, taut_join *join)
{
    const double limit = gap_limit(a, b);
    int break_count = 0, is_affine = 1;
    double *breaks = NULL;

    const double forward = taut_join_affine_gap(a, b, SAMPLES);
    b->sign_along = -1;
    const double backward = taut_join_affine_gap(a, b, SAMPLES);
    join->reversed = backward < forward;
    b->sign_along = join->reversed ? -1 : 1;
    breaks = common_breaks(a, b, &break_count);
    if (breaks == NULL) {
        return TAUT_NO_MEMORY;
    }
    join->max_gap = compare_along(a, b, break_count, breaks, is_affine, join);
    if (join->max_gap > limit) {
        is_affine = 0;
        join->max_gap = compare_along(a, b, break_count, breaks, is_affine, join);
        join->max_gap = fmax(join->max_gap, gap_back(a, b));
        join->c_order = 0;
    }
    if (!(join->max_gap <= limit)) {
        join->c_order = join->g_order = -1;
    } else if (isnan(join->max_normal_angle)) {
        join->g_order = 0; /* no normals to tell more */
    }
    join->kind = TAUT_JOIN_CHECK;
    join->gap_bound = nan("");
    const taut_status status = is_affine && join->c_order >= 0
                                   ? taut_join_prove(a, b, break_count, breaks, limit, join)
                                   : TAUT_OK;
    taut_free(breaks);
    return status;
}

/* Sides whose scales are shared. TAUT_NO_MEMORY. */
static taut_status measure_sides(taut_join_side sides[2], taut_join *join)
{
    const taut_status status = judge_join(&sides[0], &sides[1], join);
    return status == TAUT_OK ? taut_join_is_one_surface(&sides[0], &sides[1], &join->one_surface)
                             : status;
}

taut_status taut_join_measure_with(const taut_surface *a, taut_edge edge_a, const taut_surface *b,
                                   taut_edge edge_b, const taut_join_options *options,
                                   taut_join *join, taut_error *error)
{
    taut_pulse pulse = {.monitor = options != NULL ? &options->monitor : NULL,
                        .what = "measuring",
                        .done = taut_none};
    taut_join made;
    taut_join_side sides[2];

    if (a == NULL || b == NULL || join == NULL || taut_edge_name(edge_a)[0] == '\0' ||
        taut_edge_name(edge_b)[0] == '\0') {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a join needs two surfaces and an edge of each: u0, u1, v0 or v1");
    }
    sides[0] = side_of(a, edge_a, 1);
    sides[1] = side_of(b, edge_b, 0);
    share_scales(sides);
    sides[0].pulse = sides[1].pulse = &pulse;
    const taut_status status =
        taut_pulse_report(&pulse) ? TAUT_INTERRUPTED : measure_sides(sides, &made);
    if (taut_pulse_is_stopped(&pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    made.max_gap = ldexp(made.max_gap, sides[0].scale);
    made.gap_bound = ldexp(made.gap_bound, sides[0].scale);
    *join = made;
    return TAUT_OK;
}

taut_status taut_join_measure(const taut_surface *a, taut_edge edge_a, const taut_surface *b,
                              taut_edge edge_b, taut_join *join, taut_error *error)
{
    return taut_join_measure_with(a, edge_a, b, edge_b, NULL, join, error);
}

taut_status taut_join_gap(const taut_surface *a, taut_edge edge_a, const taut_surface *b,
                          taut_edge edge_b, int reversed, double *gap)
{
    taut_join_side sides[2] = {side_of(a, edge_a, 1), side_of(b, edge_b, 0)};
    taut_join join = {.c_order = 0, .gap_bound = nan("")};
    int break_count = 0;

    share_scales(sides);
    sides[1].sign_along = reversed ? -1 : 1;
    double *breaks = common_breaks(&sides[0], &sides[1], &break_count);
    if (breaks == NULL) {
        return TAUT_NO_MEMORY;
    }
    const taut_status status =
        taut_join_prove(&sides[0], &sides[1], break_count, breaks, INFINITY, &join);
    taut_free(breaks);
    *gap = ldexp(join.gap_bound, sides[0].scale);
    return status;
}

void taut_join_record(const taut_join *join, taut_record *record)
{
    taut_record_add_number(record, "max_gap", join->max_gap);
    taut_record_add_number(record, "max_tangent_angle", join->max_tangent_angle);
    taut_record_add_number(record, "max_normal_angle", join->max_normal_angle);
    taut_record_add_number(record, "c_order", join->c_order);
    taut_record_add_number(record, "g_order", join->g_order);
    taut_record_add_text(record, "kind", join->kind == TAUT_JOIN_BOUND ? "bound" : "check");
    if (join->kind == TAUT_JOIN_BOUND) {
        taut_record_add_number(record, "gap_bound", join->gap_bound);
    }
    taut_record_add_bool(record, "reversed", join->reversed);
    if (join->one_surface >= 0) {
        taut_record_add_bool(record, "one_surface", join->one_surface);
    }
}
