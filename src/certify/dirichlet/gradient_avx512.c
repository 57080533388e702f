/* gradient_avx512.c -- the kernels of gradient.c for AVX-512F (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define SHEAF_LANES 8
#define SHEAF_SQRT(v) ((lanes)_mm512_sqrt_pd((__m512d)(v)))
#include "certify/dirichlet/gradient_kernel_body.h"

const taut_gradient_ops taut_gradient_avx512 = GRADIENT_OPS("avx512");
#else
extern int taut_gradient_avx512_is_for_x86;
#endif
