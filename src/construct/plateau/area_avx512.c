/* area_avx512.c -- a film's kernels for AVX-512F (this file is compiled for it, with contraction).
 */
#if defined(__x86_64__)
#include <immintrin.h>

#define FILM_LANES 8
#define FILM_SQRT(v) ((lanes)_mm512_sqrt_pd((__m512d)(v)))
#include "construct/plateau/area_kernel_body.h"

const taut_film_ops taut_film_avx512 = FILM_OPS("avx512");
#else
extern int taut_film_avx512_is_for_x86;
#endif
