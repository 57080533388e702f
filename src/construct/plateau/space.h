/* space.h -- a problem of least area in one spline space. */
#ifndef TAUT_CONSTRUCT_PLATEAU_SPACE_H
#define TAUT_CONSTRUCT_PLATEAU_SPACE_H

#include "core/arena.h"
#include "taut/plateau.h"
#include "taut/record.h"

typedef struct taut_plateau_space {
    taut_plateau_problem problem; /* net and start as taut_plateau_solve wants them */
    taut_arena *arena;
    int has_curves;
    double deviation; /* of the edges from the curves, in their unit */
} taut_plateau_space;

/* The space of the problem given, or with `finer`, a surface on a finer one, that of the surface:
 * its inner points are the start, and so is its boundary unless curves are fitted anew.
 * TAUT_BAD_INPUT: curves that don't meet; a finer space where others than the boundary are known.
 * TAUT_NOT_CONVERGED: a curve that can't be fitted. */
taut_status taut_plateau_space_new(const taut_plateau_problem *given, const taut_surface *finer,
                                   taut_plateau_space **space, taut_error *error);
void taut_plateau_space_free(taut_plateau_space *space); /* NULL is fine */

/* Is exactly the boundary of the net known? */
int taut_plateau_knows_boundary(const taut_dirichlet_problem *net);

/* Adds the member `deviation` where there are curves. */
void taut_plateau_space_describe(const taut_plateau_space *space, taut_record *details);

#endif /* TAUT_CONSTRUCT_PLATEAU_SPACE_H */
