/* carrier_cells.c
 *
 *     of each span the functions alive there as polynomials about its middle, from their derivatives
 *     c_ij = sum_ab U_i,a V_j,b P_ab
 *     at a place: carrier_cells_body.h
 */
#include "trace/carrier_cells.h"

#include "basis/basis_ops.h"
#include "numeric/kernel/name.h"
#include "trace/carrier_cells_ops.h"

#include <stdint.h>
#include <string.h>

enum { DEGREE = TAUT_CARRIER_CELLS_DEGREE, POWERS = DEGREE + 1, ORDERS = TAUT_ORDER_MAX + 1 };
/* The most memory for them, in doubles: 16,384 bicubic cells. */
static const double most = 1 << 20;

struct taut_carrier_cells {
    const taut_carrier_cells_ops *ops; /* for this processor */
    int degree[2];
    int columns;   /* cells along v */
    size_t stride; /* doubles a cell */
    const double *breaks[2];
    const double *list; /* [cell][degree[0] + 1][degree[1] + 1][4] */
};

static const taut_carrier_cells_ops *chosen_ops(void)
{
#if defined(__x86_64__)
    if (!taut_kernel_is("baseline")) {
        return &taut_carrier_cells_avx2;
    }
#endif
    return &taut_carrier_cells_baseline;
}

static int is_low(const taut_basis *basis)
{
    return basis->shape.degree >= 1 && basis->shape.degree <= DEGREE &&
           basis->shape.local == basis->shape.degree + 1;
}

/* rows[k][a]: the coefficient of s^k of the a-th function alive on the span, s in [-1, 1] across it.
 * Those above the cubic one are those of the third derivative, which is 6 c3 + 24 c4 s + 60 c5 s^2. */
static void span_powers(const taut_basis *basis, int span, double rows[POWERS][POWERS])
{
    const int p = basis->shape.degree, local = p + 1;
    const double *breaks = basis->breaks + span;
    const double half = (breaks[1] - breaks[0]) / 2;
    const double at[3] = {breaks[0] + half, breaks[0], breaks[1]};
    double values[3][ORDERS * POWERS];
    double factor = 1;

    for (int k = 0; k < (p > TAUT_ORDER_MAX ? 3 : 1); k++) {
        basis->ops->eval(basis, span, at[k], p < TAUT_ORDER_MAX ? p : TAUT_ORDER_MAX, values[k]);
    }
    for (int k = 0; k <= p && k <= TAUT_ORDER_MAX; k++) {
        factor = k > 0 ? factor * half / k : 1;
        for (int a = 0; a < local; a++) {
            rows[k][a] = values[0][k * local + a] * factor;
        }
    }
    for (int a = 0; p > TAUT_ORDER_MAX && a < local; a++) {
        const int third = TAUT_ORDER_MAX * local + a;
        const double cube = half * half * half;
        const double middle = values[0][third] * cube;
        const double low = values[1][third] * cube, high = values[2][third] * cube;
        rows[4][a] = (high - low) / 48;
        if (p > 4) {
            rows[5][a] = ((low + high) / 2 - middle) / 60;
        }
    }
}

/* One cell: c[i][j][4]. */
static void fill_cell(const taut_basis *const basis[2], const int span[2], const double *net,
                      double u[POWERS][POWERS], double v[POWERS][POWERS], double *c)
{
    const int p = basis[0]->shape.degree, q = basis[1]->shape.degree;
    const int64_t columns = basis[1]->shape.count;
    double rows[POWERS * POWERS * 4] = {0};

    for (int a = 0; a <= p; a++) {
        const double *from =
            net + 4 * ((basis[0]->first[span[0]] + a) * columns + basis[1]->first[span[1]]);
        for (int j = 0; j <= q; j++) {
            for (int b = 0; b <= q; b++) {
                for (int k = 0; k < 4; k++) {
                    rows[4 * (a * (q + 1) + j) + k] += v[j][b] * from[4 * b + k];
                }
            }
        }
    }
    memset(c, 0, (size_t)((p + 1) * (q + 1) * 4) * sizeof *c);
    for (int i = 0; i <= p; i++) {
        for (int a = 0; a <= p; a++) {
            for (int k = 0; k < 4 * (q + 1); k++) {
                c[4 * i * (q + 1) + k] += u[i][a] * rows[4 * a * (q + 1) + k];
            }
        }
    }
}

taut_status taut_carrier_cells_new(taut_arena *arena, const taut_basis *const basis[2],
                                   const double *net, const taut_carrier_cells **cells)
{
    *cells = NULL;
    if (!is_low(basis[0]) || !is_low(basis[1])) {
        return TAUT_OK;
    }
    const int spans[2] = {basis[0]->shape.span_count, basis[1]->shape.span_count};
    const size_t stride =
        4 * (size_t)(basis[0]->shape.degree + 1) * (size_t)(basis[1]->shape.degree + 1);
    const double need = (double)spans[0] * spans[1] * (double)stride;
    if (need > most) {
        return TAUT_OK;
    }
    taut_carrier_cells *made = taut_arena_take(arena, 1, sizeof *made);
    double *list = taut_arena_take_raw(arena, (size_t)need, sizeof *list);
    double(*u)[POWERS][POWERS] = taut_arena_take_raw(arena, (size_t)spans[0], sizeof *u);
    double(*v)[POWERS][POWERS] = taut_arena_take_raw(arena, (size_t)spans[1], sizeof *v);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < spans[0]; i++) {
        span_powers(basis[0], i, u[i]);
    }
    for (int j = 0; j < spans[1]; j++) {
        span_powers(basis[1], j, v[j]);
    }
    for (int i = 0; i < spans[0]; i++) {
        for (int j = 0; j < spans[1]; j++) {
            const int span[2] = {i, j};
            fill_cell(basis, span, net, u[i], v[j],
                      list + ((size_t)i * (size_t)spans[1] + (size_t)j) * stride);
        }
    }
    *made = (taut_carrier_cells){.ops = chosen_ops(),
                                 .degree = {basis[0]->shape.degree, basis[1]->shape.degree},
                                 .columns = spans[1],
                                 .stride = stride,
                                 .breaks = {basis[0]->breaks, basis[1]->breaks},
                                 .list = list};
    *cells = made;
    return TAUT_OK;
}

void taut_carrier_cells_at(const taut_carrier_cells *cells, const int span[2], const double at[2],
                           int order, double (*x)[3], double *weights)
{
    const double *list =
        cells->list + ((size_t)span[0] * (size_t)cells->columns + (size_t)span[1]) * cells->stride;
    double s[2], inverse[2];

    for (int d = 0; d < 2; d++) {
        const double *breaks = cells->breaks[d] + span[d];
        const double half = (breaks[1] - breaks[0]) / 2;
        inverse[d] = 1 / half;
        s[d] = (at[d] - (breaks[0] + half)) * inverse[d];
    }
    cells->ops->at(cells->degree, list, s, inverse, order, x, weights);
}
