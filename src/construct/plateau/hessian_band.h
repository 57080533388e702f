/* hessian_band.h -- the Hessian of the area as a banded matrix, and steps by factors of it.
 *
 * At one Gauss point two basis functions p and q meet in the 3 x 3 block (construct/plateau/area.h)
 *
 *     H_pq = s n n^T + t [n]x,    s = w (G p_u q_u - F (p_u q_v + p_v q_u) + E p_v q_v) / W,
 *                                 t = w (p_v q_u - p_u q_v)
 *
 * and in L_g's block s I. Unknown points are numbered along the shorter side of the net, so the
 * band is about 3 (degree) (that side) wide.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_HESSIAN_BAND_H
#define TAUT_CONSTRUCT_PLATEAU_HESSIAN_BAND_H

#include "construct/common/mask.h"
#include "construct/plateau/area.h"
#include "numeric/band.h"

typedef struct taut_film_band taut_film_band;

/* Is a factorisation worth its cost for this film? */
int taut_film_band_pays(const taut_film *film, const taut_mask *mask);

/* About so many flops: one assembly, and one factorisation. */
double taut_film_band_assembly_cost(const taut_film *film);
double taut_film_band_factor_cost(const taut_film *film, const taut_mask *mask);

/* The mask is borrowed. TAUT_NO_MEMORY. */
taut_status taut_film_band_new(const taut_film *film, const taut_mask *mask, taut_film_band **band);
void taut_film_band_free(taut_film_band *band); /* NULL is fine */

/* Fills both matrices from the film's state: once for each net. */
void taut_film_band_assemble(taut_film_band *band, const taut_film *film);

/* Factors B = (1 - theta) H + theta L_g over the unknown points. TAUT_NO_SOLUTION when B is not
 * positive definite: there are no factors then. */
taut_status taut_film_band_factor(taut_film_band *band, double theta);

/* Solves B x = x in place with the factors of last, net double[nu][nv][3]; known points become
 * 0. */
void taut_film_band_solve(taut_film_band *band, double *net);

#endif /* TAUT_CONSTRUCT_PLATEAU_HESSIAN_BAND_H */
