/* least.h -- the claim `least`: no surface with this boundary has less area, but for so much. */
#ifndef TAUT_CERTIFY_PLATEAU_LEAST_H
#define TAUT_CERTIFY_PLATEAU_LEAST_H

#include "core/crew.h"
#include "taut/certify.h"
#include "taut/record.h"
#include "taut/surface.h"

typedef struct taut_least_request {
    const taut_surface *surface;
    const taut_record *witness; /* details.least, or NULL */
    int boundary_only;          /* the boundary is known and nothing else */
    int is_held;                /* points to pass through hold it */
    int is_declined;            /* the document says "least": false */
    double gap;                 /* asked for, or 0 */
    double area, area_error;    /* of the surface, as measured */
    const taut_crew *crew;
} taut_least_request;

/* Adds the claim, and to figures lower_bound, gap and direction where there are any. TAUT_NO_MEMORY.
 */
taut_status taut_certify_add_least(const taut_least_request *request, taut_record *figures,
                                   taut_certificate *certificate);

#endif /* TAUT_CERTIFY_PLATEAU_LEAST_H */
