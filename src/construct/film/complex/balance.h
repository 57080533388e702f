/* balance.h -- forces that cannot balance where they meet, told before anything is solved.
 *
 *     a seam     sum s_i nu_i = 0 of unit vectors nu_i: no tension is above the sum of the others
 *     a vertex   sum T_k t_k = 0 along the cables that end there: no force is above the sum of the others
 *     walls      sheets from parallel lines P_i to one line, between two planes across them that they slide on: with w_i =
 *                s_i (P_i - P_k) / |P_i - P_k| of all but k, and w_k = -sum w_i, fields w_i x e without divergence show that no such
 *                sheets have less energy than h sum s_i |P_i - P_k|, where |w_k| <= s_k; sheet k would have to be nothing
 */
#ifndef TAUT_CONSTRUCT_FILM_COMPLEX_BALANCE_H
#define TAUT_CONSTRUCT_FILM_COMPLEX_BALANCE_H

#include "construct/film/complex/layout.h"

/* TAUT_NO_SOLUTION: unbalanced. */
taut_status taut_film_balance_check(const taut_film_layout *layout, taut_error *error);

#endif /* TAUT_CONSTRUCT_FILM_COMPLEX_BALANCE_H */
