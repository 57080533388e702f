/* printed.c -- the ways in which printed figures arose that are not what they are called.
 */
#include "cli/reproduce/reproduce.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Parameter k of n + 1, ends included. */
static double parameter(const taut_basis *basis, int k, int n)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return k == n ? hi : lo + (hi - lo) * k / n;
}

static double triangle(const double *a, const double *b, const double *c)
{
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = b[i] - a[i];
        v[i] = c[i] - a[i];
    }
    const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2],
                 z = u[0] * v[1] - u[1] * v[0];
    return 0.5 * sqrt(x * x + y * y + z * z);
}

double cli_triangulated_area(const taut_surface *surface, int cells)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    double area = 0;
    for (int i = 0; i < cells; i++) {
        for (int j = 0; j < cells; j++) {
            double p[4][3];
            for (int k = 0; k < 4; k++) {
                taut_surface_eval(surface, parameter(u, i + k / 2, cells),
                                  parameter(v, j + k % 2, cells), 0, p[k]);
            }
            area += triangle(p[0], p[1], p[3]) + triangle(p[0], p[3], p[2]);
        }
    }
    return area;
}

double cli_unnormalised_curvature(const taut_surface *surface, int samples, int mean)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int n = samples - 1;
    double most = 0, sum = 0;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= n; j++) {
            taut_forms forms;
            double x[6][3];
            taut_surface_eval(surface, parameter(u, i, n), parameter(v, j, n), 2, &x[0][0]);
            taut_forms_of((const double(*)[3])x, &forms);
            most = fmax(most, fabs(forms.mean) * forms.w);
            sum += fabs(forms.mean) * forms.w;
        }
    }
    return mean ? sum / ((double)n * n) : most;
}

enum { COTES_COUNT_MAX = 12 };
typedef double gram[COTES_COUNT_MAX][COTES_COUNT_MAX];

/* M and K of a basis over its range by the composite rule: panel weights (7, 32, 12, 32, 7)/90. */
static void cotes_gram(const taut_basis *basis, int panels, gram mass, gram stiffness)
{
    static const double weights[5] = {7.0 / 90, 32.0 / 90, 12.0 / 90, 32.0 / 90, 7.0 / 90};
    const int local = taut_basis_local(basis);
    const double width = (taut_basis_hi(basis) - taut_basis_lo(basis)) / panels;

    memset(mass, 0, sizeof(gram));
    memset(stiffness, 0, sizeof(gram));
    for (int k = 0; k < 5 * panels; k++) {
        const double t = parameter(basis, 4 * (k / 5) + k % 5, 4 * panels);
        /* a node on a knot belongs to the panel it is in */
        const double inside = parameter(basis, 2 * (k / 5) + 1, 2 * panels);
        const int span = taut_basis_span(basis, inside), first = taut_basis_first(basis, span);
        double n[2 * COTES_COUNT_MAX];
        if (taut_basis_eval(basis, span, t, 1, n) != TAUT_OK) {
            return;
        }
        for (int a = 0; a < local; a++) {
            for (int b = 0; b < local; b++) {
                mass[first + a][first + b] += width * weights[k % 5] * n[a] * n[b];
                stiffness[first + a][first + b] +=
                    width * weights[k % 5] * n[local + a] * n[local + b];
            }
        }
    }
}

/* Gaussian elimination with row pivoting, in place; x replaces b. */
static void eliminate(int n, double *a, double *b)
{
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++) {
            pivot = fabs(a[i * n + k]) > fabs(a[pivot * n + k]) ? i : pivot;
        }
        for (int j = 0; j < n; j++) {
            const double t = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = t;
        }
        const double t = b[k];
        b[k] = b[pivot];
        b[pivot] = t;
        for (int i = k + 1; i < n; i++) {
            const double factor = a[i * n + k] / a[k * n + k];
            for (int j = k; j < n; j++) {
                a[i * n + j] -= factor * a[k * n + j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++) {
            b[k] -= a[k * n + j] * b[j];
        }
        b[k] /= a[k * n + k];
    }
}

double cli_cotes_point(const taut_surface *surface, int panels, int i, int j, int c)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *points = taut_surface_points(surface);
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    const int n = (nu - 2) * (nv - 2);
    gram mu, ku, mv, kv;
    double *a = NULL, *b = NULL, found = (double)NAN;

    if (nu > COTES_COUNT_MAX || nv > COTES_COUNT_MAX || n < 1 || i < 1 || j < 1 || i > nu - 2 ||
        j > nv - 2 || taut_surface_weights(surface) != NULL) {
        return found;
    }
    cotes_gram(u, panels, mu, ku);
    cotes_gram(v, panels, mv, kv);
    a = calloc((size_t)(n * n), sizeof *a);
    b = calloc((size_t)n, sizeof *b);
    for (int row = 0; a != NULL && b != NULL && row < n; row++) {
        const int ri = row / (nv - 2) + 1, rj = row % (nv - 2) + 1;
        for (int s = 0; s < nu; s++) {
            for (int t = 0; t < nv; t++) {
                const double m = ku[ri][s] * mv[rj][t] + mu[ri][s] * kv[rj][t];
                if (s == 0 || t == 0 || s == nu - 1 || t == nv - 1) {
                    b[row] -= m * points[3 * (s * nv + t) + c];
                } else {
                    a[row * n + (s - 1) * (nv - 2) + t - 1] = m;
                }
            }
        }
    }
    if (a != NULL && b != NULL) {
        eliminate(n, a, b);
        found = b[(i - 1) * (nv - 2) + j - 1];
    }
    free(a);
    free(b);
    return found;
}
