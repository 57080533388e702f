#include "construct/film/complex/ways.h"

#include "construct/film/complex/volume.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

int taut_film_ways_all(const taut_film_complex *complex, int node, double ways[9])
{
    taut_film_hold hold = complex->holds[node];
    return complex->kind[node] == TAUT_FILM_NODE_HELD ? 0 : taut_film_hold_left(&hold, ways);
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

static int find_ways(const taut_film_energy *e, int node, const double *moment, double *ways)
{
    const taut_film_complex *c = &e->layout->complex;
    taut_film_hold hold = c->holds[node];
    double x[3];

    if (c->kind[node] == TAUT_FILM_NODE_HELD) {
        return 0;
    }
    if (e->threads[node]) {
        return taut_film_hold_left(&hold, ways);
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
        taut_film_complex_tangent(c, e->net, node, x);
        (void)taut_film_hold_add(&hold, x, 0, INFINITY);
    }
    return taut_film_hold_left(&hold, ways);
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
