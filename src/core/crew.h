/* crew.h -- who does long work, and who watches it: so many threads, and a pulse.
 *
 * What is handed down through whatever may be long. A crew whose pulse was answered by an end begins no more tasks; what is
 * made of them has no meaning then, and the function that has the pulse says TAUT_INTERRUPTED, whatever it is told from inside.
 */
#ifndef TAUT_CORE_CREW_H
#define TAUT_CORE_CREW_H

#include "core/pulse.h"
#include "platform/parallel.h"

#include <stdint.h>

typedef struct taut_crew {
    int threads;       /* 0: 1 */
    taut_pulse *pulse; /* or NULL: nobody watches */
} taut_crew;

/* taut_parallel_workers of the crew's threads. crew may be NULL, here and below: one thread, unwatched. */
int taut_crew_workers(const taut_crew *crew, int64_t tasks);

/* taut_parallel_run, a beat of `work` operations after each task of the caller's thread. Nonzero when it is to end: then not
 * all tasks were run. */
int taut_crew_run(const taut_crew *crew, int workers, int64_t tasks, double work, taut_task *run,
                  void *context);

/* taut_pulse_beat of the crew's pulse. */
int taut_crew_beat(const taut_crew *crew, double work);

#endif /* TAUT_CORE_CREW_H */
