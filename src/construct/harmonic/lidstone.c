#include "construct/harmonic/lidstone.h"

#include <assert.h>

void taut_lidstone_next(int d, const taut_wide *b, taut_wide *c)
{
    assert(d >= 2);
    for (int i = 0; i <= d; i++) {
        taut_wide sum = 0;
        for (int j = 1; j < d; j++) {
            const int low = i < j ? i : j, high = i < j ? j : i;
            sum += (taut_wide)low * (d - high) / d * b[j - 1];
        }
        c[i] = -sum / ((taut_wide)d * (d - 1));
    }
}

/* From degree m-1 to m: c_i = (i/m) c_{i-1} + (1 - i/m) c_i, from the top down. */
void taut_raise_degree(int d, int n, int stride, taut_wide *c)
{
    for (int m = d + 1; m <= n; m++) {
        for (int s = 0; s < stride; s++) {
            c[m * stride + s] = c[(m - 1) * stride + s];
            for (int i = m - 1; i > 0; i--) {
                c[i * stride + s] = (i * c[(i - 1) * stride + s] + (m - i) * c[i * stride + s]) / m;
            }
        }
    }
}

void taut_second_derivative(int d, taut_wide *curve)
{
    const taut_wide factor = (taut_wide)d * (d - 1);
    assert(d >= 2);
    for (int i = 0; i + 2 <= d; i++) {
        for (int c = 0; c < 3; c++) {
            curve[3 * i + c] =
                factor * (curve[3 * i + c] - 2 * curve[3 * (i + 1) + c] + curve[3 * (i + 2) + c]);
        }
    }
}

void taut_top_difference(int m, const double *curve, double top[3])
{
    taut_wide binomial = m % 2 != 0 ? -1 : 1; /* (-1)^(m-j) C(m, j) */
    taut_wide sum[3] = {0, 0, 0};
    for (int j = 0; j <= m; j++) {
        for (int c = 0; c < 3; c++) {
            sum[c] += binomial * curve[3 * j + c];
        }
        binomial = -binomial * (m - j) / (j + 1);
    }
    for (int c = 0; c < 3; c++) {
        top[c] = (double)sum[c];
    }
}

void taut_power_coefficients(int e, int n, taut_wide *c)
{
    for (int i = 0; i <= n; i++) {
        taut_wide ratio = i >= e ? 1 : 0; /* C(i,e) / C(n,e) = prod (i-k)/(n-k) */
        for (int k = 0; k < e && ratio != 0; k++) {
            ratio *= (taut_wide)(i - k) / (n - k);
        }
        c[i] = ratio;
    }
}
