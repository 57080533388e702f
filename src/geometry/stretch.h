/* stretch.h -- curves of the window as details.domain has them: quintic splines. */
#ifndef TAUT_GEOMETRY_STRETCH_H
#define TAUT_GEOMETRY_STRETCH_H

#include "core/arena.h"
#include "taut/curve.h"
#include "taut/record.h"

/* An item as a curve of points (u, v, 0), the arena's; NULL where it is none. TAUT_NO_MEMORY. */
taut_status taut_stretch_read(const taut_record *item, taut_arena *arena, taut_curve **stretch);

#endif /* TAUT_GEOMETRY_STRETCH_H */
