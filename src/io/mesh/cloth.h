/* cloth.h -- what a mesh of a cutting pattern shows besides its triangles: how its flat pieces are strained, and the lines of seams and
 * outlines. */
#ifndef TAUT_IO_MESH_CLOTH_H
#define TAUT_IO_MESH_CLOTH_H

#include "core/arena.h"
#include "io/file/sink.h"
#include "io/json/out.h"
#include "taut/mesh.h"

typedef struct taut_mesh_line {
    const char *name; /* the seam's or the curve's */
    size_t count;
    const double (*points)[3];
} taut_mesh_line;

/* values double[vertices]: the principal strain that is larger in size, beyond the compensation; NaN where no flat piece is, or no strain.
 * model: what the mesh was made of. TAUT_NO_MEMORY. */
taut_status taut_mesh_strains(const taut_model *model, const taut_mesh *mesh, taut_arena *arena,
                              double *values);
/* The model's seams, each as far above and below the surface as `lift` says, and its other curves, as polylines taken from the arena. TAUT_NO_MEMORY. */
taut_status taut_mesh_lines(const taut_model *model, double lift, taut_arena *arena, int *count,
                            const taut_mesh_line **lines);
/* A line as a mesh of glTF, its places those of an accessor. */
void taut_mesh_put_line(taut_json_out *out, const char *name, int accessor, int material);
/* The places of all lines in single precision, off an origin. */
void taut_mesh_write_lines(taut_sink *sink, int count, const taut_mesh_line *lines,
                           const double origin[3]);

#endif /* TAUT_IO_MESH_CLOTH_H */
