/* system_parts.h -- the inside of system.h, shared by its source files. */
#ifndef TAUT_CONSTRUCT_DIRICHLET_SYSTEM_PARTS_H
#define TAUT_CONSTRUCT_DIRICHLET_SYSTEM_PARTS_H

#include "construct/dirichlet/system.h"
#include "numeric/tensor/solver.h"

struct taut_dirichlet_system {
    taut_dirichlet_form *form;
    const taut_mask *mask;
    const taut_monitor *monitor;
    taut_gram u, v;                             /* of the hull */
    taut_tensor_solver *solver;                 /* of the hull */
    double fu, fv;                              /* the larger one is 1 */
    double *residual, *step, *product, *smooth; /* nets; the last three for iterations only */
    double *scales; /* double[nu][nv], of the preconditioner, or NULL where all are 1 */
    double *hull;
    int is_damped; /* the solver's matrices are near the hull's, not equal to them */
    int iterations;
};

/* Numbers in a net, double[nu][nv][3]. */
static inline size_t taut_dirichlet_net_size(const taut_dirichlet_system *system)
{
    return 3 * (size_t)system->form->nu * (size_t)system->form->nv;
}

/* omega of a residual: max |r_ij| / sum |A(ij,st)| over the unknowns. */
double taut_dirichlet_omega(const taut_dirichlet_system *system, const double *r);

/* hull = (hull part of A)^-1 r, of the tensor form. */
taut_status taut_dirichlet_solve_hull(taut_dirichlet_system *system, const double *r);

/* TAUT_INTERRUPTED when the monitor says so. */
taut_status taut_dirichlet_stopped(const taut_dirichlet_system *system, taut_error *error);

/* Conjugate gradients from residual = -A net until omega of the updated residual falls to `enough`
 * or `most` steps are done. Statuses of the solver; TAUT_INTERRUPTED. */
taut_status taut_dirichlet_iterate(taut_dirichlet_system *system, double enough, int most,
                                   double *net, taut_error *error);

#endif /* TAUT_CONSTRUCT_DIRICHLET_SYSTEM_PARTS_H */
