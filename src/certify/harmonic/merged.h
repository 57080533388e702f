/* merged.h -- is the surface over both rectangles, `h`, the one and the other? */
#ifndef TAUT_CERTIFY_HARMONIC_MERGED_H
#define TAUT_CERTIFY_HARMONIC_MERGED_H

#include "taut/join.h"
#include "taut/surface.h"

typedef struct taut_merged {
    double residual;   /* largest distance of a control point over the size of its piece */
    double limit;      /* what rounding explains of it */
    const char *piece; /* of the residual */
} taut_merged;

/* h cut at the edge that p and q share, by de Casteljau's algorithm in twice the precision, against
 * their nets: an identity of polynomials. Residual 1 where bases and ranges are not those of two
 * pieces of one surface. Limit 4 (n+1) 2^-53 M / size, M the largest number that carrying p on to
 * the end of h meets. */
taut_merged taut_merged_of(const taut_surface *p, const taut_surface *q, const taut_surface *h,
                           taut_edge edge);

/* M: about the rounding of q's points over 2^-53, p's carried on to its end. 0 where the ranges do
 * not meet in the edge. */
double taut_merged_carried(const taut_surface *p, const taut_surface *q, taut_edge edge);

#endif /* TAUT_CERTIFY_HARMONIC_MERGED_H */
