/* quartic.h -- Algorithm 1 for degree 4: each edge has one free number, the place of P_2 on the
 * line common to its two corner planes, and the weights follow from curvatures and torsions.
 */
#ifndef TAUT_ASYMPTOTIC_QUARTIC_H
#define TAUT_ASYMPTOTIC_QUARTIC_H

#include "construct/asymptotic/branch.h"
#include "construct/asymptotic/corner_data.h"

/* P_2 = A_0 + lambda a_0 + mu c_0 = A_1 + nu c_1 + rho a_1 with
 * (lambda, mu, nu, rho) = at + p along. */
typedef struct taut_quartic_line {
    double at[4], along[4];
    int same_ratio;    /* nu / mu is the same for all p */
    double torsion[2]; /* n.(P_3 - P_0) and n.(P_1 - P_4): what the end torsions are made of */
} taut_quartic_line;

typedef struct taut_quartic {
    const taut_corner_data *data;
    taut_quartic_line lines[4];
    int linked[4]; /* corners whose torsions must match */
    int ring;      /* all four are */
    taut_closing closing;
    int closing_signs[4];    /* epsilon of docs page (4.5) */
    double closing_constant; /* of sum epsilon (constant + 2 log(nu / mu)) = 0 */
} taut_quartic;

/* The whole family is taut_family_quartic (family.h).
 *
 * TAUT_NO_SOLUTION where corner planes are parallel, a torsion vanishes on one side only, no signs
 * agree, or the closing condition is impossible. */
taut_status taut_quartic_fill(const taut_corner_data *data, taut_quartic *quartic,
                              taut_error *error);

/* The message for a ring that cannot close: the factor it misses by, of logarithm `gap`, and the
 * curvatures that close it, by the least change in logarithms: the same for all eight. is_open:
 * those close it in the limit of middle points at infinity only, and what lies beyond them does. */
taut_status taut_closing_fail(const taut_corner_data *data, double gap, int is_open,
                              taut_error *error);

/* Do these signs agree with the torsions' signs at all linked corners, and can each edge take
 * its sign at both ends? */
int taut_quartic_allows(const taut_quartic *quartic, const int signs[4]);

/* TAUT_NO_SOLUTION where no signs do: which edge turns over, or which control point of a ring is on
 * the wrong side of a tangent plane by the least. */
taut_status taut_quartic_check_signs(const taut_quartic *quartic, taut_error *error);

/* The part of the p-line on which mu and nu have the sign: 0 if empty. */
int taut_quartic_interval(const taut_quartic_line *line, int sign, double range[2]);
/* Least and largest log(nu / mu) there; may be infinite. */
void taut_quartic_ratios(const taut_quartic_line *line, const double range[2], double ratios[2]);

#endif /* TAUT_ASYMPTOTIC_QUARTIC_H */
