/* measure.c -- all figures of a surface, its edges, and of a curve.
 *
 * Along an edge with the curve x(t), the surface's unit normal n and the binormal b = x' x x'',
 *     k_n = x''.n / |x'|^2,    angle of n and b = atan2(|n x b|, |n.b|) in [0, pi/2].
 */
#include "taut/measure.h"

#include "core/arena.h"
#include "core/crew.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "measure/curvature/box.h"
#include "measure/curvature/extremes.h"
#include "measure/curvature/scan.h"
#include "measure/integrate/integrals.h"
#include "measure/integrate/jacobian.h"
#include "measure/integrate/line.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { GRID = 101 };

/* The options with their defaults filled in. */
static taut_status settle_options(const taut_measure_options *given, taut_measure_options *options,
                                  taut_error *error)
{
    *options = given != NULL ? *given : (taut_measure_options){.grid = 0};
    options->grid = options->grid == 0 ? GRID : options->grid;
    options->threads = options->threads == 0 ? 1 : options->threads;
    if (options->grid < 2 || options->grid > TAUT_GRID_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/grid", options->grid,
                         TAUT_GRID_MAX, "a grid of %d parameters, expected 2 to %d", options->grid,
                         TAUT_GRID_MAX);
    }
    if (options->threads < 1 || options->threads > TAUT_THREADS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", "/threads", options->threads,
                         TAUT_THREADS_MAX, "%d threads, expected 1 to %d", options->threads,
                         TAUT_THREADS_MAX);
    }
    return TAUT_OK;
}

static void take_figures(const taut_surface_integrals *figures, const taut_extremes *extremes,
                         taut_surface_measure *measure)
{
    measure->area = figures->area;
    measure->area_error = figures->area_error;
    measure->dirichlet_energy = figures->dirichlet;
    measure->dirichlet_energy_error = figures->dirichlet_error;
    measure->bending_energy = figures->bending;
    measure->bending_energy_error = figures->bending_error;
    measure->mean_abs_mean = figures->mean_abs;
    measure->isothermality = figures->isothermality;
    measure->isothermality_error = figures->isothermality_error;
    measure->max_abs_mean = extremes->max_abs_mean;
    measure->max_abs_mean_at[0] = extremes->max_abs_mean_at[0];
    measure->max_abs_mean_at[1] = extremes->max_abs_mean_at[1];
    measure->min_gaussian = extremes->min_gaussian;
    measure->max_gaussian = extremes->max_gaussian;
    measure->max_e_minus_g = extremes->max_e_minus_g;
    measure->max_f = extremes->max_f;
    measure->max_laplacian = extremes->max_laplacian;
    measure->singular_points = extremes->singular;
}

/* The surface's normals along an edge, entry by entry of the grid along it: double[count][3], NaN
 * where there is none; NULL when memory runs out. */
static const double *normals_along(taut_arena *arena, const taut_surface *surface, int edge,
                                   const taut_parameters *along)
{
    const int held = edge / 2; /* the direction across: 0 u, 1 v */
    const taut_basis *basis = held == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const double end = edge % 2 == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis);
    const taut_parameters *across = taut_parameters_new(arena, basis, 1, end);
    double *normals = taut_arena_take(arena, (size_t)along->count, 3 * sizeof(double));
    double *values = taut_arena_take(arena, (size_t)along->count, 18 * sizeof(double));
    taut_scan *scan = NULL;
    const taut_status status = held == 0 ? taut_scan_new(arena, surface, across, along, &scan)
                                         : taut_scan_new(arena, surface, along, across, &scan);
    double *scratch =
        status == TAUT_OK ? taut_arena_take(arena, taut_scan_scratch(scan), sizeof(double)) : NULL;

    if (scratch == NULL) {
        return NULL;
    }
    for (int i = 0; i < scan->u->count; i++) {
        taut_scan_line(scan, i, scratch, values + (held == 0 ? 0 : 18 * (int64_t)i));
    }
    for (int i = 0; i < along->count; i++) {
        taut_forms forms;
        taut_forms_of((const double(*)[3])(values + 18 * (int64_t)i), &forms);
        memcpy(normals + 3 * (int64_t)i, forms.normal, sizeof forms.normal);
    }
    return normals;
}

static double angle_between_lines(const double *a, const double *b)
{
    double c[3];
    taut_cross(a, b, c);
    return taut_atan2(taut_length(c), fabs(taut_dot(a, b)));
}

/* fmax passes over the NaN of a point where a figure is undefined. */
static void extremes_along(const taut_line *line, const taut_parameters *along,
                           const double *normals, double length, taut_edge_measure *measure)
{
    const double largest = taut_line_curvature(line, along);

    measure->max_abs_normal_curvature = measure->max_angle_normal_binormal = nan("");
    for (int i = 0; i < along->count; i++) {
        const double *n = normals + 3 * (int64_t)i;
        taut_bend bend;
        taut_line_bend(line, along->span[i], along->t[i], 2, &bend);
        if (isnan(n[0]) || isnan(bend.curvature)) {
            continue;
        }
        const double k = taut_dot(bend.d[2], n) / bend.speed / bend.speed;
        measure->max_abs_normal_curvature =
            fmax(measure->max_abs_normal_curvature, ldexp(fabs(k), -line->scale));
        if (!taut_bend_is_straight(&bend, largest, length)) {
            measure->max_angle_normal_binormal =
                fmax(measure->max_angle_normal_binormal, angle_between_lines(n, bend.binormal));
        }
    }
}

/* Length, normal curvature and angle along one edge, 0..3 in the order of taut_edge. */
static taut_status measure_edge(taut_arena *arena, const taut_surface *surface, int edge, int grid,
                                taut_edge_measure *measure)
{
    const taut_basis *basis = edge < 2 ? taut_surface_v(surface) : taut_surface_u(surface);
    const taut_parameters *along = taut_parameters_new(arena, basis, grid, 0);
    taut_line line;

    if (along == NULL || taut_line_of_edge(arena, surface, edge, &line) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const double *normals = normals_along(arena, surface, edge, along);
    if (normals == NULL || taut_line_length(&line, &measure->length) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    extremes_along(&line, along, normals, ldexp(measure->length, -line.scale), measure);
    return TAUT_OK;
}

/* All but the options' range; what fails here is memory. */
static taut_status measure_surface(taut_arena *arena, const taut_surface *surface,
                                   const taut_measure_options *options, const taut_crew *crew,
                                   taut_surface_measure *measure)
{
    taut_extremes extremes;
    taut_surface_integrals integrals;

    if (taut_surface_integrals_of(surface, 2, crew, &integrals) != TAUT_OK ||
        taut_extremes_of(surface, options->grid, crew, &extremes) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int edge = 0; edge < 4; edge++) {
        if (measure_edge(arena, surface, edge, options->grid, &measure->edges[edge]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        if (taut_pulse_report(crew->pulse)) {
            return TAUT_INTERRUPTED;
        }
    }
    taut_box_of(surface, crew, measure->box);
    take_figures(&integrals, &extremes, measure);
    return taut_jacobian_of(surface, crew->pulse, &measure->jacobian);
}

taut_status taut_measure_surface(const taut_surface *surface, const taut_measure_options *options,
                                 taut_surface_measure *measure, taut_error *error)
{
    taut_measure_options settled;
    taut_surface_measure made;
    taut_status status = TAUT_OK;

    if (surface == NULL || measure == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "measuring needs a surface and a place for its figures");
    }
    status = settle_options(options, &settled, error);
    if (status != TAUT_OK) {
        return status;
    }
    memset(&made, 0, sizeof made);
    taut_pulse pulse = {.monitor = &settled.monitor, .what = "measuring", .done = NAN};
    const taut_crew crew = {settled.threads, &pulse};
    if (!taut_pulse_report(&pulse)) {
        taut_arena *arena = taut_arena_new();
        status = measure_surface(arena, surface, &settled, &crew, &made);
        taut_arena_free(arena);
    }
    if (pulse.is_stopped) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    *measure = made;
    return TAUT_OK;
}

/* tau = (x' x x'') . x''' / |x' x x''|^2, left out where the curve is straight. */
static double torsion_along(const taut_line *line, const taut_parameters *lines, double curvature,
                            double length)
{
    double largest = nan("");
    for (int i = 0; i < lines->count; i++) {
        taut_bend bend;
        taut_line_bend(line, lines->span[i], lines->t[i], 3, &bend);
        if (!taut_bend_is_straight(&bend, curvature, length)) {
            largest = fmax(largest, fabs(taut_dot(bend.binormal, bend.d[3])) /
                                        taut_dot(bend.binormal, bend.binormal));
        }
    }
    return largest;
}

static taut_status measure_curve(taut_arena *arena, const taut_curve *curve, int grid,
                                 taut_curve_measure *measure)
{
    const taut_parameters *parameters = taut_parameters_new(arena, taut_curve_t(curve), grid, 0);
    taut_line line;
    double length = 0;

    if (parameters == NULL || taut_line_of_curve(arena, curve, &line) != TAUT_OK ||
        taut_line_length(&line, &length) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const double curvature = taut_line_curvature(&line, parameters);
    measure->length = length;
    measure->max_curvature = ldexp(curvature, -line.scale);
    measure->max_torsion =
        ldexp(torsion_along(&line, parameters, curvature, ldexp(length, -line.scale)), -line.scale);
    return TAUT_OK;
}

taut_status taut_measure_curve(const taut_curve *curve, const taut_measure_options *options,
                               taut_curve_measure *measure, taut_error *error)
{
    taut_measure_options settled;
    taut_status status = TAUT_OK;

    if (curve == NULL || measure == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "measuring needs a curve and a place for its figures");
    }
    status = settle_options(options, &settled, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_pulse pulse = {.monitor = &settled.monitor, .what = "measuring", .done = NAN};
    if (taut_pulse_report(&pulse)) {
        return taut_fail_status(error, TAUT_INTERRUPTED);
    }
    taut_arena *arena = taut_arena_new();
    status = measure_curve(arena, curve, settled.grid, measure);
    taut_arena_free(arena);
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}
