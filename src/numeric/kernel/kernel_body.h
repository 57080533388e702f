/* kernel_body.h -- the loops of kernel.h in terms of a processor: baseline.c, avx2.c, avx512.c
 * define that before they include this file. */
#ifndef __clang__
/* Carrying values from one turn of a loop to the next costs more stores than it saves loads here.
 */
#pragma GCC optimize("no-predictive-commoning")
#endif

#include "numeric/kernel/kernel.h"

#include <stdint.h>
#include <string.h>

enum {
    LANES = TAUT_LANES,
    BLOCK = V_SIZE * GROUPS, /* lanes in registers together; a whole number of them are LANES */
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

/* a b + c and c - a b, rounded twice: a fused operation would round once, where the set has one. */
INLINE v_double v_add_product(v_double a, v_double b, v_double c)
{
    return a * b + c;
}

INLINE v_double v_less_product(v_double a, v_double b, v_double c)
{
    return c - a * b;
}

/* The rounding error of p = a b, by splitting both factors in halves ([Dekker1971]). */
INLINE v_double v_product_error(v_double a, v_double b, v_double p)
{
    const v_double split = v_all(0x1p27 + 1.0);
    const v_double a_high = split * a - (split * a - a), b_high = split * b - (split * b - b);
    const v_double a_low = a - a_high, b_low = b - b_high;
    return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

/* Where `mask` is all ones a, where it is all zeros b. */
typedef int64_t v_mask __attribute__((vector_size(V_SIZE * 8)));

INLINE v_mask v_all_bits(int64_t bits)
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

/* ---- matrix products: a TILE_ROWS x TILE_COLUMNS block stays in registers while `depth` rank-one
 * terms are added to it ---- */

TARGET static void tile(size_t depth, const double *a, const double *b, double *c, size_t c_stride)
{
    v_double sum[TILE_ROWS][TILE_GROUPS];

#pragma GCC unroll 8
    for (int r = 0; r < TILE_ROWS; r++) {
#pragma GCC unroll 8
        for (int g = 0; g < TILE_GROUPS; g++) {
            sum[r][g] = v_load(c + (size_t)r * c_stride + (size_t)g * V_SIZE);
        }
    }
    for (size_t k = 0; k < depth; k++) {
        v_double bk[TILE_GROUPS];
#pragma GCC unroll 8
        for (int g = 0; g < TILE_GROUPS; g++) {
            bk[g] = v_load(b + g * V_SIZE);
        }
#pragma GCC unroll 8
        for (int r = 0; r < TILE_ROWS; r++) {
            const v_double ar = v_all(a[r]);
#pragma GCC unroll 8
            for (int g = 0; g < TILE_GROUPS; g++) {
                sum[r][g] = v_add_product(ar, bk[g], sum[r][g]);
            }
        }
        a += TILE_ROWS;
        b += TILE_COLUMNS;
    }
#pragma GCC unroll 8
    for (int r = 0; r < TILE_ROWS; r++) {
        double *row = c + (size_t)r * c_stride;
#pragma GCC unroll 8
        for (int g = 0; g < TILE_GROUPS; g++) {
            v_store(row + g * V_SIZE, sum[r][g]);
        }
    }
}

TARGET static void pack(size_t units, const double *from, size_t to_stride, double *to)
{
    for (size_t q = 0; q < units; q++, from += TILE_COLUMNS, to += to_stride) {
        for (int g = 0; g < TILE_GROUPS; g++) {
            v_store(to + g * V_SIZE, v_load(from + g * V_SIZE));
        }
    }
}

/* ---- long vectors of any length and alignment ---- */

#ifndef v_load_some /* where the set has no masks */
/* The last count % V_SIZE entries, filled up with zeros. */
INLINE v_double v_load_some(const double *from, size_t count)
{
    v_double v = v_all(0.0);
    memcpy(&v, from, count * sizeof *from);
    return v;
}

INLINE void v_store_some(double *to, v_double v, size_t count)
{
    memcpy(to, &v, count * sizeof *to);
}
#endif

/* Term i goes to sum i % DOT_LANES, at every width of vectors; halves are added to halves. */
enum { DOT_LANES = 16, DOT_GROUPS = DOT_LANES / V_SIZE };

TARGET static double dot(size_t count, const double *x, const double *y)
{
    v_double sum[DOT_GROUPS];
    size_t i = 0;
#pragma GCC unroll 8
    for (int g = 0; g < DOT_GROUPS; g++) {
        sum[g] = v_all(0.0);
    }
    for (; i + DOT_LANES <= count; i += DOT_LANES) {
#pragma GCC unroll 8
        for (int g = 0; g < DOT_GROUPS; g++) {
            sum[g] = v_add_product(v_load(x + i + g * V_SIZE), v_load(y + i + g * V_SIZE), sum[g]);
        }
    }
#pragma GCC unroll 8
    for (int g = 0; g < DOT_GROUPS; g++) {
        const size_t at = i + (size_t)g * V_SIZE;
        if (at < count) {
            const size_t some = count - at < V_SIZE ? count - at : V_SIZE;
            sum[g] = v_add_product(v_load_some(x + at, some), v_load_some(y + at, some), sum[g]);
        }
    }
#pragma GCC unroll 8
    for (int half = DOT_GROUPS / 2; half > 0; half /= 2) {
#pragma GCC unroll 8
        for (int g = 0; g < half; g++) {
            sum[g] += sum[half + g];
        }
    }
    return v_fold(sum[0]); /* the lower half and the upper one, again */
}

/* Row i of the product; what lies outside the matrix is left out. */
INLINE double diagonals_row(size_t n, size_t width, const double *a, const double *x, size_t i)
{
    double sum = a[i] * x[i];
    for (size_t d = 1; d <= width; d++) {
        sum += d <= i ? a[d * n + i] * x[i - d] : 0.0;
        sum += d < n - i ? a[d * n + i + d] * x[i + d] : 0.0;
    }
    return sum;
}

TARGET static void diagonals_multiply(size_t n, size_t width, const double *a, const double *x,
                                      double *y)
{
    size_t i = 0;
    for (; i < n && i < width; i++) {
        y[i] = diagonals_row(n, width, a, x, i);
    }
    for (; i + V_SIZE + width <= n; i += V_SIZE) {
        v_double sum = v_load(a + i) * v_load(x + i);
        for (size_t d = 1; d <= width; d++) {
            sum = v_add_product(v_load(a + d * n + i), v_load(x + i - d), sum);
            sum = v_add_product(v_load(a + d * n + i + d), v_load(x + i + d), sum);
        }
        v_store(y + i, sum);
    }
    for (; i < n; i++) {
        y[i] = diagonals_row(n, width, a, x, i);
    }
}

TARGET static void add_scaled(size_t count, double factor, const double *x, double *y)
{
    const v_double f = v_all(factor);
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_store(y + i, v_add_product(f, v_load(x + i), v_load(y + i)));
    }
    const v_double last =
        v_add_product(f, v_load_some(x + i, count - i), v_load_some(y + i, count - i));
    v_store_some(y + i, last, count - i);
}

TARGET static void add_products(size_t count, const double *c, const double *x, double *y)
{
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_store(y + i, v_add_product(v_load(c + i), v_load(x + i), v_load(y + i)));
    }
    const v_double last =
        v_add_product(v_load_some(c + i, count - i), v_load_some(x + i, count - i),
                      v_load_some(y + i, count - i));
    v_store_some(y + i, last, count - i);
}

/* high + low += a b + extra: the product and the sum are taken with their rounding errors
 * ([Dekker1971], [Knuth1998] 4.2.2), which go to low. */
INLINE void add_exactly(v_double a, v_double b, v_double extra, v_double *high, v_double *low)
{
    const v_double product = a * b;
    const v_double sum = *high + product;
    const v_double moved = sum - *high;
    const v_double error = (*high - (sum - moved)) + (product - moved);
    *low += (error + v_product_error(a, b, product)) + extra;
    *high = sum;
}

TARGET static void add_scaled_exactly(size_t count, double factor, const double *x,
                                      const double *x_low, double *high, double *low)
{
    const v_double f = v_all(factor);
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_double h = v_load(high + i), l = v_load(low + i);
        add_exactly(f, v_load(x + i), f * v_load(x_low + i), &h, &l);
        v_store(high + i, h);
        v_store(low + i, l);
    }
    v_double h = v_load_some(high + i, count - i), l = v_load_some(low + i, count - i);
    const v_double tail = f * v_load_some(x_low + i, count - i);
    add_exactly(f, v_load_some(x + i, count - i), tail, &h, &l);
    v_store_some(high + i, h, count - i);
    v_store_some(low + i, l, count - i);
}

TARGET static void add_products_exactly(size_t count, const double *c, const double *x,
                                        double *high, double *low)
{
    const v_double none = v_all(0.0);
    size_t i = 0;
    for (; i + V_SIZE <= count; i += V_SIZE) {
        v_double h = v_load(high + i), l = v_load(low + i);
        add_exactly(v_load(c + i), v_load(x + i), none, &h, &l);
        v_store(high + i, h);
        v_store(low + i, l);
    }
    v_double h = v_load_some(high + i, count - i), l = v_load_some(low + i, count - i);
    add_exactly(v_load_some(c + i, count - i), v_load_some(x + i, count - i), none, &h, &l);
    v_store_some(high + i, h, count - i);
    v_store_some(low + i, l, count - i);
}

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

extern const taut_kernel JOIN(taut_kernel_, SUFFIX);
const taut_kernel JOIN(taut_kernel_, SUFFIX) = {
    .name = TEXT(SUFFIX),
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
