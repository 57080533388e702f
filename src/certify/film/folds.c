#include "certify/film/folds.h"

#include "core/arena.h"
#include "core/vec3.h"

#include <string.h>

static const double beside =
    1e-6; /* of a span: where edges meet sharply, they may pass each other in the corner alone */

/* Places along a direction, so many a span and one beside each end; how many. */
static int count_places(const taut_basis *basis)
{
    return taut_basis_span_count(basis) * (taut_basis_degree(basis) + 3) + 2;
}

static double *make_places(taut_arena *arena, const taut_basis *basis)
{
    const double *breaks = taut_basis_breaks(basis);
    const int each = taut_basis_degree(basis) + 3, count = count_places(basis);
    double *at = taut_arena_take(arena, (size_t)count, sizeof *at);

    for (int k = 1; at != NULL && k < count - 1; k++) {
        const int span = (k - 1) / each;
        const double share = ((k - 1) % each + 0.5) / each;
        at[k] = (1 - share) * breaks[span] + share * breaks[span + 1];
    }
    if (at != NULL) {
        const int last = taut_basis_span_count(basis);
        at[0] = (1 - beside) * breaks[0] + beside * breaks[1];
        at[count - 1] = beside * breaks[last - 1] + (1 - beside) * breaks[last];
    }
    return at;
}

static void make_unit(double x[3])
{
    const double size = taut_norm(x);
    for (int c = 0; c < 3; c++) {
        x[c] /= size;
    }
}

/* Of lengths up to 1: of unit x_u and x_v, so that nothing leaves the range of doubles. */
static void find_normals(double (*vectors)[TAUT_SURFACE_VECTORS(1)][3], int count, double *normals)
{
    for (int k = 0; k < count; k++) {
        make_unit(vectors[k][TAUT_XU]);
        make_unit(vectors[k][TAUT_XV]);
        taut_cross(vectors[k][TAUT_XU], vectors[k][TAUT_XV], normals + (ptrdiff_t)3 * k);
    }
}

taut_status taut_film_find_fold(const taut_surface *surface, int *folds, double *u, double *v)
{
    const taut_basis *along = taut_surface_u(surface), *across = taut_surface_v(surface);
    const int nu = count_places(along), nv = count_places(across);
    taut_arena *arena = taut_arena_new();
    const double *us = make_places(arena, along), *vs = make_places(arena, across);
    double(*vectors)[TAUT_SURFACE_VECTORS(1)][3] =
        taut_arena_take(arena, (size_t)nv, sizeof *vectors);
    double *line[2] = {taut_arena_take(arena, (size_t)nv, 3 * sizeof(double)),
                       taut_arena_take(arena, (size_t)nv, 3 * sizeof(double))};
    taut_status status = taut_arena_status(arena);

    *folds = 0;
    for (int i = 0; status == TAUT_OK && !*folds && i < nu; i++) {
        double *here = line[i % 2];
        const double *before = line[1 - i % 2];
        status = taut_surface_eval_grid(surface, 1, us + i, nv, vs, 1, 1, vectors[0][0]);
        find_normals(vectors, nv, here);
        for (int j = 0; status == TAUT_OK && !*folds && j < nv; j++) {
            const double *n = here + (ptrdiff_t)3 * j;
            if ((j > 0 && taut_dot(n, n - 3) < 0) ||
                (i > 0 && taut_dot(n, before + (ptrdiff_t)3 * j) < 0)) {
                *folds = 1;
                *u = us[i];
                *v = vs[j];
            }
        }
    }
    taut_arena_free(arena);
    return status;
}
