/* gradient.h -- the gradient of the Dirichlet energy of a finished surface, by
 * quadrature.
 *
 *     g_ij = dD/dP_ij = iint lambda phi_u x_u + phi_v x_v / lambda du dv,   phi = dx/dP_ij
 *     D    = 1/2 iint lambda |x_u|^2 + |x_v|^2 / lambda du dv               ([WuWang2011] 2.3, 2.4)
 *
 * from the derivatives that evaluation gives at Gauss nodes, not from Gram matrices. Lengths are in
 * units of a power of two near the size of the surface, so that nothing overflows.
 */
#ifndef TAUT_CERTIFY_DIRICHLET_GRADIENT_H
#define TAUT_CERTIFY_DIRICHLET_GRADIENT_H

#include "core/crew.h"
#include "geometry/nurbs/cells.h"
#include "taut/surface.h"

typedef struct taut_dirichlet_gradient {
    double *values; /* [nu][nv][3]: g over max(lambda Lv/Lu, Lu/Lv/lambda) and the unit */
    double *gross; /* [nu][nv]: the sum of what rounding acts on, 2^-53 of it is what storing points
                    * and parameters in doubles leaves:
                    *     iint |phi_u| (sum |phi_u,st| |P_st| + rho |x_u|) + the same in v,
                    *     rho = |u| (k/du + |w_u|/w) + |v| (h/dv + |w_v|/w)
                    * points as stored, not centred; k, h functions alive, du, dv widths of spans
                    * (at most 1 on hyperbolic bases, whose layers are as wide) */
    double halves[2];       /* iint |x_u|^2, iint |x_v|^2, in squares of the unit */
    double halves_gross[2]; /* of the Dirichlet energy: what rounding acts on in either, 2^-53
                             * roundings of it */
    double roundings;       /* so many of 2^-53 gross the sums themselves may be off by */
    double remainder;       /* of the rule: what quadrature may be off by in any derivative */
    double area;            /* in squares of the unit; 0 of the Dirichlet energy's gradient */
    int unit;               /* the unit is 2 to this power */
    double points;          /* of quadrature, summed one after the other, */
    double spans;           /* on so many pairs of spans */
} taut_dirichlet_gradient;

/* Where the nodes are: so many Gauss nodes (1..TAUT_GAUSS_MAX) a cell. */
typedef struct taut_gradient_rule {
    int nodes;
    int halvings;          /* of every cell (geometry/nurbs/cells.h), unless they are told: */
    double remainder;      /* no derivative is off by more, rounding aside; INFINITY: not known */
    taut_cells *cells[2];  /* of u and of v, or NULL */
    const taut_crew *crew; /* or NULL; the gradient is the same for any number of threads */
} taut_gradient_rule;

/* A rule whose remainder is below the rounding of the sums, or else the best that can be afforded,
 * with nodes 0 where there is none (certify/dirichlet/remainder.h); to be cleared. rule->crew is the
 * crew. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_gradient_plan(const taut_surface *surface, int is_area, double aspect,
                               const taut_crew *crew, taut_gradient_rule *rule);
void taut_gradient_rule_clear(taut_gradient_rule *rule);

/* rule->nodes half as many again, at most TAUT_GAUSS_MAX; or 0 where that is reached, or where they would be more than
 * 2^24 Gauss points and more than those of TAUT_GAUSS_MAX nodes on every span: cells that are cut because weights are
 * far apart do not pay for more. `before` is the gradient by the rule as it stands. */
int taut_gradient_raise(taut_gradient_rule *rule, const taut_dirichlet_gradient *before);

/* TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_dirichlet_gradient_new(const taut_surface *surface, double aspect,
                                        const taut_gradient_rule *rule,
                                        taut_dirichlet_gradient *gradient);
/* The gradient of the area instead, from the form (G, -F, E) / W in place of (lambda, 0, 1/lambda)
 * ([WuWang2011] 7.1: at the surface itself it has the area's gradient). */
taut_status taut_area_gradient_new(const taut_surface *surface, const taut_gradient_rule *rule,
                                   taut_dirichlet_gradient *gradient);
void taut_dirichlet_gradient_clear(taut_dirichlet_gradient *gradient);

#endif /* TAUT_CERTIFY_DIRICHLET_GRADIENT_H */
