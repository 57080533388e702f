/* family.h -- what Algorithm 1 must provide for one degree of the boundary: which sign branches the
 * data allows, and the least energy in each.
 */
#ifndef TAUT_ASYMPTOTIC_FAMILY_H
#define TAUT_ASYMPTOTIC_FAMILY_H

#include "construct/asymptotic/branch.h"
#include "core/pulse.h"

typedef struct taut_family {
    /* Fills what does not depend on the branch; room is zeroed memory of `size` bytes. */
    size_t size;
    taut_status (*prepare)(const taut_corner_data *data, void *room, taut_closing *closing,
                           taut_error *error);
    /* Can torsions and edges have these signs? Straight edges carry 0. */
    int (*allows)(const void *room, const int signs[4]);
    /* work: double[TAUT_STARTS_WORK]. Finds nothing where the pulse is stopped. */
    void (*minimise)(const void *room, const int signs[4], double *work, taut_pulse *pulse,
                     taut_branch *branch);
} taut_family;

extern const taut_family taut_family_quartic; /* quartic_minimise.c */
extern const taut_family taut_family_quintic; /* quintic.c */

/* Degree 3, of corners that passed taut_corner_check, differs: nothing but one length is free, and the signs come with it. */
taut_status taut_cubic_find(const taut_asymptotic_corners *corners, double rounding,
                            taut_branches *branches, taut_error *error);

#endif /* TAUT_ASYMPTOTIC_FAMILY_H */
