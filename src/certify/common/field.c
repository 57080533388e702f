/* field.c -- Bernstein coefficients with running errors.
 *
 * Every operation computes its coefficients in doubles and, beside them, a bound of
 *
 *     |what the errors of the arguments make of the result| + |what this operation rounds|
 *
 * with u = 2^-53 and gamma(n) = n u / (1 - n u), [Higham2002] (3.4). Bounds are themselves rounded:
 * they are sums of products of positive numbers, relatively right to a few hundred u, which SLACK
 * covers. TINY stands for what underflow may lose in one operation.
 */
#include "certify/common/field.h"

#include "certify/common/bernstein.h"
#include "certify/common/quasi.h"
#include "certify/common/verdict.h"
#include "core/constants.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const double unit = TAUT_UNIT_ROUNDOFF;
static const double slack = 1 + 0x1p-40;
static const double tiny = 0x1p-1060;
static const taut_field none = {0, 0, NULL, NULL};

static size_t size_of(const taut_field *f)
{
    return (size_t)(f->p + 1) * (size_t)(f->q + 1);
}

taut_field taut_field_new(taut_arena *arena, int p, int q)
{
    taut_field f = {p, q, NULL, NULL};
    if (p > TAUT_FIELD_DEGREE || q > TAUT_FIELD_DEGREE) {
        return none;
    }
    f.a = taut_arena_take(arena, 2 * size_of(&f), sizeof(double));
    f.e = f.a != NULL ? f.a + size_of(&f) : NULL;
    return f;
}

taut_field taut_field_constant(taut_arena *arena, double value)
{
    taut_field f = taut_field_new(arena, 0, 0);
    if (f.a != NULL) {
        f.a[0] = value;
    }
    return f;
}

taut_field taut_field_copy(taut_arena *arena, const taut_field *f)
{
    taut_field copy = f->a != NULL ? taut_field_new(arena, f->p, f->q) : none;
    if (copy.a != NULL) {
        memcpy(copy.a, f->a, 2 * size_of(f) * sizeof(double));
    }
    return copy;
}

/* row[k] = C(n, k), each of the one before: the same roundings as taut_certify_binomial has. */
static void fill_binomials(int n, double *row)
{
    row[0] = row[n] = 1;
    for (int k = 1; k <= n / 2; k++) {
        row[k] = row[n - k] = row[k - 1] * (n - k + 1) / k;
    }
}

/* f's coefficients times C(p, i) C(q, j): four roundings, two of them of the binomials. */
static double *scaled_of(taut_arena *arena, const taut_field *f, const double *values)
{
    double rows[2][TAUT_FIELD_DEGREE + 1];
    double *scaled = taut_arena_take_raw(arena, size_of(f), sizeof(double));
    if (scaled == NULL) {
        return NULL;
    }
    fill_binomials(f->p, rows[0]);
    fill_binomials(f->q, rows[1]);
    for (int i = 0; i <= f->p; i++) {
        for (int j = 0; j <= f->q; j++) {
            const size_t at = (size_t)i * (size_t)(f->q + 1) + (size_t)j;
            scaled[at] = rows[0][i] * rows[1][j] * values[at];
        }
    }
    return scaled;
}

/* Roundings of the binomials of a product: up to degree 50 they are exact on the way too, above they
 * are products of up to twice as many rounded factors, for both factors and the product. */
static int rounded_binomials(const taut_field *product)
{
    const int degree = product->p > product->q ? product->p : product->q;
    return degree <= 50 ? 0 : 4 * (product->p + product->q);
}

/* a += x y, e += size whole + error sizes; without `whole` no e. */
static void add_row(double x, double error, const double *restrict y, const double *restrict whole,
                    const double *restrict sizes, int count, double *restrict a, double *restrict e)
{
    const double size = fabs(x);

    for (int l = 0; l < count; l++) {
        a[l] += x * y[l];
        if (whole != NULL) {
            e[l] += size * whole[l] + error * sizes[l];
        }
    }
}

/* out.a += conv(fa, ga); out.e += conv(|fa|, whole) + conv(fe, sizes), all scaled; whole is
 * ge + gamma |ga|, sizes |ga| + ge, or NULL. Both are symmetric in f and g: of a square, rows i < k count
 * twice. */
static void convolve(const taut_field *f, const double *fa, const double *fe, const taut_field *g,
                     const double *ga, const double *whole, const double *sizes, taut_field *out)
{
    const int is_square = f->a == g->a;

    for (int i = 0; i <= f->p; i++) {
        for (int j = 0; j <= f->q; j++) {
            const size_t at = (size_t)i * (size_t)(f->q + 1) + (size_t)j;
            for (int k = is_square ? i : 0; k <= g->p; k++) {
                const size_t row = (size_t)k * (size_t)(g->q + 1);
                const size_t to = (size_t)(i + k) * (size_t)(out->q + 1) + (size_t)j;
                const double times = is_square && k > i ? 2 : 1;
                add_row(times * fa[at], times * fe[at], ga + row,
                        whole != NULL ? whole + row : NULL, sizes + row, g->q + 1, out->a + to,
                        out->e + to);
            }
        }
    }
}

/* The largest error of a coefficient. */
static double error_of(const taut_field *f)
{
    double most = 0;
    for (size_t k = 0; k < size_of(f); k++) {
        most = taut_certify_max(most, f->e[k]);
    }
    return most;
}

static taut_field multiply(taut_arena *arena, const taut_field *f, const taut_field *g, int is_even)
{
    double rows[2][TAUT_FIELD_DEGREE + 1];
    taut_field out = none;
    double *scaled[4], *whole = NULL;
    double gamma = 0, even = 0;

    if (f->a == NULL || g->a == NULL) {
        return none;
    }
    if (f->q > g->q) { /* the inner loop is over g */
        const taut_field *longer = f;
        f = g;
        g = longer;
    }
    out = taut_field_new(arena, f->p + g->p, f->q + g->q);
    scaled[0] = scaled_of(arena, f, f->a);
    scaled[1] = is_even ? f->e : scaled_of(arena, f, f->e);
    scaled[2] = scaled_of(arena, g, g->a);
    scaled[3] = is_even ? g->e : scaled_of(arena, g, g->e);
    whole = taut_arena_take_raw(arena, size_of(g), sizeof(double));
    if (out.a == NULL || scaled[0] == NULL || scaled[1] == NULL || scaled[2] == NULL ||
        scaled[3] == NULL || whole == NULL) {
        return none;
    }
    gamma =
        unit * (double)((f->p < g->p ? f->p + 1 : g->p + 1) * (f->q < g->q ? f->q + 1 : g->q + 1) +
                        rounded_binomials(&out) + 16);
    if (is_even) {
        const double size = taut_field_largest(f), other = taut_field_largest(g);
        even = slack * (size * error_of(g) + other * error_of(f) + gamma * size * other);
    }
    for (size_t k = 0; !is_even && k < size_of(g); k++) {
        const double size = fabs(scaled[2][k]), error = scaled[3][k];
        whole[k] = error + slack * gamma * size;
        scaled[3][k] = size + error;
    }
    convolve(f, scaled[0], scaled[1], g, scaled[2], is_even ? NULL : whole, scaled[3], &out);
    fill_binomials(out.p, rows[0]);
    fill_binomials(out.q, rows[1]);
    for (int i = 0; i <= out.p; i++) {
        for (int j = 0; j <= out.q; j++) {
            const size_t at = (size_t)i * (size_t)(out.q + 1) + (size_t)j;
            const double divisor = rows[0][i] * rows[1][j];
            out.a[at] /= divisor;
            out.e[at] = (is_even ? even : slack * out.e[at] / divisor) + tiny;
        }
    }
    return out;
}

taut_field taut_field_product(taut_arena *arena, const taut_field *f, const taut_field *g)
{
    return multiply(arena, f, g, 0);
}

taut_field taut_field_product_even(taut_arena *arena, const taut_field *f, const taut_field *g)
{
    return multiply(arena, f, g, 1);
}

taut_field taut_field_raise(taut_arena *arena, const taut_field *f, int up, int vp)
{
    taut_field ones = none, half = none;
    if (up == 0 && vp == 0) {
        return *f;
    }
    if (up > 0 && vp > 0) { /* one after the other: far fewer terms */
        half = taut_field_raise(arena, f, up, 0);
        return taut_field_raise(arena, &half, 0, vp);
    }
    ones = taut_field_new(arena, up, vp);
    for (size_t k = 0; ones.a != NULL && k < size_of(&ones); k++) {
        ones.a[k] = 1;
    }
    return taut_field_product(arena, f, &ones);
}

taut_field taut_field_combine(taut_arena *arena, double s, const taut_field *f, double t,
                              const taut_field *g)
{
    const int p = f->p > g->p ? f->p : g->p, q = f->q > g->q ? f->q : g->q;
    taut_field x = none, y = none, out = none;

    if (f->a == NULL || g->a == NULL) {
        return none;
    }
    x = taut_field_raise(arena, f, p - f->p, q - f->q);
    y = taut_field_raise(arena, g, p - g->p, q - g->q);
    out = taut_field_new(arena, p, q);
    if (x.a == NULL || y.a == NULL || out.a == NULL) {
        return none;
    }
    for (size_t k = 0; k < size_of(&out); k++) {
        const double a = s * x.a[k], b = t * y.a[k];
        out.a[k] = a + b;
        out.e[k] = slack * (fabs(s) * x.e[k] + fabs(t) * y.e[k] + 2 * unit * (fabs(a) + fabs(b)) +
                            unit * fabs(out.a[k])) +
                   tiny;
    }
    return out;
}

taut_field taut_field_sum(taut_arena *arena, const taut_field *f, const taut_field *g)
{
    return taut_field_combine(arena, 1, f, 1, g);
}

taut_field taut_field_difference(taut_arena *arena, const taut_field *f, const taut_field *g)
{
    return taut_field_combine(arena, 1, f, -1, g);
}

/* degree times the differences of coefficients `step` apart. */
static taut_field differences(taut_arena *arena, const taut_field *f, int p, int q, int degree,
                              size_t step)
{
    taut_field out = f->a != NULL ? taut_field_new(arena, p, q) : none;
    if (out.a == NULL) {
        return none;
    }
    for (int i = 0; degree > 0 && i <= p; i++) {
        for (int j = 0; j <= q; j++) {
            const size_t at = (size_t)i * (size_t)(f->q + 1) + (size_t)j;
            const size_t to = (size_t)i * (size_t)(q + 1) + (size_t)j;
            const double change = f->a[at + step] - f->a[at];
            out.a[to] = degree * change;
            out.e[to] =
                slack * degree * (f->e[at + step] + f->e[at] + 2 * unit * fabs(change)) + tiny;
        }
    }
    return out;
}

taut_field taut_field_du(taut_arena *arena, const taut_field *f)
{
    return differences(arena, f, f->p > 0 ? f->p - 1 : 0, f->q, f->p, (size_t)(f->q + 1));
}

taut_field taut_field_dv(taut_arena *arena, const taut_field *f)
{
    return differences(arena, f, f->p, f->q > 0 ? f->q - 1 : 0, f->q, 1);
}

void taut_field_cross(taut_arena *arena, const taut_field f[3], const taut_field g[3],
                      taut_field out[3])
{
    for (int k = 0; k < 3; k++) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        const taut_field a = taut_field_product(arena, &f[l], &g[m]);
        const taut_field b = taut_field_product(arena, &f[m], &g[l]);
        out[k] = taut_field_difference(arena, &a, &b);
    }
}

taut_field taut_field_dot(taut_arena *arena, const taut_field f[3], const taut_field g[3])
{
    taut_field sum = taut_field_product(arena, &f[0], &g[0]);
    for (int k = 1; k < 3; k++) {
        const taut_field term = taut_field_product(arena, &f[k], &g[k]);
        sum = taut_field_sum(arena, &sum, &term);
    }
    return sum;
}

/* One line of coefficients `step` apart by de Casteljau's algorithm at 1/2, in place: it becomes
 * the high half, and low the low one. */
static void halve_line(int degree, size_t step, double *a, double *e, double *low, double *low_e)
{
    for (int level = 0; level <= degree; level++) {
        low[(size_t)level * step] = a[0];
        low_e[(size_t)level * step] = e[0];
        for (int k = 0; k < degree - level; k++) {
            const size_t at = (size_t)k * step;
            a[at] = 0.5 * a[at] + 0.5 * a[at + step];
            e[at] = slack * (0.5 * e[at] + 0.5 * e[at + step] + unit * fabs(a[at])) + tiny;
        }
    }
}

void taut_field_halve(taut_arena *arena, const taut_field *f, int direction, taut_field *low,
                      taut_field *high)
{
    const taut_field from = *f;
    const size_t across = (size_t)(from.q + 1);
    *low = from.a != NULL ? taut_field_new(arena, from.p, from.q) : none;
    *high = taut_field_copy(arena, &from);
    if (low->a == NULL || high->a == NULL) {
        *low = *high = none;
        return;
    }
    for (int k = 0; k <= (direction == 0 ? from.q : from.p); k++) {
        const size_t at = direction == 0 ? (size_t)k : (size_t)k * across;
        halve_line(direction == 0 ? from.p : from.q, direction == 0 ? across : 1, high->a + at,
                   high->e + at, low->a + at, low->e + at);
    }
}

taut_field taut_field_edge(taut_arena *arena, const taut_field *f, int edge)
{
    const int along = edge < 2 ? f->q : f->p;
    const size_t across = (size_t)(f->q + 1);
    const size_t first = edge == 1 ? (size_t)f->p * across : edge == 3 ? (size_t)f->q : 0;
    const size_t step = edge < 2 ? 1 : across;
    taut_field out = f->a != NULL ? taut_field_new(arena, along, 0) : none;
    for (int k = 0; out.a != NULL && k <= along; k++) {
        out.a[k] = f->a[first + (size_t)k * step];
        out.e[k] = f->e[first + (size_t)k * step];
    }
    return out;
}

/* x moved up by more than one rounding. */
static double upwards(double x)
{
    return x + (0x1p-51 * fabs(x) + tiny);
}

double taut_field_high(const taut_field *f)
{
    double high = f->a != NULL ? -INFINITY : NAN;
    for (size_t k = 0; f->a != NULL && k < size_of(f); k++) {
        high = taut_certify_max(high, upwards(f->a[k] + f->e[k]));
    }
    return high;
}

double taut_field_low(const taut_field *f)
{
    double low = f->a != NULL ? INFINITY : NAN;
    for (size_t k = 0; f->a != NULL && k < size_of(f); k++) {
        low = taut_certify_min(low, -upwards(f->e[k] - f->a[k]));
    }
    return low;
}

double taut_field_largest(const taut_field *f)
{
    return taut_certify_max(taut_field_high(f), -taut_field_low(f));
}

/* De Casteljau's algorithm in place. */
static double line_value(int degree, double *a, double t)
{
    for (int level = degree; level > 0; level--) {
        for (int k = 0; k < level; k++) {
            a[k] = (1 - t) * a[k] + t * a[k + 1];
        }
    }
    return a[0];
}

double taut_field_value(const taut_field *f, double u, double v)
{
    double rows[TAUT_FIELD_DEGREE + 1], row[TAUT_FIELD_DEGREE + 1];
    if (f->a == NULL) {
        return NAN;
    }
    for (int i = 0; i <= f->p; i++) {
        memcpy(row, f->a + (size_t)i * (size_t)(f->q + 1), (size_t)(f->q + 1) * sizeof *row);
        rows[i] = line_value(f->q, row, v);
    }
    return line_value(f->p, rows, u);
}

/* One direction of a net: which functions live on a span, and how they become Bernstein's. */
typedef struct side {
    int local, first; /* functions */
    double lo, hi;
    const double *knots; /* of the spline, from the one that begins the first function; or NULL */
    int is_quasi;
    taut_quasi_span quasi;
} side;

static int find_side(const taut_basis *basis, int span, side *s)
{
    taut_basis_spec spec;
    const int is_spline = strcmp(taut_basis_type(basis), "bspline") == 0;
    s->is_quasi = taut_certify_quasi(basis, span, &s->quasi);
    if (!is_spline && !s->is_quasi && strcmp(taut_basis_type(basis), "bezier") != 0) {
        return 0;
    }
    taut_basis_spec_of(basis, &spec);
    s->local = taut_basis_local(basis);
    s->first = taut_basis_first(basis, span);
    s->lo = taut_basis_breaks(basis)[span];
    s->hi = taut_basis_breaks(basis)[span + 1];
    s->knots = is_spline ? spec.knots + s->first : NULL;
    return 1;
}

/* x = the convex combination of *a and *b with parts b : a = (t - lo) : (hi - t); their errors too.
 * Each part is right to three roundings. */
static inline void blend(double lo, double t, double hi, const double *a, const double *ae,
                         double *b, double *be)
{
    const double up = (t - lo) / (hi - lo), down = (hi - t) / (hi - lo);
    const double x = down * *a, y = up * *b;
    *be = slack * (down * *ae + up * *be + 5 * unit * (fabs(x) + fabs(y))) + tiny;
    *b = x + y;
}

/* One level of de Boor's scheme at t, in place. */
static void blend_level(const side *s, int level, double t, double *a, double *e)
{
    const int p = s->local - 1;
    for (int j = p; j >= level; j--) {
        blend(s->knots[j], t, s->knots[j + p + 1 - level], &a[j - 1], &e[j - 1], &a[j], &e[j]);
    }
}

/* The Bernstein coefficients of a line of p + 1 spline coefficients, in place: coefficient k is the
 * blossom at p - k times lo and k times hi, by de Boor's scheme ([PieglTiller1997] section 5.2). From the
 * last one on, so that the levels at lo are those of the one before and one more. */
static void line_of_spline(const side *s, size_t step, double *a, double *e)
{
    double from[2][TAUT_FIELD_DEGREE + 1], work[2][TAUT_FIELD_DEGREE + 1];
    const int p = s->local - 1;
    const size_t room = (size_t)s->local * sizeof(double);
    for (int i = 0; i <= p; i++) {
        from[0][i] = a[(size_t)i * step];
        from[1][i] = e[(size_t)i * step];
    }
    for (int k = p; k >= 0; k--) {
        if (k < p) {
            blend_level(s, p - k, s->lo, from[0], from[1]);
        }
        memcpy(work[0], from[0], room);
        memcpy(work[1], from[1], room);
        for (int level = p - k + 1; level <= p; level++) {
            blend_level(s, level, s->hi, work[0], work[1]);
        }
        a[(size_t)k * step] = work[0][p];
        e[(size_t)k * step] = work[1][p];
    }
}

/* A line of four coefficients of c- or h- functions, `step` apart, as one of degree s->degree. The
 * functions add up to 1, so that only what coefficients differ from the first counts: what the
 * polynomials miss times the largest difference met goes to all errors. */
static void line_of_quasi(const taut_quasi_span *s, size_t step, const double *a, const double *e,
                          const double largest[TAUT_QUASI_FUNCTIONS], size_t to, double *out,
                          double *out_e)
{
    double missed = 0;
    for (int i = 1; i < TAUT_QUASI_FUNCTIONS; i++) {
        missed += s->missed[i] * largest[i];
    }
    for (int k = 0; k <= s->degree; k++) {
        double sum = 0, error = missed + e[0], size = 0;
        for (int i = 1; i < TAUT_QUASI_FUNCTIONS; i++) {
            const double apart = a[(size_t)i * step] - a[0], term = s->c[i][k] * apart;
            sum += term;
            size += fabs(term);
            error += fabs(s->c[i][k]) * (e[(size_t)i * step] + e[0]);
        }
        out[(size_t)k * to] = a[0] + sum;
        out_e[(size_t)k * to] =
            slack * (error + unit * (8 * size + fabs(out[(size_t)k * to]) * (size > 0))) + tiny;
    }
}

/* Coefficients of c- or h- functions along one direction become Bernstein's of a higher degree. */
static taut_field expand(taut_arena *arena, const taut_quasi_span *s, int direction,
                         const taut_field *f)
{
    const int lines = direction == 0 ? f->q + 1 : f->p + 1;
    taut_field out = f->a == NULL     ? none
                     : direction == 0 ? taut_field_new(arena, s->degree, f->q)
                                      : taut_field_new(arena, f->p, s->degree);
    const size_t step = direction == 0 ? (size_t)(f->q + 1) : 1;
    const size_t to = direction == 0 ? (size_t)(out.q + 1) : 1;
    const size_t next = direction == 0 ? 1 : (size_t)(f->q + 1);
    const size_t next_out = direction == 0 ? 1 : (size_t)(out.q + 1);
    double largest[TAUT_QUASI_FUNCTIONS] = {0, 0, 0, 0};

    for (int k = 0; out.a != NULL && k < lines * TAUT_QUASI_FUNCTIONS; k++) {
        const int i = k % TAUT_QUASI_FUNCTIONS;
        const size_t first = (size_t)(k / TAUT_QUASI_FUNCTIONS) * next;
        const size_t at = first + (size_t)i * step;
        largest[i] = taut_certify_max(
            largest[i], slack * (fabs(f->a[at] - f->a[first]) + f->e[at] + f->e[first]));
    }
    for (int line = 0; out.a != NULL && line < lines; line++) {
        const size_t from = (size_t)line * next, into = (size_t)line * next_out;
        line_of_quasi(s, step, f->a + from, f->e + from, largest, to, out.a + into, out.e + into);
    }
    return out;
}

/* Coefficients of a span become Bernstein's along both directions. */
static taut_field extract(taut_arena *arena, const side *u, const side *v, const taut_field *given)
{
    taut_field f = u->is_quasi ? expand(arena, &u->quasi, 0, given) : *given;
    const size_t across = (size_t)(f.q + 1);
    for (size_t j = 0; u->knots != NULL && f.a != NULL && j < across; j++) {
        line_of_spline(u, across, f.a + j, f.e + j);
    }
    for (int i = 0; v->knots != NULL && f.a != NULL && i <= f.p; i++) {
        line_of_spline(v, 1, f.a + (size_t)i * across, f.e + (size_t)i * across);
    }
    return v->is_quasi ? expand(arena, &v->quasi, 1, &f) : f;
}

/* The coefficient number `at` of X, Y, Z or w. */
static void take_point(const double *points, const double *weights, size_t at, int c,
                       const double origin[3], int exponent, double *a, double *e)
{
    const double w = weights != NULL ? weights[at] : 1;
    *a = w;
    *e = 0;
    if (c < 3) {
        const double x = ldexp(points[3 * at + (size_t)c], -exponent);
        const double apart = x - ldexp(origin[c], -exponent);
        *a = w * apart;
        *e = slack * 2 * unit * fabs(*a) + tiny * (1 + w);
    }
}

static int make_piece(taut_arena *arena, const side *u, const side *v, int columns,
                      const double *points, const double *weights, const double origin[3],
                      int exponent, taut_field out[4])
{
    for (int c = 0; c < 4; c++) {
        if (c == 3 && weights == NULL) {
            out[3] = taut_field_constant(arena, 1);
            continue;
        }
        out[c] = taut_field_new(arena, u->local - 1, v->local - 1);
        for (size_t k = 0; out[c].a != NULL && k < size_of(&out[c]); k++) {
            const size_t i = k / (size_t)v->local, j = k % (size_t)v->local;
            const size_t at = ((size_t)u->first + i) * (size_t)columns + (size_t)v->first + j;
            take_point(points, weights, at, c, origin, exponent, out[c].a + k, out[c].e + k);
        }
        if (out[c].a != NULL) {
            out[c] = extract(arena, u, v, &out[c]);
        }
    }
    return 1;
}

int taut_field_of_surface(taut_arena *arena, const taut_surface *surface, int i, int j,
                          const double origin[3], int exponent, taut_field out[4], double widths[2])
{
    side u, v;
    if (!find_side(taut_surface_u(surface), i, &u) || !find_side(taut_surface_v(surface), j, &v)) {
        return 0;
    }
    if (widths != NULL) {
        widths[0] = u.hi - u.lo;
        widths[1] = v.hi - v.lo;
    }
    return make_piece(arena, &u, &v, taut_basis_count(taut_surface_v(surface)),
                      taut_surface_points(surface), taut_surface_weights(surface), origin, exponent,
                      out);
}

/* What the four functions of a c- or h- basis are worth at the end of its range, and how well that is
 * known: the Bezier-like ones begin and end in one of them. */
static double find_ends(const taut_basis *basis, int is_high, double values[TAUT_QUASI_FUNCTIONS])
{
    const int spans = taut_basis_span_count(basis);
    const char *type = taut_basis_type(basis);

    (void)taut_basis_eval(basis, is_high ? spans - 1 : 0,
                          is_high ? taut_basis_hi(basis) : taut_basis_lo(basis), 0, values);
    if (strcmp(type, "c-bezier") != 0 && strcmp(type, "h-bezier") != 0) {
        return 1e-14; /* taut/basis.h */
    }
    for (int a = 0; a < TAUT_QUASI_FUNCTIONS; a++) {
        values[a] = a == (is_high ? TAUT_QUASI_FUNCTIONS - 1 : 0);
    }
    return 0;
}

int taut_field_of_edge(taut_arena *arena, const taut_surface *surface, int edge, int span,
                       const double origin[3], int exponent, taut_field out[4])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const taut_basis *along = edge < 2 ? v : u, *across = edge < 2 ? u : v;
    const int last = edge % 2 == 0 ? 0 : taut_basis_span_count(across) - 1;
    const side point = {.local = 1, .hi = 1};
    double values[TAUT_QUASI_FUNCTIONS], off = 0;
    side from, to;

    if (!find_side(across, last, &from) || !find_side(along, span, &to)) {
        return 0;
    }
    if (!from.is_quasi) {
        taut_field whole[4];
        const int found =
            taut_field_of_surface(arena, surface, edge < 2 ? last : span, edge < 2 ? span : last,
                                  origin, exponent, whole, NULL);
        for (int c = 0; found && c < 4; c++) {
            out[c] = whole[c].p == 0 && whole[c].q == 0 ? whole[c]
                                                        : taut_field_edge(arena, &whole[c], edge);
        }
        return found;
    }
    off = find_ends(across, edge % 2, values);
    for (int c = 0; c < 3; c++) {
        taut_field line = taut_field_new(arena, to.local - 1, 0);
        for (int k = 0; line.a != NULL && k < to.local; k++) {
            for (int a = 0; a < TAUT_QUASI_FUNCTIONS; a++) {
                const size_t i = (size_t)(edge < 2 ? from.first + a : to.first + k);
                const size_t j = (size_t)(edge < 2 ? to.first + k : from.first + a);
                double x = 0, e = 0;
                take_point(taut_surface_points(surface), NULL, i * (size_t)taut_basis_count(v) + j,
                           c, origin, exponent, &x, &e);
                line.a[k] += values[a] * x;
                line.e[k] +=
                    slack * (fabs(values[a]) * e + (off + 8 * unit * fabs(values[a])) * fabs(x));
            }
        }
        out[c] = line.a != NULL ? extract(arena, &to, &point, &line) : none;
    }
    out[3] = taut_field_constant(arena, 1); /* these bases have no weights */
    return 1;
}

int taut_field_of_curve(taut_arena *arena, const taut_curve *curve, int i, const double origin[3],
                        int exponent, taut_field out[4], double *width)
{
    const side point = {.local = 1, .hi = 1};
    side t;
    if (!find_side(taut_curve_t(curve), i, &t)) {
        return 0;
    }
    if (width != NULL) {
        *width = t.hi - t.lo;
    }
    return make_piece(arena, &t, &point, 1, taut_curve_points(curve), taut_curve_weights(curve),
                      origin, exponent, out);
}

int taut_field_of_net(taut_arena *arena, const taut_basis *u, const taut_basis *v,
                      const double *coefficients, int i, int j, taut_field *out, double widths[2])
{
    const size_t columns = (size_t)taut_basis_count(v);
    side s, t;
    if (!find_side(u, i, &s) || !find_side(v, j, &t)) {
        return 0;
    }
    if (widths != NULL) {
        widths[0] = s.hi - s.lo;
        widths[1] = t.hi - t.lo;
    }
    *out = taut_field_new(arena, s.local - 1, t.local - 1);
    for (int k = 0; out->a != NULL && k < s.local; k++) {
        memcpy(out->a + (size_t)k * (size_t)t.local,
               coefficients + (size_t)(s.first + k) * columns + t.first,
               (size_t)t.local * sizeof(double));
    }
    if (out->a != NULL) {
        *out = extract(arena, &s, &t, out);
    }
    return 1;
}
