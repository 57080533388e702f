#include "construct/film/complex/turned.h"

#include "construct/film/complex/places.h"
#include "core/vec3.h"

static const double beside = 1e-6; /* of a span: an edge, but for a pole */

static taut_status lay_places(const taut_basis *basis, taut_arena *arena, taut_film_places *l)
{
    const int spans = taut_basis_span_count(basis), each = taut_basis_local(basis) + 2;
    const taut_status status = taut_film_places_take(basis, spans * each + 2, arena, l);

    if (status != TAUT_OK) {
        return status;
    }
    taut_film_places_put(basis, 0, beside, 0, l);
    for (int k = 0; k < spans * each; k++) {
        taut_film_places_put(basis, k / each, (k % each + 0.5) / each, k + 1, l);
    }
    taut_film_places_put(basis, spans - 1, 1 - beside, l->count - 1, l);
    return TAUT_OK;
}

static taut_status look_at_patch(const taut_film_complex *c, int p, const double *x,
                                 taut_film_turned *turned)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const int *node = c->node + c->first[p];
    const int nv = taut_basis_count(patch->v);
    taut_arena *arena = taut_arena_new();
    taut_film_places u, v;
    double *normals[2] = {NULL, NULL};
    taut_status status = lay_places(patch->u, arena, &u);

    if (status == TAUT_OK) {
        status = lay_places(patch->v, arena, &v);
    }
    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        normals[k] = taut_arena_take(arena, (size_t)v.count, 3 * sizeof(double));
        status = taut_arena_status(arena);
    }
    for (int i = 0; status == TAUT_OK && turned->patch < 0 && i < u.count; i++) {
        const double *before = normals[(i + 1) % 2];
        for (int j = 0; turned->patch < 0 && j < v.count; j++) {
            double *n = normals[i % 2] + 3 * (size_t)j;
            taut_film_normal(x, node, nv, &u, i, &v, j, n);
            if ((j > 0 && taut_dot(n, n - 3) < 0) ||
                (i > 0 && taut_dot(n, before + 3 * (size_t)j) < 0)) {
                *turned = (taut_film_turned){p, u.at[i], v.at[j]};
            }
        }
    }
    taut_arena_free(arena);
    return status;
}

taut_status taut_film_find_turned(const taut_film_complex *c, const double *x,
                                  taut_film_turned *turned)
{
    taut_status status = TAUT_OK;

    turned->patch = -1;
    for (int p = 0; status == TAUT_OK && turned->patch < 0 && p < c->problem->patch_count; p++) {
        status = look_at_patch(c, p, x, turned);
    }
    return status;
}
