#include "construct/asymptotic/conditions.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/dense.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

static const double least_sine = 1e-6;     /* of the angle between legs: the limit of `regular` */
static const double off_plane = 1e-10;     /* sine of a second derivative with the tangent plane */
static const double torsion_match = 1e-10; /* relative */
static const double least_bend = 1e-12;    /* sine below which an end has no osculating plane */

/* What rounding of the points does to directions made from the three first points at an end: their
 * triangle is `height` high. */
static double rounding(const taut_quad *quad, int edge, int end)
{
    double leg[3], arm[3], bend[3];
    taut_quad_leg(quad, edge, end, leg);
    taut_difference(taut_quad_point(quad, edge, end, 2), taut_quad_point(quad, edge, end, 0), arm);
    taut_cross(leg, arm, bend);
    return 32 * taut_quad_rounding(quad) * taut_norm(leg) / taut_norm(bend);
}

/* The leg of the partner at this end. */
static void partner_leg(const taut_quad *quad, int edge, int end, double leg[3])
{
    const taut_quad_meeting *const f = &taut_quad_partner[edge][end];
    taut_quad_leg(quad, f->edge, f->end, leg);
}

int taut_quad_side(const taut_quad *quad, int edge, int end)
{
    double leg[3], other[3], arm[3], bend[3], plane[3];
    if (quad->edges[edge].straight) {
        return 0;
    }
    taut_quad_leg(quad, edge, end, leg);
    partner_leg(quad, edge, end, other);
    taut_difference(taut_quad_point(quad, edge, end, 2), taut_quad_point(quad, edge, end, 0), arm);
    taut_cross(leg, arm, bend);
    taut_cross(leg, other, plane);
    return taut_dot(bend, plane) > 0 ? 1 : -1;
}

int taut_quad_sigma(const taut_quad *quad, int edge, int end)
{
    const int runs_with_u = edge == TAUT_ASYMPTOTIC_V0 || edge == TAUT_ASYMPTOTIC_V1;
    const int side = taut_quad_side(quad, edge, end);
    return runs_with_u ? side : -side;
}

/* (C1) */
static taut_status check_legs(const taut_quad *quad, int c, taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    double a[3], b[3], normal[3], sine = 0.0;
    taut_quad_leg(quad, m[0].edge, m[0].end, a);
    taut_quad_leg(quad, m[1].edge, m[1].end, b);
    for (int k = 0; k < 2; k++) {
        if (!(taut_norm(k == 0 ? a : b) > 0)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-leg", "/curves", 0.0, taut_none,
                             "the control point of %s beside corner %s lies on it: the curve has "
                             "no leg there",
                             taut_asymptotic_edge_name(m[k].edge), taut_asymptotic_corner_name(c));
        }
    }
    taut_cross(a, b, normal);
    sine = taut_norm(normal) / (taut_norm(a) * taut_norm(b));
    if (!(sine >= least_sine)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "parallel-legs", "", sine, least_sine,
                         "the legs of %s and %s are parallel at corner %s (sine %.3g): they must "
                         "span the tangent plane",
                         taut_asymptotic_edge_name(m[0].edge), taut_asymptotic_edge_name(m[1].edge),
                         taut_asymptotic_corner_name(c), sine);
    }
    return TAUT_OK;
}

/* (C2), and that each curved edge has an osculating plane at its ends. */
static taut_status check_plane(const taut_quad *quad, int c, taut_error *error)
{
    double leg[2][3], normal[3];
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const m = &taut_quad_corner[c][k];
        taut_quad_leg(quad, m->edge, m->end, leg[k]);
    }
    taut_cross(leg[0], leg[1], normal);
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const m = &taut_quad_corner[c][k];
        double arm[3], bend[3], off = 0.0;
        if (quad->edges[m->edge].straight) {
            continue;
        }
        /* of points, not of derivatives, in which weights cancel */
        taut_difference(taut_quad_point(quad, m->edge, m->end, 2),
                        taut_quad_point(quad, m->edge, m->end, 0), arm);
        taut_cross(leg[k], arm, bend);
        if (!(taut_norm(bend) > least_bend * taut_norm(leg[k]) * taut_norm(arm))) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-curvature", "", taut_norm(bend),
                             taut_none,
                             "edge %s has curvature 0 at corner %s and is not straight: it has no "
                             "osculating plane there",
                             taut_asymptotic_edge_name(m->edge), taut_asymptotic_corner_name(c));
        }
        off = fabs(taut_dot(bend, leg[1 - k])) / (taut_norm(bend) * taut_norm(leg[1 - k]));
        if (!(off <= off_plane + rounding(quad, m->edge, m->end))) {
            return taut_fail(error, TAUT_NO_SOLUTION, "osculating-plane", "", off, off_plane,
                             "the osculating plane of %s at corner %s does not hold the tangent "
                             "of %s: the sine of the angle between them is %.3g",
                             taut_asymptotic_edge_name(m->edge), taut_asymptotic_corner_name(c),
                             taut_asymptotic_edge_name(taut_quad_corner[c][1 - k].edge), off);
        }
    }
    return TAUT_OK;
}

static int is_linked(const taut_quad *quad, int c)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    return !quad->edges[m[0].edge].straight && !quad->edges[m[1].edge].straight;
}

/* The factors on inner weights of least sum of squared logarithms that make torsions opposite at
 * all corners: log|tau| is linear in them,
 *     log|tau(0)| = log w_0 + log w_3 - log w_1 - log w_2 + const.
 * factors[edge][j - 1] for w_j. Returns 0 if no weights do. */
static int nearest_weights(const taut_quad *quad, double factors[4][TAUT_QUAD_POINTS])
{
    const int n = quad->degree, per_edge = n - 1;
    double a[4 * 4 * TAUT_QUAD_POINTS] = {0}, b[4] = {0}, x[4 * TAUT_QUAD_POINTS];
    int rows = 0;
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        double torsion[2];
        if (!is_linked(quad, c)) {
            continue;
        }
        for (int k = 0; k < 2; k++) {
            torsion[k] = taut_quad_torsion(quad, m[k].edge, m[k].end);
            for (int step = 1; step <= 3; step++) {
                const int j = m[k].end == 0 ? step : n - step;
                if (j >= 1 && j <= n - 1) {
                    a[(m[k].edge * per_edge + j - 1) * 4 + rows] +=
                        (step == 3 ? 1.0 : -1.0) * (k == 0 ? 1.0 : -1.0);
                }
            }
        }
        if (!(torsion[0] * torsion[1] < 0)) {
            return 0;
        }
        b[rows++] = taut_log(-torsion[1] / torsion[0]);
    }
    (void)taut_least_norm(4, 4 * per_edge, a, b, 1e-9, x, NULL);
    for (int row = 0; row < 4; row++) {
        double miss = -b[row];
        for (int j = 0; j < 4 * per_edge; j++) {
            miss += a[4 * j + row] * x[j];
        }
        if (!(fabs(miss) <= 1e-9)) {
            return 0;
        }
    }
    for (int e = 0; e < 4; e++) {
        for (int j = 0; j < per_edge; j++) {
            factors[e][j] = taut_exp(x[e * per_edge + j]);
        }
    }
    return 1;
}

/* "v0 1.01 0.99 1, ..." */
static void factors_text(const taut_quad *quad, double factors[4][TAUT_QUAD_POINTS], char *text,
                         size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int e = 0; e < 4 && used < size; e++) {
        used += (size_t)snprintf(text + used, size - used, " %s", taut_asymptotic_edge_name(e));
        for (int j = 0; j < quad->degree - 1 && used < size; j++) {
            used += (size_t)snprintf(text + used, size - used, " %.15g", factors[e][j]);
        }
    }
}

/* Of the determinant of the first three differences, which close to an inflection is as small as
 * the square of the height, and twice of the height below it. */
double taut_quad_torsion_rounding(const taut_quad *quad, int edge, int end, double t)
{
    const int n = quad->degree;
    const double factor =
        (n - 2.0) / n * taut_quad_weight(quad, edge, end, 0) *
        taut_quad_weight(quad, edge, end, 3) /
        (taut_quad_weight(quad, edge, end, 1) * taut_quad_weight(quad, edge, end, 2));
    double d[3][3], size[3], normal[3];
    for (int j = 0; j < 3; j++) {
        taut_difference(taut_quad_point(quad, edge, end, j + 1),
                        taut_quad_point(quad, edge, end, 0), d[j]);
        size[j] = taut_norm(d[j]);
    }
    taut_cross(d[0], d[1], normal);
    return 2 * rounding(quad, edge, end) * fabs(t) +
           32 * taut_quad_rounding(quad) * fabs(factor) *
               (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]) /
               taut_dot(normal, normal);
}

/* (C3) */
static taut_status check_torsion(const taut_quad *quad, int c, taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    const double t0 = taut_quad_torsion(quad, m[0].edge, m[0].end);
    const double t1 = taut_quad_torsion(quad, m[1].edge, m[1].end);
    const double size = fmax(fabs(t0), fabs(t1));
    const double scale = taut_quad_size(quad);
    const double match = torsion_match * size +
                         taut_quad_torsion_rounding(quad, m[0].edge, m[0].end, t0) +
                         taut_quad_torsion_rounding(quad, m[1].edge, m[1].end, t1);
    double factors[4][TAUT_QUAD_POINTS];
    char text[600] = " none";
    /* torsions that are nothing but rounding next to the size are equal */
    if (fabs(t0 + t1) <= match || size * scale <= 1e-12) {
        return TAUT_OK;
    }
    if (nearest_weights(quad, factors)) {
        factors_text(quad, factors, text, sizeof text);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "torsion", "", t0 + t1, match,
                     "the torsions of %s and %s at corner %s are %.9g and %.9g: they must be "
                     "opposite; nearest factors on inner weights:%s",
                     taut_asymptotic_edge_name(m[0].edge), taut_asymptotic_edge_name(m[1].edge),
                     taut_asymptotic_corner_name(c), t0, t1, text);
}

taut_status taut_quad_check(const taut_quad *quad, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int c = 0; c < 4 && status == TAUT_OK; c++) {
        status = check_legs(quad, c, error);
    }
    for (int c = 0; c < 4 && status == TAUT_OK; c++) {
        status = check_plane(quad, c, error);
    }
    for (int c = 0; c < 4 && status == TAUT_OK; c++) {
        status = is_linked(quad, c) ? check_torsion(quad, c, error) : TAUT_OK;
    }
    return status;
}
