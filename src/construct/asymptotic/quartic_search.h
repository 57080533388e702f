/* quartic_search.h -- inside Algorithm 1 for degree 4: one sign branch as a function of few
 * unknowns.
 *
 * Unknowns: for each curved edge the logarithm of |mu| (of |nu|, or p itself, where mu does not
 * move), and for each chain of edges linked by torsions one common scale, the logarithm of one w_2.
 * From T_i0 = log|w_i2 tau_i(0)| and T_i1, functions of p_i alone, the corner equations (4.4)
 *     log w_f2 = log w_e2 + T_f - T_e
 * give the others along a tree of corners. A ring that closes only for some p loses one unknown:
 * (4.5) gives log(nu / mu) of one edge, and p from it by a Moebius map. Gradients run backwards
 * through the same steps.
 */
#ifndef TAUT_ASYMPTOTIC_QUARTIC_SEARCH_H
#define TAUT_ASYMPTOTIC_QUARTIC_SEARCH_H

#include "construct/asymptotic/quartic.h"

#include <stdint.h>

/* What the unknown of an edge is; the first two index the line's numbers. */
enum { TAUT_BY_P = 0, TAUT_BY_MU = 1, TAUT_BY_NU = 2 };

typedef struct taut_quartic_link {
    int from, from_end, to, to_end;
} taut_quartic_link;

typedef struct taut_quartic_search {
    const taut_quartic *quartic;
    const taut_curve_rule *rule;
    const int *signs;
    int kind[4];     /* of the unknown of each edge */
    int variable[4]; /* its index; -1: straight, or found by the closing condition */
    int closer;      /* the edge found by the closing condition, or -1 */
    int root_of[4];  /* index of the scale of each edge whose w_2 is an unknown, else -1 */
    taut_quartic_link links[3]; /* from an edge whose w_2 is known to the next */
    int link_count;
    int count; /* of unknowns */
    double range[4][2];
    taut_quad quad; /* at the last point evaluated */
} taut_quartic_search;

/* One edge on its way through an evaluation, and the derivatives on their way back (the _bar). */
typedef struct taut_quartic_state {
    double p, slope; /* dp / d(unknown) */
    double mu, nu, log_mu, log_nu, log_w2;
    double torsion[2]; /* T_i0, T_i1 */
    double p_bar, log_mu_bar, log_nu_bar, log_w2_bar, torsion_bar[2];
} taut_quartic_state;

/* quartic_search.c */
void taut_quartic_plan(const taut_quartic *quartic, const int signs[4], taut_quartic_search *s);
/* A start: number 0 is the plain guess, the others disturb it; 0 if this one fails. */
int taut_quartic_start(void *search, int number, uint64_t *noise, double *x);
/* By how much the closing condition stays out of reach in this branch; 0 if it does not. */
double taut_quartic_gap(const taut_quartic_search *s);

/* quartic_evaluate.c */
int taut_quartic_objective(void *search, const double *x, double *value, double *gradient);
/* Unknowns to the states of all edges; 0 outside the domain. */
int taut_quartic_forwards(const taut_quartic_search *s, const double *x, taut_quartic_state at[4]);
double taut_quartic_p_of(const taut_quartic_search *s, int edge, double unknown);
/* p where nu = ratio mu. */
double taut_quartic_p_of_ratio(const taut_quartic_line *line, double ratio);

#endif /* TAUT_ASYMPTOTIC_QUARTIC_SEARCH_H */
