/* system.h -- solving for the unknown points of a net, at one aspect after another.
 *
 *     [A x]_ij = 0 at every unknown point,   A = fu Ku (x) Mv + fv Mu (x) Kv
 *
 * ([WuWang2011] 2.4, 3)
 *
 * When the unknowns fill a box and A has tensor structure, fast diagonalisation of the box and a
 * step of refinement solve it; otherwise conjugate gradients, preconditioned by the same
 * diagonalised operator on the hull of the unknowns (section 7.6). Both stop on the residual
 *
 *     omega = max |A x|_ij / (sum |A(ij,st)| max |x|)
 *
 * computed anew from the points, when it is down to rounding.
 */
#ifndef TAUT_CONSTRUCT_DIRICHLET_SYSTEM_H
#define TAUT_CONSTRUCT_DIRICHLET_SYSTEM_H

#include "construct/common/mask.h"
#include "construct/dirichlet/form.h"
#include "taut/monitor.h"

typedef struct taut_dirichlet_system taut_dirichlet_system;

/* The form, the mask (at least one point known, one unknown) and the monitor are borrowed. threads: of every solve, 0: 1;
 * the same bits for any number.
 * TAUT_NO_MEMORY; TAUT_NOT_CONVERGED when the matrices are not safely positive definite. */
taut_status taut_dirichlet_system_new(taut_dirichlet_form *form, const taut_mask *mask,
                                      const taut_monitor *monitor, int threads,
                                      taut_dirichlet_system **system, taut_error *error);
void taut_dirichlet_system_free(taut_dirichlet_system *system); /* NULL is fine */

/* Solves in place: net double[nu][nv][3], its known points in [-1, 1]^3, the unknown ones a first
 * guess (0 is fine). TAUT_NOT_CONVERGED with the residual in error->found; TAUT_INTERRUPTED. */
taut_status taut_dirichlet_system_solve(taut_dirichlet_system *system, double aspect, double *net,
                                        taut_error *error);

/* The same with A x = right at the unknown points, by the rule that the last solution without one settled by, if there was one: right double[nu][nv][3], 0 at known points and
 * about 1 at the largest elsewhere. */
taut_status taut_dirichlet_system_solve_right(taut_dirichlet_system *system, double aspect,
                                              const double *right, double *net, taut_error *error);

/* The aspect of least energy over the search of section 7.3, and its solution in net.
 * TAUT_NO_SOLUTION when the energy falls for ever towards one end: the surface is a curve. */
taut_status taut_dirichlet_system_aspect(taut_dirichlet_system *system, double *net, double *aspect,
                                         taut_error *error);

/* The aspect with fu = fv, Lu / Lv: what 1 is to two ranges of equal length. */
double taut_dirichlet_system_natural_aspect(const taut_dirichlet_system *system);

/* As taut_dirichlet_form_energies. */
void taut_dirichlet_system_energies(const taut_dirichlet_system *system, const double *net,
                                    double halves[2]);

/* "fast-diagonalisation" or "conjugate-gradients", and how many products with A the iterations of
 * the latter took in all (0 for the former). */
const char *taut_dirichlet_system_method(const taut_dirichlet_system *system);
int taut_dirichlet_system_iterations(const taut_dirichlet_system *system);

#endif /* TAUT_CONSTRUCT_DIRICHLET_SYSTEM_H */
