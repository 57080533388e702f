/* machine.h -- clocks and the machine's own limits, measured in the run that uses them. */
#ifndef TAUT_BENCH_MACHINE_H
#define TAUT_BENCH_MACHINE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

double bench_cpu_seconds(void); /* of this process, all threads */
double bench_wall_seconds(void);
/* The processor's name, in a static buffer. */
const char *bench_processor(void);
/* Bytes a second that one thread writes past the caches into a buffer of this many bytes that it
 * has touched before; best of three. */
double bench_store_rate(double *buffer, size_t bytes);
/* Double-precision operations a second of one thread in fused multiply-adds that never leave the
 * registers, with the widest vectors there are. */
double bench_fma_rate(void);

#ifdef __cplusplus
}
#endif

#endif /* TAUT_BENCH_MACHINE_H */
