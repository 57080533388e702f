#include "certify/asymptotic/unit.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

static double largest(int64_t count, const double *numbers, double most)
{
    for (int64_t k = 0; k < count; k++) {
        most = fmax(most, fabs(numbers[k]));
    }
    return most;
}

static int exponent_of(double size)
{
    int exponent = 0;
    (void)frexp(size, &exponent);
    return exponent;
}

/* count numbers times 2^-exponent; NULL of NULL. */
static double *scaled_numbers(taut_arena *arena, int64_t count, const double *from, int exponent)
{
    double *const made =
        from != NULL ? taut_arena_copy(arena, from, (size_t)count, sizeof *made) : NULL;
    for (int64_t k = 0; made != NULL && k < count; k++) {
        made[k] = ldexp(made[k], -exponent);
    }
    return made;
}

static void free_surface(void *surface)
{
    taut_surface_free(surface);
}

static void free_curve(void *curve)
{
    taut_curve_free(curve);
}

static taut_status scale_patch(const taut_surface *patch, int exponent, taut_arena *arena,
                               const taut_surface **unit)
{
    const taut_basis *const u = taut_surface_u(patch), *const v = taut_surface_v(patch);
    const int64_t count = (int64_t)taut_basis_count(u) * taut_basis_count(v);
    const double *const weights = taut_surface_weights(patch);
    const int light = weights != NULL ? exponent_of(largest(count, weights, 0)) : 0;
    const double *const points =
        scaled_numbers(arena, 3 * count, taut_surface_points(patch), exponent);
    const double *const scaled = scaled_numbers(arena, count, weights, light);
    taut_surface *made = NULL;
    taut_status status = taut_arena_status(arena);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_new(taut_surface_name(patch), u, v, points, scaled, &made, NULL);
    *unit = made;
    return status == TAUT_OK && !taut_arena_keep(arena, made, free_surface) ? TAUT_NO_MEMORY
                                                                            : status;
}

static taut_status scale_curve(const taut_curve *curve, int exponent, taut_arena *arena,
                               const taut_curve **unit)
{
    const int64_t count = taut_basis_count(taut_curve_t(curve));
    const double *const points =
        scaled_numbers(arena, 3 * count, taut_curve_points(curve), exponent);
    taut_curve *made = NULL;
    taut_status status = taut_arena_status(arena);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(taut_curve_name(curve), taut_curve_t(curve), points,
                            taut_curve_weights(curve), &made, NULL);
    *unit = made;
    return status == TAUT_OK && !taut_arena_keep(arena, made, free_curve) ? TAUT_NO_MEMORY : status;
}

static taut_status scale_problem(const taut_asymptotic_problem *problem, int exponent,
                                 taut_arena *arena, taut_asymptotic_problem *scaled)
{
    taut_status status = TAUT_OK;
    *scaled = *problem;
    if (problem->given == TAUT_ASYMPTOTIC_CURVES) {
        for (int e = 0; e < 4 && status == TAUT_OK; e++) {
            status = scale_curve(problem->curves[e], exponent, arena, &scaled->curves[e]);
        }
        return status;
    }
    for (int c = 0; c < 4; c++) {
        taut_asymptotic_edge *const edge = &scaled->corners.edges[c];
        for (int k = 0; k < 3; k++) {
            scaled->corners.points[c][k] = ldexp(scaled->corners.points[c][k], -exponent);
            edge->legs[0][k] = ldexp(edge->legs[0][k], -exponent);
            edge->legs[1][k] = ldexp(edge->legs[1][k], -exponent);
        }
        for (int end = 0; end < 2; end++) {
            edge->curvature[end] = ldexp(edge->curvature[end], exponent);
        }
    }
    return TAUT_OK;
}

taut_status taut_asymptotic_unit(const taut_asymptotic_model *model,
                                 const taut_asymptotic_problem *problem, taut_arena *arena,
                                 taut_asymptotic_model *unit, taut_asymptotic_problem *scaled,
                                 int *exponent)
{
    const int64_t count = INT64_C(3) * taut_basis_count(taut_surface_u(model->patch)) *
                          taut_basis_count(taut_surface_v(model->patch));
    double size = largest(count, taut_surface_points(model->patch), 0);
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4; e++) {
        size = largest(INT64_C(3) * taut_basis_count(taut_curve_t(model->curves[e])),
                       taut_curve_points(model->curves[e]), size);
    }
    *exponent = exponent_of(size);
    memset(unit, 0, sizeof *unit);
    status = scale_patch(model->patch, *exponent, arena, &unit->patch);
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        status = scale_curve(model->curves[e], *exponent, arena, &unit->curves[e]);
    }
    return status == TAUT_OK && problem != NULL ? scale_problem(problem, *exponent, arena, scaled)
                                                : status;
}
