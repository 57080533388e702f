#include "measure/integrate/near_zero.h"

#include "core/memory.h"

#include <math.h>

int taut_near_zero(const taut_basis *basis, taut_basis **moved)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const double nearest = lo > 0 ? lo : hi < 0 ? -hi : 0;
    taut_basis_spec spec;
    double *knots = NULL;
    taut_status status = TAUT_OK;

    *moved = NULL;
    if (nearest < hi - lo || nearest == 0) {
        return 1;
    }
    taut_basis_spec_of(basis, &spec);
    spec.range[0] -= lo;
    spec.range[1] -= lo;
    if (spec.knots != NULL) {
        knots = taut_alloc((size_t)spec.knot_count, sizeof *knots);
        if (knots == NULL) {
            return 0;
        }
        for (int i = 0; i < spec.knot_count; i++) {
            knots[i] = spec.knots[i] - lo;
        }
        spec.knots = knots;
    }
    status = taut_basis_new(&spec, taut_basis_count(basis), moved, NULL);
    taut_free(knots);
    return status != TAUT_NO_MEMORY;
}

int taut_surface_near_zero(const taut_surface *surface, taut_surface **moved)
{
    taut_basis *u = NULL, *v = NULL;
    int done =
        taut_near_zero(taut_surface_u(surface), &u) && taut_near_zero(taut_surface_v(surface), &v);

    *moved = NULL;
    if (done && (u != NULL || v != NULL)) {
        done =
            taut_surface_new(taut_surface_name(surface), u != NULL ? u : taut_surface_u(surface),
                             v != NULL ? v : taut_surface_v(surface), taut_surface_points(surface),
                             taut_surface_weights(surface), moved, NULL) == TAUT_OK;
    }
    taut_basis_free(u);
    taut_basis_free(v);
    return done;
}
