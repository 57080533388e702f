/* thick.h -- solid sheets of a thickness T out of surfaces: NURBS for CAD systems.
 *
 *     sides    x(u, v) + T/2 n(u, v)  and  x(u, v) - T/2 n(u, v), as B-splines of degree 5
 *     walls    along each edge that no other surface shares, straight from one side to the other
 *
 * Where surfaces meet with one tangent plane, both sides meet as they do; what is left of an angle there (2.6 degrees at most)
 * is shared out over the surfaces. A sheet with an outline is one body, of the volume T A + T^3/12 int K dA (Steiner's
 * formula for both sides, whose terms in H cancel). A closed surface has two sides and no wall: a hollow.
 */
#ifndef TAUT_SHELL_THICK_THICK_H
#define TAUT_SHELL_THICK_THICK_H

#include "core/arena.h"
#include "taut/model.h"

typedef struct taut_thick_request {
    double thickness; /* T > 0, a length */
    double tolerance; /* > 0, a length: how near the splines come to the sides */
    double moved;     /* how far the surfaces may be from what they stand for */
    int threads;
} taut_thick_request;

typedef struct taut_thick {
    taut_model *
        model; /* of the caller: two sides of each surface, "NAME.top" and "NAME.bottom", and walls, "NAME.u0" ... */
    int *from; /* [its surfaces], in the arena: the surface that each comes from */
    double
        distance; /* the largest from a side that was met, at points between those interpolated: a check */
    double bound;  /* the largest from a side anywhere, proved; infinite where nothing is */
    double parted; /* what angles between surfaces take of it: finer splines do not lower that */
} taut_thick;

/* The sheets of all surfaces of a model of polynomial and rational surfaces; curves are left out.
 * TAUT_NO_SOLUTION: "fold": T/2 times the largest curvature met is 1 or more; "sheet": surfaces meet at an angle, an edge is a
 * point, or there is no normal; "too-many-points". TAUT_NO_MEMORY. */
taut_status taut_thick_new(const taut_model *nurbs, const taut_thick_request *request,
                           taut_arena *arena, taut_thick *sheet, taut_error *error);

#endif /* TAUT_SHELL_THICK_THICK_H */
