/* curvature.c -- the jump of the principal curvatures across a joint, times the radius.
 *
 *     H = (E N - 2 F M + G L) / (2 (E G - F^2)),   K = (L N - M^2) / (E G - F^2),   H +- sqrt(H^2 -
 * K)
 *
 * of both surfaces at each place of the ring they share. Where tangent planes agree along a ring,
 * only the curvature across it can differ, so that equal principal curvatures are an equal second
 * form.
 */
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

enum { AROUND = 96 };

/* Both principal curvatures, the larger first, in units of 1 / radius; the sign is that of the
 * normal x_u x x_v. */
static void principal(const taut_surface *surface, int last, double v, double radius,
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

void taut_pipe_meet_curved(const taut_pipe_parts *parts, int side, taut_pipe_meeting *meeting)
{
    const taut_basis *v = taut_surface_v(parts->blend), *w = taut_surface_v(parts->pipes[side]);

    *meeting = (taut_pipe_meeting){.noise = noise_of(parts, side)};
    for (int k = 0; k <= AROUND; k++) {
        const double part = (double)k / AROUND;
        const double at = taut_basis_lo(v) + (taut_basis_hi(v) - taut_basis_lo(v)) * part;
        const double too = taut_basis_lo(w) + (taut_basis_hi(w) - taut_basis_lo(w)) * part;
        double a[2], b[2], jump = 0;
        principal(parts->blend, side == 1, at, parts->radius, a);
        principal(parts->pipes[side], side == 0, too, parts->radius, b);
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
    taut_pipe_meet_curved(parts, side, &m);
    return taut_pipe_add_claim(side == 0 ? "curvature1" : "curvature2", m.residual, 0, m.noise,
                               m.where, certificate);
}
