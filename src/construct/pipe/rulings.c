/* rulings.c -- the first rings of a blend along the lines of the straight pipe beside it.
 *
 * At a joint x_u is the way from the end ring to the next, which exactly is along the axis; the
 * rounding of its points turns it by their last digit over that way, which in short first segments
 * far from the origin is thousands of digits. Where on its line a point lies matters little, so
 * it is moved along by less than the tube can tell, to where rounding happens to leave it on the
 * line.
 */
#include "construct/pipe/blend.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { PLACES = 2048 };

/* Of the sine between a ruling and the axis (g2: of the curvature across it, times the radius). */
static const double near_enough = 5e-14;
static const double part_of_way = 1e-3; /* from the end ring, that a point may move */

/* The distance of p from the line through q along d. */
static double off_line(const double p[3], const double q[3], const double d[3])
{
    double way[3], across[3];
    taut_difference(p, q, way);
    taut_cross(way, d, across);
    return taut_norm(across);
}

/* p moved along the line to where it is nearest to it, or to the first place that is near enough.
 */
static void place(const double q[3], const double d[3], double most, double enough, double p[3])
{
    double way[3], best = off_line(p, q, d), along = 0;
    taut_difference(p, q, way);
    along = taut_dot(way, d);
    for (int n = 1; n <= 2 * PLACES && best > enough; n++) {
        const double s = along + (n % 2 == 0 ? most : -most) * ((n + 1) / 2) / PLACES;
        const double next[3] = {q[0] + s * d[0], q[1] + s * d[1], q[2] + s * d[2]};
        const double off = off_line(next, q, d);
        if (off < best) {
            best = off;
            memcpy(p, next, sizeof next);
        }
    }
}

void taut_pipe_straighten(const taut_pipe_arc *arc, const taut_pipe_blend *blend, double radius,
                          double *points)
{
    const int depth = arc->degree == 5 ? 2 : 1, rows = blend->rows;
    for (int n = 0; n < 2 * depth * TAUT_PIPE_RING && blend->slack > 0; n++) {
        const int side = n % 2, j = n / 2 % TAUT_PIPE_RING, row = 1 + n / (2 * TAUT_PIPE_RING);
        const int step = 3 * TAUT_PIPE_RING;
        const double *const q = points + 3 * j + (side == 0 ? 0 : (rows - 1) * step);
        const double *const first = q + (side == 0 ? step : -step);
        double *const p = points + 3 * j + (side == 0 ? row : rows - 1 - row) * step;
        const double leg = taut_distance(first, q);
        taut_pipe_jet jet;
        taut_pipe_arc_jet(arc, side, &jet);
        place(q, jet.tangent, fmin(blend->slack * radius, part_of_way * leg),
              near_enough * leg * (depth == 2 ? fmin(1, leg / radius) : 1), p);
    }
}
