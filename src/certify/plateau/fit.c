#include "certify/plateau/fit.h"

#include "core/arena.h"
#include "core/constants.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

typedef struct work {
    const taut_curve *curve;
    const taut_basis *basis;
    taut_arena *arena;
    double *gram;      /* [n - 2][local]: A(i, i - d), of the inner functions */
    double *points;    /* [n][3]: the ends, and between them first the right-hand sides */
    double *functions; /* [local] */
} work;

/* The parameter of the curve that belongs to t. */
static double curve_parameter(const work *w, double t)
{
    const taut_basis *c = taut_curve_t(w->curve);
    const double lo = taut_basis_lo(w->basis), hi = taut_basis_hi(w->basis);
    const double a = taut_basis_lo(c), b = taut_basis_hi(c);
    return fmin(b, fmax(a, a + (t - lo) / (hi - lo) * (b - a)));
}

/* Adds one node of one span; functions of the outermost points go to the right-hand side. */
static taut_status add_node(work *w, int span, double t, double weight)
{
    const int n = taut_basis_count(w->basis), local = taut_basis_local(w->basis);
    const int first = taut_basis_first(w->basis, span);
    const double *f = w->functions;
    double x[3];
    taut_status status = taut_curve_eval(w->curve, curve_parameter(w, t), 0, x);

    if (status == TAUT_OK) {
        status = taut_basis_eval(w->basis, span, t, 0, w->functions);
    }
    for (int b = 0; b < local && status == TAUT_OK; b++) {
        if (first + b == 0 || first + b == n - 1) {
            for (int c = 0; c < 3; c++) {
                x[c] -= f[b] * w->points[3 * (size_t)(first + b) + (size_t)c];
            }
        }
    }
    for (int a = 0; a < local && status == TAUT_OK; a++) {
        const int i = first + a;
        if (i == 0 || i == n - 1) {
            continue;
        }
        for (int c = 0; c < 3; c++) {
            w->points[3 * (size_t)i + (size_t)c] += weight * f[a] * x[c];
        }
        for (int b = 0; b <= a; b++) {
            if (first + b > 0) {
                w->gram[(size_t)(i - 1) * (size_t)local + (size_t)(a - b)] += weight * f[a] * f[b];
            }
        }
    }
    return status;
}

static taut_status add_spans(work *w)
{
    const int local = taut_basis_local(w->basis);
    const int count = local + 2 < TAUT_GAUSS_MAX ? local + 2 : TAUT_GAUSS_MAX;
    const double *breaks = taut_basis_breaks(w->basis);
    double nodes[TAUT_GAUSS_MAX], weights[TAUT_GAUSS_MAX];
    taut_status status = TAUT_OK;

    taut_gauss_rule(count, nodes, weights);
    for (int k = 0; k < taut_basis_span_count(w->basis); k++) {
        const double lo = breaks[k], half = 0.5 * (breaks[k + 1] - lo);
        for (int g = 0; g < count && status == TAUT_OK; g++) {
            const double t = fmin(breaks[k + 1], lo + half * (1 + nodes[g]));
            status = add_node(w, k, t, half * weights[g]);
        }
    }
    return status;
}

/* Cholesky's factors in place, A = L L' ([GolubVanLoan2013] 4.3.5); 0 where a pivot is not safely
 * above 0. */
static int factor(double *a, int n, int width)
{
    for (int i = 0; i < n; i++) {
        const double diagonal = a[(size_t)i * (size_t)width];
        for (int d = i < width - 1 ? i : width - 1; d >= 0; d--) {
            const int j = i - d, first = i < width - 1 ? 0 : i - width + 1;
            const double *const row = a + (size_t)i * (size_t)width;
            const double *const other = a + (size_t)j * (size_t)width;
            double sum = row[d];
            for (int k = first; k < j; k++) {
                sum -= row[i - k] * other[j - k];
            }
            if (d == 0 && !(sum > 8 * n * TAUT_UNIT_ROUNDOFF * diagonal)) {
                return 0;
            }
            a[(size_t)i * (size_t)width + (size_t)d] = d == 0 ? sqrt(sum) : sum / other[0];
        }
    }
    return 1;
}

/* x = A^-1 x, x[n][3], forwards with L and back with its transpose. */
static void solve(const double *a, int n, int width, double *x)
{
    for (int i = 0; i < n; i++) {
        const double *row = a + (size_t)i * (size_t)width;
        for (int c = 0; c < 3; c++) {
            double sum = x[3 * i + c];
            for (int d = 1; d < width && d <= i; d++) {
                sum -= row[d] * x[3 * (i - d) + c];
            }
            x[3 * i + c] = sum / row[0];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int c = 0; c < 3; c++) {
            double sum = x[3 * i + c];
            for (int d = 1; d < width && i + d < n; d++) {
                sum -= a[(size_t)(i + d) * (size_t)width + (size_t)d] * x[3 * (i + d) + c];
            }
            x[3 * i + c] = sum / a[(size_t)i * (size_t)width];
        }
    }
}

static taut_status make_fit(work *w, taut_curve **fit)
{
    const int n = taut_basis_count(w->basis), local = taut_basis_local(w->basis);
    const taut_basis *c = taut_curve_t(w->curve);
    taut_status status = TAUT_OK;

    w->functions = taut_arena_take(w->arena, (size_t)local, sizeof(double));
    w->points = taut_arena_take(w->arena, 3 * (size_t)n, sizeof(double));
    w->gram = taut_arena_take(w->arena, (size_t)n * (size_t)local, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    memset(w->points, 0, 3 * (size_t)n * sizeof(double));
    memset(w->gram, 0, (size_t)n * (size_t)local * sizeof(double));
    status = taut_curve_eval(w->curve, taut_basis_lo(c), 0, w->points);
    if (status == TAUT_OK) {
        status = taut_curve_eval(w->curve, taut_basis_hi(c), 0, w->points + 3 * (size_t)(n - 1));
    }
    if (n > 2 && status == TAUT_OK) {
        status = add_spans(w);
        if (status == TAUT_OK && !factor(w->gram, n - 2, local)) {
            status = TAUT_NO_SOLUTION;
        }
        if (status == TAUT_OK) {
            solve(w->gram, n - 2, local, w->points + 3);
        }
    }
    return status == TAUT_OK ? taut_curve_new("", w->basis, w->points, NULL, fit, NULL) : status;
}

taut_status taut_certify_fit(const taut_curve *curve, const taut_basis *basis, taut_curve **fit)
{
    work w = {.curve = curve, .basis = basis, .arena = taut_arena_new()};
    const taut_status status = make_fit(&w, fit);

    taut_arena_free(w.arena);
    return status == TAUT_OK || status == TAUT_NO_MEMORY ? status : TAUT_NO_SOLUTION;
}
