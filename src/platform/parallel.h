/* parallel.h -- independent work on several threads.
 *
 * Each part writes to a place of its own, which the caller adds up in order, so that results do not
 * depend on the number of threads.
 */
#ifndef TAUT_PLATFORM_PARALLEL_H
#define TAUT_PLATFORM_PARALLEL_H

#include <stdint.h>

/* Calls work(context, part, from, to) for parts of [0, count), each on a thread of its own (the
 * first on this one); part is 0..threads-1. The split depends on count and threads only. If a
 * thread can't be started its part is done here. */
void taut_parallel_for(int count, int threads,
                       void (*work)(void *context, int part, int from, int to), void *context);

/* `worker` is 0 .. workers-1, for scratch that is the thread's own. */
typedef void taut_task(void *context, int worker, int64_t task);

/* How many workers `tasks` tasks get when `threads` are asked for: at least 1, at most either. */
int taut_parallel_workers(int threads, int64_t tasks);

/* Runs tasks 0 .. tasks-1, of unequal length: each of `workers` threads, the caller's among them,
 * takes the next one until none is left. Where the system grants no more threads, those there are
 * do the work. Returns when all tasks are done. */
void taut_parallel_run(int workers, int64_t tasks, taut_task *run, void *context);

#endif /* TAUT_PLATFORM_PARALLEL_H */
