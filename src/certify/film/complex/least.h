/* least.h -- a number that no film of many patches with this boundary can be below.
 *
 * The boundary is one closed curve, held, and the model carries a direction e and a function psi on the spans of each patch
 * (details.least: direction, patches). What certify/plateau/least.h shows of one film is shown of all together:
 *
 *     psi is one function      coefficients and knots of the two sides of a seam are the same, bit for bit
 *     J, |grad psi| <= 1       patch by patch, J of one sign seen from one side of the film; the gaps add up
 *     convex                   the sides of the boundary in turn turn back by no more than rounding in all, and turn by 2 pi
 *
 * Knots that are evenly spread to rounding count as evenly spread, so that those of a seam that is run backwards are the same.
 * The film then is mapped to the plane without folds, and onto a domain whose border it meets once: so every place of it is
 * met once (the degree of a map), vertices where patches meet too, and psi is a function on the domain.
 */
#ifndef TAUT_CERTIFY_FILM_COMPLEX_LEAST_H
#define TAUT_CERTIFY_FILM_COMPLEX_LEAST_H

#include "certify/plateau/least.h"
#include "core/pulse.h"
#include "problem/film_complex.h"
#include "taut/record.h"

/* surfaces[patch_count]; witness: details.least, or what is no object. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_complex_least_of(const taut_film_complex *complex,
                                  const taut_surface *const *surfaces, const taut_record *witness,
                                  taut_pulse *pulse, taut_least_finding *found);

#endif /* TAUT_CERTIFY_FILM_COMPLEX_LEAST_H */
