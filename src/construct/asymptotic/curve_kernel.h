/* curve_kernel.h -- the loops of curve_energy.h over Gauss nodes, for each instruction set: the same
 * bits from all. */
#ifndef TAUT_ASYMPTOTIC_CURVE_KERNEL_H
#define TAUT_ASYMPTOTIC_CURVE_KERNEL_H

#include "construct/asymptotic/curve_energy.h"

typedef struct taut_curve_ops {
    double (*energy)(const taut_curve_rule *rule, const taut_quad_edge *edge,
                     double by_point[TAUT_QUAD_POINTS][3], double by_log[TAUT_QUAD_POINTS]);
    void (*second)(const taut_curve_rule *rule, const taut_quad_edge *edge,
                   const taut_curve_moves *moves, double first[TAUT_CURVE_WAYS],
                   double second[TAUT_CURVE_WAYS][TAUT_CURVE_WAYS]);
} taut_curve_ops;

extern const taut_curve_ops taut_curve_baseline;
#if defined(__x86_64__)
extern const taut_curve_ops taut_curve_avx2;
extern const taut_curve_ops taut_curve_avx512;
#endif

#endif /* TAUT_ASYMPTOTIC_CURVE_KERNEL_H */
