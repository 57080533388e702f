/* blossom.h -- B-spline coefficients over finer knots, as convex combinations of the old ones.
 *
 * The coefficient of a degree p spline that belongs to knots x_1 <= .. <= x_p in a row is the value
 * f(x_1, .., x_p) of its blossom. The old knots are refined locally by inserting what is missing,
 * one at a time ([Boehm1980]; [PieglTiller1997] A5.1): every step is a convex combination.
 */
#ifndef TAUT_BASIS_BLOSSOM_H
#define TAUT_BASIS_BLOSSOM_H

typedef struct taut_blossom taut_blossom;

taut_blossom *taut_blossom_new(int degree); /* scratch for one degree; NULL when memory runs out */
void taut_blossom_free(taut_blossom *blossom);

/* row[0..p]: f(x) = sum_a row[a] d[first + a].
 * knots  the old ones in full, clamped, count + p + 1 of them
 * x      double[p], non-decreasing, in the range; every old knot strictly between the first and the
 *        last of them is among them at least as often as it is a knot
 * Cost: O(p^2) for each knot that is missing. */
void taut_blossom_row(taut_blossom *blossom, const double *knots, int count, const double *x,
                      int *first, double *row);

/* rows[p+1][p+1]: the Bezier points of the piece on knot interval `low` (not empty), out of the
 * coefficients low - p .. low. Cost: O(p^3). */
void taut_blossom_piece(taut_blossom *blossom, const double *knots, int low, double *rows);

#endif /* TAUT_BASIS_BLOSSOM_H */
