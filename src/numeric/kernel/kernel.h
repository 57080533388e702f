/* kernel.h -- the innermost loops, once per instruction set, chosen when the program runs.
 *
 * Every set is compiled from the same loops (*_body.h), with the vectors that baseline.c, avx2.c and
 * avx512.c give, and fills one const table. Results are the same bit for bit: no set fuses a product with a sum,
 * and what a sum takes in which order does not depend on the width of the vectors. To add a kernel: a member here, its loop in a
 * *_body.h, its line in the table of kernel_body.h, its test in test_kernel.c.
 */
#ifndef TAUT_NUMERIC_KERNEL_H
#define TAUT_NUMERIC_KERNEL_H

#include "numeric/kernel/name.h"

#include <stddef.h>
#include <stdint.h>

enum {
    TAUT_LANES = 24,        /* of every set, or what is solved side by side would tell them apart */
    TAUT_TILE_ROWS_MAX = 8, /* bounds of the members below, for arrays on the stack */
    TAUT_TILE_COLUMNS_MAX = 32
};

/* TAUT_LANES independent problems are solved side by side: lane l of an array double[...][lanes]
 * belongs to problem l. All arrays are aligned to 64 bytes where a row is double[lanes]. */
typedef struct taut_kernel {
    const char *name;
    int tile_rows, tile_columns;

    /* c[r][q] += a[k][r] b[k][q], k = 0, 1, ..., depth - 1,    r < tile_rows, q < tile_columns
     *
     *     a  double[depth][tile_rows]
     *     b  double[depth][tile_columns], aligned to 64
     *     c  row r starts at c + r * c_stride */
    void (*tile)(size_t depth, const double *a, const double *b, double *c, size_t c_stride);

    /* Copies `units` pieces of tile_columns numbers, piece q to to[q * to_stride]; `to` and
     * to_stride are multiples of 64 bytes. */
    void (*pack)(size_t units, const double *from, size_t to_stride, double *to);

    /* L D L^T of  scale K + shift[l] M  for rows first..end-1, lane by lane, no row interchanges
     *
     *     k, m      double[n][width + 1] as in band.h
     *     shift     double[lanes]
     *     tiny      > 0: pivots nearer to zero are moved to tiny or -tiny
     *     factor    double[width + end - first][width + 1][lanes], row i at width + i - first;
     *               slot 0 of a row is 1 / D(i), slot d is L(i, i - d); the first `width` rows
     *               are input, the rows before row `first`, zero where there are none
     *     negative  double[lanes]: gains the number of negative pivots */
    void (*band_factor)(int first, int end, int width, const double *k, const double *m,
                        double scale, const double *shift, double tiny, double *factor,
                        double *negative);

    /* Solves with a factor of rows 0..n-1 in place; x double[n][count][lanes]. */
    void (*band_substitute)(int n, int width, int count, const double *factor, double *x);

    /* r = (K - lambda[l] M) x and mx = M x, all double[n][lanes] and apart
     *
     *     dot  double[3][lanes]: x . mx, x . r, r . r */
    void (*band_pencil)(int n, int width, const double *k, const double *m, const double *lambda,
                        const double *x, double *r, double *mx, double *dot);

    /* xy[l] = x . y and xx[l] = x . x over double[n][lanes]. */
    void (*lane_dot)(int n, const double *x, const double *y, double *xy, double *xx);

    /* mantissa[l] 2^exponent[l] is multiplied by x[i * stride + l], i < n; 1 <= |mantissa| < 2
     * after that. Every |x| must lie between 2^-250 and 2^250. */
    void (*lane_product)(int n, size_t stride, const double *x, double *mantissa,
                         int64_t *exponent);

    /* x . y over `count` entries, in 16 sums. Any alignment, here and below. */
    double (*dot)(size_t count, const double *x, const double *y);

    /* y = A x, x and y double[n] and apart; A symmetric by diagonals, a[d*n + i] = A(i, i - d), d
     * <= width. */
    void (*diagonals_multiply)(size_t n, size_t width, const double *a, const double *x, double *y);

    /* y += factor x, and y += c x entry by entry, over `count` entries. */
    void (*add_scaled)(size_t count, double factor, const double *x, double *y);
    void (*add_products)(size_t count, const double *c, const double *x, double *y);

    /* The same into sums kept as high + low, with an error of about 2^-104 of the terms. */
    void (*add_scaled_exactly)(size_t count, double factor, const double *x, const double *x_low,
                               double *high, double *low);
    void (*add_products_exactly)(size_t count, const double *c, const double *x, double *high,
                                 double *low);
} taut_kernel;

/* The best table for this processor, or the one that the environment variable TAUT_KERNEL names
 * ("baseline", "avx2", "avx512") if the processor has it. Never NULL; cost: a few comparisons. Its name is taut_kernel_name(). */
const taut_kernel *taut_kernel_best(void);
/* The table called `name`, or NULL when there is none or the processor lacks it. */
const taut_kernel *taut_kernel_find(const char *name);

#endif /* TAUT_NUMERIC_KERNEL_H */
