/* joint.c -- do the surfaces meet at the joints of a pipe?
 *
 *   joint1, joint2  along both edges: the larger of gap over radius and sine between the normals
 *   curvature1, -2  the jump of the principal curvatures, times the radius,
 *
 *     H = (E N - 2 F M + G L) / (2 (E G - F^2)),   K = (L N - M^2) / (E G - F^2)
 *     H +- sqrt(H^2 - K)
 *
 * of both surfaces at each place of the ring they share. Where tangent planes agree along a ring,
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
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { AROUND = 96, LOCAL = 10 /* functions alive on a span, at most */ };

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

/* The sine between two unit normals; 1 where they look apart or one is missing. */
static double sine_between(const double a[3], const double b[3])
{
    double across[3];
    taut_cross(a, b, across);
    return taut_dot(a, b) > 0.5 ? taut_norm(across) : 1;
}

/* An edge u0 (edge 0) or u1 of a surface, and what rounding does to its tangents across. */
typedef struct joint_edge {
    const taut_surface *surface;
    int last;
    double sideways; /* of control points */
    double leg;      /* times |x_u|: the distance to the next ring that makes it up */
} joint_edge;

static joint_edge edge_of(const taut_pipe_parts *parts, int side, const taut_surface *surface,
                          int last)
{
    const taut_basis *u = taut_surface_u(surface);
    const int nu = taut_basis_count(u), nv = taut_basis_count(taut_surface_v(surface));
    const int spans = taut_basis_span_count(u);
    const double *breaks = taut_basis_breaks(u), *points = taut_surface_points(surface);
    const double *ring = points + (size_t)(last ? nu - 1 : 0) * 3 * (size_t)nv;
    const double *next = points + (size_t)(last ? nu - 2 : 1) * 3 * (size_t)nv;
    double changes[3] = {0, 0, 0};
    for (int j = 0; j < 3 * nv; j++) {
        changes[j % 3] = fmax(changes[j % 3], fabs(ring[j] - next[j]));
    }
    return (joint_edge){
        .surface = surface,
        .last = last,
        .sideways = taut_pipe_sideways(parts, side, changes),
        .leg = (last ? breaks[spans] - breaks[spans - 1] : breaks[1] - breaks[0]) /
               fmax(1, taut_basis_degree(u)),
    };
}

/* The point and the unit normal at v; returns what rounding turns the normal by: only the part of
 * x_u at right angles to the ring holds it. */
static double evaluate_edge(const joint_edge *e, double v, double x[3], double normal[3])
{
    double d[3][3], around[3], across[3], length = 0;
    taut_pipe_edge_eval(e->surface, e->last, v, 1, d);
    memcpy(x, d[0], sizeof d[0]);
    taut_pipe_unit_normal(d[TAUT_XU], d[TAUT_XV], normal);
    length = taut_norm(d[TAUT_XV]);
    for (int k = 0; k < 3; k++) {
        around[k] = length > 0 ? d[TAUT_XV][k] / length : 0;
    }
    taut_cross(d[TAUT_XU], around, across);
    length = taut_norm(across) * e->leg;
    return e->sideways > 0 || !(length > 0) ? e->sideways / length : 0;
}

void taut_pipe_measure_joint(const taut_pipe_parts *parts, int side, taut_pipe_meeting *meeting)
{
    const joint_edge blend = edge_of(parts, side, parts->blend, side == 1);
    const joint_edge pipe = edge_of(parts, side, parts->pipes[side], side == 0);
    const taut_basis *v = taut_surface_v(blend.surface), *w = taut_surface_v(pipe.surface);
    double turned = 0;

    *meeting = (taut_pipe_meeting){.where = ""};
    for (int k = 0; k <= AROUND; k++) {
        double a[3], b[3], normal_a[3], normal_b[3], residual = 0;
        turned =
            fmax(turned, evaluate_edge(&blend, taut_pipe_parameter(v, k, AROUND), a, normal_a) +
                             evaluate_edge(&pipe, taut_pipe_parameter(w, k, AROUND), b, normal_b));
        residual = fmax(taut_distance(a, b) / parts->radius, sine_between(normal_a, normal_b));
        if (!(residual <= meeting->residual)) {
            meeting->residual = residual;
            snprintf(meeting->where, sizeof meeting->where, "v = %.6g",
                     taut_pipe_parameter(v, k, AROUND));
        }
    }
    meeting->noise = (4 * DBL_EPSILON + DBL_EPSILON * parts->size / parts->radius) *
                         parts->flatness * parts->flatness +
                     turned;
}

taut_status taut_pipe_claim_joint(const taut_pipe_parts *parts, int side,
                                  taut_certificate *certificate)
{
    taut_pipe_meeting m;
    taut_pipe_measure_joint(parts, side, &m);
    return taut_pipe_add_claim(side == 0 ? "joint1" : "joint2", m.residual, 0, m.noise, m.where,
                               certificate);
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

void taut_pipe_measure_curvatures(const taut_pipe_parts *parts, int side,
                                  taut_pipe_meeting *meeting)
{
    const taut_basis *v = taut_surface_v(parts->blend), *w = taut_surface_v(parts->pipes[side]);

    *meeting = (taut_pipe_meeting){.noise = noise_of(parts, side)};
    for (int k = 0; k <= AROUND; k++) {
        const double part = (double)k / AROUND;
        const double at = taut_basis_lo(v) + (taut_basis_hi(v) - taut_basis_lo(v)) * part;
        const double too = taut_basis_lo(w) + (taut_basis_hi(w) - taut_basis_lo(w)) * part;
        double a[2], b[2], jump = 0;
        find_principal(parts->blend, side == 1, at, parts->radius, a);
        find_principal(parts->pipes[side], side == 0, too, parts->radius, b);
        jump = fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1]));
        if (!(jump <= meeting->residual)) {
            meeting->residual = jump;
            snprintf(meeting->where, sizeof meeting->where, "v = %.6g", at);
        }
    }
}

taut_status taut_pipe_claim_curvature(const taut_pipe_parts *parts, int side,
                                      taut_certificate *certificate)
{
    taut_pipe_meeting m;
    taut_pipe_measure_curvatures(parts, side, &m);
    return taut_pipe_add_claim(side == 0 ? "curvature1" : "curvature2", m.residual, 0, m.noise,
                               m.where, certificate);
}
