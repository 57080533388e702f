/* taut/mesh.h -- the surfaces of a model as quads and triangles.
 *
 * Every surface becomes a grid of vertices over its parameters, with lines at all knots, so that
 * each cell lies in one span. How fine it is follows from a chord tolerance: with cells of hu by hv
 * the mesh stays within
 *
 *     hu^2 |x_uu| / 8 + hu hv |x_uv| / 4 + hv^2 |x_vv| / 8        (to leading order)
 *
 * of the surface, where only the parts across x_u, across the tangent plane and across x_v count.
 *
 * Surfaces that share an edge (the same points at the same share of the edge's range, from either
 * end, within a hundredth of the tolerance and 1e-6 of the size) are cut alike along it, and the
 * vertices there are in the same place bit for bit: the mesh is closed where the surfaces are.
 *
 * One cell a span of surfaces of bidegree (1, 1) without weights, as panels are, has their control
 * points for vertices, digit by digit, and welds collapsed edges only where they are points to
 * rounding.
 *
 * With a thickness T each surface is a sheet: every vertex x becomes two, x + T/2 n and x - T/2 n, where surfaces meet
 * in an edge at T/2 from both (x + T/2 (n + m) / (1 + n . m)), and along edges that are open the two are joined by a strip. What
 * comes out is closed: a plate of an open sheet, a wall of an open tube, a hollow of a closed body. The groups are first the
 * surfaces on the sides that they are turned to, then in the same order the other sides, then the strips.
 */
#ifndef TAUT_MESH_H
#define TAUT_MESH_H

#include "taut/model.h"
#include "taut/monitor.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_mesh taut_mesh;

/* Zero means default everywhere. */
typedef struct taut_mesh_options {
    double tolerance;    /* chord error over the size (the diagonal of the box); 0: 1e-3 */
    int divide;          /* cells per knot span in each direction; 0: by tolerance */
    int threads;         /* 0: 1 */
    const char *surface; /* only surfaces of this name; NULL: all */
    taut_monitor monitor;
    double thickness; /* of a sheet, in the model's unit; 0: none */
} taut_mesh_options;

/* One surface: vertices first_vertex + i*nv + j at line i of u and line j of v, and the
 * (nu-1)*(nv-1) quads and twice as many triangles from first_quad and 2*first_quad on. */
typedef struct taut_mesh_group {
    const char *name; /* the surface's, borrowed from the mesh */
    int surface;      /* its index in the model */
    int nu, nv;       /* vertices along u and along v, 2 or more */
    int turned;       /* nonzero: its normal points the other way than its neighbours', or inwards
                       * where they close, or would with lids on edges that are rings, as tubes */
    size_t first_vertex, first_quad;
} taut_mesh_group;

/* Meshes the surfaces of a model. TAUT_BAD_ARGUMENT: an option out of its range, or more than
 * TAUT_POINTS_MAX vertices asked for; TAUT_NO_SOLUTION: the model has no such surface; with a thickness "fold":
 * T/2 times the largest curvature at a vertex is 1 or more, or a triangle of a side looks the other way than that of the
 * surface; "sheet": surfaces meet so that they have no two sides. Sides that meet far from where the surface does are not looked for;
 * TAUT_NO_MEMORY; TAUT_INTERRUPTED. Cost: evaluation at some samples per span and at the vertices.
 */
TAUT_API taut_status taut_mesh_new(const taut_model *model, const taut_mesh_options *options,
                                   taut_mesh **mesh, taut_error *error);
TAUT_API void taut_mesh_free(taut_mesh *mesh); /* NULL is fine */

TAUT_API size_t taut_mesh_vertex_count(const taut_mesh *mesh);
TAUT_API const double *taut_mesh_positions(const taut_mesh *mesh); /* double[n][3], borrowed */
/* double[n][3], unit: x_u x x_v, where it vanishes the mean of the faces around. */
TAUT_API const double *taut_mesh_normals(const taut_mesh *mesh);
TAUT_API const double *taut_mesh_parameters(const taut_mesh *mesh); /* double[n][2]: u, v */

/* Corners from 0, counter-clockwise seen from where the normal points to. */
TAUT_API size_t taut_mesh_quad_count(const taut_mesh *mesh);
TAUT_API const uint32_t *taut_mesh_quads(const taut_mesh *mesh); /* uint32_t[n][4] */
/* Each quad cut along its shorter diagonal: uint32_t[2 n][3]. */
TAUT_API const uint32_t *taut_mesh_triangles(const taut_mesh *mesh);
/* uint32_t[n]: the first vertex in the same place, across seams and along collapsed edges; faces
 * with a place twice have no area. */
TAUT_API const uint32_t *taut_mesh_welded(const taut_mesh *mesh);

TAUT_API int taut_mesh_group_count(const taut_mesh *mesh);
TAUT_API const taut_mesh_group *taut_mesh_group_at(const taut_mesh *mesh, int i); /* or NULL */

#ifdef __cplusplus
}
#endif
#endif /* TAUT_MESH_H */
