/* monitors.h -- a monitor that counts reports and stops the work, or has it end with what there is. */
#ifndef TAUT_TEST_MONITORS_H
#define TAUT_TEST_MONITORS_H

#include "taut/monitor.h"

typedef struct watch {
    int stop_at; /* the first report that is answered otherwise: from 1 on, 0 never */
    int reports; /* so far */
    int answer;  /* from then on; 0: TAUT_STOP */
} watch;

/* The watch must live as long as the monitor. */
taut_monitor monitor_of(watch *w);

#endif /* TAUT_TEST_MONITORS_H */
