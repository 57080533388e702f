/* taut/plateau.h -- the surface of least area through the known points of a net.
 *
 *     A(x) = iint |x_u x x_v| du dv
 *
 * over the spline space of a net with unknown points: the net of taut/dirichlet.h, the true area in
 * place of its bound. Newton steps, made safe by the metric iteration ([WuWang2011] sections
 * 6, 7.1, 7.2; docs/plateau.md).
 */
#ifndef TAUT_PLATEAU_H
#define TAUT_PLATEAU_H

#include "taut/curve.h"
#include "taut/dirichlet.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum taut_plateau_method {
    TAUT_PLATEAU_FULL = 0, /* the minimum over the whole spline space */
    TAUT_PLATEAU_NORMAL,   /* each point moves along the unit normal of the Dirichlet surface at its
                            * Greville point: a little above the minimum on coarse nets, and as close
                            * as the net allows on fine ones */
    TAUT_PLATEAU_EITHER /* the first; where that finds none, the second: details.method, with a warning */
} taut_plateau_method;

/* The most that `refine` may be, and the most control points of the last net it leads to. */
enum { TAUT_PLATEAU_REFINE_MAX = 6 };
enum { TAUT_PLATEAU_REFINED_MAX = 1000000 };
#define TAUT_PLATEAU_AREA_MIN 1e-11 /* of tolerance_area */
/* Control points of a net that tolerance_area puts knots into. */
enum { TAUT_PLATEAU_ADAPTED_MAX = 2500 };
#define TAUT_PLATEAU_GAP_MIN 1e-12 /* below gap */
/* Control points of a film that is proved to be near the least. */
enum { TAUT_PLATEAU_LEAST_MAX = 10000 };

/* Zero means default everywhere. */
typedef struct taut_plateau_problem {
    taut_dirichlet_problem net;  /* as for dirichlet; name NULL: "plateau". net.through: with
                                  * TAUT_PLATEAU_NORMAL ("full" folds around a point inside), and
                                  * none of refine, tolerance_area, gap; nearest points are those of
                                  * the film that passes through none */
    const taut_curve *curves[4]; /* u0, u1 along v; v0, v1 along u; all NULL: none. Given, they are
                                  * fitted to the bases of the net and are its boundary: points and
                                  * known are not read, weights must be NULL */
    const double *start;         /* double[nu][nv][3] to begin from, its known points those of the
                                  * net; NULL: the Dirichlet surface */
    double tolerance;            /* of the claim `stationary`, below 1; 0: 1e-10 */
    int max_iterations;          /* 0: 500 */
    taut_plateau_method method;
    int refine;            /* 0..TAUT_PLATEAU_REFINE_MAX: estimate the distance from the least area
                            * of all surfaces with this boundary, from so many spaces with halved
                            * spans; only where the boundary is known and nothing else */
    double tolerance_area; /* above 0: put knots in, until that estimate is within so much of the
                            * area; from TAUT_PLATEAU_AREA_MIN on and below 1, without refine and
                            * start */
    int without_least;     /* nonzero: no witness for the claim `least` is looked for */
    double gap;            /* above 0: put knots in, until the area is proved to be within so much
                            * of itself from the least of all (docs/least.md); above
                            * TAUT_PLATEAU_GAP_MIN and below 1, with none of refine, start,
                            * tolerance_area and without_least */
} taut_plateau_problem;

/* What may be wrong with a problem that is well formed: the word in error->reason, its meaning, a
 * remedy. The words of TAUT_DIRICHLET_REASON_LIST come besides, from the surface it starts with,
 * and from its own solve those repeated here. */
#define TAUT_PLATEAU_REASON_LIST(X)                                                                \
    X("basis", "a basis of type \"ce-bezier\" is for curves", "take any other type")               \
    X("corners", "two curves do not meet where they should",                                       \
      "let u0 and u1 run with v, v0 and v1 with u, from corner to corner")                         \
    X("unclamped", "the edges of a surface on this basis do not end in its outermost points",      \
      "take a bezier, c-bezier, h-bezier or bspline basis")                                        \
    X("curve-fit", "a curve cannot be fitted to the basis of its edge",                            \
      "lower the degree, or even out the knots")                                                   \
    X("no-area", "the known points span no area", "give a boundary that is not a point or a line") \
    X("free-edge", "a free edge lets the surface shrink away, or keeps it from coming to rest",    \
      "make the points of that edge known")                                                        \
    X("folds", "the surface of least area folds in this space",                                    \
      "take fewer points, give points inside, or take the method \"normal\"")                      \
    X("slides", "the net still slides within the surface",                                         \
      "take the method \"normal\", or the tolerance that the message names")                       \
    X("saddle", "the area has a direction of negative curvature, but no step along it lowers it",  \
      "give another start")                                                                        \
    X("iterations", "max_iterations were made", "allow more, or raise the tolerance")              \
    X("work", "the work that is allowed was done", "take fewer points, or raise the tolerance")    \
    X("no-step", "no step lowers the area any more, and the residual is above the tolerance",      \
      "raise the tolerance, or take fewer points")                                                 \
    X("gauss-points", "the area asks for too many Gauss points",                                   \
      "even out the weights or the bases, or take more control points")                            \
    X("area-gap", "tolerance_area is not reached with as many points as there may be",             \
      "raise the degree, or tolerance_area")                                                       \
    X("gap", "the gap asked for is not reached with as many points as there may be",               \
      "raise the degree, or the gap")                                                              \
    X("not-convex", "no direction is found along which the film is a graph over a convex domain",  \
      "leave out the gap, or give a boundary that projects onto a convex curve")                   \
    X("overflow", "a point of the solution is beyond the range of double precision",               \
      "scale the points down")                                                                     \
    X("ill-conditioned", "the knots, the degree or the weights are too extreme for doubles",       \
      "lower the degree, or even out knots and weights")

/* Makes the model with its one surface; details: iterations, products, dirichlet_area, areas (one
 * an iteration), residual, tolerance, unknowns, known, method, solver; with TAUT_PLATEAU_NORMAL
 * also directions [nu][nv][3]; with points to pass through `through`, as of dirichlet, and where one
 * is inside a warning; with curves deviation; with refine, tolerance_area or gap refinement;
 * where a witness was found least (docs/least.md).
 * TAUT_BAD_INPUT: numbers out of range, error->where the member.
 * TAUT_NO_SOLUTION: the known points span no area, or a free edge lets the surface shrink away.
 * TAUT_NOT_CONVERGED: max_iterations, or a surface that folds. Others as taut_make. */
TAUT_API taut_status taut_plateau_make(const taut_plateau_problem *problem,
                                       const taut_make_options *options, taut_model **model,
                                       taut_error *error);

/* The certificate: claims `stationary`, `least` and, with a problem, `known` and `through`, where net.regular asks
 * `regular`; figures area, mean_abs_mean_curvature, max_abs_mean_curvature, of `least` lower_bound,
 * gap, direction, of `regular` regular_bound. */
TAUT_API taut_status taut_plateau_certify(const taut_model *model,
                                          const taut_plateau_problem *problem,
                                          const taut_certify_options *options,
                                          taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_PLATEAU_H */
