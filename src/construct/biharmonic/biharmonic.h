/* biharmonic.h -- the two halves of the construction `biharmonic`. */
#ifndef TAUT_CONSTRUCT_BIHARMONIC_BIHARMONIC_H
#define TAUT_CONSTRUCT_BIHARMONIC_BIHARMONIC_H

#include "core/arena.h"
#include "taut/biharmonic.h"

/* Adds the surface with the problem's four rows. */
taut_status taut_biharmonic_rows(const taut_biharmonic_problem *problem, taut_arena *arena,
                                 taut_model *model, taut_error *error);
/* Adds the given surface and its neighbour. */
taut_status taut_biharmonic_neighbour(const taut_biharmonic_problem *problem, taut_arena *arena,
                                      taut_model *model, taut_error *error);

/* The amplification, and a warning where it is large. */
void taut_biharmonic_tell(double amplification, taut_record *details);

#endif /* TAUT_CONSTRUCT_BIHARMONIC_BIHARMONIC_H */
