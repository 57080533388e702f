/* lines.h -- where a surface is cut into cells. */
#ifndef TAUT_MESH_LINES_H
#define TAUT_MESH_LINES_H

#include "core/arena.h"
#include "core/crew.h"
#include "taut/surface.h"

/* How strongly a surface bends, sampled over it. */
typedef struct taut_bending {
    double *u;           /* [u spans]: the largest |x_uu| + r |x_uv| over each */
    double *v;           /* [v spans]: the largest |x_vv| + |x_uv| / r; r differs between spans */
    double longest_u;    /* the largest |x_u| and */
    double longest_v;    /* |x_v| */
    double lo[3], hi[3]; /* the box of the samples */
} taut_bending;

/* Samples a surface; the arrays are taken from the arena. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_bending_sample(const taut_surface *surface, const taut_crew *crew,
                                taut_arena *arena, taut_bending *bending);

/* The number of cells of a span of this width and bending under a chord tolerance (absolute): at
 * least 1; not whole and not finite where it is too large to be had. */
double taut_cell_count(double width, double bending, double tolerance);

#endif /* TAUT_MESH_LINES_H */
