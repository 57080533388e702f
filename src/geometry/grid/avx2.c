/* avx2.c -- grid kernels for AVX2 (this file is compiled for it). */
#if defined(__x86_64__)
#include <immintrin.h>

#define GRID_LANES 4
#define GRID_STREAM(pointer, value) _mm256_stream_pd(pointer, (__m256d)(value))
#define GRID_STREAMS 1
#define GRID_FENCE() _mm_sfence()
#include "geometry/grid/kernel_body.h"

const taut_grid_ops taut_grid_avx2 = GRID_OPS("avx2");
#else
extern int taut_grid_avx2_is_for_x86;
#endif
