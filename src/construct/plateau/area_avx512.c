/* area_avx512.c -- the kernels of the area for AVX-512F (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define AREA_LANES 8
#define AREA_SQRT(v) ((lanes)_mm512_sqrt_pd((__m512d)(v)))
#include "construct/plateau/area_kernel_body.h"

const taut_area_ops taut_area_avx512 = AREA_OPS("avx512");
#else
extern int taut_area_avx512_is_for_x86;
#endif
