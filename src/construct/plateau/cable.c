#include "construct/plateau/cable.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <math.h>
#include <string.h>

static taut_status fill_node(const taut_basis *basis, int span, double t, taut_area_cable *cable,
                             int node)
{
    double values[2 * (TAUT_DEGREE_MAX + 1)];
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);
    const taut_status status = taut_basis_eval(basis, span, t, 1, values);

    cable->alive[node] = taut_basis_first(basis, span);
    for (int a = 0; status == TAUT_OK && a < cable->local; a++) {
        cable->slope[node * cable->local + a] = values[cable->local + a] * length;
    }
    return status;
}

taut_status taut_area_cable_new(const taut_basis *basis, int extra, size_t first, size_t step,
                                taut_arena *arena, taut_area_cable *cable)
{
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];
    const double *breaks = taut_basis_breaks(basis);
    const double length = taut_basis_hi(basis) - taut_basis_lo(basis);
    const int spans = taut_basis_span_count(basis), wanted = taut_basis_local(basis) + extra;
    const int each = wanted < TAUT_GAUSS_MAX ? wanted : TAUT_GAUSS_MAX;
    taut_status status = TAUT_OK;

    *cable = (taut_area_cable){.first = first, .step = step, .nodes = spans * each};
    cable->local = taut_basis_local(basis);
    cable->count = taut_basis_count(basis);
    const size_t nodes = (size_t)cable->nodes, local = (size_t)cable->local;
    cable->alive = taut_arena_take(arena, nodes, sizeof(int));
    cable->slope = taut_arena_take(arena, nodes * local, sizeof(double));
    cable->weight = taut_arena_take(arena, nodes, sizeof(double));
    cable->state = taut_arena_take(arena, nodes, TAUT_AREA_CABLE_STATE * sizeof(double));
    cable->pull = taut_arena_take(arena, (size_t)cable->count, 3 * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(each, node, weight);
    for (int k = 0; status == TAUT_OK && k < cable->nodes; k++) {
        const int span = k / each;
        const double half = 0.5 * (breaks[span + 1] - breaks[span]);
        status = fill_node(basis, span, breaks[span] + half * (1 + node[k % each]), cable, k);
        cable->weight[k] = weight[k % each] * (half / length);
    }
    return status;
}

void taut_area_cable_open(const taut_loop *around, taut_area_cable *cable)
{
    for (int k = 0; k < cable->nodes; k++) {
        taut_loop_open(around, cable->alive[k], cable->slope + (size_t)k * (size_t)cable->local);
    }
}

/* x_t of a net at a node. */
static void find_slope(const taut_area_cable *cable, const double *net, int node, double d[3])
{
    const double *slope = cable->slope + (size_t)node * (size_t)cable->local;
    const double *x = net + 3 * (cable->first + (size_t)cable->alive[node] * cable->step);

    memset(d, 0, 3 * sizeof(double));
    for (int a = 0; a < cable->local; a++, x += 3 * cable->step) {
        taut_add_scaled(slope[a], x, d);
    }
}

/* net += the functions' slopes times f. */
static void spread_slope(const taut_area_cable *cable, const double f[3], int node, double *net)
{
    const double *slope = cable->slope + (size_t)node * (size_t)cable->local;
    double *x = net + 3 * (cable->first + (size_t)cable->alive[node] * cable->step);

    for (int a = 0; a < cable->local; a++, x += 3 * cable->step) {
        taut_add_scaled(slope[a], f, x);
    }
}

/* p at a length. */
static double find_force(const taut_area_cable *cable, double length)
{
    return fmax(0, cable->base + cable->stiffness * (length - cable->target));
}

double taut_area_cable_energy(const taut_area_cable *cable, double length)
{
    if (cable->stiffness == 0) {
        return cable->tension * length;
    }
    const double p = find_force(cable, length);
    return 0.5 * p * p / cable->stiffness;
}

double taut_area_cable_length(const taut_area_cable *cable, const double *net)
{
    taut_sum sum = {0, 0};
    for (int k = 0; k < cable->nodes; k++) {
        double d[3];
        find_slope(cable, net, k, d);
        taut_sum_add(&sum, cable->weight[k] * taut_length(d));
    }
    return taut_sum_total(&sum);
}

/* What a node adds to dL. */
static void add_pull(const taut_area_cable *cable, int node)
{
    const double *slope = cable->slope + (size_t)node * (size_t)cable->local;
    const double *t = cable->state + (size_t)node * TAUT_AREA_CABLE_STATE;
    double *x = cable->pull + 3 * cable->alive[node];

    for (int a = 0; a < cable->local; a++, x += 3) {
        taut_add_scaled(cable->weight[node] * slope[a], t, x);
    }
}

void taut_area_cable_pull(taut_area_cable *cable)
{
    memset(cable->pull, 0, 3 * (size_t)cable->count * sizeof(double));
    for (int k = 0; k < cable->nodes; k++) {
        add_pull(cable, k);
    }
}

double taut_area_cable_gradient(taut_area_cable *cable, const double *net, double *gradient)
{
    taut_sum sum = {0, 0};
    if (cable->stiffness > 0) {
        cable->tension = find_force(cable, taut_area_cable_length(cable, net));
        memset(cable->pull, 0, 3 * (size_t)cable->count * sizeof(double));
    }
    for (int k = 0; k < cable->nodes; k++) {
        double *state = cable->state + (size_t)k * TAUT_AREA_CABLE_STATE;
        double d[3], f[3];
        find_slope(cable, net, k, d);
        const double speed = taut_length(d), inverse = speed > 0x1p-500 ? 1 / speed : 0;
        for (int c = 0; c < 3; c++) {
            state[c] = inverse * d[c];
            f[c] = cable->tension * cable->weight[k] * state[c];
        }
        state[3] = cable->weight[k] * inverse;
        taut_sum_add(&sum, cable->weight[k] * speed);
        spread_slope(cable, f, k, gradient);
        if (cable->stiffness > 0) {
            add_pull(cable, k);
        }
    }
    return taut_sum_total(&sum);
}

/* product += k dL (dL . direction). */
static void add_stiffness(const taut_area_cable *cable, const double *direction, double *product)
{
    double along = 0;
    for (int k = 0; k < cable->count; k++) {
        const size_t at = 3 * (cable->first + (size_t)k * cable->step);
        along += taut_dot(cable->pull + 3 * k, direction + at);
    }
    for (int k = 0; k < cable->count; k++) {
        const size_t at = 3 * (cable->first + (size_t)k * cable->step);
        taut_add_scaled(cable->stiffness * along, cable->pull + 3 * k, product + at);
    }
}

void taut_area_cable_product(const taut_area_cable *cable, double theta, const double *direction,
                             double *product)
{
    for (int k = 0; k < cable->nodes; k++) {
        const double *t = cable->state + (size_t)k * TAUT_AREA_CABLE_STATE;
        double d[3];
        find_slope(cable, direction, k, d);
        const double along = (1 - theta) * taut_dot(t, d), r = cable->tension * t[3];
        for (int c = 0; c < 3; c++) {
            d[c] = r * (d[c] - along * t[c]);
        }
        spread_slope(cable, d, k, product);
    }
    if (cable->stiffness > 0 && cable->tension > 0) {
        add_stiffness(cable, direction, product);
    }
}
