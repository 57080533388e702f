#include "numeric/parity.h"

#include <assert.h>
#include <math.h>

double taut_parity_defect(const taut_band *a)
{
    double worst = 0.0;
    for (int i = 0; i < a->n; i++) {
        for (int d = 0; d <= a->width && d <= i; d++) {
            const double size = sqrt(taut_band_at(a, i, i) * taut_band_at(a, i - d, i - d));
            const double here = taut_band_at(a, i, i - d);
            const double there = taut_band_at(a, a->n - 1 - i, a->n - 1 - i + d);
            if (!(size > 0.0)) {
                return INFINITY;
            }
            worst = fmax(worst, fabs(here - there) / size);
        }
    }
    return worst;
}

static double averaged(const taut_band *a, int i, int j)
{
    return 0.5 * (taut_band_at(a, i, j) + taut_band_at(a, a->n - 1 - i, a->n - 1 - j));
}

/* e_i.A e_j = A(i,j) + A(i,n-1-j), o_i.A o_j = A(i,j) - A(i,n-1-j), off the middle; the middle row
 * times sqrt(2). */
taut_status taut_parity_split(const taut_band *a, taut_band *even, taut_band *odd)
{
    const int n = a->n, pairs = n / 2;
    taut_band e = {0, 0, NULL}, o = {0, 0, NULL};
    assert(n >= 2);
    taut_status status = taut_band_init(n - pairs, a->width, &e);
    if (status == TAUT_OK) {
        status = taut_band_init(pairs, a->width, &o);
    }
    if (status != TAUT_OK) {
        taut_band_clear(&e);
        return status;
    }
    for (int i = 0; i < n - pairs; i++) {
        for (int d = 0; d <= a->width && d <= i; d++) {
            const int j = i - d;
            const double direct = averaged(a, i, j);
            const double across = averaged(a, i, n - 1 - j);
            if (i < pairs) {
                taut_band_row(&e, i)[d] = direct + across;
                taut_band_row(&o, i)[d] = direct - across;
            } else {
                taut_band_row(&e, i)[d] = d == 0 ? direct : sqrt(2.0) * direct;
            }
        }
    }
    *even = e;
    *odd = o;
    return TAUT_OK;
}
