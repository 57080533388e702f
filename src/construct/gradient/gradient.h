/* gradient.h -- what the derivatives of all constructions share. */
#ifndef TAUT_CONSTRUCT_GRADIENT_GRADIENT_H
#define TAUT_CONSTRUCT_GRADIENT_GRADIENT_H

#include "core/arena.h"
#include "taut/gradient.h"

/* The net that a derivative is by. */
typedef struct taut_gradient_net {
    const taut_basis *u, *v;
    const double *points;       /* double[nu][nv][3] */
    const unsigned char *known; /* [nu][nv] */
    int is_near;                /* nonzero: the surface need not go through the known points */
} taut_gradient_net;

/* Work on the derivative by a net: `seed` double[nu][nv][3] comes as dF/dP at every control point,
 * and goes as the gradient, 0 at unknown points. */
typedef taut_status taut_gradient_pull(const void *context, const taut_surface *surface,
                                       const taut_gradient_request *request, taut_arena *arena,
                                       double *seed, taut_error *error);

/* Checks the arguments, takes dF/dP of the model's surface, pulls it back and writes it out. */
taut_status taut_gradient_run(const taut_gradient_net *net, const taut_model *model,
                              const taut_gradient_request *request, taut_gradient_pull *pull,
                              const void *context, double *gradient, taut_error *error);

/* A request that has no answer here. */
taut_status taut_gradient_refuse(const char *why, taut_error *error);

/* seed = dF/dP at every control point, known or not (surface.c). */
taut_status taut_gradient_of_surface(const taut_surface *surface,
                                     const taut_gradient_request *request, taut_arena *arena,
                                     double *seed, taut_error *error);

/* Nodes on a span beyond those that a polynomial needs, of rules one after the other until two agree. */
enum { TAUT_GRADIENT_RULES = 11 };
extern const int taut_gradient_nodes[TAUT_GRADIENT_RULES];

/* Largest |a - b| over the largest |b|. */
double taut_gradient_change(size_t size, const double *a, const double *b);

/* TAUT_NOT_CONVERGED, "rough", where two rules differ by such a share that nothing is known. */
taut_status taut_gradient_check_settled(double change, taut_error *error);

/* Pulls back through the Dirichlet surface: one solve (dirichlet.c). */
taut_status taut_gradient_pull_dirichlet(const taut_dirichlet_problem *problem,
                                         const taut_monitor *monitor, taut_arena *arena,
                                         double *seed, taut_error *error);

/* Pulls back through any construction that is linear in the points of its net (linear.c). `make`
 * makes its model with other points in place of its own. */
typedef taut_status taut_gradient_remake(const void *context, const double *points,
                                         const taut_make_options *options, taut_model **model,
                                         taut_error *error);
taut_status taut_gradient_pull_linear(const taut_gradient_net *net, taut_gradient_remake *remake,
                                      const void *context, const taut_monitor *monitor,
                                      taut_arena *arena, double *seed, taut_error *error);

#endif /* TAUT_CONSTRUCT_GRADIENT_GRADIENT_H */
