/* meshes.h -- meshes for tests. */
#ifndef TAUT_TEST_MESHES_H
#define TAUT_TEST_MESHES_H

#include "taut/mesh.h"

/* CHECKs that it is made; 0 means the default of either. */
taut_mesh *mesh_of(const taut_model *model, double tolerance, int divide);

#endif /* TAUT_TEST_MESHES_H */
