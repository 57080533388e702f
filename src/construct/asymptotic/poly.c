/* poly.c -- [Farouki2012] sections 4 and 5. */
#include "construct/asymptotic/poly.h"

#include <assert.h>
#include <string.h>

double taut_poly_binomial(int n, int k)
{
    double value = 1.0;
    assert(0 <= k && k <= n && n <= TAUT_POLY_MAX);
    for (int i = 1; i <= (k < n - k ? k : n - k); i++) {
        value = value * (n + 1 - i) / i; /* an integer at each step, exact below 2^53 */
    }
    return value;
}

/* (s a)_k = sum_{i+j=k} C(p,i) C(q,j) / C(p+q,k) s_i a_j */
void taut_poly_scale(int p, const double *s, int q, int dim, const double *a, double *out)
{
    memset(out, 0, (size_t)((p + q + 1) * dim) * sizeof *out);
    for (int i = 0; i <= p; i++) {
        const double left = taut_poly_binomial(p, i) * s[i];
        for (int j = 0; j <= q; j++) {
            const double factor = left * taut_poly_binomial(q, j);
            for (int d = 0; d < dim; d++) {
                out[(i + j) * dim + d] += factor * a[j * dim + d];
            }
        }
    }
    for (int k = 0; k <= p + q; k++) {
        for (int d = 0; d < dim; d++) {
            out[k * dim + d] /= taut_poly_binomial(p + q, k);
        }
    }
}

void taut_poly_cross(int p, const double *a, int q, const double *b, double *out)
{
    memset(out, 0, (size_t)(p + q + 1) * 3 * sizeof *out);
    for (int i = 0; i <= p; i++) {
        for (int j = 0; j <= q; j++) {
            const double factor = taut_poly_binomial(p, i) * taut_poly_binomial(q, j);
            const double *const x = a + (long)i * 3, *const y = b + (long)j * 3;
            double *const z = out + (long)(i + j) * 3;
            z[0] += factor * (x[1] * y[2] - x[2] * y[1]);
            z[1] += factor * (x[2] * y[0] - x[0] * y[2]);
            z[2] += factor * (x[0] * y[1] - x[1] * y[0]);
        }
    }
    for (int k = 0; k <= p + q; k++) {
        for (int d = 0; d < 3; d++) {
            out[k * 3 + d] /= taut_poly_binomial(p + q, k);
        }
    }
}

void taut_poly_elevate(int p, int dim, const double *a, int times, double *out)
{
    memcpy(out, a, (size_t)((p + 1) * dim) * sizeof *out);
    for (int q = p + 1; q <= p + times; q++) { /* q: the new degree */
        for (int d = 0; d < dim; d++) {
            out[q * dim + d] = out[(q - 1) * dim + d];
            for (int k = q - 1; k > 0; k--) {
                out[k * dim + d] = (k * out[(k - 1) * dim + d] + (q - k) * out[k * dim + d]) / q;
            }
        }
    }
}

/* a_j = (j / p) (1 - root) b_{j-1} - ((p - j) / p) root b_j. Solving forwards for b_j multiplies
 * an error by j (1 - root) / ((p - j) root), which is below 1 while j < p root; backwards above. */
void taut_poly_deflate(int p, int dim, const double *a, double root, double *out)
{
    const double head = 1.0 - root;
    for (int d = 0; d < dim; d++) {
        int split = 0;
        for (int j = 0; j < p * root && j < p; j++) {
            const double before = j > 0 ? out[(j - 1) * dim + d] : 0.0;
            out[j * dim + d] = (j * head * before - p * a[j * dim + d]) / ((p - j) * root);
            split = j + 1;
        }
        for (int j = p; j > split; j--) {
            const double after = j < p ? out[j * dim + d] : 0.0;
            out[(j - 1) * dim + d] = (p * a[j * dim + d] + (p - j) * root * after) / (j * head);
        }
    }
}

void taut_poly_eval(int p, int dim, const double *a, double t, double *out)
{
    double work[TAUT_POLY_MAX + 1];
    assert(p <= TAUT_POLY_MAX);
    for (int d = 0; d < dim; d++) {
        for (int k = 0; k <= p; k++) {
            work[k] = a[k * dim + d];
        }
        for (int q = p; q > 0; q--) {
            for (int k = 0; k < q; k++) {
                work[k] = (1.0 - t) * work[k] + t * work[k + 1];
            }
        }
        out[d] = work[0];
    }
}
