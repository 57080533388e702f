/* kernel_body.h -- the loops of kernel.h in terms of simd_*.h, which is included before. */
#ifndef __clang__
/* Carrying values from one turn of a loop to the next costs more stores than it saves loads here.
 */
#pragma GCC optimize("no-predictive-commoning")
#endif

#include "numeric/kernel/kernel.h"

#include <string.h>

enum {
    LANES = V_SIZE * GROUPS,
    TILE_COLUMNS = V_SIZE * TILE_GROUPS,
    WIDTH_FIXED = 5 /* half-widths that have loops of their own */
};

#define INLINE static inline __attribute__((always_inline)) TARGET

INLINE v_double v_load(const double *from)
{
    v_double v;
    memcpy(&v, from, sizeof v);
    return v;
}

INLINE void v_store(double *to, v_double v)
{
    memcpy(to, &v, sizeof v);
}

/* Where `mask` is all ones a, where it is all zeros b. */
typedef long long v_mask __attribute__((vector_size(V_SIZE * 8)));

INLINE v_mask v_all_bits(long long bits)
{
    return (v_mask){0} + bits;
}

INLINE v_double v_select(v_mask mask, v_double a, v_double b)
{
    return (v_double)((mask & (v_mask)a) | (~mask & (v_mask)b));
}

/* a, or `limit` with the sign of a where |a| is less. */
INLINE v_double v_away_from_zero(v_double a, v_double limit)
{
    const v_mask sign = (v_mask)v_all(-0.0);
    const v_double size = (v_double)(~sign & (v_mask)a);
    return (v_double)((v_mask)v_max(size, limit) | (sign & (v_mask)a));
}

#include "numeric/kernel/band_body.h"
#include "numeric/kernel/tile_body.h"
#include "numeric/kernel/vector_body.h"

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

extern const taut_kernel JOIN(taut_kernel_, SUFFIX);
const taut_kernel JOIN(taut_kernel_, SUFFIX) = {
    .name = TEXT(SUFFIX),
    .lanes = LANES,
    .tile_rows = TILE_ROWS,
    .tile_columns = TILE_COLUMNS,
    .tile = tile,
    .pack = pack,
    .band_factor = band_factor,
    .band_substitute = band_substitute,
    .band_pencil = band_pencil,
    .lane_dot = lane_dot,
    .lane_product = lane_product,
    .dot = dot,
    .diagonals_multiply = diagonals_multiply,
    .add_scaled = add_scaled,
    .add_products = add_products,
    .add_scaled_exactly = add_scaled_exactly,
    .add_products_exactly = add_products_exactly,
};
