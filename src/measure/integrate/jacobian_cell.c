/* jacobian_cell.c -- products and means of Bernstein coefficients with running error bounds.
 *
 *     f = sum a_i B[p,i], g = sum b_k B[q,k]:  f g = sum_l B[p+q,l] sum_(i+k=l) W_ik a_i b_k,
 *     W_ik = C(p,i) C(q,k) / C(p+q,l),  which sum to 1 for each l           [Farin2002] 5.5
 */
#include "measure/integrate/jacobian_cell.h"

#include "taut/limits.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double unit_roundoff = 0x1p-53;

/* C(p,i) C(q,k) / C(p+q,i+k) for all i, k: double[p+1][q+1]. The hypergeometric ratios are formed
 * along k from the first, W_i0 = C(p,i) / C(p+q,i); every factor is a quotient of whole numbers, so
 * the relative error is below 3 (p + q) 2^-53. */
static void weights_of(int p, int q, double *w)
{
    for (int i = 0; i <= p; i++) {
        double weight = 1;
        for (int k = 0; k < i; k++) {
            weight *= (double)(p - k) / (p + q - k);
        }
        for (int k = 0; k <= q; k++) {
            w[i * (q + 1) + k] = weight;
            weight *= (double)(q - k) * (i + k + 1) / ((double)(k + 1) * (p + q - i - k));
        }
    }
}

/* One coefficient: sums over i + k = l and j + h = r of
 *     n m (dx_u[i][j] dy_v[k][h] - dy_u[i][j] dx_v[k][h]). */
static void coefficient(const taut_planar *patch, const double *wu, const double *wv, int l, int r,
                        double *value, double *error)
{
    const int n = patch->n, m = patch->m, columns = 2 * (m + 1);
    const double apart = 2 * patch->apart;
    double sum = 0, size = 0, spread = 0;

    for (int i = l > n ? l - n : 0; i < n && i <= l; i++) {
        const int k = l - i; /* x_u has n rows of coefficients, x_v has n + 1 */
        for (int j = r >= m ? r - m + 1 : 0; j <= m && j <= r; j++) {
            const int h = r - j;
            const double *a = patch->x + i * columns + 2 * j, *b = patch->x + k * columns + 2 * h;
            const double xu = a[columns] - a[0], yu = a[columns + 1] - a[1];
            const double xv = b[2] - b[0], yv = b[3] - b[1];
            const double w = wu[i * (n + 1) + k] * wv[h * (m + 1) + j];
            const double big = fabs(xu * yv) + fabs(yu * xv);
            const int is_zero = (xu == 0 || yv == 0) && (yu == 0 || xv == 0);
            sum += w * (xu * yv - yu * xv);
            size += is_zero ? 0 : fmax(w * big, DBL_MIN);
            spread += w * apart * (fabs(xu) + fabs(yu) + fabs(xv) + fabs(yv) + 2 * apart);
        }
    }
    *value = n * m * sum;
    *error = n * m * ((8 * (double)(n + m) + 2.0 * n * m + 8) * unit_roundoff * size + 2 * spread);
}

void taut_jacobian_coefficients(const taut_planar *patch, double scale, double *values)
{
    double wu[TAUT_DEGREE_MAX * (TAUT_DEGREE_MAX + 1)], wv[TAUT_DEGREE_MAX * (TAUT_DEGREE_MAX + 1)];
    const int n = patch->n, m = patch->m;
    double *errors = values + (size_t)(2 * n) * (size_t)(2 * m);

    weights_of(n - 1, n, wu); /* i of x_u with k of x_v */
    weights_of(m - 1, m, wv); /* h of x_v with j of x_u */
    for (int l = 0; l < 2 * n; l++) {
        for (int r = 0; r < 2 * m; r++) {
            double value = 0, error = 0;
            coefficient(patch, wu, wv, l, r, &value, &error);
            values[l * 2 * m + r] = scale * value;
            errors[l * 2 * m + r] = scale * (1 + 8 * unit_roundoff) * error;
        }
    }
}

/* The halves of one line by de Casteljau's triangle at 1/2: `line` becomes the low one, `high` gets
 * the other; errors go along. */
static void halve(int degree, long stride, double *value, double *error, double *high_value,
                  double *high_error)
{
    for (int step = 0; step <= degree; step++) {
        high_value[(degree - step) * stride] = value[degree * stride];
        high_error[(degree - step) * stride] = error[degree * stride];
        for (int i = degree; i > step; i--) {
            const double mean = 0.5 * (value[i * stride] + value[(i - 1) * stride]);
            const double bound = 0.5 * (error[i * stride] + error[(i - 1) * stride]);
            value[i * stride] = mean;
            error[i * stride] = bound * (1 + 4 * unit_roundoff) + 2 * unit_roundoff * fabs(mean);
        }
    }
}

void taut_jacobian_quarter(int du, int dv, const taut_jacobian_cell *cell, double *scratch,
                           taut_jacobian_cell children[4])
{
    const size_t count = (size_t)(du + 1) * (size_t)(dv + 1);
    const double middle[2] = {0.5 * cell->lo[0] + 0.5 * cell->hi[0],
                              0.5 * cell->lo[1] + 0.5 * cell->hi[1]};

    memcpy(children[0].values, cell->values, 2 * count * sizeof(double));
    for (int j = 0; j <= dv; j++) { /* low u in child 0, high u in the scratch */
        halve(du, dv + 1, children[0].values + j, children[0].values + count + j, scratch + j,
              scratch + count + j);
    }
    memcpy(children[2].values, scratch, 2 * count * sizeof(double));
    for (int half = 0; half < 4; half += 2) {
        double *low = children[half].values, *high = children[half + 1].values;
        for (int i = 0; i <= du; i++) {
            const long row = (long)i * (dv + 1);
            halve(dv, 1, low + row, low + count + row, high + row, high + count + row);
        }
    }
    for (int k = 0; k < 4; k++) {
        const int side[2] = {k / 2, k % 2};
        for (int d = 0; d < 2; d++) {
            children[k].lo[d] = side[d] ? middle[d] : cell->lo[d];
            children[k].hi[d] = side[d] ? cell->hi[d] : middle[d];
        }
    }
}
