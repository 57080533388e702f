/* panels.c -- a panel's plane has the normal of its diagonals; x is its first side that is not a point. */
#include "io/dxf/panels.h"

#include "core/vec3.h"

#include <string.h>

int taut_is_panels(const taut_model *model, int i)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *kind = details != NULL ? taut_record_get(details, "panels") : NULL;
    const taut_surface *surface = taut_model_surface(model, i);
    return kind != NULL && taut_record_kind_of(kind) == TAUT_RECORD_TEXT &&
           taut_surface_weights(surface) == NULL &&
           taut_basis_degree(taut_surface_u(surface)) == 1 &&
           taut_basis_degree(taut_surface_v(surface)) == 1;
}

/* The corners of a cell around it, those at the place of the one before left out. */
static int corners_of(const taut_surface *surface, int i, int j, double corners[4][3])
{
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    const size_t first = (size_t)i * nv + (size_t)j;
    const size_t at[4] = {first, first + nv, first + nv + 1, first + 1};
    int count = 0;
    for (int k = 0; k < 4; k++) {
        const double *point = taut_surface_points(surface) + 3 * at[k];
        if (count == 0 || memcmp(point, corners[count - 1], 3 * sizeof *point) != 0) {
            memcpy(corners[count++], point, 3 * sizeof *point);
        }
    }
    return count > 1 && memcmp(corners[0], corners[count - 1], 3 * sizeof(double)) == 0 ? count - 1
                                                                                        : count;
}

static void make_unit(double v[3])
{
    const double length = taut_norm(v);
    for (int c = 0; c < 3; c++) {
        v[c] = length > 0 ? v[c] / length : 0;
    }
}

/* x along the first side, y square to it in the plane; of fewer than three corners y is 0. */
static void frame_of(double corners[4][3], int count, double x[3], double y[3])
{
    double p[3] = {0, 0, 0}, q[3] = {0, 0, 0}, normal[3];
    taut_difference(corners[1], corners[0], x);
    make_unit(x);
    if (count > 2) {
        taut_difference(corners[2], corners[0], p);
        taut_difference(corners[count - 1], corners[1], q);
    }
    taut_cross(p, q, normal);
    make_unit(normal);
    taut_cross(normal, x, y);
    make_unit(y);
}

taut_flat_panel taut_lay_flat(const taut_surface *surface, int i, int j)
{
    double corners[4][3], x[3], y[3], low[2] = {INFINITY, INFINITY};
    taut_flat_panel panel = {.count = corners_of(surface, i, j, corners)};
    if (panel.count < 2) {
        return panel;
    }
    frame_of(corners, panel.count, x, y);
    for (int k = 0; k < panel.count; k++) {
        double d[3];
        taut_difference(corners[k], corners[0], d);
        panel.corners[k][0] = taut_dot(d, x);
        panel.corners[k][1] = taut_dot(d, y);
        low[0] = fmin(low[0], panel.corners[k][0]);
        low[1] = fmin(low[1], panel.corners[k][1]);
    }
    for (int k = 0; k < panel.count; k++) {
        for (int c = 0; c < 2; c++) {
            panel.corners[k][c] -= low[c];
            panel.size[c] = fmax(panel.size[c], panel.corners[k][c]);
        }
    }
    return panel;
}
