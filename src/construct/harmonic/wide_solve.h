/* wide_solve.h -- small dense systems in twice the precision. Matrices are row by row.
 *
 * pulse: told of the work, or NULL; once it says stop results have no meaning. */
#ifndef TAUT_HARMONIC_WIDE_SOLVE_H
#define TAUT_HARMONIC_WIDE_SOLVE_H

#include "core/pulse.h"
#include "core/twice.h"

/* Adds rows to a triangle: r'r becomes r'r + block'block ([GolubVanLoan2013] 5.2, Householder).
 *     r      [n][n], the upper triangle used, zero before the first call
 *     block  [rows][n], destroyed; scratch [n]
 * Right-hand sides are further columns: only the first `columns` are eliminated. */
void taut_wide_append(int columns, int n, taut_twice *r, int rows, taut_twice *block,
                      taut_twice *scratch, taut_pulse *pulse);

/* The right-hand sides x, the columns of r [columns][n] beyond the triangle, become r^-1 x. */
void taut_wide_back(int columns, int n, taut_twice *r, taut_pulse *pulse);

/* The affine solution set of c x = d for a consistent system of known rank, by Gram-Schmidt with
 * the longest row next, each orthogonalised twice.
 *     c      [rows][n], d [rows][sides]; destroyed
 *     basis  [n][n]: the first `rank` rows span the rows of c, the others its null space;
 *            orthonormal
 *     x      [sides][n]: the shortest solutions */
void taut_wide_constrain(int rows, int n, int rank, int sides, taut_twice *c, taut_twice *d,
                         taut_twice *basis, taut_twice *x, taut_pulse *pulse);

#endif /* TAUT_HARMONIC_WIDE_SOLVE_H */
