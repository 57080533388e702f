/* quasi.c -- c- and h- functions by Chebyshev polynomials.
 *
 * About the middle m of a span of width h, with z = h/2 and t = m + z x, -1 <= x <= 1,
 *
 *     f(t) = f(m) + f'(m) z x + f''(m) C(z x) + f'''(m) S(z x)
 *     C(y) = 1 - cos y, S(y) = y - sin y    or    cosh y - 1, sinh y - y
 *
 * ([XuWang2006] section 3: the functions are sums of 1, t, sine and cosine), where ([DLMF] 10.12,
 * 10.35)
 *
 *     cos z x = J_0 + 2 sum (-1)^k J_2k T_2k(x)       sin z x = 2 sum (-1)^k J_(2k+1) T_(2k+1)(x)
 *     cosh z x = I_0 + 2 sum I_2k T_2k(x)             sinh z x = 2 sum I_(2k+1) T_(2k+1)(x)
 *
 *     |J_n| <= I_n <= (z/2)^n / n! exp(z^2 / 4 (n + 1)),     |T_n'| <= n^2,  |T_n''| <= n^2 (n^2 - 1) / 3
 *
 * All terms up to degree d are taken, the others bounded; so is what the four derivatives in m may be
 * off by: the accuracy that taut/basis.h states, and the rounding of m and of the ends of the span.
 */
#include "certify/common/quasi.h"

#include "certify/common/bernstein.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum { TERMS = 64, ORDERS = 3, FEWEST = 5 };

static const double accuracy =
    1e-14;                          /* of derivatives, of the largest of their order on the span */
static const double goal = 0x1p-45; /* what a degree may miss, the functions being at most 1 */
static const double widest = 4;     /* spans: beyond them cosh y - 1 loses digits */
/* Of the sum of absolute terms of a coefficient: 64 terms, each of a Bessel function, a binomial
 * quotient and a raise by at most 24 degrees. */
static const double rounding = 0x1p-46;
static const double up = 1 + 0x1p-30;

static int is_circular(const taut_basis *basis)
{
    return strcmp(taut_basis_type(basis), "c-bezier") == 0 ||
           strcmp(taut_basis_type(basis), "c-bspline") == 0;
}

static int is_hyperbolic(const taut_basis *basis)
{
    return strcmp(taut_basis_type(basis), "h-bezier") == 0 ||
           strcmp(taut_basis_type(basis), "h-bspline") == 0;
}

/* J_n(z) for sign -1, I_n(z) for 1, by its series: sum sign^j (z/2)^(n+2j) / j! (n+j)!, from the
 * term `from` on. */
static double bessel(int sign, int n, int from, double z)
{
    double term = 1, sum = 0;

    for (int k = 1; k <= n; k++) {
        term *= 0.5 * z / k;
    }
    for (int j = 0; j < TERMS; j++) {
        sum += j >= from ? term : 0;
        term *= sign * (0.25 * z * z) / ((j + 1.0) * (n + j + 1.0));
    }
    return sum;
}

/* What |J_n|, I_n and the absolute terms of their series from `from` on are at most. */
static double bessel_bound(int n, int from, double z)
{
    double term = up * taut_exp(z * z / (4 * (n + 1.0)));

    for (int k = 1; k <= n; k++) {
        term *= up * 0.5 * z / k;
    }
    return from == 0 ? term : term * up * (0.25 * z * z) / (n + 1.0);
}

/* The factor of T_n in C (even n) or S (odd n), and a bound of its size: 1 - J_0 and z - 2 J_1 are
 * their series without the first term, in which nothing cancels. */
static double series_factor(int sign, int n, double z, double *size)
{
    const int from = n < 2;
    const double value = bessel(sign, n, from, z);
    const int is_minus = sign < 0 && n / 2 % 2 == 0;

    *size = 2 * bessel_bound(n, from, z);
    return (is_minus ? -1 : 1) * (n == 0 ? 1 : 2) * value;
}

/* tail[r], r = 0..2: what terms above degree d of C (parity 0) or S (1), and of their derivatives by
 * s = (1 + x) / 2, are at most. */
static void bound_tail(int d, int parity, double z, double tail[ORDERS])
{
    memset(tail, 0, ORDERS * sizeof *tail);
    for (int n = d + 1; n <= d + TERMS; n++) {
        const double square = (double)n * n;
        const double size = n % 2 == parity ? 2 * bessel_bound(n, 0, z) : 0;
        tail[0] += size;
        tail[1] += 2 * square * size;
        tail[2] += 4 * square * (square - 1) / 3 * size;
    }
    for (int r = 0; r < ORDERS; r++) {
        tail[r] *= 1 + 0x1p-20; /* terms beyond these: each less than a tenth of the one before */
    }
}

/* Derivatives 0..3 of the four functions in the middle, and bounds of what these are off by. */
typedef struct middle {
    double f[4][TAUT_QUASI_FUNCTIONS];
    double off[4];
} middle;

static void find_middle(const taut_basis *basis, int span, double lo, double hi, middle *m)
{
    const double y = 0.5 * (hi - lo), place = fabs(lo) + fabs(hi);
    const double sine = taut_sinh(y), versine = taut_cosh(y) - 1;
    double size[5] = {1, 0, 0, 0, 0};

    (void)taut_basis_eval(basis, span, lo + 0.5 * (hi - lo), 3, m->f[0]);
    for (int a = 0; a < TAUT_QUASI_FUNCTIONS; a++) {
        const double first = fabs(m->f[1][a]), second = fabs(m->f[2][a]), third = fabs(m->f[3][a]);
        size[1] = fmax(size[1], first + second * sine + third * versine);
        size[2] = fmax(size[2], second * (versine + 1) + third * sine);
        size[3] = fmax(size[3], second * sine + third * (versine + 1));
    }
    size[4] = size[2]; /* f'''' = -f'' or f'' */
    for (int r = 0; r < 4; r++) {
        m->off[r] = up * (accuracy * size[r] + 8 * TAUT_UNIT_ROUNDOFF * place * size[r + 1]);
    }
}

/* What derivatives that are off by m->off add to delta and its derivatives by s. */
static void bound_middle(const middle *m, double y, double delta[ORDERS])
{
    const double versine = taut_cosh(y) - 1, h = 2 * y;

    delta[0] = m->off[0] + m->off[1] * y + m->off[2] * versine + m->off[3] * (taut_sinh(y) - y);
    delta[1] = h * (m->off[1] + m->off[2] * taut_sinh(y) + m->off[3] * versine);
    delta[2] = h * h * (m->off[2] * (versine + 1) + m->off[3] * taut_sinh(y));
}

/* What errors of the coefficients must be for the tails of degree d, whatever the derivative. */
static double share_of_tails(const middle *m, int a, int d, double tails[2][ORDERS],
                             const double known[ORDERS])
{
    const double shares[ORDERS] = {1, 2.0 * d, 4.0 * d * (d - 1)};
    double most = 0;

    for (int r = 0; r < ORDERS; r++) {
        const double tail = fabs(m->f[2][a]) * tails[0][r] + fabs(m->f[3][a]) * tails[1][r];
        most = fmax(most, (tail + known[r]) / shares[r]);
    }
    return most;
}

/* The fewest degrees that miss no more than is wanted; 0: none do. */
static int choose_degree(const middle *m, double z)
{
    static const double none[ORDERS] = {0, 0, 0};

    for (int d = FEWEST; d <= TAUT_QUASI_DEGREE; d++) {
        double tails[2][ORDERS], most = 0;
        bound_tail(d, 0, z, tails[0]);
        bound_tail(d, 1, z, tails[1]);
        for (int a = 0; a < TAUT_QUASI_FUNCTIONS; a++) {
            most = fmax(most, share_of_tails(m, a, d, tails, none));
        }
        if (most <= goal) {
            return d;
        }
    }
    return 0;
}

/* Row n: the coefficients of T_n on [0, 1], raised to degree d, and the sums of the absolute terms
 * that they are made of. */
typedef struct chebyshev {
    double c[TAUT_QUASI_DEGREE + 1][TAUT_QUASI_DEGREE + 1];
    double size[TAUT_QUASI_DEGREE + 1][TAUT_QUASI_DEGREE + 1];
} chebyshev;

static void fill_chebyshev(int d, chebyshev *t)
{
    memset(t, 0, sizeof *t);
    for (int n = 0; n <= d; n++) {
        for (int j = 0; j <= n; j++) {
            const double own = taut_certify_binomial(2 * n, 2 * j);
            for (int k = j; k <= d - n + j; k++) {
                const double share =
                    own * taut_certify_binomial(d - n, k - j) / taut_certify_binomial(d, k);
                t->c[n][k] += (n - j) % 2 == 0 ? share : -share;
                t->size[n][k] += share;
            }
        }
    }
}

/* c_a; returns the largest sum of the absolute terms of one. */
static double add_terms(const middle *m, int a, const chebyshev *t, const double *factor,
                        const double *factor_size, double z, taut_quasi_span *out)
{
    const int d = out->degree;
    double most = 0;

    for (int k = 0; k <= d; k++) {
        double size = fabs(m->f[0][a]) + fabs(m->f[1][a]) * z;
        out->c[a][k] = m->f[0][a] + m->f[1][a] * z * (-1 + 2.0 * k / d);
        for (int n = 0; n <= d; n++) {
            const double f = m->f[n % 2 == 0 ? 2 : 3][a];
            out->c[a][k] += f * factor[n] * t->c[n][k];
            size += fabs(f) * factor_size[n] * t->size[n][k];
        }
        most = fmax(most, size);
    }
    return most;
}

/* The polynomials, their degree being chosen. */
static void fill_span(const middle *m, int sign, double z, taut_quasi_span *out)
{
    double tails[2][ORDERS], known[ORDERS];
    double factor[TAUT_QUASI_DEGREE + 1], size[TAUT_QUASI_DEGREE + 1];
    chebyshev t;

    fill_chebyshev(out->degree, &t);
    for (int n = 0; n <= out->degree; n++) {
        factor[n] = series_factor(sign, n, z, &size[n]);
    }
    bound_tail(out->degree, 0, z, tails[0]);
    bound_tail(out->degree, 1, z, tails[1]);
    bound_middle(m, z, known);
    for (int a = 0; a < TAUT_QUASI_FUNCTIONS; a++) {
        const double gross = add_terms(m, a, &t, factor, size, z, out);
        const double delta = share_of_tails(m, a, out->degree, tails, known);
        out->missed[a] = up * (delta + rounding * gross);
    }
}

int taut_certify_quasi(const taut_basis *basis, int span, taut_quasi_span *out)
{
    const double lo = taut_basis_breaks(basis)[span], hi = taut_basis_breaks(basis)[span + 1];
    const int is_quasi = is_circular(basis) || is_hyperbolic(basis);
    middle m;

    if (!is_quasi || !(hi - lo <= widest)) {
        return 0;
    }
    find_middle(basis, span, lo, hi, &m);
    out->degree = choose_degree(&m, 0.5 * (hi - lo));
    if (out->degree == 0) {
        return 0;
    }
    fill_span(&m, is_circular(basis) ? -1 : 1, 0.5 * (hi - lo), out);
    return 1;
}

int taut_certify_degree(const taut_basis *basis)
{
    taut_quasi_span quasi;

    if (taut_basis_degree(basis) >= 0) {
        return taut_basis_degree(basis);
    }
    return taut_certify_quasi(basis, 0, &quasi) ? quasi.degree : -1;
}
