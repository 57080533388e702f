/* glb_document.h -- the JSON chunk of a GLB file. */
#ifndef TAUT_IO_MESH_GLB_DOCUMENT_H
#define TAUT_IO_MESH_GLB_DOCUMENT_H

#include "io/mesh/out.h"
#include "mesh/colour.h"

/* What of the data is one group's. */
typedef struct glb_part {
    double lo[3], hi[3]; /* of its positions as written */
    size_t first_index, index_count;
    int keeps_all; /* all its triangles have a place twice, and are written all the same */
} glb_part;

typedef struct glb_plan {
    const taut_mesh *mesh;
    int count; /* groups */
    glb_part *parts;
    size_t index_count;
    double origin[3]; /* taken off the positions */
    taut_colour colour;
    double *values; /* [vertices]: the curvature shown; NULL: plain colours */
    double limit;   /* of its colours */
} glb_plan;

/* Bytes of the BIN chunk. */
size_t glb_data_length(const glb_plan *plan);
/* The text, freed by taut_free. TAUT_NO_MEMORY. */
taut_status glb_document_text(const glb_plan *plan, const taut_model *model, char **text,
                              size_t *length);
/* A byte of sRGB as the linear share that glTF wants. */
double glb_linear(unsigned char byte);

#endif /* TAUT_IO_MESH_GLB_DOCUMENT_H */
