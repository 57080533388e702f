#include "construct/film/complex/pressure.h"

#include "construct/film/edges.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "problem/film_cells.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double surplus = 1e-6; /* of the bound: what quadrature of lengths may be off by */

/* Is p the only pressure on patch q? */
static int is_alone(const taut_film_problem *problem, int cell, int q)
{
    for (int k = 0; k < problem->cell_count; k++) {
        if (k != cell && taut_film_cell_turn(&problem->cells[k], q) != 0) {
            return 0;
        }
    }
    return 1;
}

/* Do the sides of the cell end in held edges and poles alone, and touch no other sheet and no cable? */
static int is_held_round(const taut_film_complex *c, int cell)
{
    const taut_film_problem *problem = c->problem;

    for (int k = 0; k < 4 * problem->patch_count; k++) {
        const int p = k / 4, e = k % 4, s = taut_film_complex_seam(problem, p, e);
        const taut_film_edge *edge = &problem->patches[p].edges[e];
        if (taut_film_cell_turn(&problem->cells[cell], p) == 0) {
            continue;
        }
        if (!is_alone(problem, cell, p) || taut_film_has_density(&problem->patches[p]) ||
            (s < 0 && edge->kind != TAUT_FILM_FIXED && edge->kind != TAUT_FILM_POLE) ||
            (s >= 0 && problem->seams[s].edge.kind == TAUT_FILM_CABLE)) {
            return 0;
        }
        for (int i = 0; s >= 0 && i < problem->seams[s].count; i++) {
            if (taut_film_cell_turn(&problem->cells[cell], problem->seams[s].sides[i].patch) == 0) {
                return 0;
            }
        }
        if (s >= 0 && taut_film_cell_rim(c, &problem->cells[cell], p, e) != 0) {
            return 0;
        }
    }
    return 1;
}

/* What an edge adds to a, in user's units, and its length. */
static taut_status add_edge(const taut_film_layout *l, const taut_film_side *side, double sign,
                            double a[3], double *length)
{
    const taut_film_complex *c = &l->complex;
    const taut_film_problem *patch = &c->problem->patches[side->patch];
    const taut_basis *basis = side->edge < 2 ? patch->v : patch->u;
    const int local = taut_basis_local(basis), each = local + 4;
    const double *breaks = taut_basis_breaks(basis);
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX], values[2 * (TAUT_DEGREE_MAX + 1)];

    taut_gauss_rule(each, node, weight);
    for (int k = 0; k < taut_basis_span_count(basis) * each; k++) {
        const int span = k / each;
        const double lo = breaks[span], half = (breaks[span + 1] - lo) / 2;
        double x[3] = {0, 0, 0}, d[3] = {0, 0, 0}, cross[3];
        const taut_status status =
            taut_basis_eval(basis, span, lo + half * (1 + node[k % each]), 1, values);
        if (status != TAUT_OK) {
            return status;
        }
        for (int i = 0; i < local; i++) {
            const double *at =
                l->start + 3 * taut_film_complex_node(c, side, taut_basis_first(basis, span) + i);
            taut_add_scaled(values[i], at, x);
            taut_add_scaled(values[local + i], at, d);
        }
        taut_cross(x, d, cross);
        taut_add_scaled(sign * half * weight[k % each] / 2, cross, a);
        *length += half * weight[k % each] * taut_norm(d);
    }
    return TAUT_OK;
}

static taut_status check_cell(const taut_film_layout *l, int cell, taut_error *error)
{
    const taut_film_complex *c = &l->complex;
    const taut_film_problem *problem = c->problem;
    double a[3] = {0, 0, 0}, pull = 0;

    for (int k = 0; k < 4 * problem->patch_count; k++) {
        const taut_film_side side = {k / 4, k % 4, 0};
        const int turn = taut_film_cell_turn(&problem->cells[cell], side.patch);
        if (turn != 0 && problem->patches[side.patch].edges[side.edge].kind == TAUT_FILM_FIXED &&
            taut_film_complex_seam(problem, side.patch, side.edge) < 0) {
            double length = 0;
            const taut_status status =
                add_edge(l, &side, turn * taut_film_edge_turn(side.edge), a, &length);
            if (status != TAUT_OK) {
                return taut_fail_memory(error);
            }
            pull += l->tensions[side.patch] / l->tensions[0] * length;
        }
    }
    const double area = taut_norm(a), pressure = fabs(l->pressures[cell]);
    if (!(pressure * area > pull * (1 + surplus))) {
        return TAUT_OK;
    }
    char where[48], name[TAUT_FILM_NAME];
    const double most = fabs(problem->cells[cell].pressure) * (pull / area / pressure);
    snprintf(where, sizeof where, "/cells/%d/pressure", cell);
    taut_film_cell_name(problem, cell, name);
    return taut_fail(error, TAUT_NO_SOLUTION, "pressure-too-high", where,
                     problem->cells[cell].pressure, most,
                     "cell %s: no film between these edges holds a pressure above %.6g, which the "
                     "tension along them balances (proved); found %.6g; lower it, or give a volume",
                     name, most, problem->cells[cell].pressure);
}

taut_status taut_film_pressure_check(const taut_film_layout *layout, taut_error *error)
{
    const taut_film_problem *problem = layout->complex.problem;
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < problem->cell_count; k++) {
        if (!problem->cells[k].has_volume && is_held_round(&layout->complex, k)) {
            status = check_cell(layout, k, error);
        }
    }
    return status;
}
