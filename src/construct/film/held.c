#include "construct/film/held.h"

#include "construct/common/curve_fit.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static taut_status fit(const taut_film_space *space, int e, double *row, double *deviation)
{
    const taut_film_problem *problem = space->problem;
    const taut_curve *curve = problem->edges[e].curve;
    const taut_basis *basis = e < 2 ? problem->v : problem->u;
    double ends[2][3];

    if (space->around != NULL) {
        return taut_curve_fit_around(curve, basis, space->around, row, deviation);
    }
    if (taut_basis_equal(taut_curve_t(curve), basis) && taut_curve_weights(curve) == NULL) {
        memcpy(row, taut_curve_points(curve), 3 * (size_t)taut_basis_count(basis) * sizeof(double));
        return TAUT_OK;
    }
    for (int end = 0; end < 2; end++) {
        memcpy(ends[end], space->corners[taut_film_corner_of(e, end)], sizeof ends[end]);
    }
    return taut_curve_fit(curve, basis, (const double(*)[3])ends, row, deviation);
}

taut_status taut_film_lay_curve(taut_film_space *space, int e, taut_arena *arena, taut_error *error)
{
    size_t first = 0, step = 0;
    int count = 0;
    double deviation = 0;

    taut_film_edge_points(space->nu, space->nv, e, &first, &step, &count);
    double *row = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    if (row == NULL) {
        return taut_fail_memory(error);
    }
    const taut_status status = fit(space, e, row, &deviation);
    if (status == TAUT_NO_MEMORY) {
        return taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        char where[32];
        snprintf(where, sizeof where, "/edges/%s/fixed", taut_film_edge_names[e]);
        return taut_fail(error, TAUT_NOT_CONVERGED, "curve-fit", where, taut_none, taut_none,
                         "the curve of edge %s cannot be fitted to its basis: the knots, the "
                         "degree or the points are too extreme",
                         taut_film_edge_names[e]);
    }
    space->deviation = fmax(space->deviation, deviation);
    for (int k = 0; k < count; k++) {
        memcpy(space->points + 3 * (first + (size_t)k * step), row + 3 * k, 3 * sizeof(double));
        space->known[first + (size_t)k * step] = 1;
    }
    return TAUT_OK;
}
