/* arc.c -- the arc from P through Q to R.
 *
 * It turns by twice the angle between PQ and QR (inscribed angles). With t that turn, over its chord, c
 * the unit vector along it, h half its length, n towards Q across it, it has
 *
 *     middle  M = (P + R) / 2 + h tan(t / 4) n,      radius  r = h / sin(t / 2)
 *
 * The functions of a uniform c-bspline are one function moved from segment to segment, so that points
 * at equal angles on a circle make a circle, with the same centre ([XuWang2006] section 3). With
 * alpha = t / 4 the angle of a segment and N_0, N_1, N_2 the functions alive at its beginning,
 *
 *     P_i = M + r (g sin(a) c + (g cos(a) - 1) n),   a = (i - 3) alpha,   g = 1 / (N_1 + (N_0 + N_2) cos(alpha))
 */
#include "geometry/arc.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "taut/basis.h"

#include <math.h>
#include <string.h>

enum { SEGMENTS = 4, POINTS = SEGMENTS + 3, TURN_SEGMENTS = 8, TURN_POINTS = TURN_SEGMENTS + 3 };
static const double along_normal = 1e-6; /* a start is shorter than this across it */

/* The arc over its chord. */
typedef struct arc {
    double half, angle;
    double along[3], across[3]; /* unit: c, n */
} arc;

/* 0 where the three points bound no triangle. */
static int measure_arc(const double points[3][3], arc *a)
{
    double from[3], to[3], normal[3];

    taut_difference(points[1], points[0], from);
    taut_difference(points[2], points[1], to);
    taut_difference(points[2], points[0], a->along);
    const double chord = taut_norm(a->along);
    if (!(chord > 0) || !isfinite(chord)) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        a->along[c] /= chord;
        from[c] /= chord;
        to[c] /= chord;
    }
    taut_cross(from, to, normal);
    const double area = taut_norm(normal);
    if (!(area > 0) || !isfinite(area)) {
        return 0;
    }
    a->half = 0.5 * chord;
    a->angle = 2 * taut_atan2(area, taut_dot(from, to)); /* what Q turns by is half of it */
    taut_cross(a->along, normal, a->across);
    for (int c = 0; c < 3; c++) {
        a->across[c] /= area;
    }
    return a->angle >= TAUT_ARC_ANGLE && 2 * TAUT_PI - a->angle >= TAUT_ARC_ANGLE;
}

static taut_status lay_points(const arc *a, const double points[3][3], const taut_basis *basis,
                              double net[POINTS][3])
{
    const double alpha = a->angle / SEGMENTS, radius = a->half / taut_sin(0.5 * a->angle);
    double n[4];
    const taut_status status = taut_basis_eval(basis, 0, taut_basis_lo(basis), 0, n);

    if (status != TAUT_OK) {
        return status;
    }
    const double grown = 1 / (n[1] + (n[0] + n[2]) * taut_cos(alpha));
    for (int i = 0; i < POINTS; i++) {
        const double turn = (i - 0.5 * (POINTS - 1)) * alpha;
        const double aside = radius * grown * taut_sin(turn);
        const double rise = radius * (grown * taut_cos(turn) - 1);
        for (int c = 0; c < 3; c++) {
            net[i][c] = 0.5 * points[0][c] + 0.5 * points[2][c] + aside * a->along[c] +
                        (a->half * taut_tan(0.25 * a->angle) + rise) * a->across[c];
        }
    }
    return TAUT_OK;
}

taut_status taut_arc_new(const double points[3][3], taut_curve **curve)
{
    arc a;
    double net[POINTS][3];
    taut_basis *basis = NULL;

    if (!measure_arc(points, &a)) {
        return TAUT_NO_SOLUTION;
    }
    const taut_basis_spec spec = {
        .type = "c-bspline", .alpha = a.angle / SEGMENTS, .segments = SEGMENTS};
    taut_status status = taut_basis_new(&spec, POINTS, &basis, NULL);
    if (status == TAUT_OK) {
        status = lay_points(&a, points, basis, net);
    }
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, net[0], NULL, curve, NULL);
    }
    taut_basis_free(basis);
    return status == TAUT_OK || status == TAUT_NO_MEMORY ? status : TAUT_NO_SOLUTION;
}

static int make_unit(double x[3])
{
    const double size = taut_norm(x);
    for (int c = 0; c < 3; c++) {
        x[c] /= size;
    }
    return size > 0 && isfinite(size);
}

/* axes[0]: from the centre to where a circle begins; axes[1]: a quarter on. */
static int find_axes(const double normal[3], const double *start, double axes[2][3])
{
    double n[3] = {normal[0], normal[1], normal[2]};

    if (!make_unit(n)) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        double x[3] = {k == 0, k == 1, 0};
        if (start != NULL) {
            memcpy(x, start, sizeof x);
            if (!make_unit(x)) {
                return 0;
            }
        }
        taut_add_scaled(-taut_dot(n, x), n, x);
        const int is_across = taut_norm(x) >= along_normal;
        if (is_across && make_unit(x)) {
            memcpy(axes[0], x, sizeof x);
            taut_cross(n, x, axes[1]);
            return 1;
        }
        if (start != NULL) {
            return 0;
        }
    }
    return 0;
}

static taut_status lay_circle(const double center[3], double radius, const double axes[2][3],
                              const taut_basis *basis, double net[TURN_POINTS][3])
{
    const double alpha = 2 * TAUT_PI / TURN_SEGMENTS;
    double n[4];
    const taut_status status = taut_basis_eval(basis, 0, taut_basis_lo(basis), 0, n);

    if (status != TAUT_OK) {
        return status;
    }
    const double grown = radius / (n[1] + (n[0] + n[2]) * taut_cos(alpha));
    for (int i = 0; i < TURN_POINTS;
         i++) { /* the point of the function in the middle of the first knot */
        const double turn = (i - 1) * alpha;
        memcpy(net[i], center, sizeof net[i]);
        taut_add_scaled(grown * taut_cos(turn), axes[0], net[i]);
        taut_add_scaled(grown * taut_sin(turn), axes[1], net[i]);
    }
    return TAUT_OK;
}

taut_status taut_circle_new(const double center[3], const double normal[3], double radius,
                            const double *start, taut_curve **curve)
{
    const taut_basis_spec spec = {
        .type = "c-bspline", .alpha = 2 * TAUT_PI / TURN_SEGMENTS, .segments = TURN_SEGMENTS};
    double axes[2][3], net[TURN_POINTS][3];
    taut_basis *basis = NULL;

    if (!(radius > 0) || !find_axes(normal, start, axes)) {
        return TAUT_NO_SOLUTION;
    }
    taut_status status = taut_basis_new(&spec, TURN_POINTS, &basis, NULL);
    if (status == TAUT_OK) {
        status = lay_circle(center, radius, (const double(*)[3])axes, basis, net);
    }
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, net[0], NULL, curve, NULL);
    }
    taut_basis_free(basis);
    return status == TAUT_OK || status == TAUT_NO_MEMORY ? status : TAUT_NO_SOLUTION;
}
