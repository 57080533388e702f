/* surface.c -- a number of a surface, derived by its control points.
 *
 * Area: construct/plateau/area.h, by Gauss rules one after the other until two agree. Dirichlet
 * energy: A x, the matrix of construct/dirichlet/form.h.
 */
#include "construct/common/scaling.h"
#include "construct/dirichlet/form.h"
#include "construct/gradient/gradient.h"
#include "construct/plateau/area.h"
#include "core/fail.h"

#include <math.h>
#include <string.h>

const int taut_gradient_nodes[TAUT_GRADIENT_RULES] = {2, 4, 6, 9, 13, 19, 28, 42, 63, 94, 141};

/* What decides: shares of the largest derivative. */
static const struct {
    double settled;     /* two rules agree */
    double unsettled;   /* where the last rules differ by more, nothing is known */
    double points_next; /* Gauss points: a finer rule is not tried where it has more */
} limits = {.settled = 1e-13, .unsettled = 1e-9, .points_next = 3e7};

static size_t numbers_of(const taut_surface *surface)
{
    return 3 * (size_t)taut_basis_count(taut_surface_u(surface)) *
           (size_t)taut_basis_count(taut_surface_v(surface));
}

double taut_gradient_change(size_t size, const double *a, const double *b)
{
    double difference = 0, largest = 0;
    for (size_t i = 0; i < size; i++) {
        difference = fmax(difference, fabs(a[i] - b[i]));
        largest = fmax(largest, fabs(b[i]));
    }
    return largest > 0 ? difference / largest : 0;
}

taut_status taut_gradient_check_settled(double change, taut_error *error)
{
    if (change <= limits.unsettled) {
        return TAUT_OK;
    }
    return taut_fail(error, TAUT_NOT_CONVERGED, "rough", NULL, change, limits.unsettled,
                     "two rules of quadrature differ by %.3g in the derivatives of the area, "
                     "expected at most %.3g",
                     change, limits.unsettled);
}

/* ---- area ---- */

/* seed by one rule; *points of it. net is scaled. */
static taut_status derive_by_rule(const taut_surface *surface, int extra, const double *net,
                                  taut_pulse *pulse, double *seed, double *points)
{
    taut_area_functional *functional = NULL;
    const taut_status status =
        taut_area_functional_new(taut_surface_u(surface), taut_surface_v(surface),
                                 taut_surface_weights(surface), extra, &functional);
    if (status != TAUT_OK) {
        return status;
    }
    *points = (double)functional->u.count * functional->v.count;
    functional->pulse = pulse;
    (void)taut_area_functional_gradient(functional, net, seed);
    taut_area_functional_free(functional);
    return taut_pulse_is_stopped(pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

static taut_status derive_area(const taut_surface *surface, const taut_monitor *monitor,
                               taut_arena *arena, double *seed, taut_error *error)
{
    taut_pulse pulse = {.monitor = monitor, .what = "gradient", .done = taut_none};
    const size_t size = numbers_of(surface);
    unsigned char *all = taut_arena_take(arena, size / 3, 1);
    double *net = taut_arena_take(arena, size, sizeof(double));
    double *before = taut_arena_take(arena, size, sizeof(double));
    double change = INFINITY, points = 0;

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    memset(all, 1, size / 3);
    const taut_scaling scaling = taut_scaling_of(size / 3, taut_surface_points(surface), all);
    taut_scaling_apply(&scaling, size / 3, taut_surface_points(surface), NULL, net);
    for (int k = 0;
         k < TAUT_GRADIENT_RULES && change > limits.settled && points <= limits.points_next / 4;
         k++) {
        memcpy(before, seed, size * sizeof(double));
        const taut_status status =
            derive_by_rule(surface, taut_gradient_nodes[k], net, &pulse, seed, &points);
        if (status != TAUT_OK) {
            return taut_fail_status(error, status);
        }
        change = k > 0 ? taut_gradient_change(size, before, seed) : INFINITY;
    }
    if (taut_gradient_check_settled(change, error) != TAUT_OK) {
        return TAUT_NOT_CONVERGED;
    }
    for (size_t i = 0; i < size; i++) { /* squares of the scaled unit over the scaled unit */
        seed[i] = ldexp(seed[i], scaling.outer + scaling.inner);
    }
    return TAUT_OK;
}

/* ---- Dirichlet energy ---- */

/* The nodes of a quadrature raised until A x moves no more. */
static taut_status settle_form(taut_dirichlet_form *form, size_t size, const double *points,
                               double *before, double *seed, taut_error *error)
{
    double change = INFINITY;
    for (int k = 0; k < TAUT_GRADIENT_RULES && change > limits.settled; k++) {
        memcpy(before, seed, size * sizeof(double));
        taut_status status = taut_dirichlet_rational_raise(form->rational);
        if (status == TAUT_NO_MEMORY) {
            return taut_fail_memory(error);
        }
        if (status != TAUT_OK) {
            return taut_dirichlet_rational_refuse(form->rational, error);
        }
        if (taut_dirichlet_form_apply(form, points, seed) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        change = taut_gradient_change(size, before, seed);
    }
    return taut_gradient_check_settled(change, error);
}

static taut_status derive_energy(const taut_surface *surface, taut_arena *arena, double *seed,
                                 taut_error *error)
{
    const double *points = taut_surface_points(surface);
    const size_t size = numbers_of(surface);
    double *before = taut_arena_take(arena, size, sizeof(double));
    taut_dirichlet_form form;
    taut_status status = TAUT_OK;

    if (before == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_dirichlet_form_new(taut_surface_u(surface), taut_surface_v(surface),
                                     taut_surface_weights(surface), &form, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_dirichlet_form_scale(&form, form.ratio, 1 / form.ratio);
    if (taut_dirichlet_form_apply(&form, points, seed) != TAUT_OK) {
        status = taut_fail_memory(error);
    } else if (form.rational != NULL) {
        status = settle_form(&form, size, points, before, seed, error);
    }
    taut_dirichlet_form_clear(&form);
    return status;
}

taut_status taut_gradient_of_surface(const taut_surface *surface,
                                     const taut_gradient_request *request, taut_arena *arena,
                                     double *seed, taut_error *error)
{
    if (request->of == TAUT_GRADIENT_POINTS) {
        memcpy(seed, request->factors, numbers_of(surface) * sizeof(double));
        return TAUT_OK;
    }
    return request->of == TAUT_GRADIENT_AREA
               ? derive_area(surface, &request->monitor, arena, seed, error)
               : derive_energy(surface, arena, seed, error);
}
