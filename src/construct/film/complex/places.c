#include "construct/film/complex/places.h"

#include "core/vec3.h"

taut_status taut_film_places_take(const taut_basis *basis, int count, taut_arena *arena,
                                  taut_film_places *places)
{
    places->count = count;
    places->local = taut_basis_local(basis);
    places->at = taut_arena_take(arena, (size_t)count, sizeof(double));
    places->first = taut_arena_take(arena, (size_t)count, sizeof(int));
    places->values =
        taut_arena_take(arena, (size_t)count, 2 * (size_t)places->local * sizeof(double));
    return taut_arena_status(arena);
}

void taut_film_places_put(const taut_basis *basis, int span, double share, int k,
                          taut_film_places *places)
{
    const double *breaks = taut_basis_breaks(basis);

    places->at[k] = (1 - share) * breaks[span] + share * breaks[span + 1];
    places->first[k] = taut_basis_first(basis, span);
    (void)taut_basis_eval(basis, span, places->at[k], 1,
                          places->values + (size_t)k * 2 * (size_t)places->local);
}

void taut_film_normal(const double *x, const int *node, int nv, const taut_film_places *u, int i,
                      const taut_film_places *v, int j, double normal[3])
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
