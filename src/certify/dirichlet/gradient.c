/* gradient.c -- one line u = const of quadrature points after another.
 *
 * On a line the integrals over v are gathered per column of the net, then spread over the rows
 * whose functions are alive. Without weights phi = N_i N_j. With weights, w = sum w_st N_s N_t,
 *
 *     phi = w_ij N_i N_j / w,     phi_u = w_ij N_j (N_i' - N_i w_u / w) / w
 *
 * so the same sums run with x_u / w for x_u, and a third one takes N_i N_j (x_u w_u + ..) / w^2.
 */
#include "certify/dirichlet/gradient.h"

#include "core/arena.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/grid/table.h"
#include "geometry/keep.h"
#include "geometry/nurbs/cells.h"
#include "numeric/quadrature.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    VALUES = 9,   /* x, x_u, x_v of a point */
    CHANNELS = 4, /* three coordinates, and the gross */
    LINES = 16    /* evaluated at once */
};

/* Gauss nodes on every span of a direction; slopes in the table are over the unit interval. */
typedef struct axis {
    taut_table *table; /* order 1 */
    double *t;
    double *weights;   /* their sum is 1 */
    double *roundings; /* degree |t| over the width of the span: what a rounding of t is there */
    double length;
    double reach; /* max |t| / length */
    int count;
} axis;

typedef struct work {
    taut_arena *arena; /* of all below */
    axis u, v;
    int nu, nv;
    taut_surface *centred;
    const double *weights; /* of the surface, or NULL */
    double *sizes;         /* [nu][nv]: largest coordinate of each point as stored, in the unit */
    double fu, fv;         /* the larger one is 1 */
    int is_area;
    int unit;         /* its power of two */
    double *lines;    /* [LINES][v.count][3][3] */
    double *polygons; /* [4][nv]: w and w_u; gross of values and of slopes in u */
    double *spread;   /* [2][nv][CHANNELS]: what goes back with N_i, and with N_i' */
} work;

static taut_status fill_axis(const taut_basis *basis, const taut_cells *cells, int nodes,
                             taut_arena *arena, axis *a)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double *breaks = taut_basis_breaks(basis);
    const size_t count = (size_t)cells->count * (size_t)nodes;
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];

    a->count = (int)count;
    a->length = hi - lo;
    a->reach = fmax(fabs(lo), fabs(hi)) / a->length;
    a->t = taut_arena_take(arena, count, sizeof(double));
    a->weights = taut_arena_take(arena, count, sizeof(double));
    a->roundings = taut_arena_take(arena, count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(nodes, node, weight);
    for (int k = 0; k < a->count; k++) {
        const int cell = k / nodes, span = cells->span[cell];
        const double t = taut_cells_at(cells, cell, node[k % nodes]);
        const double width = cells->hi[cell] - cells->lo[cell];
        a->t[k] = t < breaks[span + 1] ? t : breaks[span]; /* the span of t must be this one */
        a->weights[k] = 0.5 * weight[k % nodes] * (width / a->length);
        a->roundings[k] = taut_basis_local(basis) * fabs(t) / taut_cells_finest(basis, span);
    }
    return TAUT_OK;
}

/* lines, step, next as in geometry/nurbs/cells.h. */
static taut_status make_axis(const taut_basis *basis, int lines, const double *surface_weights,
                             size_t step, size_t next, int nodes, taut_arena *arena, axis *a)
{
    taut_cells *cells = NULL;
    taut_status status = taut_cells_new(basis, lines, surface_weights, step, next, &cells);

    if (status != TAUT_OK) {
        return status;
    }
    status = fill_axis(basis, cells, nodes, arena, a);
    taut_cells_free(cells);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_table_new(basis, a->count, a->t, NULL, 1, &a->table);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < a->count; k++) {
        double *slopes = a->table->values + (2 * (size_t)k + 1) * (size_t)a->table->local;
        for (int i = 0; i < a->table->local; i++) {
            slopes[i] *= a->length;
        }
    }
    return taut_keep_table(arena, a->table) ? TAUT_OK : TAUT_NO_MEMORY;
}

/* The exponent e with largest < 2^e, 0 for 0. */
static int exponent_of(double largest)
{
    int e = 0;
    (void)frexp(largest, &e);
    return e;
}

/* The surface with its points around 0 and of about unit size, and the sizes of the points as they
 * are. The unit is a power of two, so that scaling rounds nothing. */
static taut_status centre_surface(const taut_surface *surface, work *w)
{
    const size_t count = (size_t)w->nu * (size_t)w->nv;
    const double *p = taut_surface_points(surface);
    double *moved = taut_arena_take(w->arena, 3 * count, sizeof(double));
    double largest = 0, size = 0;
    taut_status status = TAUT_OK;
    int coarse = 0, fine = 0;

    w->sizes = taut_arena_take(w->arena, count, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        largest = fmax(largest, fabs(p[i]));
    }
    coarse = exponent_of(largest);
    for (size_t i = 0; i < 3 * count; i++) {
        moved[i] = ldexp(p[i], -coarse) - ldexp(p[i % 3], -coarse); /* from the first point */
        size = fmax(size, fabs(moved[i]));
    }
    fine = exponent_of(size);
    w->unit = coarse + fine;
    for (size_t i = 0; i < 3 * count; i++) {
        moved[i] = ldexp(moved[i], -fine);
    }
    for (size_t i = 0; i < count; i++) {
        /* numbers below DBL_MIN are stored with its rounding */
        const double x =
            fmax(fmax(fabs(p[3 * i]), DBL_MIN), fmax(fabs(p[3 * i + 1]), fabs(p[3 * i + 2])));
        w->sizes[i] = ldexp(ldexp(x, -coarse), -fine);
    }
    status = taut_surface_new("", taut_surface_u(surface), taut_surface_v(surface), moved,
                              w->weights, &w->centred, NULL);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_keep_surface(w->arena, w->centred) ? TAUT_OK : TAUT_NO_MEMORY;
}

/* w->arena is there, or NULL. */
static taut_status prepare(const taut_surface *surface, double aspect, int nodes, work *w)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface));
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    taut_status status = TAUT_OK;
    double f = 0;

    w->nu = (int)nu;
    w->nv = (int)nv;
    w->weights = taut_surface_weights(surface);
    status = make_axis(taut_surface_u(surface), w->nv, w->weights, nv, 1, nodes, w->arena, &w->u);
    if (status != TAUT_OK) {
        return status;
    }
    status = make_axis(taut_surface_v(surface), w->nu, w->weights, 1, nv, nodes, w->arena, &w->v);
    if (status != TAUT_OK) {
        return status;
    }
    status = centre_surface(surface, w);
    if (status != TAUT_OK) {
        return status;
    }
    w->lines = taut_arena_take(w->arena, LINES * VALUES * (size_t)w->v.count, sizeof(double));
    w->polygons = taut_arena_take(w->arena, 4 * nv, sizeof(double));
    w->spread = taut_arena_take(w->arena, 2 * CHANNELS * nv, sizeof(double));
    f = aspect * (w->v.length / w->u.length);
    w->fu = f >= 1 ? 1 : f * f;
    w->fv = f >= 1 ? 1 / f / f : 1;
    return taut_arena_status(w->arena);
}

/* polygons[0..1][t] = sum_s N_s w_st, N_s' w_st;   [2..3][t] = sum_s N_s w_st |P_st|, |N_s'| .. */
static void contract_line(const work *w, int line)
{
    const taut_table *table = w->u.table;
    const size_t nv = (size_t)w->nv;
    double *p = w->polygons;

    memset(p, 0, 4 * nv * sizeof(double));
    for (int a = 0; a < table->local; a++) {
        const double n = taut_table_row(table, line, 0)[a], d = taut_table_row(table, line, 1)[a];
        const size_t row = (size_t)(table->first[line] + a) * nv;
        for (size_t t = 0; t < nv; t++) {
            const double weight = w->weights != NULL ? w->weights[row + t] : 1;
            const double gross = weight * w->sizes[row + t];
            p[t] += n * weight;
            p[nv + t] += d * weight;
            p[2 * nv + t] += n * gross;
            p[3 * nv + t] += fabs(d) * gross;
        }
    }
}

/* w, w_u, w_v and the gross of x, x_u, x_v (before the division by w) at point k of the line. */
static void find_sums(const work *w, int k, double sums[6])
{
    const taut_table *table = w->v.table;
    const size_t nv = (size_t)w->nv;
    const double *p = w->polygons + table->first[k];
    const double *n = taut_table_row(table, k, 0), *d = taut_table_row(table, k, 1);

    memset(sums, 0, 6 * sizeof(double));
    sums[0] = w->weights == NULL;
    for (size_t b = 0; w->weights != NULL && b < (size_t)table->local; b++) {
        sums[0] += n[b] * p[b];
        sums[1] += n[b] * p[nv + b];
        sums[2] += d[b] * p[b];
    }
    for (size_t b = 0; b < (size_t)table->local; b++) {
        sums[3] += n[b] * p[2 * nv + b];
        sums[4] += n[b] * p[3 * nv + b];
        sums[5] += fabs(d[b]) * p[2 * nv + b];
    }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* The quadratic form in x_u, x_v that the gradient is of, over the unit square: the constant one of
 * the Dirichlet energy, or for the area (G, -F, E) / W of the surface itself, 0 where W is. Returns
 * W in the latter case. */
static double find_form(const work *w, const double *x, double form[3])
{
    const double *xu = x + 3 * TAUT_XU, *xv = x + 3 * TAUT_XV;
    const double u = w->u.length, v = w->v.length;
    double normal[3], element = 0;

    form[0] = w->fu;
    form[1] = 0;
    form[2] = w->fv;
    if (w->is_area) {
        taut_cross(xu, xv, normal);
        element = taut_norm(normal) * u * v;
        const double inverse = element > 0x1p-500 ? 1 / element : 0;
        form[0] = taut_dot(xv, xv) * v * v * inverse;
        form[1] = -taut_dot(xu, xv) * u * v * inverse;
        form[2] = taut_dot(xu, xu) * u * u * inverse;
    }
    return element;
}

/* What multiplies N_i' N_j (out[0]), N_i N_j' (out[1]) and -N_i N_j (out[2]) at one point, in each
 * channel. In the gross one every sign is positive, and the slopes of the surface times what a
 * rounding of (u, v) is to basis and w are added. */
static void find_integrands(const work *w, double weight, double roundings, const double *x,
                            const double sums[6], const double form[3], double out[3][CHANNELS])
{
    const double inverse = 1 / sums[0];
    const double wu = w->weights != NULL ? sums[1] * inverse : 0;
    const double wv = w->weights != NULL ? sums[2] * inverse : 0;
    const double scale = weight * inverse;
    const double fu = scale * form[0], mixed = scale * form[1], fv = scale * form[2];
    const double all = roundings + w->u.reach * fabs(wu) + w->v.reach * fabs(wv);
    double gross_u = 0, gross_v = 0;

    for (int c = 0; c < 3; c++) {
        const double xu = x[3 * TAUT_XU + c] * w->u.length, xv = x[3 * TAUT_XV + c] * w->v.length;
        out[0][c] = fu * xu + mixed * xv;
        out[1][c] = mixed * xu + fv * xv;
        out[2][c] = out[0][c] * wu + out[1][c] * wv;
        gross_u = larger(gross_u, fabs(xu));
        gross_v = larger(gross_v, fabs(xv));
    }
    gross_u = all * gross_u + (sums[4] + fabs(wu) * sums[3]) * inverse;
    gross_v = all * gross_v + (sums[5] + fabs(wv) * sums[3]) * inverse;
    out[0][3] = fu * gross_u + fabs(mixed) * gross_v;
    out[1][3] = fabs(mixed) * gross_u + fv * gross_v;
    out[2][3] = -(out[0][3] * fabs(wu) + out[1][3] * fabs(wv));
}

/* spread[0] += N_j' V - N_j Z,   spread[1] += N_j U. */
static void gather_point(const work *w, int k, double out[3][CHANNELS])
{
    const taut_table *table = w->v.table;
    const double *n = taut_table_row(table, k, 0), *d = taut_table_row(table, k, 1);
    double *still = w->spread + CHANNELS * (size_t)table->first[k];
    double *along = still + CHANNELS * (size_t)w->nv;

    for (int b = 0; b < table->local; b++) {
        const double slopes[CHANNELS] = {d[b], d[b], d[b], fabs(d[b])};
        for (int c = 0; c < CHANNELS; c++) {
            still[c] += slopes[c] * out[1][c];
            along[c] += n[b] * out[0][c];
        }
        for (int c = 0; w->weights != NULL && c < CHANNELS; c++) {
            still[c] -= n[b] * out[2][c];
        }
        still += CHANNELS;
        along += CHANNELS;
    }
}

/* values and gross of the rows alive on the line += w_ij (N_i spread[0] + N_i' spread[1]). */
static void add_line(const work *w, int line, taut_dirichlet_gradient *g)
{
    const taut_table *table = w->u.table;
    const size_t nv = (size_t)w->nv;
    for (int a = 0; a < table->local; a++) {
        const double n = taut_table_row(table, line, 0)[a], d = taut_table_row(table, line, 1)[a];
        const size_t row = (size_t)(table->first[line] + a) * nv;
        for (size_t t = 0; t < nv; t++) {
            const double *still = w->spread + CHANNELS * t, *along = still + CHANNELS * nv;
            const double weight = w->weights != NULL ? w->weights[row + t] : 1;
            for (size_t c = 0; c < 3; c++) {
                g->values[3 * (row + t) + c] += weight * (n * still[c] + d * along[c]);
            }
            g->gross[row + t] += weight * (n * still[3] + fabs(d) * along[3]);
        }
    }
}

static double square(const double *x)
{
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}

/* One line, from the values of its points. */
static void integrate_line(work *w, int line, const double *values, taut_dirichlet_gradient *g)
{
    const double area = w->u.length * w->v.length;

    contract_line(w, line);
    memset(w->spread, 0, 2 * CHANNELS * (size_t)w->nv * sizeof(double));
    for (int k = 0; k < w->v.count; k++) {
        const double *x = values + VALUES * (size_t)k;
        const double weight = w->u.weights[line] * w->v.weights[k];
        double sums[6], form[3], out[3][CHANNELS];
        find_sums(w, k, sums);
        g->area += weight * find_form(w, x, form);
        find_integrands(w, weight, w->u.roundings[line] + w->v.roundings[k], x, sums, form, out);
        gather_point(w, k, out);
        g->halves[0] += weight * square(x + 3 * TAUT_XU) * area;
        g->halves[1] += weight * square(x + 3 * TAUT_XV) * area;
    }
    add_line(w, line, g);
}

static taut_status integrate_surface(work *w, taut_dirichlet_gradient *g)
{
    for (int from = 0; from < w->u.count; from += LINES) {
        const int count = w->u.count - from < LINES ? w->u.count - from : LINES;
        const taut_status status = taut_surface_eval_grid(w->centred, count, w->u.t + from,
                                                          w->v.count, w->v.t, 1, 1, w->lines);
        if (status != TAUT_OK) {
            return status;
        }
        for (int i = 0; i < count; i++) {
            integrate_line(w, from + i, w->lines + VALUES * (size_t)w->v.count * (size_t)i, g);
        }
    }
    return TAUT_OK;
}

static taut_status find_gradient(const taut_surface *surface, double aspect, int nodes, work *w,
                                 taut_dirichlet_gradient *made)
{
    const taut_status status = prepare(surface, aspect, nodes, w);
    const size_t count = (size_t)w->nu * (size_t)w->nv;

    if (status != TAUT_OK) {
        return status;
    }
    made->unit = w->unit;
    made->values = taut_alloc_zero(3 * count, sizeof(double));
    made->gross = taut_alloc_zero(count, sizeof(double));
    if (made->values == NULL || made->gross == NULL) {
        return TAUT_NO_MEMORY;
    }
    return integrate_surface(w, made);
}

static taut_status gradient_new(const taut_surface *surface, int is_area, double aspect, int nodes,
                                taut_dirichlet_gradient *gradient)
{
    taut_dirichlet_gradient made = {NULL, NULL, {0, 0}, 0, 0};
    work w = {.arena = taut_arena_new(), .is_area = is_area};
    const taut_status status = find_gradient(surface, aspect, nodes, &w, &made);

    taut_arena_free(w.arena);
    if (status != TAUT_OK) {
        taut_dirichlet_gradient_clear(&made);
        return status;
    }
    *gradient = made;
    return TAUT_OK;
}

taut_status taut_dirichlet_gradient_new(const taut_surface *surface, double aspect, int nodes,
                                        taut_dirichlet_gradient *gradient)
{
    return gradient_new(surface, 0, aspect, nodes, gradient);
}

taut_status taut_area_gradient_new(const taut_surface *surface, int nodes,
                                   taut_dirichlet_gradient *gradient)
{
    return gradient_new(surface, 1, 1, nodes, gradient);
}

void taut_dirichlet_gradient_clear(taut_dirichlet_gradient *gradient)
{
    taut_free(gradient->values);
    taut_free(gradient->gross);
    memset(gradient, 0, sizeof *gradient);
}
