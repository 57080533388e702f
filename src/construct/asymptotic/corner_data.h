/* corner_data.h -- the input of Algorithm 1, checked and put per edge. */
#ifndef TAUT_ASYMPTOTIC_CORNER_DATA_H
#define TAUT_ASYMPTOTIC_CORNER_DATA_H

#include "construct/asymptotic/curve_energy.h"
#include "construct/asymptotic/quad.h"

/* One edge; index [0] is its start, [1] its end. */
typedef struct taut_corner_edge {
    int straight;
    double point[2][3];   /* A_0, A_1 */
    double leg[2][3];     /* a_0, a_1 */
    double partner[2][3]; /* c_0, c_1: the legs of the edges it meets */
    double normal[2][3];  /* n = a x c */
    double weight[2];
    double curvature[2];
    /* log of (n-1)/n w |n| / (k |a|^3), so that the end curvature asks for
     *     log w_1 = (bend + log w_2 + log |mu|) / 2                      (4.2) */
    double bend[2];
} taut_corner_edge;

typedef struct taut_corner_data {
    int degree;      /* that is solved for: 4 or 5 */
    int raised;      /* that it is to be raised to */
    double size;     /* largest distance between corners */
    double rounding; /* of the corners' coordinates */
    taut_corner_edge edges[4];
    taut_curve_rule coarse, fine; /* for the curve energies */
} taut_corner_data;

/* Of corners that passed taut_corner_check, for degree 4 and more; above 5 the degree solved for is 5. TAUT_BAD_INPUT: a number out of its
 * range; TAUT_NO_SOLUTION: legs parallel at a corner, unequal end weights, a straight edge whose
 * legs leave its chord. */
taut_status taut_corner_data_fill(const taut_asymptotic_corners *corners, double rounding,
                                  taut_corner_data *data, taut_error *error);

/* The checks that hold for every degree: finite corners, legs and weights, distinct corners, equal
 * weights where edges meet. */
taut_status taut_corner_check(const taut_asymptotic_corners *corners, taut_error *error);

/* The straight edge of zero energy at degree n: r linear in t ([WangZhuLi2017], docs page 4.2). */
void taut_corner_straight(const taut_corner_data *data, int edge, int n, taut_quad_edge *made);

/* Start and end corner of an edge: index 0 and 1. */
extern const int taut_corner_of_edge[4][2];

#endif /* TAUT_ASYMPTOTIC_CORNER_DATA_H */
