/* lattice.h -- control points of a curve or surface as one array, ready for changes of basis.
 *
 * A curve is a surface with one column. Rational ones hold (wx, wy, wz, w).
 */
#ifndef TAUT_GEOMETRY_LATTICE_H
#define TAUT_GEOMETRY_LATTICE_H

#include "basis/change.h"
#include "taut/curve.h"
#include "taut/surface.h"

#include <stddef.h>

typedef struct taut_lattice {
    int count[2]; /* along u and v; count[1] is 1 for a curve */
    int dim;      /* 3, or 4 with weights */
    double *net;  /* [count[0]][count[1]][dim], owned */
} taut_lattice;

taut_status taut_lattice_of_curve(const taut_curve *curve, taut_lattice *lattice,
                                  taut_error *error);
taut_status taut_lattice_of_surface(const taut_surface *surface, taut_lattice *lattice,
                                    taut_error *error);
void taut_lattice_free(taut_lattice *lattice); /* leaves it empty */

/* out = the change along a direction; `out` is a new lattice. On failure, here and above, it is
 * empty: there is nothing to free. */
taut_status taut_lattice_change(const taut_lattice *in, int direction, const taut_change *change,
                                taut_lattice *out, taut_error *error);

/* Back to points and weights. The lattice is freed, whatever happens, and left empty. */
taut_status taut_lattice_into_curve(taut_lattice *lattice, const char *name, const taut_basis *t,
                                    taut_curve **curve, taut_error *error);
taut_status taut_lattice_into_surface(taut_lattice *lattice, const char *name, const taut_basis *u,
                                      const taut_basis *v, taut_surface **surface,
                                      taut_error *error);

/* A curve or surface after one change. */
taut_status taut_curve_changed(const taut_curve *curve, const taut_change *change, const char *name,
                               taut_curve **changed, taut_error *error);
taut_status taut_surface_changed(const taut_surface *surface, int direction,
                                 const taut_change *change, const char *name,
                                 taut_surface **changed, taut_error *error);

/* The basis along TAUT_ALONG_U or TAUT_ALONG_V. */
const taut_basis *taut_surface_along(const taut_surface *surface, int direction);

#endif /* TAUT_GEOMETRY_LATTICE_H */
