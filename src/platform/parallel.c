#include "platform/parallel.h"

#include "taut/limits.h"

#include <pthread.h>
#include <stdatomic.h>

typedef struct job {
    void (*work)(void *context, int part, int from, int to);
    void *context;
    int part, from, to;
} job;

static void *run_job(void *argument)
{
    const job *j = argument;
    j->work(j->context, j->part, j->from, j->to);
    return NULL;
}

void taut_parallel_for(int count, int threads,
                       void (*work)(void *context, int part, int from, int to), void *context)
{
    job jobs[TAUT_THREADS_MAX];
    pthread_t handles[TAUT_THREADS_MAX];
    int started[TAUT_THREADS_MAX];
    int parts = threads < 1 ? 1 : threads > TAUT_THREADS_MAX ? TAUT_THREADS_MAX : threads;

    if (parts > count) {
        parts = count > 0 ? count : 1;
    }
    for (int p = parts - 1; p >= 0; p--) {
        const int from = (int)((long)count * p / parts), to = (int)((long)count * (p + 1) / parts);
        jobs[p] = (job){work, context, p, from, to};
        started[p] = p > 0 && pthread_create(&handles[p], NULL, run_job, &jobs[p]) == 0;
        if (!started[p]) {
            run_job(&jobs[p]);
        }
    }
    for (int p = 1; p < parts; p++) {
        if (started[p]) {
            pthread_join(handles[p], NULL);
        }
    }
}

/* What the workers share: a counter from which each takes the next task. */
typedef struct crew {
    atomic_long next;
    long tasks;
    taut_task *run;
    void *context;
} crew;

int taut_parallel_workers(int threads, long tasks)
{
    const long limit = threads > TAUT_THREADS_MAX ? TAUT_THREADS_MAX : threads;
    const long workers = tasks < limit ? tasks : limit;
    return workers < 1 ? 1 : (int)workers;
}

static void take_tasks(void *context, int worker, int from, int to)
{
    crew *all = context;
    (void)from;
    (void)to;
    for (long task = atomic_fetch_add(&all->next, 1); task < all->tasks;
         task = atomic_fetch_add(&all->next, 1)) {
        all->run(all->context, worker, task);
    }
}

void taut_parallel_run(int workers, long tasks, taut_task *run, void *context)
{
    crew all = {.tasks = tasks, .run = run, .context = context};
    atomic_init(&all.next, 0);
    taut_parallel_for(workers, workers, take_tasks, &all);
}
