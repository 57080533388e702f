/* flat.h -- flat sails, told before anything is solved.
 *
 * Where the corners lie in a plane and every edge is straight or a cable of given force, the film
 * is the flat region between arcs of circles: the cable over a chord c is an arc of radius T / s
 * that bows into the sail. It exists exactly when
 *
 *     every chord     c <= 2 T / s,
 *     every corner    its angle is above the sum of asin(s c / (2 T)) of its two edges (0: straight),
 *     arcs and straight edges meet only in the corners that they share.
 *
 * docs/film.md has the proof.
 */
#ifndef TAUT_CONSTRUCT_FILM_FLAT_H
#define TAUT_CONSTRUCT_FILM_FLAT_H

#include "construct/film/space.h"

/* TAUT_OK where the film is not flat, has points that move elsewhere than in cables, or exists. TAUT_NO_SOLUTION: cable-too-weak, error->limit the
 * least force of the cable named in error->where, all forces raised alike; crossed. */
taut_status taut_film_flat_check(const taut_film_space *space, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_FLAT_H */
