/* fit.h -- the harmonic surface nearest to four boundary rows. */
#ifndef TAUT_HARMONIC_FIT_H
#define TAUT_HARMONIC_FIT_H

#include "taut/harmonic.h"

/* [NiWang2015] section 8.3: least squares of the boundary distance over the harmonic space, in a
 * basis made orthonormal on the boundary. details: boundary_gap (largest distance found, user's
 * unit). */
taut_status taut_harmonic_fit(const taut_harmonic_problem *problem, taut_model **model,
                              taut_error *error);

#endif /* TAUT_HARMONIC_FIT_H */
