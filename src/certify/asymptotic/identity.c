#include "certify/asymptotic/identity.h"

#include "certify/common/bernstein.h"
#include "core/vec3.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Sums and products of twice the precision of double, so that what is left of an identity is the
 * model's own rounding and not that of the proof. A number is hi + lo with |lo| <= 2^-53 |hi|;
 * relative error of an operation about 2^-104 ([Dekker1971]; the products by fma). */
typedef struct double_double {
    double hi, lo;
} double_double;

static double_double double_of(double x)
{
    return (double_double){x, 0.0};
}

static double_double double_sum(double a, double b)
{
    const double s = a + b, part = s - a;
    return (double_double){s, (a - (s - part)) + (b - part)};
}

static double_double double_add(double_double a, double_double b)
{
    double_double high = double_sum(a.hi, b.hi);
    const double_double low = double_sum(a.lo, b.lo);
    high.lo += low.hi;
    high = double_sum(high.hi, high.lo);
    high.lo += low.lo;
    return double_sum(high.hi, high.lo);
}

static double_double double_negative(double_double a)
{
    return (double_double){-a.hi, -a.lo};
}

static double_double double_multiply(double_double a, double_double b)
{
    const double p = a.hi * b.hi;
    const double rest = fma(a.hi, b.hi, -p) + (a.hi * b.lo + a.lo * b.hi);
    return double_sum(p, rest);
}

/* a / d for a plain number d. */
static double_double double_divide(double_double a, double d)
{
    const double q = a.hi / d;
    const double_double product = double_multiply(double_of(q), double_of(d));
    const double_double rest = double_add(a, double_negative(product));
    return double_sum(q, (rest.hi + rest.lo) / d);
}

/* A polynomial in twice the precision, scaled Bernstein form: coefficient j times C(degree, j), in
 * which products are plain convolutions ([Farouki2012] section 4). */
typedef struct wide {
    int degree;
    double_double *c;
} wide;

/* The rows of the net along an edge, homogeneous, about the net's first point: k_n is the same from
 * any origin, and the products of coordinates then lose nothing to a far one. */
typedef struct rows {
    int along, across;          /* degrees */
    double_double *edge, *next; /* [along + 1][4] */
    double sign;                /* of next - edge as a derivative across */
} rows;

/* One block for all of them, handed out from the front. */
typedef struct pool {
    double_double *next, *end;
} pool;

/* Coefficients per coefficient of the edge: two rows and S_c (12), the parts of the edge (12 + 8),
 * 12 + 12 minors of at most 2 m + 1, 4 + 3 of at most 3 m, and D. */
enum { POOL_PER_COEFFICIENT = 128 };

static wide wide_new(pool *from, int degree)
{
    const wide made = {degree, from->next};
    from->next += degree + 1;
    assert(from->next <= from->end);
    return made;
}

/* sum += s a b, degrees adding up. */
static void add_product(double s, const wide *a, const wide *b, const wide *sum)
{
    for (int i = 0; i <= a->degree; i++) {
        const double_double left = {s * a->c[i].hi, s * a->c[i].lo};
        for (int j = 0; j <= b->degree; j++) {
            sum->c[i + j] = double_add(sum->c[i + j], double_multiply(left, b->c[j]));
        }
    }
}

/* Multiplies (or divides) coefficient j by C(degree, j). */
static void scale(const wide *a, int divide)
{
    double_double binomial = double_of(1.0);
    for (int j = 0; j <= a->degree; j++) {
        if (divide) {
            /* 1 / binomial to working precision, then one correction */
            const double q = 1.0 / binomial.hi;
            const double_double rest = double_add(
                double_of(1.0), double_negative(double_multiply(double_of(q), binomial)));
            const double_double inverse = double_sum(q, q * (rest.hi + rest.lo));
            a->c[j] = double_multiply(a->c[j], inverse);
        } else {
            a->c[j] = double_multiply(a->c[j], binomial);
        }
        binomial =
            double_divide(double_multiply(binomial, double_of((double)(a->degree - j))), j + 1.0);
    }
}

/* Component k of the coefficients from `from` on, as a polynomial of `degree`. */
static wide part(pool *from, const double_double *row, int first, int degree, int k)
{
    const wide made = wide_new(from, degree);
    for (int j = 0; j <= degree; j++) {
        made.c[j] = row[4 * (first + j) + k];
    }
    scale(&made, 0);
    return made;
}

static void take_rows(const taut_surface *surface, int edge, pool *from, rows *r)
{
    const int with_u = edge % 2 == 0, high = edge >= 2;
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const int count = with_u ? nu : nv, last = (with_u ? nv : nu) - 1;
    const double *const points = taut_surface_points(surface);
    const double *const weights = taut_surface_weights(surface);
    r->along = count - 1;
    r->across = last;
    r->sign = high ? -1.0 : 1.0;
    r->edge = wide_new(from, 4 * count - 1).c;
    r->next = wide_new(from, 4 * count - 1).c;
    for (int depth = 0; depth < 2; depth++) {
        double_double *const row = depth == 0 ? r->edge : r->next;
        for (int k = 0; k < count; k++) {
            const int held = high ? last - depth : depth;
            const long at = with_u ? (long)k * nv + held : (long)held * nv + k;
            const double w = weights != NULL ? weights[at] : 1.0;
            for (int d = 0; d < 3; d++) {
                row[4 * k + d] =
                    double_multiply(double_of(w), double_sum(points[3 * at + d], -points[d]));
            }
            row[4 * k + 3] = double_of(w);
        }
    }
}

/* S_c as four polynomials of degree `along`. */
static void take_cross(pool *from, const rows *r, wide cross[4])
{
    for (int k = 0; k < 4; k++) {
        cross[k] = wide_new(from, r->along);
        for (int j = 0; j <= r->along; j++) {
            const double_double step =
                double_add(r->next[4 * j + k], double_negative(r->edge[4 * j + k]));
            cross[k].c[j] = double_multiply(step, double_of(r->sign * r->across));
        }
        scale(&cross[k], 0);
    }
}

/* x_k y_l - x_l y_k of vectors of polynomials of one degree. */
static wide minor(pool *from, const wide *x, const wide *y, int k, int l)
{
    const wide made = wide_new(from, x[0].degree + y[0].degree);
    add_product(1.0, &x[k], &y[l], &made);
    add_product(-1.0, &x[l], &y[k], &made);
    return made;
}

static void take_parts(pool *from, const double_double *row, int first, int degree, wide out[4])
{
    for (int k = 0; k < 4; k++) {
        out[k] = part(from, row, first, degree, k);
    }
}

/* Rounds to plain coefficients with a factor; stride 3 writes one component of a vector. */
static void round_into(const wide *a, double factor, double *out, int stride)
{
    scale(a, 1);
    for (int j = 0; j <= a->degree; j++) {
        out[j * stride] = factor * (a->c[j].hi + a->c[j].lo);
    }
}

/* D = m^2 (m-1) det(a, b, c, S_c) with a, b, c the edge's coefficients from 0, 1, 2 on, of degree
 * m - 2 (the derivatives of S are combinations of them with determinant 1). */
static void fill_d(pool *from, const rows *r, const wide cross[4], taut_identity *id)
{
    const int m = r->along;
    const wide sum = wide_new(from, 4 * m - 6);
    wide a[4], b[4], c[4];
    take_parts(from, r->edge, 0, m - 2, a);
    take_parts(from, r->edge, 1, m - 2, b);
    take_parts(from, r->edge, 2, m - 2, c);
    for (int k = 0; k < 4; k++) { /* expand by the last row: cofactor of S_c's component k */
        const int i = k == 0 ? 1 : 0, j = k <= 1 ? 2 : 1, l = k <= 2 ? 3 : 2;
        const wide ij = minor(from, a, b, i, j), jl = minor(from, a, b, j, l);
        const wide li = minor(from, a, b, l, i), three = wide_new(from, 3 * m - 6);
        add_product(1.0, &ij, &c[l], &three);
        add_product(1.0, &jl, &c[i], &three);
        add_product(1.0, &li, &c[j], &three);
        add_product(k % 2 == 0 ? -1.0 : 1.0, &three, &cross[k], &sum);
    }
    round_into(&sum, (double)m * m * (m - 1), id->d, 1);
}

/* P = m (lo_w up - lo up_w) and M = m sum over the wedge of lo, up and S_c. */
static void fill_denominator(pool *from, const rows *r, const wide cross[4], taut_identity *id)
{
    const int m = r->along;
    wide lo[4], up[4];
    take_parts(from, r->edge, 0, m - 1, lo);
    take_parts(from, r->edge, 1, m - 1, up);
    for (int k = 0; k < 3; k++) { /* component k of M: i, j the other two, 3 the weight */
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const wide tangent = minor(from, lo, up, 3, k), ij = minor(from, lo, up, i, j);
        const wide jw = minor(from, lo, up, j, 3), wi = minor(from, lo, up, 3, i);
        const wide three = wide_new(from, 3 * m - 2);
        add_product(1.0, &ij, &cross[3], &three);
        add_product(1.0, &jw, &cross[i], &three);
        add_product(1.0, &wi, &cross[j], &three);
        round_into(&three, m, id->m + k, 3);
        round_into(&tangent, m, id->p + k, 3);
    }
    for (int j = 0; j <= m; j++) {
        id->w[j] = r->edge[4 * j + 3].hi;
    }
}

taut_status taut_identity_fill(const taut_surface *surface, int edge, taut_arena *arena,
                               taut_identity *identity)
{
    const taut_basis *const along =
        edge % 2 == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const int m = taut_basis_count(along) - 1;
    const size_t room = (size_t)POOL_PER_COEFFICIENT * (size_t)(m + 1);
    double_double *const block = taut_arena_take(arena, room, sizeof *block);
    double *numbers = NULL;
    rows r;
    wide cross[4];
    identity->degree[0] = 4 * m - 6;
    identity->degree[1] = 3 * m - 2;
    identity->degree[2] = 2 * m - 2;
    identity->degree[3] = m;
    numbers = taut_arena_take(arena, (size_t)taut_identity_size(identity), sizeof *numbers);
    if (block == NULL || numbers == NULL) {
        return TAUT_NO_MEMORY;
    }
    identity->d = numbers;
    identity->m = identity->d + (4 * m - 5);
    identity->p = identity->m + 3 * (3 * m - 1);
    identity->w = identity->p + 3 * (2 * m - 1);
    {
        pool from = {block, block + room};
        take_rows(surface, edge, &from, &r);
        take_cross(&from, &r, cross);
        fill_d(&from, &r, cross, identity);
        fill_denominator(&from, &r, cross, identity);
    }
    return TAUT_OK;
}

/* ---- values and bounds ---- */

/* sum_j a_j B_j(t), stable: the recurrence on binomial terms, from the nearer end. */
static double value_of(int degree, const double *a, int stride, double t)
{
    const double s = 1.0 - t, ratio = t <= 0.5 ? t / s : s / t;
    const double start = pow(t <= 0.5 ? s : t, degree);
    double sum = 0.0, term = start;
    for (int j = 0; j <= degree; j++) {
        sum += term * a[(t <= 0.5 ? j : degree - j) * stride];
        term *= ratio * (degree - j) / (j + 1);
    }
    return sum;
}

double taut_identity_at(const taut_identity *identity, double t)
{
    double m[3], p[3];
    const double w = value_of(identity->degree[3], identity->w, 1, t);
    for (int k = 0; k < 3; k++) {
        m[k] = value_of(identity->degree[1], identity->m + k, 3, t);
        p[k] = value_of(identity->degree[2], identity->p + k, 3, t);
    }
    return w * w * w * value_of(identity->degree[0], identity->d, 1, t) /
           (taut_norm(m) * taut_dot(p, p));
}

static double largest_of(int degree, const double *a)
{
    double most = 0.0;
    for (int j = 0; j <= degree; j++) {
        most = fmax(most, fabs(a[j]));
    }
    return most;
}

/* A lower bound of |a(t)| on the piece: the least coefficient along the mean direction. */
static double least_length(int degree, const double *a)
{
    double mean[3] = {0}, least = INFINITY, length = 0.0;
    for (int j = 0; j <= degree; j++) {
        taut_add_scaled(1.0, a + 3 * j, mean);
    }
    length = taut_norm(mean);
    for (int j = 0; j <= degree; j++) {
        least = fmin(least, taut_dot(a + 3 * j, mean) / length);
    }
    return length > 0 ? fmax(least, 0.0) : 0.0;
}

long taut_identity_size(const taut_identity *identity)
{
    const int *const g = identity->degree;
    return (g[0] + 1) + 3L * (g[1] + 1) + 3L * (g[2] + 1) + (g[3] + 1);
}

/* The four polynomials of a piece, one after the other. */
static void places(const taut_identity *identity, double *from, double *out[4])
{
    out[0] = from;
    out[1] = out[0] + identity->degree[0] + 1;
    out[2] = out[1] + 3 * (identity->degree[1] + 1);
    out[3] = out[2] + 3 * (identity->degree[2] + 1);
}

static double piece_bound(const taut_identity *identity, double *const at[4])
{
    const int *const g = identity->degree;
    const double w = largest_of(g[3], at[3]);
    const double m = least_length(g[1], at[1]), p = least_length(g[2], at[2]);
    return w * w * w * largest_of(g[0], at[0]) / (m * p * p);
}

static const int dims[4] = {1, 3, 3, 1};

typedef struct run {
    const taut_identity *identity;
    const taut_bounding *how;
    long size;
    double least_m; /* pieces on which |M| may be less are left out */
    double bound, covered;
} run;

/* stack holds one piece per level: the piece at hand first, its left halves behind it; it is
 * `share` of the edge. */
static void bound_below(run *b, int levels, double share, double *stack)
{
    double *here[4], *left[4];
    places(b->identity, stack, here);
    if (levels <= 0) {
        const double bound = piece_bound(b->identity, here);
        const int counts =
            isfinite(bound) && least_length(b->identity->degree[1], here[1]) >= b->least_m;
        if (counts && (bound <= b->how->target || levels <= -b->how->more)) {
            b->bound = fmax(b->bound, bound);
            b->covered += share;
            return;
        }
        if (levels <= -b->how->more) {
            return;
        }
    }
    places(b->identity, stack + b->size, left);
    for (int k = 0; k < 4; k++) {
        taut_certify_halve(b->identity->degree[k], dims[k], here[k], left[k], here[k]);
    }
    bound_below(b, levels - 1, 0.5 * share, stack + b->size);
    memcpy(stack + b->size, stack, (size_t)b->size * sizeof *stack);
    bound_below(b, levels - 1, 0.5 * share, stack + b->size);
}

static void bound_edge(run *b, double *scratch)
{
    const taut_identity *const identity = b->identity;
    const double *const from[4] = {identity->d, identity->m, identity->p, identity->w};
    double *at[4];
    places(identity, scratch, at);
    for (int k = 0; k < 4; k++) {
        memcpy(at[k], from[k], (size_t)((identity->degree[k] + 1) * dims[k]) * sizeof **from);
    }
    b->bound = b->covered = 0.0;
    bound_below(b, b->how->levels, 1.0, scratch);
}

double taut_identity_bound(const taut_identity *identity, const taut_bounding *bounding,
                           double *scratch, double *covered)
{
    run b = {.identity = identity, .how = bounding, .size = taut_identity_size(identity)};
    bound_edge(&b, scratch);
    if (b.covered < 1.0) {
        for (int j = 0; j <= identity->degree[1]; j++) {
            b.least_m = fmax(b.least_m, bounding->regular * taut_norm(identity->m + 3 * j));
        }
        bound_edge(&b, scratch);
    }
    *covered = b.covered;
    return b.covered > 0 ? b.bound : INFINITY;
}
