/* lines.h -- what the edges of a film do: its cables' bends, and the forces on what holds it.
 *
 *     T c'' = s nu      along a cable, nu the conormal of the film pointing outwards
 *     k_g = c'' . nu,  k_n = c'' . n     so that k_g T / s = 1, k_n = 0 where the film is at rest
 */
#ifndef TAUT_CERTIFY_FILM_LINES_H
#define TAUT_CERTIFY_FILM_LINES_H

#include "certify/film/sheet.h"

/* Largest over places of a uniform grid on every cable and slide, its ends too. */
typedef struct taut_film_defects {
    double
        geodesic; /* |k_g T / s - 1|; of a cable in a plane of normal N |T c'' - s (nu - (nu.N) N)| / s */
    double normal; /* |k_n| T / s; of cables in planes none */
    double slide;  /* |nu - (nu.N) N| */
} taut_film_defects;

taut_film_defects taut_film_defects_of(const taut_film_sheet *sheet);

/* Least and most of alpha |x_u| / |x_v| and of beta |x_v| / |x_u|, in the user's unit, over places of the same grid on the film. */
void taut_film_stress(const taut_film_sheet *sheet, double range[2][2]);

/* The largest distance of cable e from its chord over the chord, at places of the same grid. */
double taut_film_sag(const taut_film_sheet *sheet, int e);

/* forces[c]: what the cables that end in corner c pull it with, in the user's unit; has[c]: is it
 * the end of one, and held? *balance: |sum of these, of s nu over the held edges and of what planes take of it| over the
 * sum of their sizes, 0 where all is in balance. */
void taut_film_reactions(const taut_film_sheet *sheet, double forces[4][3], unsigned char has[4],
                         double *balance);

/* The corner, or -1, in which a cable passes another edge, as they leave it by what draws them,
 *
 *     c_s(0) = int c_s dt - s / T int (1 - t) nu ds,  c_s(1) = int c_s dt + s / T int t nu ds,  t from 0 to 1,
 *
 * nu in planes what lies in them: nearer to the continuous film's than the net's own tangents. */
int taut_film_passed_at(const taut_film_sheet *sheet);

#endif /* TAUT_CERTIFY_FILM_LINES_H */
