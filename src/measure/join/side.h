/* side.h -- one surface and its edge, seen from the join. */
#ifndef TAUT_MEASURE_JOIN_SIDE_H
#define TAUT_MEASURE_JOIN_SIDE_H

#include "core/pulse.h"
#include "measure/curvature/spot.h"
#include "taut/join.h"

typedef struct taut_join_side {
    const taut_surface *surface;
    taut_edge edge;
    int held;                /* direction across the edge: 0 u, 1 v */
    const taut_basis *along; /* basis that runs along the edge */
    const taut_basis *across;
    double sign_along;  /* -1 where the edge runs against the other */
    double sign_across; /* of the parameter's growth: out of the first surface, into the second */
    int scale;          /* points are divided by 2^scale */
    int shift_across;   /* parameters across by 2^shift_across: the same for both sides */
    taut_pulse *pulse;  /* told of what is evaluated, or NULL */
} taut_join_side;

/* The surface near a point of its edge: Taylor polynomials in (along, across), the second variable
 * growing from the first surface to the second. Once the side's pulse is stopped they are zero. */
void taut_join_spot(const taut_join_side *side, int span, double t, int order, taut_spot *spot);

/* The parameter of a side at the part in [0, 1] of the common direction along the edge. */
double taut_join_parameter(const taut_join_side *side, double part);
void taut_join_position(const taut_join_side *side, double t, double *x);

/* The largest distance at equal parts, `samples` intervals. */
double taut_join_affine_gap(const taut_join_side *a, const taut_join_side *b, int samples);

/* The nearest point of the side to x, a point of the other at `part`: the distance, and its
 * parameter in *t. Ends belong to ends. */
double taut_join_foot(const taut_join_side *side, const double *x, double part, int samples,
                      double *t);

/* How far up the orders two spots agree at one pair of points, 0..3, given that they meet; and
 * angles, NaN where undefined. g is 3 where a normal vanishes: such a point says nothing. */
typedef struct taut_join_contact {
    int c, g;
    double tangent_angle, normal_angle;
} taut_join_contact;

taut_join_contact taut_join_contact_of(const taut_spot *a, const taut_spot *b);

/* taut_join.one_surface. TAUT_NO_MEMORY. */
taut_status taut_join_is_one_surface(const taut_join_side *a, const taut_join_side *b, int *one);

/* Proves the gap and c_order of a join that is matched by the affine map of the sides: join->kind
 * and join->gap_bound, in the sides' scale; left alone where no proof is known. TAUT_NO_MEMORY. */
taut_status taut_join_prove(const taut_join_side *a, const taut_join_side *b, int break_count,
                            const double *breaks, double gap_limit, taut_join *join);

/* Only the gap, proved, of two edges matched by the affine map of one range to the other, `reversed`
 * or not: a length, rounding counted, however large; NaN where no proof is known. TAUT_NO_MEMORY. */
taut_status taut_join_gap(const taut_surface *a, taut_edge edge_a, const taut_surface *b,
                          taut_edge edge_b, int reversed, double *gap);

/* See taut/join.h: of what a derivative could be. */
static const double taut_join_tolerance = 1e-9;

#endif /* TAUT_MEASURE_JOIN_SIDE_H */
