/* area.c -- one line u = const of Gauss points after another: the rows of the net alive there are
 * contracted with the functions of u once for the line, then with those of v cell by cell, all
 * points of a cell side by side (area_kernel.h); what comes back is gathered along v per column of
 * the net and spread over the rows once (sum factorisation). Nothing is allocated after
 * taut_area_functional_new. */
#include "construct/plateau/area.h"

#include "construct/plateau/density.h"
#include "core/arena.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/grid/table.h"
#include "geometry/nurbs/cells.h"
#include "numeric/kernel/kernel.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <string.h>

const taut_area_ops *taut_area_ops_chosen(void)
{
    return TAUT_KERNEL_OF(taut_area);
}

/* value, slope and first from the table of both. */
static void fill_axis(const taut_table *table, double length, taut_area_axis *a)
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

static taut_status tabulate_axis(const taut_basis *basis, const taut_cells *cells,
                                 taut_arena *arena, taut_area_axis *a)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);
    const size_t count = (size_t)a->count, local = (size_t)a->local;
    double *t = a->at = taut_arena_take(arena, count, sizeof(double));
    taut_table *table = NULL;
    taut_status status = TAUT_OK;

    a->first = taut_arena_take(arena, count, sizeof(int));
    a->weights = taut_arena_take(arena, count, sizeof(double));
    a->value = taut_arena_take(arena, count * local, sizeof(double));
    a->slope = taut_arena_take(arena, count * local, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(a->nodes, node, weight);
    for (int k = 0; k < a->count; k++) {
        const int cell = k / a->nodes, span = cells->span[cell];
        const double at = taut_cells_at(cells, cell, node[k % a->nodes]);
        const double width = cells->hi[cell] - cells->lo[cell];
        t[k] = at < breaks[span + 1] ? at : breaks[span]; /* the span of t must be this one */
        a->weights[k] = 0.5 * weight[k % a->nodes] * (width / length);
    }
    status = taut_table_new(basis, a->count, t, NULL, 1, &table);
    if (status != TAUT_OK) {
        return status;
    }
    fill_axis(table, length, a);
    taut_table_free(table);
    return TAUT_OK;
}

/* lines, step, next as in geometry/nurbs/cells.h. */
static taut_status make_axis(const taut_basis *basis, int lines, const double *weights, size_t step,
                             size_t next, int extra, taut_arena *arena, taut_area_axis *a)
{
    const int wanted = taut_basis_local(basis) + extra;
    taut_cells *cells = NULL;
    taut_status status = taut_cells_new(basis, lines, weights, step, next, &cells);

    if (status != TAUT_OK) {
        return status;
    }
    a->local = taut_basis_local(basis);
    a->nodes = wanted < TAUT_GAUSS_MAX ? wanted : TAUT_GAUSS_MAX;
    a->count = cells->count * a->nodes;
    status = tabulate_axis(basis, cells, arena, a);
    taut_cells_free(cells);
    return status;
}

static int rounded_up(int count, int lanes)
{
    return (count + lanes - 1) / lanes * lanes;
}

/* The tables for kernels. */
static taut_status arrange_axis(int lanes, taut_arena *arena, taut_area_axis *a)
{
    const size_t local = (size_t)a->local, nodes = (size_t)a->nodes;
    const size_t cells = (size_t)a->count / nodes;
    const size_t group = (size_t)rounded_up(a->nodes, lanes);
    const size_t wide = (size_t)rounded_up(a->local, lanes);

    a->group = (int)group;
    a->wide = (int)wide;
    a->values = taut_arena_take(arena, cells * local, group * sizeof(double));
    a->slopes = taut_arena_take(arena, cells * local, group * sizeof(double));
    a->by_node = taut_arena_take(arena, cells * nodes, wide * sizeof(double));
    a->sloped = taut_arena_take(arena, cells * nodes, wide * sizeof(double));
    a->group_weights = taut_arena_take(arena, cells, group * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < cells * nodes; k++) {
        const size_t cell = k / nodes, g = k % nodes;
        a->group_weights[cell * group + g] = a->weights[k];
        for (size_t b = 0; b < local; b++) {
            a->values[(cell * local + b) * group + g] = a->value[k * local + b];
            a->slopes[(cell * local + b) * group + g] = a->slope[k * local + b];
            a->by_node[k * wide + b] = a->value[k * local + b];
            a->sloped[k * wide + b] = a->slope[k * local + b];
        }
    }
    return TAUT_OK;
}

/* functional->net = the net in planes, times the weights. */
static void load_net(taut_area_functional *functional, const double *net)
{
    const size_t nv = (size_t)functional->nv;

    for (size_t i = 0; i < (size_t)functional->nu; i++) {
        double *row = functional->net + i * functional->width;
        for (size_t j = 0; j < nv; j++, net += 3) {
            const double w = functional->weights != NULL ? functional->weights[i * nv + j] : 1;
            for (size_t c = 0; c < 3; c++) {
                row[c * functional->stride + j] = w * net[c];
            }
        }
    }
}

static double *net_sums(const taut_area_functional *functional)
{
    return functional->net + (size_t)functional->nu * functional->width;
}

static void store_sums(const taut_area_functional *functional, double *net)
{
    const size_t nv = (size_t)functional->nv;

    for (size_t i = 0; i < (size_t)functional->nu; i++) {
        const double *row = net_sums(functional) + i * functional->width;
        for (size_t j = 0; j < nv; j++, net += 3) {
            const double w = functional->weights != NULL ? functional->weights[i * nv + j] : 1;
            for (size_t c = 0; c < 3; c++) {
                net[c] = w * row[c * functional->stride + j];
            }
        }
    }
}

static void contract_line(const taut_area_functional *functional, int line)
{
    const size_t at = (size_t)line * (size_t)functional->u.local;
    functional->ops->contract(
        functional->u.local, functional->u.value + at, functional->u.slope + at,
        functional->net + (size_t)functional->u.first[line] * functional->width, functional->width,
        functional->polygons, functional->polygons + functional->width);
}

static void spread_line(const taut_area_functional *functional, int line)
{
    const size_t at = (size_t)line * (size_t)functional->u.local;
    functional->ops->spread(
        functional->u.local, functional->u.value + at, functional->u.slope + at, functional->spread,
        functional->spread + functional->width, functional->width,
        net_sums(functional) + (size_t)functional->u.first[line] * functional->width);
}

static size_t cells_of(const taut_area_axis *a)
{
    return (size_t)(a->count / a->nodes);
}

/* Where numbers of cell `cell` on the line begin, `each` of them a point. */
static size_t cell_offset(const taut_area_functional *functional, int line, size_t cell,
                          size_t each)
{
    return ((size_t)line * cells_of(&functional->v) + cell) * each * (size_t)functional->v.group;
}

/* What kernels see of a cell. */
static taut_area_cell cell_view(const taut_area_functional *functional, int line, size_t cell)
{
    const taut_area_axis *v = &functional->v;
    const size_t nodes = (size_t)v->nodes, first = (size_t)v->first[cell * nodes];
    const size_t table = cell * (size_t)v->local * (size_t)v->group;
    return (taut_area_cell){
        .nodes = v->nodes,
        .group = v->group,
        .local = v->local,
        .wide = v->wide,
        .stride = functional->stride,
        .value = v->values + table,
        .slope = v->slopes + table,
        .values = v->by_node + cell * nodes * (size_t)v->wide,
        .slopes = v->sloped + cell * nodes * (size_t)v->wide,
        .still = functional->polygons + first,
        .along = functional->polygons + functional->width + first,
        .quotient = functional->quotient != NULL
                        ? functional->quotient + cell_offset(functional, line, cell, 3)
                        : NULL,
        .spread_still = functional->spread + first,
        .spread_u = functional->spread + functional->width + first,
    };
}

/* Where number 0 of the state lies; the others follow by v.group. */
static double *place_of(const taut_area_functional *functional, int line, int k)
{
    const size_t cell = (size_t)(k / functional->v.nodes), g = (size_t)(k % functional->v.nodes);
    return functional->state + cell_offset(functional, line, cell, TAUT_AREA_STATE) + g;
}

void taut_area_functional_state(const taut_area_functional *functional, int line, int k,
                                double state[TAUT_AREA_STATE])
{
    const double *s = place_of(functional, line, k);
    for (size_t i = 0; i < TAUT_AREA_STATE; i++) {
        state[i] = s[i * (size_t)functional->v.group];
    }
}

void taut_area_functional_quotient(const taut_area_functional *functional, int line, int k,
                                   double quotient[3])
{
    const size_t cell = (size_t)(k / functional->v.nodes), g = (size_t)(k % functional->v.nodes);
    const double *q = functional->quotient + cell_offset(functional, line, cell, 3) + g;
    for (size_t i = 0; i < 3; i++) {
        quotient[i] = q[i * (size_t)functional->v.group];
    }
}

/* 1 / w, w_u / w, w_v / w of one point, w from the first plane of the polygons. */
static void find_quotient(const taut_area_functional *functional, int k, double q[3])
{
    const size_t local = (size_t)functional->v.local;
    const double *n = functional->v.value + (size_t)k * local,
                 *d = functional->v.slope + (size_t)k * local;
    const double *still = functional->polygons + functional->v.first[k],
                 *along = still + functional->width;
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
static void fill_quotients(taut_area_functional *functional)
{
    const size_t group = (size_t)functional->v.group;

    for (int i = 0; i < functional->nu; i++) {
        memcpy(functional->net + (size_t)i * functional->width,
               functional->weights + (size_t)i * (size_t)functional->nv,
               (size_t)functional->nv * sizeof(double));
    }
    for (int line = 0; line < functional->u.count; line++) {
        contract_line(functional, line);
        for (int k = 0; k < functional->v.count; k++) {
            const size_t cell = (size_t)(k / functional->v.nodes),
                         g = (size_t)(k % functional->v.nodes);
            double *to = functional->quotient + cell_offset(functional, line, cell, 3) + g, q[3];
            find_quotient(functional, k, q);
            for (size_t c = 0; c < 3; c++) {
                to[c * group] = q[c];
            }
        }
    }
}

static taut_status take_weights(const double *weights, taut_area_functional *functional)
{
    const size_t count = (size_t)functional->nu * (size_t)functional->nv;
    const size_t lines = (size_t)functional->u.count * cells_of(&functional->v);
    const size_t group = (size_t)functional->v.group;
    double largest = 0;

    if (weights == NULL) {
        return TAUT_OK;
    }
    functional->weights = taut_arena_take(functional->arena, count, sizeof(double));
    functional->quotient = taut_arena_take(functional->arena, lines * group, 3 * sizeof(double));
    if (taut_arena_status(functional->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        largest = weights[i] > largest ? weights[i] : largest;
    }
    for (size_t i = 0; i < count; i++) {
        functional->weights[i] = weights[i] / largest;
    }
    fill_quotients(functional);
    return TAUT_OK;
}

void taut_area_functional_free(taut_area_functional *functional)
{
    if (functional != NULL) {
        taut_arena_free(functional->arena);
        taut_free(functional);
    }
}

/* Planes carry TAUT_AREA_PAD numbers more than the net, which stay 0 or are never looked at. */
static taut_status take_arrays(taut_area_functional *functional)
{
    taut_arena *arena = functional->arena;
    const size_t nu = (size_t)functional->nu, group = (size_t)functional->v.group;
    const size_t lines = (size_t)functional->u.count * cells_of(&functional->v);

    functional->stride = (size_t)rounded_up(functional->nv, TAUT_AREA_PAD) + TAUT_AREA_PAD;
    functional->width = 3 * functional->stride;
    /* not zeroed: gigabytes, which a rule that turns out too fine never touches */
    functional->state = taut_arena_take_raw(arena, lines * group, TAUT_AREA_STATE * sizeof(double));
    functional->net = taut_arena_take(arena, 2 * nu * functional->width, sizeof(double));
    functional->polygons = taut_arena_take(arena, 2 * functional->width, sizeof(double));
    functional->spread = taut_arena_take(arena, 2 * functional->width, sizeof(double));
    functional->elements = taut_arena_take(arena, 2 * group, sizeof(double));
    return taut_arena_status(arena);
}

/* The tables of an axis become those of the functions that go around. */
static void open_axis(const taut_loop *around, taut_area_axis *a)
{
    for (int k = 0; around != NULL && k < a->count; k++) {
        taut_loop_open(around, a->first[k], a->value + (size_t)k * (size_t)a->local);
        taut_loop_open(around, a->first[k], a->slope + (size_t)k * (size_t)a->local);
    }
}

/* What a functional is made from. */
typedef struct request {
    const taut_basis *u, *v;
    const double *weights;
    const taut_loop *around_u, *around_v;
    int extra;
} request;

static taut_status make_parts(const request *r, taut_area_functional *functional)
{
    taut_arena *arena = functional->arena;
    const double *weights = r->weights;
    const int nu = functional->nu, nv = functional->nv;
    taut_status status =
        make_axis(r->u, nv, weights, (size_t)nv, 1, r->extra, arena, &functional->u);

    if (status != TAUT_OK) {
        return status;
    }
    status = make_axis(r->v, nu, weights, 1, (size_t)nv, r->extra, arena, &functional->v);
    if (status != TAUT_OK) {
        return status;
    }
    open_axis(r->around_u, &functional->u);
    open_axis(r->around_v, &functional->v);
    status = arrange_axis(functional->ops->lanes, arena, &functional->v);
    if (status != TAUT_OK) {
        return status;
    }
    status = take_arrays(functional);
    return status == TAUT_OK ? take_weights(weights, functional) : status;
}

static taut_status functional_new(const request *r, taut_area_functional **functional)
{
    taut_area_functional *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = TAUT_OK;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->arena = taut_arena_new();
    made->nu = taut_basis_count(r->u);
    made->nv = taut_basis_count(r->v);
    made->ops = taut_area_ops_chosen();
    status = make_parts(r, made);
    if (status != TAUT_OK) {
        taut_area_functional_free(made);
        return status;
    }
    *functional = made;
    return TAUT_OK;
}

taut_status taut_area_functional_new(const taut_basis *u, const taut_basis *v,
                                     const double *weights, int extra,
                                     taut_area_functional **functional)
{
    const request r = {.u = u, .v = v, .weights = weights, .extra = extra};
    return functional_new(&r, functional);
}

taut_status taut_area_functional_around(const taut_basis *u, const taut_basis *v,
                                        const taut_loop *around_u, const taut_loop *around_v,
                                        int extra, taut_area_functional **functional)
{
    const request r = {.u = u, .v = v, .around_u = around_u, .around_v = around_v, .extra = extra};
    return functional_new(&r, functional);
}

/* At each point 6 numbers from the functions alive along v, and what is made of them. */
double taut_area_functional_cost(const taut_area_functional *functional)
{
    return 12.0 * (functional->v.local + 4) * functional->u.count * functional->v.count;
}

/* Tells of one line of Gauss points, each so many times the work of the area, some of which are done at once; what is begun is
 * finished even so, as the value of a net that is half looked at has no meaning. */
static void tell_line(const taut_area_functional *functional, double times)
{
    enum { AT_ONCE = 4 };
    const double line = taut_area_functional_cost(functional) / functional->u.count;

    (void)taut_pulse_beat(functional->pulse, times * line / AT_ONCE);
}

/* Adds the cell's W, in functional->elements, and lowers the least. */
static void add_elements(const taut_area_functional *functional, int line, size_t cell,
                         taut_sum *sum, taut_area_value *value)
{
    const double *weights = functional->v.weights + cell * (size_t)functional->v.nodes;
    const double along_u = functional->u.weights[line];
    for (int g = 0; g < functional->v.nodes; g++) {
        const double w = functional->elements[g];
        value->least = w < value->least ? w : value->least;
        taut_sum_add(sum, along_u * weights[g] * w);
    }
}

static taut_area_value sum_up(const taut_sum *sum, taut_area_value value)
{
    value.area = taut_sum_total(sum);
    value.least = value.area > 0 ? value.least / value.area : 0;
    return value;
}

static taut_area_value area_value(taut_area_functional *functional, const double *net)
{
    taut_area_value value = {0, INFINITY};
    taut_sum sum = {0, 0};

    functional->work += taut_area_functional_cost(functional);
    load_net(functional, net);
    for (int line = 0; line < functional->u.count; line++) {
        contract_line(functional, line);
        for (size_t cell = 0; cell < cells_of(&functional->v); cell++) {
            const taut_area_cell p = cell_view(functional, line, cell);
            functional->ops->area(&p, functional->elements);
            add_elements(functional, line, cell, &sum, &value);
        }
        tell_line(functional, 1);
    }
    return sum_up(&sum, value);
}

static taut_area_value area_gradient(taut_area_functional *functional, const double *net,
                                     double *gradient)
{
    const size_t group = (size_t)functional->v.group;
    double *const weights = functional->elements + group;
    taut_area_value value = {0, INFINITY};
    taut_sum sum = {0, 0};

    functional->work += 2 * taut_area_functional_cost(functional);
    load_net(functional, net);
    memset(net_sums(functional), 0, (size_t)functional->nu * functional->width * sizeof(double));
    for (int line = 0; line < functional->u.count; line++) {
        contract_line(functional, line);
        memset(functional->spread, 0, 2 * functional->width * sizeof(double));
        for (size_t cell = 0; cell < cells_of(&functional->v); cell++) {
            const taut_area_cell p = cell_view(functional, line, cell);
            for (size_t g = 0; g < group; g++) {
                weights[g] =
                    functional->u.weights[line] * functional->v.group_weights[cell * group + g];
            }
            functional->ops->gradient(&p, weights,
                                      functional->state +
                                          cell_offset(functional, line, cell, TAUT_AREA_STATE),
                                      functional->elements);
            add_elements(functional, line, cell, &sum, &value);
        }
        spread_line(functional, line);
        tell_line(functional, 2);
    }
    store_sums(functional, gradient);
    return sum_up(&sum, value);
}

static void area_product(taut_area_functional *functional, double theta, const double *direction,
                         double *product)
{
    functional->work += 2 * taut_area_functional_cost(functional);
    load_net(functional, direction);
    memset(net_sums(functional), 0, (size_t)functional->nu * functional->width * sizeof(double));
    for (int line = 0; line < functional->u.count; line++) {
        contract_line(functional, line);
        memset(functional->spread, 0, 2 * functional->width * sizeof(double));
        for (size_t cell = 0; cell < cells_of(&functional->v); cell++) {
            const taut_area_cell p = cell_view(functional, line, cell);
            functional->ops->product(&p, theta,
                                     functional->state +
                                         cell_offset(functional, line, cell, TAUT_AREA_STATE));
        }
        spread_line(functional, line);
        tell_line(functional, 2);
    }
    store_sums(functional, product);
}

/* Puts a and b where the operators take their state from, as they have to be after each gradient of the area. */
static void load_density(taut_area_functional *functional)
{
    const taut_area_density *density = functional->density;
    const size_t group = (size_t)functional->v.group;

    for (int line = 0; line < functional->u.count; line++) {
        for (int k = 0; k < functional->v.count; k++) {
            const size_t at = (size_t)line * (size_t)functional->v.count + (size_t)k;
            const double weight = functional->u.weights[line] * functional->v.weights[k];
            double *state = place_of(functional, line, k);
            state[3 * group] = weight * density->along_v[at];
            state[4 * group] = 0;
            state[5 * group] = weight * density->along_u[at];
        }
    }
}

/* The energy of a density, image = K net; the state is that of the net's normals. */
static taut_area_value density_gradient(taut_area_functional *functional, const double *net,
                                        double *image)
{
    const size_t count = 3 * (size_t)functional->nu * (size_t)functional->nv;
    taut_sum sum = {0, 0};

    (void)area_gradient(functional, net, image);
    load_density(functional);
    area_product(functional, 1, net, image);
    for (size_t i = 0; i < count; i++) {
        taut_sum_add(&sum, 0.5 * net[i] * image[i]);
    }
    return (taut_area_value){.area = taut_sum_total(&sum), .least = 1};
}

taut_area_value taut_area_functional_value(taut_area_functional *functional, const double *net)
{
    taut_area_value value = functional->density != NULL
                                ? density_gradient(functional, net, functional->density->image)
                                : area_value(functional, net);

    for (int k = 0; k < functional->cable_count; k++) {
        const taut_area_cable *cable = functional->cables + k;
        value.area += taut_area_cable_energy(cable, taut_area_cable_length(cable, net));
    }
    return value;
}

taut_area_value taut_area_functional_gradient(taut_area_functional *functional, const double *net,
                                              double *gradient)
{
    taut_area_value value = functional->density != NULL
                                ? density_gradient(functional, net, gradient)
                                : area_gradient(functional, net, gradient);

    for (int k = 0; k < functional->cable_count; k++) {
        taut_area_cable *cable = functional->cables + k;
        const double length = taut_area_cable_gradient(cable, net, gradient);
        value.area += taut_area_cable_energy(cable, length);
    }
    return value;
}

void taut_area_functional_product(taut_area_functional *functional, double theta,
                                  const double *direction, double *product)
{
    area_product(functional, functional->density != NULL ? 1 : theta, direction, product);
    for (int k = 0; k < functional->cable_count; k++) {
        taut_area_cable_product(functional->cables + k, theta, direction, product);
    }
}
