/* order.c -- bow ties. Two opposite edges AB and CD of a quadrilateral ABCD cross, seen along the direction across both,
 * where the nearest points of their lines are inside them,
 *
 *     s = (c w.d - b w.e) / (a c - b^2),  t = (b w.d - a w.e) / (a c - b^2),
 *     d = B - A,  e = D - C,  w = C - A,  a = d.d,  b = d.e,  c = e.e.
 *
 * A steep saddle has such edges too, far apart from each other. So the gap between them is held against the other two
 * lines that join midpoints of opposite edges (of diagonals), which are as long as the quadrilateral is wide; and the
 * boundary must get shorter where B and C change places, as it does for every bow tie in a plane:
 * |AB| + |CD| > |AC| + |BD|. */
#include "construct/film/order.h"

#include "core/vec3.h"

#include <math.h>
#include <stdio.h>

static const double flat = 0.6; /* of a width: nearer edges cross; a saddle as high as wide has 1 */

static double between(const double a[3], const double b[3])
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return taut_norm(d);
}

/* The distance of the middle of pq from that of rs. */
static double width(const double p[3], const double q[3], const double r[3], const double s[3])
{
    double x[3];
    for (int k = 0; k < 3; k++) {
        x[k] = 0.5 * (p[k] + q[k]) - 0.5 * (r[k] + s[k]);
    }
    return taut_norm(x);
}

/* The gap between lines AB and CD where they are nearest inside both, else infinite. */
static double gap_of(const double A[3], const double B[3], const double C[3], const double D[3])
{
    double d[3], e[3], w[3];
    for (int k = 0; k < 3; k++) {
        d[k] = B[k] - A[k];
        e[k] = D[k] - C[k];
        w[k] = C[k] - A[k];
    }
    const double a = taut_dot(d, d), b = taut_dot(d, e), c = taut_dot(e, e);
    const double wd = taut_dot(w, d), we = taut_dot(w, e), whole = a * c - b * b;
    const double s = (c * wd - b * we) / whole, t = (b * wd - a * we) / whole;
    if (!(whole > 1e-12 * a * c && s > 0 && s < 1 && t > 0 && t < 1)) {
        return INFINITY;
    }
    for (int k = 0; k < 3; k++) {
        w[k] += t * e[k] - s * d[k];
    }
    return taut_norm(w);
}

static int is_bow_tie(const double A[3], const double B[3], const double C[3], const double D[3])
{
    return gap_of(A, B, C, D) < flat * fmin(width(A, C, B, D), width(A, D, B, C)) &&
           between(A, B) + between(C, D) > between(A, C) + between(B, D);
}

int taut_film_order_note(const taut_film_problem *problem, char *text, size_t size)
{
    const double(*x)[3] = problem->corners; /* u0v0, u1v0, u0v1, u1v1 */
    for (int k = 0; k < 4; k++) {
        if (problem->ring != TAUT_FILM_OPEN || !problem->has_corner[k] ||
            problem->corner_kinds[k] != TAUT_FILM_HELD || problem->edges[k].curve != NULL ||
            problem->edges[k].kind == TAUT_FILM_POLE) {
            return 0;
        }
    }
    const int by_v = is_bow_tie(x[0], x[1], x[3], x[2]), by_u = is_bow_tie(x[1], x[3], x[2], x[0]);
    if (by_v || by_u) {
        snprintf(
            text, size,
            "edges %s cross: exchange corners %s and u1v1, if that is not meant (round the film "
            "they are u0v0, u1v0, u1v1, u0v1)",
            by_v ? "v0 and v1" : "u0 and u1", by_v ? "u1v0" : "u0v1");
    }
    return by_v || by_u;
}
