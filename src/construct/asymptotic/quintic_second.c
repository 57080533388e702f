/* quintic_second.c -- the second derivatives of the curve energy of one branch of degree 5.
 *
 * Each edge has six unknowns, its own four and the torsions at its ends; its control points and
 * weights, the ways, are jets of them, and the energy's derivatives by the ways are closed:
 *     d2A = sum A_ab dz_a dz_b + sum A_a d2z_a
 */
#include "construct/asymptotic/quintic_search.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "numeric/jet.h"

#include <string.h>

/* The unknowns of an edge in its jets, behind its own four. */
enum { THETA_0 = TAUT_QUINTIC_OWN, THETA_1 };
/* Its ways in their order: P_1, P_2 twice, P_3 twice, P_4; then log w_1 .. log w_4. */
enum { SCALE_0, LAMBDA, MU, RHO, NU, SCALE_1, MOVES, LOG_WEIGHT = MOVES - 1, WAYS = MOVES + 4 };

typedef struct edge_ways {
    taut_jet z[WAYS];
    double leg[3]; /* the last one, backwards */
    taut_curve_moves moves;
} edge_ways;

static void fill_moves(const taut_corner_edge *edge, edge_ways *ways)
{
    const double *const direction[MOVES] = {edge->leg[0], edge->leg[0],     edge->partner[0],
                                            edge->leg[1], edge->partner[1], ways->leg};
    static const int point[MOVES] = {1, 2, 2, 3, 3, 4};
    ways->moves.count = MOVES;
    memcpy(ways->moves.point, point, sizeof point);
    memcpy(ways->moves.direction, direction, sizeof direction);
    for (int k = 0; k < 3; k++) {
        ways->leg[k] = -edge->leg[1][k];
    }
}

/* h of an end: theta - (l_3 - 3/2 l_2) without the weights; log |n.(P_3 - P_0)| is the curved part
 * of it. */
static taut_jet end_height(const taut_quintic_search *s, int e, int end, const double *x,
                           const edge_ways *ways)
{
    const taut_corner_edge *const edge = &s->data->edges[e];
    const double *const y = x + s->first[e];
    const double value = taut_quintic_numerator(s, e, end, &s->quad.edges[e]);
    taut_jet numerator = taut_jet_constant(0.0), height = taut_jet_variable(0.0, THETA_0 + end);
    taut_jet_add(taut_dot(edge->normal[end], edge->leg[1 - end]), &ways->z[end == 0 ? RHO : LAMBDA],
                 &numerator);
    taut_jet_add(taut_dot(edge->normal[end], edge->partner[1 - end]), &ways->z[end == 0 ? NU : MU],
                 &numerator);
    numerator.value = value;
    numerator = taut_jet_log(&numerator);
    taut_jet_add(-1.0, &numerator, &height);
    height.by[end == 0 ? TAUT_QUINTIC_LOG_MU : TAUT_QUINTIC_LOG_NU] += 1.5;
    height.value = x[s->theta[e][end]] - taut_quintic_rest(s, e, end, y, value);
    return height;
}

/* log w_1 or log w_4, and how far the leg is stretched to it where the degree is raised later. */
static void fill_side(const taut_quintic_search *s, int e, int end, const double *y,
                      const taut_jet *next, edge_ways *ways)
{
    const double raising = taut_quintic_raising(s, e, end);
    const int own = end == 0 ? TAUT_QUINTIC_LOG_MU : TAUT_QUINTIC_LOG_NU;
    taut_jet *const log_weight = &ways->z[LOG_WEIGHT + (end == 0 ? 1 : 4)];
    taut_jet *const scale = &ways->z[end == 0 ? SCALE_0 : SCALE_1];
    taut_jet whole = taut_jet_constant(0.0);
    taut_jet_add(0.5, next, &whole);
    whole.value += 0.5 * (s->data->edges[e].bend[end] + y[own]);
    whole.by[own] += 0.5;
    *scale = taut_jet_constant(1.0);
    *log_weight = whole;
    if (raising != 0.0) {
        taut_jet weight = taut_jet_exp(&whole);
        weight.value -= raising;
        *log_weight = taut_jet_log(&weight);
        taut_jet_add(-1.0, log_weight, &whole);
        *scale = taut_jet_exp(&whole);
    }
}

static void fill_ways(const taut_quintic_search *s, int e, const double *x, edge_ways *ways)
{
    const double *const y = x + s->first[e];
    const taut_jet log_mu = taut_jet_variable(y[TAUT_QUINTIC_LOG_MU], TAUT_QUINTIC_LOG_MU);
    const taut_jet log_nu = taut_jet_variable(y[TAUT_QUINTIC_LOG_NU], TAUT_QUINTIC_LOG_NU);
    const taut_jet mu = taut_jet_exp(&log_mu), nu = taut_jet_exp(&log_nu);
    taut_jet *const z = ways->z;
    taut_jet h[2];
    fill_moves(&s->data->edges[e], ways);
    z[LAMBDA] = taut_jet_variable(y[TAUT_QUINTIC_LAMBDA], TAUT_QUINTIC_LAMBDA);
    z[RHO] = taut_jet_variable(y[TAUT_QUINTIC_RHO], TAUT_QUINTIC_RHO);
    z[MU] = z[NU] = taut_jet_constant(0.0);
    taut_jet_add(s->signs[e], &mu, &z[MU]);
    taut_jet_add(s->signs[e], &nu, &z[NU]);
    for (int k = 0; k < 2; k++) {
        h[k] = end_height(s, e, k, x, ways);
    }
    for (int k = 0; k < 2; k++) { /* l_2 = -(h_1 + 3/2 h_0) / (5/4) */
        taut_jet *const inner = &z[LOG_WEIGHT + 2 + k];
        *inner = taut_jet_constant(0.0);
        taut_jet_add(-1.0 / 1.25, &h[1 - k], inner);
        taut_jet_add(-1.5 / 1.25, &h[k], inner);
        fill_side(s, e, k, y, inner, ways);
    }
}

/* The lower triangle, as jets keep it, of the energy's Hessian by the edge's six unknowns. */
static void edge_second(const taut_quintic_search *s, int e, const double *x,
                        double hessian[TAUT_JET_PAIRS])
{
    double first[TAUT_CURVE_WAYS], second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS];
    edge_ways ways;
    fill_ways(s, e, x, &ways);
    taut_curve_second(s->rule, &s->quad.edges[e], &ways.moves, first, second);
    memset(hessian, 0, TAUT_JET_PAIRS * sizeof *hessian);
    for (int a = 0; a < WAYS; a++) {
        double row[TAUT_JET_SIZE] = {0};
        for (int b = 0; b < WAYS; b++) {
            const double entry = a >= b ? second[a][b] : second[b][a];
            for (int i = 0; i < TAUT_JET_SIZE; i++) {
                row[i] += entry * ways.z[b].by[i];
            }
        }
        for (int i = 0, k = 0; i < TAUT_JET_SIZE; i++) {
            for (int j = 0; j <= i; j++, k++) {
                hessian[k] += ways.z[a].by[i] * row[j] + first[a] * ways.z[a].second[k];
            }
        }
    }
}

void taut_quintic_hessian(void *search, const double *x, double *hessian)
{
    const taut_quintic_search *const s = search;
    memset(hessian, 0, (size_t)s->count * (size_t)s->count * sizeof *hessian);
    for (int e = 0; e < 4; e++) {
        double part[TAUT_JET_PAIRS];
        if (s->first[e] < 0) {
            continue;
        }
        edge_second(s, e, x, part);
        for (int i = 0, k = 0; i < TAUT_JET_SIZE; i++) {
            const int row = i < THETA_0 ? s->first[e] + i : s->theta[e][i - THETA_0];
            for (int j = 0; j <= i; j++, k++) {
                const int column = j < THETA_0 ? s->first[e] + j : s->theta[e][j - THETA_0];
                hessian[row * s->count + column] += part[k];
                hessian[column * s->count + row] += row != column ? part[k] : 0.0;
            }
        }
    }
}
