#include "core/pace.h"

#include "core/fail.h"
#include "platform/system.h"

#include <math.h>
#include <stddef.h>

#ifndef TAUT_UNWATCHED

static int report(void *context, double done, const char *what)
{
    taut_pace *pace = context;
    const taut_monitor *asked = &pace->asked;
    const int answer =
        asked->progress != NULL ? asked->progress(asked->context, done, what) : TAUT_GO_ON;

    if (answer != TAUT_GO_ON && answer != TAUT_ENOUGH) {
        pace->is_enough = 0; /* who asked for an end may still want none of it */
        return answer;
    }
    if (pace->limit > 0 && taut_system_seconds() >= pace->end) {
        pace->is_over = 1;
    }
    pace->is_enough = pace->is_enough || answer == TAUT_ENOUGH || pace->is_over;
    return pace->is_enough ? TAUT_ENOUGH : TAUT_GO_ON;
}

taut_make_options taut_pace_options(taut_pace *pace, const taut_make_options *options)
{
    taut_make_options own = *options;
    *pace = (taut_pace){.asked = options->monitor, .limit = options->time_limit};
    pace->end = pace->limit > 0 ? taut_system_seconds() + pace->limit : INFINITY;
    own.time_limit = 0;
    if (pace->limit > 0 || options->monitor.progress != NULL) {
        own.monitor = (taut_monitor){report, pace};
    }
    return own;
}

int taut_pace_ends(const taut_pace *pace, taut_status status, taut_record *details)
{
    if (status != TAUT_INTERRUPTED || !pace->is_enough) {
        return 0;
    }
    taut_record_add_text(details, "stopped", pace->is_over ? "time" : "request");
    return 1;
}

taut_status taut_pace_end(const taut_pace *pace, taut_status status, taut_error *error)
{
    if (status != TAUT_INTERRUPTED || !pace->is_enough) {
        return status;
    }
    if (!pace->is_over) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "time", NULL, taut_none, taut_none,
                         "it was to end before there was anything to show");
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "time", NULL, taut_none, pace->limit,
                     "the %.6g seconds allowed were over before there was anything to show",
                     pace->limit);
}

#endif
