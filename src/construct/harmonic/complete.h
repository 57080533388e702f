/* complete.h -- harmonic nets from their data, on normalised parameters with mu = (a/b)^2.
 *
 * Nets are double[n+1][m+1][3]: n the degree along u, m along v. The data is used as it is: scale
 * and centre it before. Curves are on the stack (degrees at most TAUT_DEGREE_MAX), the sums in
 * `wide`, taut_twice[n+1][m+1][3], which is rounded once. Nothing can fail; where numbers overflow
 * the result is not finite, which callers check. pulse: told of the work, or NULL; once it says stop
 * results have no meaning.
 */
#ifndef TAUT_HARMONIC_COMPLETE_H
#define TAUT_HARMONIC_COMPLETE_H

#include "construct/harmonic/lidstone.h"
#include "core/pulse.h"

/* From the curves on u = 0 and u = 1, of degree m ([NiWang2015] section 2.4, algorithm B). n >= m
 * for odd m; for even m, n > m, or n = m and the two top differences agree (their mean is used). */
void taut_harmonic_from_rows(int n, int m, taut_twice mu, const double *row0, const double *row1,
                             taut_twice *wide, double *net, taut_pulse *pulse);
/* The largest growth from data to net, in the largest-coordinate norm (section 7). */
double taut_harmonic_rows_amplification(int n, int m, double mu, taut_pulse *pulse);

/* From the curve on u = 0 and the derivative across it; width times `cross` is dP/du in normalised
 * u (section 2.5, algorithm C). For even m = n the top difference of `cross` must vanish; its term
 * is left out. */
void taut_harmonic_from_derivative(int n, int m, taut_twice mu, const double *row, double width,
                                   const double *cross, taut_twice *wide, double *net,
                                   taut_pulse *pulse);
/* The same as growth from the first two rows of the net; scratch net [n+1][m+1][3], sum
 * [n+1][m+1]. */
double taut_harmonic_derivative_amplification(int n, int m, taut_twice mu, taut_twice *net,
                                              double *sum, taut_pulse *pulse);

#endif /* TAUT_HARMONIC_COMPLETE_H */
