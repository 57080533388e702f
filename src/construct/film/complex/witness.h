/* witness.h -- the function that shows how near a film of many patches is to the least area of all.
 *
 * As construct/plateau/witness.h has it of one: here psi is one function over all patches, on the spans of each, whose
 * coefficients along a seam are the same on both sides.
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_WITNESS_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_WITNESS_H

#include "construct/film/complex/solve.h"
#include "taut/record.h"

/* Adds the member `least` to details, where there is a witness: films whose boundary is one closed curve (problem/film_rim.h) over a
 * convex domain, of at most TAUT_PLATEAU_LEAST_MAX points. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_complex_witness_add(const taut_film_layout *layout, const taut_film_rest *rest,
                                     const taut_monitor *monitor, taut_record *details);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_WITNESS_H */
