/* taut/dirichlet.h -- the surface of least Dirichlet energy through the known points of a net.
 *
 *     D(x) = 1/2 iint |x_u|^2 + |x_v|^2 du dv   (an upper bound of the area, equal where the
 *                                                parameters are isothermal)
 *
 * Given some points of a control net (in the source's case its four boundary rows), the others are
 * found such that D is least: one linear system, symmetric and positive definite as soon as one
 * point is known. Source: [WuWang2011] sections 2 to 3, 7.3, 7.5, 7.6.
 */
#ifndef TAUT_DIRICHLET_H
#define TAUT_DIRICHLET_H

#include "taut/construct.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A point that the surface passes through: S(u, v) = point, with u and v in their ranges, or both
 * NaN: those of the nearest point of the surface that passes through none. */
typedef struct taut_through {
    double u, v;
    double point[3];
} taut_through;

enum { TAUT_THROUGH_MAX = 1000 }; /* points to pass through, at most */

typedef struct taut_dirichlet_problem {
    const char *name;    /* of the surface; NULL: "dirichlet" */
    const taut_basis *u; /* any basis but ce-bezier */
    const taut_basis *v;
    const double *points;       /* double[nu][nv][3]; unknown points are not read */
    const unsigned char *known; /* [nu][nv]: nonzero where the point is given */
    const double *weights;      /* double[nu][nv], positive, or NULL */
    double aspect;              /* lambda of D_lambda = 1/2 iint lambda |x_u|^2 + |x_v|^2 / lambda;
                                 * 0 means 1 */
    int aspect_auto;            /* nonzero: minimise over lambda as well (section 7.3) */
    int regular; /* nonzero: the certificate claims `regular`: x_u and x_v nowhere parallel or 0 */
    const taut_through *through; /* taut_through[through_count], or NULL; not with aspect_auto */
    int through_count;           /* 0..TAUT_THROUGH_MAX */
} taut_dirichlet_problem;

/* What may be wrong with a problem that is well formed: the word in error->reason, its meaning, a
 * remedy. Numbers out of range and members at odds have the words of documents (taut/read.h). */
#define TAUT_DIRICHLET_REASON_LIST(X)                                                              \
    X("basis", "a basis of type \"ce-bezier\" is for curves", "take any other type")               \
    X("nothing-known", "no point of the net is known", "give at least one point")                  \
    X("through", "a point to pass through contradicts known points, or another such point",        \
      "move the one that the message names, or leave it out")                                      \
    X("no-best-aspect", "the energy keeps falling as the aspect goes to 0 or to infinity",         \
      "give the aspect as a number")                                                               \
    X("overflow", "a point of the solution is beyond the range of double precision",               \
      "scale the points down")                                                                     \
    X("ill-conditioned", "the knots, the degree or the weights are too extreme for doubles",       \
      "lower the degree, or even out knots and weights")                                           \
    X("undetermined", "the known points hardly determine the others",                              \
      "lower the degree, or bring the weights nearer to each other")                               \
    X("weights-vary", "the weights vary so much that the integrals take too many Gauss nodes",     \
      "bring the weights nearer to each other")

/* Makes the model with its one surface. details: unknowns; known ("boundary", "all" or "pattern");
 * method ("none", "fast-diagonalisation" or "conjugate-gradients"); iterations; and, if an aspect
 * was given or searched for, aspect and aspect_energy, the D_lambda that was minimised; of points to
 * pass through a list, u and v of each. Errors as
 * taut_make; a net with no known point is TAUT_NO_SOLUTION, and so is the search for an aspect when
 * the surface is a curve. Known points come out bit for bit. Cost and accuracy: docs/dirichlet.md.
 */
TAUT_API taut_status taut_dirichlet_make(const taut_dirichlet_problem *problem,
                                         const taut_make_options *options, taut_model **model,
                                         taut_error *error);

/* The certificate. Claims: `stationary` (where points are passed through: but for what holds the
 * surface there), with a problem `known` and `through`, after a search `aspect`, where the
 * problem asks `regular`; figures dirichlet_energy (aspect 1), area, isothermality and, with an
 * aspect, aspect_energy, with `regular` regular_bound. problem
 * NULL: judged from the model's details where they say that the boundary or all points were known,
 * else TAUT_BAD_INPUT. The limits are formulas of docs/dirichlet.md. */
TAUT_API taut_status taut_dirichlet_certify(const taut_model *model,
                                            const taut_dirichlet_problem *problem,
                                            const taut_certify_options *options,
                                            taut_certificate **certificate, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_DIRICHLET_H */
