/* eight_avx2.c -- the kernels of eight.h for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define EIGHT_LANES 4
#define EIGHT_SQRT(v) ((lanes)_mm256_sqrt_pd((__m256d)(v)))
#include "measure/integrate/eight_body.h"

const taut_eight_ops taut_eight_avx2 = EIGHT_OPS("avx2");
#else
extern int taut_eight_avx2_is_for_x86;
#endif
