/* normals.h -- the directions in which the points of the method "normal" move.
 *
 * The unit normals of the Dirichlet surface of the same net at its Greville points ([WuWang2011]
 * 7.2); where the normal vanishes, the mean of those around it. The surface travels with the model as
 * a witness, which proves itself: its known points are those of the film, and its energy is at rest
 * at all others (certify/plateau/plateau.c). Its normals are found here.
 */
#ifndef TAUT_CERTIFY_PLATEAU_NORMALS_H
#define TAUT_CERTIFY_PLATEAU_NORMALS_H

#include "core/arena.h"
#include "taut/record.h"
#include "taut/surface.h"

/* The surface of a witness, rows of points, on the bases and weights of the film; NULL where it is
 * none. Freed by the arena, whose status tells whether memory ran out. */
taut_surface *taut_certify_read_net(const taut_record *rows, const taut_surface *film,
                                    taut_arena *arena);

/* directions[nu][nv][3]. TAUT_NO_MEMORY. */
taut_status taut_certify_normals(const taut_surface *surface, double *directions);

#endif /* TAUT_CERTIFY_PLATEAU_NORMALS_H */
