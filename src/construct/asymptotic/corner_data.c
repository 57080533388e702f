#include "construct/asymptotic/corner_data.h"

#include "construct/asymptotic/end_weights.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <stdio.h>
#include <string.h>

const int taut_corner_of_edge[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};

/* Below this sine two directions count as parallel: the least that the claim `regular` accepts. */
static const double least_sine = 1e-6;
/* Straight data is given in decimals: a leg may leave the chord by its rounding. */
static const double off_chord = 1e-12;

/* Conditions are products of up to eight of these: what lies beyond leaves the range of double. */
static const double most = 1e30;

static int is_beyond(double x)
{
    return x > 0 && !(x <= most && x >= 1 / most);
}

static int finite_all(int count, const double *x)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(x[i])) {
            return 0;
        }
    }
    return 1;
}

static taut_status fail_value(taut_error *error, const char *where, double found, const char *what)
{
    const double limit = is_beyond(found) ? (found > most ? most : 1e-30) : taut_none;
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, found, limit, "%s", what);
}

static taut_status check_edge(const taut_asymptotic_corners *corners, int e, taut_error *error)
{
    const taut_asymptotic_edge *const edge = &corners->edges[e];
    const int weights = corners->degree == 3 ? 4 : 2;
    const int legs = corners->degree == 3 ? 1 : 2;
    char where[48];
    (void)snprintf(where, sizeof where, "/edges/%s/weights", taut_asymptotic_edge_name(e));
    for (int k = 0; k < weights; k++) {
        if (!(edge->weights[k] > 0) || !isfinite(edge->weights[k])) {
            return fail_value(error, where, edge->weights[k], "weights must be positive numbers");
        }
        if (is_beyond(edge->weights[k])) {
            return fail_value(error, where, edge->weights[k],
                              "weights must lie between 1e-30 and 1e30");
        }
    }
    (void)snprintf(where, sizeof where, "/edges/%s/legs", taut_asymptotic_edge_name(e));
    if (!finite_all(3 * legs, &edge->legs[0][0])) {
        return fail_value(error, where, taut_none, "legs must be finite");
    }
    for (int k = 0; k < legs; k++) {
        if (!(taut_norm(edge->legs[k]) > 0)) {
            return fail_value(error, where, 0.0, "a leg must not have length zero");
        }
        if (is_beyond(taut_norm(edge->legs[k]))) {
            return fail_value(error, where, taut_norm(edge->legs[k]),
                              "the length of a leg must lie between 1e-30 and 1e30");
        }
    }
    (void)snprintf(where, sizeof where, "/edges/%s/curvature", taut_asymptotic_edge_name(e));
    for (int k = 0; k < 2 && corners->degree > 3; k++) {
        const double curvature = edge->curvature[k];
        if (!(curvature >= 0) || !isfinite(curvature)) {
            return fail_value(error, where, curvature, "end curvatures must not be negative");
        }
        if (is_beyond(curvature)) {
            return fail_value(error, where, curvature,
                              "end curvatures must be 0 or lie between 1e-30 and 1e30");
        }
        if ((curvature > 0) != (edge->curvature[1 - k] > 0)) {
            return fail_value(
                error, where, 0.0,
                "one end curvature is 0 and the other is not: both are 0 on a straight "
                "edge and none is on a curved one");
        }
    }
    return TAUT_OK;
}

static taut_status check_corners(const taut_asymptotic_corners *corners, taut_error *error)
{
    if (!finite_all(12, &corners->points[0][0])) {
        return fail_value(error, "/corners", taut_none, "corner points must be finite");
    }
    for (int e = 0; e < 4; e++) {
        const int *const c = taut_corner_of_edge[e];
        const double length = taut_distance(corners->points[c[0]], corners->points[c[1]]);
        if (!(length > 0) || !isfinite(length)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "same-corner", "/corners", length, 0.0,
                             "edge %s begins and ends at the same corner point",
                             taut_asymptotic_edge_name(e));
        }
    }
    return TAUT_OK;
}

taut_status taut_corner_check(const taut_asymptotic_corners *corners, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (corners->degree < 3 || corners->degree > TAUT_QUAD_DEGREE) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/degree", corners->degree,
                         TAUT_QUAD_DEGREE, "the degree of the boundary must be 3 to %d",
                         TAUT_QUAD_DEGREE);
    }
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        status = check_edge(corners, e, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = check_corners(corners, error);
    return status == TAUT_OK ? taut_end_weights_of_data(corners, error) : status;
}

/* A straight edge's legs must point along its chord and be shorter than it. */
static taut_status check_straight(const taut_corner_edge *edge, int e, double rounding,
                                  taut_error *error)
{
    double chord[3];
    taut_difference(edge->point[1], edge->point[0], chord);
    for (int k = 0; k < 2; k++) {
        const double length = taut_norm(chord), along = taut_dot(edge->leg[k], chord) / length;
        double normal[3];
        taut_cross(edge->leg[k], chord, normal);
        if (taut_norm(normal) > (off_chord * length + 4 * rounding) * taut_norm(edge->leg[k]) ||
            !(along > 0) || !(along < length)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "straight-edge", "/edges",
                             taut_norm(normal) / (length * taut_norm(edge->leg[k])), off_chord,
                             "edge %s has curvature 0 at its ends, but leg %d does not lie along "
                             "the chord and within it: a straight edge's legs must",
                             taut_asymptotic_edge_name(e), k);
        }
    }
    return TAUT_OK;
}

static taut_status fill_edge(const taut_asymptotic_corners *corners, int e, double rounding,
                             taut_corner_edge *edge, taut_error *error)
{
    const int n = corners->degree < 5 ? corners->degree : 5;
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const f = &taut_quad_partner[e][k];
        const double *const leg = corners->edges[e].legs[k];
        const double *const other = corners->edges[f->edge].legs[f->end];
        double sine = 0.0;
        memcpy(edge->point[k], corners->points[taut_corner_of_edge[e][k]], sizeof edge->point[k]);
        memcpy(edge->leg[k], leg, sizeof edge->leg[k]);
        memcpy(edge->partner[k], other, sizeof edge->partner[k]);
        taut_cross(leg, other, edge->normal[k]);
        edge->weight[k] = taut_corner_end_weight(corners, e, k);
        edge->curvature[k] = corners->edges[e].curvature[k];
        sine = taut_norm(edge->normal[k]) / (taut_norm(leg) * taut_norm(other));
        if (!(sine >= least_sine)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "parallel-legs", "/edges", sine, least_sine,
                             "the legs of %s and %s are parallel at corner %s: they must span the "
                             "tangent plane",
                             taut_asymptotic_edge_name(e), taut_asymptotic_edge_name(f->edge),
                             taut_asymptotic_corner_name(f->corner));
        }
        /* a logarithm of numbers without unit: far from 1 it would keep fewer digits of them */
        edge->bend[k] = taut_log((n - 1.0) / n * edge->weight[k] *
                                 (taut_norm(edge->normal[k]) / taut_dot(leg, leg)) /
                                 (edge->curvature[k] * taut_norm(leg)));
    }
    edge->straight = edge->curvature[0] == 0.0;
    return edge->straight ? check_straight(edge, e, rounding, error) : TAUT_OK;
}

taut_status taut_corner_data_fill(const taut_asymptotic_corners *corners, double rounding,
                                  taut_corner_data *data, taut_error *error)
{
    taut_status status = TAUT_OK;
    data->degree = corners->degree < 5 ? corners->degree : 5;
    data->raised = corners->degree;
    data->size = 0.0;
    data->rounding = rounding;
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        status = fill_edge(corners, e, rounding, &data->edges[e], error);
        data->size = fmax(data->size, taut_distance(corners->points[0], corners->points[e]));
    }
    taut_curve_rule_fill(data->degree, TAUT_CURVE_COARSE, &data->coarse);
    taut_curve_rule_fill(data->degree, TAUT_CURVE_FINE, &data->fine);
    return status;
}

/* W = c of degree n-1 raised once, W r = A_0 W + L t c. With leg = f L at an end, c there begins
 *     c_0 = w,  c_1 = w (1/f - 1) / (n - 1);
 * between, c runs linearly in its index. Degree 4 leaves no choice. */
void taut_corner_straight(const taut_corner_data *data, int edge, int n, taut_quad_edge *made)
{
    const taut_corner_edge *const e = &data->edges[edge];
    double c[TAUT_QUAD_POINTS], chord[3], inner[2];
    taut_difference(e->point[1], e->point[0], chord);
    for (int k = 0; k < 2; k++) {
        const double f = taut_dot(e->leg[k], chord) / taut_dot(chord, chord);
        inner[k] = e->weight[k] * (1.0 / f - 1.0) / (n - 1);
    }
    c[0] = e->weight[0];
    c[n - 1] = e->weight[1];
    for (int j = 1; j <= n - 2; j++) {
        const double t = (double)(j - 1) / (n - 3);
        c[j] = (1.0 - t) * inner[0] + t * inner[1];
    }
    for (int j = 0; j <= n; j++) {
        const double before = j > 0 ? j * c[j - 1] : 0.0;
        const double here = j < n ? (n - j) * c[j] : 0.0;
        made->weights[j] = (before + here) / n;
        memcpy(made->points[j], e->point[0], sizeof made->points[j]);
        taut_add_scaled(before / (n * made->weights[j]), chord, made->points[j]);
    }
    memcpy(made->points[n], e->point[1], sizeof made->points[n]);
    made->straight = 1;
}
