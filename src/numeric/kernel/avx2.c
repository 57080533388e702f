/* avx2.c -- four doubles at a time. */
#if defined(__x86_64__)
#include <immintrin.h>

#define TARGET __attribute__((target("avx2")))
#define SUFFIX avx2
enum { V_SIZE = 4, GROUPS = 3, TILE_ROWS = 4, TILE_GROUPS = 3 };
typedef double v_double __attribute__((vector_size(32)));

#define v_max(a, b) _mm256_max_pd((a), (b))
#define v_all(x) _mm256_set1_pd(x)

#include "numeric/kernel/kernel_body.h"
#else
extern int taut_kernel_avx2_is_absent; /* a translation unit may not be empty */
#endif
