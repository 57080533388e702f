/* simd_baseline.h -- two doubles at a time, on any processor. */
#define TARGET
#define SUFFIX baseline
enum { V_SIZE = 2, GROUPS = 2, TILE_ROWS = 4, TILE_GROUPS = 2 };
typedef double v_double __attribute__((vector_size(16)));

/* a b + c, c - a b, and the same number in every place */
#define v_fma(a, b, c) ((a) * (b) + (c))
#define v_fnma(a, b, c) ((c) - (a) * (b))
#define v_all(x) ((v_double){(x), (x)})
