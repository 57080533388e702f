/* known.h -- the claim `known`: what the problem gave is in the surface, bit for bit.
 *
 * Its residual is the largest distance of a known point from the problem's over their size, or the
 * difference of the bases and weights; the limit is 0.
 */
#ifndef TAUT_CERTIFY_COMMON_KNOWN_H
#define TAUT_CERTIFY_COMMON_KNOWN_H

#include "taut/certify.h"
#include "taut/dirichlet.h"

/* What `where` says when no point was unknown, so that nothing can be said to be at rest; and after a
 * place, when the model alone says which points were known. */
#define TAUT_KNOWN_ALL "nothing was unknown"
#define TAUT_KNOWN_AS_TOLD " (known points as the model says)"

/* Are the members there that every problem with a net needs? */
static inline int taut_known_is_whole(const taut_dirichlet_problem *problem)
{
    return problem->u != NULL && problem->v != NULL && problem->points != NULL &&
           problem->known != NULL;
}

/* The net of the surface has the shape of the problem's. TAUT_NO_MEMORY. */
taut_status taut_certify_add_known(const taut_surface *surface,
                                   const taut_dirichlet_problem *problem,
                                   taut_certificate *certificate);

#endif /* TAUT_CERTIFY_COMMON_KNOWN_H */
