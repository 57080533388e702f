/* avx512.c -- eight doubles at a time. */
#if defined(__x86_64__)
#include <immintrin.h>

#define TARGET __attribute__((target("avx512f,avx512dq,avx512vl,avx2")))
#define SUFFIX avx512
enum { V_SIZE = 8, GROUPS = 3, TILE_ROWS = 8, TILE_GROUPS = 3 };
typedef double v_double __attribute__((vector_size(64)));

#define v_max(a, b) _mm512_max_pd((a), (b))
#define v_all(x) _mm512_set1_pd(x)
#define v_some(count) ((__mmask8)((1U << (count)) - 1U))
#define v_load_some(from, count) _mm512_maskz_loadu_pd(v_some(count), (from))
#define v_store_some(to, v, count) _mm512_mask_storeu_pd((to), v_some(count), (v))

static inline TARGET double v_fold(v_double v)
{
    const __m256d four = _mm512_castpd512_pd256(v) + _mm512_extractf64x4_pd(v, 1);
    const __m128d two = _mm256_castpd256_pd128(four) + _mm256_extractf128_pd(four, 1);
    return two[0] + two[1];
}

#include "numeric/kernel/kernel_body.h"
#else
extern int taut_kernel_avx512_is_absent; /* a translation unit may not be empty */
#endif
