/* directions.h -- the unit normals of a surface at its Greville points. */
#ifndef TAUT_CONSTRUCT_PLATEAU_DIRECTIONS_H
#define TAUT_CONSTRUCT_PLATEAU_DIRECTIONS_H

#include "taut/surface.h"

/* directions double[nu][nv][3]. Where the normal vanishes (a collapsed edge), the mean of the
 * nearest ones; the third axis when there is none at all. TAUT_NO_MEMORY. */
taut_status taut_plateau_directions(const taut_surface *surface, double *directions);

#endif /* TAUT_CONSTRUCT_PLATEAU_DIRECTIONS_H */
