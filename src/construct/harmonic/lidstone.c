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

void taut_binomials(int d, taut_twice *c)
{
    c[0] = taut_twice_of(1);
    for (int i = 0; i < d; i++) {
        c[i + 1] = taut_twice_over_number(taut_twice_scale(d - i, c[i]), i + 1);
    }
}

/* a + b, to 2^-100 of the larger of both. */
static taut_twice plus(taut_twice a, taut_twice b)
{
    const taut_twice s = taut_twice_sum(a.high, b.high);
    return taut_twice_sum(s.high, s.low + (a.low + b.low));
}

/* From degree m-1 to m: C(m,i) = C(m-1,i-1) + C(m-1,i), from the top down. */
void taut_raise_weighted(int d, int n, int stride, taut_twice *c)
{
    for (int m = d + 1; m <= n; m++) {
        for (int k = 0; k < stride; k++) {
            c[m * stride + k] = c[(m - 1) * stride + k];
        }
        for (int k = m * stride - 1; k >= stride; k--) {
            c[k] = plus(c[k], c[k - stride]);
        }
    }
}

/* d(d-1) C(d-2,i) Delta^2 c_i, as C(d-2,i) d (d-1) = C(d,i) (d-i)(d-i-1) = C(d,i+1) (i+1)(d-i-1)
 * = C(d,i+2) (i+1)(i+2). */
void taut_second_derivative(int d, taut_twice scale, taut_twice *curve)
{
    assert(d >= 2);
    for (int i = 0; i + 2 <= d; i++) {
        const int left = d - i - 1;
        for (int c = 0; c < 3; c++) {
            taut_twice *const at = curve + 3 * i + c;
            taut_twice bend = taut_twice_scale((i + 1) * (i + 2), at[6]);
            bend = taut_twice_gain(bend, taut_twice_of(left * (left + 1)), at[0]);
            bend = taut_twice_gain(bend, taut_twice_of(-2 * left * (i + 1)), at[3]);
            at[0] = taut_twice_times(scale, bend);
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
