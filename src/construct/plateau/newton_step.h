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
#include "taut/monitor.h"

typedef struct taut_film_solver taut_film_solver;

/* directions double[nu][nv][3] for "normal", NULL for "full". aspect: fu / fv of the
 * preconditioner, > 0. All is borrowed. TAUT_NO_MEMORY; TAUT_NOT_CONVERGED when the Gram matrices
 * are not safely positive definite. */
taut_status taut_film_solver_new(taut_film *film, const taut_dirichlet_form *form,
                                 const taut_mask *mask, const double *directions, double aspect,
                                 const taut_monitor *monitor, taut_film_solver **solver);
void taut_film_solver_free(taut_film_solver *solver); /* NULL is fine */

/* Tells the monitor that work goes on; TAUT_INTERRUPTED when it asks to stop. */
taut_status taut_film_solver_report(const taut_film_solver *solver);

/* 1 for "normal", 3 for "full". */
int taut_film_solver_parts(const taut_film_solver *solver);
/* The least theta that is worth using: below it rounding or the number of products takes over. */
double taut_film_solver_floor(const taut_film_solver *solver);
/* "factors" or "conjugate-gradients"; products with B so far. */
const char *taut_film_solver_name(const taut_film_solver *solver);
int taut_film_solver_products(const taut_film_solver *solver);

/* About so many flops: one step. */
double taut_film_solver_step_cost(const taut_film_solver *solver);

/* z from a net of gradients, and the move of the points that z is. */
void taut_film_solver_reduce(const taut_film_solver *solver, const double *net, double *z);
void taut_film_solver_expand(const taut_film_solver *solver, const double *z, double *net);

/* The film's state has changed. */
void taut_film_solver_renew(taut_film_solver *solver);

/* z = B^-1 b, to |b - B z| <= forcing |b| in the norm of the preconditioner (factors: exactly).
 * *model = b.z - 1/2 z.B z, what the quadratic model says is gained. TAUT_OK, TAUT_INTERRUPTED,
 * or TAUT_NO_SOLUTION when B has shown itself not positive definite. */
taut_status taut_film_solver_solve(taut_film_solver *solver, double theta, double forcing,
                                   const double *b, double *z, double *model);

/* Are steps made by factors? Then z = B^-1 z with those of the last solve that succeeded, whatever
 * the film's state is now. */
int taut_film_solver_has_factors(const taut_film_solver *solver);
void taut_film_solver_again(taut_film_solver *solver, double *z);

/* product = B z. */
void taut_film_solver_product(taut_film_solver *solver, double theta, const double *z,
                              double *product);
/* a . b over the unknowns. */
double taut_film_solver_dot(const taut_film_solver *solver, const double *a, const double *b);

#endif /* TAUT_CONSTRUCT_PLATEAU_NEWTON_STEP_H */
