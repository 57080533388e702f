/* local.h -- a piece of a net on c-, h- or cubic bases, as coefficients about its middle.
 *
 * The functions of such a basis satisfy N'''' = s N'' on a span (s = -1 on c-, 1 on h-, 0 on cubic
 * bases), so that four derivatives at one point say all:
 *
 *     N(t + tau) = N + N' tau + N'' (cosh(q tau) - 1) / s + N''' (sinh(q tau)/q - tau) / s,  q^2 = s
 *
 * and a surface is  r = sum_de x[d][e] phi_d(tau) psi_e(eta)  on the whole piece, with x[d][e] its
 * derivatives in the middle: exact, and as well conditioned on a segment of 1e-5 as on one of 3.
 * Parameters are told in units of L, a power of two about half the piece, so that s is s L^2.
 */
#ifndef TAUT_CERTIFY_BONNET_LOCAL_H
#define TAUT_CERTIFY_BONNET_LOCAL_H

#include "certify/bonnet/sums.h"

/* Which piece: spans of both bases, middle and half widths. */
typedef struct taut_bonnet_piece {
    int span[2];
    double middle[2], half[2];
} taut_bonnet_piece;

typedef struct taut_bonnet_local {
    double x[4][4][3];   /* times L^(d+e) 2^-unit; x[0][0] less the origin */
    double own[4][4];    /* what rounding in this calculation leaves of a coordinate of x */
    double points[4][4]; /* what rounding in the stored points explains of it */
    double origin[3];    /* a point near the middle, times 2^-unit */
    double s[2];         /* of both directions, times L^2 */
    double bound[2][4];  /* |phi_d|, |psi_e| on the piece are at most these, */
    double slope[2][4];  /* and their derivatives these */
    double unit_length;  /* L */
} taut_bonnet_local;

/* s of a direction into *sign; 0 where its functions are no such ones. */
int taut_bonnet_sign_of(const taut_basis *basis, double *sign);

/* How a surface is cut into pieces to begin with: count[d] of them along, in equal parts of each
 * span, at most 1/2 wide on c- and h- bases. */
typedef struct taut_bonnet_cuts {
    int each[2]; /* of one span */
    int count[2];
} taut_bonnet_cuts;

taut_bonnet_cuts taut_bonnet_cuts_of(const taut_surface *surface);
taut_bonnet_piece taut_bonnet_piece_at(const taut_surface *surface, const taut_bonnet_cuts *cuts,
                                       int i, int j);

/* The coefficients of a piece, points times 2^-unit. Both directions have a sign. */
void taut_bonnet_local_of(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                          const taut_bonnet_piece *piece, taut_bonnet_local *local);

#endif /* TAUT_CERTIFY_BONNET_LOCAL_H */
