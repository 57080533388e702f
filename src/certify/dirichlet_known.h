/* dirichlet_known.h -- is what a problem gave in the surface, bit for bit? */
#ifndef TAUT_CERTIFY_DIRICHLET_KNOWN_H
#define TAUT_CERTIFY_DIRICHLET_KNOWN_H

#include "taut/dirichlet.h"

/* Adds the claim `known`: the largest difference of a known point over the size of them all, of a
 * break over the range, or of a weight over itself, held against 0. The nets have the same shape.
 * TAUT_NO_MEMORY. */
taut_status taut_dirichlet_add_known(const taut_surface *surface,
                                     const taut_dirichlet_problem *problem,
                                     taut_certificate *certificate);

#endif /* TAUT_CERTIFY_DIRICHLET_KNOWN_H */
