#include "construct/plateau/approach.h"

#include "construct/plateau/directions.h"
#include "core/fail.h"
#include "core/memory.h"

#include <string.h>

static const double near = 1e-7; /* residual: the rest is for the whole net */

taut_status taut_plateau_approach(taut_film *film, const taut_dirichlet_form *form,
                                  const taut_mask *mask, const taut_surface *first, double aspect,
                                  const taut_monitor *monitor, taut_descent *descent, double *net,
                                  int *products, taut_error *error)
{
    const size_t size = 3 * (size_t)film->nu * (size_t)film->nv;
    double *directions = taut_alloc_aligned(size, sizeof(double));
    double *moved = taut_alloc_aligned(size, sizeof(double));
    taut_film_solver *solver = NULL;
    taut_descent along = *descent;
    taut_status status = directions != NULL && moved != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    if (status == TAUT_OK) {
        memcpy(moved, net, size * sizeof(double));
        status = taut_plateau_directions(first, directions);
    }
    if (status == TAUT_OK) {
        status = taut_film_solver_new(film, form, mask, directions, aspect, monitor, &solver);
    }
    if (status == TAUT_OK) {
        along.tolerance = near > along.tolerance ? near : along.tolerance;
        status = taut_film_descend(film, solver, &along, moved, NULL);
        *products += taut_film_solver_products(solver);
    }
    if (status == TAUT_OK) {
        memcpy(net, moved, size * sizeof(double));
        descent->iterations = along.iterations;
        descent->areas_count = along.areas_count;
    }
    taut_film_solver_free(solver);
    taut_free(directions);
    taut_free(moved);
    if (status == TAUT_INTERRUPTED) {
        return taut_fail(error, status, "value", NULL, taut_none, taut_none, "stopped on request");
    }
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : TAUT_OK;
}
