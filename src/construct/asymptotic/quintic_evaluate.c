/* quintic_evaluate.c -- the curve energy of one branch of degree 5 and its derivatives. */
#include "construct/asymptotic/quintic_search.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

static const double longest_log = 40.0; /* weights outside e^+-40 are no solution */

void taut_quintic_points(const taut_quintic_search *s, int e, const double *y, taut_quad_edge *made)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    double(*const p)[3] = made->points;
    for (int k = 0; k < 3; k++) {
        p[0][k] = edge->point[0][k];
        p[2][k] = edge->point[0][k] + y[TAUT_QUINTIC_LAMBDA] * edge->leg[0][k] +
                  s->signs[e] * taut_exp(y[TAUT_QUINTIC_LOG_MU]) * edge->partner[0][k];
        p[3][k] = edge->point[1][k] + y[TAUT_QUINTIC_RHO] * edge->leg[1][k] +
                  s->signs[e] * taut_exp(y[TAUT_QUINTIC_LOG_NU]) * edge->partner[1][k];
        p[5][k] = edge->point[1][k];
    }
}

double taut_quintic_numerator(const taut_quintic_search *s, int e, int end,
                              const taut_quad_edge *made)
{
    double arm[3];
    taut_difference(made->points[end == 0 ? 3 : 2], made->points[end == 0 ? 0 : TAUT_QUINTIC], arm);
    return taut_dot(s->data->edges[e].normal[end], arm);
}

double taut_quintic_rest(const taut_quintic_search *s, int e, int end, const double *y,
                         double numerator)
{
    return s->fixed[e][end] + taut_log(fabs(numerator)) -
           1.5 * y[end == 0 ? TAUT_QUINTIC_LOG_MU : TAUT_QUINTIC_LOG_NU];
}

double taut_quintic_raising(const taut_quintic_search *s, int e, int end)
{
    return (s->data->raised - TAUT_QUINTIC) * s->data->edges[e].weight[end] / TAUT_QUINTIC;
}

/* All weights of edge e, and P_1 and P_4; scale: s at the two ends. */
static int place_weights(const taut_quintic_search *s, int e, const double *x,
                         const double numerator[2], taut_quad_edge *made, double scale[2])
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    const double *const y = x + s->first[e];
    double h[2], l[TAUT_QUINTIC + 1];
    for (int k = 0; k < 2; k++) {
        h[k] = x[s->theta[e][k]] - taut_quintic_rest(s, e, k, y, numerator[k]);
    }
    l[2] = -(h[1] + 1.5 * h[0]) / 1.25;
    l[3] = -(h[0] + 1.5 * h[1]) / 1.25;
    l[1] = 0.5 * (edge->bend[0] + l[2] + y[TAUT_QUINTIC_LOG_MU]);
    l[4] = 0.5 * (edge->bend[1] + l[3] + y[TAUT_QUINTIC_LOG_NU]);
    for (int j = 1; j < TAUT_QUINTIC; j++) {
        if (!(fabs(l[j]) < longest_log)) {
            return 0;
        }
        made->weights[j] = taut_exp(l[j]);
    }
    made->weights[0] = edge->weight[0];
    made->weights[TAUT_QUINTIC] = edge->weight[1];
    for (int k = 0; k < 2; k++) {
        const int j = k == 0 ? 1 : 4;
        const double whole = made->weights[j];
        made->weights[j] -= taut_quintic_raising(s, e, k);
        if (!(made->weights[j] > 0)) {
            return 0;
        }
        scale[k] = whole / made->weights[j];
        memcpy(made->points[j], edge->point[k], sizeof made->points[j]);
        taut_add_scaled(k == 0 ? scale[k] : -scale[k], edge->leg[k], made->points[j]);
    }
    return 1;
}

/* Back from the derivatives by points and log weights to those by the unknowns. */
static void backwards(const taut_quintic_search *s, int e, const double *x,
                      const double numerator[2], const double scale[2],
                      double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS],
                      double *gradient)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    const double *const y = x + s->first[e];
    double *const g = gradient + s->first[e];
    double h[2];

    for (int k = 0; k < 2; k++) { /* d log w_1 / d log(w_1 + h) = s, ds = s (1 - s) */
        const int j = k == 0 ? 1 : 4;
        const double along = taut_dot(by_point[j], edge->leg[k]) * (k == 0 ? 1.0 : -1.0);
        by_log[j] = scale[k] * (by_log[j] + (1.0 - scale[k]) * along);
    }
    by_log[2] += 0.5 * by_log[1];
    by_log[3] += 0.5 * by_log[4];
    g[TAUT_QUINTIC_LOG_MU] = 0.5 * by_log[1];
    g[TAUT_QUINTIC_LOG_NU] = 0.5 * by_log[4];
    h[0] = -(1.5 * by_log[2] + by_log[3]) / 1.25;
    h[1] = -(by_log[2] + 1.5 * by_log[3]) / 1.25;
    for (int k = 0; k < 2; k++) {
        gradient[s->theta[e][k]] += h[k];
        g[k == 0 ? TAUT_QUINTIC_LOG_MU : TAUT_QUINTIC_LOG_NU] += 1.5 * h[k];
        taut_add_scaled(-h[k] / numerator[k], edge->normal[k], by_point[k == 0 ? 3 : 2]);
    }
    g[TAUT_QUINTIC_LAMBDA] = taut_dot(by_point[2], edge->leg[0]);
    g[TAUT_QUINTIC_RHO] = taut_dot(by_point[3], edge->leg[1]);
    g[TAUT_QUINTIC_LOG_MU] +=
        s->signs[e] * taut_exp(y[TAUT_QUINTIC_LOG_MU]) * taut_dot(by_point[2], edge->partner[0]);
    g[TAUT_QUINTIC_LOG_NU] +=
        s->signs[e] * taut_exp(y[TAUT_QUINTIC_LOG_NU]) * taut_dot(by_point[3], edge->partner[1]);
}

int taut_quintic_objective(void *context, const double *x, double *value, double *gradient)
{
    taut_quintic_search *const s = context;
    *value = 0.0;
    memset(gradient, 0, (size_t)s->count * sizeof *gradient);
    for (int e = 0; e < 4; e++) {
        taut_quad_edge *const made = &s->quad.edges[e];
        double by_point[TAUT_QUAD_POINTS][3], by_log[TAUT_QUAD_POINTS];
        double numerator[2], scale[2];
        if (s->first[e] < 0) {
            continue;
        }
        taut_quintic_points(s, e, x + s->first[e], made);
        for (int k = 0; k < 2; k++) {
            numerator[k] = taut_quintic_numerator(s, e, k, made);
            if (!(numerator[k] * s->torsion_sign[e][k] > 0)) {
                return 0;
            }
        }
        if (!place_weights(s, e, x, numerator, made, scale)) {
            return 0;
        }
        *value += taut_curve_energy(s->rule, made, by_point, by_log);
        backwards(s, e, x, numerator, scale, by_point, by_log, gradient);
    }
    return 1;
}
