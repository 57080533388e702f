/* combs.c -- curvature combs of the edges of a surface. */
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "draw/parts.h"
#include "geometry/exponent.h"

#include <math.h>
#include <string.h>

/* What an edge of this length over the size of its surface has left of it is rounding: it is a point, which bends nowhere. */
static const double point_of_size = 1e-9;

/* k from x' and x''; NaN where x' over the edge's range is no `least` length. */
static void bend_of(const double *d1, const double *d2, double range, double least, double bend[3])
{
    if (!(taut_norm(d1) * range > least)) {
        bend[0] = bend[1] = bend[2] = (double)NAN;
        return;
    }
    const double speed2 = taut_dot(d1, d1), along = taut_dot(d1, d2) / speed2;
    for (int c = 0; c < 3; c++) {
        bend[c] = (d2[c] - along * d1[c]) / speed2;
    }
}

static double parameter_at(double a, double b, int i)
{
    const double s = (double)i / (TAUT_COMB_TEETH - 1);
    return fmin(fmax((1 - s) * a + s * b, a), b);
}

/* The parameters of tooth i of an edge: u0, u1 run along v, and v0, v1 along u. */
static void tooth_parameters(const taut_surface *surface, int edge, int i, double uv[2])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    if (edge < 2) {
        uv[0] = edge == 0 ? taut_basis_lo(u) : taut_basis_hi(u);
        uv[1] = parameter_at(taut_basis_lo(v), taut_basis_hi(v), i);
    } else {
        uv[0] = parameter_at(taut_basis_lo(u), taut_basis_hi(u), i);
        uv[1] = edge == 2 ? taut_basis_lo(v) : taut_basis_hi(v);
    }
}

taut_status taut_combs_fill(const taut_surface *surface, taut_combs *combs, double *most)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double size = 2 * taut_half_size(taut_point_count(surface), taut_surface_points(surface));
    for (int k = 0; k < 4 * TAUT_COMB_TEETH; k++) {
        const int edge = k / TAUT_COMB_TEETH, i = k % TAUT_COMB_TEETH;
        const int first = edge < 2 ? TAUT_XV : TAUT_XU, second = edge < 2 ? TAUT_XVV : TAUT_XUU;
        double uv[2], values[6][3], *bend = combs->bend[edge][i];
        tooth_parameters(surface, edge, i, uv);
        const taut_status status = taut_surface_eval(surface, uv[0], uv[1], 2, &values[0][0]);
        if (status != TAUT_OK) {
            return status;
        }
        memcpy(combs->foot[edge][i], values[TAUT_X], sizeof values[TAUT_X]);
        bend_of(values[first], values[second],
                edge < 2 ? taut_basis_hi(v) - taut_basis_lo(v)
                         : taut_basis_hi(u) - taut_basis_lo(u),
                point_of_size * size, bend);
        *most =
            fmax(*most, taut_hypot(taut_hypot(bend[0], bend[1]), bend[2])); /* passes over NaN */
    }
    return TAUT_OK;
}

void taut_combs_scale(taut_combs *combs, double scale)
{
    const double *foot = &combs->foot[0][0][0], *bend = &combs->bend[0][0][0];
    double *tip = &combs->tip[0][0][0];
    for (size_t i = 0; i < sizeof combs->tip / sizeof *tip; i++) {
        tip[i] = foot[i] - scale * bend[i];
    }
}

taut_status taut_combs_add(const taut_combs *combs, const taut_camera *camera, taut_scene *scene)
{
    static const taut_ink tooth_ink = {196, 108, 60}, tip_ink = {150, 62, 24};
    double tips[TAUT_COMB_TEETH][3];
    for (int edge = 0; edge < 4; edge++) {
        for (int i = 0; i < TAUT_COMB_TEETH; i++) {
            double tooth[2][3];
            taut_camera_project(camera, combs->foot[edge][i], tooth[0]);
            taut_camera_project(camera, combs->tip[edge][i], tooth[1]);
            memcpy(tips[i], tooth[1], sizeof tips[i]);
            if (i % 2 == 0) {
                taut_scene_line(scene, 2, tooth[0], tooth_ink, 0.8);
            }
        }
        taut_scene_line(scene, TAUT_COMB_TEETH, tips[0], tip_ink, 1.4);
    }
    return scene->status;
}
