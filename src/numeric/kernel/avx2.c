/* avx2.c -- four doubles at a time, fused multiply-add. */
#if defined(__x86_64__)
#include <immintrin.h>

#define TARGET __attribute__((target("avx2,fma")))
#define SUFFIX avx2
enum { V_SIZE = 4, GROUPS = 3, TILE_ROWS = 4, TILE_GROUPS = 3 };
typedef double v_double __attribute__((vector_size(32)));

#define v_fma(a, b, c) _mm256_fmadd_pd((a), (b), (c))
#define v_fnma(a, b, c) _mm256_fnmadd_pd((a), (b), (c))
#define v_max(a, b) _mm256_max_pd((a), (b))
#define v_all(x) _mm256_set1_pd(x)
/* the rounding error of p = a b */
#define v_product_error(a, b, p) _mm256_fmsub_pd((a), (b), (p))

#include "numeric/kernel/kernel_body.h"
#else
extern int taut_kernel_avx2_is_absent; /* a translation unit may not be empty */
#endif
