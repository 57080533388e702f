/* least.h -- the claim `least`: no surface with this boundary has less area, but for so much. */
#ifndef TAUT_CERTIFY_PLATEAU_LEAST_H
#define TAUT_CERTIFY_PLATEAU_LEAST_H

#include "certify/plateau/flux.h"
#include "certify/plateau/outline.h"
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

/* Why there is no bound, or the bound. */
typedef struct taut_least_finding {
    const char *why; /* NULL: there is one */
    double gap;      /* in squares of 2^exponent */
    double area_low, area_high;
    double direction[3];
    int exponent;
} taut_least_finding;

/* Words for a verdict; NULL for that which admits a witness. */
const char *taut_least_reason(taut_flux_verdict verdict);
/* found->why, or gap, area_low and area_high, of what all sheets and the whole boundary have. */
void taut_least_conclude(const taut_flux_bound *flux, const taut_outline_bound *outline,
                         taut_least_finding *found);
/* The residual. Adds lower_bound, gap and direction to figures; the first two times the tension. */
double taut_least_tell(const taut_least_finding *found, double measured, double measured_error,
                       double tension, taut_record *figures);

#endif /* TAUT_CERTIFY_PLATEAU_LEAST_H */
