#include "certify/asymptotic/identity.h"

#include "certify/common/bernstein.h"
#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/twice.h"
#include "core/vec3.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* A polynomial in twice the precision, scaled Bernstein form: coefficient j times C(degree, j), in
 * which products are plain convolutions ([Farouki2012] section 4). */
typedef struct wide {
    int degree;
    taut_twice *c;
} wide;

/* The rows of the net along an edge, homogeneous, about the net's first point: k_n is the same from
 * any origin, and the products of coordinates then lose nothing to a far one. */
typedef struct rows {
    int along, across;       /* degrees */
    taut_twice *edge, *next; /* [along + 1][4] */
    double sign;             /* of next - edge as a derivative across */
} rows;

/* One block for all of them, handed out from the front. */
typedef struct pool {
    taut_twice *next, *end;
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
        const taut_twice left = {s * a->c[i].high, s * a->c[i].low};
        for (int j = 0; j <= b->degree; j++) {
            sum->c[i + j] = taut_twice_add(sum->c[i + j], taut_twice_times(left, b->c[j]));
        }
    }
}

/* Multiplies (or divides) coefficient j by C(degree, j). */
static void scale(const wide *a, int divide)
{
    taut_twice binomial = taut_twice_of(1.0);
    for (int j = 0; j <= a->degree; j++) {
        if (divide) {
            /* 1 / binomial to working precision, then one correction */
            const double q = 1.0 / binomial.high;
            const taut_twice rest =
                taut_twice_add(taut_twice_of(1.0),
                               taut_twice_negative(taut_twice_times(taut_twice_of(q), binomial)));
            const taut_twice inverse = taut_twice_sum(q, q * (rest.high + rest.low));
            a->c[j] = taut_twice_times(a->c[j], inverse);
        } else {
            a->c[j] = taut_twice_times(a->c[j], binomial);
        }
        binomial = taut_twice_over_number(
            taut_twice_times(binomial, taut_twice_of((double)(a->degree - j))), j + 1.0);
    }
}

/* Component k of the coefficients from `from` on, as a polynomial of `degree`. */
static wide part(pool *from, const taut_twice *row, int first, int degree, int k)
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
        taut_twice *const row = depth == 0 ? r->edge : r->next;
        for (int k = 0; k < count; k++) {
            const int held = high ? last - depth : depth;
            const int64_t at = with_u ? (int64_t)k * nv + held : (int64_t)held * nv + k;
            const double w = weights != NULL ? weights[at] : 1.0;
            for (int d = 0; d < 3; d++) {
                row[4 * k + d] = taut_twice_times(taut_twice_of(w),
                                                  taut_twice_sum(points[3 * at + d], -points[d]));
            }
            row[4 * k + 3] = taut_twice_of(w);
        }
    }
}

/* S_c as four polynomials of degree `along`. */
static void take_cross(pool *from, const rows *r, wide cross[4])
{
    for (int k = 0; k < 4; k++) {
        cross[k] = wide_new(from, r->along);
        for (int j = 0; j <= r->along; j++) {
            const taut_twice step =
                taut_twice_add(r->next[4 * j + k], taut_twice_negative(r->edge[4 * j + k]));
            cross[k].c[j] = taut_twice_times(step, taut_twice_of(r->sign * r->across));
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

static void take_parts(pool *from, const taut_twice *row, int first, int degree, wide out[4])
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
        out[j * stride] = factor * (a->c[j].high + a->c[j].low);
    }
}

/* Q, and D = m^2 (m-1) det(a, b, c, S_c) with a, b, c the edge's coefficients from 0, 1, 2 on, of degree
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
        if (k < 3) { /* columns 1, 2, w; 0, 2, w; 0, 1, w: Q, but for the order of the second */
            round_into(&three, (k == 1 ? -1.0 : 1.0) * m * m * (m - 1), id->q + k, 3);
        }
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
        id->w[j] = r->edge[4 * j + 3].high;
    }
}

taut_status taut_identity_fill(const taut_surface *surface, int edge, taut_arena *arena,
                               taut_identity *identity)
{
    const taut_basis *const along =
        edge % 2 == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const int m = taut_basis_count(along) - 1;
    const size_t room = (size_t)POOL_PER_COEFFICIENT * (size_t)(m + 1);
    taut_twice *const block = taut_arena_take(arena, room, sizeof *block);
    double *numbers = NULL;
    rows r;
    wide cross[4];
    identity->degree[0] = 4 * m - 6;
    identity->degree[1] = 3 * m - 2;
    identity->degree[2] = 2 * m - 2;
    identity->degree[3] = m;
    identity->degree[4] = 3 * m - 6;
    numbers = taut_arena_take(arena, (size_t)taut_identity_size(identity), sizeof *numbers);
    if (block == NULL || numbers == NULL) {
        return TAUT_NO_MEMORY;
    }
    identity->d = numbers;
    identity->m = identity->d + (4 * m - 5);
    identity->p = identity->m + 3 * (3 * m - 1);
    identity->w = identity->p + 3 * (2 * m - 1);
    identity->q = identity->w + (m + 1);
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

enum { PARTS = 5 }; /* D, M, P, W, Q */
/* Of an edge that resists everywhere, as where a single coordinate is 1e100: what is not bounded after so many is left out,
 * as at the last level. Edges of real patches take some hundreds. */
enum { PIECES_MORE = 1 << 13 };
static const double slack = 1 + 0x1p-40;

/* sum_j a_j B_j(t), stable: the recurrence on binomial terms, from the nearer end. */
static double value_of(int degree, const double *a, int stride, double t)
{
    const double s = 1.0 - t, ratio = t <= 0.5 ? t / s : s / t;
    const double start = taut_pow(t <= 0.5 ? s : t, degree);
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
        most = taut_certify_max(most, fabs(a[j]));
    }
    return most;
}

/* By squares where they are far from the ends of the range: `slack` holds their rounding. */
static double largest_length(int degree, const double *a)
{
    double square = 0.0, most = 0.0;
    for (int j = 0; j <= degree; j++) {
        square = taut_certify_max(square, taut_dot(a + 3 * j, a + 3 * j));
    }
    if (square > 1e-200 && square < 1e200) {
        return sqrt(square);
    }
    for (int j = 0; j <= degree; j++) {
        most = taut_certify_max(most, taut_norm(a + 3 * j));
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

int64_t taut_identity_size(const taut_identity *identity)
{
    const int *const g = identity->degree;
    return (g[0] + 1) + INT64_C(3) * (g[1] + 1) + INT64_C(3) * (g[2] + 1) + (g[3] + 1) +
           INT64_C(3) * (g[4] + 1);
}

/* The polynomials of a piece, one after the other. */
static void places(const taut_identity *identity, double *from, double *out[PARTS])
{
    out[0] = from;
    out[1] = out[0] + identity->degree[0] + 1;
    out[2] = out[1] + 3 * (identity->degree[1] + 1);
    out[3] = out[2] + 3 * (identity->degree[2] + 1);
    out[4] = out[3] + (identity->degree[3] + 1);
}

/* |k_n| at most, the sine, and the curvature; infinite where nothing is known. */
typedef struct piece_bounds {
    double flat, sine, bent;
} piece_bounds;

/* error[]: of each coefficient of the parts, from being halved. Those of the parts themselves are
 * 2^-100 of sums of products of which the limits are 2^-53 at least, and left out. */
static piece_bounds bounds_of(const taut_identity *identity, double *const at[PARTS],
                              const double error[PARTS])
{
    const int *const g = identity->degree;
    const double d = largest_of(g[0], at[0]) + error[0];
    const double w = largest_of(g[3], at[3]) + error[3];
    const double p_most = largest_length(g[2], at[2]) + 2 * error[2];
    const double q_most = largest_length(g[4], at[4]) + 2 * error[4];
    const double m = fmax(least_length(g[1], at[1]) - 2 * error[1], 0);
    const double p = fmax(least_length(g[2], at[2]) - 2 * error[2], 0);
    const double q = fmax(least_length(g[4], at[4]) - 2 * error[4], 0);
    return (piece_bounds){slack * w * w * w * d / (m * p * p), slack * d * p_most / (m * q),
                          slack * w * w * w * q_most / (p * p * p)};
}

static const int dims[PARTS] = {1, 3, 3, 1, 3};

typedef struct run {
    const taut_identity *identity;
    const taut_bounding *how;
    int64_t size;
    double least_m; /* pieces on which |M| may be less are left out */
    int64_t pieces; /* that may still be looked at */
    double bound, covered, sine;
} run;

/* Counts the piece, if it can be left as it is. */
static int is_done(run *b, int levels, double share, double *const here[PARTS],
                   const double error[PARTS])
{
    const piece_bounds found = bounds_of(b->identity, here, error);
    const int bends = !(found.bent <= b->how->bent);
    if (!isfinite(found.flat) || !(least_length(b->identity->degree[1], here[1]) >= b->least_m) ||
        (levels > -b->how->more &&
         (!(found.flat <= b->how->target) || (bends && !(found.sine <= b->how->sine))))) {
        return 0;
    }
    b->bound = taut_certify_max(b->bound, found.flat);
    b->sine = bends ? taut_certify_max(b->sine, found.sine) : b->sine;
    b->covered += share;
    return 1;
}

/* Are all of M, or all of P, no more than their rounding? That of the halves is no less, and they are
 * no larger: no bound comes of them. */
static int is_hopeless(const run *b, double *const here[PARTS], const double error[PARTS])
{
    const int *const g = b->identity->degree;
    return !(largest_length(g[1], here[1]) > 2 * error[1]) ||
           !(largest_length(g[2], here[2]) > 2 * error[2]);
}

/* stack holds one piece per level: the piece at hand first, its left halves behind it; it is
 * `share` of the edge. */
static void bound_below(run *b, int levels, double share, double *stack, const double error[PARTS])
{
    double *here[PARTS], *left[PARTS], more[PARTS];
    places(b->identity, stack, here);
    b->pieces--;
    if (levels <= 0 && (is_done(b, levels, share, here, error) || levels <= -b->how->more ||
                        b->pieces <= 0 || is_hopeless(b, here, error) ||
                        largest_length(b->identity->degree[1], here[1]) < b->least_m)) {
        return;
    }
    places(b->identity, stack + b->size, left);
    for (int k = 0; k < PARTS; k++) {
        const int degree = b->identity->degree[k];
        more[k] = error[k] +
                  degree * TAUT_UNIT_ROUNDOFF * largest_of(dims[k] * (degree + 1) - 1, here[k]);
        taut_certify_halve(degree, dims[k], here[k], left[k], here[k]);
    }
    bound_below(b, levels - 1, 0.5 * share, stack + b->size, more);
    memcpy(stack + b->size, stack, (size_t)b->size * sizeof *stack);
    bound_below(b, levels - 1, 0.5 * share, stack + b->size, more);
}

static void bound_edge(run *b, double *scratch)
{
    const taut_identity *const identity = b->identity;
    const double *const from[PARTS] = {identity->d, identity->m, identity->p, identity->w,
                                       identity->q};
    double *at[PARTS], error[PARTS];
    places(identity, scratch, at);
    for (int k = 0; k < PARTS; k++) {
        const int count = (identity->degree[k] + 1) * dims[k];
        memcpy(at[k], from[k], (size_t)count * sizeof **from);
        error[k] = 4 * TAUT_UNIT_ROUNDOFF * largest_of(count - 1, from[k]);
    }
    b->bound = b->covered = b->sine = 0.0;
    b->pieces = ((int64_t)2 << b->how->levels) + PIECES_MORE;
    bound_below(b, b->how->levels, 1.0, scratch, error);
}

double taut_identity_bound(const taut_identity *identity, const taut_bounding *bounding,
                           double *scratch, double *covered, double *sine)
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
    *sine = b.covered > 0 ? b.sine : INFINITY;
    return b.covered > 0 ? b.bound : INFINITY;
}
