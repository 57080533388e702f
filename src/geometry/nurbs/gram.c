/* gram.c -- Gram matrices by Gauss quadrature, span by span ([WuWang2011] section 2.5).
 *
 * The products of polynomials of degree p have degree 2p: the rule of p+1 nodes is exact for them.
 * Rational, trigonometric and hyperbolic functions are analytic on each span, so there the error
 * falls faster than any power of the nodes; the rule is raised until two agree to rounding.
 */
#include "geometry/nurbs/gram.h"

#include "basis/basis_ops.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/memory.h"
#include "geometry/nurbs/cells.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

typedef struct gauss {
    int nodes;
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
} gauss;

void taut_gram_clear(taut_gram *gram)
{
    taut_band_clear(&gram->mass);
    taut_band_clear(&gram->stiffness);
    gram->length = 0;
}

/* On failure there is nothing to free. */
static taut_status begin_gram(const taut_basis *basis, taut_gram *gram)
{
    const int n = taut_basis_count(basis), width = taut_basis_local(basis) - 1;
    const double *breaks = taut_basis_breaks(basis);

    memset(gram, 0, sizeof *gram);
    gram->length = taut_basis_hi(basis) - taut_basis_lo(basis);
    for (int k = 0; k < taut_basis_span_count(basis); k++) {
        const double largest = fmax(fabs(breaks[k]), fabs(breaks[k + 1]));
        gram->roundings = fmax(gram->roundings, 1 + largest / taut_cells_finest(basis, k));
    }
    if (taut_band_init(n, width, &gram->mass) != TAUT_OK ||
        taut_band_init(n, width, &gram->stiffness) != TAUT_OK) {
        taut_gram_clear(gram);
        return TAUT_NO_MEMORY;
    }
    return TAUT_OK;
}

/* Values and slopes n[0][..], n[1][..] become those of R = a N / W, W = sum a N. With D = a N' / W
 *     R_i' = sum_{s != i} D_i R_s - R_i D_s
 * where what cancels in (N' - N W'/W) / W, as weights that outweigh the others do, is left out. */
static void make_rational(int local, const double *weights, double *n)
{
    double *slope = n + local;
    double behind[2] = {0, 0}, ahead[TAUT_DEGREE_MAX + 1][2], w = 0;
    for (int i = 0; i < local; i++) {
        w += weights[i] * n[i];
    }
    ahead[local - 1][0] = ahead[local - 1][1] = 0; /* sums over s > i of R and D */
    for (int i = local - 1; i >= 0; i--) {
        n[i] = weights[i] * n[i] / w;
        slope[i] = weights[i] * (slope[i] / w);
        if (i > 0) {
            ahead[i - 1][0] = ahead[i][0] + n[i];
            ahead[i - 1][1] = ahead[i][1] + slope[i];
        }
    }
    for (int i = 0; i < local; i++) {
        const double value = n[i], d = slope[i];
        slope[i] = d * (behind[0] + ahead[i][0]) - value * (behind[1] + ahead[i][1]);
        behind[0] += value;
        behind[1] += d;
    }
}

/* Adds factor x x^T to rows first.. of the band, x double[local]. */
static void add_square(taut_band *band, int first, int local, const double *x)
{
    for (int a = 0; a < local; a++) {
        double *row = taut_band_row(band, first + a);
        for (int b = 0; b <= a; b++) {
            row[a - b] += x[a] * x[b];
        }
    }
}

/* Distances between neighbouring knots of a polynomial spline, new; NULL for other bases. What is
 * near a knot is taken from these and not from parameters, which far from 0 are rounded to more
 * than the lengths are. Lengths that mirror to within the rounding of the knots, as those of i/n
 * do, are made to mirror exactly, unless that moves one by more than 2^-40 of itself: short spans
 * beside an end far from 0 are what the knots say they are. TAUT_OK or TAUT_NO_MEMORY. */
static taut_status knot_lengths(const taut_basis *basis, double **lengths)
{
    *lengths = NULL;
    if (basis->shape.knot_count == 0 || basis->shape.degree < 0) {
        return TAUT_OK;
    }
    const int count = basis->shape.knot_count - 1;
    const double *t = basis->knots;
    const double rounding = 0x1p-52 * fmax(fabs(t[0]), fabs(t[count]));
    double *length = taut_alloc((size_t)count, sizeof *length);
    int mirrors = 1;
    if (length == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < count; i++) {
        length[i] = t[i + 1] - t[i];
        mirrors = mirrors && fabs(length[i] - (t[count - i] - t[count - 1 - i])) <=
                                 fmin(rounding, 0x1p-40 * length[i]);
    }
    for (int i = 0; i < count / 2 && mirrors; i++) {
        length[i] = length[count - 1 - i] = 0.5 * (length[i] + length[count - 1 - i]);
    }
    *lengths = length;
    return TAUT_OK;
}

/* n[0..p] = the functions on knot interval i, n[p+1..2p+1] their slopes, a share 0 < x < 1 of it
 * behind its start, y = 1 - x in front of its end: the recurrence of [PieglTiller1997] A2.2 with
 * distances to knots that are sums of lengths. */
static void eval_by_lengths(int p, const double *length, int i, double x, double y, double *n)
{
    double left[TAUT_DEGREE_MAX + 1], right[TAUT_DEGREE_MAX + 1], *slope = n + p + 1;
    double between_left = 0, between_right = 0;

    n[0] = 1;
    slope[0] = 0;
    for (int m = 1; m <= p; m++) {
        left[m] = between_left + x * length[i];
        right[m] = between_right + y * length[i];
        between_left += length[i - m]; /* i >= p: knots are clamped */
        between_right += length[i + m];
        double saved = 0, below = 0;
        for (int r = 0; r < m; r++) {
            const double part = n[r] / (right[r + 1] + left[m - r]);
            n[r] = saved + right[r + 1] * part;
            saved = left[m - r] * part;
            if (m == p) {
                slope[r] = p * (below - part);
                below = part;
            }
        }
        n[m] = saved;
        slope[m] = m == p ? p * below : 0;
    }
}

/* Values and slopes at node g of a cell, a share of its knot interval: there nothing depends on
 * how far from 0 the parameters lie. */
static void eval_share(const taut_basis *basis, const taut_cells *cells, int k, double node,
                       const double *lengths, double *n)
{
    const double *span = taut_basis_breaks(basis) + cells->span[k];
    const double lo = (cells->lo[k] - span[0]) / (span[1] - span[0]);
    const double hi = (cells->hi[k] - span[0]) / (span[1] - span[0]);
    const double up = 0.5 + 0.5 * node, down = 0.5 - 0.5 * node;
    eval_by_lengths(taut_basis_local(basis) - 1, lengths, basis->knot_span[cells->span[k]],
                    down * lo + up * hi, down * (1 - lo) + up * (1 - hi), n);
}

/* The terms of one cell. The square roots of the weights go into the factors, so that very short
 * spans do not overflow before they are summed. */
static void add_cell(const taut_basis *basis, const double *weights, const taut_cells *cells, int k,
                     const gauss *rule, const double *lengths, taut_gram *gram)
{
    const double *span = taut_basis_breaks(basis) + cells->span[k];
    const double share = (cells->hi[k] - cells->lo[k]) / (span[1] - span[0]);
    const double width = lengths == NULL ? cells->hi[k] - cells->lo[k]
                                         : share * lengths[basis->knot_span[cells->span[k]]];
    const int local = taut_basis_local(basis), first = taut_basis_first(basis, cells->span[k]);
    double n[2 * (TAUT_DEGREE_MAX + 1)];

    for (int g = 0; g < rule->nodes; g++) {
        const double root = sqrt(0.5 * rule->weight[g] * (width / gram->length));
        const double slope_root = root * gram->length;
        if (lengths != NULL) {
            eval_share(basis, cells, k, rule->node[g], lengths, n);
        } else {
            taut_basis_eval(basis, cells->span[k], taut_cells_at(cells, k, rule->node[g]), 1, n);
        }
        if (weights != NULL) {
            make_rational(local, weights + first, n);
        }
        for (int a = 0; a < local; a++) {
            n[a] *= root;
            n[local + a] *= slope_root;
        }
        add_square(&gram->mass, first, local, n);
        add_square(&gram->stiffness, first, local, n + local);
    }
}

/* The matrices by a rule of `nodes` nodes a cell. On failure there is nothing to free. */
static taut_status gram_with(const taut_basis *basis, const double *weights, int nodes,
                             taut_gram *gram)
{
    gauss rule = {.nodes = nodes};
    taut_cells *cells = NULL;
    double *lengths = NULL;
    const int is_ready = taut_cells_new(basis, 1, weights, 1, 0, &cells) == TAUT_OK &&
                         knot_lengths(basis, &lengths) == TAUT_OK &&
                         begin_gram(basis, gram) == TAUT_OK;

    taut_gauss_rule(nodes, rule.node, rule.weight);
    for (int k = 0; is_ready && k < cells->count; k++) {
        add_cell(basis, weights, cells, k, &rule, lengths, gram);
    }
    taut_free(lengths);
    taut_cells_free(cells);
    return is_ready ? TAUT_OK : TAUT_NO_MEMORY;
}

static int all_finite(const taut_band *band)
{
    const size_t size = (size_t)band->n * ((size_t)band->width + 1);
    for (size_t i = 0; i < size; i++) {
        if (!isfinite(band->a[i])) {
            return 0;
        }
    }
    return 1;
}

/* max |A - B|(i,s) / sqrt(B(i,i) B(s,s)); entries of a row without weight are left out. */
static double change_of(const taut_band *a, const taut_band *b)
{
    double largest = 0;
    for (int i = 0; i < b->n; i++) {
        for (int d = 0; d <= b->width && d <= i; d++) {
            const double scale = sqrt(taut_band_row(b, i)[0]) * sqrt(taut_band_row(b, i - d)[0]);
            const double moved = fabs(taut_band_row(a, i)[d] - taut_band_row(b, i)[d]);
            if (moved > largest * scale) {
                largest = scale > 0 ? moved / scale : INFINITY;
            }
        }
    }
    return largest;
}

/* Raises the nodes by half until mass and stiffness agree with those before: to what sums of O(100)
 * terms carry, each with the roundings of its parameter. */
static taut_status raise_nodes(const taut_basis *basis, const double *weights, taut_gram *gram,
                               taut_error *error)
{
    double moved = INFINITY, enough = 0;
    int nodes = taut_basis_local(basis) + 3;
    taut_gram next;

    if (gram_with(basis, weights, nodes, gram) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    while (!(moved <= enough) && nodes < TAUT_GAUSS_MAX) {
        nodes = nodes + nodes / 2 < TAUT_GAUSS_MAX ? nodes + nodes / 2 : TAUT_GAUSS_MAX;
        enough = 64 * TAUT_UNIT_ROUNDOFF * gram->roundings;
        if (gram_with(basis, weights, nodes, &next) != TAUT_OK) {
            taut_gram_clear(gram);
            return taut_fail_memory(error);
        }
        moved =
            fmax(change_of(&gram->mass, &next.mass), change_of(&gram->stiffness, &next.stiffness));
        taut_gram_clear(gram);
        *gram = next;
    }
    if (all_finite(&gram->stiffness) && !(moved <= enough)) {
        taut_gram_clear(gram);
        return taut_fail(error, TAUT_NOT_CONVERGED, "not-converged", NULL, moved, enough,
                         "%d Gauss nodes on each panel leave a relative change of %.3g in the "
                         "integrals of the basis, expected at most %.3g: the weights or the shape "
                         "of the basis are too extreme",
                         TAUT_GAUSS_MAX, moved, enough);
    }
    return TAUT_OK;
}

/* Checks what was made and hands it over. */
static taut_status hand_over(taut_gram *made, taut_gram *gram, taut_error *error)
{
    if (!all_finite(&made->mass) || !all_finite(&made->stiffness)) {
        taut_gram_clear(made);
        return taut_fail(error, TAUT_BAD_INPUT, "short-span", "", taut_none, taut_none,
                         "a span of the basis is too short against its range: its slopes "
                         "overflow");
    }
    *gram = *made;
    return TAUT_OK;
}

/* By one rule of `nodes` nodes a cell. */
static taut_status gram_by_rule(const taut_basis *basis, const double *weights, int nodes,
                                taut_gram *gram, taut_error *error)
{
    taut_gram made;
    if (gram_with(basis, weights, nodes, &made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return hand_over(&made, gram, error);
}

taut_status taut_gram_new(const taut_basis *basis, const double *weights, taut_gram *gram,
                          taut_error *error)
{
    taut_gram made;

    if (weights == NULL && taut_basis_degree(basis) >= 0) {
        return gram_by_rule(basis, NULL, taut_basis_local(basis), gram, error);
    }
    const taut_status status = raise_nodes(basis, weights, &made, error);
    return status == TAUT_OK ? hand_over(&made, gram, error) : status;
}

taut_status taut_gram_new_rough(const taut_basis *basis, const double *weights, taut_gram *gram,
                                taut_error *error)
{
    return gram_by_rule(basis, weights, taut_basis_local(basis) + 3, gram, error);
}

static taut_status select_band(const taut_band *from, int count, const int *index, taut_band *part)
{
    if (taut_band_init(count, from->width, part) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < count; i++) {
        for (int d = 0; d <= from->width && d <= i; d++) {
            taut_band_row(part, i)[d] = taut_band_at(from, index[i], index[i - d]);
        }
    }
    return TAUT_OK;
}

taut_status taut_gram_select(const taut_gram *gram, int count, const int *index, taut_gram *part)
{
    taut_gram made = {.length = gram->length, .roundings = gram->roundings};

    if (select_band(&gram->mass, count, index, &made.mass) != TAUT_OK ||
        select_band(&gram->stiffness, count, index, &made.stiffness) != TAUT_OK) {
        taut_gram_clear(&made);
        return TAUT_NO_MEMORY;
    }
    *part = made;
    return TAUT_OK;
}
