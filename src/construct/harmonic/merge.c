/* merge.c -- are a harmonic surface and another given one pieces of one? Their polynomial is that
 * of the first, so the second must be what it is carried on to ([NiWang2015] section 3, G). */
#include "construct/harmonic/neighbour.h"
#include "core/elementary/elementary.h"
#include "core/exact.h"
#include "core/fail.h"

#include <float.h>
#include <math.h>
#include <string.h>

taut_status taut_neighbour_match(const taut_neighbour *e, double *width, taut_error *error)
{
    const taut_surface *other = e->other, *given = e->surface;
    const int is_v = e->edge == TAUT_EDGE_V0 || e->edge == TAUT_EDGE_V1;
    const taut_basis *across = is_v ? taut_surface_v(other) : taut_surface_u(other);
    const taut_status status = taut_neighbour_check(other, 0, error);

    if (status != TAUT_OK) {
        return taut_fail(error, TAUT_BAD_INPUT, "not-bezier", "/neighbour", taut_none, taut_none,
                         "expected a polynomial surface on \"bezier\" bases");
    }
    const int n = taut_basis_degree(taut_surface_u(given));
    const int m = taut_basis_degree(taut_surface_v(given));
    const int other_n = taut_basis_degree(taut_surface_u(other));
    const int other_m = taut_basis_degree(taut_surface_v(other));
    if (n != other_n || m != other_m) {
        return taut_fail(error, TAUT_NO_SOLUTION, "other-surface", "/neighbour", taut_none,
                         taut_none,
                         "not the same surface: the neighbour's degrees are %d and %d, the "
                         "surface's %d and %d",
                         other_n, other_m, n, m);
    }
    *width = taut_basis_hi(across) - taut_basis_lo(across);
    return TAUT_OK;
}

/* Do the exact points differ? By their texts in lowest terms: the other surface over its own range
 * again. */
static taut_status differ(const taut_neighbour *e, const taut_surface *beyond, int *apart,
                          taut_error *error)
{
    const taut_surface *other = e->other;
    const int n = taut_basis_degree(taut_surface_u(other));
    const int m = taut_basis_degree(taut_surface_v(other));
    const double same[4] = {0, 1, 0, 1};
    const taut_exact_numbers numbers = {taut_surface_points(other), taut_surface_exact(other)};
    const taut_exact_memory memory = taut_exact_memory_of(e->arena);
    const taut_exact_ops *ops = NULL;
    taut_exact_net net;
    const taut_status status = taut_exact_load(&ops, error);

    *apart = 0;
    if (status != TAUT_OK) {
        return status;
    }
    if (!ops->rerange(n, m, &numbers, 0, same, &memory, &net)) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < 3 * (n + 1) * (m + 1); k++) {
        *apart = *apart || strcmp(net.texts[k], taut_surface_exact(beyond)[k]) != 0;
    }
    return TAUT_OK;
}

taut_status taut_neighbour_compare(const taut_neighbour *e, const taut_surface *beyond, int exact,
                                   taut_error *error)
{
    const double *a = taut_surface_points(beyond), *b = taut_surface_points(e->other);
    const double growth =
        4 * DBL_EPSILON * taut_unit_map_reach(&e->map) * taut_pow(1 + 2 * e->ratio, e->n);
    double gap = 0, size = e->map.size, limit = 0;
    int apart = 0;
    const taut_status status = exact ? differ(e, beyond, &apart, error) : TAUT_OK;

    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < 3 * (e->n + 1) * (e->m + 1); k++) {
        gap = fmax(gap, fabs(a[k] - b[k]));
        size = fmax(size, fabs(a[k] - e->map.centre[k % 3]));
    }
    limit = exact ? 0 : fmax(1e-10 * size, growth * e->map.size);
    if (apart || !(gap <= limit)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "other-surface", "/neighbour", gap, limit,
                         "not the same surface: carried on across %s the surface misses the "
                         "neighbour's points by %.3g (u and v must run alike in both)",
                         taut_edge_name(e->edge), gap);
    }
    return TAUT_OK;
}
