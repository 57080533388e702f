/* out.h -- what the mesh formats share: the mesh of the options, the triangles that have an
 * area, and numbers as little-endian bytes. */
#ifndef TAUT_IO_MESH_OUT_H
#define TAUT_IO_MESH_OUT_H

#include "io/file/sink.h"
#include "taut/mesh.h"
#include "taut/write.h"

#include <stdint.h>

/* Meshes what the options ask for. */
taut_status taut_mesh_out_new(const taut_model *model, const taut_write_options *options,
                              taut_mesh **mesh, taut_error *error);

/* The triangles of a mesh (or of one group) but those with a place twice. */
size_t taut_mesh_out_count(const taut_mesh *mesh, const taut_mesh_group *group);
/* Are the three corners in three places? */
int taut_mesh_out_is_kept(const taut_mesh *mesh, const uint32_t *triangle);
/* The triangles of a group: taut_mesh_triangles from here on, so many. */
const uint32_t *taut_mesh_out_triangles(const taut_mesh *mesh, const taut_mesh_group *group,
                                        size_t *count);

/* Which corner of a face of `size` corners comes k-th, so that the face is seen from the side that its
 * group is turned to. */
static inline size_t taut_mesh_out_corner(const taut_mesh_group *group, size_t size, size_t k)
{
    return group->turned ? size - 1 - k : k;
}

/* The normals of all vertices on the sides that their groups are turned to, double[vertices][3], freed
 * by taut_free. NULL: no memory. */
double *taut_mesh_out_normals(const taut_mesh *mesh);

/* TAUT_NO_SOLUTION where a coordinate is too large for single precision, which `format` has. */
taut_status taut_mesh_out_check_float(const taut_mesh *mesh, const char *format, taut_error *error);

void taut_mesh_out_u16(taut_sink *sink, unsigned value);
void taut_mesh_out_u32(taut_sink *sink, uint32_t value);
void taut_mesh_out_f32(taut_sink *sink, double value);
void taut_mesh_out_f64(taut_sink *sink, double value);

/* The surfaces of the mesh: as many of its groups come first, one each. */
int taut_mesh_out_surfaces(const taut_mesh *mesh);
/* The number of the colour of group g: the first group of its surface, out of that many. */
int taut_mesh_out_colour(const taut_mesh *mesh, int surfaces, int g);
/* Its plain colour, by its surface's name (mesh/colour.h). */
int taut_mesh_out_plain(const taut_model *model, const taut_mesh *mesh, int surfaces, int g);

/* The group's name, or "surface<i>" where it has none, in room for TAUT_NAME_MAX + 1 bytes. */
const char *taut_mesh_out_name(const taut_mesh_group *group, char *room);

/* Ends writing. */
taut_status taut_mesh_out_finish(taut_sink *sink, taut_error *error);

#endif /* TAUT_IO_MESH_OUT_H */
