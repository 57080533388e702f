/* baseline.c -- two doubles at a time, on any processor. */
#define TARGET
#define SUFFIX baseline
enum { V_SIZE = 2, GROUPS = 2, TILE_ROWS = 4, TILE_GROUPS = 2 };
typedef double v_double __attribute__((vector_size(16)));

/* a b + c, c - a b, and the same number in every place */
#define v_fma(a, b, c) ((a) * (b) + (c))
#define v_fnma(a, b, c) ((c) - (a) * (b))
#define v_all(x) ((v_double){(x), (x)})

static inline v_double v_max(v_double a, v_double b)
{
    return (v_double){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}

/* The rounding error of p = a b, by splitting both factors in halves ([Dekker1971]). */
static inline v_double v_product_error(v_double a, v_double b, v_double p)
{
    const v_double split = v_all(0x1p27 + 1.0);
    const v_double a_high = split * a - (split * a - a), b_high = split * b - (split * b - b);
    const v_double a_low = a - a_high, b_low = b - b_high;
    return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

#include "numeric/kernel/kernel_body.h"
