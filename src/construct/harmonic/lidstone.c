#include "construct/harmonic/lidstone.h"

#include <assert.h>

void taut_lidstone_next(int d, const taut_twice *b, taut_twice *c)
{
    assert(d >= 2);
    for (int i = 0; i <= d; i++) {
        taut_twice sum = {0, 0};
        for (int j = 1; j < d; j++) {
            const int low = i < j ? i : j, high = i < j ? j : i;
            sum = taut_twice_gain(sum, taut_twice_of(low * (d - high)), b[j - 1]);
        }
        c[i] = taut_twice_over_number(sum, -(double)d * d * (d - 1));
    }
}

/* From degree m-1 to m: c_i = (i/m) c_{i-1} + (1 - i/m) c_i, from the top down. */
void taut_raise_degree(int d, int n, int stride, taut_twice *c)
{
    for (int m = d + 1; m <= n; m++) {
        for (int s = 0; s < stride; s++) {
            c[m * stride + s] = c[(m - 1) * stride + s];
            for (int i = m - 1; i > 0; i--) {
                const taut_twice low = taut_twice_scale(i, c[(i - 1) * stride + s]);
                const taut_twice sum =
                    taut_twice_gain(low, taut_twice_of(m - i), c[i * stride + s]);
                c[i * stride + s] = taut_twice_over_number(sum, m);
            }
        }
    }
}

void taut_second_derivative(int d, taut_twice scale, taut_twice *curve)
{
    const taut_twice factor = taut_twice_scale((double)d * (d - 1), scale);
    assert(d >= 2);
    for (int i = 0; i + 2 <= d; i++) {
        for (int c = 0; c < 3; c++) {
            taut_twice *const at = curve + 3 * i + c;
            const taut_twice ends = taut_twice_add(at[0], at[6]);
            const taut_twice bend = taut_twice_gain(ends, taut_twice_of(-2), at[3]);
            at[0] = taut_twice_times(factor, bend);
        }
    }
}

void taut_top_difference(int m, const double *curve, double top[3])
{
    taut_twice binomial = taut_twice_of(m % 2 != 0 ? -1 : 1); /* (-1)^(m-j) C(m, j) */
    taut_twice sum[3] = {{0, 0}, {0, 0}, {0, 0}};
    for (int j = 0; j <= m; j++) {
        for (int c = 0; c < 3; c++) {
            sum[c] = taut_twice_gain(sum[c], binomial, taut_twice_of(curve[3 * j + c]));
        }
        binomial = taut_twice_over_number(taut_twice_scale(j - m, binomial), j + 1);
    }
    for (int c = 0; c < 3; c++) {
        top[c] = taut_twice_round(sum[c]);
    }
}

void taut_power_coefficients(int e, int n, taut_twice *c)
{
    for (int i = 0; i <= n; i++) {
        taut_twice ratio = taut_twice_of(i >= e ? 1 : 0); /* C(i,e) / C(n,e) = prod (i-k)/(n-k) */
        for (int k = 0; k < e && i >= e; k++) {
            ratio = taut_twice_over_number(taut_twice_scale(i - k, ratio), n - k);
        }
        c[i] = ratio;
    }
}
