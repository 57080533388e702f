#include "construct/asymptotic/bubble.h"

#include "numeric/bernstein.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* p[0..count-1] = Legendre polynomials of x: (k+1) P_(k+1) = (2k+1) x P_k - k P_(k-1). */
static void legendre(int count, double x, double *p)
{
    p[0] = 1.0;
    p[1] = x;
    for (int k = 1; k + 1 < count; k++) {
        p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
    }
}

/* int_0^t P_k(2s - 1) ds = (P_(k+1) - P_(k-1)) / (2 (2k+1)), zero at both ends for k >= 1. */
static double integral(const double *p, int k)
{
    return (p[k + 1] - p[k - 1]) / (2.0 * (2 * k + 1));
}

void taut_bubble_eval(int m, double t, double *values)
{
    double p[TAUT_BERNSTEIN_MAX + 1];
    const int count = m - 3;
    assert(m >= 4 && m < TAUT_BERNSTEIN_MAX);
    legendre(m + 1, 2.0 * t - 1.0, p);
    for (int k = 2; k <= m - 2; k++) {
        const double scale = sqrt(2.0 * k + 1.0);
        values[k - 2] = scale * (integral(p, k + 1) - integral(p, k - 1)) / (2.0 * (2 * k + 1));
        values[count + k - 2] = scale * integral(p, k);
        values[2 * count + k - 2] = scale * p[k];
    }
}

/* P_k(2t - 1) has Bernstein coefficients (-1)^(k+i) C(k, i); raised to degree m - 2 and summed
 * twice from the left, where errors have not piled up; the right half by symmetry. */
void taut_bubble_bernstein(int m, double *coefficients)
{
    assert(m >= 4 && m < TAUT_BERNSTEIN_MAX);
    for (int k = 2; k <= m - 2; k++) {
        double low[TAUT_BERNSTEIN_MAX + 1], a[TAUT_BERNSTEIN_MAX + 1];
        double *const out = coefficients + (int64_t)(k - 2) * (m + 1);
        double first = 0.0, second = 0.0;
        for (int i = 0; i <= k; i++) {
            low[i] = ((k + i) % 2 == 0 ? 1.0 : -1.0) * taut_binomial(k, i);
        }
        taut_bernstein_raise(k, 1, low, m - 2 - k, a);
        memset(out, 0, (size_t)(m + 1) * sizeof *out);
        for (int j = 2; j <= m / 2; j++) {
            first += a[j - 2] / (m - 1);
            second += first / m;
            out[j] = sqrt(2.0 * k + 1.0) * second;
            out[m - j] = k % 2 == 0 ? out[j] : -out[j];
        }
        if (m % 2 == 0 && k % 2 != 0) {
            out[m / 2] = 0.0;
        }
    }
}
