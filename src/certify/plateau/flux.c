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
    SIDE = 6,       /* most coefficients of R, K, V, U, each way ... */
    SIDE_SMALL = 4, /* ... and on the small spans of a film that has many */
    SPANS_MANY = 500,
    DEPTH_MAX = 12,  /* halvings, both ways each */
    DEPTH_LOOSE = 5, /* the same for a bound that is loose */
    DEPTH_COARSE = 4 /* and is far from what is asked however tight it is */
};

static const struct {
    double loose;      /* share of a bound that finer cells may still take off ... */
    double coarse;     /* ... where it is less than so many times what is asked; else */
    double rough;      /* this */
    double match;      /* c, b: above, V and U are not near what they stand for */
    double negligible; /* share of the area of a cell: no finer cells for less */
    double flops;      /* of a certificate */
} limits = {
    .loose = 0.05, .coarse = 4, .rough = 0.5, .match = 2, .negligible = 1e-17, .flops = 1e10};

static const double up = 1 + 0x1p-40; /* more than the few roundings of a bound */

typedef struct cell {
    taut_field n[3], w, q[2];
    taut_field square; /* n.n */
    taut_field room;   /* J^2 - |Q|^2 */
    double share;      /* of its span */
    int depth;
} cell;

typedef struct cell_bound {
    double gap, likely; /* the bound, and what it would be with factors from the middle */
    double off;         /* d */
    double area_low, area_high, shadow;
} cell_bound;

typedef struct work {
    taut_flux_task *task;
    int side; /* coefficients of R, K, V, U, each way */
    double nodes[SIDE];
    double inverse[SIDE][SIDE]; /* values at nodes to coefficients */
    double flops;               /* that are left */
    double likely;              /* the sum over the spans before */
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

/* Gauss-Jordan with row interchanges: nodes of Chebyshev's kind are far apart enough. */
static void fill_inverse(work *w)
{
    const int n = w->side;
    double a[SIDE][2 * SIDE];

    memset(a, 0, sizeof a);
    for (int r = 0; r < n; r++) {
        w->nodes[r] = 0.5 - 0.5 * taut_cos(TAUT_PI * (r + 0.5) / n);
        fill_row(n - 1, w->nodes[r], a[r]);
        a[r][n + r] = 1;
    }
    for (int c = 0; c < n; c++) {
        int pivot = c;
        for (int r = c + 1; r < n; r++) {
            pivot = fabs(a[r][c]) > fabs(a[pivot][c]) ? r : pivot;
        }
        for (int k = 0; k < 2 * n; k++) {
            const double kept = a[c][k];
            a[c][k] = a[pivot][k];
            a[pivot][k] = kept;
        }
        for (int r = 0; r < n; r++) {
            const double factor = r == c ? 0 : a[r][c] / a[c][c];
            for (int k = 0; k < 2 * n; k++) {
                a[r][k] -= factor * a[c][k];
            }
        }
    }
    for (int r = 0; r < n; r++) {
        for (int c = 0; c < n; c++) {
            w->inverse[r][c] = a[r][n + c] / a[r][r];
        }
    }
}

/* values[r][c] = f at the nodes. */
static void evaluate_at_nodes(const work *w, const taut_field *f, double values[SIDE][SIDE])
{
    double by_v[SIDE][TAUT_FIELD_DEGREE + 1], row[TAUT_FIELD_DEGREE + 1];

    memset(values, 0, SIDE * sizeof values[0]);
    if (f->a == NULL) {
        return; /* memory ran out: the arena tells */
    }
    for (int c = 0; c < w->side; c++) {
        fill_row(f->q, w->nodes[c], row);
        for (int i = 0; i <= f->p; i++) {
            const double *a = f->a + (size_t)i * (size_t)(f->q + 1);
            by_v[c][i] = 0;
            for (int j = 0; j <= f->q; j++) {
                by_v[c][i] += row[j] * a[j];
            }
        }
    }
    for (int r = 0; r < w->side; r++) {
        fill_row(f->p, w->nodes[r], row);
        for (int c = 0; c < w->side; c++) {
            values[r][c] = 0;
            for (int i = 0; i <= f->p; i++) {
                values[r][c] += row[i] * by_v[c][i];
            }
        }
    }
}

/* The polynomial with these values at the nodes, up to rounding: its coefficients are what they are,
 * without an error. */
static taut_field interpolate(const work *w, taut_arena *arena, double values[SIDE][SIDE])
{
    double half[SIDE][SIDE];
    taut_field near = taut_field_new(arena, w->side - 1, w->side - 1);

    for (int r = 0; r < w->side; r++) {
        for (int c = 0; c < w->side; c++) {
            half[r][c] = 0;
            for (int k = 0; k < w->side; k++) {
                half[r][c] += w->inverse[r][k] * values[k][c];
            }
        }
    }
    for (int k = 0; near.a != NULL && k < w->side * w->side; k++) {
        for (int m = 0; m < w->side; m++) {
            near.a[k] += half[k / w->side][m] * w->inverse[k % w->side][m];
        }
    }
    return near;
}

/* R, K, V, U of a cell, and T. */
typedef struct nearby {
    taut_field root, weight, first, second, length;
} nearby;

static nearby find_nearby(const work *w, taut_arena *arena, const cell *c)
{
    double jacobian[SIDE][SIDE], square[SIDE][SIDE], weight[SIDE][SIDE];
    double root[SIDE][SIDE], half[SIDE][SIDE], first[SIDE][SIDE], second[SIDE][SIDE];
    nearby found;

    evaluate_at_nodes(w, &c->n[2], jacobian);
    evaluate_at_nodes(w, &c->square, square);
    evaluate_at_nodes(w, &c->w, weight);
    for (int k = 0; k < w->side * w->side; k++) {
        const int row = k / w->side, column = k % w->side;
        const double heavy = fabs(weight[row][column]), steep = fabs(jacobian[row][column]);
        root[row][column] = sqrt(sqrt(fabs(square[row][column])));
        half[row][column] = sqrt(heavy);
        first[row][column] = 1 / (heavy * half[row][column] * steep * root[row][column]);
        second[row][column] = first[row][column] / steep;
    }
    found.root = interpolate(w, arena, root);
    found.weight = is_constant(&c->w) ? taut_field_constant(arena, 1) : interpolate(w, arena, half);
    found.first = interpolate(w, arena, first);
    found.second = interpolate(w, arena, second);
    found.length = taut_field_product(arena, &found.root, &found.root);
    return found;
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

/* min (w K f R) for f = V J or U J^2. */
static double least_match(taut_arena *arena, const cell *c, const nearby *near, const taut_field *f)
{
    const taut_field half = taut_field_product(arena, f, &near->root);
    if (is_constant(&c->w)) {
        return taut_field_low(&half) * taut_field_low(&c->w);
    }
    const taut_field heavy = taut_field_product(arena, &c->w, &near->weight);
    const taut_field whole = taut_field_product(arena, &half, &heavy);
    return taut_field_low(&whole);
}

/* What the polynomials nearby lack. */
typedef struct lack {
    double off;                     /* d */
    double first, second;           /* c, b */
    double high_first, high_second; /* max |V J|, max |U J| */
} lack;

static lack find_lack(taut_arena *arena, const cell *c, const nearby *near,
                      const taut_field *upright, const extremes *x)
{
    const taut_field square = taut_field_product(arena, &near->length, &near->length);
    const taut_field apart = taut_field_difference(arena, &c->square, &square);
    const taut_field first = taut_field_product(arena, &near->first, upright);
    const taut_field half = taut_field_product(arena, &near->second, upright);
    const taut_field second = taut_field_product(arena, &half, upright);
    const double low = taut_field_low(&near->length);
    double share = 1;
    lack found = {0, 0, 0, 0, 0};

    found.off = up * taut_field_largest(&apart) / (x->length + fmax(0, low));
    if (!is_constant(&c->w)) {
        const taut_field weight = taut_field_product(arena, &near->weight, &near->weight);
        const taut_field more = taut_field_difference(arena, &c->w, &weight);
        share = 1 - up * taut_field_largest(&more) / taut_field_low(&weight);
    }
    share *= 1 - up * found.off / low;
    const double one = least_match(arena, c, near, &first);
    const double two = least_match(arena, c, near, &second);
    found.first = low > 0 && share > 0 && one > 0 ? up / (one * one * share) : INFINITY;
    found.second = low > 0 && share > 0 && two > 0 ? up / (two * two * share) : INFINITY;
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
    const lack l = find_lack(arena, c, near, upright, x);
    taut_field along[2];
    double norm = 0, largest = 0;

    for (int k = 0; k < 2; k++) {
        const taut_field one = taut_field_product(arena, &c->q[k], &near->length);
        const taut_field other = taut_field_product(arena, upright, &c->n[k]);
        const taut_field e = taut_field_difference(arena, &one, &other);
        const taut_field weighted = taut_field_product(arena, &near->first, &e);
        const double part = norm_of(arena, &weighted), size = taut_field_largest(&e);
        along[k] = taut_field_product(arena, &e, &c->n[k]);
        norm += part * part;
        largest += size * size;
    }
    largest = up * sqrt(largest) + l.off * x->high_jacobian;
    const taut_field both = taut_field_sum(arena, &along[0], &along[1]);
    const taut_field weighted = taut_field_product(arena, &near->second, &both);
    const double second = norm_of(arena, &weighted), rate = least_rate(x, largest);
    const double flat = sqrt(norm) + l.off * l.high_first;
    const double steep = second + l.off * l.high_second * x->high_length +
                         taut_field_largest(&near->second) * largest * largest / (2 * x->jacobian);
    found->gap = up * up * c->share * 0.5 *
                 (l.first * flat * flat + l.second * steep * steep / (rate * rate));
    found->likely = l.first < limits.match && l.second < limits.match
                        ? c->share * 0.5 * (norm + second * second)
                        : 0; /* V, U are far off: what they weigh means nothing */
    found->off = l.off;
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
    const nearby near = find_nearby(w, arena, c);
    const double low_cube = x.weight * x.weight * x.weight;
    const double high_cube = x.high_weight * x.high_weight * x.high_weight;
    const double rounded = 0x1p-40 * taut_field_largest(&near.length);
    const double mean = mean_of(&near.length);
    const double most = up * c->share * 2 * x.high_length / low_cube; /* as |m - X| <= 2 */
    bound_gap(arena, c, &near, &upright, &x, found);
    found->gap = found->gap < most ? found->gap : most;
    found->area_low = c->share * fmax(0, mean - found->off - rounded) / high_cube / up;
    found->area_high = fmin(0.5 * most, up * c->share * (mean + found->off + rounded) / low_cube);
    found->shadow =
        c->share * fmax(0, mean_of(&upright) - 0x1p-40 * x.high_jacobian) / high_cube / up;
    return isfinite(found->gap) && isfinite(found->area_high) && found->area_low >= 0
               ? TAUT_FLUX_ADMITTED
               : TAUT_FLUX_RANGE;
}

/* ---- cells of cells ---- */

/* Quarter k: low or high in u, low or high in v. */
static void take_quarter(taut_arena *arena, const cell *from, int k, cell *quarter)
{
    const taut_field *given[8] = {&from->n[0], &from->n[1], &from->n[2],   &from->w,
                                  &from->q[0], &from->q[1], &from->square, &from->room};
    taut_field *taken[8] = {&quarter->n[0], &quarter->n[1], &quarter->n[2],   &quarter->w,
                            &quarter->q[0], &quarter->q[1], &quarter->square, &quarter->room};

    for (int f = 0; f < 8; f++) {
        taut_field half[2], part[2];
        taut_field_halve(arena, given[f], 0, &half[0], &half[1]);
        taut_field_halve(arena, &half[k / 2], 1, &part[0], &part[1]);
        *taken[f] = part[k % 2];
    }
    quarter->share = 0.25 * from->share;
    quarter->depth = from->depth + 1;
}

/* About so many flops. */
static double cost_of(const work *w, const cell *c)
{
    const double near = (2 * w->side - 1) * (2 * w->side - 1);
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

static taut_status add_quarters(work *w, const cell *c, double *likely)
{
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < 4 && w->bound.verdict == TAUT_FLUX_ADMITTED; k++) {
        taut_arena *arena = taut_arena_new();
        cell quarter;
        take_quarter(arena, c, k, &quarter);
        status = taut_arena_status(arena);
        if (status == TAUT_OK) {
            status = add_cell(w, &quarter, likely);
        }
        taut_arena_free(arena);
    }
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
    w->flops -= cost_of(w, c);
    if (w->flops < 0) {
        verdict = TAUT_FLUX_WORK;
    }
    if ((verdict == TAUT_FLUX_FOLDS || verdict == TAUT_FLUX_STEEP) && c->depth < DEPTH_MAX) {
        return add_quarters(w, c, likely);
    }
    if (verdict != TAUT_FLUX_ADMITTED) {
        w->bound.verdict = verdict;
        return TAUT_OK;
    }
    if (is_loose(w, c, &found)) {
        return add_quarters(w, c, likely);
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
    const taut_field one = taut_field_product(arena, weight, dx);
    const taut_field other = taut_field_product(arena, dweight, x);
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
        const taut_field one = taut_field_product(arena, &dv[3], &du[c]);
        const taut_field other = taut_field_product(arena, &du[3], &dv[c]);
        mixed[c] = taut_field_difference(arena, &one, &other);
    }
    taut_field_cross(arena, x, mixed, second);
    for (int c = 0; c < 3; c++) {
        const taut_field first = taut_field_product(arena, &x[3], &flat[c]);
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
        const taut_field one = taut_field_product(arena, &psi_u, &along_v);
        const taut_field other = taut_field_product(arena, &psi_v, &along_u);
        q[c] = taut_field_difference(arena, &one, &other);
        if (is_rational) {
            q[c] = taut_field_product(arena, &x[3], &q[c]);
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
    const taut_field level = taut_field_product(arena, &c->n[2], &c->n[2]);
    const taut_field one = taut_field_product(arena, &c->q[0], &c->q[0]);
    const taut_field other = taut_field_product(arena, &c->q[1], &c->q[1]);
    const taut_field dual = taut_field_sum(arena, &one, &other);
    c->room = taut_field_difference(arena, &level, &dual);
    c->share = 1;
    c->depth = 0;
    return 1;
}

/* What making the cell of a span costs, from the degrees alone: before anything is multiplied. */
static double cost_of_span(const taut_flux_task *task, int side)
{
    const int rational = taut_surface_weights(task->surface) != NULL;
    const double p = taut_certify_degree(taut_surface_u(task->surface)),
                 q = taut_certify_degree(taut_surface_v(task->surface));
    const double n = (rational ? 3 * p : 2 * p) * (rational ? 3 * q : 2 * q);
    const double dual = (taut_basis_degree(task->u) + (rational ? 3 : 1) * p) *
                        (taut_basis_degree(task->v) + (rational ? 3 : 1) * q);
    const double near = (2.0 * side - 1) * (2.0 * side - 1);
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
    w->flops -= cost_of_span(w->task, w->side);
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
    work w = {
        .task = task, .flops = limits.flops, .side = nu * nv < SPANS_MANY ? SIDE : SIDE_SMALL};
    taut_status status = TAUT_OK;

    if (!(cost_of_span(task, w.side) * nu * nv <= limits.flops)) {
        *bound = (taut_flux_bound){.verdict = TAUT_FLUX_WORK};
        return TAUT_OK;
    }
    fill_inverse(&w);
    for (int k = 0; status == TAUT_OK && k < nu * nv && w.bound.verdict == TAUT_FLUX_ADMITTED;
         k++) {
        status = add_span(&w, k / nv, k % nv);
        if (status == TAUT_OK && taut_crew_beat(task->crew, cost_of_span(task, w.side))) {
            status = TAUT_INTERRUPTED;
        }
    }
    w.bound.gap *= up;
    *bound = w.bound;
    return status;
}
