/* quad.h -- a closed quadrilateral of rational Bezier curves of one degree, and which end of which
 * edge meets which. */
#ifndef TAUT_ASYMPTOTIC_QUAD_H
#define TAUT_ASYMPTOTIC_QUAD_H

#include "taut/asymptotic.h"

enum {
    TAUT_QUAD_DEGREE = TAUT_ASYMPTOTIC_DEGREE_MAX,
    TAUT_QUAD_POINTS = TAUT_QUAD_DEGREE + 1,
    TAUT_QUAD_PATCH = 5 * TAUT_QUAD_DEGREE - 7 /* highest degree of a patch */
};

/* One boundary curve: r(t) = sum_j w_j P_j B_j(t) / sum_j w_j B_j(t). */
typedef struct taut_quad_edge {
    double points[TAUT_QUAD_POINTS][3];
    double weights[TAUT_QUAD_POINTS];
    int straight;
} taut_quad_edge;

typedef struct taut_quad {
    int degree; /* n */
    taut_quad_edge edges[4];
    double rounding; /* of the coordinates as they were given; 0 where they were not */
} taut_quad;

/* At end `end` of edge `edge` the other edge there, its end, and the corner. */
typedef struct taut_quad_meeting {
    int edge, end, corner;
} taut_quad_meeting;
extern const taut_quad_meeting taut_quad_partner[4][2];

/* The two ends at a corner: first the edge that runs with u, then the one that runs with v. */
extern const taut_quad_meeting taut_quad_corner[4][2];

/* Leg of an edge at one of its ends, both in the direction of increasing parameter. */
void taut_quad_leg(const taut_quad *quad, int edge, int end, double leg[3]);

/* The point `step` places in from end `end`, and its weight. */
const double *taut_quad_point(const taut_quad *quad, int edge, int end, int step);
double taut_quad_weight(const taut_quad *quad, int edge, int end, int step);

/* Signed torsion tau = det(r', r'', r''') / |r' x r''|^2 at an end, from control points:
 *     (n-2)/n  w0 w3 / (w1 w2)  det(D0, D0^2, D0^3) / |D0 x D0^2|^2                             */
double taut_quad_torsion(const taut_quad *quad, int edge, int end);

/* Largest distance between two control points. */
double taut_quad_size(const taut_quad *quad);
/* The rounding of a coordinate: 2^-53 of the largest distance of a control point from the origin,
 * or what it was where the points were given. */
double taut_quad_rounding(const taut_quad *quad);

/* Raises a curve of degree p to n, and all four to degree n. */
void taut_quad_raise_edge(int p, int n, taut_quad_edge *edge);
void taut_quad_raise(taut_quad *quad, int n);

/* The quadrilateral of given curves: closed, end weights equal, raised to a common degree of at
 * least 3. TAUT_NO_SOLUTION or TAUT_BAD_INPUT say why not. */
taut_status taut_quad_of_curves(const taut_curve *const curves[4], taut_quad *quad,
                                taut_error *error);

#endif /* TAUT_ASYMPTOTIC_QUAD_H */
