/* run.h -- the vertices of a mesh along an edge of one of its groups: edge 4 g + e, e = 0, 1, 2, 3 for u0, u1, v0, v1. */
#ifndef TAUT_MESH_RUN_H
#define TAUT_MESH_RUN_H

#include "taut/mesh.h"

/* first, first + stride, ... */
typedef struct taut_edge_run {
    size_t first, stride;
    int count;
} taut_edge_run;

static inline taut_edge_run taut_edge_run_of(const taut_mesh_group *groups, int edge)
{
    const taut_mesh_group *group = &groups[edge / 4];
    const size_t nu = (size_t)group->nu, nv = (size_t)group->nv;
    const taut_edge_run runs[4] = {{0, 1, group->nv},
                                   {(nu - 1) * nv, 1, group->nv},
                                   {0, nv, group->nu},
                                   {nv - 1, nv, group->nu}};
    taut_edge_run run = runs[edge % 4];
    run.first += group->first_vertex;
    return run;
}

static inline size_t taut_edge_run_at(const taut_edge_run *run, int k)
{
    return run->first + run->stride * (size_t)k;
}

/* Around a surface, seen from its normal, the edges v0 and u1 are run along their parameter, v1 and
 * u0 against it. */
static inline int taut_edge_run_is_along(int edge)
{
    return edge % 4 == 1 || edge % 4 == 2;
}

#endif /* TAUT_MESH_RUN_H */
