/* pace.h -- how long a call may go on: its monitor, and its time, as one monitor for those who work.
 *
 *     taut_pace pace;
 *     const taut_make_options own = taut_pace_options(&pace, options);
 *     status = work(&own, ...)             TAUT_INTERRUPTED where a report was not answered by 0
 *     if (taut_pace_ends(&pace, status, details)) ...  it is to end with the best so far
 *     return taut_pace_end(&pace, status, error);
 */
#ifndef TAUT_CORE_PACE_H
#define TAUT_CORE_PACE_H

#include "taut/construct.h"
#include "taut/record.h"

typedef struct taut_pace {
    taut_monitor asked;
    double limit, end; /* seconds: what was allowed, 0 for no end; and by the clock */
    int is_enough;     /* once said it stays said, so that all that work is made of ends */
    int is_over;       /* by the clock */
} taut_pace;

#ifdef TAUT_UNWATCHED /* a build whose callers have neither a monitor nor a limit */

static inline taut_make_options taut_pace_options(taut_pace *pace, const taut_make_options *options)
{
    *pace = (taut_pace){.limit = 0};
    return *options;
}

static inline int taut_pace_ends(const taut_pace *pace, taut_status status, taut_record *details)
{
    (void)pace;
    (void)status;
    (void)details;
    return 0;
}

static inline taut_status taut_pace_end(const taut_pace *pace, taut_status status,
                                        taut_error *error)
{
    (void)pace;
    (void)error;
    return status;
}

#else

/* The options (not NULL) with this pace for a monitor, which must live as long, and without a time
 * limit: that is the pace's. */
taut_make_options taut_pace_options(taut_pace *pace, const taut_make_options *options);

/* Is work of this status to end with what there is? Then the details say "stopped": "time" or "request". */
int taut_pace_ends(const taut_pace *pace, taut_status status, taut_record *details);
/* The status of work that was ended: TAUT_NOT_CONVERGED, "time", in place of TAUT_INTERRUPTED where
 * nobody asked it to stop. */
taut_status taut_pace_end(const taut_pace *pace, taut_status status, taut_error *error);

#endif

#endif /* TAUT_CORE_PACE_H */
