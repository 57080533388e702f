/* bracket.h -- where a function of one variable vanishes or is largest between two places.
 *
 * Both take few calls where the function is smooth and no more than bisection and golden section where it
 * is not; where it has a jump or a kink the place of that is found.
 * Sources: [Chandrupatla1997] for roots, [Brent1973] chapter 5 for the largest value.
 */
#ifndef TAUT_NUMERIC_BRACKET_H
#define TAUT_NUMERIC_BRACKET_H

typedef double taut_bracket_function(const void *context, double t);

/* Where f changes its sign between low and high: f_low and f_high are its values there, not of one sign.
 * To 4 ulp of the larger of |low| and |high|. */
double taut_bracket_root(taut_bracket_function *f, const void *context, double low, double high,
                         double f_low, double f_high);

/* The largest value of f between low and high, and in *at its place, to the square root of rounding where
 * f is smooth: the value to rounding. A local one where there are several. */
double taut_bracket_most(taut_bracket_function *f, const void *context, double low, double high,
                         double *at);

#endif /* TAUT_NUMERIC_BRACKET_H */
