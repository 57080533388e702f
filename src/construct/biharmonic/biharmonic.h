/* biharmonic.h -- the two ways of the construction `biharmonic`. */
#ifndef TAUT_CONSTRUCT_BIHARMONIC_BIHARMONIC_H
#define TAUT_CONSTRUCT_BIHARMONIC_BIHARMONIC_H

#include "core/arena.h"
#include "core/pulse.h"
#include "taut/biharmonic.h"

/* Adds the surface with four given rows. pulse, here and below: told of the work; TAUT_INTERRUPTED as it says. */
taut_status taut_biharmonic_add_rows(const taut_biharmonic_rows *rows, taut_arena *arena,
                                     taut_pulse *pulse, taut_model *model, double *amplification,
                                     taut_error *error);
/* Adds the given surface and its neighbour, and to the details what was chosen. */
taut_status taut_biharmonic_add_neighbour(const taut_biharmonic_neighbour *neighbour,
                                          taut_arena *arena, taut_pulse *pulse, taut_model *model,
                                          taut_record *details, double *amplification,
                                          taut_error *error);

#endif /* TAUT_CONSTRUCT_BIHARMONIC_BIHARMONIC_H */
