/* witness.h -- the function that shows how near a film is to the least area of all.
 *
 * psi on the spans of the film, two degrees above it (one from WITNESS_LARGE points on), for which
 *
 *     D = iint sqrt(1 - |grad psi|^2) dx dy + oint z dpsi  <=  area of any surface with this boundary
 *
 * is as large as it gets: docs/least.md. It goes into the model, for the certificate to judge.
 */
#ifndef TAUT_CONSTRUCT_PLATEAU_WITNESS_H
#define TAUT_CONSTRUCT_PLATEAU_WITNESS_H

#include "taut/monitor.h"
#include "taut/record.h"
#include "taut/surface.h"

typedef struct taut_plateau_witness {
    double direction[3];
    taut_basis *u, *v;
    double *coefficients; /* double[count of u][count of v], in the unit of the surface */
    double gap;           /* (A - D) / A by a Gauss rule */
    double *density;      /* double[spans of u][spans of v]: the share of each in it */
} taut_plateau_witness;

/* *witness is NULL where there is none: more than 100 x 100 points, no direction in which the film is a graph over a convex domain, or a system that doubles
 * do not solve. The monitor may be NULL, or empty. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_plateau_witness_new(const taut_surface *surface, const taut_monitor *monitor,
                                     taut_plateau_witness **witness);
/* Its failure, told: TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_plateau_witness_fail(taut_status status, taut_error *error);
void taut_plateau_witness_free(taut_plateau_witness *witness); /* NULL is fine */

/* The member `least` of details. */
void taut_plateau_witness_describe(const taut_plateau_witness *witness, taut_record *details);

/* The same breaks and continuity, so many degrees up: each knot repeated so many times more. */
taut_status taut_plateau_raise(const taut_basis *basis, int more, taut_basis **raised);
/* Members u, v, coefficients of a record. */
void taut_plateau_describe_psi(const taut_basis *u, const taut_basis *v, const double *coefficients,
                               taut_record *record);

#endif /* TAUT_CONSTRUCT_PLATEAU_WITNESS_H */
