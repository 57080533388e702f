/* complete.c -- [NiWang2015] sections 2.4, 2.5 and 7: finite Lidstone and Taylor series, summed in
 * Bernstein form. */
#include "construct/harmonic/complete.h"

#include "construct/harmonic/lidstone.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

enum { SIZE = TAUT_DEGREE_MAX + 2 };

typedef taut_wide curve[SIZE * 3];

/* A curve that sheds two degrees a step, and the same raised back to degree m. */
typedef struct chain {
    int m, degree;
    curve now, raised;
} chain;

static void chain_start(chain *c, int m, const double *points)
{
    c->m = c->degree = m;
    for (int i = 0; i < 3 * (m + 1); i++) {
        c->now[i] = points[i];
    }
}

static void chain_raise(chain *c)
{
    memcpy(c->raised, c->now, (size_t)(c->degree + 1) * 3 * sizeof(taut_wide));
    taut_raise_degree(c->degree, c->m, 3, c->raised);
}

static void chain_step(chain *c)
{
    if (c->degree >= 2) {
        taut_second_derivative(c->degree, c->now);
    }
    c->degree -= 2;
}

/* net[i][j] += scale factor[i] curve[j] */
static void add_product(int n, int m, taut_wide scale, const taut_wide *factor,
                        const taut_wide *points, taut_wide *net)
{
    for (int i = 0; i <= n; i++) {
        const taut_wide f = scale * factor[i];
        for (int c = 0; c < 3 * (m + 1); c++) {
            net[i * 3 * (m + 1) + c] += f * points[c];
        }
    }
}

/* The one rounding of a net. */
static void round_net(int n, int m, const taut_wide *wide, double *net)
{
    for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
        net[k] = (double)wide[k];
    }
}

static void reverse_factor(int n, const taut_wide *from, taut_wide *to)
{
    for (int i = 0; i <= n; i++) {
        to[i] = from[n - i];
    }
}

/* One more step of the u-factors: from degree d - 2 to d, kept low and raised to n. */
static void next_factor(int d, int n, taut_wide *low, taut_wide *raised)
{
    taut_wide next[SIZE];
    taut_lidstone_next(d, low, next);
    memcpy(low, next, (size_t)(d + 1) * sizeof(taut_wide));
    memcpy(raised, next, (size_t)(d + 1) * sizeof(taut_wide));
    taut_raise_degree(d, n, 1, raised);
}

/* S_k of even m = 2k: S_k'' = S_{k-1}, S_0 = 1. */
static void even_factor(int m, taut_wide *factor)
{
    taut_wide low[SIZE] = {1};
    factor[0] = 1;
    taut_raise_degree(0, m, 1, factor);
    for (int k = 1; 2 * k <= m; k++) {
        next_factor(2 * k, m, low, factor);
    }
}

/* The last term of even m = n, where both top derivatives are one constant: S_k has degree 2k and
 * not 2k + 1. */
static void add_even_term(int m, taut_wide scale, const chain *a, const chain *b, taut_wide *net)
{
    taut_wide raised[SIZE];
    curve mean;
    even_factor(m, raised);
    for (int c = 0; c < 3 * (m + 1); c++) {
        mean[c] = 0.5L * (a->raised[c] + b->raised[c]);
    }
    add_product(m, m, scale, raised, mean, net);
}

void taut_harmonic_from_rows(int n, int m, taut_wide mu, const double *row0, const double *row1,
                             taut_wide *wide, double *net)
{
    taut_wide low[SIZE] = {0, 1}, factor[SIZE] = {0, 1}, mirrored[SIZE];
    chain a, b;
    taut_wide scale = 1;

    memset(wide, 0, (size_t)(n + 1) * (size_t)(m + 1) * 3 * sizeof *wide);
    chain_start(&a, m, row0);
    chain_start(&b, m, row1);
    taut_raise_degree(1, n, 1, factor); /* Lambda_0(u) = u */
    for (int k = 0; 2 * k <= m; k++) {
        chain_raise(&a);
        chain_raise(&b);
        if (2 * k + 1 > n) {
            add_even_term(m, scale, &a, &b, wide);
            break;
        }
        if (k > 0) {
            next_factor(2 * k + 1, n, low, factor);
        }
        reverse_factor(n, factor, mirrored);
        add_product(n, m, scale, mirrored, a.raised, wide);
        add_product(n, m, scale, factor, b.raised, wide);
        scale *= -mu;
        chain_step(&a);
        chain_step(&b);
    }
    round_net(n, m, wide, net);
}

/* K = max_i sum_k m!/(m-2k)! (4 mu)^k (|Lambda_k(1-.)|_i + |Lambda_k|_i); of even m = n the last
 * term has |S_k|_i for the sum of both. All coefficients of one Lambda_k, or S_k, have one sign. */
double taut_harmonic_rows_amplification(int n, int m, taut_wide mu)
{
    taut_wide low[SIZE] = {0, 1}, factor[SIZE] = {0, 1}, sum[SIZE] = {0};
    taut_wide scale = 1, most = 0;

    taut_raise_degree(1, n, 1, factor);
    for (int k = 0; 2 * k <= m && 2 * k + 1 <= n; k++) {
        if (k > 0) {
            next_factor(2 * k + 1, n, low, factor);
            scale *= 4 * mu * (m - 2 * k + 2) * (m - 2 * k + 1);
        }
        for (int i = 0; i <= n; i++) {
            sum[i] += scale * (fabsl(factor[i]) + fabsl(factor[n - i]));
        }
    }
    if (m == n && m % 2 == 0) {
        even_factor(m, factor);
        scale *= 8 * mu;
        for (int i = 0; i <= n; i++) {
            sum[i] += scale * fabsl(factor[i]);
        }
    }
    for (int i = 0; i <= n; i++) {
        most = fmaxl(most, sum[i]);
    }
    return (double)most;
}

static void wide_from_derivative(int n, int m, taut_wide mu, const double *row, taut_wide width,
                                 const double *cross, taut_wide *net)
{
    taut_wide factor[SIZE];
    chain f, g;
    taut_wide even = 1, odd = width; /* (-mu)^k / (2k)!, width (-mu)^k / (2k+1)! */

    memset(net, 0, (size_t)(n + 1) * (size_t)(m + 1) * 3 * sizeof *net);
    chain_start(&f, m, row);
    chain_start(&g, m, cross);
    for (int k = 0; 2 * k <= m && 2 * k <= n; k++) {
        chain_raise(&f);
        chain_raise(&g);
        taut_power_coefficients(2 * k, n, factor);
        add_product(n, m, even, factor, f.raised, net);
        if (2 * k + 1 <= n) {
            taut_power_coefficients(2 * k + 1, n, factor);
            add_product(n, m, odd, factor, g.raised, net);
        }
        even *= -mu / ((2 * k + 1) * (2 * k + 2));
        odd *= -mu / ((2 * k + 2) * (2 * k + 3));
        chain_step(&f);
        chain_step(&g);
    }
}

void taut_harmonic_from_derivative(int n, int m, taut_wide mu, const double *row, taut_wide width,
                                   const double *cross, taut_wide *wide, double *net)
{
    wide_from_derivative(n, m, mu, row, width, cross, wide);
    round_net(n, m, wide, net);
}

/* Adds |net| of one unit vector (three of them at once, one a coordinate) to `sum`. */
static taut_wide add_sizes(int n, int m, const taut_wide *net, taut_wide *sum)
{
    taut_wide most = 0;
    for (int i = 0; i < (n + 1) * (m + 1); i++) {
        for (int c = 0; c < 3; c++) {
            sum[i] += fabsl(net[3 * i + c]);
        }
        most = fmaxl(most, sum[i]);
    }
    return most;
}

/* The map is linear, so its norm is the largest sum of sizes over unit data: point j of row 0 (then
 * P_u = -n times it) and of row 1 (P_u = n times it). */
double taut_harmonic_derivative_amplification(int n, int m, taut_wide mu, taut_wide *scratch)
{
    taut_wide *net = scratch, *sum = scratch + 3 * (n + 1) * (m + 1), most = 0;

    memset(sum, 0, (size_t)(n + 1) * (size_t)(m + 1) * sizeof *sum);
    for (int first = 0; first < 2 * (m + 1); first += 3) {
        double row[SIZE * 3] = {0}, cross[SIZE * 3] = {0};
        for (int c = 0; c < 3 && first + c < 2 * (m + 1); c++) {
            const int j = (first + c) % (m + 1);
            const int next = first + c > m;
            row[3 * j + c] = next ? 0 : 1;
            cross[3 * j + c] = next ? n : -n;
        }
        wide_from_derivative(n, m, mu, row, 1, cross, net);
        most = add_sizes(n, m, net, sum);
    }
    return (double)most;
}
