/* edge.h -- the four edges of a surface: u0, u1, v0, v1 in the order of taut_edge. */
#ifndef TAUT_MEASURE_CURVATURE_EDGE_H
#define TAUT_MEASURE_CURVATURE_EDGE_H

#include "measure/integrate/line.h"
#include "taut/measure.h"

/* The direction that is held along an edge (0: u), and the one that runs. */
static inline int taut_edge_held(int edge)
{
    return edge / 2;
}

/* The held parameter. */
static inline double taut_edge_at(const taut_surface *surface, int edge)
{
    const taut_basis *basis = edge < 2 ? taut_surface_u(surface) : taut_surface_v(surface);
    return edge % 2 == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis);
}

/* Length, normal curvature and angle along one edge. TAUT_NO_MEMORY. */
taut_status taut_edge_measure_of(const taut_surface *surface, int edge, int grid,
                                 taut_edge_measure *measure);

#endif /* TAUT_MEASURE_CURVATURE_EDGE_H */
