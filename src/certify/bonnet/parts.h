/* parts.h -- the parts of the certificate of `bonnet`. A residual comes with its noise: what
 * rounding each control point, each basis function and each term of the sums once explains of it.
 */
#ifndef TAUT_CERTIFY_BONNET_PARTS_H
#define TAUT_CERTIFY_BONNET_PARTS_H

#include "certify/bonnet/sums.h"
#include "taut/bonnet.h"

#include <stdint.h>

typedef struct taut_bonnet_finding {
    double residual, noise;
    double at[2]; /* u, v of the residual */
} taut_bonnet_finding;

/* Raises `largest` to a value, which is 1e30 at most and never NaN, and to its noise. */
void taut_bonnet_raise(taut_bonnet_finding *largest, double residual, double noise, double u,
                       double v);

/* The algebraic test, span by span; 0 where the bases are not those it is made for. */
int taut_bonnet_algebra(const taut_surface *surface, const taut_bonnet_scale *scale,
                        taut_bonnet_finding *found);

/* Do its coefficients show that a surface about 1 in size is minimal, and its spans one surface? 0 where
 * rounding hides it. */
int taut_bonnet_is_algebraic(const taut_surface *surface);

/* One surface of the problem. */
typedef struct taut_bonnet_frame {
    const taut_bonnet_problem *problem;
    double lambda;
} taut_bonnet_frame;

/* A number that the distance of the surface from the formula, at the same parameters, exceeds
 * nowhere, over the largest coordinate. */
void taut_bonnet_against_formula(const taut_surface *surface, const taut_bonnet_scale *scale,
                                 const taut_bonnet_frame *frame, taut_bonnet_finding *found);
/* Area and total curvature in closed form, with the relative rounding of each. */
void taut_bonnet_closed_area(const taut_bonnet_frame *frame, double *area, double *noise);
void taut_bonnet_closed_curvature(const taut_bonnet_frame *frame, double *total, double *noise);

/* iint dA and iint K dA by quadrature, to 1e-13 relative or to what rounding leaves, with the
 * relative noise of each, after `most` cuts at the latest. TAUT_NO_MEMORY. */
typedef struct taut_bonnet_integrals {
    double value[2], noise[2];
} taut_bonnet_integrals;
taut_status taut_bonnet_integrate(const taut_surface *surface, const taut_bonnet_scale *scale,
                                  taut_arena *arena, int64_t most,
                                  taut_bonnet_integrals *integrals);

#endif /* TAUT_CERTIFY_BONNET_PARTS_H */
