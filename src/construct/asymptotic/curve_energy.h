/* curve_energy.h -- the energy of one rational Bezier curve and its gradient.
 *
 *     A = int_0^1 |r''(t)|^2 dt,     r = sum_j P_j phi_j,   phi_j = w_j B_j / W
 */
#ifndef TAUT_ASYMPTOTIC_CURVE_ENERGY_H
#define TAUT_ASYMPTOTIC_CURVE_ENERGY_H

#include "construct/asymptotic/quad.h"

/* Gauss nodes. FINE: 1e-13 relative on all worked examples; COARSE finds the way there. */
enum { TAUT_CURVE_COARSE = 20, TAUT_CURVE_FINE = 64 };

/* Bernstein functions and two derivatives at the Gauss nodes of [0, 1]. */
typedef struct taut_curve_rule {
    int degree, nodes;
    double weight[TAUT_CURVE_FINE];
    double basis[TAUT_CURVE_FINE][3][TAUT_QUAD_POINTS];
} taut_curve_rule;

/* nodes at most TAUT_CURVE_FINE */
void taut_curve_rule_fill(int degree, int nodes, taut_curve_rule *rule);

/* The energy of the curve; with gradients not NULL also
 *     by_point[j] = dA/dP_j,   by_log[j] = dA/d(log w_j)                                        */
double taut_curve_energy(const taut_curve_rule *rule, const taut_quad_edge *edge,
                         double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS]);

#endif /* TAUT_ASYMPTOTIC_CURVE_ENERGY_H */
