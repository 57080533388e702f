/* newton_step.h -- steps towards less area: B z = -g in the unknowns of a method.
 *
 * The unknowns are the three coordinates of each unknown point ("full"), or one number along its
 * given direction ("normal"); vectors of them lie on the whole net, [nu][nv][parts], zero at known
 * points. B is (1 - theta) H + theta L_g of construct/plateau/area.h, solved by banded factors
 * (hessian_band.h) where they pay, else by conjugate gradients preconditioned with the diagonalised
 * Dirichlet operator of the same mean stretch: the number of products does not grow with the net
 * ([WuWang2011] 7.1, 7.2).
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_NEWTON_STEP_H
#define TAUT_CONSTRUCT_PLATEAU_NEWTON_STEP_H

#include "construct/common/mask.h"
#include "construct/dirichlet/form.h"
#include "construct/plateau/area.h"
#include "construct/plateau/held.h"
#include "taut/monitor.h"

typedef struct taut_newton_step taut_newton_step;

/* directions double[nu][nv][3] for "normal", NULL for "full". aspect: fu / fv of the
 * preconditioner, > 0. All is borrowed. TAUT_NO_MEMORY; TAUT_NOT_CONVERGED when the Gram matrices
 * are not safely positive definite. */
taut_status taut_newton_step_new(taut_area_functional *functional, const taut_dirichlet_form *form,
                                 const taut_mask *mask, const double *directions, double aspect,
                                 const taut_monitor *monitor, taut_newton_step **newton);
void taut_newton_step_free(taut_newton_step *newton); /* NULL is fine */

/* From now on steps leave the surface where the conditions hold it. Both are borrowed, `held` is worked in.
 * TAUT_NO_MEMORY; TAUT_NOT_CONVERGED as above; TAUT_INTERRUPTED. */
taut_status taut_newton_step_hold(taut_newton_step *newton, const taut_conditions *conditions,
                                  taut_held *held);

/* Has the monitor asked for an end? */
int taut_newton_step_is_stopped(const taut_newton_step *newton);
/* Tells the monitor that work goes on; TAUT_INTERRUPTED when it asks to stop. */
taut_status taut_newton_step_report(taut_newton_step *newton);

/* 1 for "normal", 3 for "full". */
int taut_newton_step_parts(const taut_newton_step *newton);
/* The least theta that is worth using: below it rounding or the number of products takes over. */
double taut_newton_step_floor(const taut_newton_step *newton);
/* "factors" or "conjugate-gradients"; products with B so far. */
const char *taut_newton_step_method(const taut_newton_step *newton);
int taut_newton_step_products(const taut_newton_step *newton);

/* About so many flops: one step. */
double taut_newton_step_cost(const taut_newton_step *newton);

/* z from a net of gradients, and the move of the points that z is. */
void taut_newton_step_reduce(const taut_newton_step *newton, const double *net, double *z);
void taut_newton_step_expand(const taut_newton_step *newton, const double *z, double *net);

/* The state of the functional has changed. */
void taut_newton_step_renew(taut_newton_step *newton);

/* z = B^-1 b, to |b - B z| <= forcing |b| in the norm of the preconditioner (factors: exactly).
 * *model = b.z - 1/2 z.B z, what the quadratic model says is gained. TAUT_OK, TAUT_INTERRUPTED,
 * or TAUT_NO_SOLUTION when B has shown itself not positive definite. */
taut_status taut_newton_step_solve(taut_newton_step *newton, double theta, double forcing,
                                   const double *b, double *z, double *model);

/* Are steps made by factors? Then z = B^-1 z with those of the last solve that succeeded, whatever
 * the state of the functional is now. */
int taut_newton_step_has_factors(const taut_newton_step *newton);
void taut_newton_step_again(taut_newton_step *newton, double *z);

/* product = B z. */
void taut_newton_step_product(taut_newton_step *newton, double theta, const double *z,
                              double *product);
/* a . b over the unknowns. */
double taut_newton_step_dot(const taut_newton_step *newton, const double *a, const double *b);

#endif /* TAUT_CONSTRUCT_PLATEAU_NEWTON_STEP_H */
