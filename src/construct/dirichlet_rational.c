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
#include "geometry/table.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

/* Quadrature in one direction: slopes are over the unit interval, weights sum to 1. */
typedef struct rule {
    taut_table *table;
    double *weights; /* [table->count] */
} rule;

struct taut_dirichlet_rational {
    const taut_basis *u, *v;
    double *weights; /* [nu][nv] */
    int nodes;       /* a span */
    rule along_u, along_v;
    double *polygons; /* [2][nv][4]: of values and of slopes in u */
    double *spread;   /* [2][nv][3]: what goes back with N_i and with N_i' */
};

static void rule_clear(rule *r)
{
    taut_table_free(r->table);
    taut_free(r->weights);
    memset(r, 0, sizeof *r);
}

/* Parameters, spans and weights of `nodes` Gauss nodes on every span. */
static void place_nodes(const taut_basis *basis, int nodes, double *t, int *spans, double *weights)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);

    taut_gauss_rule(nodes, node, weight);
    for (int k = 0; k < taut_basis_span_count(basis); k++) {
        const double width = breaks[k + 1] - breaks[k];
        for (int g = 0; g < nodes; g++) {
            *t++ = fmin(breaks[k] + width * (0.5 * (1 + node[g])), breaks[k + 1]);
            *spans++ = k;
            *weights++ = 0.5 * weight[g] * (width / length);
        }
    }
}

static taut_status rule_new(const taut_basis *basis, int nodes, rule *made)
{
    const size_t count = (size_t)taut_basis_span_count(basis) * (size_t)nodes;
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);
    double *t = taut_alloc(count, sizeof(double));
    int *spans = taut_alloc(count, sizeof(int));
    taut_status status = TAUT_NO_MEMORY;

    made->table = NULL;
    made->weights = taut_alloc(count, sizeof(double));
    if (t != NULL && spans != NULL && made->weights != NULL) {
        place_nodes(basis, nodes, t, spans, made->weights);
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
    rule u = {NULL, NULL}, v = {NULL, NULL};
    taut_status status = rule_new(form->u, nodes, &u);
    if (status == TAUT_OK) {
        status = rule_new(form->v, nodes, &v);
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
        status = set_nodes(made, wider + 3);
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
        taut_free(form->weights);
        taut_free(form->polygons);
        taut_free(form->spread);
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

/* U, V, Z times the quadrature weight, from (a, w) and its derivatives h[0], h[1], h[2]. */
static void integrands(double weight, double fu, double fv, double h[3][4], double out[3][3])
{
    const double w = h[0][3], wu = h[1][3] / w, wv = h[2][3] / w;
    for (int c = 0; c < 3; c++) {
        const double x = h[0][c] / w;
        const double xu = (h[1][c] - h[1][3] * x) / w, xv = (h[2][c] - h[2][3] * x) / w;
        out[0][c] = weight * (fu * xu / w);
        out[1][c] = weight * (fv * xv / w);
        out[2][c] = weight * ((fu * wu * xu + fv * wv * xv) / w);
    }
}

/* spread[0] += N_j' V - N_j Z,  spread[1] += N_j U  at point k of the line. */
static void spread_point(const taut_dirichlet_rational *form, int k, double weight, double fu,
                         double fv)
{
    const taut_table *table = form->along_v.table;
    const size_t nv = (size_t)taut_basis_count(form->v), first = (size_t)table->first[k];
    const double *n = taut_table_row(table, k, 0), *slope = taut_table_row(table, k, 1);
    double h[3][4] = {{0}}, out[3][3];

    for (int b = 0; b < table->local; b++) {
        const double *value = form->polygons + 4 * (first + (size_t)b), *along = value + 4 * nv;
        for (int c = 0; c < 4; c++) {
            h[0][c] += n[b] * value[c];
            h[1][c] += n[b] * along[c];
            h[2][c] += slope[b] * value[c];
        }
    }
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
