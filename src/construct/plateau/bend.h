/* bend.h -- where a film bends though it should not. */
#ifndef TAUT_CONSTRUCT_PLATEAU_BEND_H
#define TAUT_CONSTRUCT_PLATEAU_BEND_H

#include "taut/surface.h"

/* The same surface with knots in the middle of the spans that hold most of int |H|^2 W
 * ([WuWang2011] 7.4), at least one in each direction. */
taut_status taut_plateau_insert(const taut_surface *surface, taut_surface **finer,
                                taut_error *error);

#endif /* TAUT_CONSTRUCT_PLATEAU_BEND_H */
