#include "construct/asymptotic/curve_energy.h"

#include "construct/asymptotic/curve_kernel.h"
#include "numeric/bernstein.h"
#include "numeric/kernel/name.h"
#include "numeric/quadrature.h"

#include <assert.h>

void taut_curve_rule_fill(int degree, int nodes, taut_curve_rule *rule)
{
    double at[TAUT_CURVE_FINE];
    assert(nodes <= TAUT_CURVE_FINE && nodes % TAUT_CURVE_LANES == 0);
    rule->degree = degree;
    rule->nodes = nodes;
    taut_gauss_rule(nodes, at, rule->weight);
    for (int k = 0; k < nodes; k++) {
        double values[3 * TAUT_QUAD_POINTS];
        rule->weight[k] *= 0.5;
        taut_bernstein_eval(degree, 2, 0.5 + 0.5 * at[k], values);
        for (int d = 0; d < 3; d++) {
            for (int j = 0; j <= degree; j++) {
                rule->basis[k / TAUT_CURVE_LANES][d][j][k % TAUT_CURVE_LANES] =
                    values[d * (degree + 1) + j];
            }
        }
    }
}

double taut_curve_energy(const taut_curve_rule *rule, const taut_quad_edge *edge,
                         double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS])
{
    return TAUT_KERNEL_OF(taut_curve)->energy(rule, edge, by_point, by_log);
}

void taut_curve_second(const taut_curve_rule *rule, const taut_quad_edge *edge,
                       const taut_curve_moves *moves, double first[TAUT_CURVE_WAYS],
                       double second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS])
{
    TAUT_KERNEL_OF(taut_curve)->second(rule, edge, moves, first, second);
}
