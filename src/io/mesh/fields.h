/* fields.h -- what the fundamental forms say at the vertices of a mesh. */
#ifndef TAUT_IO_MESH_FIELDS_H
#define TAUT_IO_MESH_FIELDS_H

#include "core/pulse.h"
#include "taut/mesh.h"

enum { TAUT_FIELD_H, TAUT_FIELD_K, TAUT_FIELD_E_MINUS_G, TAUT_FIELD_F, TAUT_FIELD_I, TAUT_FIELDS };

enum {
    TAUT_FIELDS_WORK = 500
}; /* operations of a place, as pulses count them, its derivatives included */

/* fields double[nu][nv][TAUT_FIELDS] of one group, its parameters those of the mesh: mean and
 * Gaussian curvature (NaN where there is no normal), E - G, F, and isothermality. pulse, which may be
 * NULL, is told of it. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_mesh_fields(const taut_surface *surface, const taut_mesh *mesh,
                             const taut_mesh_group *group, int threads, taut_pulse *pulse,
                             double *fields);

/* All of them at one point, from position and derivatives double[6][3]. */
void taut_fields_of(const double *vectors, double fields[TAUT_FIELDS]);

#endif /* TAUT_IO_MESH_FIELDS_H */
