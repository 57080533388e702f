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
} taut_dirichlet_problem;

/* Makes the model with its one surface. details: unknowns; known ("boundary", "all" or "pattern");
 * method ("none", "fast-diagonalisation" or "conjugate-gradients"); iterations; and, if an aspect
 * was given or searched for, aspect and aspect_energy, the D_lambda that was minimised. Errors as
 * taut_make; a net with no known point is TAUT_NO_SOLUTION, and so is the search for an aspect when
 * the surface is a curve. Known points come out bit for bit. Cost and accuracy: docs/dirichlet.md.
 */
TAUT_API taut_status taut_dirichlet_make(const taut_dirichlet_problem *problem,
                                         const taut_make_options *options, taut_model **model,
                                         taut_error *error);

/* The certificate. Claims: `stationary`, with a problem `known`, after a search `aspect`; figures
 * dirichlet_energy (aspect 1), area, isothermality and, with an aspect, aspect_energy. problem
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
