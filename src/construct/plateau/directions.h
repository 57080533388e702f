/* directions.h -- the unit normals of a surface at its Greville points. */
#ifndef TAUT_CONSTRUCT_PLATEAU_DIRECTIONS_H
#define TAUT_CONSTRUCT_PLATEAU_DIRECTIONS_H

#include "taut/surface.h"

/* The parameter that belongs to each control point, t double[count]: the coefficients of the
 * function t, sum t[i] N_i(t) = t, where they lie in the closed range, else the end they lie beyond
 * (the outermost points of c- and h-bsplines); evenly spread where t is not among the functions
 * (ce-bezier). */
void taut_plateau_greville(const taut_basis *basis, double *t);

/* directions double[nu][nv][3]. Where the normal vanishes (a collapsed edge), the mean of the
 * nearest ones; the third axis when there is none at all. TAUT_NO_MEMORY. */
taut_status taut_plateau_directions(const taut_surface *surface, double *directions);

#endif /* TAUT_CONSTRUCT_PLATEAU_DIRECTIONS_H */
