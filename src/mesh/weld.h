/* weld.h -- vertices along seams become one place, and surfaces that meet are turned alike. */
#ifndef TAUT_MESH_WELD_H
#define TAUT_MESH_WELD_H

#include "mesh/seams.h"
#include "taut/mesh.h"

typedef struct taut_weld {
    const taut_seam *seams; /* edges count through the groups */
    int seam_count;
    const unsigned char *collapsed; /* [4 groups] */
    double tolerance;               /* a length */
    int own;                        /* nonzero: the vertices are control points */
    taut_mesh_group *groups;
    int group_count;
    double *positions; /* double[vertices][3]: welded ones take the place of the first of them */
    uint32_t *welded;  /* uint32_t[vertices], out: the first vertex at the same place */
    size_t vertex_count;
} taut_weld;

/* Welds the vertices of each seam whose two edges have as many, all within the tolerance, and those
 * of collapsed edges; sets groups[].turned. TAUT_NO_MEMORY. */
taut_status taut_weld_vertices(const taut_weld *weld);

#endif /* TAUT_MESH_WELD_H */
