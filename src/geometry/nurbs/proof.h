/* proof.h -- how far a quintic Hermite spline is from a curve or surface on c- and h- bases,
 * proved; and spans for which it is near enough. */
#ifndef TAUT_GEOMETRY_NURBS_PROOF_H
#define TAUT_GEOMETRY_NURBS_PROOF_H

#include "geometry/lattice.h"

/* What a span of the spline does to the four points of a piece: the distance is at most
 * |sum rows[0][i] P_i| + |sum rows[1][i] P_i|. */
typedef struct taut_nurbs_span {
    double rows[2][4];
} taut_nurbs_span;

/* One direction of what is converted. */
typedef struct taut_nurbs_side {
    const taut_basis *basis; /* NULL for the missing direction of a curve */
    taut_change_list pieces; /* one per span of the basis */
    int exact;               /* polynomial: nothing is lost, and nothing is cut */
    int *first;   /* [pieces + 1]: spans of the spline first[p] .. first[p + 1] - 1 cut piece p */
    double *ends; /* [first[pieces] + 1] */
    taut_nurbs_span *spans; /* [first[pieces]] */
} taut_nurbs_side;

/* On failure there is still something to free. */
taut_status taut_nurbs_side_begin(const taut_basis *basis, taut_nurbs_side *s, taut_error *error);
void taut_nurbs_side_free(taut_nurbs_side *s);

/* The span [lo, hi] of piece p. */
taut_nurbs_span taut_nurbs_span_of(const taut_nurbs_side *s, int p, double lo, double hi);

/* Its distance on `lines` lines of four points: points[l * line + i * step + c]. */
double taut_nurbs_along(const taut_nurbs_span *span, int lines, const double *points, size_t line,
                        size_t step);

/* Cuts a side that is not exact into as few spans as its distance alone, `share` at most, allows;
 * `direction` is the one it runs along. `whole` is without weights.
 * TAUT_NO_SOLUTION: more than TAUT_COUNT_MAX functions. */
taut_status taut_nurbs_cut(const taut_lattice *whole, int direction, taut_nurbs_side *s,
                           const taut_nurbs_side *other, double share, taut_error *error);

/* The proved distance for the spans the sides have now. */
taut_status taut_nurbs_prove(const taut_lattice *whole, const taut_nurbs_side *u,
                             const taut_nurbs_side *v, double *distance, taut_error *error);

#endif /* TAUT_GEOMETRY_NURBS_PROOF_H */
