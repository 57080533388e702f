/* taut/bonnet.h -- minimal surfaces with planar curvature lines as exact control meshes.
 *
 *     r(u, v) = ((lambda u + s sin u cosh v) / w, (v + s lambda cos u sinh v) / w, s cos u cosh v),
 *     s = +1 or -1, w = sqrt(1 - lambda^2), 0 <= lambda < 1
 *
 * from the catenoid (lambda = 0) towards Enneper's surface, on c- and h- bases, which hold it
 * exactly. The associate family turns it into r cos(theta) + r* sin(theta), r* the adjoint surface:
 * all minimal, all isometric. The normalised family 2 (r(w p, w q) - r(0, 0)) / w^2, s = -1, stays
 * bounded and ends in Enneper's surface itself at lambda = 1. Source: [XuWang2006] sections 1 to 5,
 * 8, 9.
 */
#ifndef TAUT_BONNET_H
#define TAUT_BONNET_H

#include "taut/construct.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_bonnet_problem {
    double lambda[2]; /* both the same for one surface; first and last of `frames` */
    int frames;       /* 0 or 1: one surface; more: so many, in equal steps, ends included */
    int sign;         /* +1 or -1 */
    double alpha;     /* > 0: length of a segment in u; at most pi, bspline: less than pi */
    double beta;      /* > 0: length of a segment in v */
    int bspline; /* nonzero: the quasi-B-spline mesh of `segments`; else quasi-Bezier, one segment
                  */
    int segments[2]; /* >= 1; 0 means 1 */
    double theta;    /* of the associate family */
    int normalize;   /* nonzero: the normalised family; alpha, beta, start are lengths in p and q */
    double start[2]; /* where the window begins */
} taut_bonnet_problem;

/* Reasons: word, meaning, remedy. */
#define TAUT_BONNET_REASON_LIST(X)                                                                 \
    X("lambda", "lambda is outside the range in which the surface exists",                         \
      "take 0 <= lambda < 1, or 1 with \"normalize\": true")                                       \
    X("segment-length", "a segment in u is too long for its basis",                                \
      "use \"mesh\": \"bspline\" with more segments, or make it of two windows")                   \
    X("far-window", "the window lies so far out that curvatures overflow or digits are lost",      \
      "begin nearer to 0, or end earlier")

/* Makes the model: surface "bonnet", or frame-0, frame-1, ... details: lambda (a list for frames),
 * amplitude (of the quasi-B-spline net: alpha / sin alpha; 1 for bezier). TAUT_NO_SOLUTION: lambda
 * outside [0, 1) (1 is fine when normalised), a c-bspline of alpha >= pi, a window so far out that
 * curvatures overflow; TAUT_BAD_INPUT: any other member outside its range. */
TAUT_API taut_status taut_bonnet_make(const taut_bonnet_problem *problem,
                                      const taut_make_options *options, taut_model **model,
                                      taut_error *error);

/* The certificate, over all surfaces of the model: claims isothermal, harmonic, minimal, smooth,
 * algebraic and, with the problem (NULL: only the model), formula, closed-form; figures area,
 * total_gaussian_curvature, lists for several surfaces. TAUT_BAD_INPUT: not that many surfaces, or
 * weights. docs/bonnet.md says what each claim is held against. */
TAUT_API taut_status taut_bonnet_certify(const taut_model *model,
                                         const taut_bonnet_problem *problem,
                                         const taut_certify_options *options,
                                         taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_BONNET_H */
