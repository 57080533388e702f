/* least.h -- a number that no sail on the same corners can be below.
 *
 * Of corners in a plane with edges that are straight or cables, over the chord c of edge k, x along
 * the chord from its middle, y into the sail, R = T / s:
 *
 *     A_k = -T ( sqrt(1 - x^2 / R^2), -x / R ),    |A_k| = T,   curl A_k = s,   defined for |x| <= R
 *
 * Where the convex hull of the corners lies within |x| <= R of every cable, each oriented surface
 * and its cables have (Stokes; docs/film.md)
 *
 *     s A + sum T L  >=  s (polygon's area) + sum s R^2 (a + sin a cos a),    a = asin(c / (2 R))
 *
 * Cables that are kept in planes have fewer rivals, and the bound stays one. An elastic cable stores C(L) >= C(L*) + T (L - L*), L* its length under the force T, whatever T is;
 * of a given length T L is known. Nothing is used of the construction's, and of the film only the
 * forces of cables that have none of their own, for which any will do.
 */
#ifndef TAUT_CERTIFY_FILM_LEAST_H
#define TAUT_CERTIFY_FILM_LEAST_H

#include "certify/film/sheet.h"

/* *bound: no film of the problem has less energy, in the user's unit. Returns NULL, or why there is
 * none. given: lengths as taut_film_sheet_given has them. */
const char *taut_film_least(const taut_film_sheet *sheet, const double given[4], double *bound);

#endif /* TAUT_CERTIFY_FILM_LEAST_H */
