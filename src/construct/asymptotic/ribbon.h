/* ribbon.h -- Algorithm 2: the cross tangents along the edges of a patch of bidegree m = 5n - 7.
 *
 * On a curved edge ([WangZhuLi2017], docs page (5.1))
 *     T = x r' + y (r' x r'') x r',   x = W sum_j alpha_j B_j^(3n-5),   y = W^4 (beta_0, beta_1)
 *       = N / W,                      N = alpha P + beta Qh   of degree m,
 * with r' = P / W^2, r' x r'' = Q / W^3, Qh = Q x P. Where r' x r'' vanishes at an inflection the
 * linear factor is taken out of Q, so that T leaves the tangent there too (docs page 10.2).
 * A straight edge takes the cubic Hermite vector polynomial through its end data.
 */
#ifndef TAUT_ASYMPTOTIC_RIBBON_H
#define TAUT_ASYMPTOTIC_RIBBON_H

#include "construct/asymptotic/patch.h"

enum {
    TAUT_RIBBON_ALPHA = 3 * TAUT_QUAD_DEGREE - 4, /* coefficients of alpha */
    TAUT_RIBBON_INFLECTIONS = 3 * TAUT_QUAD_DEGREE - 6
};

typedef struct taut_ribbon {
    int straight;
    int inflections;
    double inflection[TAUT_RIBBON_INFLECTIONS]; /* parameters, increasing */
    double alpha[TAUT_RIBBON_ALPHA];
    double beta[2];
    double tangent[2][3];                     /* r' at the ends */
    double p[2 * TAUT_QUAD_DEGREE - 1][3];    /* P */
    double qh[5 * TAUT_QUAD_DEGREE - 7][3];   /* Qh, inflections taken out */
    double numerator[TAUT_QUAD_PATCH + 1][3]; /* N */
} taut_ribbon;

/* P, Q without its inflections, Qh; r' at the ends. */
void taut_ribbon_fill(const taut_quad *quad, int edge, taut_ribbon *ribbon);

/* alpha_0, alpha_last, beta_0, beta_1 from T = r_f' at the ends (5.2), the partners' derivatives;
 * the other alpha 0, and N. */
void taut_ribbon_ends(const taut_quad *quad, int edge, taut_ribbon ribbons[4]);

/* N from alpha and beta. */
void taut_ribbon_numerator(int n, taut_ribbon *ribbon);

/* T' at an end of a curved edge: (N' - T W') / W. */
void taut_ribbon_slope(const taut_quad *quad, int edge, int end, const taut_ribbon *ribbon,
                       double slope[3]);

/* The neighbours of the end alphas such that both edges of each corner have one twist (5.3), the
 * twists, and the ribbons of straight edges. TAUT_NO_SOLUTION if twists cannot agree. */
taut_status taut_ribbon_twists(const taut_quad *quad, taut_ribbon ribbons[4], double twist[4][3],
                               taut_error *error);

/* Steps 3 and 4 (rows.c): fills the boundary rows, the second rows, and the inner weights with 1;
 * patch->m is 5n - 7. TAUT_NO_SOLUTION if a weight beside the boundary is not positive. */
taut_status taut_ribbon_rows(const taut_quad *quad, const taut_ribbon ribbons[4], taut_patch *patch,
                             taut_error *error);

/* The parameter at which a curved edge is singular, beta(t) = 0; NaN if there is none. */
double taut_ribbon_singular(const taut_ribbon *ribbon);

#endif /* TAUT_ASYMPTOTIC_RIBBON_H */
