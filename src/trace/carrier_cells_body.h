/* carrier_cells_body.h -- the loops behind carrier_cells_ops.h, compiled once per instruction set.
 *
 * Horner's rule with derivatives along t of each row, then along s of what comes out. Vectors are gcc's and clang's vector
 * extension, of four where the processor has them, else of two and two.
 */
#include "taut/basis.h"
#include "trace/carrier_cells_ops.h"

#include <stddef.h>
#include <string.h>

enum { POWERS = TAUT_CARRIER_CELLS_DEGREE + 1, ORDERS = TAUT_ORDER_MAX + 1 };

typedef double four __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias));

#define INLINE static inline __attribute__((always_inline))

/* out[k] = sum_i rows[i] (d/ds)^k s^i / k!, k = 0..order; rows are `step` vectors apart. */
INLINE void horner(const four *rows, int degree, int step, double s, const int order, four *out)
{
    for (int k = 0; k <= order; k++) {
        out[k] = (four){0, 0, 0, 0};
    }
    for (int i = degree; i >= 0; i--) {
        for (int k = order; k > 0; k--) {
            out[k] = out[k] * s + out[k - 1];
        }
        out[0] = out[0] * s + rows[i * step];
    }
}

/* horner of degree 3: a sum of order k is nothing before its k-th turn and begins as what it is added to. */
INLINE void horner_cubic(const four *rows, const int step, double s, const int order, four *out)
{
    const four top = rows[3 * step];
    const four value_1 = top * s + rows[2 * step];
    const four value_2 = value_1 * s + rows[step], slope_2 = top * s + value_1;
    out[0] = value_2 * s + rows[0];
    if (order > 0) {
        out[1] = slope_2 * s + value_2;
    }
    if (order > 1) {
        out[2] = top * s + slope_2;
    }
    if (order > 2) {
        out[3] = top;
    }
}

/* The derivatives of order l along t and up to `order` along s, from the rows' own. */
INLINE void combine(const four *rows, int degree, const int is_cubic, double s,
                    const double u[ORDERS], double v, const int l, const int order, double (*x)[3],
                    double *weights)
{
    four column[ORDERS];
    if (is_cubic) {
        horner_cubic(rows + l, ORDERS, s, order, column);
    } else {
        horner(rows + l, degree, ORDERS, s, order, column);
    }
    for (int k = 0; k <= order; k++) {
        const int n = (k + l) * (k + l + 1) / 2 + l;
        const four value = column[k] * (u[k] * v);
        memcpy(x[n], &value, sizeof x[n]);
        weights[n] = value[3];
    }
}

/* `order` and `is_cubic` (both degrees are 3) are constants at each call, so that the loops over derivatives
 * unroll. */
INLINE void evaluate(const int degree[2], const double *c, const double s[2],
                     const double inverse[2], const int order, const int is_cubic, double (*x)[3],
                     double *weights)
{
    const int p = is_cubic ? 3 : degree[0], q = is_cubic ? 3 : degree[1];
    const double a = inverse[0], b = inverse[1];
    const double u[ORDERS] = {1, a, 2 * a * a, 6 * a * a * a};
    const four *list = (const four *)(const void *)c;
    four rows[POWERS * ORDERS];

    for (int i = 0; i <= p; i++) {
        if (is_cubic) {
            horner_cubic(list + i * 4, 1, s[1], order, rows + i * ORDERS);
        } else {
            horner(list + i * (q + 1), q, 1, s[1], order, rows + i * ORDERS);
        }
    }
    combine(rows, p, is_cubic, s[0], u, 1, 0, order, x, weights);
    if (order > 0) {
        combine(rows, p, is_cubic, s[0], u, b, 1, order - 1, x, weights);
    }
    if (order > 1) {
        combine(rows, p, is_cubic, s[0], u, 2 * b * b, 2, order - 2, x, weights);
    }
    if (order > 2) {
        combine(rows, p, is_cubic, s[0], u, 6 * b * b * b, 3, order - 3, x, weights);
    }
}

static void evaluate_at(const int degree[2], const double *c, const double s[2],
                        const double inverse[2], int order, double (*x)[3], double *weights)
{
    const int is_cubic = degree[0] == 3 && degree[1] == 3;
    switch (order) {
    case 0:
        evaluate(degree, c, s, inverse, 0, 0, x, weights);
        break;
    case 1:
        evaluate(degree, c, s, inverse, 1, 0, x, weights);
        break;
    case 2:
        if (is_cubic) {
            evaluate(degree, c, s, inverse, 2, 1, x, weights);
        } else {
            evaluate(degree, c, s, inverse, 2, 0, x, weights);
        }
        break;
    default:
        if (is_cubic) {
            evaluate(degree, c, s, inverse, 3, 1, x, weights);
        } else {
            evaluate(degree, c, s, inverse, 3, 0, x, weights);
        }
    }
}
