#include "construct/film/complex/ways.h"

#include "construct/film/complex/volume.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

/* Unit vectors that the holds leave, into ways[count ..]; how many then. */
static int complete(taut_film_hold *hold, double *ways)
{
    int count = 0;

    for (int k = 0; hold->count < 3 && k < 6; k++) { /* axes that are far from what holds first */
        const double axis[3] = {k % 3 == 0, k % 3 == 1, k % 3 == 2};
        const int before = hold->count;
        double left = 1;
        for (int n = 0; n < before; n++) {
            const double along = taut_dot(axis, hold->normals[n]);
            left -= along * along;
        }
        if (left > (k < 3 ? 0.3 : 1e-6)) {
            (void)taut_film_hold_add(hold, axis, 0, INFINITY);
        }
        if (hold->count > before) {
            memcpy(ways + 3 * count++, hold->normals[before], 3 * sizeof(double));
        }
    }
    return count;
}

int taut_film_ways_all(const taut_film_complex *complex, int node, double ways[9])
{
    taut_film_hold hold = complex->holds[node];
    return complex->kind[node] == TAUT_FILM_NODE_HELD ? 0 : complete(&hold, ways);
}

/* iint N_a x_u x x_v of a patch, added to the nodes. */
static void add_moments(const taut_film_energy *e, int p, double *local, double *moments)
{
    const taut_film_complex *c = &e->layout->complex;
    const taut_area_functional *area = e->areas[p];
    const taut_area_axis *u = &area->u, *v = &area->v;
    const double *place = e->places[p];
    const int count = c->first[p + 1] - c->first[p];

    taut_volume_places(area, e->net + 3 * c->first[p], e->rows, e->places[p]);
    memset(local, 0, 3 * (size_t)count * sizeof(double));
    for (int line = 0; line < u->count; line++) {
        for (int k = 0; k < v->count; k++, place += TAUT_VOLUME_PLACE) {
            double n[3];
            taut_cross(place + 3, place + 6, n);
            for (int i = 0; i < u->local; i++) {
                const double a = u->weights[line] * v->weights[k] * u->value[line * u->local + i];
                double *to = local + 3 * ((size_t)(u->first[line] + i) * (size_t)area->nv +
                                          (size_t)v->first[k]);
                for (int j = 0; j < v->local; j++) {
                    taut_add_scaled(a * v->value[k * v->local + j], n, to + 3 * j);
                }
            }
        }
    }
    for (int k = 0; k < count; k++) {
        double *to = moments + 3 * c->node[c->first[p] + k];
        taut_add_scaled(taut_dot(local + 3 * k, to) < 0 ? -1 : 1, local + 3 * k, to);
    }
}

/* x_t of the line of a node, where its point belongs. */
static void find_tangent(const taut_film_energy *e, int node, double t[3])
{
    const taut_film_complex *c = &e->layout->complex;
    const taut_film_side *side = &c->line[node];
    const taut_film_problem *patch = &c->problem->patches[side->patch];
    const taut_basis *basis = side->edge < 2 ? patch->v : patch->u;
    const int p = taut_basis_degree(basis), n = taut_basis_count(basis), k = c->at[node];
    double values[2 * (TAUT_DEGREE_MAX + 1)], at = 0;
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    for (int i = 1; i <= p; i++) {
        at += spec.knots != NULL ? spec.knots[k + i] / p
              : k + i > p        ? taut_basis_hi(basis) / p
                                 : taut_basis_lo(basis) / p;
    }
    at = k == 0 ? taut_basis_lo(basis) : k == n - 1 ? taut_basis_hi(basis) : at;
    const int span = taut_basis_span(basis, at), first = taut_basis_first(basis, span);
    memset(t, 0, 3 * sizeof(double));
    if (taut_basis_eval(basis, span, at, 1, values) != TAUT_OK) {
        return;
    }
    for (int i = 0; i < taut_basis_local(basis); i++) {
        const int point =
            c->first[side->patch] + taut_film_complex_point(patch, side->edge, first + i);
        taut_add_scaled(values[taut_basis_local(basis) + i], e->net + 3 * point, t);
    }
}

static int find_ways(const taut_film_energy *e, int node, const double *moment, double *ways)
{
    const taut_film_complex *c = &e->layout->complex;
    taut_film_hold hold = c->holds[node];
    double x[3];

    if (c->kind[node] == TAUT_FILM_NODE_HELD) {
        return 0;
    }
    if (e->threads[node]) {
        return complete(&hold, ways);
    }
    if (c->kind[node] == TAUT_FILM_NODE_INSIDE) {
        memcpy(x, moment, sizeof x);
        for (int k = 0; k < hold.count; k++) {
            taut_add_scaled(-taut_dot(x, hold.normals[k]), hold.normals[k], x);
        }
        const double size = taut_norm(x);
        for (int k = 0; k < 3; k++) {
            ways[k] = size > 0 ? x[k] / size : k == 0;
        }
        return hold.count < 3;
    }
    if (c->kind[node] == TAUT_FILM_NODE_LINE) {
        find_tangent(e, node, x);
        (void)taut_film_hold_add(&hold, x, 0, INFINITY);
    }
    return complete(&hold, ways);
}

void taut_film_ways_seen(const taut_film_energy *energy, double *moments, double *local,
                         unsigned char *size, double *ways)
{
    const taut_film_complex *c = &energy->layout->complex;

    memset(moments, 0, 3 * (size_t)c->nodes * sizeof(double));
    for (int p = 0; p < c->problem->patch_count; p++) {
        add_moments(energy, p, local, moments);
    }
    for (int a = 0; a < c->nodes; a++) {
        size[a] = (unsigned char)find_ways(energy, a, moments + 3 * a, ways + 9 * a);
    }
}
