/* plan.h -- all of a Dirichlet problem that does not depend on its points: which of them
 * are unknown, the energy as a form, and the diagonalised system.
 *
 * A sequence of boundaries on the same knots shares one plan. It serves any aspect, and what comes
 * out is bit for bit what a plan of its own would give: nothing in it remembers a solve.
 */
#ifndef TAUT_CONSTRUCT_DIRICHLET_PLAN_H
#define TAUT_CONSTRUCT_DIRICHLET_PLAN_H

#include "construct/dirichlet/system.h"
#include "taut/dirichlet.h"

typedef struct taut_dirichlet_plan {
    taut_arena *arena;
    taut_basis *u, *v;
    unsigned char *known; /* [nu][nv], 0 or 1 */
    double *weights;      /* NULL: none */
    taut_mask mask;
    taut_dirichlet_form form;
    taut_dirichlet_system *system; /* NULL: every point is known */
    int is_lasting;                /* serves other problems too: a quadrature that is refined as a
                                    * solve goes on would remember it */
} taut_dirichlet_plan;

/* The problem has been checked; nothing of it is borrowed. Errors as taut_dirichlet_system_new. */
taut_status taut_dirichlet_plan_new(const taut_dirichlet_problem *problem,
                                    const taut_monitor *monitor, taut_dirichlet_plan **plan,
                                    taut_error *error);
void taut_dirichlet_plan_free(void *plan); /* NULL is fine */

/* Are the problem's bases, known places and weights this plan's, bit for bit? */
int taut_dirichlet_plan_serves(const taut_dirichlet_plan *plan,
                               const taut_dirichlet_problem *problem);

#endif /* TAUT_CONSTRUCT_DIRICHLET_PLAN_H */
