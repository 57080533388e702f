#include "platform/parallel.h"

#include "platform/system.h"
#include "taut/limits.h"

#include <stdatomic.h>
#include <stdint.h>

typedef struct job {
    void (*work)(void *context, int part, int from, int to);
    void *context;
    int count, parts;
} job;

static void run_part(void *context, int part)
{
    const job *j = context;
    const int from = (int)((int64_t)j->count * part / j->parts);
    const int to = (int)((int64_t)j->count * (part + 1) / j->parts);
    j->work(j->context, part, from, to);
}

void taut_parallel_for(int count, int threads,
                       void (*work)(void *context, int part, int from, int to), void *context)
{
    int parts = threads < 1 ? 1 : threads > TAUT_THREADS_MAX ? TAUT_THREADS_MAX : threads;

    if (parts > count) {
        parts = count > 0 ? count : 1;
    }
    job all = {work, context, count, parts};
    taut_system_threads(parts, run_part, &all);
}

/* What the workers share: a counter from which each takes the next task. */
typedef struct crew {
    atomic_long next;
    int64_t tasks;
    taut_task *run;
    void *context;
} crew;

int taut_parallel_workers(int threads, int64_t tasks)
{
    const int64_t limit = threads > TAUT_THREADS_MAX ? TAUT_THREADS_MAX : threads;
    const int64_t workers = tasks < limit ? tasks : limit;
    return workers < 1 ? 1 : (int)workers;
}

static void take_tasks(void *context, int worker, int from, int to)
{
    crew *all = context;
    (void)from;
    (void)to;
    for (int64_t task = atomic_fetch_add(&all->next, 1); task < all->tasks;
         task = atomic_fetch_add(&all->next, 1)) {
        all->run(all->context, worker, task);
    }
}

void taut_parallel_run(int workers, int64_t tasks, taut_task *run, void *context)
{
    crew all = {.tasks = tasks, .run = run, .context = context};
    atomic_init(&all.next, 0);
    taut_parallel_for(workers, workers, take_tasks, &all);
}
