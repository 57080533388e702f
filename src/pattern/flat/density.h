/* density.h -- the energy of a place of a flat piece, and its variations.
 *
 * With J' = H J: dC = -(H' C + C H), and for two directions A, B
 *     C_ab = (A B + B A)' C + C (A B + B A) + A' C B + B' C A,   d det J = tr H det J,
 * so that a place has a 4 x 4 form in the entries of H.
 */
#ifndef TAUT_PATTERN_DENSITY_H
#define TAUT_PATTERN_DENSITY_H

#include "pattern/flat/flat.h"

typedef struct taut_flat_form {
    double w; /* 1/2 E : D : E det F0 det J */
    /* its first and second derivatives by the entries of H, (11, 12, 21, 22) */
    double first[4], second[4][4];
    double inverse[2][2], det; /* of J */
} taut_flat_form;

/* C = J^-T G J^-1, (11, 22, 12); 0 where det J <= 0. */
int taut_flat_stretch(const double j[2][2], const double g[3], double inverse[2][2], double *det,
                      double c[3]);
/* `shrink`: 1 / F0, of warp and weft; order 0: w alone, or all. 0 where det J <= 0. */
int taut_flat_density(const taut_flat_law *law, const double shrink[2], const double j[2][2],
                      const double g[3], int order, taut_flat_form *f);

#endif /* TAUT_PATTERN_DENSITY_H */
