/* taut/gradient.h -- how a number of a surface changes with the points that it was made from.
 *
 *     F(P) a number of the finished control points P, k the points that were given:
 *     dF/dk = F_k + sum F_p dp/dk,    p the points that were found, whose equations R(p, k) = 0 say
 *     dF/dk = F_k - R_k^T l,          R_p^T l = F_p
 *
 * One solve, however many points are given: the adjoint ([GriewankWalther2008] ch. 3, 15; docs/gradient.md).
 */
#ifndef TAUT_GRADIENT_H
#define TAUT_GRADIENT_H

#include "taut/film.h"
#include "taut/plateau.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The number that is derived. */
typedef enum taut_gradient_of {
    TAUT_GRADIENT_AREA = 0,
    TAUT_GRADIENT_DIRICHLET_ENERGY, /* 1/2 iint |x_u|^2 + |x_v|^2, aspect 1 */
    TAUT_GRADIENT_POINTS            /* sum factors . points: any other, by its derivatives */
} taut_gradient_of;

/* Zero means default everywhere. */
typedef struct taut_gradient_request {
    taut_gradient_of of;
    const double *factors; /* double[nu][nv][3], finite, for TAUT_GRADIENT_POINTS: derivatives of
                            * the number by the control points of the surface; else NULL */
    taut_monitor monitor;
} taut_gradient_request;

/* Reasons: word, meaning, remedy. */
#define TAUT_GRADIENT_REASON_LIST(X)                                                               \
    X("no-gradient", "there is no derivative of this, or none is known here",                      \
      "see docs/gradient.md for what has one")                                                     \
    X("other-model", "the surface is not the one of this problem", "give the model made from it")  \
    X("not-at-rest", "the surface is not where its area is least, so its equations say nothing",   \
      "make it to a smaller tolerance")                                                            \
    X("rough", "no quadrature agrees on the derivatives of the area",                              \
      "even out the weights, or give points that have a tangent plane")                            \
    X("saddle", "the second derivative of the area is not positive",                               \
      "take fewer points, or give points inside")

/* gradient double[nu][nv][3] of the problem's net: the derivative by each coordinate of each known
 * point, 0 at the others; written whole on success, else untouched. model: what the problem was made
 * into. request NULL: the area's.
 *
 * dirichlet     every number; exact to the rounding of its solve
 * plateau       method "normal": every number; "full": the area alone, since what else depends on
 *               where the points lie within the surface is not determined; as good as the surface is at rest
 *
 * TAUT_BAD_ARGUMENT: no-gradient, other-model, NULL; TAUT_NO_SOLUTION: not-at-rest, saddle;
 * TAUT_NOT_CONVERGED: rough; others as the call that makes the surface. */
TAUT_API taut_status taut_dirichlet_gradient(const taut_dirichlet_problem *problem,
                                             const taut_model *model,
                                             const taut_gradient_request *request, double *gradient,
                                             taut_error *error);
TAUT_API taut_status taut_plateau_gradient(const taut_plateau_problem *problem,
                                           const taut_model *model,
                                           const taut_gradient_request *request, double *gradient,
                                           taut_error *error);

/* The same of a problem that was read; films have their own below. Besides these two, harmonic (two rows, or four that are fitted)
 * and biharmonic (four rows), whose points are linear in what is given; a make for each three points
 * given. TAUT_BAD_ARGUMENT, no-gradient: other constructions, and what is given otherwise. */
TAUT_API taut_status taut_gradient(const taut_problem *problem, const taut_model *model,
                                   const taut_gradient_request *request, double *gradient,
                                   taut_error *error);

/* The number of a film that is derived, as its certificate has it; a reaction there is what cables pull
 * along their tangents, which this one comes to as the net gets finer. */
typedef enum taut_film_gradient_of {
    TAUT_FILM_GRADIENT_ENERGY = 0,
    TAUT_FILM_GRADIENT_AREA,
    TAUT_FILM_GRADIENT_LENGTH,  /* of the cable `edge` */
    TAUT_FILM_GRADIENT_TENSION, /* of the cable `edge` */
    TAUT_FILM_GRADIENT_REACTION /* along `axis`, at the held corner `corner`: -dE/d(corner alone) */
} taut_film_gradient_of;

/* Zero means default everywhere. */
typedef struct taut_film_gradient_request {
    taut_film_gradient_of of;
    int edge;   /* 0 to 3: u0, u1, v0, v1 */
    int corner; /* 0 to 3: u0v0, u1v0, u0v1, u1v1 */
    int axis;   /* 0 to 2: x, y, z */
    taut_monitor monitor;
} taut_film_gradient_request;

/* Derivatives by what a film was made from; 0 where the problem has nothing of the kind. */
typedef struct taut_film_slopes {
    double corners[4][3]; /* held corners that are given; straight held edges go with them */
    double laws[4];       /* given of each cable: force, length, sag or unstressed length */
    double stiffness[4];  /* of elastic cables */
    double *points; /* double[nu][nv][3] of the caller's, or NULL: each held point of the net alone,
                     * as those of an edge on a curve, the others 0; of a ring for moves that keep its edges closed */
} taut_film_slopes;

/* *slopes, written whole on success, else untouched. A film of one patch, open or a ring, of the method "full",
 * without updates of a reference; request NULL: the energy. The energy does not change with what was found,
 * so nothing is solved for it; for all else one system with the second derivative of the energy in all
 * coordinates of the net is, and lengths and laws of cables ([GriewankWalther2008] ch. 15; docs/gradient.md).
 * TAUT_BAD_ARGUMENT: no-gradient, other-model, argument; TAUT_NO_SOLUTION: not-at-rest, saddle;
 * TAUT_NOT_CONVERGED: rough; TAUT_INTERRUPTED; TAUT_NO_MEMORY. */
TAUT_API taut_status taut_film_gradient(const taut_film_problem *problem, const taut_model *model,
                                        const taut_film_gradient_request *request,
                                        taut_film_slopes *slopes, taut_error *error);
/* The same of a problem that was read. TAUT_BAD_ARGUMENT, no-gradient: it is no film. */
TAUT_API taut_status taut_gradient_of_film(const taut_problem *problem, const taut_model *model,
                                           const taut_film_gradient_request *request,
                                           taut_film_slopes *slopes, taut_error *error);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_GRADIENT_H */
