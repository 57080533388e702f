/* climb.h -- from a start to the psi of least gap, by Newton's steps (construct/plateau/dual.h), of one film or of many patches.
 *
 *     psi  = the one whose field is next to the film's normals, made smaller if it is too steep
 *     while it is cheap and worth it: Newton's step, halved until it is not too steep and the gap falls
 *
 * The gap is of second order in the error of grad psi. So the start is good to about the root of the gap, and films whose gap is
 * small need no step; and decimals that move grad psi by a thousandth of the root of the gap are told in vain.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_CLIMB_H
#define TAUT_CONSTRUCT_PLATEAU_CLIMB_H

#include "construct/plateau/dual.h"

typedef struct taut_dual_climb {
    size_t count; /* coefficients */
    double area;  /* of the film */
    double flops; /* about, of a step */
    taut_dual_value (*evaluate)(void *context, const double *psi);
    /* Newton's step from psi; of NULL: the start. TAUT_NO_SOLUTION, TAUT_INTERRUPTED, TAUT_NO_MEMORY. */
    taut_status (*solve)(void *context, const double *psi, double *step);
    void *context;
    taut_pulse *pulse;
} taut_dual_climb;

/* psi, step, next: double[count]. TAUT_NO_SOLUTION: none is found. */
taut_status taut_dual_climb_up(const taut_dual_climb *climb, double *psi, double *step,
                               double *next, taut_dual_value *value);

/* 10^k for the k decimals that count, in units of 2^exponent; 0: all. gap: over the area; steep: how much steeper than 1 over the
 * size a function is, the largest number of spans times functions alive on one. */
double taut_dual_decimals(double gap, double steep, int exponent);
/* x to these. */
double taut_dual_round(double x, double power);

#endif /* TAUT_CONSTRUCT_PLATEAU_CLIMB_H */
