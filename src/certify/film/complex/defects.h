/* defects.h -- how far a film of many patches is from the equations of equilibrium: of the continuous film all are 0.
 *
 * At the middles of equal parts of the parameters of each patch, seam and line, so that the ends of lines, where there may be no
 * normal, are not among them.
 */
#ifndef TAUT_CERTIFY_FILM_COMPLEX_DEFECTS_H
#define TAUT_CERTIFY_FILM_COMPLEX_DEFECTS_H

#include "certify/film/complex/sheets.h"

typedef struct taut_complex_defects {
    double mean; /* |2 H + p / s| size */
    double
        seam; /* |sum s_i nu_i - T c''| / the largest s_i of the seam; threads: what they pull with in place of s nu */
    double slide; /* |nu - (nu . N) N| */
    double
        geodesic; /* of cable edges |k_g T / s - 1|; in a plane |T c'' - s (nu - (nu . N) N)| / s */
    /* beside threads |T c'' - p| over the largest |p| of the edge, p what they pull with, and no normal */
    double normal; /* |k_n| T / s, of those in no plane */
} taut_complex_defects;

taut_complex_defects taut_complex_defects_of(const taut_sheets *sheets);
/* What patches of threads reach, per width: [[least, most] along u, along v]. */
void taut_complex_stress(const taut_sheets *sheets, double range[2][2]);

/* forces[nodes][3]: what the cables that end in a node pull it with, in the user's unit. */
void taut_complex_pulls(const taut_sheets *sheets, double *forces);
/* What holds the film draws its edges and cables with, and the pressures in it: |sum of these forces| over the sum of their sizes;
 * of what moves in planes and along lines only the part that these take. 0 where all is in balance. */
double taut_complex_balance(const taut_sheets *sheets);
/* The largest distance of a cable from its chord over the chord; 0 where it closes. */
double taut_complex_sag(const taut_sheets *sheets, int rope);

/* 4 patch + corner: a held corner in which a cable passes another edge that ends there, as certify/film/lines.h has it, or -1. */
int taut_complex_passed(const taut_sheets *sheets);

#endif /* TAUT_CERTIFY_FILM_COMPLEX_DEFECTS_H */
