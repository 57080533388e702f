/* name.h -- which instruction set is in use, for rooms that have kernels of their own. */
#ifndef TAUT_NUMERIC_KERNEL_NAME_H
#define TAUT_NUMERIC_KERNEL_NAME_H

/* "baseline", "avx2" or "avx512": the best that this processor has, or the one that the environment
 * variable TAUT_KERNEL names if the processor has it. */
const char *taut_kernel_name(void);

#endif /* TAUT_NUMERIC_KERNEL_NAME_H */
