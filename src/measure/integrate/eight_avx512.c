/* eight_avx512.c -- the kernels of eight.h for AVX-512F (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define EIGHT_LANES 8
#define EIGHT_SQRT(v) ((lanes)_mm512_sqrt_pd((__m512d)(v)))
#include "measure/integrate/eight_body.h"

const taut_eight_ops taut_eight_avx512 = EIGHT_OPS("avx512");
#else
extern int taut_eight_avx512_is_for_x86;
#endif
