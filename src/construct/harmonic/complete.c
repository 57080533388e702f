/* complete.c -- [NiWang2015] sections 2.4, 2.5 and 7: finite Lidstone and Taylor series, summed in
 * Bernstein form. */
#include "construct/harmonic/complete.h"

#include "construct/harmonic/growth.h"
#include "construct/harmonic/lidstone.h"
#include "numeric/wide.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

enum { SIZE = TAUT_DEGREE_MAX + 2 };

typedef taut_twice curve[SIZE * 3];

/* A curve that sheds two degrees a step, and the same raised back to degree m, both weighted. The powers of mu go
 * into it: by themselves they would leave the range of numbers where their terms do not. */
typedef struct chain {
    int m, degree;
    curve now, raised;
} chain;

/* Half of x + sign y. */
static void chain_start(chain *c, int m, const taut_twice *weights, const double *x, double sign,
                        const double *y)
{
    c->m = c->degree = m;
    for (int i = 0; i < 3 * (m + 1); i++) {
        const taut_twice sum = taut_twice_sum(x[i], sign * y[i]);
        c->now[i] = taut_twice_times(weights[i / 3], taut_twice_scale(0.5, sum));
    }
}

static void chain_raise(chain *c)
{
    memcpy(c->raised, c->now, (size_t)(c->degree + 1) * 3 * sizeof(taut_twice));
    taut_raise_weighted(c->degree, c->m, 3, c->raised);
}

static void chain_step(chain *c, taut_twice scale)
{
    if (c->degree >= 2) {
        taut_second_derivative(c->degree, scale, c->now);
    }
    c->degree -= 2;
}

/* Of term k: two curves raised by 2 k degrees, two factors by as many as are left, two products with the net. Nonzero
 * when it is to end. */
static int beat_of_term(int n, int m, int k, taut_pulse *pulse)
{
    const double raised = 3.0 * (m + 1) * 2 * k + (n + 1.0) * (n + 1);
    return taut_pulse_beat(pulse, 2 * TAUT_TWICE_WORK * (raised + 3.0 * (n + 1) * (m + 1)));
}

/* net[i][j] += factor[i] curve[j] */
static void add_product(int n, int m, const taut_twice *factor, const taut_twice *points,
                        taut_twice *net)
{
    for (int i = 0; i <= n; i++) {
        taut_wide_gain(3 * (m + 1), factor[i], points, net + i * 3 * (m + 1));
    }
}

/* Where columns are weighted, and nothing else is. */
static void unweight_columns(int n, int m, const taut_twice *weights, taut_twice *net)
{
    curve inverse;
    for (int c = 0; c < 3 * (m + 1); c++) {
        inverse[c] = taut_twice_over(taut_twice_of(1), weights[c / 3]);
    }
    for (int i = 0; i <= n; i++) {
        taut_twice *const row = net + i * 3 * (m + 1);
        for (int c = 0; c < 3 * (m + 1); c++) {
            row[c] = taut_twice_times(row[c], inverse[c]);
        }
    }
}

/* The one rounding of a net. */
static void round_net(int n, int m, const taut_twice *wide, double *net)
{
    for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
        net[k] = taut_twice_round(wide[k]);
    }
}

/* From degree d to n, neither weighted; C(n,i) are the weights. */
static void raise_factor(int d, int n, const taut_twice *weights, const taut_twice *low,
                         taut_twice *raised)
{
    taut_binomials(d, raised);
    for (int i = 0; i <= d; i++) {
        raised[i] = taut_twice_times(raised[i], low[i]);
    }
    taut_raise_weighted(d, n, 1, raised);
    for (int i = 0; i <= n; i++) {
        raised[i] = taut_twice_over(raised[i], weights[i]);
    }
}

/* One more step of the u-factors, 8 times it: from degree d - 2 to d, kept low and raised to n.
 * Lambda_k falls as pi^-2k, and 8^k Lambda_k stays in sight of 1. */
static void next_factor(int d, int n, const taut_twice *weights, taut_twice *low,
                        taut_twice *raised)
{
    taut_twice next[SIZE];
    taut_lidstone_next(d, low, next);
    for (int i = 0; i <= d; i++) {
        low[i] = taut_twice_scale(8, next[i]);
    }
    raise_factor(d, n, weights, low, raised);
}

/* 8^k S_k of even m = 2k: S_k'' = S_{k-1}, S_0 = 1. */
static void even_factor(int m, const taut_twice *weights, taut_twice *factor)
{
    taut_twice low[SIZE] = {{1, 0}};
    raise_factor(0, m, weights, low, factor);
    for (int k = 1; 2 * k <= m; k++) {
        next_factor(2 * k, m, weights, low, factor);
    }
}

/* The last term of even m = n, where both top derivatives are one constant: S_k has degree 2k and
 * not 2k + 1. It is even about the middle. */
static void add_even_term(int m, const taut_twice *weights, const chain *mean, taut_twice *net)
{
    taut_twice factor[SIZE];
    even_factor(m, weights, factor);
    add_product(m / 2, m, factor, mean->raised, net);
}

/* Lambda_k(1-u) a + Lambda_k(u) b is a sum of an even and an odd part about the middle: line i of the first half has the
 * even one, line n - i the odd one. */
static void add_term(int n, int m, const taut_twice *factor, const chain *mean, const chain *half,
                     taut_twice *net)
{
    for (int i = 0; 2 * i <= n; i++) {
        const taut_twice near = factor[n - i], far = factor[i];
        taut_wide_gain(3 * (m + 1), taut_twice_add(near, far), mean->raised, net + i * 3 * (m + 1));
        if (2 * i < n) {
            taut_wide_gain(3 * (m + 1), taut_twice_less(near, far), half->raised,
                           net + (n - i) * 3 * (m + 1));
        }
    }
}

static void join_halves(int n, int m, taut_twice *net)
{
    for (int i = 0; 2 * i < n; i++) {
        taut_twice *const even = net + i * 3 * (m + 1), *const odd = net + (n - i) * 3 * (m + 1);
        for (int c = 0; c < 3 * (m + 1); c++) {
            const taut_twice sum = taut_twice_add(even[c], odd[c]);
            odd[c] = taut_twice_less(even[c], odd[c]);
            even[c] = sum;
        }
    }
}

void taut_harmonic_from_rows(int n, int m, taut_twice mu, const double *row0, const double *row1,
                             taut_twice *wide, double *net, taut_pulse *pulse)
{
    const taut_twice step = taut_twice_scale(-0.125, mu);
    taut_twice across[SIZE], along[SIZE], low[SIZE] = {{0, 0}, {1, 0}}, factor[SIZE];
    chain mean, half; /* of the sum and of the difference of both curves */

    memset(wide, 0, (size_t)(n + 1) * (size_t)(m + 1) * 3 * sizeof *wide);
    taut_binomials(n, across);
    taut_binomials(m, along);
    chain_start(&mean, m, along, row0, 1, row1);
    chain_start(&half, m, along, row0, -1, row1);
    raise_factor(1, n, across, low, factor); /* Lambda_0(u) = u */
    for (int k = 0; 2 * k <= m && !beat_of_term(n, m, k, pulse); k++) {
        chain_raise(&mean);
        chain_raise(&half);
        if (2 * k + 1 > n) {
            add_even_term(m, across, &mean, wide);
            break;
        }
        if (k > 0) {
            next_factor(2 * k + 1, n, across, low, factor);
        }
        add_term(n, m, factor, &mean, &half, wide);
        chain_step(&mean, step);
        chain_step(&half, step);
    }
    join_halves(n, m, wide);
    unweight_columns(n, m, along, wide);
    round_net(n, m, wide, net);
}

static double size_of(taut_twice x)
{
    return fabs(taut_twice_round(x));
}

static double find_largest(int count, const double *sum)
{
    double most = 0;
    for (int i = 0; i < count; i++) {
        most = taut_larger_growth(most, sum[i]);
    }
    return most;
}

/* K = max_i sum_k m!/(m-2k)! (4 mu)^k (|Lambda_k(1-.)|_i + |Lambda_k|_i); of even m = n the last
 * term has |S_k|_i for the sum of both. All coefficients of one Lambda_k, or S_k, have one sign. */
double taut_harmonic_rows_amplification(int n, int m, double mu, taut_pulse *pulse)
{
    taut_twice weights[SIZE], low[SIZE] = {{0, 0}, {1, 0}}, factor[SIZE];
    double sum[SIZE] = {0}, scale = 1; /* m!/(m-2k)! (4 mu)^k / 8^k */

    taut_binomials(n, weights);
    raise_factor(1, n, weights, low, factor);
    for (int k = 0; 2 * k <= m && 2 * k + 1 <= n && !beat_of_term(n, m, k, pulse); k++) {
        if (k > 0) {
            next_factor(2 * k + 1, n, weights, low, factor);
            scale *= 0.5 * mu * (m - 2 * k + 2) * (m - 2 * k + 1);
        }
        for (int i = 0; i <= n; i++) {
            sum[i] += scale * (size_of(factor[i]) + size_of(factor[n - i]));
        }
    }
    if (m == n && m % 2 == 0) {
        even_factor(m, weights, factor);
        scale *= mu;
        for (int i = 0; i <= n; i++) {
            sum[i] += scale * size_of(factor[i]);
        }
    }
    return find_largest(n + 1, sum);
}

/* The terms are (-mu)^k / (2k)! u^2k row^(2k) and (-mu)^k / (2k+1)! u^(2k+1) width cross^(2k). */
static void wide_from_derivative(int n, int m, taut_twice mu, const double *row, double width,
                                 const double *cross, taut_twice *net, taut_pulse *pulse)
{
    taut_twice weights[SIZE], factor[SIZE];
    chain f, g;

    memset(net, 0, (size_t)(n + 1) * (size_t)(m + 1) * 3 * sizeof *net);
    taut_binomials(m, weights);
    chain_start(&f, m, weights, row, 1, row);
    chain_start(&g, m, weights, cross, 1, cross);
    for (int i = 0; i < 3 * (m + 1); i++) {
        g.now[i] = taut_twice_scale(width, g.now[i]);
    }
    for (int k = 0; 2 * k <= m && 2 * k <= n && !beat_of_term(n, m, k, pulse); k++) {
        const int d = 2 * k;
        chain_raise(&f);
        chain_raise(&g);
        taut_power_coefficients(d, n, factor);
        add_product(n, m, factor, f.raised, net);
        if (d + 1 <= n) {
            taut_power_coefficients(d + 1, n, factor);
            add_product(n, m, factor, g.raised, net);
        }
        chain_step(&f, taut_twice_over_number(mu, -(d + 1) * (d + 2)));
        chain_step(&g, taut_twice_over_number(mu, -(d + 2) * (d + 3)));
    }
    unweight_columns(n, m, weights, net);
}

void taut_harmonic_from_derivative(int n, int m, taut_twice mu, const double *row, double width,
                                   const double *cross, taut_twice *wide, double *net,
                                   taut_pulse *pulse)
{
    wide_from_derivative(n, m, mu, row, width, cross, wide, pulse);
    round_net(n, m, wide, net);
}

/* Adds |net| of one unit vector (three of them at once, one a coordinate) to `sum`. */
static void add_sizes(int n, int m, const taut_twice *net, double *sum)
{
    for (int i = 0; i < (n + 1) * (m + 1); i++) {
        for (int c = 0; c < 3; c++) {
            sum[i] += size_of(net[3 * i + c]);
        }
    }
}

/* The map is linear, so its norm is the largest sum of sizes over unit data: point j of row 0 (then
 * P_u = -n times it) and of row 1 (P_u = n times it). */
double taut_harmonic_derivative_amplification(int n, int m, taut_twice mu, taut_twice *net,
                                              double *sum, taut_pulse *pulse)
{
    memset(sum, 0, (size_t)(n + 1) * (size_t)(m + 1) * sizeof *sum);
    for (int first = 0; first < 2 * (m + 1) && !taut_pulse_is_stopped(pulse); first += 3) {
        double row[SIZE * 3] = {0}, cross[SIZE * 3] = {0};
        for (int c = 0; c < 3 && first + c < 2 * (m + 1); c++) {
            const int j = (first + c) % (m + 1);
            const int next = first + c > m;
            row[3 * j + c] = next ? 0 : 1;
            cross[3 * j + c] = next ? n : -n;
        }
        wide_from_derivative(n, m, mu, row, 1, cross, net, pulse);
        add_sizes(n, m, net, sum);
    }
    return find_largest((n + 1) * (m + 1), sum);
}
