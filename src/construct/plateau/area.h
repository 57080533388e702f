/* area.h -- the area of a net, its gradient and its Hessian, at Gauss points.
 *
 *     A      = sum_g w_g W,    W = |x_u x x_v|,    n = x_u x x_v / W       ([WuWang2011] 2.3, 6)
 *     dA     = iint f_u . d_u + f_v . d_v,         f_u = x_v x n,  f_v = n x x_u
 *     df_u   = n (G n.d_u - F n.d_v) / W + d_v x n
 *     df_v   = n (E n.d_v - F n.d_u) / W + n x d_u
 *
 * The last two are section 6's, with dn written out: what acts along the normal is the operator of
 * the metric, E = |x_u|^2, F = x_u.x_v, G = |x_v|^2, and what is left is an antisymmetric part.
 * Without the projection on n and the antisymmetric part it is the metric operator L_g itself
 * (7.1): for every d, A(x + d) <= A(x) + dA d + 1/2 d L_g d, at each Gauss point and so in the sum.
 * Hence the operators here,
 *
 *     B = (1 - theta) H + theta L_g,    0 <= theta <= 1,
 *
 * lead from Newton's step (0) to one that always falls (1).
 *
 * With weights, x = X / w has x_u = (X_u - (w_u / w) X) / w: linear in the points too. Points where
 * W is zero have no normal and count for nothing.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_AREA_H
#define TAUT_CONSTRUCT_PLATEAU_AREA_H

#include "construct/plateau/area_kernel.h"
#include "construct/plateau/cable.h"
#include "core/arena.h"
#include "core/pulse.h"
#include "geometry/nurbs/loop.h"
#include "taut/basis.h"

#include <stddef.h>

/* Gauss nodes in one direction; slopes are over the unit interval. */
typedef struct taut_area_axis {
    int count; /* nodes in all */
    int nodes; /* on each cell */
    int local;
    int *first;      /* [count] */
    double *value;   /* [count][local] */
    double *slope;   /* [count][local] */
    double *weights; /* [count]: their sum is 1 */
    double *at;      /* [count]: parameters */
    /* For kernels, by cell, whole vectors of nodes or functions, zeros where there are none: */
    int group, wide;          /* nodes, local, rounded up */
    double *values, *slopes;  /* [cells][local][group] */
    double *by_node, *sloped; /* [count][wide]: value and slope */
    double *group_weights;    /* [cells][group] */
} taut_area_axis;

typedef struct taut_area_density taut_area_density;

typedef struct taut_area_functional {
    taut_arena *arena; /* of all its arrays */
    int nu, nv;
    taut_area_axis u, v;
    const taut_area_ops *ops;
    size_t stride, width; /* of a plane of a row of the net; 3 of them */
    double *weights;      /* [nu][nv] over the largest, or NULL */
    double *quotient;     /* [u.count][cells of v][3][group], area_kernel.h, or NULL */
    double *state;        /* [u.count][cells of v][TAUT_AREA_STATE][group] of the last gradient */
    double *net;          /* [nu][width], then as many for what comes back: in planes, weighted */
    double *polygons;     /* [2][width] */
    double *spread;       /* [2][width] */
    double *elements;     /* [2][group]: W of a cell; weights */
    double work;          /* about so many flops were spent on it, its factors included */
    taut_area_cable *cables; /* [cable_count], borrowed: they count beside the area, everywhere */
    int cable_count;         /* 0 at first */
    int threads;             /* for matrices made of it; 0, at first: 1 */
    taut_pulse *pulse; /* borrowed: is told of what is done here and of factors; NULL at first */
    taut_area_density
        *density; /* borrowed: its energy counts in place of the area (density.h); NULL at first */
} taut_area_functional;

/* What a net is worth; of a density least is 1. */
typedef struct taut_area_value {
    double area;  /* with C(L) of each cable */
    double least; /* smallest W over the area (the mean of W) */
} taut_area_value;

/* local + extra nodes a cell in each direction. weights double[nu][nv] or NULL. TAUT_NO_MEMORY. */
taut_status taut_area_functional_new(const taut_basis *u, const taut_basis *v,
                                     const double *weights, int extra,
                                     taut_area_functional **functional);
/* The same of nets on the functions that go around where a loop is given, NULL else
 * (geometry/nurbs/loop.h); copies count as points of their own. */
taut_status taut_area_functional_around(const taut_basis *u, const taut_basis *v,
                                        const taut_loop *around_u, const taut_loop *around_v,
                                        int extra, taut_area_functional **functional);
void taut_area_functional_free(taut_area_functional *functional); /* NULL is fine */

/* The area of net double[nu][nv][3]. */
taut_area_value taut_area_functional_value(taut_area_functional *functional, const double *net);
/* The same, with gradient double[nu][nv][3] at every point, known ones too; the operators below are
 * those of this net from now on. */
taut_area_value taut_area_functional_gradient(taut_area_functional *functional, const double *net,
                                              double *gradient);

/* The state, and the quotient where there are weights, of node k of v on line `line`. */
void taut_area_functional_state(const taut_area_functional *functional, int line, int k,
                                double state[TAUT_AREA_STATE]);
void taut_area_functional_quotient(const taut_area_functional *functional, int line, int k,
                                   double quotient[3]);

/* About so many flops: one look at the area of a net. */
double taut_area_functional_cost(const taut_area_functional *functional);

/* product = B direction, nets double[nu][nv][3], apart. */
void taut_area_functional_product(taut_area_functional *functional, double theta,
                                  const double *direction, double *product);

#endif /* TAUT_CONSTRUCT_PLATEAU_AREA_H */
