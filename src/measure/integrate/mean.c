/* mean.c -- the largest |H| of a grid, row by row.
 *
 * Of most points it is enough to know that |H| is below what another point of the row has:
 *
 *     |H| = |l G - 2 m F + n E| / (2 W^3),   l = x_uu . (x_u x x_v), ..
 *
 * as it stands, with what rounding may do to it added. Only points that may be the largest are
 * looked at with forms.c's care, and so are those whose numbers are too small, too large or too
 * nearly singular for a bound. */
#include "measure/integrate/integrals.h"

#include "core/vec3.h"
#include "measure/curvature/scan.h"
#include "taut/measure.h"

#include <math.h>

enum { POINT_WORK = 200 }; /* operations at a point, as pulses count them */

/* Products of up to nine of these neither overflow nor underflow. */
static const double smallest = 0x1p-100, largest = 0x1p100;
/* Above W^2 / (E G) the relative rounding of W is below 1e-9; that of the sum is `noise` of its
 * terms. */
static const double flattest = 1e-10, noise = 0x1p-44;

/* A number that |H| is not above; INFINITY where none is known. */
static double bound_of(const double *x)
{
    const double *xu = x + 3 * TAUT_XU, *xv = x + 3 * TAUT_XV;
    const double e = taut_dot(xu, xu), f = taut_dot(xu, xv), g = taut_dot(xv, xv);
    double normal[3];

    taut_cross(xu, xv, normal);
    const double w2 = taut_dot(normal, normal);
    const double l = taut_dot(x + 3 * TAUT_XUU, normal) * g;
    const double m = taut_dot(x + 3 * TAUT_XUV, normal) * 2 * f;
    const double n = taut_dot(x + 3 * TAUT_XVV, normal) * e;
    if (!(e > smallest && e < largest && g > smallest && g < largest && w2 > flattest * e * g)) {
        return INFINITY;
    }
    const double w = sqrt(w2);
    /* l, m, n cancel by themselves too: |x_uu| W in place of |x_uu . (x_u x x_v)| */
    const double sizes =
        w * (taut_length(x + 3 * TAUT_XUU) * g + 2 * taut_length(x + 3 * TAUT_XUV) * fabs(f) +
             taut_length(x + 3 * TAUT_XVV) * e);
    const double bound = (fabs(l - m + n) + noise * sizes) / (2 * w2 * w);
    return sizes < largest ? bound * (1 + 1e-8) : INFINITY;
}

static double exact_mean(const double *x)
{
    taut_forms forms;
    taut_forms_of((const double(*)[3])x, &forms);
    return forms.regular ? fabs(forms.mean) : -1;
}

/* The largest |H| of `count` points and of `most`, which is -1 before there is one. */
static double raise_largest(int count, const double *values, double *bounds, double most)
{
    int best = 0;
    for (int j = 0; j < count; j++) {
        bounds[j] = bound_of(values + 18 * (size_t)j);
        best = bounds[j] > bounds[best] ? j : best;
    }
    if (count > 0 && bounds[best] > most) { /* the likeliest first: it spares the others */
        most = fmax(most, exact_mean(values + 18 * (size_t)best));
        bounds[best] = -1;
    }
    for (int j = 0; j < count; j++) {
        if (bounds[j] > most) {
            most = fmax(most, exact_mean(values + 18 * (size_t)j));
        }
    }
    return most;
}

static taut_status look(taut_arena *arena, const taut_surface *surface, int grid,
                        const taut_crew *crew, double *most)
{
    const taut_parameters *u = taut_parameters_new(arena, taut_surface_u(surface), grid, 0);
    const taut_parameters *v = taut_parameters_new(arena, taut_surface_v(surface), grid, 0);
    taut_scan *scan = NULL;
    double found = -1;

    if (taut_scan_new(arena, surface, u, v, &scan) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    double *scratch = taut_arena_take(arena, taut_scan_scratch(scan), sizeof(double));
    double *values = taut_arena_take(arena, (size_t)v->count, 18 * sizeof(double));
    double *bounds = taut_arena_take(arena, (size_t)v->count, sizeof(double));
    if (bounds == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < u->count; i++) {
        taut_scan_line(scan, i, scratch, values);
        found = raise_largest(v->count, values, bounds, found);
        if (taut_crew_beat(crew, POINT_WORK * v->count)) {
            return TAUT_INTERRUPTED;
        }
    }
    *most = found >= 0 ? found : nan("");
    return TAUT_OK;
}

taut_status taut_mean_largest(const taut_surface *surface, int grid, const taut_crew *crew,
                              double *most)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = look(arena, surface, grid, crew, most);

    taut_arena_free(arena);
    return status;
}

taut_status taut_mean_figures_of(const taut_surface *surface, int grid, const taut_crew *crew,
                                 taut_mean_figures *figures)
{
    taut_surface_integrals integrals;
    taut_status status = taut_surface_mean(surface, crew, &integrals);
    if (status != TAUT_OK) {
        return status;
    }
    taut_mean_figures made = {.area = integrals.area,
                              .area_error = integrals.area_error,
                              .mean_abs = integrals.mean_abs,
                              .rms = sqrt(integrals.mean_square)};
    status = taut_mean_largest(surface, grid, crew, &made.max_abs);
    if (status != TAUT_OK) {
        return status;
    }
    *figures = made;
    return TAUT_OK;
}
