/* inflection.h -- the parameters at which r' x r'' vanishes, taken out of its numerator. */
#ifndef TAUT_ASYMPTOTIC_INFLECTION_H
#define TAUT_ASYMPTOTIC_INFLECTION_H

/* q: vector polynomial double[degree + 1][3]. Every zero in [0, 1] common to its three components
 * is divided out, and the quotient raised again to `degree`:
 *     q(t) <- q(t) / prod (t - t_k)
 * at: the zeros, increasing, room for `degree` of them. rounding: of the data q is made of, over
 * its size. Returns how many. */
int taut_inflections_remove(int degree, double rounding, double (*q)[3], double *at);

#endif /* TAUT_ASYMPTOTIC_INFLECTION_H */
