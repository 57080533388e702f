/* scaling.h -- moves given points near the origin and to about unit size, and back.
 *
 *     y = 2^-inner (2^-outer x - centre)
 *
 * The powers of two cost no rounding, so a problem in units of 1e200 or 1e-200 is the same problem,
 * and a far-off origin costs only what its own storage in doubles does.
 */
#ifndef TAUT_CONSTRUCT_COMMON_SCALING_H
#define TAUT_CONSTRUCT_COMMON_SCALING_H

#include "taut/status.h"

#include <stddef.h>

typedef struct taut_scaling {
    double centre[3];
    int outer, inner;
} taut_scaling;

/* From the points with known[i] != 0 (at least one): afterwards they lie in [-1, 1]^3, the
 * largest coordinate at least 1/2 in size unless all of them coincide. points double[count][3]. */
taut_scaling taut_scaling_of(size_t count, const double *points, const unsigned char *known);

/* net double[count][3]: the scaled points, 0 where known[i] is 0; known NULL: all are. */
void taut_scaling_apply(const taut_scaling *scaling, size_t count, const double *points,
                        const unsigned char *known, double *net);
/* points double[count][3]: those known as `given`, bit for bit, the others from the scaled net,
 * which may be `points`. TAUT_NO_SOLUTION, "overflow": one is beyond the range of doubles. */
taut_status taut_scaling_undo(const taut_scaling *scaling, size_t count, const double *given,
                              const unsigned char *known, const double *net, double *points,
                              taut_error *error);

/* value in squared lengths: value 2^(2 (outer + inner)), as far as doubles reach. */
double taut_scaling_undo_square(const taut_scaling *scaling, double value);

#endif /* TAUT_CONSTRUCT_COMMON_SCALING_H */
