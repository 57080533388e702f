/* gradient_avx2.c -- the kernels of gradient.c for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define SHEAF_LANES 4
#define SHEAF_SQRT(v) ((lanes)_mm256_sqrt_pd((__m256d)(v)))
#include "certify/dirichlet/gradient_kernel_body.h"

const taut_gradient_ops taut_gradient_avx2 = GRADIENT_OPS("avx2");
#else
extern int taut_gradient_avx2_is_for_x86;
#endif
