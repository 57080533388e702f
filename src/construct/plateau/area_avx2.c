/* area_avx2.c -- the kernels of the area for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define AREA_LANES 4
#define AREA_SQRT(v) ((lanes)_mm256_sqrt_pd((__m256d)(v)))
#include "construct/plateau/area_kernel_body.h"

const taut_area_ops taut_area_avx2 = AREA_OPS("avx2");
#else
extern int taut_area_avx2_is_for_x86;
#endif
