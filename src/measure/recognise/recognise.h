/* recognise.h -- what the files of recognise share. */
#ifndef TAUT_MEASURE_RECOGNISE_RECOGNISE_H
#define TAUT_MEASURE_RECOGNISE_RECOGNISE_H

#include "taut/recognise.h"

#include <complex.h>

/* Phi', Phi'', Phi''' at (x, y): x runs along u, or along v where turned. Four functions alive in
 * each direction. */
void taut_phi_of(const taut_surface *surface, int turned, const double at[2],
                 double complex phi[3][3]);

/* A bicubic net without weights; residual stays infinite where it cannot be Enneper's surface. */
void taut_recognise_enneper(const taut_surface *surface, taut_family_member *member);

#endif /* TAUT_MEASURE_RECOGNISE_RECOGNISE_H */
