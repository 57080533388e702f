/* meshes.h -- meshes for tests. */
#ifndef TAUT_TEST_MESHES_H
#define TAUT_TEST_MESHES_H

#include "taut/mesh.h"

/* CHECKs that it is made; 0 means the default of either. */
taut_mesh *mesh_of(const taut_model *model, double tolerance, int divide);

/* What all triangles with three places say, turned as their groups are. */
typedef struct mesh_body {
    size_t open;   /* runs without one run the other way, or run twice */
    double volume; /* six times the sum of a . (b x c), over 6 */
} mesh_body;

mesh_body mesh_look_at(const taut_mesh *mesh);

#endif /* TAUT_TEST_MESHES_H */
