/* flux.c -- how far the area of a film is above the flux of a dual field, proved (flux.h).
 *
 *     for every span
 *         n, w, Q   as polynomials on it: with a = w S_u w, b = w S_v w,
 *                   n = w S_u' x S_v' + S' x (w_v S_u' - w_u S_v')   (S' = (X, Y, Z), S_u' = dS'/du)
 *                   Q = w (psi_u b_h - psi_v a_h)
 *         bound the cell; where J, or J^2 - |Q|^2, is not shown to be of its sign, or the bound is
 *         loose: halve it both ways, and so on
 *
 * The order of the work is bounded before it begins: a hostile model is no reason to wait.
 */
#include "certify/plateau/flux.h"

#include "certify/common/field.h"
#include "certify/common/quasi.h"
#include "certify/common/verdict.h"
#include "certify/plateau/piece.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum {
    SIDE = 12,       /* most coefficients of T, each way: of its rules ... */
    SIDES = 4,       /* ... so many ... */
    SIDE_FIRST = 6,  /* ... the first has these ... */
    SIDE_STEP = 2,   /* ... and each more ... */
    SIDE_USUAL = 8,  /* ... than what costs are estimated with */
    SIDE_NEAR = 4,   /* those of R, K, V, U */
    DEPTH_MAX = 12,  /* halvings, both ways each */
    DEPTH_LOOSE = 5, /* the same for a bound that is loose */
    DEPTH_COARSE = 4 /* and is far from what is asked however tight it is */
};
static const struct {
    double loose;      /* share of a bound that finer cells may still take off ... */
    double coarse;     /* ... where it is less than so many times what is asked; else */
    double rough;      /* this */
    double match;      /* c, b: above, V and U are not near what they stand for */
    double apart;      /* share of the gap's root that d may add to it where more nodes help: ... */
    double slow;       /* ... they do where they take it down to less than this */
    double negligible; /* share of the area of a cell: no finer cells for less */
    double flops;      /* of a certificate */
} limits = {.loose = 0.05,
            .coarse = 4,
            .rough = 0.5,
            .match = 2,
            .apart = 0.01,
            .slow = 0.5,
            .negligible = 1e-17,
            .flops = 1e10};

static const double up = 1 + 0x1p-40; /* more than the few roundings of a bound */

enum { PARTS = 8 }; /* polynomials of a cell */

typedef struct cell {
    union {
        struct {
            taut_field n[3], w, q[2];
            taut_field square; /* n.n */
            taut_field room;   /* J^2 - |Q|^2 */
        };
        taut_field parts[PARTS];
    };
    double share;  /* of its span */
    double likely; /* as far as is known of what it is part of: the bound over its share, or 0 */
    int depth;
} cell;

typedef struct cell_bound {
    double gap, likely; /* the bound, and what it would be with factors from the middle */
    double area_low, area_high, shadow;
} cell_bound;

/* Nodes of Chebyshev's kind and what makes coefficients of values there. */
typedef struct flux_rule {
    int count;
    double nodes[SIDE], inverse[SIDE][SIDE];
} flux_rule;

typedef struct work {
    taut_flux_task *task;
    flux_rule near, lengths[SIDES];
    double flops;  /* that are left */
    double likely; /* the sum over the spans before */
    int spans;
    taut_flux_bound bound;
} work;

static int is_constant(const taut_field *f)
{
    return f->p == 0 && f->q == 0;
}

/* ---- polynomials that are near ---- */

/* row[i] = B[p,i](t). */
static void fill_row(int p, double t, double *row)
{
    row[0] = 1;
    for (int m = 1; m <= p; m++) {
        double carried = 0;
        for (int i = 0; i < m; i++) {
            const double lower = row[i];
            row[i] = (1 - t) * lower + carried;
            carried = t * lower;
        }
        row[m] = carried;
    }
}

/* Gauss-Jordan; rows stay where they are, as the matrix is totally positive. */
static void fill_rule(int n, flux_rule *rule)
{
    double a[SIDE][2 * SIDE];

    rule->count = n;
    memset(a, 0, sizeof a);
    for (int r = 0; r < n; r++) {
        rule->nodes[r] = 0.5 - 0.5 * taut_cos(TAUT_PI * (r + 0.5) / n);
        fill_row(n - 1, rule->nodes[r], a[r]);
        a[r][n + r] = 1;
    }
    for (int c = 0; c < n; c++) {
        for (int r = 0; r < n; r++) {
            const double factor = r == c ? 0 : a[r][c] / a[c][c];
            for (int k = 0; k < 2 * n; k++) {
                a[r][k] -= factor * a[c][k];
            }
        }
    }
    for (int r = 0; r < n; r++) {
        for (int c = 0; c < n; c++) {
            rule->inverse[r][c] = a[r][n + c] / a[r][r];
        }
    }
}

/* values[r][c] = f at the nodes. */
static void evaluate_at_nodes(const flux_rule *rule, const taut_field *f, double values[SIDE][SIDE])
{
    double by_v[SIDE][TAUT_FIELD_DEGREE + 1], row[TAUT_FIELD_DEGREE + 1];

    memset(values, 0, SIDE * sizeof values[0]);
    if (f->a == NULL) {
        return; /* memory ran out: the arena tells */
    }
    for (int c = 0; c < rule->count; c++) {
        fill_row(f->q, rule->nodes[c], row);
        for (int i = 0; i <= f->p; i++) {
            const double *a = f->a + (size_t)i * (size_t)(f->q + 1);
            by_v[c][i] = 0;
            for (int j = 0; j <= f->q; j++) {
                by_v[c][i] += row[j] * a[j];
            }
        }
    }
    for (int r = 0; r < rule->count; r++) {
        fill_row(f->p, rule->nodes[r], row);
        for (int c = 0; c < rule->count; c++) {
            values[r][c] = 0;
            for (int i = 0; i <= f->p; i++) {
                values[r][c] += row[i] * by_v[c][i];
            }
        }
    }
}

/* The polynomial with these values at the nodes, up to rounding: its coefficients are what they are,
 * without an error. */
static taut_field interpolate(const flux_rule *rule, taut_arena *arena, double values[SIDE][SIDE])
{
    double half[SIDE][SIDE];
    taut_field near = taut_field_new(arena, rule->count - 1, rule->count - 1);

    for (int r = 0; r < rule->count; r++) {
        for (int c = 0; c < rule->count; c++) {
            half[r][c] = 0;
            for (int k = 0; k < rule->count; k++) {
                half[r][c] += rule->inverse[r][k] * values[k][c];
            }
        }
    }
    for (int k = 0; near.a != NULL && k < rule->count * rule->count; k++) {
        for (int m = 0; m < rule->count; m++) {
            near.a[k] += half[k / rule->count][m] * rule->inverse[k % rule->count][m];
        }
    }
    return near;
}

/* ---- one cell ---- */

/* double[n + 1][n + 1]: int B[n,i] B[n,k] = C(n,i) C(n,k) / C(2n,i+k) / (2n+1). */
static void fill_gram(int n, double *gram)
{
    double row[2 * TAUT_FIELD_DEGREE + 1], half[TAUT_FIELD_DEGREE + 1];

    row[0] = half[0] = 1;
    for (int k = 1; k <= 2 * n; k++) {
        row[k] = row[k - 1] * (2 * n - k + 1) / k;
    }
    for (int k = 1; k <= n; k++) {
        half[k] = half[k - 1] * (n - k + 1) / k;
    }
    for (int k = 0; k < (n + 1) * (n + 1); k++) {
        const int i = k / (n + 1), j = k % (n + 1);
        gram[k] = half[i] * half[j] / row[i + j] / (2 * n + 1);
    }
}

/* The root of the integral of f^2 over [0, 1]^2, bounded: that of its coefficients and their largest
 * error. */
static double norm_of(taut_arena *arena, const taut_field *f)
{
    const size_t p = (size_t)f->p + 1, q = (size_t)f->q + 1;
    double *gram = taut_arena_take_raw(arena, p * p + q * q + 2 * q, sizeof(double));
    double sum = 0, error = 0, size = 0;

    if (gram == NULL || f->a == NULL) {
        return NAN;
    }
    double *other = gram + p * p, *half = other + q * q, *mixed = half + q;
    fill_gram(f->p, gram);
    fill_gram(f->q, other);
    for (size_t i = 0; i < p; i++) {
        memset(half, 0, 2 * q * sizeof *half);
        for (size_t j = 0; j < q; j++) {
            for (size_t l = 0; l < q; l++) {
                half[l] += f->a[i * q + j] * other[j * q + l];
            }
            error = taut_certify_max(error, f->e[i * q + j]);
            size = taut_certify_max(size, fabs(f->a[i * q + j]));
        }
        for (size_t k = 0; k < p; k++) {
            for (size_t l = 0; l < q; l++) {
                mixed[l] += gram[i * p + k] * f->a[k * q + l];
            }
        }
        for (size_t l = 0; l < q; l++) {
            sum += half[l] * mixed[l];
        }
    }
    /* All of the Gram matrix sums to 1: what rounding does is of the size of the largest square,
     * times the roundings of two sums and of binomials. */
    return sqrt(fabs(sum) + 0x1p-40 * size * size) + error;
}

/* The mean of the coefficients is the integral. */
static double mean_of(const taut_field *f)
{
    const int count = (f->p + 1) * (f->q + 1);
    double sum = f->a != NULL ? 0 : NAN, error = 0;
    for (int k = 0; f->a != NULL && k < count; k++) {
        sum += f->a[k];
        error = taut_certify_max(error, f->e[k]);
    }
    return sum / count - error; /* from below, but for the roundings of the sum */
}

/* Extremes over a cell. */
typedef struct extremes {
    double jacobian, high_jacobian; /* of |J| */
    double length, high_length;     /* of |n| */
    double weight, high_weight, room;
} extremes;

static taut_flux_verdict find_extremes(const cell *c, const taut_field *upright, extremes *x)
{
    x->jacobian = taut_field_low(upright);
    x->high_jacobian = taut_field_high(upright);
    x->weight = taut_field_low(&c->w);
    x->high_weight = taut_field_high(&c->w);
    x->length = sqrt(taut_field_low(&c->square)) / up;
    x->high_length = up * sqrt(taut_field_high(&c->square));
    x->room = taut_field_low(&c->room);
    if (!isfinite(x->high_jacobian) || !isfinite(x->high_length) || !isfinite(x->high_weight)) {
        return TAUT_FLUX_RANGE;
    }
    if (!(x->jacobian > 0) || !(x->weight > 0) || !(x->length > 0)) {
        return TAUT_FLUX_FOLDS;
    }
    return x->room >= 0 ? TAUT_FLUX_ADMITTED : TAUT_FLUX_STEEP;
}

/* ---- what is near ---- */

/* R, K, V, U of a cell, and T. */
typedef struct nearby {
    taut_field root, weight, first, second, length;
    double weighs; /* by about how much the gap's root grows with d */
    double off;    /* d */
} nearby;

static void find_weights(const flux_rule *rule, taut_arena *arena, const cell *c, nearby *found)
{
    double jacobian[SIDE][SIDE], square[SIDE][SIDE], weight[SIDE][SIDE];
    double root[SIDE][SIDE], half[SIDE][SIDE], first[SIDE][SIDE], second[SIDE][SIDE];

    evaluate_at_nodes(rule, &c->n[2], jacobian);
    evaluate_at_nodes(rule, &c->square, square);
    evaluate_at_nodes(rule, &c->w, weight);
    found->weighs = 0;
    for (int k = 0; k < rule->count * rule->count; k++) {
        const int row = k / rule->count, column = k % rule->count;
        const double heavy = fabs(weight[row][column]), steep = fabs(jacobian[row][column]);
        root[row][column] = sqrt(sqrt(fabs(square[row][column])));
        half[row][column] = sqrt(heavy);
        first[row][column] = 1 / (heavy * half[row][column] * steep * root[row][column]);
        second[row][column] = first[row][column] / steep;
        const double length = root[row][column] * root[row][column];
        found->weighs = fmax(found->weighs, first[row][column] * fmax(steep, length));
    }
    found->root = interpolate(rule, arena, root);
    found->weight =
        is_constant(&c->w) ? taut_field_constant(arena, 1) : interpolate(rule, arena, half);
    found->first = interpolate(rule, arena, first);
    found->second = interpolate(rule, arena, second);
}

/* T: by more and more nodes, until d is at most `wanted` or more do not help. */
static void find_length(const work *w, taut_arena *arena, const cell *c, double least,
                        double wanted, nearby *found)
{
    found->off = INFINITY;
    for (int k = 0; k < SIDES; k++) {
        double values[SIDE][SIDE];
        evaluate_at_nodes(&w->lengths[k], &c->square, values);
        for (int m = 0; m < SIDE * SIDE; m++) {
            values[m / SIDE][m % SIDE] = sqrt(fabs(values[m / SIDE][m % SIDE]));
        }
        const taut_field length = interpolate(&w->lengths[k], arena, values);
        const taut_field square = taut_field_product_even(arena, &length, &length);
        const taut_field apart = taut_field_difference(arena, &c->square, &square);
        const double low = taut_field_low(&length), before = found->off;
        const double off = low > 0 ? up * taut_field_largest(&apart) / (least + low) : INFINITY;
        if (k == 0 || off < before) {
            found->length = length;
            found->off = off;
        }
        if (off <= wanted || off > limits.slow * before) {
            break;
        }
    }
}

/* min (w K f R) for f = V J or U J^2. */
static double least_match(taut_arena *arena, const cell *c, const nearby *near, const taut_field *f)
{
    const taut_field half = taut_field_product_even(arena, f, &near->root);
    if (is_constant(&c->w)) {
        return taut_field_low(&half) * taut_field_low(&c->w);
    }
    const taut_field heavy = taut_field_product_even(arena, &c->w, &near->weight);
    const taut_field whole = taut_field_product_even(arena, &half, &heavy);
    return taut_field_low(&whole);
}

/* What the polynomials nearby lack. */
typedef struct lack {
    double first, second;           /* c, b */
    double high_first, high_second; /* max |V J|, max |U J| */
} lack;

/* A share of near^2 that f is nowhere below; none where near^2 is not shown to be above 0. */
static double share_of(taut_arena *arena, const taut_field *f, const taut_field *near)
{
    const taut_field square = taut_field_product_even(arena, near, near);
    const taut_field more = taut_field_difference(arena, f, &square);
    const double low = taut_field_low(&square);
    return low > 0 ? 1 - up * taut_field_largest(&more) / low : 0;
}

static lack find_lack(taut_arena *arena, const cell *c, const nearby *near,
                      const taut_field *upright)
{
    const taut_field first = taut_field_product_even(arena, &near->first, upright);
    const taut_field half = taut_field_product_even(arena, &near->second, upright);
    const taut_field second = taut_field_product_even(arena, &half, upright);
    const double low = taut_field_low(&near->length);
    const double weight = is_constant(&c->w) ? 1 : share_of(arena, &c->w, &near->weight);
    const double root = share_of(arena, &near->length, &near->root);
    const double length = 1 - up * near->off / low;
    const double one = least_match(arena, c, near, &first);
    const double two = least_match(arena, c, near, &second);
    const int is_near = weight > 0 && root > 0 && length > 0 && low > 0;
    const double share = weight * root * length;
    lack found;

    found.first = is_near && one > 0 ? up / (one * one * share) : INFINITY;
    found.second = is_near && two > 0 ? up / (two * two * share) : INFINITY;
    found.high_first = taut_field_largest(&first);
    found.high_second = taut_field_largest(&half);
    return found;
}

/* min r: by how near X is to the normal, or by the least of both. */
static double least_rate(const extremes *x, double largest)
{
    const double near = 1 - up * largest * x->high_length * x->high_length /
                                (x->length * x->jacobian * x->jacobian * x->jacobian);
    const double sum = x->jacobian / x->high_length + sqrt(x->room) / x->high_jacobian;
    const double plain = sum * x->length / (2 * x->high_jacobian) / up;
    return near > plain ? near : plain;
}

static void bound_gap(taut_arena *arena, const cell *c, const nearby *near,
                      const taut_field *upright, const extremes *x, cell_bound *found)
{
    const lack l = find_lack(arena, c, near, upright);
    taut_field along[2];
    double norm = 0, largest = 0;

    for (int k = 0; k < 2; k++) {
        const taut_field one = taut_field_product_even(arena, &c->q[k], &near->length);
        const taut_field other = taut_field_product_even(arena, upright, &c->n[k]);
        const taut_field e = taut_field_difference(arena, &one, &other);
        const taut_field weighted = taut_field_product_even(arena, &near->first, &e);
        const double part = norm_of(arena, &weighted), size = taut_field_largest(&e);
        along[k] = taut_field_product_even(arena, &e, &c->n[k]);
        norm += part * part;
        largest += size * size;
    }
    largest = up * sqrt(largest) + near->off * x->high_jacobian;
    const taut_field both = taut_field_sum(arena, &along[0], &along[1]);
    const taut_field weighted = taut_field_product_even(arena, &near->second, &both);
    const double second = norm_of(arena, &weighted), rate = least_rate(x, largest);
    const double flat = sqrt(norm) + near->off * l.high_first;
    const double steep = second + near->off * l.high_second * x->high_length +
                         taut_field_largest(&near->second) * largest * largest / (2 * x->jacobian);
    found->gap = up * up * c->share * 0.5 *
                 (l.first * flat * flat + l.second * steep * steep / (rate * rate));
    found->likely = l.first < limits.match && l.second < limits.match
                        ? c->share * 0.5 * (norm + second * second)
                        : 0; /* V, U are far off: what they weigh means nothing */
}

static taut_flux_verdict bound_cell(const work *w, taut_arena *arena, const cell *c,
                                    cell_bound *found)
{
    const taut_field upright = taut_field_combine(arena, w->task->sign, &c->n[2], 0, &c->n[2]);
    extremes x;
    const taut_flux_verdict verdict = find_extremes(c, &upright, &x);

    if (verdict != TAUT_FLUX_ADMITTED) {
        return verdict;
    }
    nearby near;
    find_weights(&w->near, arena, c, &near);
    const double likely = fmax(c->likely, w->spans > 0 ? w->likely / w->spans : 0);
    const double root = sqrt(fmax(2 * likely, limits.negligible * x.length));
    find_length(w, arena, c, x.length, limits.apart * root / near.weighs, &near);
    const double low_cube = x.weight * x.weight * x.weight;
    const double high_cube = x.high_weight * x.high_weight * x.high_weight;
    const double rounded = 0x1p-40 * taut_field_largest(&near.length);
    const double mean = mean_of(&near.length);
    const double most = up * c->share * 2 * x.high_length / low_cube; /* as |m - X| <= 2 */
    bound_gap(arena, c, &near, &upright, &x, found);
    found->gap = found->gap < most ? found->gap : most;
    found->area_low = c->share * fmax(0, mean - near.off - rounded) / high_cube / up;
    found->area_high = fmin(0.5 * most, up * c->share * (mean + near.off + rounded) / low_cube);
    found->shadow =
        c->share * fmax(0, mean_of(&upright) - 0x1p-40 * x.high_jacobian) / high_cube / up;
    return isfinite(found->gap) && isfinite(found->area_high) && found->area_low >= 0
               ? TAUT_FLUX_ADMITTED
               : TAUT_FLUX_RANGE;
}

/* ---- cells of cells ---- */

/* The four quarters: low or high in u, low or high in v. */
static void take_quarters(taut_arena *arena, const cell *from, double likely, cell quarters[4])
{
    const taut_field *given = from->parts;

    for (int f = 0; f < PARTS; f++) {
        taut_field half[2];
        taut_field_halve(arena, &given[f], 0, &half[0], &half[1]);
        for (int k = 0; k < 2; k++) {
            taut_field_halve(arena, &half[k], 1, &quarters[2 * k].parts[f],
                             &quarters[2 * k + 1].parts[f]);
        }
    }
    for (int k = 0; k < 4; k++) {
        quarters[k].share = 0.25 * from->share;
        quarters[k].likely = likely / from->share;
        quarters[k].depth = from->depth + 1;
    }
}

/* About so many flops. */
static double cost_of(const cell *c)
{
    const double near = SIDE_USUAL * SIDE_USUAL;
    const double n = (c->n[2].p + 1.0) * (c->n[2].q + 1.0);
    const double q = (c->q[0].p + 1.0) * (c->q[0].q + 1.0);
    const double width = 2.0 + c->q[0].p + c->q[0].q;
    return 12 * (near * near + 2 * near * q + 2 * n * n) + 40 * q * width;
}

static int is_loose(const work *w, const cell *c, const cell_bound *found)
{
    const double likely =
        taut_certify_max(found->likely, w->spans > 0 ? c->share * w->likely / w->spans : 0);
    const int is_coarse = found->likely > limits.coarse * w->task->wanted * found->area_low;
    const double share = is_coarse ? limits.rough : limits.loose;
    return c->depth < (is_coarse ? DEPTH_COARSE : DEPTH_LOOSE) &&
           !(found->gap - found->likely <= share * likely) &&
           found->gap > limits.negligible * found->area_low;
}

static taut_status add_cell(work *w, const cell *c, double *likely);

static taut_status add_quarters(work *w, const cell *c, double of_whole, double *likely)
{
    taut_arena *arena = taut_arena_new();
    taut_status status = TAUT_OK;
    cell quarters[4];

    take_quarters(arena, c, of_whole, quarters);
    status = taut_arena_status(arena);
    for (int k = 0; status == TAUT_OK && k < 4 && w->bound.verdict == TAUT_FLUX_ADMITTED; k++) {
        status = add_cell(w, &quarters[k], likely);
    }
    taut_arena_free(arena);
    return status;
}

/* Adds what is proved of the cell to the bound; *likely gains what is likely. */
static taut_status add_cell(work *w, const cell *c, double *likely)
{
    taut_arena *arena = taut_arena_new();
    cell_bound found = {.gap = 0};
    taut_flux_verdict verdict = bound_cell(w, arena, c, &found);
    const taut_status status = taut_arena_status(arena);

    taut_arena_free(arena);
    if (status != TAUT_OK) {
        return status;
    }
    w->flops -= cost_of(c);
    if (w->flops < 0) {
        verdict = TAUT_FLUX_WORK;
    }
    if ((verdict == TAUT_FLUX_FOLDS || verdict == TAUT_FLUX_STEEP) && c->depth < DEPTH_MAX) {
        return add_quarters(w, c, 0, likely);
    }
    if (verdict != TAUT_FLUX_ADMITTED) {
        w->bound.verdict = verdict;
        return TAUT_OK;
    }
    if (is_loose(w, c, &found)) {
        return add_quarters(w, c, found.likely, likely);
    }
    *likely += found.likely;
    w->bound.gap += found.gap;
    w->bound.area_low += found.area_low;
    w->bound.area_high += found.area_high;
    w->bound.shadow += found.shadow;
    return TAUT_OK;
}

/* ---- spans ---- */

/* w x_d - w_d x for one derivative: w^2 times that of x / w. */
static taut_field quotient_of(taut_arena *arena, const taut_field *x, const taut_field *dx,
                              const taut_field *weight, const taut_field *dweight)
{
    const taut_field one = taut_field_product_even(arena, weight, dx);
    const taut_field other = taut_field_product_even(arena, dweight, x);
    return taut_field_difference(arena, &one, &other);
}

/* n of a rational span. */
static void find_normal(taut_arena *arena, const taut_field x[4], const taut_field du[4],
                        const taut_field dv[4], taut_field n[3])
{
    taut_field flat[3], mixed[3], second[3];

    taut_field_cross(arena, du, dv, flat);
    if (is_constant(&x[3])) {
        memcpy(n, flat, sizeof flat); /* without weights w is 1 */
        return;
    }
    for (int c = 0; c < 3; c++) {
        const taut_field one = taut_field_product_even(arena, &dv[3], &du[c]);
        const taut_field other = taut_field_product_even(arena, &du[3], &dv[c]);
        mixed[c] = taut_field_difference(arena, &one, &other);
    }
    taut_field_cross(arena, x, mixed, second);
    for (int c = 0; c < 3; c++) {
        const taut_field first = taut_field_product_even(arena, &x[3], &flat[c]);
        n[c] = taut_field_sum(arena, &first, &second[c]);
    }
}

/* Q of a span. */
static void find_dual(taut_arena *arena, const taut_field x[4], const taut_field du[4],
                      const taut_field dv[4], const taut_field *psi, taut_field q[2])
{
    const taut_field psi_u = taut_field_du(arena, psi), psi_v = taut_field_dv(arena, psi);
    const int is_rational = !is_constant(&x[3]);

    for (int c = 0; c < 2; c++) {
        taut_field along_u = du[c], along_v = dv[c];
        if (is_rational) {
            along_u = quotient_of(arena, &x[c], &du[c], &x[3], &du[3]);
            along_v = quotient_of(arena, &x[c], &dv[c], &x[3], &dv[3]);
        }
        const taut_field one = taut_field_product_even(arena, &psi_u, &along_v);
        const taut_field other = taut_field_product_even(arena, &psi_v, &along_u);
        q[c] = taut_field_difference(arena, &one, &other);
        if (is_rational) {
            q[c] = taut_field_product_even(arena, &x[3], &q[c]);
        }
    }
}

/* The polynomials of span (i, j). */
static int make_cell(const work *w, taut_arena *arena, int i, int j, cell *c)
{
    const taut_flux_task *task = w->task;
    taut_field x[4], du[4], dv[4], psi;

    if (!taut_certify_piece(arena, task, i, j, x) ||
        !taut_field_of_net(arena, task->u, task->v, task->coefficients, i, j, &psi, NULL)) {
        return 0;
    }
    for (int k = 0; k < 4; k++) {
        du[k] = taut_field_du(arena, &x[k]);
        dv[k] = taut_field_dv(arena, &x[k]);
    }
    find_normal(arena, x, du, dv, c->n);
    find_dual(arena, x, du, dv, &psi, c->q);
    c->w = x[3];
    c->square = taut_field_dot(arena, c->n, c->n);
    const taut_field level = taut_field_product_even(arena, &c->n[2], &c->n[2]);
    const taut_field one = taut_field_product_even(arena, &c->q[0], &c->q[0]);
    const taut_field other = taut_field_product_even(arena, &c->q[1], &c->q[1]);
    const taut_field dual = taut_field_sum(arena, &one, &other);
    c->room = taut_field_difference(arena, &level, &dual);
    c->share = 1;
    c->likely = 0;
    c->depth = 0;
    return 1;
}

/* What making the cell of a span costs, from the degrees alone: before anything is multiplied. */
static double cost_of_span(const taut_flux_task *task)
{
    const int rational = taut_surface_weights(task->surface) != NULL;
    const double p = taut_certify_degree(taut_surface_u(task->surface)),
                 q = taut_certify_degree(taut_surface_v(task->surface));
    const double n = (rational ? 3 * p : 2 * p) * (rational ? 3 * q : 2 * q);
    const double dual = (taut_basis_degree(task->u) + (rational ? 3 : 1) * p) *
                        (taut_basis_degree(task->v) + (rational ? 3 : 1) * q);
    const double near = SIDE_USUAL * SIDE_USUAL;
    return 12 * (4 * n * n + 2 * dual * dual + 2 * near * dual + near * near);
}

static taut_status add_span(work *w, int i, int j)
{
    taut_arena *arena = taut_arena_new();
    taut_status status = TAUT_OK;
    double likely = 0;
    cell c;

    if (!make_cell(w, arena, i, j, &c)) {
        w->bound.verdict = TAUT_FLUX_RANGE;
        taut_arena_free(arena);
        return TAUT_OK;
    }
    status = taut_arena_status(arena);
    if (status == TAUT_OK && w->task->sign == 0) {
        w->task->sign = taut_field_value(&c.n[2], 0.5, 0.5) > 0 ? 1 : -1;
    }
    w->flops -= cost_of_span(w->task);
    if (status == TAUT_OK) {
        status = add_cell(w, &c, &likely);
    }
    w->likely += likely;
    w->spans++;
    taut_arena_free(arena);
    return status;
}

taut_status taut_certify_flux(taut_flux_task *task, taut_flux_bound *bound)
{
    const int nu = taut_basis_span_count(taut_surface_u(task->surface));
    const int nv = taut_basis_span_count(taut_surface_v(task->surface));
    work w = {.task = task, .flops = limits.flops};
    taut_status status = TAUT_OK;

    if (!(cost_of_span(task) * nu * nv <= limits.flops)) {
        *bound = (taut_flux_bound){.verdict = TAUT_FLUX_WORK};
        return TAUT_OK;
    }
    fill_rule(SIDE_NEAR, &w.near);
    for (int k = 0; k < SIDES; k++) {
        fill_rule(SIDE_FIRST + k * SIDE_STEP, &w.lengths[k]);
    }
    for (int k = 0; status == TAUT_OK && k < nu * nv && w.bound.verdict == TAUT_FLUX_ADMITTED;
         k++) {
        status = add_span(&w, k / nv, k % nv);
        if (status == TAUT_OK && taut_crew_beat(task->crew, cost_of_span(task))) {
            status = TAUT_INTERRUPTED;
        }
    }
    w.bound.gap *= up;
    *bound = w.bound;
    return status;
}
