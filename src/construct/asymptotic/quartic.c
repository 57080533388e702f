/* quartic.c -- what degree 4 leaves free, and whether it can close. The minimisation is in
 * quartic_minimise.c. Docs page section 4.1. */
#include "construct/asymptotic/quartic.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/dense.h"

#include <stdio.h>
#include <string.h>

static const double rank_cut = 1e-9;    /* relative: planes nearer to parallel count as parallel */
static const double ratio_cut = 1e-11;  /* relative: rounding of the line's coefficients */
static const double closing_cut = 1e-9; /* of a logarithm: data given to nine digits may close */
static const double planar_cut = 1e-12; /* relative: a torsion's numerator that is rounding */
static const int epsilon[4] = {1, -1, -1, 1};

/* (4.1): A_0 + lambda a_0 + mu c_0 = A_1 + nu c_1 + rho a_1, its least-norm solution and its null
 * vector, with each column scaled to length 1, and p to the chord's, so that units do not matter.
 */
static taut_status fill_line(const taut_corner_edge *edge, int e, double rounding,
                             taut_quartic_line *line, taut_error *error)
{
    const double *const columns[4] = {edge->leg[0], edge->partner[0], edge->partner[1],
                                      edge->leg[1]};
    double a[12], b[3], x[4], null[16], length[4], chord = 0.0, pivot = 0.0;
    for (int k = 0; k < 4; k++) {
        length[k] = taut_norm(columns[k]);
        for (int i = 0; i < 3; i++) {
            a[3 * k + i] = (k < 2 ? 1.0 : -1.0) * columns[k][i] / length[k];
        }
    }
    taut_difference(edge->point[1], edge->point[0], b);
    if (taut_least_norm(3, 4, a, b, rank_cut, x, null) < 3) {
        return taut_fail(error, TAUT_NO_SOLUTION, "parallel-planes", "/edges", taut_none, taut_none,
                         "the tangent planes at the two ends of edge %s are parallel: turn one "
                         "of its legs or of the legs it meets",
                         taut_asymptotic_edge_name(e));
    }
    chord = taut_norm(b);
    for (int k = 0; k < 4; k++) {
        line->at[k] = x[k] / length[k];
        line->along[k] = fabs(null[k]) > ratio_cut ? null[k] * chord / length[k] : 0.0;
    }
    pivot = fabs(line->at[1] * line->along[2] - line->at[2] * line->along[1]);
    line->same_ratio =
        pivot <= (ratio_cut * chord + 32 * rounding) * chord / (length[1] * length[2]);
    return TAUT_OK;
}

/* The constants n_0.(P_3 - P_0), n_1.(P_1 - P_4) of (4.3). */
static void fill_torsions(const taut_corner_edge *edge, taut_quartic_line *line)
{
    for (int k = 0; k < 2; k++) {
        double arm[3];
        taut_difference(edge->point[1 - k], edge->point[k], arm);
        taut_add_scaled(k == 0 ? -1.0 : 1.0, edge->leg[1 - k], arm);
        line->torsion[k] = taut_dot(edge->normal[k], arm);
        if (fabs(line->torsion[k]) <= planar_cut * taut_norm(edge->normal[k]) * taut_norm(arm)) {
            line->torsion[k] = 0.0;
        }
    }
}

/* A corner is linked where both edges are curved and have a torsion; where only one has, no weights
 * can balance it. */
static taut_status fill_links(taut_quartic *quartic, taut_error *error)
{
    quartic->ring = 1;
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        const double t0 = quartic->lines[m[0].edge].torsion[m[0].end];
        const double t1 = quartic->lines[m[1].edge].torsion[m[1].end];
        const int curved =
            !quartic->data->edges[m[0].edge].straight && !quartic->data->edges[m[1].edge].straight;
        if (curved && (t0 == 0.0) != (t1 == 0.0)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "torsion", "/edges", t0 != 0.0 ? t0 : t1, 0.0,
                             "at corner %s the torsion of %s is zero whatever its weights are and "
                             "that of %s is not: they must be opposite",
                             taut_asymptotic_corner_name(c),
                             taut_asymptotic_edge_name(m[t0 == 0.0 ? 0 : 1].edge),
                             taut_asymptotic_edge_name(m[t0 == 0.0 ? 1 : 0].edge));
        }
        quartic->linked[c] = curved && t0 != 0.0;
        quartic->ring = quartic->ring && quartic->linked[c];
    }
    return TAUT_OK;
}

/* log |tau(0) / tau(1)| of an edge less 2 log(nu / mu), from (4.5) with the weights of (4.2). */
static double torsion_ratio(const taut_corner_edge *edge, const taut_quartic_line *line)
{
    const double h0 = taut_log(edge->weight[0]) + taut_log(fabs(line->torsion[0])) -
                      2 * taut_log(taut_norm(edge->normal[0]));
    const double h1 = taut_log(edge->weight[1]) + taut_log(fabs(line->torsion[1])) -
                      2 * taut_log(taut_norm(edge->normal[1]));
    return edge->bend[1] - edge->bend[0] + h0 - h1;
}

taut_status taut_closing_fail(const taut_corner_data *data, double gap, int is_open,
                              taut_error *error)
{
    static const int order[4] = {TAUT_ASYMPTOTIC_V0, TAUT_ASYMPTOTIC_V1, TAUT_ASYMPTOTIC_U0,
                                 TAUT_ASYMPTOTIC_U1};
    char text[256] = "";
    size_t used = 0;
    for (int k = 0; k < 4 && used < sizeof text; k++) {
        const int e = order[k];
        const double factor = taut_exp(epsilon[e] * gap / 8);
        used += (size_t)snprintf(text + used, sizeof text - used, " %s [%.17g,%.17g]",
                                 taut_asymptotic_edge_name(e), data->edges[e].curvature[0] / factor,
                                 data->edges[e].curvature[1] * factor);
    }
    return taut_fail(error, TAUT_NO_SOLUTION, "closing", "/edges", gap, closing_cut,
                     "the torsions cannot close around the four corners: the curvatures miss it "
                     "by %sa factor of %.12g; %s curvatures, each %.6g times more or less:%s",
                     is_open ? "more than " : "", taut_exp(gap),
                     is_open ? "needed beyond these" : "nearest", taut_exp(fabs(gap) / 8), text);
}

/* What rounding of the corners leaves of the closing condition: each torsion has the height of a
 * point over a plane as a factor, and mu, nu where they are fixed follow from the chord. */
static double closing_noise(const taut_corner_edge *edge, const taut_quartic_line *line,
                            double rounding)
{
    double sum = 0.0;
    for (int k = 0; k < 2; k++) {
        sum += taut_norm(edge->normal[k]) / fabs(line->torsion[k]);
        if (line->along[1] == 0.0 && line->along[2] == 0.0) {
            sum += 2 / (fabs(line->at[1 + k]) * taut_norm(edge->partner[k]));
        }
    }
    return 32 * rounding * sum;
}

static taut_status fill_closing(taut_quartic *quartic, taut_error *error)
{
    int varies = 0;
    double constant = 0.0, total = 0.0, noise = 0.0;
    if (!quartic->ring) {
        quartic->closing = TAUT_CLOSING_NONE;
        return TAUT_OK;
    }
    for (int e = 0; e < 4; e++) {
        const taut_quartic_line *const line = &quartic->lines[e];
        const double ratio = torsion_ratio(&quartic->data->edges[e], line);
        const int k = fabs(line->along[1]) > 0 || fabs(line->along[2]) > 0;
        const double mu = k ? line->along[1] : line->at[1], nu = k ? line->along[2] : line->at[2];
        noise += closing_noise(&quartic->data->edges[e], line, quartic->data->rounding);
        constant += epsilon[e] * ratio;
        varies = varies || !line->same_ratio;
        total += line->same_ratio ? epsilon[e] * 2 * taut_log(fabs(nu / mu)) : 0.0;
    }
    quartic->closing_constant = constant;
    quartic->closing = varies ? TAUT_CLOSING_CONSTRAINT : TAUT_CLOSING_IDENTITY;
    if (!varies && !(fabs(constant + total) <= closing_cut + noise)) {
        return taut_closing_fail(quartic->data, constant + total, 0, error);
    }
    return TAUT_OK;
}

taut_status taut_quartic_fill(const taut_corner_data *data, taut_quartic *quartic,
                              taut_error *error)
{
    taut_status status = TAUT_OK;
    memset(quartic, 0, sizeof *quartic);
    quartic->data = data;
    memcpy(quartic->closing_signs, epsilon, sizeof epsilon);
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        if (!data->edges[e].straight) {
            status = fill_line(&data->edges[e], e, data->rounding, &quartic->lines[e], error);
            fill_torsions(&data->edges[e], &quartic->lines[e]);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = fill_links(quartic, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_quartic_check_signs(quartic, error);
    return status == TAUT_OK ? fill_closing(quartic, error) : status;
}

/* nu / mu at p, as a logarithm; its limit where p is infinite or an end of the interval. */
static double log_ratio(const taut_quartic_line *line, double p)
{
    const double mu = isinf(p) ? line->along[1] : line->at[1] + p * line->along[1];
    const double nu = isinf(p) ? line->along[2] : line->at[2] + p * line->along[2];
    const double small = 1e-12;
    if (fabs(mu) <= small * (fabs(line->at[1]) + fabs(isinf(p) ? 0.0 : p * line->along[1]))) {
        return INFINITY;
    }
    if (fabs(nu) <= small * (fabs(line->at[2]) + fabs(isinf(p) ? 0.0 : p * line->along[2]))) {
        return -INFINITY;
    }
    return taut_log(fabs(nu / mu));
}

void taut_quartic_ratios(const taut_quartic_line *line, const double range[2], double ratios[2])
{
    double a = 0.0, b = 0.0;
    if (line->same_ratio) {
        const int k = line->along[1] != 0.0 || line->along[2] != 0.0;
        const double *const from = k ? line->along : line->at;
        ratios[0] = ratios[1] = taut_log(fabs(from[2] / from[1]));
        return;
    }
    a = log_ratio(line, range[0]);
    b = log_ratio(line, range[1]);
    ratios[0] = fmin(a, b); /* nu / mu is a Moebius function of p: monotone */
    ratios[1] = fmax(a, b);
}
