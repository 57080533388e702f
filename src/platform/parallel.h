/* parallel.h -- splitting a range of independent work among threads. */
#ifndef TAUT_PLATFORM_PARALLEL_H
#define TAUT_PLATFORM_PARALLEL_H

/* Calls work(context, part, from, to) for parts of [0, count), each on a thread of its own (the
 * first on this one); part is 0..threads-1. The split depends on count and threads only. If a
 * thread can't be started its part is done here. */
void taut_parallel_for(int count, int threads,
                       void (*work)(void *context, int part, int from, int to), void *context);

#endif /* TAUT_PLATFORM_PARALLEL_H */
