/* minimise.h -- minima of smooth functions of a few variables with exact gradients.
 *
 * Quasi-Newton steps (BFGS, backtracking) come near, Newton steps finish: with a Hessian of its own
 * these alone, else with one from central differences of the gradient. Where it is not positive its
 * eigenvalues are made so. The objective may refuse a point (outside its domain): the step is halved then, so that
 * iterates never leave the region the start lies in.
 * Sources: [NocedalWright2006] algorithms 3.1 and 6.1, section 3.4.
 */
#ifndef TAUT_NUMERIC_MINIMISE_H
#define TAUT_NUMERIC_MINIMISE_H

enum { TAUT_MINIMISE_MAX = 96 }; /* variables */

/* Value and gradient at x; 0 if x lies outside the domain. */
typedef int (*taut_objective)(void *context, const double *x, double *value, double *gradient);

/* The Hessian, symmetric, double[count][count], where the objective was last called: at x. */
typedef void (*taut_hessian)(void *context, const double *x, double *hessian);

typedef struct taut_minimum {
    double value;
    double gradient;  /* largest partial derivative, absolute value */
    double curvature; /* least eigenvalue of the Hessian */
    int evaluations;
    int converged; /* gradient <= 1e-8 times the value's size, curvature positive */
} taut_minimum;

/* Numbers of scratch that taut_minimise needs. */
#define TAUT_MINIMISE_WORK(count) (3 * (count) * (count) + 6 * (count))

/* x: the start, in the domain, on entry; the last and best point on return.
 * work: double[TAUT_MINIMISE_WORK(count)].
 * hessian: NULL where there is none.
 * rough: nonzero stops at a gradient of 1e-4 of the value; curvature and converged mean nothing
 * then. Returns 0 if the start is outside the domain. */
int taut_minimise(int count, taut_objective objective, taut_hessian hessian, void *context,
                  double *x, double *work, int rough, taut_minimum *minimum);

#endif /* TAUT_NUMERIC_MINIMISE_H */
