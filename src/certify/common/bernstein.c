#include "certify/common/bernstein.h"

#include <stddef.h>
#include <string.h>

double taut_certify_binomial(int n, int k)
{
    double value = 1;
    for (int i = 1; i <= k; i++) {
        value = value * (n - k + i) / i;
    }
    return value;
}

void taut_certify_halve(int degree, int dim, const double *a, double *low, double *high)
{
    memmove(high, a, (size_t)(dim * (degree + 1)) * sizeof *high);
    for (int step = 0; step <= degree; step++) {
        memcpy(low + (size_t)(dim * step), high, (size_t)dim * sizeof *high);
        for (int k = 0; k < dim * (degree - step); k++) {
            high[k] = 0.5 * high[k] + 0.5 * high[k + dim];
        }
    }
}
