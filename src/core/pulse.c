#include "core/pulse.h"

#ifndef TAUT_UNWATCHED

int taut_pulse_report(taut_pulse *pulse)
{
    if (pulse == NULL) {
        return 0;
    }
    pulse->work = 0;
    if (!pulse->is_stopped && pulse->monitor != NULL && pulse->monitor->progress != NULL) {
        pulse->is_stopped =
            pulse->monitor->progress(pulse->monitor->context, pulse->done, pulse->what) != 0;
    }
    return pulse->is_stopped;
}

int taut_pulse_beat(taut_pulse *pulse, double work)
{
    if (pulse == NULL) {
        return 0;
    }
    pulse->work += work;
    return pulse->work >= TAUT_PULSE_WORK ? taut_pulse_report(pulse) : pulse->is_stopped;
}

#endif

static int pass_on(void *context, double done, const char *what)
{
    (void)done;
    (void)what;
    return taut_pulse_report(context) ? TAUT_STOP : TAUT_GO_ON;
}

taut_monitor taut_pulse_monitor(taut_pulse *pulse)
{
    const taut_monitor monitor = {.progress = pass_on, .context = pulse};
    return monitor;
}
