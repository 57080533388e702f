/* curve_energy.h -- the energy of one rational Bezier curve and its derivatives.
 *
 *     A = int_0^1 |r''(t)|^2 dt,     r = sum_j P_j phi_j,   phi_j = w_j B_j / W
 */
#ifndef TAUT_ASYMPTOTIC_CURVE_ENERGY_H
#define TAUT_ASYMPTOTIC_CURVE_ENERGY_H

#include "construct/asymptotic/quad.h"

/* Gauss nodes. FINE: 1e-13 relative on all worked examples; COARSE finds the way there. LANES of them
 * are worked on side by side. */
enum { TAUT_CURVE_COARSE = 20, TAUT_CURVE_FINE = 64, TAUT_CURVE_LANES = 4 };

/* Bernstein functions and two derivatives at the Gauss nodes of [0, 1]. */
typedef struct taut_curve_rule {
    int degree, nodes;
    double weight[TAUT_CURVE_FINE];
    double basis[TAUT_CURVE_FINE / TAUT_CURVE_LANES][3][TAUT_QUAD_POINTS][TAUT_CURVE_LANES];
} taut_curve_rule;

/* nodes: at most TAUT_CURVE_FINE, a multiple of TAUT_CURVE_LANES */
void taut_curve_rule_fill(int degree, int nodes, taut_curve_rule *rule);

/* The energy of the curve; with gradients not NULL also
 *     by_point[j] = dA/dP_j,   by_log[j] = dA/d(log w_j)                                        */
double taut_curve_energy(const taut_curve_rule *rule, const taut_quad_edge *edge,
                         double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS]);

/* Points that move on lines, P_j + z d, one number z each; a point may have several. */
enum { TAUT_CURVE_MOVES = 6, TAUT_CURVE_WAYS = TAUT_CURVE_MOVES + TAUT_QUAD_POINTS - 2 };
typedef struct taut_curve_moves {
    int count;
    int point[TAUT_CURVE_MOVES];
    const double *direction[TAUT_CURVE_MOVES];
} taut_curve_moves;

/* The energy's first and second derivatives by the moves, in their order, and after them by the
 * logarithms of the inner weights w_1 .. w_n-1; second: the lower triangle, i >= j, only. */
void taut_curve_second(const taut_curve_rule *rule, const taut_quad_edge *edge,
                       const taut_curve_moves *moves, double first[TAUT_CURVE_WAYS],
                       double second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS]);

#endif /* TAUT_ASYMPTOTIC_CURVE_ENERGY_H */
