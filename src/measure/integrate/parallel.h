/* parallel.h -- independent tasks on several threads.
 *
 * Each task writes to a place of its own, which the caller adds up in the order of the tasks, so
 * that results do not depend on the number of threads.
 */
#ifndef TAUT_MEASURE_INTEGRATE_PARALLEL_H
#define TAUT_MEASURE_INTEGRATE_PARALLEL_H

/* `worker` is 0 .. threads-1, for scratch that is the thread's own. */
typedef void taut_task(void *context, int worker, long task);

/* How many workers `tasks` tasks get when `threads` are asked for: at least 1, at most either. */
int taut_parallel_workers(int threads, long tasks);

/* Runs tasks 0 .. tasks-1 on `workers` threads, the caller's among them; where the system grants no
 * more threads, those there are do the work. Returns when all tasks are done. */
void taut_parallel_run(int workers, long tasks, taut_task *run, void *context);

#endif /* TAUT_MEASURE_INTEGRATE_PARALLEL_H */
