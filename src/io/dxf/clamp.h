/* clamp.h -- splines of DXF files on knots that end as ours do. */
#ifndef TAUT_IO_DXF_CLAMP_H
#define TAUT_IO_DXF_CLAMP_H

#include "io/dxf/shapes.h"

/* The same curve, over the parameters at which it is one, on knots that begin and end with degree + 1 equal ones; points that
 * it has on both keep their bits. 0 where the knots decrease, leave no such parameters, or break the curve. TAUT_NO_MEMORY is in
 * the arena's status. */
int taut_dxf_clamp(taut_dxf_curve *curve, taut_arena *arena);

#endif /* TAUT_IO_DXF_CLAMP_H */
