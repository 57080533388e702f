/* dense.h -- dense linear algebra in the small: Householder triangles, Jacobi singular values, and
 * eigenvalues (symmetric.c). Nothing here allocates.
 *
 * Matrices are column-major: a[i + j ld] is row i, column j. Sources: [GolubVanLoan2013] 5.1-5.3
 * (Householder), 8.3 (eigenvalues), 8.6.3 (one-sided Jacobi).
 */
#ifndef TAUT_NUMERIC_DENSE_H
#define TAUT_NUMERIC_DENSE_H

enum { TAUT_SVD_MAX = 48 };   /* most columns of a singular value decomposition */
enum { TAUT_EIGEN_MAX = 96 }; /* most rows of a symmetric eigenvalue problem */

/* Adds rows to a triangle: on return r'r is what r'r + block'block was, so that least squares over
 * any number of rows is done block by block.
 *     r      double[n][n], upper triangle used; zero before the first call
 *     block  rows x n with leading dimension `rows`; destroyed
 * Right-hand sides are further columns. Backward stable; cost 2 rows n^2. */
void taut_qr_append(int n, double *r, int rows, double *block);

/* x <- r^-1 x for the leading n x n upper triangle of r (leading dimension ld). Returns 0, with x
 * untouched, if a diagonal entry is below 1e-14 of the largest: the columns are dependent. */
int taut_triangle_solve(int n, int ld, const double *r, double *x);

/* a = u s v', rows >= columns: a (leading dimension rows) becomes u, s double[columns] decreasing,
 * v double[columns][columns] column-major. Columns of u with s = 0 are zero.
 * Singular values to relative accuracy where a's columns are well scaled. */
void taut_svd(int rows, int columns, double *a, double *s, double *v);

/* The least-squares solution of least norm of a x = b: singular values below `cut` times the
 * largest count as zero. Any shape with both sides at most TAUT_SVD_MAX.
 *     a  rows x columns, leading dimension rows; kept      b  double[rows]
 *     x  double[columns]
 *     null  double[columns][columns - rank] column-major, an orthonormal basis of the null space,
 *           or NULL (room for columns x columns numbers)
 * Returns the rank. */
int taut_least_norm(int rows, int columns, const double *a, const double *b, double cut, double *x,
                    double *null);

/* a = v diag(values) v' for a symmetric n x n a, n at most TAUT_EIGEN_MAX, which is destroyed;
 * values increasing, errors some roundings of the largest. Cost about 9 n^3. */
void taut_symmetric_eigen(int n, double *a, double *values, double *v);

#endif /* TAUT_NUMERIC_DENSE_H */
