/* name.h -- which instruction set is in use, for rooms that have kernels of their own. */
#ifndef TAUT_NUMERIC_KERNEL_NAME_H
#define TAUT_NUMERIC_KERNEL_NAME_H

/* "baseline", "avx2" or "avx512": the best that this processor has, or the one that the environment
 * variable TAUT_KERNEL names if the processor has it. */
const char *taut_kernel_name(void);

/* The operations in use among set_baseline, set_avx2 and set_avx512, which a room declares as structs of one type. */
#if defined(__x86_64__)
#define TAUT_KERNEL_OF(set)                                                                        \
    (taut_kernel_is("avx512") ? &set##_avx512                                                      \
     : taut_kernel_is("avx2") ? &set##_avx2                                                        \
                              : &set##_baseline)
#else
#define TAUT_KERNEL_OF(set) (&set##_baseline)
#endif

/* Whether taut_kernel_name() is this one. */
int taut_kernel_is(const char *name);

#endif /* TAUT_NUMERIC_KERNEL_NAME_H */
