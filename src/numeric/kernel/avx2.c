#if defined(__x86_64__)
#include "numeric/kernel/simd_avx2.h"

#include "numeric/kernel/kernel_body.h"
#else
extern int taut_kernel_avx2_is_absent; /* a translation unit may not be empty */
#endif
