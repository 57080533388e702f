#include "construct/asymptotic/quad.h"

#include "core/constants.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <string.h>

/* [WangZhuLi2017] section 1, the map pi of docs/papers/asymptotic.md 1.1. */
const taut_quad_meeting taut_quad_partner[4][2] = {
    {{1, 0, 0}, {3, 0, 1}},
    {{0, 0, 0}, {2, 0, 2}},
    {{1, 1, 2}, {3, 1, 3}},
    {{0, 1, 1}, {2, 1, 3}},
};

const taut_quad_meeting taut_quad_corner[4][2] = {
    {{0, 0, 0}, {1, 0, 0}},
    {{0, 1, 1}, {3, 0, 1}},
    {{2, 0, 2}, {1, 1, 2}},
    {{2, 1, 3}, {3, 1, 3}},
};

static const char *const edge_names[4] = {"v0", "u0", "v1", "u1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

const char *taut_asymptotic_edge_name(int edge)
{
    return edge >= 0 && edge < 4 ? edge_names[edge] : NULL;
}

const char *taut_asymptotic_corner_name(int corner)
{
    return corner >= 0 && corner < 4 ? corner_names[corner] : NULL;
}

const double *taut_quad_point(const taut_quad *quad, int edge, int end, int step)
{
    return quad->edges[edge].points[end == 0 ? step : quad->degree - step];
}

double taut_quad_weight(const taut_quad *quad, int edge, int end, int step)
{
    return quad->edges[edge].weights[end == 0 ? step : quad->degree - step];
}

void taut_quad_leg(const taut_quad *quad, int edge, int end, double leg[3])
{
    const double *const corner = taut_quad_point(quad, edge, end, 0);
    const double *const next = taut_quad_point(quad, edge, end, 1);
    taut_difference(end == 0 ? next : corner, end == 0 ? corner : next, leg);
}

double taut_quad_torsion(const taut_quad *quad, int edge, int end)
{
    const int n = quad->degree;
    double d[4][3], normal[3];
    for (int j = 1; j <= 3; j++) {
        taut_difference(taut_quad_point(quad, edge, end, j), taut_quad_point(quad, edge, end, 0),
                        d[j]);
    }
    taut_cross(d[1], d[2], normal);
    return (n - 2.0) / n * taut_quad_weight(quad, edge, end, 0) *
           taut_quad_weight(quad, edge, end, 3) /
           (taut_quad_weight(quad, edge, end, 1) * taut_quad_weight(quad, edge, end, 2)) *
           taut_dot(normal, d[3]) / taut_dot(normal, normal);
}

double taut_quad_size(const taut_quad *quad)
{
    double size = 0.0;
    for (int a = 0; a < 4; a++) {
        for (int j = 0; j <= quad->degree; j++) {
            size = fmax(size, taut_distance(quad->edges[0].points[0], quad->edges[a].points[j]));
        }
    }
    return size;
}

double taut_quad_rounding(const taut_quad *quad)
{
    double reach = 0.0;
    for (int a = 0; a < 4; a++) {
        for (int j = 0; j <= quad->degree; j++) {
            reach = fmax(reach, taut_norm(quad->edges[a].points[j]));
        }
    }
    return fmax(quad->rounding, TAUT_UNIT_ROUNDOFF * reach);
}

/* Degree elevation of the homogeneous coefficients. */
void taut_quad_raise_edge(int p, int n, taut_quad_edge *edge)
{
    double low[TAUT_QUAD_POINTS][4], high[TAUT_QUAD_POINTS][4];
    if (p == n) {
        return;
    }
    for (int j = 0; j <= p; j++) {
        low[j][3] = edge->weights[j];
        for (int k = 0; k < 3; k++) {
            low[j][k] = edge->points[j][k] * edge->weights[j];
        }
    }
    taut_bernstein_raise(p, 4, &low[0][0], n - p, &high[0][0]);
    for (int j = 0; j <= n; j++) {
        edge->weights[j] = high[j][3];
        for (int k = 0; k < 3; k++) {
            edge->points[j][k] = high[j][k] / high[j][3];
        }
    }
}

void taut_quad_raise(taut_quad *quad, int n)
{
    for (int a = 0; a < 4; a++) {
        taut_quad_raise_edge(quad->degree, n, &quad->edges[a]);
    }
    quad->degree = n;
}
