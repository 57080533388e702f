/* circulation.h -- int B dt - psi dz along an edge over a convex quadrilateral, with a bound of its error.
 *
 *     r(s, t) = q0 + s e + t f + s t g,    (x, y)(tau) = r(s, t)
 *
 * s and t are algebraic along the edge, and may bend as sharply as they like where the Jacobian J = r_s x r_t is small, so
 * that two rules that agree prove nothing. On a piece of the edge, tau in [-1, 1], x = sum_j a_j tau^j, and on the ellipse of
 * foci -1, 1 and half axes that add up to rho
 *
 *     |x(tau) - x(0)| <= D = sum_(j>0) |a_j| ((rho + 1 / rho) / 2)^j.
 *
 * With alpha no less than the norm of (r_s r_t)^-1 at the middle, (s, t) is analytic where 4 alpha^2 |g| D <= 1 / 2, within
 * R = 2 alpha D of its value there (contraction),
 * |J| >= |J(0)| / 2, and a polynomial of Bernstein coefficients b_ij is at most max |b_ij| (1 + 2 R)^(m + n). A Gauss rule of
 * n nodes misses at most 64 M rho^(2 - 2 n) / (15 (1 - rho^-2)) where |f| <= M ([Trefethen2008] theorem 4.5). Pieces are
 * halved until that is as small as rounding.
 */
#ifndef TAUT_CERTIFY_FILM_CIRCULATION_H
#define TAUT_CERTIFY_FILM_CIRCULATION_H

#include "certify/common/field.h"

/* The quadrilateral in the plane of the first two coordinates, as it runs round, and the fields over it. */
typedef struct taut_film_flow {
    const double (*corners)[2];
    const taut_field *b, *psi; /* of degree 1 at least */
} taut_film_flow;

/* What is added up, and the most that may be wrong with it. */
typedef struct taut_film_total {
    double sum, off;
} taut_film_total;

/* (s, t) of a place in the quadrilateral; returns how far off they may be, infinity where that is not known. */
double taut_film_locate(const taut_film_flow *flow, const double at[2], double st[2]);

/* A field at such a place: *value, and returns how far off it may be. */
double taut_film_flow_value(const taut_field *f, const double st[2], double off, double *value);

/* Adds sign times the integral over a piece with Bernstein coefficients double[degree + 1][3] of x, y, z; *pieces: how many
 * more may be looked at. total->off is infinite where they do not do. TAUT_NO_MEMORY. */
taut_status taut_film_circulate(const taut_film_flow *flow, int degree, const double *piece,
                                double sign, int *pieces, taut_film_total *total);

#endif /* TAUT_CERTIFY_FILM_CIRCULATION_H */
