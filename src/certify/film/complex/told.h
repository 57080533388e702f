/* told.h -- what the details of a film say of its forces: are they what the certificate finds? */
#ifndef TAUT_CERTIFY_FILM_COMPLEX_TOLD_H
#define TAUT_CERTIFY_FILM_COMPLEX_TOLD_H

#include "problem/film_complex.h"
#include "taut/certify.h"

/* The claim `details`, a check, where it does not hold; nothing where it does, or where details say nothing of these:
 *
 *     tension        the problem's
 *     cables         edge, what it goes along, force, length, unstressed length; as many, in the same order
 *     supports       corners
 *     held_straight  edges
 *     cells          name, pressure
 *
 * Numbers to 1e-8, of forces over the largest. complex: NULL of a film of one patch. The certificate has the figures. */
taut_status taut_film_told(const taut_model *model, const taut_film_problem *problem,
                           const taut_film_complex *complex, taut_certificate *certificate);

#endif /* TAUT_CERTIFY_FILM_COMPLEX_TOLD_H */
