/* taut/join.h -- how two surfaces meet along an edge.
 *
 * Each surface brings one edge. They are matched end to end, whichever way they run and whatever
 * the speed of their parameters: by the affine map of one range to the other where that closes the
 * gap, else point by point to the nearest. `out` is the derivative across the first edge, out of
 * its surface; `in` that across the second edge, into its surface.
 *
 *     C^k   the derivatives of order 0..k of the first surface by `out` equal those of the second
 *           by `in`, each by its surface's own parameter
 *     G^k   over their common tangent plane both surfaces have the same Taylor polynomial of order
 *           k: tangent planes (1, and no fold), second fundamental forms (2), their rates (3). It
 *           does not depend on parameters
 *
 * Two derivatives are equal when they differ by at most 1e-9 of what the derivative of that order
 * could be for nets of this size (2^k n!/(n-k)! times the size for Bezier nets; with weights, what
 * the quotient rule allows at the point, so that heavy rows elsewhere excuse nothing); a gap
 * counts as closed when it is at most 1e-9 of the size of the larger net. Source of the C^k test: [NiWang2015] section
 * 2.6 (3), section 3 algorithm E.
 */
#ifndef TAUT_JOIN_H
#define TAUT_JOIN_H

#include "taut/monitor.h"
#include "taut/record.h"
#include "taut/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Named by the parameter held: u = umin, u = umax, v = vmin, v = vmax. */
typedef enum taut_edge { TAUT_EDGE_U0, TAUT_EDGE_U1, TAUT_EDGE_V0, TAUT_EDGE_V1 } taut_edge;

TAUT_API const char *taut_edge_name(taut_edge edge); /* "u0", ...; "" for none */
/* TAUT_BAD_ARGUMENT: no edge has this name. */
TAUT_API taut_status taut_edge_of_name(const char *name, taut_edge *edge);

/* What max_gap and c_order rest on: places, or coefficients of the polynomials that the derivatives
 * of both surfaces differ by. */
typedef enum taut_join_kind { TAUT_JOIN_CHECK = 0, TAUT_JOIN_BOUND = 1 } taut_join_kind;

typedef struct taut_join {
    double max_gap;           /* largest distance between matched points that was found */
    double gap_bound;         /* no pair is farther apart, rounding counted; NaN where not proved */
    double max_tangent_angle; /* of `out` and `in`, in [0, pi]; NaN where undefined all along */
    double max_normal_angle;  /* of the normals, both on the same side of a smooth join: [0, pi];
                               * NaN where undefined all along. Points where a normal vanishes are
                               * left out, here and of g_order >= 1 */
    int c_order, g_order;     /* -1 for a gap, at most 3 */
    int reversed;             /* nonzero: the edges run against each other */
    int one_surface; /* 1: both are polynomial Bezier patches, of one bidegree, and pieces of one
                      * polynomial surface; 0: such patches, but not of one; -1: not such patches */
    taut_join_kind kind; /* bound: there is no gap anywhere, and derivatives up to c_order are
                            * equal all along; with a normal everywhere g_order >= c_order then. On
                            * polynomial bases, with weights too, where the edges are matched by
                            * the affine map; beyond c_order, g_order and angles are checks */
} taut_join;

/* TAUT_BAD_ARGUMENT (NULL, no such edge), TAUT_NO_MEMORY. Edges of high degree that do not meet take seconds: of degree
 * 127, ten. */
TAUT_API taut_status taut_join_measure(const taut_surface *a, taut_edge edge_a,
                                       const taut_surface *b, taut_edge edge_b, taut_join *join,
                                       taut_error *error);

/* Zero means default everywhere. */
typedef struct taut_join_options {
    taut_monitor monitor; /* TAUT_INTERRUPTED where it says stop, or enough */
} taut_join_options;

/* The same with options, which may be NULL. */
TAUT_API taut_status taut_join_measure_with(const taut_surface *a, taut_edge edge_a,
                                            const taut_surface *b, taut_edge edge_b,
                                            const taut_join_options *options, taut_join *join,
                                            taut_error *error);

/* The document of `taut join --json`: adds its members to `record`; one_surface only where it is
 * known. */
TAUT_API void taut_join_record(const taut_join *join, taut_record *record);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_JOIN_H */
