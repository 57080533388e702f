/* solve.h -- the surface of least area in one spline space. */
#ifndef TAUT_CONSTRUCT_PLATEAU_SOLVE_H
#define TAUT_CONSTRUCT_PLATEAU_SOLVE_H

#include "taut/plateau.h"
#include "taut/record.h"

typedef struct taut_plateau_solution {
    taut_surface *surface;
    taut_record *details;
    double area; /* of the surface, in squares of its unit */
} taut_plateau_solution;

/* Of problem: net, start, tolerance, max_iterations, method. options is not NULL. Statuses as
 * taut_plateau_make. With TAUT_NOT_CONVERGED and TAUT_INTERRUPTED the solution may be there too, as far
 * as it came: it is to be cleared. */
taut_status taut_plateau_solve(const taut_plateau_problem *problem,
                               const taut_make_options *options, taut_plateau_solution *solution,
                               taut_error *error);
void taut_plateau_solution_clear(taut_plateau_solution *solution);

#endif /* TAUT_CONSTRUCT_PLATEAU_SOLVE_H */
