#include "construct/film/complex/turned.h"

#include "core/vec3.h"

#include <string.h>

static const double beside = 1e-6; /* of a span: an edge, but for a pole */

/* Functions and slopes at places of one direction. */
typedef struct places {
    int count, local;
    double *at;     /* [count] */
    int *first;     /* [count] */
    double *values; /* [count][2][local] */
} places;

static taut_status lay_places(const taut_basis *basis, taut_arena *arena, places *l)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), each = taut_basis_local(basis) + 2;

    l->count = spans * each + 2;
    l->local = taut_basis_local(basis);
    l->at = taut_arena_take(arena, (size_t)l->count, sizeof(double));
    l->first = taut_arena_take(arena, (size_t)l->count, sizeof(int));
    l->values = taut_arena_take(arena, (size_t)l->count, 2 * (size_t)l->local * sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < l->count; k++) {
        const int is_last = k == l->count - 1, span = k == 0    ? 0
                                                      : is_last ? spans - 1
                                                                : (k - 1) / each;
        const double share = k == 0 ? beside : is_last ? 1 - beside : ((k - 1) % each + 0.5) / each;
        l->at[k] = (1 - share) * breaks[span] + share * breaks[span + 1];
        l->first[k] = taut_basis_first(basis, span);
        (void)taut_basis_eval(basis, span, l->at[k], 1,
                              l->values + (size_t)k * 2 * (size_t)l->local);
    }
    return TAUT_OK;
}

/* node: [nu][nv] */
static void find_normal(const double *x, const int *node, int nv, const places *u, int i,
                        const places *v, int j, double normal[3])
{
    const double *n = u->values + (size_t)i * 2 * (size_t)u->local, *d = n + u->local;
    const double *m = v->values + (size_t)j * 2 * (size_t)v->local, *e = m + v->local;
    double xu[3] = {0, 0, 0}, xv[3] = {0, 0, 0};

    for (int a = 0; a < u->local; a++) {
        for (int b = 0; b < v->local; b++) {
            const double *p = x + 3 * node[(u->first[i] + a) * nv + v->first[j] + b];
            taut_add_scaled(d[a] * m[b], p, xu);
            taut_add_scaled(n[a] * e[b], p, xv);
        }
    }
    taut_cross(xu, xv, normal);
}

static taut_status look_at_patch(const taut_film_complex *c, int p, const double *x,
                                 taut_film_turned *turned)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const int *node = c->node + c->first[p];
    const int nv = taut_basis_count(patch->v);
    taut_arena *arena = taut_arena_new();
    places u, v;
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
            find_normal(x, node, nv, &u, i, &v, j, n);
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
