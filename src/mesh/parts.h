/* parts.h -- what a mesh is made of, for the files that make one. */
#ifndef TAUT_MESH_PARTS_H
#define TAUT_MESH_PARTS_H

#include "core/arena.h"
#include "taut/mesh.h"

struct taut_mesh {
    taut_arena *arena; /* owns all arrays */
    size_t vertex_count, quad_count;
    double *positions, *normals, *parameters;
    uint32_t *quads, *triangles, *welded;
    taut_mesh_group *groups;
    int group_count;
};

/* Arrays for the counts of the mesh. TAUT_NO_MEMORY. */
taut_status taut_mesh_take_arrays(taut_mesh *mesh, taut_error *error);

/* The quads and triangles of a group whose vertices are there, and a normal, the mean of the faces around, to those that have
 * none: (0, 0, 0). */
void taut_mesh_fill_faces(taut_mesh *mesh, const taut_mesh_group *group);

/* thicken.c: what `thin` becomes at a thickness: each surface moved by half of it either way along its normals, and a strip between
 * the two along every edge that is open. `thick` is empty but for its arena. TAUT_NO_SOLUTION: "fold", "sheet";
 * TAUT_BAD_ARGUMENT: "too-fine"; TAUT_NO_MEMORY. */
taut_status taut_mesh_thicken(const taut_mesh *thin, const taut_model *model, double thickness,
                              int threads, taut_mesh *thick, taut_error *error);

#endif /* TAUT_MESH_PARTS_H */
