/* quintic.c -- Algorithm 1 for degree 5 (docs page section 4.4).
 *
 * Unknowns of a curved edge:
 *     P_2 = A_0 + lambda a_0 + mu c_0     in the corner planes, mu = +-e^m, nu = +-e^q
 *     P_3 = A_1 + rho a_1 + nu c_1
 *     theta_0, theta_1 = log |tau| at the ends, one number for the two edges of a corner
 * so that the corner torsions match by construction. Curvatures give w_1 and w_4; with l_j = log w_j
 *     theta_0 = l_3 - 3/2 l_2 + g_0,   theta_1 = l_2 - 3/2 l_3 + g_1
 * give w_2 and w_3. No closing condition is left.
 */
#include "construct/asymptotic/corner_data.h"
#include "construct/asymptotic/family.h"
#include "construct/asymptotic/starts.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

static const double longest_log = 40.0; /* weights outside e^+-40 are no solution */
enum { DRAWS_MAX = 200 };

/* Places of an edge's own unknowns, counted from its first. */
enum { LAMBDA, LOG_MU, LOG_NU, RHO, OWN };
enum { N = 5 };

typedef struct search {
    const taut_corner_data *data;
    const taut_curve_rule *rule;
    const int *signs;
    int first[4];           /* index of an edge's own unknowns, -1 if straight */
    int theta[4][2];        /* index of an end's log |tau| */
    int torsion_sign[4][2]; /* of n.(P_3 - P_0), fixed by the start; 0: not yet */
    int count;
    taut_quad quad;
} search;

static void plan_unknowns(const taut_corner_data *data, const int signs[4], search *s)
{
    memset(s, 0, sizeof *s);
    s->data = data;
    s->signs = signs;
    s->quad.degree = N;
    for (int e = 0; e < 4; e++) {
        s->first[e] = -1;
        if (data->edges[e].straight) {
            taut_corner_straight(data, e, N, &s->quad.edges[e]);
            continue;
        }
        s->first[e] = s->count;
        s->count += OWN;
    }
    for (int c = 0; c < 4; c++) {
        const int shared = s->count;
        for (int k = 0; k < 2; k++) {
            const taut_quad_meeting *const m = &taut_quad_corner[c][k];
            if (s->first[m->edge] >= 0) {
                s->theta[m->edge][m->end] = shared;
                s->count = shared + 1;
            }
        }
    }
}

/* The control points of edge e but P_1 and P_4 from its unknowns y. */
static void place_points(const search *s, int e, const double *y, taut_quad_edge *made)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    double(*const p)[3] = made->points;
    for (int k = 0; k < 3; k++) {
        p[0][k] = edge->point[0][k];
        p[2][k] = edge->point[0][k] + y[LAMBDA] * edge->leg[0][k] +
                  s->signs[e] * taut_exp(y[LOG_MU]) * edge->partner[0][k];
        p[3][k] = edge->point[1][k] + y[RHO] * edge->leg[1][k] +
                  s->signs[e] * taut_exp(y[LOG_NU]) * edge->partner[1][k];
        p[5][k] = edge->point[1][k];
    }
}

/* n.(P_3 - P_0) at end 0, n.(P_2 - P_5) at end 1. */
static double torsion_numerator(const search *s, int e, int end, const taut_quad_edge *made)
{
    double arm[3];
    taut_difference(made->points[end == 0 ? 3 : 2], made->points[end == 0 ? 0 : N], arm);
    return taut_dot(s->data->edges[e].normal[end], arm);
}

/* theta - (l_3 - 3/2 l_2) at an end: what the torsion has besides its weights. */
static double torsion_rest(const search *s, int e, int end, const double *y, double numerator)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    return taut_log((N - 2.0) / N * edge->weight[end]) + taut_log(fabs(numerator)) -
           2 * taut_log(taut_norm(edge->normal[end])) - 1.5 * y[end == 0 ? LOG_MU : LOG_NU] -
           0.5 * edge->bend[end];
}

/* h of an end. */
static double raising(const search *s, int e, int end)
{
    return (s->data->raised - N) * s->data->edges[e].weight[end] / N;
}

/* All weights of edge e, and P_1 and P_4; scale: s at the two ends. */
static int place_weights(const search *s, int e, const double *x, const double numerator[2],
                         taut_quad_edge *made, double scale[2])
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    const double *const y = x + s->first[e];
    double h[2], l[N + 1];
    for (int k = 0; k < 2; k++) {
        h[k] = x[s->theta[e][k]] - torsion_rest(s, e, k, y, numerator[k]);
    }
    l[2] = -(h[1] + 1.5 * h[0]) / 1.25;
    l[3] = -(h[0] + 1.5 * h[1]) / 1.25;
    l[1] = 0.5 * (edge->bend[0] + l[2] + y[LOG_MU]);
    l[4] = 0.5 * (edge->bend[1] + l[3] + y[LOG_NU]);
    for (int j = 1; j < N; j++) {
        if (!(fabs(l[j]) < longest_log)) {
            return 0;
        }
        made->weights[j] = taut_exp(l[j]);
    }
    made->weights[0] = edge->weight[0];
    made->weights[N] = edge->weight[1];
    for (int k = 0; k < 2; k++) {
        const int j = k == 0 ? 1 : 4;
        const double whole = made->weights[j];
        made->weights[j] -= raising(s, e, k);
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
static void backwards(const search *s, int e, const double *x, const double numerator[2],
                      const double scale[2], double by_point[TAUT_QUAD_POINTS][3],
                      double by_log[TAUT_QUAD_POINTS], double *gradient)
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
    g[LOG_MU] = 0.5 * by_log[1];
    g[LOG_NU] = 0.5 * by_log[4];
    h[0] = -(1.5 * by_log[2] + by_log[3]) / 1.25;
    h[1] = -(by_log[2] + 1.5 * by_log[3]) / 1.25;
    for (int k = 0; k < 2; k++) {
        gradient[s->theta[e][k]] += h[k];
        g[k == 0 ? LOG_MU : LOG_NU] += 1.5 * h[k];
        taut_add_scaled(-h[k] / numerator[k], edge->normal[k], by_point[k == 0 ? 3 : 2]);
    }
    g[LAMBDA] = taut_dot(by_point[2], edge->leg[0]);
    g[RHO] = taut_dot(by_point[3], edge->leg[1]);
    g[LOG_MU] += s->signs[e] * taut_exp(y[LOG_MU]) * taut_dot(by_point[2], edge->partner[0]);
    g[LOG_NU] += s->signs[e] * taut_exp(y[LOG_NU]) * taut_dot(by_point[3], edge->partner[1]);
}

static int objective(void *context, const double *x, double *value, double *gradient)
{
    search *const s = context;
    *value = 0.0;
    memset(gradient, 0, (size_t)s->count * sizeof *gradient);
    for (int e = 0; e < 4; e++) {
        taut_quad_edge *const made = &s->quad.edges[e];
        double by_point[TAUT_QUAD_POINTS][3], by_log[TAUT_QUAD_POINTS];
        double numerator[2], scale[2];
        if (s->first[e] < 0) {
            continue;
        }
        place_points(s, e, x + s->first[e], made);
        for (int k = 0; k < 2; k++) {
            numerator[k] = torsion_numerator(s, e, k, made);
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

/* Signs of the torsions' numerators as they are; 0 unless torsions are opposite at every corner
 * where two curved edges meet. */
static int set_signs(search *s, const double *x)
{
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 2 && s->first[e] >= 0; k++) {
            place_points(s, e, x + s->first[e], &s->quad.edges[e]);
            s->torsion_sign[e][k] = torsion_numerator(s, e, k, &s->quad.edges[e]) > 0 ? 1 : -1;
        }
    }
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const m = taut_quad_corner[c];
        int product = 1;
        for (int k = 0; k < 2; k++) {
            product *= s->signs[m[k].edge] * s->torsion_sign[m[k].edge][m[k].end] *
                       (m[k].end == 0 ? 1 : -1);
        }
        if (product > 0) {
            return 0;
        }
    }
    return 1;
}

/* The guess for an edge's own unknowns, disturbed by noise of the given size: a guess as
 * for evenly spaced points, side weights near the geometric means of their neighbours. */
static void guess_edge(const search *s, int e, double size, uint64_t *noise, double *y)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    const double raise = 2 * taut_log((double)s->data->raised / N);
    y[LAMBDA] = 2.0 + size * taut_noise(noise);
    y[RHO] = -2.0 + size * taut_noise(noise);
    y[LOG_MU] = taut_log(edge->weight[0]) - edge->bend[0] + raise + size * taut_noise(noise);
    y[LOG_NU] = taut_log(edge->weight[1]) - edge->bend[1] + raise + size * taut_noise(noise);
}

/* A start whose torsions can match; 0 if none is drawn. Torsions begin as the mean of what
 * weights of 1 give the two edges of a corner. */
static int draw_start(void *context, int number, uint64_t *noise, double *x)
{
    search *const s = context;
    int ends[4] = {0};
    int fits = 0;
    for (int draw = 0; draw < DRAWS_MAX && !fits; draw++) {
        const double size = number == 0 && draw == 0 ? 0.0 : 0.4 + 0.01 * draw;
        for (int e = 0; e < 4; e++) {
            if (s->first[e] >= 0) {
                guess_edge(s, e, size, noise, x + s->first[e]);
            }
        }
        fits = set_signs(s, x);
    }
    for (int c = 0; c < 4 && fits; c++) {
        double sum = 0.0;
        int place = -1;
        for (int k = 0; k < 2; k++) {
            const taut_quad_meeting *const m = &taut_quad_corner[c][k];
            if (s->first[m->edge] >= 0) {
                place = s->theta[m->edge][m->end];
                sum += torsion_rest(s, m->edge, m->end, x + s->first[m->edge],
                                    torsion_numerator(s, m->edge, m->end, &s->quad.edges[m->edge]));
                ends[c]++;
            }
        }
        if (place >= 0) {
            x[place] = sum / ends[c];
        }
    }
    return fits;
}

static void fix_signs(void *context, const double *x)
{
    (void)set_signs(context, x);
}

static taut_status prepare(const taut_corner_data *data, void *room, taut_closing *closing,
                           taut_error *error)
{
    const taut_corner_data **const kept = room;
    (void)error;
    *closing = TAUT_CLOSING_NONE;
    *kept = data;
    return TAUT_OK;
}

/* The torsions' signs are as free as P_3 is: every choice may have a minimum. */
static int allows(const void *room, const int signs[4])
{
    (void)room;
    (void)signs;
    return 1;
}

static void minimise(const void *room, const int signs[4], double *work, taut_pulse *pulse,
                     taut_branch *branch)
{
    const taut_corner_data *const data = *(const taut_corner_data *const *)room;
    search s;
    taut_start_plan plan = {
        .starts = 6, .objective = objective, .start = draw_start, .begin = fix_signs};
    double x[TAUT_MINIMISE_MAX];
    plan_unknowns(data, signs, &s);
    plan.count = s.count;
    plan.context = &s;
    plan.work = work;
    plan.pulse = pulse;
    plan.rule = &s.rule;
    plan.coarse = &data->coarse;
    plan.fine = &data->fine;
    memcpy(branch->signs, signs, sizeof branch->signs);
    branch->gap = 0.0;
    branch->found = taut_starts_run(&plan, x, &branch->energy);
    branch->unknowns = s.count;
    branch->quad = s.quad;
}

const taut_family taut_family_quintic = {sizeof(const taut_corner_data *), prepare, allows,
                                         minimise};
