/* given.h -- the witness of `least`, as it was written by whoever: a direction, and psi on the spans of a film. */
#ifndef TAUT_CERTIFY_PLATEAU_GIVEN_H
#define TAUT_CERTIFY_PLATEAU_GIVEN_H

#include "certify/plateau/flux.h"
#include "core/arena.h"
#include "taut/record.h"

#define TAUT_GIVEN_NO_DIRECTION "witness: invalid direction"

/* task->frame, right-handed, and its error; 0 where rounding leaves none. */
int taut_given_frame(const taut_record *direction, taut_arena *arena, taut_flux_task *task);

/* task->u, v and coefficients, of the surface and the exponent there; in the arena, whose status tells of memory.
 * NULL, or why they are none. */
const char *taut_given_psi(const taut_record *witness, taut_arena *arena, taut_flux_task *task);

#endif /* TAUT_CERTIFY_PLATEAU_GIVEN_H */
