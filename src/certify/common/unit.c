#include "certify/common/unit.h"

#include "core/memory.h"

#include <math.h>

static size_t count_of(const taut_surface *surface)
{
    return 3 * (size_t)taut_basis_count(taut_surface_u(surface)) *
           (size_t)taut_basis_count(taut_surface_v(surface));
}

int taut_certify_unit_of(const taut_surface *surface)
{
    const size_t count = count_of(surface);
    double largest = 0;
    for (size_t k = 0; k < count; k++) {
        largest = fmax(largest, fabs(taut_surface_points(surface)[k]));
    }
    return largest > 0 ? ilogb(largest) : 0;
}

taut_status taut_certify_scaled(const taut_surface *surface, int unit, taut_surface **scaled)
{
    const size_t count = count_of(surface);
    double *points = taut_alloc(count, sizeof *points);
    taut_status status = points != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (size_t k = 0; status == TAUT_OK && k < count; k++) {
        points[k] = ldexp(taut_surface_points(surface)[k], -unit);
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(taut_surface_name(surface), taut_surface_u(surface),
                                  taut_surface_v(surface), points, taut_surface_weights(surface),
                                  scaled, NULL);
    }
    taut_free(points);
    return status;
}
