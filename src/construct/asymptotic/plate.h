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

/* A further unknown: its number is multiplied to homogeneous entries (numerator and weight) of the
 * rows beside one or two edges. */
typedef struct taut_plate_freedom {
    int parts;
    struct {
        int edge;
        double row[TAUT_QUAD_PATCH + 1][4];
    } part[2];
} taut_plate_freedom;

enum { TAUT_PLATE_FREEDOMS = 4 * (3 * TAUT_QUAD_DEGREE - 8) };

typedef struct taut_plate_options {
    int nodes; /* Gauss nodes per direction; 0: 2 m + 14, which gives A_2 to full precision */
    const taut_monitor *monitor;
} taut_plate_options;

/* Finds the inner numerators patch->net[2..m-2][2..m-2] and the factors of the freedoms, none of
 * which may touch a weight; both are put into the patch. *energy = A_2 of the result.
 * Cost O(m^6). */
taut_status taut_plate_solve(taut_patch *patch, int count, const taut_plate_freedom *freedoms,
                             double *factors, const taut_plate_options *options, double *energy,
                             taut_error *error);

/* The factors f of a Gauss-Newton step towards the least A_2 over inner points and freedoms
 * together, from a patch whose inner points are solved; freedoms may touch weights. To second
 * order A_2 at factors g is its least value plus |r (g - f)|^2, r upper triangular:
 * double[count][count], column-major. The patch stays as it is. */
taut_status taut_plate_step(taut_patch *patch, int count, const taut_plate_freedom *freedoms,
                            double *factors, double *r, const taut_plate_options *options,
                            taut_error *error);

#endif /* TAUT_ASYMPTOTIC_PLATE_H */
