/* basis.c -- functions of every basis and their derivatives, each by the formula that says least:
 *
 *     piecewise polynomials  the recursion over degrees, D^r N = p (D^(r-1) N / .. - D^(r-1) N / ..)
 *     c-, h-                 with g_0 = t - sin t (sinh t - t) and g_k its k-th derivative, on [0, a]
 *         bezier    B_3 = g_0(t) / g_0(a),  B_2 = m (g_1(t) / g_1(a) - g_0(t) / g_0(a)), mirrored;
 *                   m such that B_2 + B_3 has no slope at a
 *         bspline   Z_3 = g_0(t) / (2 a g_1(a)),  Z_1 = Z_3 - 2 Z_0 + (a - t) / a, mirrored
 *     ce-bezier              the four products of docs/papers/pipe.md section 2.1, multiplied out
 */
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int take_breaks(oracle_basis *own, int spans)
{
    own->spans = spans;
    own->breaks = calloc((size_t)spans + 1, sizeof *own->breaks);
    own->first = calloc((size_t)spans + 1, sizeof *own->first);
    return own->breaks != NULL && own->first != NULL;
}

static int take_knots(const taut_basis_spec *spec, int is_bezier, oracle_basis *own)
{
    const int n = is_bezier ? 2 * (spec->degree + 1) : spec->knot_count;
    int spans = 0;

    own->type = 'p';
    own->degree = spec->degree;
    own->local = own->degree + 1;
    own->count = n - own->degree - 1;
    own->knots = calloc((size_t)n, sizeof *own->knots);
    if (own->knots == NULL || own->local > ORACLE_LOCAL_MAX || !take_breaks(own, n)) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        own->knots[i] = is_bezier ? (i <= own->degree ? own->lo : own->hi) : spec->knots[i];
    }
    for (int i = own->degree; i < own->count; i++) {
        if (own->knots[i + 1] > own->knots[i]) {
            own->first[spans] = i - own->degree;
            own->breaks[spans++] = own->knots[i];
        }
    }
    own->breaks[spans] = own->knots[own->count];
    own->spans = spans;
    own->lo = own->breaks[0];
    own->hi = own->breaks[spans];
    return 1;
}

static int take_segments(const taut_basis_spec *spec, char kind, oracle_basis *own)
{
    const int bspline = strstr(spec->type, "bspline") != NULL;
    const int spans = bspline ? spec->segments : 1;

    own->type = bspline ? (kind == 'c' ? 'C' : 'H') : kind;
    own->length = kind == 'c' ? spec->alpha : spec->beta;
    own->local = 4;
    own->count = spans + 3;
    if (!take_breaks(own, spans)) {
        return 0;
    }
    for (int i = 0; i <= spans; i++) {
        own->breaks[i] = own->lo + (own->hi - own->lo) * i / spans;
        own->first[i] = i;
    }
    return 1;
}

int oracle_basis_of(const taut_basis *basis, oracle_basis *own)
{
    taut_basis_spec spec;

    memset(own, 0, sizeof *own);
    taut_basis_spec_of(basis, &spec);
    own->lo = taut_basis_lo(basis);
    own->hi = taut_basis_hi(basis);
    if (strcmp(spec.type, "bezier") == 0 || strcmp(spec.type, "bspline") == 0) {
        return take_knots(&spec, strcmp(spec.type, "bezier") == 0, own);
    }
    if (strcmp(spec.type, "ce-bezier") == 0) {
        own->type = 'e';
        own->local = own->count = 4;
        own->shape[0] = spec.alpha;
        own->shape[1] = spec.beta;
        own->shape[2] = spec.gamma;
        if (!take_breaks(own, 1)) {
            return 0;
        }
        own->breaks[0] = own->lo;
        own->breaks[1] = own->hi;
        return 1;
    }
    if (strncmp(spec.type, "c-", 2) == 0 || strncmp(spec.type, "h-", 2) == 0) {
        return take_segments(&spec, spec.type[0], own);
    }
    return 0;
}

void oracle_basis_free(oracle_basis *own)
{
    free(own->knots);
    free(own->breaks);
    free(own->first);
    memset(own, 0, sizeof *own);
}

int oracle_basis_span(const oracle_basis *basis, oracle_real t)
{
    int span = 0;

    while (span + 1 < basis->spans && t >= (oracle_real)basis->breaks[span + 1]) {
        span++;
    }
    return span;
}

/* From the functions of degree q - 1 alive between knots k and k + 1 to those of degree q: their
 * values (derive 0) or, of derivatives, the next ones. */
static void step_degree(const double *knots, int k, int q, oracle_real t, int derive,
                        oracle_real *n)
{
    oracle_real next[ORACLE_LOCAL_MAX + 1];

    for (int a = 0; a <= q; a++) {
        const int i = k - q + a; /* function i lives on knots i .. i + q + 1 */
        oracle_real left = 0, right = 0;
        if (a > 0) {
            const oracle_real width = (oracle_real)knots[i + q] - (oracle_real)knots[i];
            left = n[a - 1] / width * (derive ? q : t - (oracle_real)knots[i]);
        }
        if (a < q) {
            const oracle_real width = (oracle_real)knots[i + q + 1] - (oracle_real)knots[i + 1];
            right = n[a] / width * (derive ? -q : (oracle_real)knots[i + q + 1] - t);
        }
        next[a] = left + right;
    }
    memcpy(n, next, (size_t)(q + 1) * sizeof *n);
}

/* The same between two knots alone, where all widths are one: t - lo and hi - t come over it. */
static void step_single(int q, oracle_real t, oracle_real u, oracle_real *n)
{
    n[q] = t * n[q - 1];
    for (int a = q - 1; a > 0; a--) {
        n[a] = t * n[a - 1] + u * n[a];
    }
    n[0] *= u;
}

static void polynomial_row(const oracle_basis *basis, int span, oracle_real t, int order,
                           oracle_row *row)
{
    const int k = basis->first[span] + basis->degree;
    const int single = basis->count == basis->local && basis->knots[0] == basis->lo &&
                       basis->knots[2 * basis->degree + 1] == basis->hi;
    const oracle_real lo = basis->lo, hi = basis->hi, width = hi - lo;
    const oracle_real high = (t - lo) / width, low = (hi - t) / width;

    for (int r = 0; r <= order; r++) {
        memset(row->n[r], 0, (size_t)basis->local * sizeof row->n[r][0]);
        if (r > basis->degree) {
            continue;
        }
        row->n[r][0] = 1;
        for (int q = 1; q <= basis->degree; q++) {
            if (single && q <= basis->degree - r) {
                step_single(q, high, low, row->n[r]);
            } else {
                step_degree(basis->knots, k, q, t, q > basis->degree - r, row->n[r]);
            }
        }
    }
}

static oracle_real g(int circular, int k, oracle_real t)
{
    if (k == 0) { /* by its series where terms would cancel */
        oracle_real sum = 0, term = t * t * t / 6;
        if (fabsl(t) > 1) {
            return circular ? t - sinl(t) : sinhl(t) - t;
        }
        for (int i = 0; i < 14; i++) {
            sum += term;
            term *= (circular ? -1 : 1) * t * t / (oracle_real)((2 * i + 4) * (2 * i + 5));
        }
        return sum;
    }
    if (k == 1) {
        const oracle_real half = circular ? sinl(t / 2) : sinhl(t / 2);
        return 2 * half * half;
    }
    if (circular) {
        return k == 2 ? sinl(t) : k == 3 ? cosl(t) : k == 4 ? -sinl(t) : -cosl(t);
    }
    return k % 2 == 0 ? sinhl(t) : coshl(t);
}

/* Derivative k of functions 3 (and 2) at t of a segment of length a. */
static oracle_real quasi_last(int circular, int bspline, oracle_real a, int k, oracle_real t)
{
    return g(circular, k, t) / (bspline ? 2 * a * g(circular, 1, a) : g(circular, 0, a));
}

static oracle_real quasi_third(int circular, oracle_real a, int k, oracle_real t)
{
    const oracle_real slope = g(circular, 2, a) / g(circular, 1, a);
    const oracle_real steep = g(circular, 1, a) / g(circular, 0, a);

    return steep / (steep - slope) *
           (g(circular, k + 1, t) / g(circular, 1, a) - g(circular, k, t) / g(circular, 0, a));
}

static void quasi_row(const oracle_basis *basis, int span, oracle_real t, int order,
                      oracle_row *row)
{
    const int circular = basis->type == 'c' || basis->type == 'C';
    const int bspline = basis->type == 'C' || basis->type == 'H';
    const oracle_real a = (oracle_real)basis->length, s = t - (oracle_real)basis->breaks[span];

    for (int k = 0; k <= order; k++) {
        const oracle_real sign = k % 2 == 0 ? 1 : -1;
        const oracle_real z3 = quasi_last(circular, bspline, a, k, s);
        const oracle_real z0 = sign * quasi_last(circular, bspline, a, k, a - s);
        row->n[k][0] = z0;
        row->n[k][3] = z3;
        if (bspline) {
            const oracle_real rise = k == 0 ? s / a : k == 1 ? 1 / a : 0;
            const oracle_real fall = k == 0 ? (a - s) / a : k == 1 ? -1 / a : 0;
            row->n[k][1] = z3 - 2 * z0 + fall;
            row->n[k][2] = z0 - 2 * z3 + rise;
        } else {
            row->n[k][1] = sign * quasi_third(circular, a, k, a - s);
            row->n[k][2] = quasi_third(circular, a, k, s);
        }
    }
}

/* Derivatives of c t^a (1-t)^b, added. */
static void add_product(oracle_real c, int a, int b, oracle_real t, int order, oracle_real *out)
{
    static const int choose[5][5] = {
        {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};

    for (int k = 0; k <= order; k++) {
        for (int i = 0; i <= k; i++) { /* i derivatives of t^a, k - i of (1-t)^b */
            oracle_real term = c * choose[k][i];
            if (i > a || k - i > b) {
                continue;
            }
            for (int j = 0; j < i; j++) {
                term *= a - j;
            }
            for (int j = 0; j < k - i; j++) {
                term *= -(b - j);
            }
            out[k] += term * powl(t, a - i) * powl(1 - t, b - (k - i));
        }
    }
}

static void shaped_row(const oracle_basis *basis, oracle_real t, int order, oracle_row *row)
{
    const oracle_real a = basis->shape[0], b = basis->shape[1], c = basis->shape[2];
    const struct {
        int function, t, u;
        oracle_real factor;
    } products[] = {{0, 0, 3, 1}, {0, 1, 3, -a}, {1, 1, 2, 3}, {1, 1, 3, a}, {1, 2, 2, b},
                    {2, 2, 1, 3}, {2, 2, 2, -b}, {2, 3, 1, c}, {3, 3, 0, 1}, {3, 3, 1, -c}};

    for (int i = 0; i < 4; i++) {
        oracle_real sum[ORACLE_ORDER_MAX + 1] = {0};
        for (size_t k = 0; k < sizeof products / sizeof products[0]; k++) {
            if (products[k].function == i) {
                add_product(products[k].factor, products[k].t, products[k].u, t, order, sum);
            }
        }
        for (int k = 0; k <= order; k++) {
            row->n[k][i] = sum[k];
        }
    }
}

void oracle_basis_row(const oracle_basis *basis, int span, oracle_real t, int order,
                      oracle_row *row)
{
    row->first = basis->first[span];
    row->local = basis->local;
    if (basis->type == 'p') {
        polynomial_row(basis, span, t, order, row);
    } else if (basis->type == 'e') {
        shaped_row(basis, t, order, row);
    } else {
        quasi_row(basis, span, t, order, row);
    }
}
