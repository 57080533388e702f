/* edge.c -- what is measured along one edge of a surface.
 *
 * With the edge curve x(t), the surface's unit normal n and the curve's binormal b = x' x x'',
 *     k_n = x''.n / |x'|^2,    angle of n and b = atan2(|n x b|, |n.b|) in [0, pi/2].
 */
#include "measure/curvature/edge.h"

#include "core/memory.h"
#include "measure/curvature/scan.h"

#include <math.h>

/* The surface's normals along an edge, entry by entry of the grid along it: double[count][3], NaN
 * where there is none. */
static taut_status normals_along(const taut_surface *surface, int edge,
                                 const taut_parameters *along, double *normals)
{
    const int held = taut_edge_held(edge);
    const taut_basis *basis = held == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    taut_parameters *across = NULL;
    taut_scan *scan = NULL;
    double *scratch = NULL, *values = NULL;
    taut_status status = taut_parameters_new(basis, 1, taut_edge_at(surface, edge), &across);

    if (status == TAUT_OK) {
        status = held == 0 ? taut_scan_new(surface, across, along, &scan)
                           : taut_scan_new(surface, along, across, &scan);
    }
    if (status == TAUT_OK) {
        scratch = taut_alloc_aligned(taut_scan_scratch(scan), sizeof(double));
        values = taut_alloc_aligned((size_t)along->count * 18, sizeof(double));
        status = scratch != NULL && values != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        for (int i = 0; i < scan->u->count; i++) {
            taut_scan_line(scan, i, scratch, values + (held == 0 ? 0 : 18 * (long)i));
        }
        for (int i = 0; i < along->count; i++) {
            taut_forms forms;
            taut_forms_of((const double(*)[3])(values + 18 * (long)i), &forms);
            for (int c = 0; c < 3; c++) {
                normals[3 * (long)i + c] = forms.normal[c];
            }
        }
    }
    taut_free(scratch);
    taut_free(values);
    taut_scan_free(scan);
    taut_parameters_free(across);
    return status;
}

static double angle_between_lines(const double *a, const double *b)
{
    const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return atan2(sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]), fabs(dot));
}

/* fmax passes over the NaN of a point where a figure is undefined. */
static void extremes_along(const taut_line *line, const taut_parameters *along,
                           const double *normals, double length, taut_edge_measure *measure)
{
    const double largest = taut_line_curvature(line, along);

    measure->max_abs_normal_curvature = measure->max_angle_normal_binormal = nan("");
    for (int i = 0; i < along->count; i++) {
        const double *n = normals + 3 * (long)i;
        taut_bend bend;
        taut_line_bend(line, along->span[i], along->t[i], 2, &bend);
        if (isnan(n[0]) || isnan(bend.curvature)) {
            continue;
        }
        const double *b = bend.d[2];
        const double k = (b[0] * n[0] + b[1] * n[1] + b[2] * n[2]) / bend.speed / bend.speed;
        measure->max_abs_normal_curvature =
            fmax(measure->max_abs_normal_curvature, ldexp(fabs(k), -line->scale));
        if (!taut_bend_is_straight(&bend, largest, length)) {
            measure->max_angle_normal_binormal =
                fmax(measure->max_angle_normal_binormal, angle_between_lines(n, bend.binormal));
        }
    }
}

taut_status taut_edge_measure_of(const taut_surface *surface, int edge, int grid,
                                 taut_edge_measure *measure)
{
    const int runs = 1 - taut_edge_held(edge);
    const taut_basis *basis = runs == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    taut_line line = {.net = NULL};
    taut_parameters *along = NULL;
    double *normals = NULL;
    taut_status status = taut_line_of_edge(surface, edge, &line);

    if (status == TAUT_OK) {
        status = taut_parameters_new(basis, grid, 0, &along);
    }
    if (status == TAUT_OK) {
        normals = taut_alloc((size_t)along->count, 3 * sizeof(double));
        status = normals != NULL ? normals_along(surface, edge, along, normals) : TAUT_NO_MEMORY;
    }
    if (status == TAUT_OK) {
        status = taut_line_length(&line, &measure->length);
    }
    if (status == TAUT_OK) {
        extremes_along(&line, along, normals, ldexp(measure->length, -line.scale), measure);
    }
    taut_free(normals);
    taut_parameters_free(along);
    taut_line_free(&line);
    return status;
}
