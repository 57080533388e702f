/* bubble.h -- the polynomials on [0, 1] that vanish twice at both ends, in a basis made for second
 * derivatives:
 *     q_k'' = sqrt(2k+1) P_k(2t - 1),   q_k = q_k' = 0 at 0 and 1,   k = 2 .. m - 2,
 * so that int q_k'' q_l'' = delta_kl. Products q_k(u) q_l(v) span all that the inner points of a
 * net of bidegree (m, m) can do, and keep the least-squares problem of the thin plate well
 * conditioned where the Bernstein basis does not (docs page section 9).
 */
#ifndef TAUT_ASYMPTOTIC_BUBBLE_H
#define TAUT_ASYMPTOTIC_BUBBLE_H

/* values[d][k - 2] = q_k^(d)(t), d = 0..2, k = 2..m-2; m >= 4. values: double[3][m - 3]. Absolute
 * errors of a few units of rounding. */
void taut_bubble_eval(int m, double t, double *values);

/* coefficients[k - 2][j] = Bernstein coefficient j of q_k at degree m: double[m - 3][m + 1]. */
void taut_bubble_bernstein(int m, double *coefficients);

#endif /* TAUT_ASYMPTOTIC_BUBBLE_H */
