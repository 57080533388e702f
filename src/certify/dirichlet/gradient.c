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

#include "certify/dirichlet/remainder.h"
#include "core/arena.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/grid/table.h"
#include "geometry/keep.h"
#include "geometry/nurbs/cells.h"
#include "geometry/nurbs/spread.h"
#include "numeric/quadrature.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    VALUES = 9,   /* x, x_u, x_v of a point */
    CHANNELS = 4, /* three coordinates, and the gross */
    LINES = 16,   /* evaluated at once */
    HALVINGS = 6, /* of cells, for the sake of a bound */
    ROUNDS = 10,  /* of halvings, for the sake of fewer nodes */
    FEW_NODES = 20
};

/* A remainder this small, of the integral of the absolute value, is no more than the rounding of the
 * sum; the area is at rest to 1e-10 or so, and its bounds cost more. Gauss points, and terms of the
 * cells' bounds, that a plan may cost. */
static const double dirichlet_goal = 0x1p-50, area_goal = 0x1p-46, points_most = 4e6,
                    pairs_most = 1e6;
/* Of the goal: what is missed on a cell that is not to be halved. */
static const double share_of_cell = 0x1p-4;
/* Gauss points that rules may be raised to where no bound decides: about a second of work. */
static const double raised_most = 0x1p24;

/* Gauss nodes on every span of a direction; slopes in the table are over the unit interval. */
typedef struct axis {
    taut_table *table; /* order 1 */
    double *t;
    double *weights;   /* their sum is 1 */
    double *roundings; /* degree |t| over the width of the span: what a rounding of t is there */
    double length;
    double reach; /* max |t| / length */
    int count;
    int alive; /* cells where one function is not 0, at most */
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
    double roundings; /* see gradient.h */
    double *lines;    /* [LINES][v.count][3][3] */
    double *polygons; /* [4][nv]: w and w_u; gross of values and of slopes in u */
    double *spread;   /* [2][nv][CHANNELS]: what goes back with N_i, and with N_i' */
    int nodes;        /* a cell; sums are taken over cells first, so that few terms meet */
    double *cell;     /* [2][local v][CHANNELS]: of the cell of v at hand */
    double *rows;     /* [local u][nv][CHANNELS]: of the cell of u at hand */
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

/* Every cell in 2^halvings alike, in the arena. */
static taut_status halve_cells(const taut_cells *cells, int halvings, taut_arena *arena,
                               taut_cells *out)
{
    const int parts = 1 << halvings;
    const size_t count = (size_t)cells->count * (size_t)parts;

    out->count = (int)count;
    out->lo = taut_arena_take(arena, count, sizeof(double));
    out->hi = taut_arena_take(arena, count, sizeof(double));
    out->span = taut_arena_take(arena, count, sizeof(int));
    for (size_t k = 0; k < count && taut_arena_status(arena) == TAUT_OK; k++) {
        const size_t whole = k / (size_t)parts, part = k % (size_t)parts;
        const double lo = cells->lo[whole], width = cells->hi[whole] - lo;
        out->span[k] = cells->span[whole];
        out->lo[k] = lo + ldexp(width, -halvings) * (double)part;
        out->hi[k] = (int)part + 1 == parts ? cells->hi[whole]
                                            : lo + ldexp(width, -halvings) * (double)(part + 1);
    }
    return taut_arena_status(arena);
}

/* The cells of direction d of a surface, in the arena. */
static taut_status cut_direction(const taut_surface *surface, int d, int halvings,
                                 taut_arena *arena, taut_cells *out)
{
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const size_t nv = (size_t)taut_basis_count(basis[1]);
    taut_cells *cells = NULL;
    taut_status status =
        taut_cells_new(basis[d], taut_basis_count(basis[1 - d]), taut_surface_weights(surface),
                       d == 0 ? nv : 1, d == 0 ? 1 : nv, &cells);

    if (status == TAUT_OK) {
        status = halve_cells(cells, halvings, arena, out);
        taut_cells_free(cells);
    }
    return status;
}

/* The largest number of cells on the spans of one function. */
static int count_alive(const taut_basis *basis, const taut_cells *cells)
{
    const int local = taut_basis_local(basis);
    int most = 0;
    for (int from = 0, to = 0; from < cells->count; from++) {
        while (to < cells->count && taut_basis_first(basis, cells->span[to]) <
                                        taut_basis_first(basis, cells->span[from]) + local) {
            to++;
        }
        most = to - from > most ? to - from : most;
    }
    return most;
}

static taut_status make_axis(const taut_surface *surface, int d, const taut_gradient_rule *rule,
                             taut_arena *arena, axis *a)
{
    const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const taut_cells *cells = rule->cells[d];
    taut_cells halved;
    taut_status status = TAUT_OK;

    if (cells == NULL) {
        status = cut_direction(surface, d, rule->halvings, arena, &halved);
        cells = &halved;
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = fill_axis(basis, cells, rule->nodes, arena, a);
    a->alive = count_alive(basis, cells);
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

/* The factors of |x_u|^2 and |x_v|^2 over the unit square. */
static void find_form_factors(const taut_surface *surface, double aspect, double *fu, double *fv)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double f =
        aspect * ((taut_basis_hi(v) - taut_basis_lo(v)) / (taut_basis_hi(u) - taut_basis_lo(u)));
    *fu = f >= 1 ? 1 : f * f;
    *fv = f >= 1 ? 1 / f / f : 1;
}

/* Terms that meet in one sum, of a cell and of the cells where a function is not 0, line by line; and
 * what each of them went through: values of functions, sums over the net, the form. */
static double count_roundings(const work *w, int nodes)
{
    double roundings = 24;
    for (int d = 0; d < 2; d++) {
        const axis *a = d == 0 ? &w->u : &w->v;
        roundings += nodes + a->alive + 8.0 * a->table->local;
    }
    return roundings;
}

/* w->arena is there, or NULL. */
static taut_status prepare(const taut_surface *surface, double aspect,
                           const taut_gradient_rule *rule, work *w)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface));
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    taut_status status = TAUT_OK;

    w->nu = (int)nu;
    w->nv = (int)nv;
    w->weights = taut_surface_weights(surface);
    status = make_axis(surface, 0, rule, w->arena, &w->u);
    if (status != TAUT_OK) {
        return status;
    }
    status = make_axis(surface, 1, rule, w->arena, &w->v);
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
    w->nodes = rule->nodes;
    w->cell = taut_arena_take(w->arena, 2 * CHANNELS * (size_t)w->v.table->local, sizeof(double));
    w->rows = taut_arena_take(w->arena, CHANNELS * (size_t)w->u.table->local * nv, sizeof(double));
    if (taut_arena_status(w->arena) == TAUT_OK) {
        memset(w->cell, 0, 2 * CHANNELS * (size_t)w->v.table->local * sizeof(double));
        memset(w->rows, 0, CHANNELS * (size_t)w->u.table->local * nv * sizeof(double));
    }
    find_form_factors(surface, aspect, &w->fu, &w->fv);
    w->roundings = count_roundings(w, rule->nodes);
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
        element = taut_length(normal) * u * v;
        const double inverse = element > 0x1p-400 ? 1 / element : 0;
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

/* cell[0] += N_j' V - N_j Z,   cell[1] += N_j U. */
static void gather_point(const work *w, int k, double out[3][CHANNELS])
{
    const taut_table *table = w->v.table;
    const double *n = taut_table_row(table, k, 0), *d = taut_table_row(table, k, 1);
    double *still = w->cell, *along = still + CHANNELS * (size_t)table->local;

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

/* The cell of v that point k ends goes to the spread. */
static void end_cell(const work *w, int k)
{
    const size_t length = CHANNELS * (size_t)w->v.table->local;
    double *still = w->spread + CHANNELS * (size_t)w->v.table->first[k];
    double *along = still + CHANNELS * (size_t)w->nv;

    for (size_t c = 0; c < length; c++) {
        still[c] += w->cell[c];
        along[c] += w->cell[length + c];
    }
    memset(w->cell, 0, 2 * length * sizeof(double));
}

/* rows of the functions alive on the line += w_ij (N_i spread[0] + N_i' spread[1]). */
static void add_line(const work *w, int line)
{
    const taut_table *table = w->u.table;
    const size_t nv = (size_t)w->nv;
    for (int a = 0; a < table->local; a++) {
        const double n = taut_table_row(table, line, 0)[a], d = taut_table_row(table, line, 1)[a];
        const size_t row = (size_t)(table->first[line] + a) * nv;
        double *out = w->rows + CHANNELS * (size_t)a * nv;
        for (size_t t = 0; t < nv; t++) {
            const double *still = w->spread + CHANNELS * t, *along = still + CHANNELS * nv;
            const double weight = w->weights != NULL ? w->weights[row + t] : 1;
            for (size_t c = 0; c < 3; c++) {
                out[CHANNELS * t + c] += weight * (n * still[c] + d * along[c]);
            }
            out[CHANNELS * t + 3] += weight * (n * still[3] + fabs(d) * along[3]);
        }
    }
}

/* The cell of u that the line ends goes to values and gross. */
static void end_rows(const work *w, int line, taut_dirichlet_gradient *g)
{
    const size_t count = (size_t)w->u.table->local * (size_t)w->nv;
    const size_t first = (size_t)w->u.table->first[line] * (size_t)w->nv;

    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            g->values[3 * (first + i) + c] += w->rows[CHANNELS * i + c];
        }
        g->gross[first + i] += w->rows[CHANNELS * i + 3];
    }
    memset(w->rows, 0, CHANNELS * count * sizeof(double));
}

static double square(const double *x)
{
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}

static double sizes_of(const double *x)
{
    return fabs(x[0]) + fabs(x[1]) + fabs(x[2]);
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
        if ((k + 1) % w->nodes == 0) {
            end_cell(w, k);
        }
        if (!w->is_area) { /* out[0][3], out[1][3]: factor, weight over w, and rounding of the slope */
            g->halves_gross[0] +=
                2 * sizes_of(x + 3 * TAUT_XU) * out[0][3] * sums[0] / w->fu * w->v.length;
            g->halves_gross[1] +=
                2 * sizes_of(x + 3 * TAUT_XV) * out[1][3] * sums[0] / w->fv * w->u.length;
        }
        g->halves[0] += weight * square(x + 3 * TAUT_XU) * area;
        g->halves[1] += weight * square(x + 3 * TAUT_XV) * area;
    }
    add_line(w, line);
    if ((line + 1) % w->nodes == 0) {
        end_rows(w, line, g);
    }
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

static taut_status find_gradient(const taut_surface *surface, double aspect,
                                 const taut_gradient_rule *rule, work *w,
                                 taut_dirichlet_gradient *made)
{
    const taut_status status = prepare(surface, aspect, rule, w);
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

static taut_status gradient_new(const taut_surface *surface, int is_area, double aspect,
                                const taut_gradient_rule *rule, taut_dirichlet_gradient *gradient)
{
    taut_dirichlet_gradient made = {.unit = 0};
    work w = {.arena = taut_arena_new(), .is_area = is_area};
    const taut_status status = find_gradient(surface, aspect, rule, &w, &made);

    taut_arena_free(w.arena);
    if (status != TAUT_OK) {
        taut_dirichlet_gradient_clear(&made);
        return status;
    }
    made.roundings = w.roundings;
    made.remainder = rule->remainder;
    made.points = (double)w.u.count * w.v.count;
    made.spans = (double)taut_basis_span_count(taut_surface_u(surface)) *
                 taut_basis_span_count(taut_surface_v(surface));
    *gradient = made;
    return TAUT_OK;
}

taut_status taut_dirichlet_gradient_new(const taut_surface *surface, double aspect,
                                        const taut_gradient_rule *rule,
                                        taut_dirichlet_gradient *gradient)
{
    return gradient_new(surface, 0, aspect, rule, gradient);
}

taut_status taut_area_gradient_new(const taut_surface *surface, const taut_gradient_rule *rule,
                                   taut_dirichlet_gradient *gradient)
{
    return gradient_new(surface, 1, 1, rule, gradient);
}

/* ---- where to halve: the rows and columns of cells that need it ---- */

typedef struct plan {
    taut_arena *arena;
    taut_remainder_request in;
    taut_cells cells[2];
    double goal; /* of the remainder: INFINITY where a cell has no bound */
    int is_enough;
    double cost; /* Gauss points of the best rule so far */
    taut_gradient_rule best;
    taut_cells taken[2]; /* its cells */
} plan;

/* Takes the cheapest rule on these cells whose remainder is below the noise, and else the best. */
static void take_rule(plan *p, const double remainder[TAUT_REMAINDER_RULES])
{
    for (int k = 0; k < TAUT_REMAINDER_RULES; k++) {
        const int nodes = taut_remainder_nodes[k];
        const double points = (double)p->cells[0].count * p->cells[1].count * nodes * nodes;
        const int enough = remainder[k] <= p->goal;
        if (points <= points_most && isfinite(remainder[k]) &&
            (enough ? !p->is_enough || points < p->cost
                    : !p->is_enough && remainder[k] < p->best.remainder)) {
            p->best = (taut_gradient_rule){.nodes = nodes, .remainder = remainder[k]};
            memcpy(p->taken, p->cells, sizeof p->taken);
            p->cost = points;
            p->is_enough = enough;
        }
    }
}

/* marks[d][k]: cell k of direction d is to be halved; returns how many. Cells without a bound come
 * first, in both directions; once all have one, those that miss too much, in the direction that
 * does. */
static int mark_cells(const plan *p, char *const marks[2])
{
    const double most = share_of_cell * p->goal;
    const size_t nv = (size_t)p->cells[1].count, pairs = (size_t)p->cells[0].count * nv;
    int count = 0;

    for (size_t k = 0; k < pairs; k++) {
        const double *missed = p->in.missed + 2 * k;
        const int is_unbounded = !isfinite(missed[0] + missed[1]);
        for (int d = 0; d < 2; d++) {
            char *mark = marks[d] + (d == 0 ? k / nv : k % nv);
            const int is_marked = is_unbounded || missed[d] > most;
            count += is_marked && !*mark;
            *mark = *mark || is_marked;
        }
    }
    return count;
}

static taut_status halve_marked(const taut_cells *cells, const char *marks, taut_arena *arena,
                                taut_cells *out)
{
    const size_t most = 2 * (size_t)cells->count;

    out->count = 0;
    out->lo = taut_arena_take(arena, most, sizeof(double));
    out->hi = taut_arena_take(arena, most, sizeof(double));
    out->span = taut_arena_take(arena, most, sizeof(int));
    for (int k = 0; k < cells->count && taut_arena_status(arena) == TAUT_OK; k++) {
        const double lo = cells->lo[k], hi = cells->hi[k], middle = lo + 0.5 * (hi - lo);
        const int parts = marks[k] && middle > lo && middle < hi ? 2 : 1;
        for (int part = 0; part < parts; part++) {
            out->lo[out->count] = part == 0 ? lo : middle;
            out->hi[out->count] = part + 1 == parts ? hi : middle;
            out->span[out->count++] = cells->span[k];
        }
    }
    return taut_arena_status(arena);
}

/* Bounds the rules on the cells at hand, and takes the best. */
static taut_status try_cells(plan *p)
{
    const size_t pairs = (size_t)p->cells[0].count * (size_t)p->cells[1].count;
    double remainder[TAUT_REMAINDER_RULES], scale = INFINITY;

    p->in.cells[0] = &p->cells[0];
    p->in.cells[1] = &p->cells[1];
    p->in.missed = taut_arena_take(p->arena, pairs, 2 * sizeof(double));
    if (p->in.missed == NULL ||
        taut_gradient_remainder(&p->in, p->arena, remainder, &scale) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    p->goal = (p->in.is_area ? area_goal : dirichlet_goal) * scale;
    take_rule(p, remainder);
    return TAUT_OK;
}

/* Halves what needs it. *is_done: nothing does, or it cannot be afforded. */
static taut_status refine_cells(plan *p, int *is_done)
{
    const double work_of_pair =
        (double)taut_basis_local(p->in.basis[0]) * taut_basis_local(p->in.basis[1]);
    taut_cells finer[2];
    char *marks[2];

    for (int d = 0; d < 2; d++) {
        marks[d] = taut_arena_take(p->arena, (size_t)p->cells[d].count, 1);
    }
    if (taut_arena_status(p->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    *is_done = mark_cells(p, marks) == 0;
    for (int d = 0; d < 2; d++) {
        if (halve_marked(&p->cells[d], marks[d], p->arena, &finer[d]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    *is_done |= (double)finer[0].count * finer[1].count * work_of_pair > pairs_most;
    memcpy(p->cells, finer, sizeof finer);
    return TAUT_OK;
}

static taut_status search_rule(plan *p)
{
    int is_done = 0;

    for (int round = 0; !is_done; round++) {
        taut_status status = try_cells(p);
        if (status != TAUT_OK) {
            return status;
        }
        if ((p->is_enough && p->best.nodes <= FEW_NODES) ||
            round == (isfinite(p->goal) ? ROUNDS : HALVINGS)) {
            return TAUT_OK; /* half the nodes on half the cells will not do */
        }
        status = refine_cells(p, &is_done);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

static taut_status plan_rule(const taut_surface *surface, int is_area, double aspect,
                             taut_arena *arena, taut_gradient_rule *rule)
{
    plan p = {
        .arena = arena,
        .in = {.basis = {taut_surface_u(surface), taut_surface_v(surface)},
               .weights = taut_surface_weights(surface),
               .is_area = is_area},
        .cost = INFINITY,
        .best = {.remainder = INFINITY},
    };
    work w = {.arena = arena, .weights = p.in.weights};
    taut_status status = TAUT_OK;

    w.nu = taut_basis_count(p.in.basis[0]);
    w.nv = taut_basis_count(p.in.basis[1]);
    status = centre_surface(surface, &w);
    if (status != TAUT_OK) {
        return status;
    }
    p.in.points = taut_surface_points(w.centred);
    find_form_factors(surface, aspect, &p.in.fu, &p.in.fv);
    for (int d = 0; d < 2; d++) {
        if (cut_direction(surface, d, 0, arena, &p.cells[d]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    status = search_rule(&p);
    *rule = p.best;
    for (int d = 0; d < 2 && status == TAUT_OK && rule->nodes > 0; d++) {
        status = taut_cells_copy(&p.taken[d], &rule->cells[d]);
    }
    return status;
}

taut_status taut_gradient_plan(const taut_surface *surface, int is_area, double aspect,
                               taut_gradient_rule *rule)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int local =
        taut_basis_local(u) > taut_basis_local(v) ? taut_basis_local(u) : taut_basis_local(v);
    taut_gradient_rule made = {.remainder = INFINITY};

    if (!is_area && taut_surface_weights(surface) == NULL && taut_basis_degree(u) >= 0 &&
        taut_basis_degree(v) >= 0) {
        *rule = (taut_gradient_rule){.nodes = local + 1}; /* exact with one node less */
        return TAUT_OK;
    }
    if (taut_weight_spread(surface) > TAUT_SPREAD_MAX) {
        *rule = made;
        return TAUT_OK;
    }
    taut_arena *arena = taut_arena_new();
    const taut_status status = plan_rule(surface, is_area, aspect, arena, &made);

    taut_arena_free(arena);
    if (status == TAUT_OK) {
        *rule = made;
    } else {
        taut_gradient_rule_clear(&made);
    }
    return status;
}

int taut_gradient_raise(taut_gradient_rule *rule, const taut_dirichlet_gradient *before)
{
    const int more = rule->nodes + rule->nodes / 2;
    const int nodes = more < TAUT_GAUSS_MAX ? more : TAUT_GAUSS_MAX;
    const double growth = (double)nodes / rule->nodes;
    const double most =
        fmax(raised_most, before->spans * (double)TAUT_GAUSS_MAX * (double)TAUT_GAUSS_MAX);

    if (nodes == rule->nodes || before->points * growth * growth > most) {
        return 0;
    }
    rule->nodes = nodes;
    return 1;
}

void taut_gradient_rule_clear(taut_gradient_rule *rule)
{
    taut_cells_free(rule->cells[0]);
    taut_cells_free(rule->cells[1]);
    memset(rule, 0, sizeof *rule);
}

void taut_dirichlet_gradient_clear(taut_dirichlet_gradient *gradient)
{
    taut_free(gradient->values);
    taut_free(gradient->gross);
    memset(gradient, 0, sizeof *gradient);
}
