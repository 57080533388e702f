#include "construct/asymptotic/curve_energy.h"

#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"

#include <string.h>

void taut_curve_rule_fill(int degree, int nodes, taut_curve_rule *rule)
{
    double at[TAUT_CURVE_FINE];
    rule->degree = degree;
    rule->nodes = nodes;
    taut_gauss_rule(nodes, at, rule->weight);
    for (int k = 0; k < nodes; k++) {
        double values[3 * TAUT_QUAD_POINTS];
        rule->weight[k] *= 0.5;
        taut_bernstein_eval(degree, 2, 0.5 + 0.5 * at[k], values);
        for (int d = 0; d < 3; d++) {
            memcpy(rule->basis[k][d], values + d * (degree + 1),
                   (size_t)(degree + 1) * sizeof *values);
        }
    }
}

/* phi[d][j] = phi_j^(d): the quotient rule on w_j B_j / W. */
static void quotient_basis(int n, const double basis[3][TAUT_QUAD_POINTS], const double *weights,
                           double phi[3][TAUT_QUAD_POINTS])
{
    double w[3] = {0}, inverse = 0.0, slope = 0.0, bend = 0.0;
    for (int j = 0; j <= n; j++) {
        for (int d = 0; d < 3; d++) {
            w[d] += weights[j] * basis[d][j];
        }
    }
    inverse = 1.0 / w[0];
    slope = w[1] * inverse;
    bend = w[2] * inverse;
    for (int j = 0; j <= n; j++) {
        const double factor = weights[j] * inverse;
        phi[0][j] = factor * basis[0][j];
        phi[1][j] = factor * basis[1][j] - slope * phi[0][j];
        phi[2][j] = factor * basis[2][j] - 2 * slope * phi[1][j] - bend * phi[0][j];
    }
}

/* Adds one node's part of the gradients. From dr/d(log w_k) = phi_k (P_k - r):
 *     d(r'')/d(log w_k) = phi_k'' (P_k - r) - 2 phi_k' r' - phi_k r''                            */
static void add_gradients(int n, double weight, double phi[3][TAUT_QUAD_POINTS], double r[3][3],
                          const taut_quad_edge *edge, double by_point[TAUT_QUAD_POINTS][3],
                          double by_log[TAUT_QUAD_POINTS])
{
    const double r1r2 = taut_dot(r[1], r[2]), r2r2 = taut_dot(r[2], r[2]);
    for (int k = 0; k <= n; k++) {
        double arm[3];
        taut_difference(edge->points[k], r[0], arm);
        taut_add_scaled(2 * weight * phi[2][k], r[2], by_point[k]);
        by_log[k] += 2 * weight *
                     (phi[2][k] * taut_dot(r[2], arm) - 2 * phi[1][k] * r1r2 - phi[0][k] * r2r2);
    }
}

double taut_curve_energy(const taut_curve_rule *rule, const taut_quad_edge *edge,
                         double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS])
{
    const int n = rule->degree;
    double energy = 0.0;
    if (by_point != NULL) {
        memset(by_point, 0, TAUT_QUAD_POINTS * sizeof *by_point);
        memset(by_log, 0, TAUT_QUAD_POINTS * sizeof *by_log);
    }
    for (int k = 0; k < rule->nodes; k++) {
        double phi[3][TAUT_QUAD_POINTS], r[3][3] = {{0}};
        quotient_basis(n, rule->basis[k], edge->weights, phi);
        for (int d = 0; d < 3; d++) {
            for (int j = 0; j <= n; j++) {
                taut_add_scaled(phi[d][j], edge->points[j], r[d]);
            }
        }
        energy += rule->weight[k] * taut_dot(r[2], r[2]);
        if (by_point != NULL) {
            add_gradients(n, rule->weight[k], phi, r, edge, by_point, by_log);
        }
    }
    return energy;
}
