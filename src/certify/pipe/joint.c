/* joint.c -- do the surfaces meet at the joints of a pipe?
 *
 *   joint1, joint2  along both edges: the larger of gap over radius and sine between the normals
 *   curvature1, -2  the jump of the principal curvatures, times the radius,
 *
 *     H = (E N - 2 F M + G L) / (2 (E G - F^2)),   K = (L N - M^2) / (E G - F^2)
 *     H +- sqrt(H^2 - K)
 *
 * of both surfaces at each place of the ring they share, first looked at in places; where these
 * show no jump, both second forms are bounded against the cylinder's by coefficients. Where tangent planes agree along a ring,
 * only the curvature across it can differ, so that equal principal curvatures are an equal second
 * form.
 *
 * Derivatives at an edge u0 or u1 are summed from differences of points. With
 * c_i(v) = sum_j R_j(v) p_ij the rings, which have the same weights, and e the ring at the edge,
 * sum N_i = 1 makes
 *
 *     x_u = sum_i N_i' (c_i - c_e),   x_uu = sum_i N_i'' (c_i - c_e)
 *     c_i - c_e = sum_j R_j (p_ij - p_ej)
 *
 * whose rounding is that of differences of points that are near each other: summed with the points
 * themselves it would be that of their coordinates, over a first ring that may be very near.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/sweep.h"
#include "core/memory.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { AROUND = 96, LOCAL = 10 /* functions alive on a span, at most */ };
static const double weights_rounded = 4 * DBL_EPSILON;
static const double gap_most = 1e-6; /* over the radius: no limit is larger */

/* R_j and R_j' on the span of v. */
typedef struct ring_functions {
    int first, count;
    double r[2][LOCAL];
} ring_functions;

static void evaluate_ring(const taut_surface *s, int row, double v, ring_functions *out)
{
    const taut_basis *basis = taut_surface_v(s);
    const double *weights = taut_surface_weights(s);
    const int span = taut_basis_span(basis, v), nv = taut_basis_count(basis);
    double sum[2] = {0, 0};
    out->count = taut_basis_degree(basis) + 1;
    out->first = taut_basis_first(basis, span);
    double n[2 * LOCAL];
    taut_basis_eval(basis, span, v, 1, n);
    for (int j = 0; j < out->count; j++) {
        const double w = weights != NULL ? weights[row * nv + out->first + j] : 1;
        for (int k = 0; k < 2; k++) {
            out->r[k][j] = w * n[k * out->count + j];
            sum[k] += out->r[k][j];
        }
    }
    for (int j = 0; j < out->count; j++) {
        out->r[0][j] /= sum[0];
        out->r[1][j] = (out->r[1][j] - out->r[0][j] * sum[1]) / sum[0];
    }
}

/* Do both rings have the same weights? */
static int have_same_weights(const taut_surface *s, int a, int b)
{
    const double *weights = taut_surface_weights(s);
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(s));
    return weights == NULL ||
           memcmp(weights + (size_t)a * nv, weights + (size_t)b * nv, nv * sizeof *weights) == 0;
}

void taut_pipe_edge_eval(const taut_surface *s, int last, double v, int order, double (*d)[3])
{
    const taut_basis *basis = taut_surface_u(s);
    const int nu = taut_basis_count(basis), nv = taut_basis_count(taut_surface_v(s));
    const int span = last ? taut_basis_span_count(basis) - 1 : 0, edge = last ? nu - 1 : 0;
    const int count = taut_basis_degree(basis) + 1, first = taut_basis_first(basis, span);
    const double u = last ? taut_basis_hi(basis) : taut_basis_lo(basis);
    const double *points = taut_surface_points(s);
    double n[3 * LOCAL], sums[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; /* x_u, x_uu, x_uv */
    ring_functions around;

    taut_surface_eval(s, u, v, order, d[0]);
    if (count < 2 || count > LOCAL || taut_basis_degree(taut_surface_v(s)) + 1 > LOCAL ||
        taut_basis_degree(taut_surface_v(s)) < 1) {
        return;
    }
    evaluate_ring(s, edge, v, &around);
    taut_basis_eval(basis, span, u, order, n);
    for (int a = 0; a < count; a++) {
        const double first_part = n[count + a], second = order > 1 ? n[2 * count + a] : 0;
        if (first + a == edge || (first_part == 0 && second == 0)) {
            continue;
        }
        if (!have_same_weights(s, first + a, edge)) {
            return;
        }
        for (int j = 0; j < around.count; j++) {
            const double *p = points + 3 * ((first + a) * nv + around.first + j);
            double way[3];
            taut_difference(p, points + 3 * (edge * nv + around.first + j), way);
            taut_add_scaled(first_part * around.r[0][j], way, sums[0]);
            taut_add_scaled(second * around.r[0][j], way, sums[1]);
            taut_add_scaled(first_part * around.r[1][j], way, sums[2]);
        }
    }
    memcpy(d[TAUT_XU], sums[0], sizeof sums[0]);
    if (order > 1) {
        memcpy(d[TAUT_XUU], sums[1], sizeof sums[1]);
        memcpy(d[TAUT_XUV], sums[2], sizeof sums[2]);
    }
}

/* The ring at an edge u0 (last 0) or u1 of a surface, and the ways along the flow from it to the
 * next one, or from that to it: x_u at the edge is a multiple of sum R_j way_j. */
typedef struct joint_edge {
    const taut_surface *surface;
    const double *ring, *weights; /* weights may be NULL */
    double (*ways)[3];
    int count;
    int exponent;    /* 2^exponent is about the ring's size: coordinates are of unit size over it */
    double sideways; /* what rounding of control points moves them by across the axis */
    double unlike;   /* how far rounding of the next ring's weights moves the ways, at most */
} joint_edge;

/* By how much the weights of ring b are no multiple of those of ring a, over themselves. */
static double unlike_weights(const taut_surface *s, int a, int b)
{
    const double *weights = taut_surface_weights(s);
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(s));
    const double *wa = weights + (size_t)a * nv, *wb = weights + (size_t)b * nv;
    double worst = 0;
    for (size_t j = 0; weights != NULL && j < nv; j++) {
        worst = taut_certify_max(worst, fabs((wb[j] / wb[0]) / (wa[j] / wa[0]) - 1));
    }
    return worst;
}

/* Of the blend's ring, for both: a radius that is told may be far from it, and squares out of range. */
static int exponent_of(const taut_pipe_parts *parts, int side)
{
    const int nv = taut_basis_count(taut_surface_v(parts->blend));
    const int row = side == 1 ? taut_basis_count(taut_surface_u(parts->blend)) - 1 : 0;
    const double *ring = taut_surface_points(parts->blend) + (size_t)row * 3 * (size_t)nv;
    double wide = 0;
    for (int k = 3; k < 3 * nv; k++) {
        wide = fmax(wide, fabs(ring[k] - ring[k % 3]));
    }
    return wide > 0 && isfinite(wide) ? ilogb(wide) : 0;
}

static int edge_of(const taut_pipe_parts *parts, int side, const taut_surface *surface, int last,
                   taut_arena *arena, joint_edge *edge)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface)), row = last ? nu - 1 : 0;
    const double *points = taut_surface_points(surface), *weights = taut_surface_weights(surface);
    const double *ring = points + (size_t)row * 3 * (size_t)nv;
    const double *next = ring + (last ? -3 * nv : 3 * nv);
    double changes[3] = {0, 0, 0};
    *edge = (joint_edge){.surface = surface,
                         .ring = ring,
                         .weights = weights != NULL ? weights + (size_t)row * (size_t)nv : NULL,
                         .ways = taut_arena_take(arena, (size_t)nv, sizeof *edge->ways),
                         .count = nv,
                         .exponent = exponent_of(parts, side)};
    if (edge->ways == NULL) {
        return 0;
    }
    for (int j = 0; j < 3 * nv; j++) {
        const double way = last ? ring[j] - next[j] : next[j] - ring[j];
        edge->ways[j / 3][j % 3] = way;
        changes[j % 3] = fmax(changes[j % 3], fabs(way));
    }
    edge->sideways = taut_pipe_sideways(parts, side, changes);
    if (have_same_weights(surface, row, last ? nu - 2 : 1)) {
        return 1;
    }
    const double unlike = unlike_weights(surface, row, last ? nu - 2 : 1);
    double wide = 0;
    for (int j = 1; j < nv; j++) {
        wide = fmax(wide, taut_distance(next, next + 3 * j));
    }
    edge->unlike = 2 * (unlike + 4 * DBL_EPSILON) * wide;
    return unlike <= weights_rounded;
}

/* Do both rings have the same functions around? */
static int are_alike(const joint_edge *a, const joint_edge *b)
{
    const taut_basis *v = taut_surface_v(a->surface), *w = taut_surface_v(b->surface);
    if (!taut_basis_equal(v, w)) {
        return 0;
    }
    for (int j = 0; j < a->count; j++) {
        if ((a->weights != NULL ? a->weights[j] : 1) != (b->weights != NULL ? b->weights[j] : 1)) {
            return 0;
        }
    }
    return 1;
}

/* Numerators of a curve's value and derivative, w P and w (w P)' - w' w P, on span j of v; the
 * curve's points are vectors around. */
static void ring_fields(taut_arena *arena, const joint_edge *e, const double (*points)[3],
                        const double origin[3], int j, taut_field value[4], taut_field slope[3])
{
    static const double none[3] = {0, 0, 0};
    taut_curve *curve = NULL;
    taut_field w_slope;
    memset(value, 0, 4 * sizeof *value);
    memset(slope, 0, 3 * sizeof *slope);
    const taut_status status =
        taut_curve_new("", taut_surface_v(e->surface), &points[0][0], e->weights, &curve, NULL);
    if (status == TAUT_OK) {
        (void)taut_field_of_curve(arena, curve, j, origin != NULL ? origin : none, e->exponent,
                                  value, NULL);
    } else if (status == TAUT_NO_MEMORY) {
        (void)taut_arena_keep(arena, NULL, taut_free); /* so that its status tells */
    }
    taut_curve_free(curve);
    w_slope = taut_field_du(arena, &value[3]);
    for (int k = 0; k < 3; k++) {
        const taut_field du = taut_field_du(arena, &value[k]);
        const taut_field x = taut_field_product(arena, &du, &value[3]);
        const taut_field y = taut_field_product(arena, &value[k], &w_slope);
        slope[k] = taut_field_difference(arena, &x, &y);
    }
}

/* The least length of a vector of fields. */
static double shortest(taut_arena *arena, const taut_field f[3])
{
    const taut_field square = taut_field_dot(arena, f, f);
    const double least = taut_field_low(&square);
    return least > 0 ? sqrt(least) : 0;
}

/* What is bounded along a joint. */
typedef struct joint_bound {
    double upright; /* the least sine between ring and axis */
    double turned;  /* the largest angle between tangents of both rings */
    double lean[2]; /* the largest sine between each normal and that of the cylinder there, */
} joint_bound;

/* The largest | det(A, d, T) | |T| over |A x T| |d x T|: how far the normal A x T leans from
 * d x T. */
static double lean_on_span(taut_arena *arena, const joint_edge *e, int j, const taut_field axis[3],
                           const taut_field slope[3])
{
    taut_field way[4], unused[3], normal[3], upright[3], twice[3];
    ring_fields(arena, e, (const double(*)[3])e->ways, NULL, j, way, unused);
    taut_field_cross(arena, way, slope, normal);
    taut_field_cross(arena, axis, slope, upright);
    taut_field_cross(arena, normal, upright, twice);
    return taut_pipe_longest(twice) / (shortest(arena, normal) * shortest(arena, upright));
}

static void bound_on_span(taut_arena *arena, const joint_edge edges[2], const double (*gaps)[3],
                          const double d[3], int j, joint_bound *b)
{
    taut_field value[4], slope[3], gap[4], gap_slope[3], axis[3], along;
    ring_fields(arena, &edges[0], (const double(*)[3])(const void *)edges[0].ring, edges[0].ring, j,
                value, slope);
    ring_fields(arena, &edges[0], gaps, NULL, j, gap, gap_slope);
    for (int k = 0; k < 3; k++) {
        axis[k] = taut_field_constant(arena, d[k]);
    }
    along = taut_field_dot(arena, axis, slope);
    const double length = shortest(arena, slope), part = taut_field_largest(&along) / length;
    b->upright = taut_certify_min(b->upright, sqrt(fmax(1 - part * part, 0)));
    b->turned = taut_certify_max(b->turned, taut_pipe_longest(gap_slope) / length);
    for (int i = 0; i < 2; i++) {
        b->lean[i] = taut_certify_max(b->lean[i], lean_on_span(arena, &edges[i], j, axis, slope));
    }
}

/* What the ways lean from the axis by, at most: the largest part across it over the least along it.
 */
static double lean_of_ways(const joint_edge *e, const double d[3], double *least)
{
    double most = 0;
    *least = INFINITY;
    for (int j = 0; j < e->count; j++) {
        double across[3];
        taut_cross(e->ways[j], d, across);
        most = fmax(most, taut_norm(across));
        *least = fmin(*least, taut_dot(e->ways[j], d));
    }
    return *least > 0 ? most / *least : INFINITY;
}

/* The rings' convex combinations are no farther apart than their points; and each normal leans from
 * that of the cylinder by no more than the ways to the next ring do from the axis, over the sine
 * between ring and axis, or (where a frame turns about the axis) by what the coefficients of the
 * triple product show. */
static double bound_joint(const taut_pipe_parts *parts, int side, taut_arena *arena,
                          const joint_edge edges[2], double *noise)
{
    const double *d = parts->line.tangent[side];
    const int spans = taut_basis_span_count(taut_surface_v(edges[0].surface));
    joint_bound b = {.upright = 1};
    double gap = 0, sine = 0;
    double(*gaps)[3] = taut_arena_take(arena, (size_t)edges[0].count, sizeof *gaps);
    if (gaps == NULL) {
        return NAN;
    }
    for (int j = 0; j < edges[0].count; j++) {
        taut_difference(edges[0].ring + 3 * j, edges[1].ring + 3 * j, gaps[j]);
        gap = taut_certify_max(gap, taut_norm(gaps[j]));
    }
    for (int j = 0; j < spans; j++) {
        bound_on_span(arena, edges, (const double(*)[3])gaps, d, j, &b);
    }
    for (int i = 0; i < 2; i++) {
        double least = 0;
        const double lean = lean_of_ways(&edges[i], d, &least) / (b.upright * b.upright);
        sine += lean < b.lean[i] ? lean : b.lean[i];
        sine += edges[i].unlike > 0 ? edges[i].unlike / (least * b.upright) : 0;
        *noise += edges[i].sideways > 0 ? edges[i].sideways / fmax(least, 0) : 0;
        *noise += edges[i].unlike > 0 ? 2 * edges[i].unlike / (least * b.upright) : 0;
    }
    if (gap > gap_most * parts->radius) {
        *noise = 0; /* of normals: it explains no gap */
    }
    return taut_certify_max(gap / parts->radius, sine + b.turned / b.upright);
}

/* The largest distance of two edges over the radius that places show, at equal parts of what goes
 * around: enough to refuse rings that no proof compares, never to accept them. */
static double seen_gap(const taut_pipe_parts *parts, int side)
{
    const taut_surface *const surfaces[2] = {parts->blend, parts->pipes[side]};
    const int lasts[2] = {side == 1, side == 0};
    double gap = 0;
    for (int k = 0; k <= AROUND; k++) {
        double x[2][3];
        for (int i = 0; i < 2; i++) {
            const taut_basis *u = taut_surface_u(surfaces[i]), *v = taut_surface_v(surfaces[i]);
            const double lo = taut_basis_lo(v), hi = taut_basis_hi(v);
            taut_surface_eval(surfaces[i], lasts[i] ? taut_basis_hi(u) : taut_basis_lo(u),
                              k == AROUND ? hi : lo + (hi - lo) * k / AROUND, 0, x[i]);
        }
        gap = taut_certify_max(gap, taut_distance(x[0], x[1]) / parts->radius);
    }
    return gap;
}

taut_status taut_pipe_measure_joint(const taut_pipe_parts *parts, int side,
                                    taut_pipe_meeting *meeting)
{
    taut_arena *const arena = taut_arena_new();
    joint_edge edges[2];
    taut_status status = TAUT_OK;
    *meeting = (taut_pipe_meeting){.kind = TAUT_BOUND};
    const int is_known = edge_of(parts, side, parts->blend, side == 1, arena, &edges[0]) &&
                         edge_of(parts, side, parts->pipes[side], side == 0, arena, &edges[1]);
    if (is_known && are_alike(&edges[0], &edges[1])) {
        meeting->residual = bound_joint(parts, side, arena, edges, &meeting->noise);
    } else {
        meeting->residual = NAN;
        snprintf(meeting->where, sizeof meeting->where,
                 "the rings there have unlike functions around");
    }
    if (!isfinite(meeting->residual)) { /* no bound: what is seen may refuse it still */
        const double gap = seen_gap(parts, side);
        meeting->residual = gap > gap_most ? gap : meeting->residual;
    }
    meeting->noise += (8 * DBL_EPSILON + DBL_EPSILON * parts->size / parts->radius) *
                      parts->flatness * parts->flatness;
    status = taut_arena_status(arena);
    taut_arena_free(arena);
    return status;
}

taut_status taut_pipe_claim_joint(const taut_pipe_parts *parts, int side,
                                  taut_certificate *certificate)
{
    taut_pipe_meeting m;
    const taut_status status = taut_pipe_measure_joint(parts, side, &m);
    return status != TAUT_OK ? status
                             : taut_pipe_add_claim(side == 0 ? "joint1" : "joint2", TAUT_BOUND,
                                                   m.residual, 0, m.noise, m.where, certificate);
}

/* Both principal curvatures, the larger first, in units of 1 / radius; the sign is that of the
 * normal x_u x x_v. */
static void find_principal(const taut_surface *surface, int last, double v, double radius,
                           double curvatures[2])
{
    double d[6][3], normal[3], length = 0, h = 0, k = 0, root = 0;
    taut_pipe_edge_eval(surface, last, v, 2, d);
    for (int i = 0; i < 18; i++) {
        d[i / 3][i % 3] /= radius;
    }
    taut_cross(d[TAUT_XU], d[TAUT_XV], normal);
    length = taut_norm(normal);
    curvatures[0] = curvatures[1] = INFINITY;
    if (length > 0) {
        const double e = taut_dot(d[TAUT_XU], d[TAUT_XU]), f = taut_dot(d[TAUT_XU], d[TAUT_XV]);
        const double g = taut_dot(d[TAUT_XV], d[TAUT_XV]), square = length * length;
        const double l = taut_dot(normal, d[TAUT_XUU]) / length;
        const double m = taut_dot(normal, d[TAUT_XUV]) / length;
        const double n = taut_dot(normal, d[TAUT_XVV]) / length;
        h = (e * n - 2 * f * m + g * l) / (2 * square);
        k = (l * n - m * m) / square;
        root = sqrt(fmax(h * h - k, 0));
        curvatures[0] = h + root;
        curvatures[1] = h - root;
    }
}

/* Rounding s of three rings at right angles to the axis, the next one a leg away, changes the
 * curvature across by at most 4 s / leg^2 through x_uu and as much through the normal. */
static double noise_of(const taut_pipe_parts *parts, int side)
{
    const taut_surface *blend = parts->blend;
    const int nu = taut_basis_count(taut_surface_u(blend));
    const int nv = taut_basis_count(taut_surface_v(blend));
    const double *ring =
        taut_surface_points(blend) + (size_t)(side == 0 ? 0 : nu - 1) * 3 * (size_t)nv;
    const double *next =
        taut_surface_points(blend) + (size_t)(side == 0 ? 1 : nu - 2) * 3 * (size_t)nv;
    const double leg = taut_distance(ring, next);
    double changes[3] = {0, 0, 0}, rounding = 0;
    for (int j = 0; j < 3 * nv; j++) {
        changes[j % 3] = fmax(changes[j % 3], fabs(ring[j] - next[j]));
    }
    rounding = fmax(taut_pipe_sideways(parts, side, changes), DBL_EPSILON * parts->radius);
    /* curvatures of flat ellipses are as much larger, in units of 1 / radius */
    return (8 * DBL_EPSILON + 8 * rounding * parts->radius / (leg * leg)) * parts->flatness *
           parts->flatness;
}

/* The third ring from an edge, less what of it is along the second: way_j = (p2_j - p_j) - k way1_j,
 * with N', N'' of the second and of the third. 0: there is none, and x_uu is along x_u. -1: other
 * weights, or no memory. */
static int third_ring(const taut_pipe_parts *parts, int side, const joint_edge *e, int last,
                      taut_arena *arena, double (**ways)[3], double slopes[2])
{
    const taut_basis *u = taut_surface_u(e->surface);
    const int nu = taut_basis_count(u), count = taut_basis_degree(u) + 1;
    const int span = last ? taut_basis_span_count(u) - 1 : 0;
    const int row = last ? nu - 1 : 0, step = last ? -1 : 1, at = last ? count - 1 : 0;
    const double *d = parts->line.tangent[side], *third = e->ring + 6 * step * e->count;
    double n[3 * LOCAL], sums[2] = {0, 0};

    if (count < 2 || count > LOCAL) {
        return -1;
    }
    taut_basis_eval(u, span, last ? taut_basis_hi(u) : taut_basis_lo(u), 2, n);
    slopes[0] = fabs(n[count + at + step]);
    slopes[1] = count > 2 ? fabs(n[2 * count + at + 2 * step]) : 0;
    if (count == 2) {
        return 0;
    }
    *ways = taut_arena_take(arena, (size_t)e->count, sizeof **ways);
    if (*ways == NULL || !have_same_weights(e->surface, row, row + 2 * step)) {
        return -1;
    }
    for (int j = 0; j < e->count; j++) {
        taut_difference(third + 3 * j, e->ring + 3 * j, (*ways)[j]);
        sums[0] += taut_dot((*ways)[j], d);
        sums[1] += taut_dot(e->ways[j], d);
    }
    for (int j = 0; j < e->count; j++) {
        taut_add_scaled(-sums[0] / sums[1], e->ways[j], (*ways)[j]);
    }
    return 1;
}

/* The largest length of vectors. */
static double longest_way(const double (*ways)[3], int count)
{
    double most = 0;
    for (int j = 0; j < count; j++) {
        most = taut_certify_max(most, taut_norm(ways[j]));
    }
    return most;
}

/* What is known of the rings about an edge. */
typedef struct edge_rings {
    const joint_edge *edge;
    double (*third)[3]; /* NULL: none */
    double slopes[2];   /* N' and N'' */
    double rounding[2]; /* of the ways to the second and to the third */
    double lean;        /* of the normals from the cylinder's, at most */
} edge_rings;

/* How far the second form is from that of the cylinder, at most, over span j. With A the ways, S the
 * ring's slope, W the third ring's ways, n, f_2 along the ring and f_1 = n x f_2 across:
 *
 *     II(f_2, f_2) <= k = |x_vv| / |x_v|^2,   it differs by no more than the normals times k
 *     II(f_1, f_2)  = det(A, S, A') w / |A x S|^2 - (Q/P) k,   Q/P = A . S / |A x S|
 *     II(f_1, f_1)  = (N''/N'^2) det(A, S, W) |S|^2 w / |A x S|^3 - 2 (Q/P) II(f_1, f_2) - (Q/P)^2 k
 */
static double form_on_span(taut_arena *arena, const edge_rings *r, int j)
{
    const joint_edge *e = r->edge;
    const double(*ring)[3] = (const double(*)[3])(const void *)e->ring;
    taut_field x[4], slope[3], way[4], turn[3], third[4], unused[3], normal[3], second[3];
    double bend = 0;
    ring_fields(arena, e, ring, e->ring, j, x, slope);
    ring_fields(arena, e, (const double(*)[3])e->ways, NULL, j, way, turn);
    taut_field_cross(arena, way, slope, normal);
    const taut_field w_slope = taut_field_du(arena, &x[3]);
    for (int k = 0; k < 3; k++) {
        const taut_field du = taut_field_du(arena, &slope[k]);
        const taut_field a = taut_field_product(arena, &du, &x[3]);
        const taut_field b = taut_field_product(arena, &slope[k], &w_slope);
        second[k] = taut_field_combine(arena, 1, &a, -2, &b);
    }
    const double high = taut_field_high(&x[3]), most = taut_pipe_longest(slope);
    const double least = shortest(arena, slope), upright = shortest(arena, normal);
    const double unit = ldexp(1, -e->exponent),
                 k = taut_pipe_longest(second) * high / (least * least);
    const taut_field along = taut_field_dot(arena, way, slope);
    const taut_field twist = taut_field_dot(arena, normal, turn);
    const double part = taut_field_largest(&along) / upright;
    /* the ways' own rounding turns with the functions around: twice their degree at most */
    const double turned = 2 * LOCAL * r->rounding[0] * unit * high * high / upright;
    const double mixed =
        taut_field_largest(&twist) * high / (upright * upright) + turned * high + part * k;
    if (r->third != NULL) {
        ring_fields(arena, e, (const double(*)[3])r->third, NULL, j, third, unused);
        const taut_field off = taut_field_dot(arena, normal, third);
        bend = (taut_field_largest(&off) / upright + r->rounding[1] * unit * high) * r->slopes[1] /
               (r->slopes[0] * r->slopes[0]) * most * most * high / (upright * upright);
    }
    const double across = bend + 2 * part * mixed + part * part * k, lean = 1.5 * r->lean * k;
    return sqrt(across * across + 2 * mixed * mixed + lean * lean) * (1 + 256 * DBL_EPSILON);
}

/* The largest difference of principal curvatures, times the radius: no more than both second forms
 * differ from the cylinder's, as eigenvalues of symmetric matrices do. NAN: not bounded. */
static double bound_curvatures(const taut_pipe_parts *parts, int side, taut_arena *arena)
{
    const int lasts[2] = {side == 1, side == 0};
    const double *d = parts->line.tangent[side];
    joint_edge edges[2];
    edge_rings rings[2] = {{.edge = &edges[0]}, {.edge = &edges[1]}};
    double worst = 0;
    if (!edge_of(parts, side, parts->blend, lasts[0], arena, &edges[0]) ||
        !edge_of(parts, side, parts->pipes[side], lasts[1], arena, &edges[1]) ||
        !are_alike(&edges[0], &edges[1]) ||
        memcmp(edges[0].ring, edges[1].ring, 3 * (size_t)edges[0].count * sizeof(double)) != 0) {
        return NAN;
    }
    for (int i = 0; i < 2; i++) {
        edge_rings *const r = &rings[i];
        const int is_known =
            third_ring(parts, side, &edges[i], lasts[i], arena, &r->third, r->slopes);
        double least = 0;
        r->lean = lean_of_ways(&edges[i], d, &least);
        if (is_known < 0 || !(least > 0)) {
            return NAN;
        }
        r->rounding[0] =
            DBL_EPSILON * longest_way((const double(*)[3])edges[i].ways, edges[i].count);
        r->rounding[1] =
            is_known ? 4 * DBL_EPSILON * longest_way((const double(*)[3])r->third, edges[i].count) +
                           4 * r->rounding[0]
                     : 0;
    }
    for (int j = 0; j < taut_basis_span_count(taut_surface_v(parts->blend)); j++) {
        joint_bound b = {.upright = 1};
        bound_on_span(arena, edges, (const double(*)[3])edges[0].ways, d, j, &b);
        double sum = 0;
        for (int i = 0; i < 2; i++) {
            edge_rings r = rings[i];
            const double lean = r.lean / (b.upright * b.upright);
            r.lean = lean < b.lean[i] ? lean : b.lean[i];
            sum += form_on_span(arena, &r, j);
        }
        worst = taut_certify_max(worst, sum);
    }
    return worst * ldexp(parts->radius, -edges[0].exponent);
}

taut_status taut_pipe_measure_curvatures(const taut_pipe_parts *parts, int side,
                                         taut_pipe_meeting *meeting)
{
    const taut_basis *v = taut_surface_v(parts->blend), *w = taut_surface_v(parts->pipes[side]);

    *meeting = (taut_pipe_meeting){.noise = noise_of(parts, side), .kind = TAUT_CHECK};
    for (int k = 0; k <= AROUND; k++) {
        const double part = (double)k / AROUND;
        const double at = taut_basis_lo(v) + (taut_basis_hi(v) - taut_basis_lo(v)) * part;
        const double too = taut_basis_lo(w) + (taut_basis_hi(w) - taut_basis_lo(w)) * part;
        double a[2], b[2], jump = 0;
        find_principal(parts->blend, side == 1, at, parts->radius, a);
        find_principal(parts->pipes[side], side == 0, too, parts->radius, b);
        jump = fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1]));
        if (!(jump <= meeting->residual) && !isnan(meeting->residual)) {
            meeting->residual = jump;
            snprintf(meeting->where, sizeof meeting->where, "v = %.6g", at);
        }
    }
    if (meeting->residual <= taut_pipe_held(meeting->noise)) { /* else it is refused already */
        taut_arena *const arena = taut_arena_new();
        const double bound = bound_curvatures(parts, side, arena);
        const taut_status status = taut_arena_status(arena);
        taut_arena_free(arena);
        meeting->kind = bound <= taut_pipe_held(meeting->noise) ? TAUT_BOUND : TAUT_CHECK;
        return status;
    }
    return TAUT_OK;
}

taut_status taut_pipe_claim_curvature(const taut_pipe_parts *parts, int side,
                                      taut_certificate *certificate)
{
    taut_pipe_meeting m;
    const taut_status status = taut_pipe_measure_curvatures(parts, side, &m);
    return status != TAUT_OK ? status
                             : taut_pipe_add_claim(side == 0 ? "curvature1" : "curvature2", m.kind,
                                                   m.residual, 0, m.noise, m.where, certificate);
}
