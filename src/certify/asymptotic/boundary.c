/* boundary.c -- the model held against the data it was made from. Distances are over
 * the size of the data; curvatures and weights are compared relative to themselves. */
#include "certify/asymptotic/apart.h"
#include "certify/asymptotic/parts.h"
#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/vec3.h"

#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef struct tally {
    double distance, noise;
    double bound; /* that no distance exceeds, at any parameter */
    char *where;
} tally;

/* Takes a difference, and the rounding that explains some of it. */
static void add_difference(tally *t, double difference, double noise, const char *what,
                           const char *which)
{
    t->noise = taut_certify_max(t->noise, noise);
    t->bound = taut_certify_max(t->bound, difference);
    if (difference > t->distance || isnan(difference)) {
        t->distance = isnan(difference) ? INFINITY : difference;
        (void)snprintf(t->where, TAUT_PLACE_TEXT, "%s of %s", what, which);
    }
}

static taut_bezier_row row_of_curve(const taut_curve *curve)
{
    return (taut_bezier_row){taut_basis_count(taut_curve_t(curve)) - 1, 1, taut_curve_points(curve),
                             taut_curve_weights(curve)};
}

/* The outermost row or column of the patch. */
static taut_bezier_row row_of_edge(const taut_surface *patch, int edge)
{
    const int nu = taut_basis_count(taut_surface_u(patch));
    const int nv = taut_basis_count(taut_surface_v(patch));
    const int with_u = edge % 2 == 0;
    const int64_t first = edge < 2 ? 0 : with_u ? nv - 1 : (int64_t)(nu - 1) * nv;
    const double *const weights = taut_surface_weights(patch);
    return (taut_bezier_row){with_u ? nu - 1 : nv - 1, with_u ? nv : 1,
                             taut_surface_points(patch) + 3 * first,
                             weights != NULL ? weights + first : NULL};
}

/* Of two curves, one of them the model's, at places; and everywhere. */
static void compare_rows(const taut_asymptotic_model *model, const taut_bezier_row *row,
                         double places[TAUT_EDGE_SAMPLES][3], int e, double size, const char *what,
                         tally *t)
{
    const taut_bezier_row curve = row_of_curve(model->curves[e]);
    double seen = 0.0;
    for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
        double c[3], distance = 0.0;
        (void)taut_curve_eval(model->curves[e], k / (TAUT_EDGE_SAMPLES - 1.0), 0, c);
        distance = taut_distance(places[k], c);
        seen = taut_certify_max(seen, distance);
        add_difference(t, distance / size, 4 * DBL_EPSILON * model->curve_size / size, what,
                       taut_asymptotic_edge_name(e));
    }
    seen = fmax(seen, DBL_EPSILON * model->curve_size); /* no sharper than a rounding */
    t->bound = taut_certify_max(t->bound, taut_curves_apart(row, &curve, seen) / size);
}

/* The patch's edges are the model's curves. */
static void compare_edges(const taut_asymptotic_model *model, double size, tally *t)
{
    for (int e = 0; e < 4; e++) {
        const taut_bezier_row row = row_of_edge(model->patch, e);
        double places[TAUT_EDGE_SAMPLES][3];
        for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
            double u = 0.0, v = 0.0;
            taut_edge_parameters(e, k / (TAUT_EDGE_SAMPLES - 1.0), &u, &v);
            (void)taut_surface_eval(model->patch, u, v, 0, places[k]);
        }
        compare_rows(model, &row, places, e, size, "edge", t);
    }
}

/* Curves that were given, at the same parameters. */
static void compare_curves(const taut_asymptotic_model *model, const taut_curve *const given[4],
                           double size, tally *t)
{
    for (int e = 0; e < 4; e++) {
        const taut_bezier_row row = row_of_curve(given[e]);
        double places[TAUT_EDGE_SAMPLES][3];
        for (int k = 0; k < TAUT_EDGE_SAMPLES; k++) {
            (void)taut_curve_eval(given[e], k / (TAUT_EDGE_SAMPLES - 1.0), 0, places[k]);
        }
        compare_rows(model, &row, places, e, size, "curve", t);
    }
}

static const int corner_of_edge[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};

/* The end curvature from differences of control points ([PieglTiller1997] 4.3), as derivatives in
 * homogeneous form cancel where the second weight is small:
 *     k = (n-1)/n w_0 w_2 / w_1^2  |D_1 x D_2| / |D_1|^3,   D_j = P_j - P_0.
 * A rounding error r of the points moves each D_j by 2 r, and so k, relative to itself, by
 *     2 r (3 / |D_1| + (|D_1| + |D_2|) / |D_1 x D_2|).                                       */
static void compare_curvature(const taut_asymptotic_model *model,
                              const taut_asymptotic_corners *corners, int e, int end, tally *t)
{
    const int n = corners->degree, at = end ? n : 0, step = end ? -1 : 1;
    const double given = corners->edges[e].curvature[end];
    const double r = TAUT_UNIT_ROUNDOFF * model->curve_size;
    const double *const p = taut_curve_points(model->curves[e]);
    const double *const w = taut_curve_weights(model->curves[e]);
    const double factor = (n - 1.0) / n * w[at] * w[at + 2 * step] / (w[at + step] * w[at + step]);
    double d[2][3], normal[3], first = 0.0, area = 0.0;
    for (int j = 1; j <= 2; j++) {
        taut_difference(p + 3 * (at + j * step), p + 3 * at, d[j - 1]);
    }
    taut_cross(d[0], d[1], normal);
    first = taut_norm(d[0]);
    area = taut_norm(normal);
    add_difference(t, fabs(factor * area / (first * first * first) - given) / given,
                   2 * r * (3 / first + (first + taut_norm(d[1])) / area), "curvature",
                   taut_asymptotic_edge_name(e));
}

/* Corners, legs, weights and curvatures of Algorithm 1. */
static void compare_corner_data(const taut_asymptotic_model *model,
                                const taut_asymptotic_corners *corners, double size, tally *t)
{
    for (int e = 0; e < 4; e++) {
        const taut_asymptotic_edge *const edge = &corners->edges[e];
        const char *const name = taut_asymptotic_edge_name(e);
        const int n = taut_basis_count(taut_curve_t(model->curves[e])) - 1;
        const double *const p = taut_curve_points(model->curves[e]);
        const double *const w = taut_curve_weights(model->curves[e]);
        if (n != corners->degree || w == NULL) {
            add_difference(t, 1.0, 0.0, "degree", name); /* as large as anything */
            continue;
        }
        for (int end = 0; end < 2; end++) {
            const int last = end == 0 ? 0 : n;
            double leg[3];
            add_difference(
                t, taut_distance(p + 3 * last, corners->points[corner_of_edge[e][end]]) / size,
                DBL_EPSILON * model->curve_size / size, "corner", name);
            if (end == 0 || n > 3) {
                const int low = end == 0 ? 0 : n - 1;
                taut_difference(p + 3 * (low + 1), p + 3 * low, leg);
                add_difference(t, taut_distance(leg, edge->legs[end]) / size,
                               2 * DBL_EPSILON * model->curve_size / size, "leg", name);
            }
            if (n > 3) {
                add_difference(t, fabs(w[last] - edge->weights[end]) / edge->weights[end],
                               DBL_EPSILON, "end weight", name);
            }
            if (n > 3 && edge->curvature[end] > 0) {
                compare_curvature(model, corners, e, end, t);
            }
        }
        for (int j = 0; n == 3 && j <= 3; j++) {
            add_difference(t, fabs(w[j] - edge->weights[j]) / edge->weights[j], DBL_EPSILON,
                           "weight", name);
        }
    }
}

/* Largest distance between two of the curves' control points' first one and the others. */
static double size_of(const taut_asymptotic_model *model)
{
    double size = 0.0;
    for (int e = 0; e < 4; e++) {
        const int count = taut_basis_count(taut_curve_t(model->curves[e]));
        for (int j = 0; j < count; j++) {
            size = fmax(size, taut_distance(taut_curve_points(model->curves[0]),
                                            taut_curve_points(model->curves[e]) + 3 * j));
        }
    }
    return size;
}

void taut_boundary_distance(const taut_asymptotic_model *model,
                            const taut_asymptotic_problem *problem, double *distance, double *bound,
                            double *noise, char where[TAUT_PLACE_TEXT])
{
    const double size = size_of(model);
    tally t = {0.0, DBL_EPSILON, 0.0, where};
    where[0] = '\0';
    compare_edges(model, size, &t);
    if (problem != NULL && problem->given == TAUT_ASYMPTOTIC_CURVES) {
        compare_curves(model, problem->curves, size, &t);
    } else if (problem != NULL) {
        compare_corner_data(model, &problem->corners, size, &t);
    }
    *distance = t.distance;
    *bound = t.bound;
    *noise = t.noise;
}
