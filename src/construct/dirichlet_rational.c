/* dirichlet_rational.c -- sum factorisation: one line of quadrature points at a time.
 *
 * With (a, w) = sum w_st (x_st, 1) N_s N_t and x = a/w, so x_u = (a_u - w_u x)/w, the product A x
 * is
 *
 *     (A x)_ij = w_ij iint  N_i' N_j U + N_i N_j' V - N_i N_j Z
 *     U = fu x_u / w,   V = fv x_v / w,   Z = (fu w_u x_u + fv w_v x_v) / w^2
 *
 * which is the definition with R_ij,u = w_ij (N_i' N_j / w - N_i N_j w_u / w^2) put in. On a line
 * u = const the net contracts to two polygons, and the three integrands spread back through two.
 */
#include "construct/dirichlet_rational.h"

#include "core/fail.h"
#include "core/memory.h"
#include "geometry/panels.h"
#include "geometry/table.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

/* Quadrature in one direction: slopes are over the unit interval, weights sum to 1. */
typedef struct rule {
    taut_table *table;
    double *weights;   /* [table->count] */
    double *roundings; /* [table->count]: |t| over the width of its span */
    double reach;      /* max |t| / length */
} rule;

struct taut_dirichlet_rational {
    const taut_basis *u, *v;
    taut_panels *panels_u, *panels_v;
    double *weights; /* [nu][nv] */
    int nodes;       /* a panel */
    rule along_u, along_v;
    double *polygons; /* [2][nv][4]: of values and of slopes in u */
    double *spread;   /* [2][nv][3]: what goes back with N_i and with N_i' */
    double *row_sums; /* [2][nu][nv]: for (fu, fv) = (1, 0), then (0, 1) */
};

static void rule_clear(rule *r)
{
    taut_table_free(r->table);
    taut_free(r->weights);
    taut_free(r->roundings);
    memset(r, 0, sizeof *r);
}

/* Parameters, spans and weights of `nodes` Gauss nodes on every panel. */
static void place_nodes(const taut_basis *basis, const taut_panels *panels, int nodes, double *t,
                        int *spans, rule *r)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);

    taut_gauss_rule(nodes, node, weight);
    r->reach = fmax(fabs(taut_basis_lo(basis)), fabs(taut_basis_hi(basis))) / length;
    for (int i = 0; i < panels->count * nodes; i++) {
        const int k = i / nodes, g = i % nodes, span = panels->span[k];
        t[i] = taut_panels_at(panels, k, node[g]);
        spans[i] = span;
        r->weights[i] = 0.5 * weight[g] * ((panels->hi[k] - panels->lo[k]) / length);
        r->roundings[i] = fabs(t[i]) / (breaks[span + 1] - breaks[span]);
    }
}

static taut_status rule_new(const taut_basis *basis, const taut_panels *panels, int nodes,
                            rule *made)
{
    const size_t count = (size_t)panels->count * (size_t)nodes;
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);
    double *t = taut_alloc(count, sizeof(double));
    int *spans = taut_alloc(count, sizeof(int));
    taut_status status = TAUT_NO_MEMORY;

    made->table = NULL;
    made->weights = taut_alloc(count, sizeof(double));
    made->roundings = taut_alloc(count, sizeof(double));
    if (t != NULL && spans != NULL && made->weights != NULL && made->roundings != NULL) {
        place_nodes(basis, panels, nodes, t, spans, made);
        status = taut_table_new(basis, (int)count, t, spans, 1, &made->table);
    }
    taut_free(t);
    taut_free(spans);
    if (status != TAUT_OK) {
        rule_clear(made);
        return status;
    }
    for (int i = 0; i < made->table->count; i++) {
        double *slopes = made->table->values + ((size_t)i * 2 + 1) * (size_t)made->table->local;
        for (int a = 0; a < made->table->local; a++) {
            slopes[a] *= length;
        }
    }
    return TAUT_OK;
}

static taut_status set_nodes(taut_dirichlet_rational *form, int nodes)
{
    rule u = {NULL, NULL, NULL, 0}, v = {NULL, NULL, NULL, 0};
    taut_status status = rule_new(form->u, form->panels_u, nodes, &u);
    if (status == TAUT_OK) {
        status = rule_new(form->v, form->panels_v, nodes, &v);
    }
    if (status != TAUT_OK) {
        rule_clear(&u);
        return status;
    }
    rule_clear(&form->along_u);
    rule_clear(&form->along_v);
    form->along_u = u;
    form->along_v = v;
    form->nodes = nodes;
    return TAUT_OK;
}

/* The slopes of R_ab = w_ab N_a N_b / w alive at one point, |R_ab,u| in slopes[0], |R_ab,v| in
 * slopes[1], double[local_u][local_v] each; sums[0..1] their sums, times what a rounding does. */
static void absolute_slopes(const taut_dirichlet_rational *form, int i, int k, double *slopes[2],
                            double sums[2])
{
    const taut_table *tu = form->along_u.table, *tv = form->along_v.table;
    const double *nu = taut_table_row(tu, i, 0), *du = taut_table_row(tu, i, 1);
    const double *nv = taut_table_row(tv, k, 0), *dv = taut_table_row(tv, k, 1);
    const size_t columns = (size_t)taut_basis_count(form->v);
    const double *weights = form->weights + (size_t)tu->first[i] * columns + (size_t)tv->first[k];
    double w = 0, wu = 0, wv = 0, factor = 0;

    for (int a = 0; a < tu->local; a++) {
        for (int b = 0; b < tv->local; b++) {
            const double wab = weights[(size_t)a * columns + (size_t)b];
            w += wab * nu[a] * nv[b];
            wu += wab * du[a] * nv[b];
            wv += wab * nu[a] * dv[b];
        }
    }
    factor = 1 + form->along_u.roundings[i] + form->along_v.roundings[k] +
             form->along_u.reach * fabs(wu / w) + form->along_v.reach * fabs(wv / w);
    sums[0] = sums[1] = 0;
    for (int a = 0; a < tu->local; a++) {
        for (int b = 0; b < tv->local; b++) {
            const double share = weights[(size_t)a * columns + (size_t)b] / w;
            const int at = a * tv->local + b;
            slopes[0][at] = fabs(share * nv[b] * (du[a] - nu[a] * (wu / w)));
            slopes[1][at] = fabs(share * nu[a] * (dv[b] - nv[b] * (wv / w)));
            sums[0] += factor * slopes[0][at];
            sums[1] += factor * slopes[1][at];
        }
    }
}

/* row_sums[ij] = iint |R_ij,u| sum |R_st,u|, and with v; slopes double[2][local_u][local_v]. */
static void add_row_sums(taut_dirichlet_rational *form, double *slopes)
{
    const taut_table *tu = form->along_u.table, *tv = form->along_v.table;
    const size_t columns = (size_t)taut_basis_count(form->v);
    const size_t count = (size_t)taut_basis_count(form->u) * columns;
    double *parts[2] = {slopes, slopes + (size_t)tu->local * (size_t)tv->local};

    for (int i = 0; i < tu->count; i++) {
        for (int k = 0; k < tv->count; k++) {
            const double weight = form->along_u.weights[i] * form->along_v.weights[k];
            double sums[2];
            absolute_slopes(form, i, k, parts, sums);
            for (int ab = 0; ab < tu->local * tv->local; ab++) {
                const size_t row = (size_t)(tu->first[i] + ab / tv->local) * columns;
                const size_t at = row + (size_t)(tv->first[k] + ab % tv->local);
                form->row_sums[at] += weight * parts[0][ab] * sums[0];
                form->row_sums[count + at] += weight * parts[1][ab] * sums[1];
            }
        }
    }
}

static taut_status find_row_sums(taut_dirichlet_rational *form)
{
    const size_t count = (size_t)taut_basis_count(form->u) * (size_t)taut_basis_count(form->v);
    const size_t alive = (size_t)form->along_u.table->local * (size_t)form->along_v.table->local;
    double *slopes = taut_alloc(2 * alive, sizeof(double));

    form->row_sums = taut_alloc_zero(2 * count, sizeof(double));
    if (slopes == NULL || form->row_sums == NULL) {
        taut_free(slopes);
        return TAUT_NO_MEMORY;
    }
    add_row_sums(form, slopes);
    taut_free(slopes);
    return TAUT_OK;
}

double taut_dirichlet_rational_row_sum(const taut_dirichlet_rational *form, double fu, double fv,
                                       int i, int j)
{
    const size_t columns = (size_t)taut_basis_count(form->v);
    const size_t count = (size_t)taut_basis_count(form->u) * columns;
    const size_t at = (size_t)i * columns + (size_t)j;
    return fu * form->row_sums[at] + fv * form->row_sums[count + at];
}

taut_status taut_dirichlet_rational_new(const taut_basis *u, const taut_basis *v,
                                        const double *weights, taut_dirichlet_rational **form,
                                        taut_error *error)
{
    const size_t nv = (size_t)taut_basis_count(v), count = (size_t)taut_basis_count(u) * nv;
    const int wider =
        taut_basis_local(u) > taut_basis_local(v) ? taut_basis_local(u) : taut_basis_local(v);
    taut_dirichlet_rational *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_NO_MEMORY;

    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->u = u;
    made->v = v;
    made->weights = taut_alloc(count, sizeof(double));
    made->polygons = taut_alloc_aligned(8 * nv, sizeof(double));
    made->spread = taut_alloc_aligned(6 * nv, sizeof(double));
    if (made->weights != NULL && made->polygons != NULL && made->spread != NULL) {
        memcpy(made->weights, weights, count * sizeof(double));
        status = taut_panels_new(u, (int)nv, weights, nv, 1, &made->panels_u);
    }
    if (status == TAUT_OK) {
        status = taut_panels_new(v, taut_basis_count(u), weights, 1, nv, &made->panels_v);
    }
    if (status == TAUT_OK) {
        status = set_nodes(made, wider + 3);
    }
    if (status == TAUT_OK) {
        status = find_row_sums(made);
    }
    if (status != TAUT_OK) {
        taut_dirichlet_rational_free(made);
        return taut_fail_memory(error);
    }
    *form = made;
    return TAUT_OK;
}

void taut_dirichlet_rational_free(taut_dirichlet_rational *form)
{
    if (form != NULL) {
        rule_clear(&form->along_u);
        rule_clear(&form->along_v);
        taut_panels_free(form->panels_u);
        taut_panels_free(form->panels_v);
        taut_free(form->weights);
        taut_free(form->polygons);
        taut_free(form->spread);
        taut_free(form->row_sums);
        taut_free(form);
    }
}

taut_status taut_dirichlet_rational_raise(taut_dirichlet_rational *form)
{
    const int nodes = form->nodes + form->nodes / 2;
    if (form->nodes >= TAUT_GAUSS_MAX) {
        return TAUT_NOT_CONVERGED;
    }
    return set_nodes(form, nodes < TAUT_GAUSS_MAX ? nodes : TAUT_GAUSS_MAX);
}

/* polygons[k][t] = sum_s N_s^(k)(u_i) w_st (x_st, 1),  k = 0, 1. */
static void contract(const taut_dirichlet_rational *form, int i, const double *x)
{
    const taut_table *table = form->along_u.table;
    const size_t nv = (size_t)taut_basis_count(form->v);

    memset(form->polygons, 0, 8 * nv * sizeof(double));
    for (int a = 0; a < table->local; a++) {
        const size_t row = (size_t)(table->first[i] + a) * nv;
        const double n = taut_table_row(table, i, 0)[a], slope = taut_table_row(table, i, 1)[a];
        for (size_t t = 0; t < nv; t++) {
            const double w = form->weights[row + t];
            double *values = form->polygons + 4 * t, *slopes = values + 4 * nv;
            for (size_t c = 0; c < 3; c++) {
                const double wx = w * x[3 * (row + t) + c];
                values[c] += n * wx;
                slopes[c] += slope * wx;
            }
            values[3] += n * w;
            slopes[3] += slope * w;
        }
    }
}

/* h = (a, w), its slopes in u and in v, at point k of the line. */
static void evaluate(const taut_dirichlet_rational *form, int k, double h[3][4])
{
    const taut_table *table = form->along_v.table;
    const size_t nv = (size_t)taut_basis_count(form->v), first = (size_t)table->first[k];
    const double *n = taut_table_row(table, k, 0), *slope = taut_table_row(table, k, 1);

    memset(h, 0, 12 * sizeof(double));
    for (int b = 0; b < table->local; b++) {
        const double *value = form->polygons + 4 * (first + (size_t)b), *along = value + 4 * nv;
        for (int c = 0; c < 4; c++) {
            h[0][c] += n[b] * value[c];
            h[1][c] += n[b] * along[c];
            h[2][c] += slope[b] * value[c];
        }
    }
}

/* slopes[0] = x_u, slopes[1] = x_v. */
static void slopes_of(double h[3][4], double slopes[2][3])
{
    for (int c = 0; c < 3; c++) {
        const double x = h[0][c] / h[0][3];
        slopes[0][c] = (h[1][c] - h[1][3] * x) / h[0][3];
        slopes[1][c] = (h[2][c] - h[2][3] * x) / h[0][3];
    }
}

/* U, V, Z times the quadrature weight. */
static void integrands(double weight, double fu, double fv, double h[3][4], double out[3][3])
{
    const double w = h[0][3], wu = h[1][3] / w, wv = h[2][3] / w;
    double slopes[2][3];

    slopes_of(h, slopes);
    for (int c = 0; c < 3; c++) {
        out[0][c] = weight * (fu * slopes[0][c] / w);
        out[1][c] = weight * (fv * slopes[1][c] / w);
        out[2][c] = out[0][c] * wu + out[1][c] * wv;
    }
}

/* spread[0] += N_j' V - N_j Z,  spread[1] += N_j U  at point k of the line. */
static void spread_point(const taut_dirichlet_rational *form, int k, double weight, double fu,
                         double fv)
{
    const taut_table *table = form->along_v.table;
    const size_t nv = (size_t)taut_basis_count(form->v), first = (size_t)table->first[k];
    const double *n = taut_table_row(table, k, 0), *slope = taut_table_row(table, k, 1);
    double h[3][4], out[3][3];

    evaluate(form, k, h);
    integrands(weight, fu, fv, h, out);
    for (int b = 0; b < table->local; b++) {
        double *still = form->spread + 3 * (first + (size_t)b), *along = still + 3 * nv;
        for (int c = 0; c < 3; c++) {
            still[c] += slope[b] * out[1][c] - n[b] * out[2][c];
            along[c] += n[b] * out[0][c];
        }
    }
}

/* y_st += w_st (N_s spread[0][t] + N_s' spread[1][t]). */
static void add_line(const taut_dirichlet_rational *form, int i, double *y)
{
    const taut_table *table = form->along_u.table;
    const size_t nv = (size_t)taut_basis_count(form->v);
    for (int a = 0; a < table->local; a++) {
        const size_t row = (size_t)(table->first[i] + a) * nv;
        const double n = taut_table_row(table, i, 0)[a], slope = taut_table_row(table, i, 1)[a];
        for (size_t t = 0; t < nv; t++) {
            const double w = form->weights[row + t];
            const double *still = form->spread + 3 * t, *along = still + 3 * nv;
            for (size_t c = 0; c < 3; c++) {
                y[3 * (row + t) + c] += w * (n * still[c] + slope * along[c]);
            }
        }
    }
}

void taut_dirichlet_rational_apply(taut_dirichlet_rational *form, double fu, double fv,
                                   const double *x, double *y)
{
    const size_t nu = (size_t)taut_basis_count(form->u), nv = (size_t)taut_basis_count(form->v);
    const rule *ru = &form->along_u, *rv = &form->along_v;

    memset(y, 0, 3 * nu * nv * sizeof(double));
    for (int i = 0; i < ru->table->count; i++) {
        contract(form, i, x);
        memset(form->spread, 0, 6 * nv * sizeof(double));
        for (int k = 0; k < rv->table->count; k++) {
            spread_point(form, k, ru->weights[i] * rv->weights[k], fu, fv);
        }
        add_line(form, i, y);
    }
}

void taut_dirichlet_rational_energies(taut_dirichlet_rational *form, const double *x,
                                      double halves[2])
{
    const rule *ru = &form->along_u, *rv = &form->along_v;

    halves[0] = halves[1] = 0;
    for (int i = 0; i < ru->table->count; i++) {
        contract(form, i, x);
        for (int k = 0; k < rv->table->count; k++) {
            const double weight = 0.5 * ru->weights[i] * rv->weights[k];
            double h[3][4], slopes[2][3];
            evaluate(form, k, h);
            slopes_of(h, slopes);
            for (int c = 0; c < 3; c++) {
                halves[0] += weight * slopes[0][c] * slopes[0][c];
                halves[1] += weight * slopes[1][c] * slopes[1][c];
            }
        }
    }
}
