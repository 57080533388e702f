/* conditions.h -- what a quadrilateral must satisfy to bound a patch on which its edges are
 * asymptotic (docs page section 3).
 */
#ifndef TAUT_ASYMPTOTIC_CONDITIONS_H
#define TAUT_ASYMPTOTIC_CONDITIONS_H

#include "construct/asymptotic/quad.h"

/* The side to which edge `edge` bends at end `end`: the sign of mu (end 0) or nu (end 1) in
 * P_2 = P_0 + lambda a + mu c; 0 on a straight edge. */
int taut_quad_side(const taut_quad *quad, int edge, int end);

/* sigma_i(j) = sign(b . N), b the binormal and N along R_u x R_v: the side, with the other sign for
 * edges that run with v. */
int taut_quad_sigma(const taut_quad *quad, int edge, int end);

/* (C1) legs not parallel, (C2) both osculating planes the tangent plane, (C3) opposite torsions, at
 * every corner. TAUT_NO_SOLUTION names the corner, the condition and by how much, and for (C3) the
 * least change of inner weights, in logarithms, that mends all corners. */
taut_status taut_quad_check(const taut_quad *quad, taut_error *error);

/* What rounding of the points does to the torsion t at an end. */
double taut_quad_torsion_rounding(const taut_quad *quad, int edge, int end, double t);

#endif /* TAUT_ASYMPTOTIC_CONDITIONS_H */
