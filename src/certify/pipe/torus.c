/* torus.c -- is a surface the torus about an arc? It is as near to it as its control points are to those of the
 * torus that begins at the same point of the first ring, where the weights are the same: both are sums of
 * points by the same functions, which are positive and add up to one.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/sweep.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { RING = 9, ROWS = 3 };

static const double half_right = 0.70710678118654752440; /* sqrt(1/2) */
static const double places[RING][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                       {-1, -1}, {0, -1}, {1, -1}, {1, 0}};

/* Bezier along, four quarters of a circle around? */
static int has_bases(const taut_surface *surface)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    return taut_basis_degree(u) == 2 && taut_basis_span_count(u) == 1 &&
           taut_basis_degree(v) == 2 && taut_basis_span_count(v) == 4 &&
           taut_basis_count(v) == RING && taut_surface_weights(surface) != NULL;
}

/* How far a weight is from what it should be, over that. */
static double weight_miss(const taut_surface *surface, double middle)
{
    const double *w = taut_surface_weights(surface);
    double worst = 0;
    for (int i = 0; i < ROWS; i++) {
        for (int j = 0; j < RING; j++) {
            const double wanted = (i == 1 ? middle : 1) * (j % 2 == 1 ? half_right : 1) * w[0];
            worst = taut_certify_max(worst, fabs(w[i * RING + j] / wanted - 1));
        }
    }
    return worst;
}

/* The frame at the beginning: towards the first point of the ring and, across that, towards the third. */
static void find_frame(const taut_surface *surface, const taut_pipe_circle *circle, double u[3],
                       double w[3])
{
    const double *p = taut_surface_points(surface);
    double third[3];
    memcpy(u, p, 3 * sizeof *u);
    memcpy(third, p + 6, sizeof third);
    for (int k = 0; k < 3; k++) {
        const double start = circle->centre[k] + circle->radius * circle->out[k];
        u[k] -= start;
        third[k] -= start;
    }
    taut_add_scaled(-taut_dot(u, circle->ahead), circle->ahead, u);
    taut_pipe_unit(u, u);
    taut_cross(circle->ahead, u, w);
    if (taut_dot(w, third) < 0) {
        for (int k = 0; k < 3; k++) {
            w[k] = -w[k];
        }
    }
}

/* Point j of ring i of the torus of this frame. */
static void find_point(const taut_pipe_circle *circle, double radius, const double frame[2][3],
                       int i, int j, double x[3])
{
    const double angle = 0.5 * i * circle->angle, reach = i == 1 ? 1 / taut_cos(angle) : 1;
    double axis[3], out[3], ahead[3], far = circle->radius, high = 0;
    taut_cross(circle->out, circle->ahead, axis);
    taut_pipe_circle_directions(circle, angle, out, ahead);
    for (int d = 0; d < 2; d++) {
        far += radius * places[j][d] * taut_dot(frame[d], circle->out);
        high += radius * places[j][d] * taut_dot(frame[d], axis);
    }
    memcpy(x, circle->centre, 3 * sizeof *x);
    taut_add_scaled(reach * far, out, x);
    taut_add_scaled(high, axis, x);
}

void taut_pipe_cover_torus(const taut_pipe_parts *parts, const taut_surface *surface,
                           const taut_pipe_circle *circle, double tolerance, taut_pipe_cover *cover)
{
    const double radius = parts->radius, middle = taut_cos(0.5 * circle->angle);
    double frame[2][3], worst = 0;
    *cover = (taut_pipe_cover){.bound = INFINITY};
    snprintf(cover->where, sizeof cover->where, "%.32s", taut_surface_name(surface));
    if (!has_bases(surface)) {
        cover->open = "it is not on the basis of a torus";
        return;
    }
    find_frame(surface, circle, frame[0], frame[1]);
    for (int n = 0; n < ROWS * RING; n++) {
        double x[3];
        find_point(circle, radius, (const double(*)[3])frame, n / RING, n % RING, x);
        worst = taut_certify_max(worst, taut_distance(x, taut_surface_points(surface) + 3 * n));
    }
    const double wide =
        circle->radius + radius; /* a weight that is off moves a point by as much of it */
    cover->found = worst / radius;
    cover->bound = cover->found + circle->miss / radius +
                   4 * weight_miss(surface, middle) * wide / (radius * middle) +
                   16 * TAUT_UNIT_ROUNDOFF * (1 + (wide / middle + parts->size) / radius);
    if (cover->found > tolerance + 16 * TAUT_UNIT_ROUNDOFF * parts->size / radius) {
        cover->fault =
            ""; /* a point of the net is not on the surface, but no torus has such a net */
    }
}
