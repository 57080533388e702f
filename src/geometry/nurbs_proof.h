/* nurbs_proof.h -- how far a quintic Hermite spline is from a curve or surface on c- and h- bases,
 * proved. */
#ifndef TAUT_GEOMETRY_NURBS_PROOF_H
#define TAUT_GEOMETRY_NURBS_PROOF_H

#include "geometry/lattice.h"

/* One direction of what is converted. */
typedef struct taut_side {
    const taut_basis *basis; /* NULL for the missing direction of a curve */
    taut_change_list pieces; /* one per span */
    int exact;               /* polynomial: nothing is lost */
    int panels;              /* per span, 1 at first; 0 where exact */
    double *bends; /* [pieces][panels][2][4]: second and third derivatives in the middle */
    double at, slope, factor; /* taut_change_ops.growth within half a panel, and h^6 / 46080 */
} taut_side;

/* Largest distances: along u alone, along v alone, and all together on one patch. */
typedef struct taut_distances {
    double along[2];
    double total;
} taut_distances;

/* On failure there is still something to free. */
taut_status taut_side_begin(const taut_basis *basis, taut_side *s, taut_error *error);
void taut_side_free(taut_side *s);

/* The proved distances for the panels the sides have now; `whole` is without weights. */
taut_status taut_nurbs_prove(const taut_lattice *whole, taut_side *u, taut_side *v,
                             taut_distances *d, taut_error *error);

#endif /* TAUT_GEOMETRY_NURBS_PROOF_H */
