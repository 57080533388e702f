/* pulse.h -- tells a monitor that work goes on, by the work that is done and not by a clock: the same calls on every machine.
 *
 * Loops that may be long add what they have done; every TAUT_PULSE_WORK operations are a report. Once a report was answered
 * by an end it stays said: what is inside returns as soon as it can, with outputs of no meaning, and the function that has the
 * pulse returns TAUT_INTERRUPTED.
 */
#ifndef TAUT_CORE_PULSE_H
#define TAUT_CORE_PULSE_H

#include "taut/monitor.h"

#include <stddef.h>

#define TAUT_PULSE_WORK                                                                            \
    1e7 /* operations on doubles: some ten milliseconds where they are slowest */

typedef struct taut_pulse {
    const taut_monitor *monitor; /* or NULL */
    const char *what;
    double done; /* what reports say, in [0, 1] or NaN */
    double work; /* since the last report */
    int is_stopped;
} taut_pulse;

/* A monitor of steps that know no pulse: each of its reports is one of the pulse. */
taut_monitor taut_pulse_monitor(taut_pulse *pulse);

#ifdef TAUT_UNWATCHED /* a build whose callers have no monitor: nothing is ever to end early */

static inline int taut_pulse_report(taut_pulse *pulse)
{
    (void)pulse;
    return 0;
}

static inline int taut_pulse_beat(taut_pulse *pulse, double work)
{
    (void)pulse;
    (void)work;
    return 0;
}

static inline int taut_pulse_is_stopped(const taut_pulse *pulse)
{
    (void)pulse;
    return 0;
}

#else

/* Both: nonzero from then on when it is to end. pulse may be NULL: never. */
int taut_pulse_report(taut_pulse *pulse);
int taut_pulse_beat(taut_pulse *pulse, double work);

static inline int taut_pulse_is_stopped(const taut_pulse *pulse)
{
    return pulse != NULL && pulse->is_stopped;
}

#endif

#endif /* TAUT_CORE_PULSE_H */
