/* bspline_change.h -- parts of the operations on B-splines. */
#ifndef TAUT_BASIS_BSPLINE_CHANGE_H
#define TAUT_BASIS_BSPLINE_CHANGE_H

#include "basis/change.h"

/* The bspline basis of one span that is this bezier basis, with the same coefficients. */
taut_status taut_bspline_of_bezier(const taut_basis *bezier, taut_basis **bspline,
                                   taut_error *error);

/* As taut_change_ops.elevate. */
taut_status taut_bspline_elevate(const taut_basis *basis, taut_change **change, taut_error *error);

#endif /* TAUT_BASIS_BSPLINE_CHANGE_H */
