/* cells_body.h -- the loops behind cells_ops.h, compiled once per instruction set. Vectors are gcc's and clang's vector
 * extension, of four where the processor has them, else of two and two.
 */
#include "certify/trace/cells_ops.h"

#include <stddef.h>
#include <string.h>

enum { CURVE = TAUT_NET_CURVE, SIDE = TAUT_NET_CELL_SIDE };

typedef double four __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias));

#define INLINE static inline __attribute__((always_inline))

/* p and q are constants for cubic cells, here and below, so that the loops unroll. */
INLINE void sum_of(const int p, const int q, const double *points, const double width[2],
                   double u[3][SIDE + 1], double v[3][SIDE + 1], double x[6][3])
{
    const four *list = (const four *)(const void *)points;
    const double factor[6] = {
        1, width[0], width[1], width[0] * width[0], width[0] * width[1], width[1] * width[1]};
    four sum[6] = {{0}};

    for (int i = 0; i <= p; i++) {
        const four *row = list + i * (q + 1);
        four inner[3] = {{0}};
        for (int j = 0; j <= q; j++) {
            inner[0] += row[j] * v[0][j];
            inner[1] += row[j] * v[1][j];
            inner[2] += row[j] * v[2][j];
        }
        sum[0] += u[0][i] * inner[0];
        sum[1] += u[1][i] * inner[0];
        sum[2] += u[0][i] * inner[1];
        sum[3] += u[2][i] * inner[0];
        sum[4] += u[1][i] * inner[1];
        sum[5] += u[0][i] * inner[2];
    }
    for (int k = 0; k < 6; k++) {
        const four value = sum[k] / factor[k];
        memcpy(x[k], &value, sizeof x[k]);
    }
}

INLINE void compose_of(const int p, const int q, const double *x,
                       const taut_net_compose_row *restrict first,
                       const taut_net_compose_row *restrict second, double *restrict out)
{
    for (int k = 0; k <= CURVE * (p + q); k++) {
        out[k] = 0;
    }
    for (int i = 0; i <= p; i++) {
        taut_net_compose_row inner;
        for (int k = 0; k <= CURVE * q; k++) {
            inner[k] = 0;
        }
        for (int j = 0; j <= q; j++) {
            const double factor = x[i * (q + 1) + j];
            for (int k = 0; k <= CURVE * q; k++) {
                inner[k] += factor * second[j][k];
            }
        }
        for (int l = 0; l <= CURVE * p; l++) {
            const double factor = first[i][l];
            for (int k = 0; k <= CURVE * q; k++) {
                out[l + k] += factor * inner[k];
            }
        }
    }
}

static void sum_cell(int p, int q, const double *points, const double width[2],
                     double u[3][SIDE + 1], double v[3][SIDE + 1], double x[6][3])
{
    if (p == 3 && q == 3) {
        sum_of(3, 3, points, width, u, v, x);
    } else {
        sum_of(p, q, points, width, u, v, x);
    }
}

static void compose_cell(int p, int q, const double *x, const taut_net_compose_row *first,
                         const taut_net_compose_row *second, double *out)
{
    if (p == 3 && q == 3) {
        compose_of(3, 3, x, first, second, out);
    } else {
        compose_of(p, q, x, first, second, out);
    }
}
