#include "construct/film/meeting.h"

#include "construct/film/edges.h"
#include "core/vec3.h"

#include <stddef.h>
#include <string.h>

static const double turn_least =
    1e-6; /* sine: of held edges that run on into each other a fit leaves so much */

/* What one node has in where the ends of a cable look; out: from the net inside. */
static void add_node(double weight, double w, double radius, const double t[3], double out[3],
                     const taut_film_edge *edge, double ends[2][3])
{
    const double *n = edge->plane.direction, square = taut_dot(t, t), speed = sqrt(square);

    taut_add_scaled(-taut_dot(out, t) / square, t, out);
    const double pull = weight * speed / (radius * taut_length(out));
    if (edge->has_plane) {
        taut_add_scaled(-taut_dot(out, n) / taut_dot(n, n), n, out);
    }
    for (int end = 0; end < 2; end++) {
        taut_add_scaled((end ? -weight : weight) / speed, t, ends[end]);
        taut_add_scaled((end ? -w : w - 1) * pull, out, ends[end]);
    }
}

/* Where edge e of the net looks from its ends; radius 0: no cable. */
static void find_ends(const taut_area_functional *f, const taut_film_problem *patch, int e,
                      double radius, const double *net, double ends[2][3])
{
    const taut_area_axis *axis = e < 2 ? &f->v : &f->u;
    const taut_basis *basis = e < 2 ? patch->v : patch->u;
    const double lo = taut_basis_lo(basis), range = taut_basis_hi(basis) - lo;
    const ptrdiff_t across = 3 * (ptrdiff_t)(e < 2 ? f->nv : 1);
    size_t first = 0, step = 0;
    int count = 0;

    taut_film_edge_points(f->nu, f->nv, e, &first, &step, &count);
    net += 3 * first;
    memset(ends, 0, 6 * sizeof(double));
    if (radius == 0) {
        const double *last = net + 3 * step * (size_t)(count - 1);
        taut_difference(net + 3 * step, net, ends[0]);
        taut_difference(last - 3 * step, last, ends[1]);
    }
    for (int k = 0; radius > 0 && k < axis->count; k++) {
        double t[3] = {0, 0, 0}, out[3] = {0, 0, 0};
        for (int l = 0; l < axis->local; l++) {
            const double *p = net + 3 * step * (size_t)(axis->first[k] + l);
            const double value = axis->value[k * axis->local + l];
            taut_add_scaled(axis->slope[k * axis->local + l], p, t);
            taut_add_scaled(value, p, out);
            taut_add_scaled(-value, e % 2 ? p - across : p + across, out);
        }
        add_node(axis->weights[k], (axis->at[k] - lo) / range, radius, t, out, &patch->edges[e],
                 ends);
    }
}

int taut_film_passes(const taut_area_functional *f, const taut_film_problem *patch,
                     const double radius[4], const double *net, int c)
{
    const int i = c % 2, j = c / 2;
    double u[2][3], v[2][3], n[TAUT_AREA_STATE];

    find_ends(f, patch, 2 + j, radius[2 + j], net, u);
    find_ends(f, patch, i, radius[i], net, v);
    taut_area_functional_state(f, i * (f->u.count - 1), j * (f->v.count - 1), n);
    const double turn = (i == j ? 1 : -1) * taut_det(u[i], v[j], n);
    return !(radius[i] + radius[2 + j] > 0
                 ? turn > 0
                 : turn > -turn_least * (taut_dot(u[i], u[i]) + taut_dot(v[j], v[j])));
}
