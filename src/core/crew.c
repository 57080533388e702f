#include "core/crew.h"

#include <stdatomic.h>
#include <stddef.h>

typedef struct watched {
    taut_pulse *pulse;
    double work;
    taut_task *run;
    void *context;
    atomic_int is_over; /* as the pulse says, for the other threads */
} watched;

int taut_crew_workers(const taut_crew *crew, int64_t tasks)
{
    return taut_parallel_workers(crew != NULL ? crew->threads : 1, tasks);
}

int taut_crew_beat(const taut_crew *crew, double work)
{
    return crew != NULL && taut_pulse_beat(crew->pulse, work);
}

static void run_watched(void *context, int worker, int64_t task)
{
    watched *w = context;

    if (atomic_load(&w->is_over)) {
        return;
    }
    w->run(w->context, worker, task);
    if (worker == 0 && taut_pulse_beat(w->pulse, w->work)) {
        atomic_store(&w->is_over, 1);
    }
}

int taut_crew_run(const taut_crew *crew, int workers, int64_t tasks, double work, taut_task *run,
                  void *context)
{
    if (crew == NULL || crew->pulse == NULL) {
        taut_parallel_run(workers, tasks, run, context);
        return 0;
    }
    watched w = {.pulse = crew->pulse, .work = work, .run = run, .context = context};

    atomic_init(&w.is_over, taut_pulse_is_stopped(crew->pulse));
    taut_parallel_run(workers, tasks, run_watched, &w);
    return taut_pulse_is_stopped(crew->pulse);
}
