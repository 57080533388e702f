/* arc.h -- one polynomial piece of an axis, in Bezier form, with its curvature ready.
 *
 * An axis is made of arcs; they are kept in local coordinates (the first point near the origin, the
 * whole of about unit size), so that no number below has absolute thresholds or cancels far from
 * the origin ([WangBai2018] section 9).
 */
#ifndef TAUT_PIPE_ARC_H
#define TAUT_PIPE_ARC_H

enum { TAUT_PIPE_DEGREE_MAX = 7 };

typedef struct taut_pipe_arc {
    int degree;                                    /* n, 2 or more */
    double points[TAUT_PIPE_DEGREE_MAX + 1][3];    /* Bezier points */
    double velocity[TAUT_PIPE_DEGREE_MAX][3];      /* of P', degree n - 1 */
    double cross[2 * TAUT_PIPE_DEGREE_MAX - 3][3]; /* of P' x P'', degree 2n - 4 */
} taut_pipe_arc;

/* Everything from the points: P' x P'' = n-1 times the product of the two halves of P'. */
void taut_pipe_arc_finish(taut_pipe_arc *arc);
/* The quartic of a CE-Bezier curve with edges e_i from the origin ([WangBai2018] 2.2), P' and
 * P' x P'' in the product form of 2.3, which has no cancellation in the legal box. */
void taut_pipe_arc_quasi(const double edges[3][3], const double shape[3], taut_pipe_arc *arc);
/* The quintic with three points on either end edge, q_1 and q_4 at parts (3 + alpha) / 4 and
 * (3 + gamma) / 4 of them, which has no curvature at its ends ([WangBai2018] section 10.4); beta is
 * not used. Products of parallel edges are exactly 0. */
void taut_pipe_arc_quintic(const double edges[3][3], const double shape[3], taut_pipe_arc *arc);

/* What is asked of a point of an arc. */
typedef struct taut_pipe_jet {
    double point[3], d1[3], d2[3];
    double cross[3]; /* P' x P'' */
    double speed;    /* |P'| */
    double tangent[3];
    double turn[3];   /* dT/dt */
    double bent[3];   /* d^2 T/dt^2 */
    double curvature; /* 0 where the speed is */
} taut_pipe_jet;

void taut_pipe_arc_jet(const taut_pipe_arc *arc, double t, taut_pipe_jet *jet);
void taut_pipe_arc_point(const taut_pipe_arc *arc, double t, double point[3]);
/* The Bezier points of the piece [lo, hi]: double[degree+1][3]. */
void taut_pipe_arc_piece(const taut_pipe_arc *arc, double lo, double hi, double (*points)[3]);

#endif /* TAUT_PIPE_ARC_H */
