#include "numeric/minimise.h"

#include "numeric/dense.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

enum { QUASI_MAX = 100, NEWTON_MAX = 30, ROUGH_MAX = 12, HALVINGS_MAX = 40 };
static const double newton_from = 1e-4;  /* gradient over value at which Newton takes over */
static const double settled = 1e-8;      /* gradient over value that counts as a minimum */
static const double difference = 1e-5;   /* step of the differences: error 1e-10 of the Hessian */
static const double least_pivot = 1e-10; /* of a positive Hessian, over its largest entry */
static const double longest_step = 2.0;  /* in one step, per variable: they are logarithms */

/* The state of one run; all arrays lie in the caller's scratch. */
typedef struct descent {
    int n;
    taut_objective objective;
    taut_hessian hessian; /* or NULL */
    void *context;
    double *x, *g; /* here */
    double *trial, *g_trial;
    double *step, *scratch;
    double *matrix, *vectors, *spare; /* n x n */
    double value;
    int evaluations;
} descent;

static int evaluate_at(descent *d, const double *x, double *value, double *g)
{
    d->evaluations++;
    if (!d->objective(d->context, x, value, g) || !isfinite(*value)) {
        return 0;
    }
    for (int i = 0; i < d->n; i++) {
        if (!isfinite(g[i])) {
            return 0;
        }
    }
    return 1;
}

static double largest_of(int n, const double *x)
{
    double most = 0.0;
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(x[i]));
    }
    return most;
}

static double dot_product(int n, const double *x, const double *y)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += x[i] * y[i];
    }
    return sum;
}

/* Size that the value's rounding is measured by. */
static double size_of(double value)
{
    return fmax(fabs(value), DBL_MIN);
}

/* Moves along d->step, halving until the value falls enough (or, once differences of values are
 * rounding noise, until the gradient does). On success trial becomes here, with
 * g_trial the gradient that was here before. */
static int search_line(descent *d)
{
    const double most = largest_of(d->n, d->step);
    const double slope = dot_product(d->n, d->step, d->g);
    const double noise = 8 * DBL_EPSILON * size_of(d->value);
    double length = most > longest_step ? longest_step / most : 1.0;

    if (!(slope < 0)) {
        return 0;
    }
    for (int halving = 0; halving < HALVINGS_MAX; halving++, length *= 0.5) {
        double value = 0.0;
        if (halving > 2 && -slope * length < 0.01 * noise) {
            return 0; /* the fall to come is below what the value can tell */
        }
        for (int i = 0; i < d->n; i++) {
            d->trial[i] = d->x[i] + length * d->step[i];
        }
        if (!evaluate_at(d, d->trial, &value, d->g_trial)) {
            continue;
        }
        if (value <= d->value + 1e-4 * length * slope ||
            (fabs(value - d->value) <= noise &&
             largest_of(d->n, d->g_trial) < 0.9 * largest_of(d->n, d->g))) {
            double *const x = d->x;
            double *const g = d->g;
            d->x = d->trial;
            d->g = d->g_trial;
            d->trial = x;
            d->g_trial = g;
            d->value = value;
            return 1;
        }
    }
    return 0;
}

/* H <- (I - r s y') H (I - r y s') + r s s', r = 1 / y's ([NocedalWright2006] 6.17). */
static void quasi_update(descent *d)
{
    const int n = d->n;
    double *const s = d->step, *const y = d->g_trial, *const hy = d->scratch;
    double ys = 0.0, yhy = 0.0;
    for (int i = 0; i < n; i++) {
        s[i] = d->x[i] - d->trial[i];
        y[i] = d->g[i] - y[i];
    }
    ys = dot_product(n, y, s);
    if (!(ys > 1e-12 * sqrt(dot_product(n, y, y) * dot_product(n, s, s)))) {
        return;
    }
    for (int i = 0; i < n; i++) {
        hy[i] = dot_product(n, d->matrix + i * n, y);
    }
    yhy = dot_product(n, y, hy);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            d->matrix[i * n + j] +=
                ((1.0 + yhy / ys) * s[i] * s[j] - hy[i] * s[j] - s[i] * hy[j]) / ys;
        }
    }
}

/* The inverse Hessian's first guess: a step of the size of one tenth. */
static void quasi_reset(descent *d)
{
    const double scale = 0.1 / fmax(largest_of(d->n, d->g), DBL_MIN);
    memset(d->matrix, 0, (size_t)d->n * (size_t)d->n * sizeof *d->matrix);
    for (int i = 0; i < d->n; i++) {
        d->matrix[i * d->n + i] = scale;
    }
}

static void quasi_newton(descent *d)
{
    int fresh = 1;
    quasi_reset(d);
    for (int iteration = 0; iteration < QUASI_MAX; iteration++) {
        if (largest_of(d->n, d->g) <= newton_from * size_of(d->value)) {
            return;
        }
        for (int i = 0; i < d->n; i++) {
            d->step[i] = -dot_product(d->n, d->matrix + i * d->n, d->g);
        }
        if (search_line(d)) {
            quasi_update(d);
            fresh = 0;
        } else if (!fresh) {
            quasi_reset(d);
            fresh = 1;
        } else {
            return;
        }
    }
}

/* matrix = the Hessian at x by differences, made symmetric. One that leaves the domain is taken on
 * one side. Returns 0 if both sides leave it. */
static int difference_hessian(descent *d)
{
    const int n = d->n;
    for (int j = 0; j < n; j++) {
        double *const up = d->matrix + j * n, *const down = d->scratch;
        double unused = 0.0;
        int has_up = 0, has_down = 0;
        memcpy(d->trial, d->x, (size_t)n * sizeof *d->x);
        d->trial[j] = d->x[j] + difference;
        has_up = evaluate_at(d, d->trial, &unused, up);
        d->trial[j] = d->x[j] - difference;
        has_down = evaluate_at(d, d->trial, &unused, down);
        if (!has_up && !has_down) {
            return 0;
        }
        for (int i = 0; i < n; i++) {
            const double high = has_up ? up[i] : d->g[i];
            const double low = has_down ? down[i] : d->g[i];
            up[i] = (high - low) / ((has_up + has_down) * difference);
        }
    }
    for (int j = 0; j < n; j++) {
        for (int i = 0; i < j; i++) {
            const double mean = 0.5 * (d->matrix[i + j * n] + d->matrix[j + i * n]);
            d->matrix[i + j * n] = d->matrix[j + i * n] = mean;
        }
    }
    return 1;
}

/* matrix = the Hessian at x, where the objective was last called; 0 if there is none. */
static int find_hessian(descent *d)
{
    if (d->hessian == NULL) {
        return difference_hessian(d);
    }
    d->hessian(d->context, d->x, d->matrix);
    return 1;
}

/* Eigenvalues of the Hessian, increasing, and its vectors. */
static void find_eigen(descent *d, double *values)
{
    memcpy(d->spare, d->matrix, (size_t)d->n * (size_t)d->n * sizeof *d->spare);
    taut_symmetric_eigen(d->n, d->spare, values, d->vectors);
}

/* step = -H^-1 g by Cholesky's factors, rows of the lower triangle; 0 where H is not clearly
 * positive. */
static int positive_step(descent *d)
{
    const int n = d->n;
    double *const l = d->spare, *const x = d->step;
    double largest = 0.0;
    for (int i = 0; i < n; i++) {
        largest = fmax(largest, fabs(d->matrix[i * n + i]));
    }
    for (int i = 0; i < n; i++) {
        double rest = d->matrix[i * n + i];
        for (int j = 0; j < i; j++) {
            const double part = d->matrix[i * n + j] - dot_product(j, l + i * n, l + j * n);
            l[i * n + j] = part / l[j * n + j];
        }
        rest -= dot_product(i, l + i * n, l + i * n);
        if (!(rest > least_pivot * largest)) {
            return 0;
        }
        l[i * n + i] = sqrt(rest);
        x[i] = (-d->g[i] - dot_product(i, l + i * n, x)) / l[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        x[i] /= l[i * n + i];
        for (int j = 0; j < i; j++) {
            x[j] -= l[i * n + j] * x[i];
        }
    }
    return 1;
}

/* step = -|H|^-1 g, which falls; by the eigenvalues of H where it is not positive. */
static void newton_step(descent *d)
{
    const int n = d->n;
    double values[TAUT_MINIMISE_MAX];
    double floor_value = 0.0;
    if (positive_step(d)) {
        return;
    }
    find_eigen(d, values);
    floor_value = fmax(1e-10 * fmax(fabs(values[0]), fabs(values[n - 1])), DBL_MIN);
    memset(d->step, 0, (size_t)n * sizeof *d->step);
    for (int j = 0; j < n; j++) {
        const double *const v = d->vectors + j * n;
        const double part = dot_product(n, v, d->g) / fmax(fabs(values[j]), floor_value);
        for (int i = 0; i < n; i++) {
            d->step[i] -= part * v[i];
        }
    }
}

/* At most `most` Newton steps until the gradient is at most `enough`; 0 goes down to rounding.
 * Returns 0 where there is no Hessian. */
static int run_newton(descent *d, int most, double enough)
{
    for (int iteration = 0; iteration < most && largest_of(d->n, d->g) > enough; iteration++) {
        if (!find_hessian(d)) {
            return 0;
        }
        newton_step(d);
        if (largest_of(d->n, d->step) < DBL_EPSILON || !search_line(d)) {
            break;
        }
    }
    return 1;
}

/* The least eigenvalue of the Hessian at x, or -1. */
static double find_curvature(descent *d)
{
    double values[TAUT_MINIMISE_MAX], unused = 0.0;
    if (!evaluate_at(d, d->x, &unused, d->g) || !find_hessian(d)) {
        return -1.0;
    }
    find_eigen(d, values);
    return values[0];
}

int taut_minimise(int count, taut_objective objective, taut_hessian hessian, void *context,
                  double *x, double *work, int rough, taut_minimum *minimum)
{
    const int square = count * count;
    descent d = {.n = count, .objective = objective, .hessian = hessian, .context = context};
    int settles = 0;

    assert(count >= 1 && count <= TAUT_MINIMISE_MAX);
    d.matrix = work;
    d.vectors = work + square;
    d.spare = work + 2 * square;
    d.x = work + 3 * square;
    d.g = d.x + count;
    d.trial = d.g + count;
    d.g_trial = d.trial + count;
    d.step = d.g_trial + count;
    d.scratch = d.step + count;
    memcpy(d.x, x, (size_t)count * sizeof *x);
    if (!evaluate_at(&d, d.x, &d.value, d.g)) {
        return 0;
    }
    quasi_newton(&d);
    settles = rough ? run_newton(&d, ROUGH_MAX, newton_from * size_of(d.value))
                    : run_newton(&d, NEWTON_MAX, 0.0);
    minimum->curvature = !rough && settles ? find_curvature(&d) : -1.0;
    minimum->value = d.value;
    minimum->gradient = largest_of(count, d.g);
    minimum->evaluations = d.evaluations;
    minimum->converged = minimum->curvature > 0 && minimum->gradient <= settled * size_of(d.value);
    memcpy(x, d.x, (size_t)count * sizeof *x);
    return 1;
}
