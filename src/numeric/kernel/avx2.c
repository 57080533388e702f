/* avx2.c -- four doubles at a time. */
#if defined(__x86_64__)
#include <immintrin.h>
#include <stddef.h>
#include <stdint.h>

#define TARGET __attribute__((target("avx2")))
#define SUFFIX avx2
enum { V_SIZE = 4, GROUPS = 3, TILE_ROWS = 4, TILE_GROUPS = 3 };
typedef double v_double __attribute__((vector_size(32)));

#define v_max(a, b) _mm256_max_pd((a), (b))
#define v_all(x) _mm256_set1_pd(x)
#define v_load_some(from, count) _mm256_maskload_pd((from), v_some(count))
#define v_store_some(to, v, count) _mm256_maskstore_pd((to), v_some(count), (v))

/* All ones in the first places. */
static inline TARGET __m256i v_some(size_t count)
{
    static const int64_t ones[8] = {-1, -1, -1, -1, 0, 0, 0, 0};
    return _mm256_loadu_si256((const __m256i *)(const void *)(ones + V_SIZE - count));
}

static inline TARGET double v_fold(v_double v)
{
    const __m128d two = _mm256_castpd256_pd128(v) + _mm256_extractf128_pd(v, 1);
    return two[0] + two[1];
}

#include "numeric/kernel/kernel_body.h"
#else
extern int taut_kernel_avx2_is_absent; /* a translation unit may not be empty */
#endif
