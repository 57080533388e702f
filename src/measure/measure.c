/* measure.c -- all figures of a surface, and of a curve. */
#include "taut/measure.h"

#include "core/fail.h"
#include "measure/curvature/box.h"
#include "measure/curvature/edge.h"
#include "measure/curvature/extremes.h"
#include "measure/integrate/integrals.h"

#include <math.h>
#include <string.h>

enum { GRID = 101 };

/* The options with their defaults filled in. */
static taut_status settle(const taut_measure_options *given, taut_measure_options *options,
                          taut_error *error)
{
    *options = given != NULL ? *given : (taut_measure_options){0, 0};
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
    measure->bending_energy = figures->bending;
    measure->mean_abs_mean = figures->mean_abs;
    measure->isothermality = figures->isothermality;
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

taut_status taut_measure_surface(const taut_surface *surface, const taut_measure_options *options,
                                 taut_surface_measure *measure, taut_error *error)
{
    taut_measure_options settled;
    taut_surface_measure made;
    taut_extremes extremes;
    taut_surface_integrals figures;
    taut_status status = TAUT_OK;

    if (surface == NULL || measure == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "measuring needs a surface and a place for its figures");
    }
    status = settle(options, &settled, error);
    if (status != TAUT_OK) {
        return status;
    }
    memset(&made, 0, sizeof made);
    status = taut_surface_integrals_of(surface, settled.threads, &figures);
    if (status == TAUT_OK) {
        status = taut_extremes_of(surface, settled.grid, settled.threads, &extremes);
    }
    for (int edge = 0; status == TAUT_OK && edge < 4; edge++) {
        status = taut_edge_measure_of(surface, edge, settled.grid, &made.edges[edge]);
    }
    if (status == TAUT_OK) {
        status = taut_surface_jacobian(surface, &made.jacobian);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_box_of(surface, made.box);
    take_figures(&figures, &extremes, &made);
    *measure = made;
    return TAUT_OK;
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
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
            largest = fmax(largest,
                           fabs(dot(bend.binormal, bend.d[3])) / dot(bend.binormal, bend.binormal));
        }
    }
    return largest;
}

taut_status taut_measure_curve(const taut_curve *curve, const taut_measure_options *options,
                               taut_curve_measure *measure, taut_error *error)
{
    taut_measure_options settled;
    taut_line line = {.net = NULL};
    taut_parameters *lines = NULL;
    double length = 0;
    taut_status status = TAUT_OK;

    if (curve == NULL || measure == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "measuring needs a curve and a place for its figures");
    }
    status = settle(options, &settled, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_line_of_curve(curve, &line);
    if (status == TAUT_OK) {
        status = taut_parameters_new(taut_curve_t(curve), settled.grid, 0, &lines);
    }
    if (status == TAUT_OK) {
        status = taut_line_length(&line, &length);
    }
    if (status == TAUT_OK) {
        const double curvature = taut_line_curvature(&line, lines);
        measure->length = length;
        measure->max_curvature = ldexp(curvature, -line.scale);
        measure->max_torsion =
            ldexp(torsion_along(&line, lines, curvature, ldexp(length, -line.scale)), -line.scale);
    } else {
        status = taut_fail_memory(error);
    }
    taut_parameters_free(lines);
    taut_line_free(&line);
    return status;
}
