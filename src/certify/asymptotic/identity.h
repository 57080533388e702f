/* identity.h -- the normal curvature of a rational Bezier surface along one edge, as
 * polynomials.
 *
 * With homogeneous coordinates S = (W R, W), t along the edge and c across,
 *     k_n = W^3 D / (|M| |P|^2),
 *     D = det(S, S_t, S_tt, S_c),   P = W S_t - W_t S = W^2 R_t,   M = W^3 R_t x R_c.
 * The edge is asymptotic if and only if D is the zero polynomial. Its Bernstein coefficients bound
 * it between the ends, so that a number is proved for every t and not for samples. The curvature and
 * the sine between N and the binormal b are
 *     k = W^3 |Q| / |P|^3,    sin = |k_n| / k = |D| |P| / (|M| |Q|),    Q = W^3 R_t x R_tt,
 * as k_n is k times the cosine between N and the principal normal.
 */
#ifndef TAUT_CERTIFY_ASYMPTOTIC_IDENTITY_H
#define TAUT_CERTIFY_ASYMPTOTIC_IDENTITY_H

#include "core/arena.h"
#include "taut/surface.h"

#include <stdint.h>

/* Bernstein coefficients on [0, 1]. */
typedef struct taut_identity {
    int degree[5]; /* of D, M, P, W, Q */
    double *d;     /* [degree + 1] */
    double *m;     /* [degree + 1][3] */
    double *p;     /* [degree + 1][3] */
    double *w;     /* [degree + 1] */
    double *q;     /* [degree + 1][3] */
} taut_identity;

/* For edge 0..3 (v0, u0, v1, u1) of a surface on bezier bases. Computed in twice the working
 * precision and rounded once. TAUT_NO_MEMORY. */
taut_status taut_identity_fill(const taut_surface *surface, int edge, taut_arena *arena,
                               taut_identity *identity);

/* k_n at t; infinite where the surface is singular. */
double taut_identity_at(const taut_identity *identity, double t);

/* How the edge is cut up for a bound. */
typedef struct taut_bounding {
    int levels;     /* into 2^levels pieces */
    int more;       /* and these up to so many times further, ... */
    double target;  /* ... where the bound is above this or not finite */
    double regular; /* share of the largest |M| below which an edge that is singular is left out */
    double sine;    /* as target, for the sine */
    double bent;    /* curvature that a piece must reach for the sine to count */
} taut_bounding;

/* A number that |k_n| does not exceed anywhere on the edge, from the coefficients on its pieces. An
 * edge with pieces on which the denominator cannot be told from 0 is singular: the number then
 * holds on the share *covered of it, where |M| is at least `regular` of its largest; else *covered
 * is 1. *sine: the same for the sine between N and b, where the curvature reaches `bent`; 0 where it
 * nowhere does. scratch: double[levels + more + 1][taut_identity_size(identity)]. */
double taut_identity_bound(const taut_identity *identity, const taut_bounding *bounding,
                           double *scratch, double *covered, double *sine);
int64_t taut_identity_size(const taut_identity *identity);

#endif /* TAUT_CERTIFY_ASYMPTOTIC_IDENTITY_H */
