/* quintic_search.h -- inside Algorithm 1 for degree 5: one sign branch as a function of its unknowns
 * (docs page section 4.4).
 *
 * Unknowns of a curved edge:
 *     P_2 = A_0 + lambda a_0 + mu c_0     in the corner planes, mu = +-e^m, nu = +-e^q
 *     P_3 = A_1 + rho a_1 + nu c_1
 *     theta_0, theta_1 = log |tau| at the ends, one number for the two edges of a corner
 * so that the corner torsions match by construction. Curvatures give w_1 and w_4; with l_j = log w_j
 *     theta_0 = l_3 - 3/2 l_2 + g_0,   theta_1 = l_2 - 3/2 l_3 + g_1
 * give w_2 and w_3. No closing condition is left.
 */
#ifndef TAUT_ASYMPTOTIC_QUINTIC_SEARCH_H
#define TAUT_ASYMPTOTIC_QUINTIC_SEARCH_H

#include "construct/asymptotic/corner_data.h"

#include <stdint.h>

/* Places of an edge's own unknowns, counted from its first. */
enum {
    TAUT_QUINTIC_LAMBDA,
    TAUT_QUINTIC_LOG_MU,
    TAUT_QUINTIC_LOG_NU,
    TAUT_QUINTIC_RHO,
    TAUT_QUINTIC_OWN
};
enum { TAUT_QUINTIC = 5 };

typedef struct taut_quintic_search {
    const taut_corner_data *data;
    const taut_curve_rule *rule;
    const int *signs;
    int first[4];           /* index of an edge's own unknowns, -1 if straight */
    int theta[4][2];        /* index of an end's log |tau| */
    double fixed[4][2];     /* the part of taut_quintic_rest that no unknown moves */
    int torsion_sign[4][2]; /* of n.(P_3 - P_0), fixed by the start; 0: not yet */
    int count;
    taut_quad quad;
} taut_quintic_search;

/* quintic.c */
void taut_quintic_plan(const taut_corner_data *data, const int signs[4], taut_quintic_search *s);
/* A start whose torsions can match; 0 if none is drawn. */
int taut_quintic_start(void *search, int number, uint64_t *noise, double *x);

/* quintic_evaluate.c */

/* The control points of edge e but P_1 and P_4 from its unknowns y. */
void taut_quintic_points(const taut_quintic_search *s, int e, const double *y,
                         taut_quad_edge *made);
/* n.(P_3 - P_0) at end 0, n.(P_2 - P_5) at end 1. */
double taut_quintic_numerator(const taut_quintic_search *s, int e, int end,
                              const taut_quad_edge *made);
/* theta - (l_3 - 3/2 l_2) at an end: what the torsion has besides its weights. */
double taut_quintic_rest(const taut_quintic_search *s, int e, int end, const double *y,
                         double numerator);
/* h of an end: what raising the degree later takes from the weight beside it. */
double taut_quintic_raising(const taut_quintic_search *s, int e, int end);
/* A taut_objective; its context is the search. */
int taut_quintic_objective(void *search, const double *x, double *value, double *gradient);

/* quintic_second.c: a taut_hessian; the objective was last called at x. */
void taut_quintic_hessian(void *search, const double *x, double *hessian);

#endif /* TAUT_ASYMPTOTIC_QUINTIC_SEARCH_H */
