/* combs.h -- curvature combs: along a curve, teeth against the side it bends to, as long as it
 * bends.
 *
 *     tooth from x to x - s k,    k = (x'' - (x''.T) T) / |x'|^2,  T = x' / |x'|
 *
 * s makes the longest tooth of a figure an eighth of its size, and the figure says what that is.
 */
#ifndef TAUT_DRAW_COMBS_H
#define TAUT_DRAW_COMBS_H

#include "core/arena.h"
#include "draw/camera.h"
#include "draw/scene.h"
#include "taut/surface.h"

enum { TAUT_COMB_TEETH = 97 };

/* The combs of the four edges u0, u1, v0, v1 of a surface. NaN where there is no curvature. */
typedef struct taut_combs {
    double foot[4][TAUT_COMB_TEETH][3];
    double bend[4][TAUT_COMB_TEETH][3]; /* k */
    double tip[4][TAUT_COMB_TEETH][3];  /* after taut_combs_scale */
} taut_combs;

/* Returns the largest |k| in *most, which is not lowered. */
taut_status taut_combs_fill(const taut_surface *surface, taut_combs *combs, double *most);
void taut_combs_scale(taut_combs *combs, double scale);
taut_status taut_combs_add(const taut_combs *combs, const taut_camera *camera, taut_scene *scene);

#endif /* TAUT_DRAW_COMBS_H */
