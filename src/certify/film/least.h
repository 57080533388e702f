/* least.h -- a number that no sail held alike can be below.
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
 * and nothing is used of the construction's. Of other sails the fields are those that the model carries
 * (certify/film/calibration.h). Cables that are kept in planes have fewer rivals, and the bound stays one.
 * An elastic cable stores C(L) >= C(L*) + T (L - L*), L* its length under the force T, whatever T is; of a
 * given length T L is known. Of the film only the forces of cables that have none of their own are used,
 * for which any will do.
 */
#ifndef TAUT_CERTIFY_FILM_LEAST_H
#define TAUT_CERTIFY_FILM_LEAST_H

#include "certify/film/sheet.h"
#include "taut/record.h"

typedef struct taut_film_least {
    const char *why; /* there is no bound; or NULL */
    double bound;    /* no film of the problem has less energy; the user's unit */
    double limit;    /* what share of the energy the bound may be below it */
} taut_film_least;

/* witness: details.least of the model, or NULL. given: lengths as taut_film_sheet_given has them. TAUT_NO_MEMORY. */
taut_status taut_film_least_of(const taut_film_sheet *sheet, const taut_record *witness,
                               const double given[4], taut_film_least *least);

#endif /* TAUT_CERTIFY_FILM_LEAST_H */
