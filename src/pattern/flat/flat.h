/* flat.h -- the flat piece of cloth from which a piece of a surface is made with the least strain.
 *
 * The piece is carried by (s, t) in [0, 1]^2, s along it; G(s, t) is its metric. The flat piece y(s, t)
 * is a tensor spline of degree 5 that makes
 *
 *     W(y) = iint 1/2 E : D : E  det F0 det J ds dt,   E = 1/2 (F0^-1 C F0^-1 - 1),   C = J^-T G J^-1
 *
 * least, J = (y_s, y_t), F0 = diag(1/(1 - warp), 1/(1 - weft)): the energy that the mounted cloth holds
 * beyond its prestress. y_1 is the warp. The middle of `start` lies in the origin, the chord to the
 * middle of `end` along y_1, or at the angle `thread` from it. Held edges get a length that is told at
 * every Gauss point, weakly: int N_a (|y_s| - l) ds = 0 for every spline N_a of degree 4, so that the
 * whole length is exact to rounding.
 *
 * W grows without bound where det J falls to 0: it is its own barrier, up to what a quadrature sees.
 * Sources: [LinhardWuechnerBletzinger2008] (least deviation of stress); Newton on the Lagrangian with
 * exact second derivatives, [NocedalWright2006] 16.1, 18.1 (inertia).
 */
#ifndef TAUT_PATTERN_FLAT_H
#define TAUT_PATTERN_FLAT_H

#include "core/arena.h"
#include "core/pulse.h"

enum { TAUT_FLAT_DEGREE = 5, TAUT_FLAT_GAUSS = 6, TAUT_FLAT_SPANS_MAX = 200 };

/* Edges counter-clockwise: t = 0, s = 1, t = 1, s = 0. */
typedef enum taut_flat_edge {
    TAUT_FLAT_RIGHT = 0,
    TAUT_FLAT_END,
    TAUT_FLAT_LEFT,
    TAUT_FLAT_START,
    TAUT_FLAT_EDGES
} taut_flat_edge;

/* Plane stress, orthotropic in the cloth's frame, order (11, 22, 2 12); only ratios matter. */
typedef struct taut_flat_law {
    double d11, d22, d12, d33;
} taut_flat_law;

typedef struct taut_flat_options {
    int spans[2]; /* along s and t; 0: 16 and 4 */
    int graded;   /* nonzero: they are narrower next to corners */
    const taut_flat_law
        *law;          /* NULL: D11 = D22 = 1, D12 = 0, D33 = 1/2: least squares of all strains */
    double warp, weft; /* compensation */
    double thread;     /* radians */
    int straight;      /* nonzero: start and end straight and square to y_1 */
    int is_point
        [2]; /* nonzero: start, or end, has no length, and is one place; not both, not straight */
    /* |y_s| / |X_s| at the edge's Gauss points, [spans][TAUT_FLAT_GAUSS] as s (or t) grows; NULL: free */
    const double *held[TAUT_FLAT_EDGES];
    taut_pulse *pulse; /* or NULL */
} taut_flat_options;

typedef struct taut_flat_strip {
    /* g_ss, g_st, g_tt of a place; positive definite */
    void (*metric)(const void *context, double s, double t, double g[3]);
    const void *context;
    /* 1 / F0 there, of warp and weft; NULL: what options say everywhere */
    void (*shrink)(const void *context, double s, double t, double shrink[2]);
} taut_flat_strip;

typedef struct taut_flat {
    int spans[2], graded, count[2];
    double *knots[2]; /* [count + 6] */
    double *points;   /* [count[0]][count[1]][2] */
    taut_flat_law law;
    double warp, weft;
    double energy, area, flat_area;
    double
        residual; /* before the last step: gradient of the Lagrangian over the largest of a Hessian's diagonal times the size */
    int is_stable; /* the Hessian is positive on the constraints */
    int steps;     /* of Newton, all told */
    double torque; /* of the thread's constraint; 0 where the law has no direction */
} taut_flat;

/* In the arena. TAUT_NO_MEMORY; TAUT_INTERRUPTED as the pulse says; TAUT_NOT_CONVERGED: flat->steps tells after how many, and an energy of
 * INFINITY that no start without folds was found. `from`: a flat piece of the same strip, law and spans to
 * start from, or NULL: unrolled. */
taut_status taut_flatten(taut_arena *arena, const taut_flat_strip *strip,
                         const taut_flat_options *options, const taut_flat *from, taut_flat *flat);

/* The places where coefficient i of a direction of so many spans is at home: the mean of its inner knots. */
double taut_flat_greville(int spans, int graded, int i);
/* The same of a piece without Gauss curvature: `places`, double[count[0]][count[1]][2], are those of the Greville places, laid flat
 * without strain anywhere; turned, moved and made smaller as options say, none held. Its steps are 0. */
taut_status taut_flat_of_places(taut_arena *arena, const taut_flat_strip *strip,
                                const taut_flat_options *options, const double *places,
                                taut_flat *flat);
/* The same piece on twice the spans both ways, to start from: without knots. TAUT_NO_MEMORY. */
taut_status taut_flat_halve(taut_arena *arena, const taut_flat *from, taut_flat *to);
/* A copy in another arena. TAUT_NO_MEMORY. */
taut_status taut_flat_copy(taut_arena *arena, const taut_flat *from, taut_flat *to);

/* y, y_s, y_t at a place. */
void taut_flat_at(const taut_flat *flat, double s, double t, double y[3][2]);
/* Principal strains beyond the compensation there (`shrink`: 1 / F0), falling, of a metric; and, where `cloth` is not NULL, those of warp
 * and weft and the angle by which theirs is less than a right one. */
void taut_flat_strain(const double shrink[2], const double g[3], const double y[3][2],
                      double strain[2], double cloth[3]);
/* Of a strip that is not what it was laid flat of: area and energy. */
void taut_flat_measure(const taut_flat_strip *strip, taut_flat *flat);
/* The length of an edge, and |y_s| / |X_s| at its Gauss points ([spans][TAUT_FLAT_GAUSS], or NULL). */
double taut_flat_edge_length(const taut_flat *flat, const taut_flat_strip *strip,
                             taut_flat_edge edge, double *stretch);

#endif /* TAUT_PATTERN_FLAT_H */
