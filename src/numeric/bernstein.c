/* bernstein.c -- [Farin2002] chapters 5 and 6, [Farouki2012] sections 4 and 5. */
#include "numeric/bernstein.h"

#include <assert.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

double taut_binomial(int n, int k)
{
    double value = 1.0;
    assert(0 <= k && k <= n && n <= TAUT_BERNSTEIN_MAX);
    for (int i = 1; i <= (k < n - k ? k : n - k); i++) {
        value = value * (n + 1 - i) / i; /* an integer at each step, exact below 2^53 */
    }
    return value;
}

/* b[0..degree] = B[degree,i](t), raising the degree one step at a time ([PieglTiller1997] A1.3):
 *     B[m,i] = (1-t) B[m-1,i] + t B[m-1,i-1]
 * 1-t is one correctly rounded subtraction, so nothing cancels on [0, 1]. */
static void bernstein_values(int degree, double t, double *b)
{
    const double s = 1.0 - t;

    b[0] = 1.0;
    for (int m = 1; m <= degree; m++) {
        double carried = 0.0; /* t B[m-1,i-1] */
        for (int i = 0; i < m; i++) {
            const double lower = b[i];
            b[i] = s * lower + carried;
            carried = t * lower;
        }
        b[m] = carried;
    }
}

/* b[0..degree] holds B[degree-1,i](t), i < degree, on entry and B'[degree,i](t) on return:
 *     B'[n,i] = n (B[n-1,i-1] - B[n-1,i])
 * It is linear in b, so repeating it over rising degrees takes higher derivatives. */
static void bernstein_differentiate(int degree, double *b)
{
    b[degree] = degree * b[degree - 1];
    for (int i = degree - 1; i > 0; i--) {
        b[i] = degree * (b[i - 1] - b[i]);
    }
    b[0] = -degree * b[0];
}

void taut_bernstein_eval(int degree, int order, double t, double *values)
{
    const size_t row_length = (size_t)degree + 1;

    assert(degree >= 0 && order >= 0);
    for (int k = 0; k <= order; k++) {
        double *row = values + (size_t)k * row_length;
        if (k > degree) {
            memset(row, 0, row_length * sizeof *row);
            continue;
        }
        bernstein_values(degree - k, t, row);
        for (int m = degree - k + 1; m <= degree; m++) {
            bernstein_differentiate(m, row);
        }
    }
}

enum { DIM_MAX = 4 };

/* One level of the triangle, `count` numbers of it: b_i <- (1 - t) b_i + t b_{i+1}. */
static void reduce_level(int count, int dim, double t, double *b)
{
    const double s = 1.0 - t;
    for (int i = 0; i < count; i++) {
        b[i] = s * b[i] + t * b[i + dim];
    }
}

enum { DEGREE_LOW = 9 };

/* The same for points in space and low degrees, where pipes spend their time: with the functions b_i
 * of degree p - 1 the point is u S_0 + t S_1 and its derivative p (S_1 - S_0), S_k = sum b_i a_i+k. A
 * run of pipes takes 1.3 times as many instructions by the triangle. */
static void point_in_space(int p, const double *a, double t, double *value, double *derivative)
{
    static const double binomial[DEGREE_LOW][DEGREE_LOW] = {
        {1},
        {1, 1},
        {1, 2, 1},
        {1, 3, 3, 1},
        {1, 4, 6, 4, 1},
        {1, 5, 10, 10, 5, 1},
        {1, 6, 15, 20, 15, 6, 1},
        {1, 7, 21, 35, 35, 21, 7, 1},
        {1, 8, 28, 56, 70, 56, 28, 8, 1},
    };
    double sum[6] = {0}, b[DEGREE_LOW] = {1}; /* S_0 and S_1 */
    const double u = 1 - t;
    double falling = 1; /* u to the power of what is left */

    if (p == 0) {
        memcpy(value, a, 3 * sizeof *value);
        if (derivative != NULL) {
            memset(derivative, 0, 3 * sizeof *derivative);
        }
        return;
    }
    for (int i = 1; i < p; i++) {
        b[i] = b[i - 1] * t;
    }
    for (int i = p - 1; i >= 0; i--) {
        b[i] *= binomial[p - 1][i] * falling;
        falling *= u;
    }
    for (int i = 0; i < p; i++) {
        for (int k = 0; k < 6; k++) {
            sum[k] += b[i] * a[3 * i + k];
        }
    }
    for (int k = 0; k < 3; k++) {
        value[k] = u * sum[k] + t * sum[3 + k];
        if (derivative != NULL) {
            derivative[k] = p * (sum[3 + k] - sum[k]);
        }
    }
}

void taut_bernstein_point(int p, int dim, const double *a, double t, double *value,
                          double *derivative)
{
    double b[(TAUT_BERNSTEIN_MAX + 1) * DIM_MAX];

    assert(p >= 0 && p <= TAUT_BERNSTEIN_MAX && dim >= 1 && dim <= DIM_MAX);
    if (dim == 3 && p <= DEGREE_LOW) {
        point_in_space(p, a, t, value, derivative);
        return;
    }
    memcpy(b, a, (size_t)((p + 1) * dim) * sizeof *b);
    for (int level = p; level > 1; level--) {
        reduce_level(level * dim, dim, t, b);
    }
    for (int k = 0; k < dim && derivative != NULL; k++) {
        derivative[k] = p > 0 ? p * (b[dim + k] - b[k]) : 0;
    }
    if (p > 0) {
        reduce_level(dim, dim, t, b);
    }
    memcpy(value, b, (size_t)dim * sizeof *b);
}

/* The sides of the triangle: low_i is the first of level i, high_{p-i} the last. */
void taut_bernstein_split(int p, int dim, const double *a, double t, double *low, double *high)
{
    double b[(TAUT_BERNSTEIN_MAX + 1) * DIM_MAX];
    const size_t bytes = (size_t)dim * sizeof *b;

    assert(p >= 0 && p <= TAUT_BERNSTEIN_MAX && dim >= 1 && dim <= DIM_MAX);
    memcpy(b, a, (size_t)(p + 1) * bytes);
    for (int i = 0; i <= p; i++) {
        if (low != NULL) {
            memcpy(low + (size_t)(i * dim), b, bytes);
        }
        if (high != NULL) {
            memcpy(high + (size_t)((p - i) * dim), b + (size_t)((p - i) * dim), bytes);
        }
        reduce_level((p - i) * dim, dim, t, b);
    }
}

void taut_bernstein_derivative(int p, int dim, const double *a, double *out)
{
    for (int i = 0; i < p * dim; i++) {
        out[i] = p * (a[i + dim] - a[i]);
    }
    for (int k = 0; k < dim && p == 0; k++) {
        out[k] = 0;
    }
}

/* From degree q - 1 to q: c_k = (k c_{k-1} + (q - k) c_k) / q, from the top down. */
void taut_bernstein_raise(int p, int dim, const double *a, int times, double *out)
{
    memmove(out, a, (size_t)((p + 1) * dim) * sizeof *out);
    for (int q = p + 1; q <= p + times; q++) { /* q: the new degree */
        for (int d = 0; d < dim; d++) {
            out[q * dim + d] = out[(q - 1) * dim + d];
            for (int k = q - 1; k > 0; k--) {
                out[k * dim + d] = (k * out[(k - 1) * dim + d] + (q - k) * out[k * dim + d]) / q;
            }
        }
    }
}

/* (s a)_k = sum_{i+j=k} C(p,i) C(q,j) / C(p+q,k) s_i a_j */
void taut_bernstein_scale(int p, const double *s, int q, int dim, const double *a, double *out)
{
    memset(out, 0, (size_t)((p + q + 1) * dim) * sizeof *out);
    for (int i = 0; i <= p; i++) {
        const double left = taut_binomial(p, i) * s[i];
        for (int j = 0; j <= q; j++) {
            const double factor = left * taut_binomial(q, j);
            for (int d = 0; d < dim; d++) {
                out[(i + j) * dim + d] += factor * a[j * dim + d];
            }
        }
    }
    for (int k = 0; k <= p + q; k++) {
        for (int d = 0; d < dim; d++) {
            out[k * dim + d] /= taut_binomial(p + q, k);
        }
    }
}

void taut_bernstein_cross(int p, const double *a, int q, const double *b, double *out)
{
    memset(out, 0, (size_t)(p + q + 1) * 3 * sizeof *out);
    for (int i = 0; i <= p; i++) {
        for (int j = 0; j <= q; j++) {
            const double factor = taut_binomial(p, i) * taut_binomial(q, j);
            const double *const x = a + (int64_t)i * 3, *const y = b + (int64_t)j * 3;
            double *const z = out + (int64_t)(i + j) * 3;
            z[0] += factor * (x[1] * y[2] - x[2] * y[1]);
            z[1] += factor * (x[2] * y[0] - x[0] * y[2]);
            z[2] += factor * (x[0] * y[1] - x[1] * y[0]);
        }
    }
    for (int k = 0; k <= p + q; k++) {
        for (int d = 0; d < 3; d++) {
            out[k * 3 + d] /= taut_binomial(p + q, k);
        }
    }
}

/* a_j = (j / p) (1 - root) b_{j-1} - ((p - j) / p) root b_j. Solving forwards for b_j multiplies
 * an error by j (1 - root) / ((p - j) root), which is below 1 while j < p root; backwards above. */
void taut_bernstein_deflate(int p, int dim, const double *a, double root, double *out)
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
