/* plate.h -- the inner points of a patch: the thin plate of least energy.
 *
 *     A_2 = iint |R_uu|^2 + 2 |R_uv|^2 + |R_vv|^2
 *
 * With all weights fixed R is linear in the inner numerators, so this is least squares on samples
 * at Gauss nodes, solved by Householder QR, row block by row block; never by normal equations.
 */
#ifndef TAUT_ASYMPTOTIC_PLATE_H
#define TAUT_ASYMPTOTIC_PLATE_H

#include "construct/asymptotic/patch.h"
#include "taut/monitor.h"

/* A further unknown: its number is multiplied to these entries of the row beside an edge. */
typedef struct taut_plate_freedom {
    int edge;
    double row[TAUT_QUAD_PATCH + 1][3];
} taut_plate_freedom;

enum { TAUT_PLATE_FREEDOMS = 4 * (3 * TAUT_QUAD_DEGREE - 8) };

/* Finds the inner numerators patch->net[2..m-2][2..m-2] and the factors of the freedoms, which are
 * added to the rows; *energy = A_2 of the result. Cost O(m^6). */
taut_status taut_plate_solve(taut_patch *patch, int count, const taut_plate_freedom *freedoms,
                             double *factors, const taut_monitor *monitor, double *energy,
                             taut_error *error);

#endif /* TAUT_ASYMPTOTIC_PLATE_H */
