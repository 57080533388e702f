#include "construct/plateau/approach.h"

#include "construct/plateau/directions.h"
#include "core/arena.h"
#include "core/fail.h"

#include <string.h>

static const double residual_near = 1e-7; /* the rest is for the whole net */

/* net and region go on only where a minimum is found. */
static taut_status minimise_along(taut_area_functional *functional, taut_newton_step *newton,
                                  taut_trust_region *region, double *net, double *moved)
{
    const size_t size = 3 * (size_t)functional->nu * (size_t)functional->nv;
    taut_trust_region along = *region;
    taut_status status = TAUT_OK;

    along.tolerance = residual_near > along.tolerance ? residual_near : along.tolerance;
    memcpy(moved, net, size * sizeof(double));
    status = taut_trust_region_minimise(functional, newton, &along, moved, NULL);
    if (status != TAUT_OK) {
        return status;
    }
    memcpy(net, moved, size * sizeof(double));
    region->iterations = along.iterations;
    region->areas_count = along.areas_count;
    return TAUT_OK;
}

static taut_status approach(taut_area_functional *functional, const taut_dirichlet_form *form,
                            const taut_mask *mask, const taut_surface *first, double aspect,
                            const taut_monitor *monitor, taut_trust_region *region, double *net,
                            int *products, taut_arena *arena)
{
    const size_t size = 3 * (size_t)functional->nu * (size_t)functional->nv;
    double *directions = taut_arena_take(arena, size, sizeof(double));
    double *moved = taut_arena_take(arena, size, sizeof(double));
    taut_newton_step *newton = NULL;
    taut_status status =
        moved != NULL ? taut_plateau_directions(first, directions) : TAUT_NO_MEMORY;

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_newton_step_new(functional, form, mask, directions, aspect, monitor, &newton);
    if (status != TAUT_OK) {
        return status;
    }
    status = minimise_along(functional, newton, region, net, moved);
    *products += taut_newton_step_products(newton);
    taut_newton_step_free(newton);
    return status;
}

taut_status taut_plateau_approach(taut_area_functional *functional, const taut_dirichlet_form *form,
                                  const taut_mask *mask, const taut_surface *first, double aspect,
                                  const taut_monitor *monitor, taut_trust_region *region,
                                  double *net, int *products, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status =
        approach(functional, form, mask, first, aspect, monitor, region, net, products, arena);

    taut_arena_free(arena);
    if (status == TAUT_INTERRUPTED) {
        return taut_fail(error, status, "interrupted", NULL, taut_none, taut_none,
                         "stopped on request");
    }
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : TAUT_OK;
}
