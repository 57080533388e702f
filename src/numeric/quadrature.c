/* quadrature.c -- Gauss-Legendre nodes by Newton's method on the three-term recurrence.
 *
 *     (k+1) P_{k+1}(x) = (2k+1) x P_k(x) - k P_{k-1}(x),   (1-x^2) P_n' = n (P_{n-1} - x P_n)
 * from Tricomi's starting values; weights 2 / ((1-x^2) P_n'(x)^2). [DLMF] 18.9, 18.16, 3.5(v).
 */
#include "numeric/quadrature.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <assert.h>
#include <math.h>

/* P_n(x) and its derivative at |x| < 1. */
static void evaluate_legendre(int n, double x, double *value, double *slope)
{
    double before = 1, now = x;
    for (int k = 1; k < n; k++) {
        const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
        before = now;
        now = next;
    }
    *value = now;
    *slope = n * (before - x * now) / ((1 - x) * (1 + x));
}

/* The upper half of the rule of 8 as it is found below: sums along curves ask for it at each step. */
static const double eight[4][2] = {
    {0x1.77ac94f3c7345p-3, 0x1.736360b199344p-2},
    {0x1.0d129583284b4p-1, 0x1.413c50a255617p-2},
    {0x1.97e4ab249f41fp-1, 0x1.c76fb531d2b95p-3},
    {0x1.ebab1cb0acc67p-1, 0x1.9ea1d04ca036ep-4},
};

void taut_gauss_rule(int count, double *nodes, double *weights)
{
    assert(count >= 1 && count <= TAUT_GAUSS_MAX);
    for (int i = 0; count == 8 && i < 4; i++) {
        nodes[4 + i] = eight[i][0];
        nodes[3 - i] = -eight[i][0];
        weights[4 + i] = weights[3 - i] = eight[i][1];
    }
    if (count == 8) {
        return;
    }
    for (int i = 0; i < (count + 1) / 2; i++) {
        const double angle = TAUT_PI * (4.0 * i + 3) / (4.0 * count + 2);
        const double n = count;
        double x = (1 - (n - 1) / (8 * n * n * n)) * taut_cos(angle);
        double value = 0, slope = 1;
        for (int step = 0; step < 8; step++) {
            evaluate_legendre(count, x, &value, &slope);
            x -= value / slope;
            if (fabs(value / slope) < 1e-16) {
                break;
            }
        }
        if (2 * i + 1 == count) {
            x = 0;
        }
        evaluate_legendre(count, x, &value, &slope);
        nodes[count - 1 - i] = x;
        nodes[i] = -x;
        weights[i] = weights[count - 1 - i] = 2 / ((1 - x) * (1 + x) * slope * slope);
    }
}
