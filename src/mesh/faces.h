/* faces.h -- the grid of one surface: vertices, normals, faces. */
#ifndef TAUT_MESH_FACES_H
#define TAUT_MESH_FACES_H

#include "taut/surface.h"

#include <stdint.h>

/* Vertices at lines u[nu] and v[nv]: positions and normals double[nu][nv][3], parameters
 * double[nu][nv][2]. A normal is (0, 0, 0) where |x_u x x_v| is less than 2^-40 of `speeds`, the
 * product of the largest |x_u| and |x_v|. TAUT_NO_MEMORY. */
taut_status taut_vertices_fill(const taut_surface *surface, int nu, const double *u, int nv,
                               const double *v, double speeds, int threads, double *positions,
                               double *normals, double *parameters);

/* quads uint32_t[(nu-1)(nv-1)][4], triangles [..][2][3] of a grid whose first vertex is `first`;
 * positions are those of the whole mesh. */
void taut_faces_fill(int nu, int nv, uint32_t first, const double *positions, uint32_t *quads,
                     uint32_t *triangles);

/* Gives vertices without a normal the mean of the faces around them; (0, 0, 1) where these have
 * none either. */
void taut_normals_mend(int nu, int nv, const double *positions, double *normals);

#endif /* TAUT_MESH_FACES_H */
