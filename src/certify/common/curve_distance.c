#include "certify/common/curve_distance.h"

#include "certify/common/bernstein.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { CUTS = 14, CHANNELS = 4 /* three of the numerator, the denominator */ };
static const double bound_near = 1.05; /* times a distance seen: not made sharper */
static const double knot_same = 1e-12; /* of the range: knots nearer to each other are one */
static const double spline_tolerance =
    1e-11; /* of c- and h- curves as splines, of their size and how far off they are */

double taut_certify_reach(const taut_curve *curve, const double *x)
{
    double reach = 0;
    for (int i = 0; i < taut_basis_count(taut_curve_t(curve)); i++) {
        reach = fmax(reach, taut_distance(taut_curve_points(curve) + 3 * i, x));
    }
    return reach;
}

taut_status taut_certify_edge(const taut_basis *u, const taut_basis *v, const double *points,
                              const double *weights, int edge, taut_curve **curve,
                              taut_error *error)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v), count = edge < 2 ? nv : nu;
    const taut_basis *along = edge < 2 ? v : u;
    const int has_weights = weights != NULL && taut_basis_allows_weights(along);
    double *row = taut_alloc((size_t)count, 4 * sizeof(double));
    taut_status status = TAUT_OK;

    if (row == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < count; k++) {
        const size_t i = edge < 2 ? (size_t)(edge == 0 ? 0 : nu - 1) : (size_t)k;
        const size_t j = edge < 2 ? (size_t)k : (size_t)(edge == 2 ? 0 : nv - 1);
        const size_t at = i * (size_t)nv + j;
        memcpy(row + 3 * k, points + 3 * at, 3 * sizeof(double));
        row[3 * count + k] = weights != NULL ? weights[at] : 1;
    }
    status = taut_curve_new("", along, row, has_weights ? row + 3 * count : NULL, curve, error);
    taut_free(row);
    return status;
}

/* As a bspline over [lo, hi]; *bound gains what that costs. */
static taut_status convert_to_spline(const taut_curve *curve, double lo, double hi,
                                     taut_curve **spline, double *bound, taut_error *error)
{
    taut_curve *made = NULL;
    const double *first = taut_curve_points(curve);
    const double size = taut_certify_reach(curve, first) + taut_norm(first);
    double lost = 0;
    taut_status status =
        taut_curve_to_nurbs(curve, spline_tolerance * (size > 0 ? size : 1), &made, &lost, error);

    if (status != TAUT_OK) {
        return status;
    }
    *bound += lost;
    status = taut_curve_rerange(made, lo, hi, spline, error);
    taut_curve_free(made);
    return status;
}

/* Cuts *curve where the other has a knot and it has none near. */
static taut_status share_breaks(taut_curve **curve, const taut_curve *other, taut_error *error)
{
    const taut_basis *basis = taut_curve_t(other);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double close = knot_same * (breaks[spans] - breaks[0]);

    for (int s = 1; s < spans; s++) {
        const taut_basis *own = taut_curve_t(*curve);
        const double *there = taut_basis_breaks(own);
        const int at = taut_basis_span(own, breaks[s]);
        taut_curve *next = NULL;
        taut_status status = TAUT_OK;
        if (fabs(there[at] - breaks[s]) <= close || fabs(there[at + 1] - breaks[s]) <= close) {
            continue;
        }
        status = taut_curve_insert(*curve, breaks[s], 1, &next, error);
        if (status != TAUT_OK) {
            return status;
        }
        taut_curve_free(*curve);
        *curve = next;
    }
    return TAUT_OK;
}

static double weight_of(const taut_curve *c, int i)
{
    return taut_curve_weights(c) != NULL ? taut_curve_weights(c)[i] : 1;
}

/* (max |X_i| + rounding) / min d_i, of halves of halves where that is not near what is seen at
 * ends: *seen. c double[n+1][CHANNELS] is spoilt, spare is as long for each level. */
static double largest_distance(int n, double rounding, double *c, int cuts, double *spare,
                               double *seen)
{
    double *const deeper = spare + CHANNELS * (n + 1);
    double largest = 0, least = INFINITY;

    for (int i = 0; i <= n; i++) {
        const double size = taut_norm(c + CHANNELS * i), d = c[CHANNELS * i + 3];
        largest = size <= largest ? largest : size; /* NaN stays */
        least = fmin(least, d);
        *seen = i == 0 || i == n ? fmax(*seen, size / d) : *seen;
    }
    const double bound = (largest + rounding) / least;
    if (cuts == 0 || !(bound > bound_near * *seen + 2 * rounding / least)) {
        return bound;
    }
    taut_certify_halve(n, CHANNELS, c, spare, c);
    const double high = largest_distance(n, rounding, c, cuts - 1, deeper, seen);
    const double low = largest_distance(n, rounding, spare, cuts - 1, deeper, seen);
    return high <= low ? low : high;
}

/* The bound on one pair of Bezier pieces. work double[(CUTS + 1)(p + q + 1)][CHANNELS]. */
static double piece_distance(const taut_curve *a, const taut_curve *b, double *work, double *seen)
{
    const int p = taut_basis_degree(taut_curve_t(a)), q = taut_basis_degree(taut_curve_t(b));
    const double *centre = taut_curve_points(a);
    const double roundings = 32 * (p + q) * TAUT_UNIT_ROUNDOFF;
    double most = 0;

    memset(work, 0, CHANNELS * (size_t)(p + q + 1) * sizeof(double));
    for (int i = 0; i <= p; i++) {
        for (int j = 0; j <= q; j++) {
            const double weight = weight_of(a, i) * weight_of(b, j);
            const double part = taut_certify_binomial(p, i) * taut_certify_binomial(q, j) /
                                taut_certify_binomial(p + q, i + j) * weight;
            double apart[3];
            taut_difference(taut_curve_points(a) + 3 * i, taut_curve_points(b) + 3 * j, apart);
            taut_add_scaled(part, apart, work + CHANNELS * (i + j));
            work[CHANNELS * (i + j) + 3] += part * (1 - roundings);
            most = fmax(most, weight);
        }
    }
    const double size = fmax(taut_certify_reach(a, centre), taut_certify_reach(b, centre));
    const double rounding = roundings * (most * size + taut_norm(centre) * most);
    return largest_distance(p + q, rounding, work, CUTS, work + CHANNELS * (p + q + 1), seen);
}

/* The two curves on the way to their pieces. */
typedef struct pair {
    taut_curve *a, *b;       /* as splines */
    taut_model *of_a, *of_b; /* their Bezier pieces */
    double *work;
} pair;

static taut_status make_pieces(const taut_curve *a, const taut_curve *b, pair *p, double *bound,
                               taut_error *error)
{
    const double lo = taut_basis_lo(taut_curve_t(a)), hi = taut_basis_hi(taut_curve_t(a));
    taut_status status = convert_to_spline(a, lo, hi, &p->a, bound, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = convert_to_spline(b, lo, hi, &p->b, bound, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = share_breaks(&p->a, p->b, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = share_breaks(&p->b, p->a, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_pieces(p->a, &p->of_a, error);
    return status == TAUT_OK ? taut_curve_pieces(p->b, &p->of_b, error) : status;
}

static taut_status find_bound(const taut_curve *a, const taut_curve *b, pair *p, double *bound,
                              taut_error *error)
{
    double largest = 0, seen = 0;
    int degrees = 0;
    taut_status status = make_pieces(a, b, p, bound, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_curve_count(p->of_a) != taut_model_curve_count(p->of_b)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "close-knots", NULL, taut_none, taut_none,
                         "knots of two curves lie too close to be distinguished");
    }
    degrees = taut_basis_degree(taut_curve_t(p->a)) + taut_basis_degree(taut_curve_t(p->b)) + 1;
    p->work = taut_alloc((size_t)degrees * (CUTS + 1), CHANNELS * sizeof(double));
    if (p->work == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < taut_model_curve_count(p->of_a); k++) {
        const double here = piece_distance(taut_model_curve(p->of_a, k),
                                           taut_model_curve(p->of_b, k), p->work, &seen);
        largest = here <= largest ? largest : here; /* NaN stays */
    }
    *bound += largest;
    return TAUT_OK;
}

taut_status taut_certify_distance(const taut_curve *a, const taut_curve *b, double *bound,
                                  taut_error *error)
{
    pair p = {NULL, NULL, NULL, NULL, NULL};
    double found = 0;
    const taut_status status = find_bound(a, b, &p, &found, error);

    taut_curve_free(p.a);
    taut_curve_free(p.b);
    taut_model_free(p.of_a);
    taut_model_free(p.of_b);
    taut_free(p.work);
    if (status != TAUT_OK) {
        return status;
    }
    *bound = found;
    return TAUT_OK;
}
