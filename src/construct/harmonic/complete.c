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

/* A curve that sheds two degrees a step, and the same raised back to degree m. The powers of mu go
 * into it: by themselves they would leave the range of numbers where their terms do not. */
typedef struct chain {
    int m, degree;
    curve now, raised;
} chain;

static void chain_start(chain *c, int m, const double *points)
{
    c->m = c->degree = m;
    for (int i = 0; i < 3 * (m + 1); i++) {
        c->now[i] = taut_twice_of(points[i]);
    }
}

static void chain_raise(chain *c)
{
    memcpy(c->raised, c->now, (size_t)(c->degree + 1) * 3 * sizeof(taut_twice));
    taut_raise_degree(c->degree, c->m, 3, c->raised);
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
    return taut_pulse_beat(pulse, 2 * TAUT_TWICE_WORK * (2 * raised + 3.0 * (n + 1) * (m + 1)));
}

/* net[i][j] += factor[i] curve[j] */
static void add_product(int n, int m, const taut_twice *factor, const taut_twice *points,
                        taut_twice *net)
{
    for (int i = 0; i <= n; i++) {
        taut_wide_gain(3 * (m + 1), factor[i], points, net + i * 3 * (m + 1));
    }
}

/* The one rounding of a net. */
static void round_net(int n, int m, const taut_twice *wide, double *net)
{
    for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
        net[k] = taut_twice_round(wide[k]);
    }
}

static void reverse_factor(int n, const taut_twice *from, taut_twice *to)
{
    for (int i = 0; i <= n; i++) {
        to[i] = from[n - i];
    }
}

/* One more step of the u-factors, 8 times it: from degree d - 2 to d, kept low and raised to n.
 * Lambda_k falls as pi^-2k, and 8^k Lambda_k stays in sight of 1. */
static void next_factor(int d, int n, taut_twice *low, taut_twice *raised)
{
    taut_twice next[SIZE];
    taut_lidstone_next(d, low, next);
    for (int i = 0; i <= d; i++) {
        low[i] = raised[i] = taut_twice_scale(8, next[i]);
    }
    taut_raise_degree(d, n, 1, raised);
}

/* 8^k S_k of even m = 2k: S_k'' = S_{k-1}, S_0 = 1. */
static void even_factor(int m, taut_twice *factor)
{
    taut_twice low[SIZE] = {{1, 0}};
    factor[0] = taut_twice_of(1);
    taut_raise_degree(0, m, 1, factor);
    for (int k = 1; 2 * k <= m; k++) {
        next_factor(2 * k, m, low, factor);
    }
}

/* The last term of even m = n, where both top derivatives are one constant: S_k has degree 2k and
 * not 2k + 1. */
static void add_even_term(int m, const chain *a, const chain *b, taut_twice *net)
{
    taut_twice raised[SIZE];
    curve mean;
    even_factor(m, raised);
    for (int c = 0; c < 3 * (m + 1); c++) {
        mean[c] = taut_twice_scale(0.5, taut_twice_add(a->raised[c], b->raised[c]));
    }
    add_product(m, m, raised, mean, net);
}

void taut_harmonic_from_rows(int n, int m, taut_twice mu, const double *row0, const double *row1,
                             taut_twice *wide, double *net, taut_pulse *pulse)
{
    const taut_twice step = taut_twice_scale(-0.125, mu);
    taut_twice low[SIZE] = {{0, 0}, {1, 0}}, factor[SIZE] = {{0, 0}, {1, 0}}, mirrored[SIZE];
    chain a, b;

    memset(wide, 0, (size_t)(n + 1) * (size_t)(m + 1) * 3 * sizeof *wide);
    chain_start(&a, m, row0);
    chain_start(&b, m, row1);
    taut_raise_degree(1, n, 1, factor); /* Lambda_0(u) = u */
    for (int k = 0; 2 * k <= m && !beat_of_term(n, m, k, pulse); k++) {
        chain_raise(&a);
        chain_raise(&b);
        if (2 * k + 1 > n) {
            add_even_term(m, &a, &b, wide);
            break;
        }
        if (k > 0) {
            next_factor(2 * k + 1, n, low, factor);
        }
        reverse_factor(n, factor, mirrored);
        add_product(n, m, mirrored, a.raised, wide);
        add_product(n, m, factor, b.raised, wide);
        chain_step(&a, step);
        chain_step(&b, step);
    }
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
    taut_twice low[SIZE] = {{0, 0}, {1, 0}}, factor[SIZE] = {{0, 0}, {1, 0}};
    double sum[SIZE] = {0}, scale = 1; /* m!/(m-2k)! (4 mu)^k / 8^k */

    taut_raise_degree(1, n, 1, factor);
    for (int k = 0; 2 * k <= m && 2 * k + 1 <= n && !beat_of_term(n, m, k, pulse); k++) {
        if (k > 0) {
            next_factor(2 * k + 1, n, low, factor);
            scale *= 0.5 * mu * (m - 2 * k + 2) * (m - 2 * k + 1);
        }
        for (int i = 0; i <= n; i++) {
            sum[i] += scale * (size_of(factor[i]) + size_of(factor[n - i]));
        }
    }
    if (m == n && m % 2 == 0) {
        even_factor(m, factor);
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
    taut_twice factor[SIZE];
    chain f, g;

    memset(net, 0, (size_t)(n + 1) * (size_t)(m + 1) * 3 * sizeof *net);
    chain_start(&f, m, row);
    chain_start(&g, m, cross);
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
