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
#include "construct/common/through.h"
#include "construct/plateau/area.h"
#include "numeric/band.h"

typedef struct taut_area_hessian taut_area_hessian;

/* Is a factorisation worth its cost for this functional? */
int taut_area_hessian_pays(const taut_area_functional *functional, const taut_mask *mask);

/* About so many flops: one assembly, and one factorisation. */
double taut_area_hessian_assembly_cost(const taut_area_functional *functional);
double taut_area_hessian_factor_cost(const taut_area_functional *functional, const taut_mask *mask);

/* Numbers the unknown points so that the band is narrow, index int[nu][nv], -1 at known ones; returns how many. *width: the
 * largest distance of two that meet. */
int taut_area_number(const taut_area_functional *functional, const taut_mask *mask, int *index,
                     int *width);

/* The mask is borrowed. TAUT_NO_MEMORY. */
taut_status taut_area_hessian_new(const taut_area_functional *functional, const taut_mask *mask,
                                  taut_area_hessian **hessian);
void taut_area_hessian_free(taut_area_hessian *hessian); /* NULL is fine */

/* Fills both matrices from the state of the functional: once for each net. Its pulse is told of that and of factors,
 * which are TAUT_INTERRUPTED once it is to end. */
void taut_area_hessian_assemble(taut_area_hessian *hessian, const taut_area_functional *functional);

/* Stiffens every unknown point against moves other than those given: adds weight (I - P) to its
 * block of H, P the projector of its directions, double[nu][nv][3][3], unit and orthogonal, 0 where there
 * are fewer. The steps of factor 0 are then along them, to 1 / weight. */
void taut_area_hessian_stiffen(taut_area_hessian *hessian, const double *directions, double weight);

/* Stiffens the surface against leaving places: adds c c^T of each condition to H, by the weight that makes it a hundred times as
 * stiff there as the metric. Moves that leave them alone do not feel it. */
void taut_area_hessian_hold(taut_area_hessian *hessian, const taut_conditions *conditions);

/* Factors B = (1 - theta) H + theta L_g over the unknown points. TAUT_NO_SOLUTION when B is not
 * positive definite: there are no factors then. */
taut_status taut_area_hessian_factor(taut_area_hessian *hessian, double theta);

/* Had B no eigenvalue below 0 even without what cables store, at the last factors? */
int taut_area_hessian_is_definite(const taut_area_hessian *hessian);

/* The same for B of any signs; *negative of its eigenvalues are below 0, what cables store counted in; of cables with rigid[k]
 * (NULL: none) where their length does not change. TAUT_NO_SOLUTION: B is not safely regular. */
taut_status taut_area_hessian_factor_any(taut_area_hessian *hessian, double theta,
                                         const unsigned char *rigid, int *negative);

/* Solves B x = x in place with the factors of last, net double[nu][nv][3]; known points become
 * 0. */
void taut_area_hessian_solve(taut_area_hessian *hessian, double *net);

#endif /* TAUT_CONSTRUCT_PLATEAU_HESSIAN_BAND_H */
