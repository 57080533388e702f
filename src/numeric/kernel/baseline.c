/* baseline.c -- two doubles at a time, on any processor. */
#define TARGET
#define SUFFIX baseline
enum { V_SIZE = 2, GROUPS = 2, TILE_ROWS = 4, TILE_GROUPS = 2 };
typedef double v_double __attribute__((vector_size(16)));

/* the same number in every place */
#define v_all(x) ((v_double){(x), (x)})

static inline v_double v_max(v_double a, v_double b)
{
    return (v_double){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}

static inline double v_fold(v_double v)
{
    return v[0] + v[1];
}

#include "numeric/kernel/kernel_body.h"
