/* refine.h -- least areas in nested spaces, and what they tell of the least of all. */
#ifndef TAUT_CONSTRUCT_PLATEAU_REFINE_H
#define TAUT_CONSTRUCT_PLATEAU_REFINE_H

#include "construct/plateau/solve.h"
#include "construct/plateau/space.h"
#include "construct/plateau/witness.h"

/* The same surface with knots in the middle of the spans that hold most of int |H|^2 W
 * ([WuWang2011] 7.4), at least one in each direction: least area means H = 0. With a density,
 * double[spans of u][spans of v], of the spans that hold most of it. */
taut_status taut_plateau_insert_knots(const taut_surface *surface, const double *density,
                                      taut_surface **finer, taut_error *error);

/* Solves on problem->refine spaces, each with every span of the one before halved, and adds the
 * member `refinement` to the solution's details. */
taut_status taut_plateau_estimate(const taut_plateau_problem *problem,
                                  const taut_make_options *options, taut_plateau_solution *solution,
                                  taut_error *error);

/* Puts knots in where the surface bends, solves again, and so on until the estimated distance from
 * the least area is within problem->tolerance_area of it. *space and *solution become the last
 * ones. TAUT_NOT_CONVERGED: too many rounds or points. */
taut_status taut_plateau_adapt(const taut_plateau_problem *problem,
                               const taut_make_options *options, taut_plateau_space **space,
                               taut_plateau_solution *solution, taut_error *error);

/* Puts knots in where the gap of the witness is (construct/plateau/witness.h), solves again, and so
 * on until it is within problem->gap of the area. *space, *solution and *witness become the last
 * ones; the caller frees them. TAUT_NOT_CONVERGED: too many rounds or points, or no witness. */
taut_status taut_plateau_close_gap(const taut_plateau_problem *problem,
                                   const taut_make_options *options, taut_plateau_space **space,
                                   taut_plateau_solution *solution, taut_plateau_witness **witness,
                                   taut_error *error);

#endif /* TAUT_CONSTRUCT_PLATEAU_REFINE_H */
