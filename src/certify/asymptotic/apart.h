/* apart.h -- how far apart two rational Bezier curves are at equal parameters, proved.
 *
 *     |X/v - Y/w| <= max |D_k| / min d_k,    X w - Y v = sum_k D_k B[m+n,k],  v w = sum_k d_k B[m+n,k]
 *     D_(i+j) += C(m,i) C(n,j) / C(m+n,i+j) v_i w_j (P_i - Q_j)
 *
 * on pieces. D is formed in twice the precision of double, so that curves that differ by a rounding
 * are told apart by a rounding (certify/common/curve_distance.h knows some hundred).
 */
#ifndef TAUT_CERTIFY_ASYMPTOTIC_APART_H
#define TAUT_CERTIFY_ASYMPTOTIC_APART_H

#include <stdint.h>

/* A rational Bezier curve over [0, 1]; weights NULL: all 1. `stride`: from a point to the next. */
typedef struct taut_bezier_row {
    int degree;
    int64_t stride;
    const double *points, *weights;
} taut_bezier_row;

enum { TAUT_APART_DEGREE = 48 /* of both together: the binomials are exact */ };

/* A number that their distance does not exceed, near `seen`, a distance that they have somewhere;
 * infinite where the degrees are too high or nothing is proved. */
double taut_curves_apart(const taut_bezier_row *a, const taut_bezier_row *b, double seen);

#endif /* TAUT_CERTIFY_ASYMPTOTIC_APART_H */
