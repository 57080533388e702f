/* spot.h -- a surface near one point: its Taylor polynomial of order 3, from a span of choice. */
#ifndef TAUT_MEASURE_CURVATURE_SPOT_H
#define TAUT_MEASURE_CURVATURE_SPOT_H

#include "taut/surface.h"

/* Taylor polynomials of two variables, cut off after total order 3.
 *
 *     a(s, t) = sum_{i+j <= 3} c[(i,j)] s^i t^j,     ten numbers, in the order of taut_jet_power
 */
enum { TAUT_JET = 10 };

typedef struct taut_jet {
    double c[TAUT_JET];
} taut_jet;

/* The exponents of s and t of each coefficient, by rising total order. */
static const int taut_jet_power[TAUT_JET][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1},
                                                {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};

/* The place of s^i t^j. */
static inline int taut_jet_index(int i, int j)
{
    return (i + j) * (i + j + 1) / 2 + j;
}

static inline taut_jet taut_jet_multiply(const taut_jet *a, const taut_jet *b)
{
    taut_jet product = {{0}};
    for (int k = 0; k < TAUT_JET; k++) {
        for (int l = 0; l < TAUT_JET; l++) {
            const int i = taut_jet_power[k][0] + taut_jet_power[l][0];
            const int j = taut_jet_power[k][1] + taut_jet_power[l][1];
            if (i + j <= 3) {
                product.c[taut_jet_index(i, j)] += a->c[k] * b->c[l];
            }
        }
    }
    return product;
}

/* a / b, b's constant term not 0: q_k = (a_k - sum_{l < k} q_l b_{k-l}) / b_0, by rising order. */
static inline taut_jet taut_jet_divide(const taut_jet *a, const taut_jet *b)
{
    taut_jet quotient = {{0}};
    for (int k = 0; k < TAUT_JET; k++) {
        double sum = a->c[k];
        for (int l = 0; l < k; l++) {
            const int i = taut_jet_power[k][0] - taut_jet_power[l][0];
            const int j = taut_jet_power[k][1] - taut_jet_power[l][1];
            if (i >= 0 && j >= 0) {
                sum -= quotient.c[l] * b->c[taut_jet_index(i, j)];
            }
        }
        quotient.c[k] = sum / b->c[0];
    }
    return quotient;
}

/* a + factor * b. */
static inline taut_jet taut_jet_add(const taut_jet *a, double factor, const taut_jet *b)
{
    taut_jet sum;
    for (int k = 0; k < TAUT_JET; k++) {
        sum.c[k] = a->c[k] + factor * b->c[k];
    }
    return sum;
}

typedef struct taut_spot {
    taut_jet x[3];          /* coordinates, of points scaled by 2^-scale */
    double bound[TAUT_JET]; /* how large each coefficient could be for a net of this size: what its
                             * rounding is proportional to */
} taut_spot;

/* At (u, v) in the closed spans su, sv. order 0..3: coefficients beyond it are 0. The parameters of
 * the polynomial are those of the surface times 2^-shift[0], 2^-shift[1]. */
void taut_spot_at(const taut_surface *surface, int su, int sv, double u, double v, int order,
                  int scale, const int shift[2], taut_spot *spot);

#endif /* TAUT_MEASURE_CURVATURE_SPOT_H */
