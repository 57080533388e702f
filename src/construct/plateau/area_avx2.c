/* area_avx2.c -- a film's kernels for AVX2 and FMA (this file is compiled for them, with
 * contraction). */
#if defined(__x86_64__)
#include <immintrin.h>

#define FILM_LANES 4
#define FILM_SQRT(v) ((lanes)_mm256_sqrt_pd((__m256d)(v)))
#include "construct/plateau/area_kernel_body.h"

const taut_film_ops taut_film_avx2 = FILM_OPS("avx2");
#else
extern int taut_film_avx2_is_for_x86;
#endif
