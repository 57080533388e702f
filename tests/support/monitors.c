#include "monitors.h"

#include "check.h"

static int count_report(void *context, double done, const char *what)
{
    watch *w = context;
    (void)done;
    CHECK(what != NULL, "a report says what is done");
    w->reports++;
    if (w->stop_at == 0 || w->reports < w->stop_at) {
        return TAUT_GO_ON;
    }
    return w->answer != 0 ? w->answer : TAUT_STOP;
}

taut_monitor monitor_of(watch *w)
{
    const taut_monitor monitor = {count_report, w};
    return monitor;
}
