/* jacobian.c -- does a planar patch fold? J = x_u y_v - x_v y_u over the whole of it.
 *
 * On each knot rectangle J is a polynomial of bidegree (2n-1, 2m-1), and it lies between its least
 * and largest Bernstein coefficient ([NiWang2015] section 8.8). Rounding is bounded along with the
 * coefficients, so that one sign of all of them is a proof. Where they do not have it, the
 * rectangle whose lowest coefficient is worst is halved both ways, and so on. The corner
 * coefficients are values of J: one of the other sign proves a fold.
 *
 * J comes from products of Bernstein polynomials, with running error bounds:
 *     f = sum a_i B[p,i], g = sum b_k B[q,k]:  f g = sum_l B[p+q,l] sum_(i+k=l) W_ik a_i b_k,
 *     W_ik = C(p,i) C(q,k) / C(p+q,l),  which sum to 1 for each l           [Farin2002] 5.5
 */
#include "measure/integrate/jacobian.h"

#include "core/arena.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "taut/limits.h"
#include "taut/operations.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { CELLS = 4096, CELLS_LEAST = 64, POLISH = 256 };
/* Operations, as pulses count them: of a pair of coefficients, of a mean with its error, of a point against a plane; and
 * points between two beats. */
enum { OF_PAIR = 20, OF_MEAN = 8, OF_POINT = 60, SOME_POINTS = 4096 };

/* Points this near to a plane, over their size, are in it. */
static const double flatness = 0x1p-40;

/* J(s, t) = sum_ij value_ij B[du,i](s) B[dv,j](t) over the part lo..hi of the parameters, the true
 * coefficients within `error` of the stored ones. A coefficient of value and error 0 is exact. */
typedef struct jacobian_cell {
    double lo[2], hi[2];
    double low;     /* the least of sign value - error: J >= low all over, times the sign */
    double *values; /* double[2][du+1][dv+1]: values, then errors */
} jacobian_cell;

/* A planar polynomial patch on the unit square: x double[n+1][m+1][2], each coordinate within
 * `apart` of the true one. */
typedef struct planar_patch {
    int n, m;
    const double *x;
    double apart;
} planar_patch;

/* C(p,i) C(q,k) / C(p+q,i+k) for all i, k: double[p+1][q+1]. The hypergeometric ratios are formed
 * along k from the first, W_i0 = C(p,i) / C(p+q,i); every factor is a quotient of whole numbers, so
 * the relative error is below 3 (p + q) 2^-53. */
static void weights_of(int p, int q, double *w)
{
    for (int i = 0; i <= p; i++) {
        double weight = 1;
        for (int k = 0; k < i; k++) {
            weight *= (double)(p - k) / (p + q - k);
        }
        for (int k = 0; k <= q; k++) {
            w[i * (q + 1) + k] = weight;
            weight *= (double)(q - k) * (i + k + 1) / ((double)(k + 1) * (p + q - i - k));
        }
    }
}

/* One coefficient: sums over i + k = l and j + h = r of
 *     n m (dx_u[i][j] dy_v[k][h] - dy_u[i][j] dx_v[k][h]). */
static void sum_coefficient(const planar_patch *patch, const double *wu, const double *wv, int l,
                            int r, double *value, double *error)
{
    const int n = patch->n, m = patch->m, columns = 2 * (m + 1);
    const double apart = 2 * patch->apart;
    double sum = 0, size = 0, spread = 0;

    for (int i = l > n ? l - n : 0; i < n && i <= l; i++) {
        const int k = l - i; /* x_u has n rows of coefficients, x_v has n + 1 */
        for (int j = r >= m ? r - m + 1 : 0; j <= m && j <= r; j++) {
            const int h = r - j;
            const double *a = patch->x + i * columns + 2 * j, *b = patch->x + k * columns + 2 * h;
            const double xu = a[columns] - a[0], yu = a[columns + 1] - a[1];
            const double xv = b[2] - b[0], yv = b[3] - b[1];
            const double w = wu[i * (n + 1) + k] * wv[h * (m + 1) + j];
            const double big = fabs(xu * yv) + fabs(yu * xv);
            const int is_zero = (xu == 0 || yv == 0) && (yu == 0 || xv == 0);
            sum += w * (xu * yv - yu * xv);
            size += is_zero ? 0 : fmax(w * big, DBL_MIN);
            spread += w * apart * (fabs(xu) + fabs(yu) + fabs(xv) + fabs(yv) + 2 * apart);
        }
    }
    *value = n * m * sum;
    *error =
        n * m * ((8 * (double)(n + m) + 2.0 * n * m + 8) * TAUT_UNIT_ROUNDOFF * size + 2 * spread);
}

/* The coefficients of scale (x_u y_v - x_v y_u), du = 2n-1, dv = 2m-1: values double[2][2n][2m] as
 * above. scale > 0. scratch double[n (n+1) + m (m+1)]. Cost O(n^2 m^2). */
static void find_coefficients(const planar_patch *patch, double scale, taut_pulse *pulse,
                              double *scratch, double *values)
{
    const int n = patch->n, m = patch->m;
    double *wu = scratch, *wv = scratch + n * (n + 1);
    double *errors = values + (size_t)(2 * n) * (size_t)(2 * m);

    weights_of(n - 1, n, wu); /* i of x_u with k of x_v */
    weights_of(m - 1, m, wv); /* h of x_v with j of x_u */
    for (int l = 0; l < 2 * n; l++) {
        if (taut_pulse_beat(pulse, 0.5 * OF_PAIR * (n + 1) * m * (m + 1))) {
            return;
        }
        for (int r = 0; r < 2 * m; r++) {
            double value = 0, error = 0;
            sum_coefficient(patch, wu, wv, l, r, &value, &error);
            values[l * 2 * m + r] = scale * value;
            errors[l * 2 * m + r] = scale * (1 + 8 * TAUT_UNIT_ROUNDOFF) * error;
        }
    }
}

/* The halves of one line by de Casteljau's triangle at 1/2: `line` becomes the low one, `high` gets
 * the other; errors go along. */
static void halve_line(int degree, int64_t stride, double *value, double *error, double *high_value,
                       double *high_error)
{
    for (int step = 0; step <= degree; step++) {
        high_value[(degree - step) * stride] = value[degree * stride];
        high_error[(degree - step) * stride] = error[degree * stride];
        for (int i = degree; i > step; i--) {
            const double mean = 0.5 * (value[i * stride] + value[(i - 1) * stride]);
            const double bound = 0.5 * (error[i * stride] + error[(i - 1) * stride]);
            value[i * stride] = mean;
            error[i * stride] =
                bound * (1 + 4 * TAUT_UNIT_ROUNDOFF) + 2 * TAUT_UNIT_ROUNDOFF * fabs(mean);
        }
    }
}

/* Nonzero when it is to end: of one line halved. */
static int beat_of_line(taut_pulse *pulse, int degree)
{
    return taut_pulse_beat(pulse, 0.5 * OF_MEAN * degree * (degree + 1));
}

/* Halves the cell along both directions: children [2][2], low u slowest, whose `values` are there.
 * Means only, so errors grow by one rounding a step. scratch double[2][du+1][dv+1]. */
static void quarter_cell(int du, int dv, const jacobian_cell *cell, taut_pulse *pulse,
                         double *scratch, jacobian_cell children[4])
{
    const size_t count = (size_t)(du + 1) * (size_t)(dv + 1);
    const double middle[2] = {0.5 * cell->lo[0] + 0.5 * cell->hi[0],
                              0.5 * cell->lo[1] + 0.5 * cell->hi[1]};

    memcpy(children[0].values, cell->values, 2 * count * sizeof(double));
    for (int j = 0; j <= dv && !beat_of_line(pulse, du);
         j++) { /* low u in child 0, high u in the scratch */
        halve_line(du, dv + 1, children[0].values + j, children[0].values + count + j, scratch + j,
                   scratch + count + j);
    }
    memcpy(children[2].values, scratch, 2 * count * sizeof(double));
    for (int half = 0; half < 4; half += 2) {
        double *low = children[half].values, *high = children[half + 1].values;
        for (int i = 0; i <= du && !beat_of_line(pulse, 2 * dv); i++) {
            const int64_t row = (int64_t)i * (dv + 1);
            halve_line(dv, 1, low + row, low + count + row, high + row, high + count + row);
        }
    }
    for (int k = 0; k < 4; k++) {
        const int side[2] = {k / 2, k % 2};
        for (int d = 0; d < 2; d++) {
            children[k].lo[d] = side[d] ? middle[d] : cell->lo[d];
            children[k].hi[d] = side[d] ? cell->hi[d] : middle[d];
        }
    }
}

typedef struct search {
    const taut_surface *surface;
    taut_arena *arena;
    taut_pulse *pulse; /* or NULL */
    int axes[2];       /* the coordinates that are kept */
    int scale;         /* points are divided by 2^scale */
    double apart;      /* rounding in the points of pieces, scaled */
    int du, dv;
    double sign;
    jacobian_cell *cells; /* those to look at; their values are slots of the pool */
    int64_t count, limit, made;
    double *scratch;
    double *weights; /* of find_coefficients */
    double bound;    /* the least `low` of the cells that are done with */
    double lowest;   /* the least sign J at a corner of any cell */
    double lowest_at[2];
    int folds; /* nonzero: J of the other sign is proved at `lowest_at` */
} search;

static size_t numbers_of(const search *s)
{
    return (size_t)(s->du + 1) * (size_t)(s->dv + 1);
}

/* Nonzero when it is to end: before point k. */
static int beat_of_points(size_t k, taut_pulse *pulse)
{
    return k % SOME_POINTS == 0 && taut_pulse_beat(pulse, (double)OF_POINT * SOME_POINTS);
}

/* The coordinate to drop, 0..2, of points that are in one plane; -1 where they are not, 3 where
 * they are on one line. The scaled points are at most 1 in size. */
static int plane_of(size_t count, const double *points, int scale, taut_pulse *pulse)
{
    double a[3] = {0, 0, 0}, normal[3] = {0, 0, 0}, size = 0, area = 0, off = 0;

    for (size_t k = 1; k < count && !beat_of_points(k, pulse); k++) {
        double d[3];
        for (int c = 0; c < 3; c++) {
            d[c] = ldexp(points[3 * k + (size_t)c], -scale) - ldexp(points[c], -scale);
        }
        if (taut_norm(d) > size) {
            size = taut_norm(d);
            memcpy(a, d, sizeof a);
        }
    }
    for (int pass = 0; pass < 2; pass++) {
        for (size_t k = 1; k < count && !beat_of_points(k, pulse); k++) {
            double d[3], n[3];
            for (int c = 0; c < 3; c++) {
                d[c] = ldexp(points[3 * k + (size_t)c], -scale) - ldexp(points[c], -scale);
            }
            taut_cross(a, d, n);
            if (pass == 0 && taut_norm(n) > area) {
                area = taut_norm(n);
                memcpy(normal, n, sizeof normal);
            }
            off = pass == 1 ? fmax(off, fabs(taut_dot(normal, d))) : off;
        }
        if (area <= flatness * size * size) {
            return 3;
        }
    }
    if (off > flatness * size * area) {
        return -1;
    }
    const int first = fabs(normal[1]) > fabs(normal[0]) ? 1 : 0;
    return fabs(normal[2]) >= fabs(normal[first]) ? 2 : first;
}

/* Takes a cell into account: its corners, and whether it must be looked at again. */
static void judge_cell(search *s, const jacobian_cell *given)
{
    const int corners[4] = {0, s->dv, s->du * (s->dv + 1), s->du * (s->dv + 1) + s->dv};
    const size_t count = numbers_of(s);
    jacobian_cell cell = *given;
    int vanishes = 1;

    cell.low = INFINITY;
    for (size_t i = 0; i < count; i++) {
        vanishes = vanishes && cell.values[i] == 0 && cell.values[count + i] == 0;
        cell.low = fmin(cell.low, s->sign * cell.values[i] - cell.values[count + i]);
    }
    for (int k = 0; k < 4; k++) {
        const double value = s->sign * cell.values[corners[k]];
        if (value < s->lowest) {
            s->lowest = value;
            s->lowest_at[0] = k / 2 ? cell.hi[0] : cell.lo[0];
            s->lowest_at[1] = k % 2 ? cell.hi[1] : cell.lo[1];
        }
        s->folds = s->folds || value < -cell.values[count + (size_t)corners[k]];
    }
    s->folds = s->folds || vanishes;
    s->cells[s->count++] = cell;
}

/* Halves the cell of the least bound; 0 when there is nothing to gain, or no room. */
static int halve_worst(search *s)
{
    const size_t count = numbers_of(s);
    jacobian_cell cell, children[4];
    double *pool = NULL;
    int64_t worst = 0;

    for (int64_t k = 1; k < s->count; k++) {
        worst = s->cells[k].low < s->cells[worst].low ? k : worst;
    }
    cell = s->cells[worst];
    s->bound = cell.low;
    const int decided = s->folds || cell.low >= 0;
    const double gap = s->lowest - cell.low;
    if (s->made + 4 > s->limit || (decided && gap <= 0.01 * fabs(s->lowest)) ||
        (decided && s->made > POLISH)) {
        return 0;
    }
    pool = taut_arena_take(s->arena, 4 * 2 * count, sizeof(double));
    if (pool == NULL) {
        return -1;
    }
    for (int k = 0; k < 4; k++) {
        children[k].values = pool + 2 * count * (size_t)k;
    }
    quarter_cell(s->du, s->dv, &cell, s->pulse, s->scratch, children);
    s->cells[worst] = s->cells[--s->count];
    for (int k = 0; k < 4; k++) {
        judge_cell(s, &children[k]);
    }
    s->made += 4;
    return 1;
}

/* The first cell of a piece, in the parameters of the whole. */
static taut_status open_cell(search *s, const taut_surface *piece, jacobian_cell *cell)
{
    const taut_basis *basis[2] = {taut_surface_u(piece), taut_surface_v(piece)};
    const double *points = taut_surface_points(piece);
    const int n = taut_basis_degree(basis[0]), m = taut_basis_degree(basis[1]);
    const size_t count = (size_t)(n + 1) * (size_t)(m + 1);
    double *x = taut_arena_take(s->arena, 2 * count, sizeof(double));
    double scale = 1;

    cell->values = taut_arena_take(s->arena, 2 * numbers_of(s), sizeof(double));
    if (x == NULL || cell->values == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        for (size_t d = 0; d < 2; d++) {
            x[2 * k + d] = ldexp(points[3 * k + (size_t)s->axes[d]], -s->scale);
        }
    }
    for (int d = 0; d < 2; d++) {
        const taut_basis *whole = d == 0 ? taut_surface_u(s->surface) : taut_surface_v(s->surface);
        cell->lo[d] = taut_basis_lo(basis[d]);
        cell->hi[d] = taut_basis_hi(basis[d]);
        scale *= (taut_basis_hi(whole) - taut_basis_lo(whole)) / (cell->hi[d] - cell->lo[d]);
    }
    const planar_patch patch = {n, m, x, s->apart};
    find_coefficients(&patch, scale, s->pulse, s->weights, cell->values);
    return TAUT_OK;
}

/* A first cell for every piece, and the sign of the whole: that of the integral of J. */
static taut_status open_all(search *s, const taut_model *pieces)
{
    const int count = taut_model_surface_count(pieces);
    const size_t numbers = numbers_of(s);
    jacobian_cell *first = taut_arena_take(s->arena, (size_t)count, sizeof *first);
    double integral = 0;

    if (first == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < count && !taut_pulse_is_stopped(s->pulse); k++) {
        double sum = 0;
        if (open_cell(s, taut_model_surface(pieces, k), &first[k]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        for (size_t i = 0; i < numbers; i++) {
            sum += first[k].values[i];
        }
        integral += sum * (first[k].hi[0] - first[k].lo[0]) * (first[k].hi[1] - first[k].lo[1]);
    }
    if (taut_pulse_is_stopped(s->pulse)) {
        return TAUT_INTERRUPTED;
    }
    s->sign = integral < 0 ? -1 : 1;
    for (int k = 0; k < count; k++) {
        judge_cell(s, &first[k]);
    }
    s->made = count;
    return TAUT_OK;
}

static void report_sign(const search *s, taut_jacobian *jacobian)
{
    const taut_basis *u = taut_surface_u(s->surface), *v = taut_surface_v(s->surface);
    const double area =
        (taut_basis_hi(u) - taut_basis_lo(u)) * (taut_basis_hi(v) - taut_basis_lo(v));
    const double found = s->folds || s->bound < 0 ? s->lowest : s->bound;

    jacobian->state = s->folds        ? TAUT_JACOBIAN_FOLDS
                      : s->bound >= 0 ? TAUT_JACOBIAN_ONE_SIGN
                                      : TAUT_JACOBIAN_UNDECIDED;
    jacobian->sign = (int)s->sign;
    jacobian->lowest = ldexp(found / area, 2 * s->scale);
    memcpy(jacobian->at, s->lowest_at, sizeof jacobian->at);
    jacobian->cells = s->made;
}

static taut_status prove_sign(search *s, const taut_model *pieces, taut_jacobian *jacobian)
{
    const double work = (double)numbers_of(s) * (s->du + s->dv + 2);
    const int n = (s->du + 1) / 2, m = (s->dv + 1) / 2;
    int more = 1;

    s->limit =
        (int64_t)fmin(CELLS, fmax(CELLS_LEAST, 1e9 / work)) + taut_model_surface_count(pieces);
    s->cells = taut_arena_take(s->arena, (size_t)s->limit + 4, sizeof *s->cells);
    s->scratch = taut_arena_take(s->arena, 2 * numbers_of(s), sizeof(double));
    s->weights = taut_arena_take(s->arena, (size_t)(n * (n + 1) + m * (m + 1)), sizeof(double));
    if (taut_arena_status(s->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const taut_status status = open_all(s, pieces);
    if (status != TAUT_OK) {
        return status;
    }
    while (more > 0 && !taut_pulse_is_stopped(s->pulse)) {
        more = halve_worst(s);
    }
    if (taut_pulse_is_stopped(s->pulse)) {
        return TAUT_INTERRUPTED;
    }
    if (more == 0) {
        report_sign(s, jacobian);
    }
    return more == 0 ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The sign of J of a polynomial surface without weights, once the coordinates to keep are known. */
static taut_status prove_planar(search *s, taut_jacobian *jacobian)
{
    const taut_basis *u = taut_surface_u(s->surface), *v = taut_surface_v(s->surface);
    const int exact =
        strcmp(taut_basis_type(u), "bezier") == 0 && strcmp(taut_basis_type(v), "bezier") == 0;
    taut_model *pieces = NULL;
    taut_status status = taut_surface_pieces(s->surface, &pieces, NULL);

    if (status != TAUT_OK) {
        return status;
    }
    s->du = 2 * taut_basis_degree(u) - 1;
    s->dv = 2 * taut_basis_degree(v) - 1;
    /* a piece is reached by at most 2 degree insertions along each direction, means of points */
    s->apart = exact ? 0 : 8.0 * (s->du + s->dv + 2) * TAUT_UNIT_ROUNDOFF;
    s->arena = taut_arena_new();
    status = prove_sign(s, pieces, jacobian);
    taut_arena_free(s->arena);
    taut_model_free(pieces);
    return status;
}

taut_status taut_jacobian_of(const taut_surface *surface, taut_pulse *pulse,
                             taut_jacobian *jacobian)
{
    search s = {.surface = surface, .lowest = INFINITY, .pulse = pulse};
    taut_jacobian found = {TAUT_JACOBIAN_NONE, 0, taut_none, {taut_none, taut_none}, 0};
    taut_status status = TAUT_OK;

    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t count = taut_point_count(surface);
    s.scale = taut_exponent(taut_largest(count, taut_surface_points(surface)));
    const int dropped = plane_of(count, taut_surface_points(surface), s.scale, pulse);
    if (taut_pulse_is_stopped(pulse)) {
        return TAUT_INTERRUPTED;
    }
    if (dropped == 3) {
        found.state = TAUT_JACOBIAN_FOLDS;
        found.lowest = 0;
    } else if (dropped >= 0 && (taut_basis_degree(u) < 0 || taut_basis_degree(v) < 0 ||
                                taut_surface_weights(surface) != NULL)) {
        found.state = TAUT_JACOBIAN_UNSUPPORTED;
    } else if (dropped >= 0) {
        s.axes[0] = (dropped + 1) % 3;
        s.axes[1] = (dropped + 2) % 3;
        status = prove_planar(&s, &found);
    }
    if (status != TAUT_OK) {
        return status;
    }
    *jacobian = found;
    return TAUT_OK;
}

taut_status taut_surface_jacobian(const taut_surface *surface, taut_jacobian *jacobian)
{
    if (surface == NULL || jacobian == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    return taut_jacobian_of(surface, NULL, jacobian);
}
