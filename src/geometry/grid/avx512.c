/* avx512.c -- grid kernels for AVX-512F (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define GRID_LANES 8
#define GRID_STREAM(pointer, value) _mm256_stream_pd(pointer, (__m256d)(value))
#define GRID_STREAMS 1
#define GRID_FENCE() _mm_sfence()
#include "geometry/grid/kernel_body.h"

const taut_grid_ops taut_grid_avx512 = GRID_OPS("avx512");
#else
extern int taut_grid_avx512_is_for_x86;
#endif
