/* parallel.c -- workers take the next task from a common counter until none is left. */
#include "measure/integrate/parallel.h"

#include "taut/limits.h"

#include <pthread.h>
#include <stdatomic.h>

typedef struct crew {
    atomic_long next;
    long tasks;
    taut_task *run;
    void *context;
} crew;

typedef struct member {
    crew *crew;
    int worker;
    pthread_t thread;
} member;

int taut_parallel_workers(int threads, long tasks)
{
    const long limit = threads > TAUT_THREADS_MAX ? TAUT_THREADS_MAX : threads;
    const long workers = tasks < limit ? tasks : limit;
    return workers < 1 ? 1 : (int)workers;
}

static void *work(void *argument)
{
    const member *self = argument;
    crew *all = self->crew;
    for (;;) {
        const long task = atomic_fetch_add(&all->next, 1);
        if (task >= all->tasks) {
            return NULL;
        }
        all->run(all->context, self->worker, task);
    }
}

void taut_parallel_run(int workers, long tasks, taut_task *run, void *context)
{
    member members[TAUT_THREADS_MAX];
    crew all = {.tasks = tasks, .run = run, .context = context};
    int started = 1;

    atomic_init(&all.next, 0);
    members[0] = (member){.crew = &all, .worker = 0};
    for (int i = 1; i < workers && i < TAUT_THREADS_MAX; i++) {
        members[i] = (member){.crew = &all, .worker = i};
        if (pthread_create(&members[i].thread, NULL, work, &members[i]) != 0) {
            break;
        }
        started++;
    }
    work(&members[0]);
    for (int i = 1; i < started; i++) {
        pthread_join(members[i].thread, NULL);
    }
}
