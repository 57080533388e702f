/* area.c -- one line u = const of Gauss points after another: the rows of the net alive there are
 * contracted with the functions of u once for the line, then with those of v panel by panel, all
 * points of a panel side by side (area_kernel.h); what comes back is gathered along v per column of
 * the net and spread over the rows once (sum factorisation). Nothing is allocated after
 * taut_film_new. */
#include "construct/plateau/area.h"

#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/grid/table.h"
#include "geometry/nurbs/cells.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <string.h>

static void axis_clear(taut_film_axis *a)
{
    taut_free(a->first);
    taut_free(a->value);
    taut_free(a->slope);
    taut_free(a->weights);
    taut_free(a->values);
    taut_free(a->slopes);
    taut_free(a->by_node);
    taut_free(a->sloped);
    taut_free(a->group_weights);
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
static taut_status axis_tabulate(const taut_basis *basis, const taut_cells *panels, double *t,
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
        const double at = taut_cells_at(panels, panel, node[k % a->nodes]);
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

/* lines, step, next as in geometry/nurbs/cells.h. */
static taut_status axis_new(const taut_basis *basis, int lines, const double *weights, size_t step,
                            size_t next, int extra, taut_film_axis *a)
{
    taut_cells *panels = NULL;
    double *t = NULL;
    taut_status status = taut_cells_new(basis, lines, weights, step, next, &panels);

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
    taut_cells_free(panels);
    return status;
}

static int rounded_up(int count, int lanes)
{
    return (count + lanes - 1) / lanes * lanes;
}

/* The tables for kernels. */
static taut_status axis_arrange(int lanes, taut_film_axis *a)
{
    const size_t local = (size_t)a->local, nodes = (size_t)a->nodes;
    const size_t panels = (size_t)a->count / nodes;
    const size_t group = (size_t)rounded_up(a->nodes, lanes);
    const size_t wide = (size_t)rounded_up(a->local, lanes);

    a->group = (int)group;
    a->wide = (int)wide;
    a->values = taut_alloc_zero(panels * local, group * sizeof(double));
    a->slopes = taut_alloc_zero(panels * local, group * sizeof(double));
    a->by_node = taut_alloc_zero(panels * nodes, wide * sizeof(double));
    a->sloped = taut_alloc_zero(panels * nodes, wide * sizeof(double));
    a->group_weights = taut_alloc_zero(panels, group * sizeof(double));
    if (a->values == NULL || a->slopes == NULL || a->by_node == NULL || a->sloped == NULL ||
        a->group_weights == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < panels * nodes; k++) {
        const size_t panel = k / nodes, g = k % nodes;
        a->group_weights[panel * group + g] = a->weights[k];
        for (size_t b = 0; b < local; b++) {
            a->values[(panel * local + b) * group + g] = a->value[k * local + b];
            a->slopes[(panel * local + b) * group + g] = a->slope[k * local + b];
            a->by_node[k * wide + b] = a->value[k * local + b];
            a->sloped[k * wide + b] = a->slope[k * local + b];
        }
    }
    return TAUT_OK;
}

/* film->net = the net in planes, times the weights. */
static void take_net(taut_film *film, const double *net)
{
    const size_t nv = (size_t)film->nv;

    for (size_t i = 0; i < (size_t)film->nu; i++) {
        double *row = film->net + i * film->width;
        for (size_t j = 0; j < nv; j++, net += 3) {
            const double w = film->weights != NULL ? film->weights[i * nv + j] : 1;
            for (size_t c = 0; c < 3; c++) {
                row[c * film->stride + j] = w * net[c];
            }
        }
    }
}

static double *film_sums(const taut_film *film)
{
    return film->net + (size_t)film->nu * film->width;
}

static void give_sums(const taut_film *film, double *net)
{
    const size_t nv = (size_t)film->nv;

    for (size_t i = 0; i < (size_t)film->nu; i++) {
        const double *row = film_sums(film) + i * film->width;
        for (size_t j = 0; j < nv; j++, net += 3) {
            const double w = film->weights != NULL ? film->weights[i * nv + j] : 1;
            for (size_t c = 0; c < 3; c++) {
                net[c] = w * row[c * film->stride + j];
            }
        }
    }
}

static void contract(const taut_film *film, int line)
{
    const size_t at = (size_t)line * (size_t)film->u.local;
    film->ops->contract(film->u.local, film->u.value + at, film->u.slope + at,
                        film->net + (size_t)film->u.first[line] * film->width, film->width,
                        film->polygons, film->polygons + film->width);
}

static void spread(const taut_film *film, int line)
{
    const size_t at = (size_t)line * (size_t)film->u.local;
    film->ops->spread(film->u.local, film->u.value + at, film->u.slope + at, film->spread,
                      film->spread + film->width, film->width,
                      film_sums(film) + (size_t)film->u.first[line] * film->width);
}

static size_t panels_of(const taut_film_axis *a)
{
    return (size_t)(a->count / a->nodes);
}

/* Where numbers of panel `panel` on the line begin, `each` of them a point. */
static size_t place_of(const taut_film *film, int line, size_t panel, size_t each)
{
    return ((size_t)line * panels_of(&film->v) + panel) * each * (size_t)film->v.group;
}

/* What kernels see of a panel. */
static taut_film_panel view(const taut_film *film, int line, size_t panel)
{
    const taut_film_axis *v = &film->v;
    const size_t nodes = (size_t)v->nodes, first = (size_t)v->first[panel * nodes];
    const size_t table = panel * (size_t)v->local * (size_t)v->group;
    return (taut_film_panel){
        .nodes = v->nodes,
        .group = v->group,
        .local = v->local,
        .wide = v->wide,
        .stride = film->stride,
        .value = v->values + table,
        .slope = v->slopes + table,
        .values = v->by_node + panel * nodes * (size_t)v->wide,
        .slopes = v->sloped + panel * nodes * (size_t)v->wide,
        .still = film->polygons + first,
        .along = film->polygons + film->width + first,
        .quotient = film->quotient != NULL ? film->quotient + place_of(film, line, panel, 3) : NULL,
        .spread_still = film->spread + first,
        .spread_u = film->spread + film->width + first,
    };
}

void taut_film_state_at(const taut_film *film, int line, int k, double state[TAUT_FILM_STATE])
{
    const size_t panel = (size_t)(k / film->v.nodes), g = (size_t)(k % film->v.nodes);
    const double *s = film->state + place_of(film, line, panel, TAUT_FILM_STATE) + g;
    for (size_t i = 0; i < TAUT_FILM_STATE; i++) {
        state[i] = s[i * (size_t)film->v.group];
    }
}

void taut_film_quotient_at(const taut_film *film, int line, int k, double quotient[3])
{
    const size_t panel = (size_t)(k / film->v.nodes), g = (size_t)(k % film->v.nodes);
    const double *q = film->quotient + place_of(film, line, panel, 3) + g;
    for (size_t i = 0; i < 3; i++) {
        quotient[i] = q[i * (size_t)film->v.group];
    }
}

/* 1 / w, w_u / w, w_v / w of one point, w from the first plane of the polygons. */
static void quotient_of(const taut_film *film, int k, double q[3])
{
    const size_t local = (size_t)film->v.local;
    const double *n = film->v.value + (size_t)k * local, *d = film->v.slope + (size_t)k * local;
    const double *still = film->polygons + film->v.first[k], *along = still + film->width;
    double w = 0, wu = 0, wv = 0;

    for (size_t b = 0; b < local; b++) {
        w += n[b] * still[b];
        wu += n[b] * along[b];
        wv += d[b] * still[b];
    }
    q[0] = 1 / w;
    q[1] = wu / w;
    q[2] = wv / w;
}

/* All quotients, by the contraction of a net with w_ij in the first coordinate; 0 where there is no
 * point. */
static void fill_quotients(taut_film *film)
{
    const size_t group = (size_t)film->v.group;

    for (int i = 0; i < film->nu; i++) {
        memcpy(film->net + (size_t)i * film->width, film->weights + (size_t)i * (size_t)film->nv,
               (size_t)film->nv * sizeof(double));
    }
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line);
        for (int k = 0; k < film->v.count; k++) {
            const size_t panel = (size_t)(k / film->v.nodes), g = (size_t)(k % film->v.nodes);
            double *to = film->quotient + place_of(film, line, panel, 3) + g, q[3];
            quotient_of(film, k, q);
            for (size_t c = 0; c < 3; c++) {
                to[c * group] = q[c];
            }
        }
    }
}

static taut_status take_weights(const double *weights, taut_film *film)
{
    const size_t count = (size_t)film->nu * (size_t)film->nv;
    const size_t lines = (size_t)film->u.count * panels_of(&film->v);
    double largest = 0;

    film->weights = taut_alloc(count, sizeof(double));
    film->quotient = taut_alloc_zero(lines * (size_t)film->v.group, 3 * sizeof(double));
    if (film->weights == NULL || film->quotient == NULL) {
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
        taut_free(film->elements);
        taut_free(film);
    }
}

/* Planes carry TAUT_FILM_PAD numbers more than the net, which stay 0 or are never looked at. */
static taut_status alloc(taut_film *film)
{
    const size_t nu = (size_t)film->nu, group = (size_t)film->v.group;
    const size_t lines = (size_t)film->u.count * panels_of(&film->v);

    film->stride = (size_t)rounded_up(film->nv, TAUT_FILM_PAD) + TAUT_FILM_PAD;
    film->width = 3 * film->stride;
    film->state = taut_alloc_aligned(lines * group, TAUT_FILM_STATE * sizeof(double));
    film->net = taut_alloc_zero(2 * nu * film->width, sizeof(double));
    film->polygons = taut_alloc_aligned(2 * film->width, sizeof(double));
    film->spread = taut_alloc_aligned(2 * film->width, sizeof(double));
    film->elements = taut_alloc_aligned(2 * group, sizeof(double));
    return film->state != NULL && film->net != NULL && film->polygons != NULL &&
                   film->spread != NULL && film->elements != NULL
               ? TAUT_OK
               : TAUT_NO_MEMORY;
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
    made->ops = taut_film_ops_chosen();
    status = axis_new(u, nv, weights, (size_t)nv, 1, extra, &made->u);
    if (status == TAUT_OK) {
        status = axis_new(v, nu, weights, 1, (size_t)nv, extra, &made->v);
    }
    if (status == TAUT_OK) {
        status = axis_arrange(made->ops->lanes, &made->v);
    }
    if (status == TAUT_OK) {
        status = alloc(made);
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

/* Adds the panel's W, in film->elements, and lowers the least. */
static void add_elements(const taut_film *film, int line, size_t panel, taut_sum *sum,
                         taut_film_value *value)
{
    const double *weights = film->v.weights + panel * (size_t)film->v.nodes;
    const double along_u = film->u.weights[line];
    for (int g = 0; g < film->v.nodes; g++) {
        const double w = film->elements[g];
        value->least = w < value->least ? w : value->least;
        taut_sum_add(sum, along_u * weights[g] * w);
    }
}

static taut_film_value total(const taut_sum *sum, taut_film_value value)
{
    value.area = taut_sum_total(sum);
    value.least = value.area > 0 ? value.least / value.area : 0;
    return value;
}

taut_film_value taut_film_area(taut_film *film, const double *net)
{
    taut_film_value value = {0, INFINITY};
    taut_sum sum = {0, 0};

    film->work += taut_film_cost(film);
    take_net(film, net);
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line);
        for (size_t panel = 0; panel < panels_of(&film->v); panel++) {
            const taut_film_panel p = view(film, line, panel);
            film->ops->area(&p, film->elements);
            add_elements(film, line, panel, &sum, &value);
        }
    }
    return total(&sum, value);
}

taut_film_value taut_film_gradient(taut_film *film, const double *net, double *gradient)
{
    const size_t group = (size_t)film->v.group;
    double *const weights = film->elements + group;
    taut_film_value value = {0, INFINITY};
    taut_sum sum = {0, 0};

    film->work += 2 * taut_film_cost(film);
    take_net(film, net);
    memset(film_sums(film), 0, (size_t)film->nu * film->width * sizeof(double));
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line);
        memset(film->spread, 0, 2 * film->width * sizeof(double));
        for (size_t panel = 0; panel < panels_of(&film->v); panel++) {
            const taut_film_panel p = view(film, line, panel);
            for (size_t g = 0; g < group; g++) {
                weights[g] = film->u.weights[line] * film->v.group_weights[panel * group + g];
            }
            film->ops->gradient(&p, weights,
                                film->state + place_of(film, line, panel, TAUT_FILM_STATE),
                                film->elements);
            add_elements(film, line, panel, &sum, &value);
        }
        spread(film, line);
    }
    give_sums(film, gradient);
    return total(&sum, value);
}

void taut_film_product(taut_film *film, double theta, const double *direction, double *product)
{
    film->work += 2 * taut_film_cost(film);
    take_net(film, direction);
    memset(film_sums(film), 0, (size_t)film->nu * film->width * sizeof(double));
    for (int line = 0; line < film->u.count; line++) {
        contract(film, line);
        memset(film->spread, 0, 2 * film->width * sizeof(double));
        for (size_t panel = 0; panel < panels_of(&film->v); panel++) {
            const taut_film_panel p = view(film, line, panel);
            film->ops->product(&p, theta,
                               film->state + place_of(film, line, panel, TAUT_FILM_STATE));
        }
        spread(film, line);
    }
    give_sums(film, product);
}
