/* blend.h -- the tube about an arc as NURBS of bidegree (n, 2), n the degree of the arc. */
#ifndef TAUT_PIPE_BLEND_H
#define TAUT_PIPE_BLEND_H

#include "construct/pipe/frame.h"
#include "core/arena.h"
#include "taut/basis.h"

enum { TAUT_PIPE_RING = 9 }; /* points of a circle in four quarters */

typedef struct taut_pipe_blend {
    int segments;
    double *breaks; /* double[segments + 1] */
    int rows;       /* (n - 1) segments + 2 */
    double *points; /* double[rows][TAUT_PIPE_RING][3], local */
    double last[3]; /* the first vector of the frame at the end, over the radius */
    double slack;   /* how far a point may be moved on the tube unseen, over the radius */
} taut_pipe_blend;

/* X = P + a (c U + s W): (c, s) the rational quadratic circle, U and W cubic Hermite interpolants
 * of the frame with its exact derivatives ([WangBai2018] section 10.8). At the ends U and W are
 * unit and normal and their derivatives along the tangent (or turning about it), so the tangent
 * planes there are exactly those of the cylinders. About arcs of degree 5 and more the interpolants
 * are quintic, with second derivatives: where the arc has no curvature at its ends, the curvatures
 * are those of the cylinders too. As many segments as bring the distance from the
 * exact tube below `tolerance` times the radius.
 * binormal: Frenet frames; NULL: rotation-minimising ones. profile: NULL for round sections.
 * name: of the tube in messages. TAUT_NO_MEMORY, or TAUT_NO_SOLUTION when it would take more than
 * 100,000 segments; the arena owns what is made. */
taut_status taut_pipe_blend_make(const taut_pipe_arc *arc, double radius, double tolerance,
                                 const taut_pipe_binormal *binormal,
                                 const taut_pipe_profile *profile, taut_arena *arena,
                                 const char *name, taut_pipe_blend *blend, taut_error *error);

/* Rings beside the end rings, in the user's coordinates, moved along the axis to where rounding
 * leaves them on the lines of the straight pipes: degree 5 two of them, else one. */
void taut_pipe_straighten(const taut_pipe_arc *arc, const taut_pipe_blend *blend, double radius,
                          double *points);

/* Bases that the arena owns: any, those of the blend along u and of all rings along v, and that of
 * straight pipes along u. */
taut_status taut_pipe_basis(const taut_basis_spec *spec, int count, taut_arena *arena,
                            const taut_basis **basis, taut_error *error);
taut_status taut_pipe_basis_u(const taut_pipe_arc *arc, const taut_pipe_blend *blend,
                              taut_arena *arena, const taut_basis **u, taut_error *error);
taut_status taut_pipe_basis_v(taut_arena *arena, const taut_basis **v, taut_error *error);
taut_status taut_pipe_basis_line(taut_arena *arena, const taut_basis **line, taut_error *error);
/* 1 and sqrt(1/2) in turns: double[rows][TAUT_PIPE_RING] */
void taut_pipe_weights(int rows, double *weights);

#endif /* TAUT_PIPE_BLEND_H */
