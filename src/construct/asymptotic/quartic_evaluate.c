/* quartic_evaluate.c -- the curve energy of one branch and its gradient, forwards and backwards. */
#include "construct/asymptotic/quartic_search.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

static const double longest_log = 40.0; /* weights outside e^+-40 are no solution */

double taut_quartic_p_of(const taut_quartic_search *s, int e, double x)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    const int k = s->kind[e];
    return k == TAUT_BY_P ? x : (s->signs[e] * taut_exp(x) - line->at[k]) / line->along[k];
}

/* Fills the numbers that follow from p; 0 if mu or nu has the wrong sign. Where nu / mu is asked
 * for (else NULL) the smaller of them, a difference that may have lost its digits, follows from the
 * larger: the ring then closes to the last digit. */
static int edge_at(const taut_quartic_search *s, int e, double p, const double *log_ratio,
                   taut_quartic_state *at)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    const taut_corner_edge *const edge = &s->quartic->data->edges[e];
    double base = 0.0;
    at->p = p;
    at->mu = line->at[1] + p * line->along[1];
    at->nu = line->at[2] + p * line->along[2];
    if (!(s->signs[e] * at->mu > 0) || !(s->signs[e] * at->nu > 0) || !isfinite(p)) {
        return 0;
    }
    at->log_mu = taut_log(fabs(at->mu));
    at->log_nu = taut_log(fabs(at->nu));
    if (log_ratio != NULL && *log_ratio < 0) {
        at->log_nu = at->log_mu + *log_ratio;
    } else if (log_ratio != NULL) {
        at->log_mu = at->log_nu - *log_ratio;
    }
    base = 0.5 * (edge->bend[1] - edge->bend[0]);
    for (int k = 0; k < 2; k++) {
        const double own = k == 0 ? at->log_mu : at->log_nu;
        const double other = k == 0 ? at->log_nu : at->log_mu;
        const double numerator = fabs(line->torsion[k]);
        at->torsion[k] =
            (k == 0 ? base : -base) + 0.5 * other - 1.5 * own + taut_log(0.5 * edge->weight[k]) +
            (numerator > 0 ? taut_log(numerator) : 0.0) - 2 * taut_log(taut_norm(edge->normal[k]));
    }
    return 1;
}

/* log(nu / mu) that the closing condition asks of the closer, given the other edges. */
static double closing_ratio(const taut_quartic_search *s, const taut_quartic_state at[4])
{
    const int *const sign = s->quartic->closing_signs;
    double sum = s->quartic->closing_constant;
    for (int e = 0; e < 4; e++) {
        if (e != s->closer) {
            sum += 2 * sign[e] * (at[e].log_nu - at[e].log_mu);
        }
    }
    return -sum / (2 * sign[s->closer]);
}

/* p where nu = ratio mu. */
double taut_quartic_p_of_ratio(const taut_quartic_line *line, double ratio)
{
    return (line->at[2] - ratio * line->at[1]) / (ratio * line->along[1] - line->along[2]);
}

/* Unknowns to the states of all edges; 0 outside the domain. */
int taut_quartic_forwards(const taut_quartic_search *s, const double *x, taut_quartic_state at[4])
{
    for (int e = 0; e < 4; e++) {
        if (s->variable[e] >= 0) {
            const taut_quartic_line *const line = &s->quartic->lines[e];
            const int k = s->kind[e];
            const double p = taut_quartic_p_of(s, e, x[s->variable[e]]);
            if (!edge_at(s, e, p, NULL, &at[e])) {
                return 0;
            }
            at[e].slope =
                k == TAUT_BY_P ? 1.0 : (k == TAUT_BY_MU ? at[e].mu : at[e].nu) / line->along[k];
        }
    }
    if (s->closer >= 0) {
        const double log_ratio = closing_ratio(s, at);
        if (!edge_at(s, s->closer,
                     taut_quartic_p_of_ratio(&s->quartic->lines[s->closer], taut_exp(log_ratio)),
                     &log_ratio, &at[s->closer])) {
            return 0;
        }
    }
    for (int e = 0; e < 4; e++) {
        if (s->root_of[e] >= 0) {
            at[e].log_w2 = x[s->root_of[e]];
        }
    }
    for (int k = 0; k < s->link_count; k++) {
        const taut_quartic_link *const l = &s->links[k];
        at[l->to].log_w2 =
            at[l->from].log_w2 + at[l->to].torsion[l->to_end] - at[l->from].torsion[l->from_end];
    }
    return 1;
}

/* Control points and weights of one edge from its state ((4.1), (4.2)). */
static int place_edge(const taut_quartic_search *s, int e, const taut_quartic_state *at,
                      taut_quad_edge *made)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    const taut_corner_edge *const edge = &s->quartic->data->edges[e];
    const double log_w1 = 0.5 * (edge->bend[0] + at->log_w2 + at->log_mu);
    const double log_w3 = 0.5 * (edge->bend[1] + at->log_w2 + at->log_nu);
    if (!(fmax(fabs(at->log_w2), fmax(fabs(log_w1), fabs(log_w3))) < longest_log)) {
        return 0;
    }
    for (int k = 0; k < 3; k++) {
        made->points[0][k] = edge->point[0][k];
        made->points[1][k] = edge->point[0][k] + edge->leg[0][k];
        made->points[2][k] = edge->point[0][k] +
                             (line->at[0] + at->p * line->along[0]) * edge->leg[0][k] +
                             at->mu * edge->partner[0][k];
        made->points[3][k] = edge->point[1][k] - edge->leg[1][k];
        made->points[4][k] = edge->point[1][k];
    }
    made->weights[0] = edge->weight[0];
    made->weights[1] = taut_exp(log_w1);
    made->weights[2] = taut_exp(at->log_w2);
    made->weights[3] = taut_exp(log_w3);
    made->weights[4] = edge->weight[1];
    return 1;
}

/* The energy of one edge, and its derivatives by p (through P_2), log mu, log nu and log w_2. */
static double edge_energy(const taut_quartic_search *s, int e, const taut_quad_edge *made,
                          taut_quartic_state *at)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    const taut_corner_edge *const edge = &s->quartic->data->edges[e];
    double by_point[TAUT_QUAD_POINTS][3], by_log[TAUT_QUAD_POINTS];
    const double energy = taut_curve_energy(s->rule, made, by_point, by_log);
    at->p_bar = line->along[0] * taut_dot(by_point[2], edge->leg[0]) +
                line->along[1] * taut_dot(by_point[2], edge->partner[0]);
    at->log_w2_bar = by_log[2] + 0.5 * (by_log[1] + by_log[3]);
    at->log_mu_bar = 0.5 * by_log[1];
    at->log_nu_bar = 0.5 * by_log[3];
    return energy;
}

/* Derivatives back from the weights to log mu and log nu. */
static void backwards_links(const taut_quartic_search *s, taut_quartic_state at[4])
{
    for (int k = s->link_count - 1; k >= 0; k--) {
        const taut_quartic_link *const l = &s->links[k];
        at[l->from].log_w2_bar += at[l->to].log_w2_bar;
        at[l->to].torsion_bar[l->to_end] += at[l->to].log_w2_bar;
        at[l->from].torsion_bar[l->from_end] -= at[l->to].log_w2_bar;
    }
    for (int e = 0; e < 4; e++) {
        at[e].log_mu_bar += 0.5 * at[e].torsion_bar[1] - 1.5 * at[e].torsion_bar[0];
        at[e].log_nu_bar += 0.5 * at[e].torsion_bar[0] - 1.5 * at[e].torsion_bar[1];
    }
}

static double total_p_bar(const taut_quartic_search *s, int e, const taut_quartic_state *at)
{
    const taut_quartic_line *const line = &s->quartic->lines[e];
    return at->p_bar + at->log_mu_bar * line->along[1] / at->mu +
           at->log_nu_bar * line->along[2] / at->nu;
}

static void backwards(const taut_quartic_search *s, taut_quartic_state at[4], double *gradient)
{
    backwards_links(s, at);
    if (s->closer >= 0) {
        const int *const sign = s->quartic->closing_signs;
        const taut_quartic_line *const line = &s->quartic->lines[s->closer];
        const double ratio = at[s->closer].nu / at[s->closer].mu;
        const double bottom = ratio * line->along[1] - line->along[2];
        const double p_slope =
            (line->at[1] * line->along[2] - line->at[2] * line->along[1]) / (bottom * bottom);
        const double ratio_bar = total_p_bar(s, s->closer, &at[s->closer]) * p_slope * ratio;
        for (int e = 0; e < 4; e++) {
            if (e != s->closer) {
                at[e].log_nu_bar -= ratio_bar * sign[e] / sign[s->closer];
                at[e].log_mu_bar += ratio_bar * sign[e] / sign[s->closer];
            }
        }
    }
    for (int e = 0; e < 4; e++) {
        if (s->variable[e] >= 0) {
            gradient[s->variable[e]] = total_p_bar(s, e, &at[e]) * at[e].slope;
        }
        if (s->root_of[e] >= 0) {
            gradient[s->root_of[e]] = at[e].log_w2_bar;
        }
    }
}

int taut_quartic_objective(void *search, const double *x, double *value, double *gradient)
{
    taut_quartic_search *const s = search;
    taut_quartic_state at[4];
    memset(at, 0, sizeof at);
    if (!taut_quartic_forwards(s, x, at)) {
        return 0;
    }
    *value = 0.0;
    for (int e = 0; e < 4; e++) {
        if (!s->quartic->data->edges[e].straight) {
            if (!place_edge(s, e, &at[e], &s->quad.edges[e])) {
                return 0;
            }
            *value += edge_energy(s, e, &s->quad.edges[e], &at[e]);
        }
    }
    backwards(s, at, gradient);
    return 1;
}
