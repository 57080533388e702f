#include "construct/asymptotic/quad.h"

#include "construct/asymptotic/end_weights.h"
#include "construct/asymptotic/poly.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <float.h>
#include <stdio.h>
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
    return fmax(quad->rounding, 0.5 * DBL_EPSILON * reach);
}

/* Is every control point on the chord, up to rounding of the coordinates? */
static int is_straight(const taut_quad *quad, int edge)
{
    const taut_quad_edge *const e = &quad->edges[edge];
    const double rounding = 4 * taut_quad_rounding(quad);
    double chord[3], reach = 0.0, off = 0.0;
    taut_difference(e->points[quad->degree], e->points[0], chord);
    for (int j = 1; j < quad->degree; j++) {
        double d[3], normal[3];
        taut_difference(e->points[j], e->points[0], d);
        taut_cross(chord, d, normal);
        off = fmax(off, taut_norm(normal));
        reach = fmax(reach, taut_norm(d));
    }
    return off <= taut_norm(chord) * (1e-13 * fmax(reach, taut_norm(chord)) + rounding);
}

/* Raises a curve of degree p to n: degree elevation of the homogeneous coefficients. */
static void raise_edge(int p, int n, taut_quad_edge *edge)
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
    taut_poly_elevate(p, 4, &low[0][0], n - p, &high[0][0]);
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
        raise_edge(quad->degree, n, &quad->edges[a]);
    }
    quad->degree = n;
}

static void take_curve(const taut_curve *curve, int n, taut_quad_edge *edge)
{
    const int p = taut_basis_count(taut_curve_t(curve)) - 1;
    const double *const weights = taut_curve_weights(curve);
    memcpy(edge->points, taut_curve_points(curve), (size_t)(p + 1) * sizeof *edge->points);
    for (int j = 0; j <= p; j++) {
        edge->weights[j] = weights != NULL ? weights[j] : 1.0;
    }
    raise_edge(p, n, edge);
}

/* One degree for all four; TAUT_BAD_INPUT names the curve that cannot be a boundary. */
static taut_status common_degree(const taut_curve *const curves[4], int *degree, taut_error *error)
{
    *degree = 3;
    for (int a = 0; a < 4; a++) {
        const taut_basis *t = NULL;
        char where[32];
        (void)snprintf(where, sizeof where, "/curves/%s", edge_names[a]);
        if (curves[a] == NULL) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none,
                             "curve %s is missing: all four are needed", edge_names[a]);
        }
        t = taut_curve_t(curves[a]);
        if (strcmp(taut_basis_type(t), "bezier") != 0 || taut_basis_lo(t) != 0.0 ||
            taut_basis_hi(t) != 1.0) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none,
                             "curve %s must be a bezier curve over [0, 1]", edge_names[a]);
        }
        if (taut_basis_degree(t) > TAUT_QUAD_DEGREE) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_basis_degree(t),
                             TAUT_QUAD_DEGREE,
                             "curve %s has degree %d: boundary curves have degree at most %d",
                             edge_names[a], taut_basis_degree(t), TAUT_QUAD_DEGREE);
        }
        *degree = taut_basis_degree(t) > *degree ? taut_basis_degree(t) : *degree;
    }
    return TAUT_OK;
}

taut_status taut_quad_of_curves(const taut_curve *const curves[4], taut_quad *quad,
                                taut_error *error)
{
    int degrees[4];
    taut_status status = common_degree(curves, &quad->degree, error);
    if (status != TAUT_OK) {
        return status;
    }
    quad->rounding = 0.0;
    for (int a = 0; a < 4; a++) {
        degrees[a] = taut_basis_degree(taut_curve_t(curves[a]));
        take_curve(curves[a], quad->degree, &quad->edges[a]);
        quad->edges[a].straight = is_straight(quad, a);
    }
    quad->rounding = taut_quad_rounding(quad);
    status = taut_quad_check_closed(quad, error);
    return status == TAUT_OK ? taut_end_weights_of_curves(quad, degrees, error) : status;
}
