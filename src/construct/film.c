/* film.c -- one line u = const of Gauss points after another: the rows of the net alive there are
 * contracted with the functions of u once for the line, then with those of v at each point; what
 * comes back is gathered along v per column of the net and spread over the rows once (sum
 * factorisation). Nothing is allocated after taut_film_new. */
#include "construct/film.h"

#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/panels.h"
#include "geometry/table.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <string.h>

static void axis_clear(taut_film_axis *a)
{
    taut_free(a->first);
    taut_free(a->value);
    taut_free(a->slope);
    taut_free(a->weights);
}

/* value, slope and first from the table of both. */
static void axis_fill(const taut_table *table, double length, taut_film_axis *a)
{
    const size_t local = (size_t)a->local;
    for (int k = 0; k < a->count; k++) {
        const double *slopes = taut_table_row(table, k, 1);
        a->first[k] = table->first[k];
        memcpy(a->value + (size_t)k * local, taut_table_row(table, k, 0), local * sizeof(double));
        for (size_t i = 0; i < local; i++) {
            a->slope[(size_t)k * local + i] = slopes[i] * length;
        }
    }
}

/* t: room for the parameters. */
static taut_status axis_tabulate(const taut_basis *basis, const taut_panels *panels, double *t,
                                 taut_film_axis *a)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);
    taut_table *table = NULL;
    taut_status status = TAUT_OK;

    taut_gauss_rule(a->nodes, node, weight);
    for (int k = 0; k < a->count; k++) {
        const int panel = k / a->nodes, span = panels->span[panel];
        const double at = taut_panels_at(panels, panel, node[k % a->nodes]);
        const double width = panels->hi[panel] - panels->lo[panel];
        t[k] = at < breaks[span + 1] ? at : breaks[span]; /* the span of t must be this one */
        a->weights[k] = 0.5 * weight[k % a->nodes] * (width / length);
    }
    status = taut_table_new(basis, a->count, t, NULL, 1, &table);
    if (status == TAUT_OK) {
        axis_fill(table, length, a);
    }
    taut_table_free(table);
    return status;
}

/* lines, step, next as in geometry/panels.h. */
static taut_status axis_new(const taut_basis *basis, int lines, const double *weights, size_t step,
                            size_t next, int extra, taut_film_axis *a)
{
    taut_panels *panels = NULL;
    double *t = NULL;
    taut_status status = taut_panels_new(basis, lines, weights, step, next, &panels);

    if (status == TAUT_OK) {
        const int wanted = taut_basis_local(basis) + extra;
        a->local = taut_basis_local(basis);
        a->nodes = wanted < TAUT_GAUSS_MAX ? wanted : TAUT_GAUSS_MAX;
        a->count = panels->count * a->nodes;
        const size_t count = (size_t)a->count, table = count * (size_t)a->local;
        t = taut_alloc(count, sizeof(double));
        a->first = taut_alloc(count, sizeof(int));
        a->weights = taut_alloc(count, sizeof(double));
        a->value = taut_alloc(table, sizeof(double));
        a->slope = taut_alloc(table, sizeof(double));
        status = t != NULL && a->first != NULL && a->weights != NULL && a->value != NULL &&
                         a->slope != NULL
                     ? axis_tabulate(basis, panels, t, a)
                     : TAUT_NO_MEMORY;
    }
    taut_free(t);
    taut_panels_free(panels);
    return status;
}

/* polygons[0][j] = sum_i N_i(u) net_ij,    polygons[1][j] = sum_i N_i'(u) net_ij. */
static void contract(const taut_film *film, int line, const double *net)
{
    const size_t width = 3 * (size_t)film->nv, local = (size_t)film->u.local;
    const double *n = film->u.value + (size_t)line * local;
    const double *d = film->u.slope + (size_t)line * local;
    const double *row = net + (size_t)film->u.first[line] * width;
    double *restrict still = film->polygons, *restrict along = film->polygons + width;

    memset(still, 0, 2 * width * sizeof(double));
    for (size_t a = 0; a < local; a++, row += width) {
        for (size_t j = 0; j < width; j++) {
            still[j] += n[a] * row[j];
            along[j] += d[a] * row[j];
        }
    }
}

/* The derivatives at point k of the line: jet = x_u, x_v. q: the point's quotient, or NULL. */
static void jet_at(const taut_film *film, int k, const double *q, double jet[6])
{
    const size_t width = 3 * (size_t)film->nv, local = (size_t)film->v.local;
    const double *n = film->v.value + (size_t)k * local, *d = film->v.slope + (size_t)k * local;
    const double *still = film->polygons + 3 * (size_t)film->v.first[k], *along = still + width;
    double x[3] = {0, 0, 0};

    memset(jet, 0, 6 * sizeof(double));
    for (size_t b = 0; b < local; b++) {
        for (size_t c = 0; c < 3; c++) {
            jet[c] += n[b] * along[3 * b + c];
            jet[3 + c] += d[b] * still[3 * b + c];
            x[c] += n[b] * still[3 * b + c];
        }
    }
    for (size_t c = 0; q != NULL && c < 3; c++) {
        jet[c] = (jet[c] - q[1] * x[c]) * q[0];
        jet[3 + c] = (jet[3 + c] - q[2] * x[c]) * q[0];
    }
}

/* spread += what the fluxes f_u, f_v at point k of the line give each column. */
static void gather(const taut_film *film, int k, const double *q, const double flux[6])
{
    const size_t width = 3 * (size_t)film->nv, local = (size_t)film->v.local;
    const double *n = film->v.value + (size_t)k * local, *d = film->v.slope + (size_t)k * local;
    double *restrict still = film->spread + 3 * (size_t)film->v.first[k];
    double *restrict along = still + width;
    const double scale = q != NULL ? q[0] : 1;
    double back[3] = {0, 0, 0};

    for (size_t c = 0; q != NULL && c < 3; c++) {
        back[c] = scale * (flux[c] * q[1] + flux[3 + c] * q[2]);
    }
    for (size_t b = 0; b < local; b++) {
        for (size_t c = 0; c < 3; c++) {
            still[3 * b + c] += scale * d[b] * flux[3 + c] - n[b] * back[c];
            along[3 * b + c] += scale * n[b] * flux[c];
        }
    }
}

/* net += spread, over the rows alive on the line. */
static void spread(const taut_film *film, int line, double *net)
{
    const size_t width = 3 * (size_t)film->nv, local = (size_t)film->u.local;
    const double *n = film->u.value + (size_t)line * local;
    const double *d = film->u.slope + (size_t)line * local;
    const double *restrict still = film->spread, *restrict along = film->spread + width;
    double *row = net + (size_t)film->u.first[line] * width;

    for (size_t a = 0; a < local; a++, row += width) {
        for (size_t j = 0; j < width; j++) {
            row[j] += n[a] * still[j] + d[a] * along[j];
        }
    }
}

/* The net times the weights. */
static const double *weigh(taut_film *film, const double *net)
{
    const size_t count = (size_t)film->nu * (size_t)film->nv;
    if (film->weights == NULL) {
        return net;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        film->net[i] = film->weights[i / 3] * net[i];
    }
    return film->net;
}

static void unweigh(const taut_film *film, double *net)
{
    const size_t count = (size_t)film->nu * (size_t)film->nv;
    for (size_t i = 0; film->weights != NULL && i < 3 * count; i++) {
        net[i] *= film->weights[i / 3];
    }
}

static const double *quotient_at(const taut_film *film, int line, int k)
{
    const size_t at = (size_t)line * (size_t)film->v.count + (size_t)k;
    return film->quotient != NULL ? film->quotient + 3 * at : NULL;
}

/* w at every point, by the same contraction with w_ij in the first coordinate. */
static void fill_quotients(taut_film *film)
{
    const size_t count = (size_t)film->nu * (size_t)film->nv, local = (size_t)film->v.local;
    double *q = film->quotient;

    memset(film->net, 0, 3 * count * sizeof(double));
    for (size_t i = 0; i < count; i++) {
        film->net[3 * i] = film->weights[i];
    }
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line, film->net);
        for (int k = 0; k < film->v.count; k++, q += 3) {
            const double *still = film->polygons + 3 * (size_t)film->v.first[k];
            double jet[6], w = 0;
            jet_at(film, k, NULL, jet);
            for (size_t b = 0; b < local; b++) {
                w += film->v.value[(size_t)k * local + b] * still[3 * b];
            }
            q[0] = 1 / w;
            q[1] = jet[0] / w;
            q[2] = jet[3] / w;
        }
    }
}

static taut_status take_weights(const double *weights, taut_film *film)
{
    const size_t count = (size_t)film->nu * (size_t)film->nv;
    double largest = 0;

    film->weights = taut_alloc(count, sizeof(double));
    film->net = taut_alloc_aligned(3 * count, sizeof(double));
    film->quotient =
        taut_alloc_aligned((size_t)film->u.count * (size_t)film->v.count, 3 * sizeof(double));
    if (film->weights == NULL || film->net == NULL || film->quotient == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        largest = weights[i] > largest ? weights[i] : largest;
    }
    for (size_t i = 0; i < count; i++) {
        film->weights[i] = weights[i] / largest;
    }
    fill_quotients(film);
    return TAUT_OK;
}

void taut_film_free(taut_film *film)
{
    if (film != NULL) {
        axis_clear(&film->u);
        axis_clear(&film->v);
        taut_free(film->weights);
        taut_free(film->quotient);
        taut_free(film->state);
        taut_free(film->net);
        taut_free(film->polygons);
        taut_free(film->spread);
        taut_free(film);
    }
}

taut_status taut_film_new(const taut_basis *u, const taut_basis *v, const double *weights,
                          int extra, taut_film **film)
{
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    taut_film *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_NO_MEMORY;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->nu = nu;
    made->nv = nv;
    status = axis_new(u, nv, weights, (size_t)nv, 1, extra, &made->u);
    if (status == TAUT_OK) {
        status = axis_new(v, nu, weights, 1, (size_t)nv, extra, &made->v);
    }
    if (status == TAUT_OK) {
        made->state = taut_alloc_aligned((size_t)made->u.count * (size_t)made->v.count,
                                         TAUT_FILM_STATE * sizeof(double));
        made->polygons = taut_alloc_aligned(6 * (size_t)nv, sizeof(double));
        made->spread = taut_alloc_aligned(6 * (size_t)nv, sizeof(double));
        status = made->state != NULL && made->polygons != NULL && made->spread != NULL
                     ? TAUT_OK
                     : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK && weights != NULL) {
        status = take_weights(weights, made);
    }
    if (status != TAUT_OK) {
        taut_film_free(made);
        return status;
    }
    *film = made;
    return TAUT_OK;
}

/* At each point 6 numbers from the functions alive along v, and what is made of them. */
double taut_film_cost(const taut_film *film)
{
    return 12.0 * (film->v.local + 4) * film->u.count * film->v.count;
}

taut_film_value taut_film_area(taut_film *film, const double *net)
{
    taut_film_value value = {0, INFINITY};
    taut_sum sum = {0, 0};

    film->work += taut_film_cost(film);
    net = weigh(film, net);
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line, net);
        for (int k = 0; k < film->v.count; k++) {
            double jet[6], normal[3];
            jet_at(film, k, quotient_at(film, line, k), jet);
            taut_cross(jet, jet + 3, normal);
            const double w = sqrt(taut_dot(normal, normal));
            value.least = w < value.least ? w : value.least;
            taut_sum_add(&sum, film->u.weights[line] * film->v.weights[k] * w);
        }
    }
    value.area = taut_sum_total(&sum);
    value.least = value.area > 0 ? value.least / value.area : 0;
    return value;
}

/* The state and the fluxes, times the weight, of one point; returns W. */
static double enter(const double jet[6], double weight, double *state, double flux[6])
{
    double normal[3];
    taut_cross(jet, jet + 3, normal);
    const double w = sqrt(taut_dot(normal, normal));

    if (!(w > 0x1p-500)) {
        memset(state, 0, TAUT_FILM_STATE * sizeof(double));
        memset(flux, 0, 6 * sizeof(double));
        return w;
    }
    for (int c = 0; c < 3; c++) {
        state[c] = normal[c] / w;
    }
    state[3] = weight * taut_dot(jet, jet) / w;
    state[4] = weight * taut_dot(jet, jet + 3) / w;
    state[5] = weight * taut_dot(jet + 3, jet + 3) / w;
    state[6] = weight;
    taut_cross(jet + 3, state, flux);
    taut_cross(state, jet, flux + 3);
    for (int c = 0; c < 6; c++) {
        flux[c] *= weight;
    }
    return w;
}

taut_film_value taut_film_gradient(taut_film *film, const double *net, double *gradient)
{
    const size_t width = 3 * (size_t)film->nv;
    taut_film_value value = {0, INFINITY};
    taut_sum sum = {0, 0};
    double *state = film->state;

    film->work += 2 * taut_film_cost(film);
    net = weigh(film, net);
    memset(gradient, 0, (size_t)film->nu * width * sizeof(double));
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line, net);
        memset(film->spread, 0, 2 * width * sizeof(double));
        for (int k = 0; k < film->v.count; k++, state += TAUT_FILM_STATE) {
            const double *q = quotient_at(film, line, k);
            const double weight = film->u.weights[line] * film->v.weights[k];
            double jet[6], flux[6];
            jet_at(film, k, q, jet);
            const double w = enter(jet, weight, state, flux);
            value.least = w < value.least ? w : value.least;
            taut_sum_add(&sum, weight * w);
            gather(film, k, q, flux);
        }
        spread(film, line, gradient);
    }
    unweigh(film, gradient);
    value.area = taut_sum_total(&sum);
    value.least = value.area > 0 ? value.least / value.area : 0;
    return value;
}

/* The change of the fluxes when x_u, x_v change by d, in B. */
static void change(const double *state, double theta, const double d[6], double flux[6])
{
    const double *n = state, e = state[3], f = state[4], g = state[5];
    const double nu = taut_dot(n, d), nv = taut_dot(n, d + 3), rest = 1 - theta;
    const double along_u = rest * (g * nu - f * nv), along_v = rest * (e * nv - f * nu);
    double to_u[3], to_v[3];

    taut_cross(d + 3, n, to_u);
    taut_cross(n, d, to_v);
    for (int c = 0; c < 3; c++) {
        flux[c] = along_u * n[c] + rest * state[6] * to_u[c] + theta * (g * d[c] - f * d[3 + c]);
        flux[3 + c] =
            along_v * n[c] + rest * state[6] * to_v[c] + theta * (e * d[3 + c] - f * d[c]);
    }
}

void taut_film_product(taut_film *film, double theta, const double *direction, double *product)
{
    const size_t width = 3 * (size_t)film->nv;
    const double *state = film->state, *net = weigh(film, direction);

    film->work += 2 * taut_film_cost(film);
    memset(product, 0, (size_t)film->nu * width * sizeof(double));
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line, net);
        memset(film->spread, 0, 2 * width * sizeof(double));
        for (int k = 0; k < film->v.count; k++, state += TAUT_FILM_STATE) {
            const double *q = quotient_at(film, line, k);
            double jet[6], flux[6];
            jet_at(film, k, q, jet);
            change(state, theta, jet, flux);
            gather(film, k, q, flux);
        }
        spread(film, line, product);
    }
    unweigh(film, product);
}
