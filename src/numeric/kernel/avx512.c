/* avx512.c -- eight doubles at a time. */
#if defined(__x86_64__)
#include <immintrin.h>

#define TARGET __attribute__((target("avx512f,avx512dq,avx512vl,avx2")))
#define SUFFIX avx512
enum { V_SIZE = 8, GROUPS = 3, TILE_ROWS = 8, TILE_GROUPS = 3 };
typedef double v_double __attribute__((vector_size(64)));

#define v_max(a, b) _mm512_max_pd((a), (b))
#define v_all(x) _mm512_set1_pd(x)

#include "numeric/kernel/kernel_body.h"
#else
extern int taut_kernel_avx512_is_absent; /* a translation unit may not be empty */
#endif
