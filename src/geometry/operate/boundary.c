/* boundary.c -- the curves that a boundary may be made of: those of a model, and the edges of its surfaces, each the outermost row
 * of its net, where it is the edge: at the middle of it the row's curve meets the surface. */
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "taut/join.h"
#include "taut/limits.h"
#include "taut/operations.h"

#include <stdio.h>
#include <string.h>

static const double near_enough = 1e-12; /* of the size: roundings of a point */

/* The row of the net along edge e: its first point, the step to the next, and how many. */
typedef struct edge_row {
    const taut_basis *basis;
    size_t first, step, count;
} edge_row;

static edge_row row_of(const taut_surface *surface, taut_edge edge)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const size_t nu = (size_t)taut_basis_count(u), nv = (size_t)taut_basis_count(v);
    const edge_row rows[4] = {[TAUT_EDGE_U0] = {v, 0, 1, nv},
                              [TAUT_EDGE_U1] = {v, (nu - 1) * nv, 1, nv},
                              [TAUT_EDGE_V0] = {u, 0, nv, nu},
                              [TAUT_EDGE_V1] = {u, nv - 1, nv, nu}};
    return rows[edge];
}

static taut_status make_curve(const taut_surface *surface, const edge_row *row, const char *name,
                              taut_curve **curve)
{
    const double *net = taut_surface_points(surface), *weights = taut_surface_weights(surface);
    double *points = taut_alloc(row->count, 3 * sizeof *points);
    double *own = weights != NULL ? taut_alloc(row->count, sizeof *own) : NULL;
    taut_status status = TAUT_NO_MEMORY;

    if (points != NULL && (own != NULL || weights == NULL)) {
        for (size_t k = 0; k < row->count; k++) {
            const size_t at = row->first + k * row->step;
            memcpy(points + 3 * k, net + 3 * at, 3 * sizeof *points);
            if (own != NULL) {
                own[k] = weights[at];
            }
        }
        status = taut_curve_new(name, row->basis, points, own, curve, NULL);
    }
    taut_free(points);
    taut_free(own);
    return status;
}

static double middle_of(const taut_basis *basis)
{
    return 0.5 * taut_basis_lo(basis) + 0.5 * taut_basis_hi(basis);
}

/* Is the curve the edge, and no single point? */
static int is_edge(const taut_surface *surface, taut_edge edge, const taut_curve *curve)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const double *points = taut_surface_points(surface), *row = taut_curve_points(curve);
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve));
    const double size = 2 * taut_half_size(taut_point_count(surface), points);
    const int held = edge >= TAUT_EDGE_V0;
    double at[2], x[3], y[3];

    at[held] = edge % 2 ? taut_basis_hi(bases[held]) : taut_basis_lo(bases[held]);
    at[!held] = middle_of(bases[!held]);
    return 2 * taut_half_size(count, row) > near_enough * size &&
           taut_surface_eval(surface, at[0], at[1], 0, x) == TAUT_OK &&
           taut_curve_eval(curve, at[!held], 0, y) == TAUT_OK &&
           taut_distance(x, y) <= near_enough * (size + taut_norm(x));
}

/* Takes the curve over, also where it fails. */
static taut_status add_curve(taut_model *curves, taut_curve *curve, taut_error *error)
{
    if (taut_model_curve_count(curves) >= TAUT_OBJECTS_MAX) {
        taut_curve_free(curve);
        return taut_fail(error, TAUT_NO_SOLUTION, "too-many-objects", NULL, TAUT_OBJECTS_MAX + 1.0,
                         TAUT_OBJECTS_MAX,
                         "more than %d curves and edges in one model, expected at most so many",
                         TAUT_OBJECTS_MAX);
    }
    if (taut_model_add_curve(curves, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

static taut_status add_edges(const taut_surface *surface, int number, taut_model *curves,
                             taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int e = TAUT_EDGE_U0; e <= TAUT_EDGE_V1 && status == TAUT_OK; e++) {
        const edge_row row = row_of(surface, (taut_edge)e);
        const char *own = taut_surface_name(surface);
        char name[TAUT_NAME_MAX + 32];
        taut_curve *curve = NULL;
        if (own[0] != '\0') {
            snprintf(name, sizeof name, "%.250s.%s", own, taut_edge_name((taut_edge)e));
        } else {
            snprintf(name, sizeof name, "surface%d.%s", number, taut_edge_name((taut_edge)e));
        }
        if (make_curve(surface, &row, name, &curve) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        if (is_edge(surface, (taut_edge)e, curve)) {
            status = add_curve(curves, curve, error);
        } else {
            taut_curve_free(curve);
        }
    }
    return status;
}

static taut_status add_all(const taut_model *model, taut_model *curves, taut_error *error)
{
    taut_status status = taut_model_set_unit(curves, taut_model_unit(model));
    for (int i = 0; i < taut_model_curve_count(model) && status == TAUT_OK; i++) {
        taut_curve *curve = NULL;
        if (taut_curve_copy(taut_model_curve(model, i), &curve) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        status = add_curve(curves, curve, error);
    }
    for (int i = 0; i < taut_model_surface_count(model) && status == TAUT_OK; i++) {
        status = add_edges(taut_model_surface(model, i), i + 1, curves, error);
    }
    return status;
}

taut_status taut_model_boundary(const taut_model *model, taut_model **curves, taut_error *error)
{
    taut_model *made = NULL;
    if (model == NULL || curves == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "curves and edges need a model and a place");
    }
    if (taut_model_new(&made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    const taut_status status = add_all(model, made, error);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *curves = made;
    return TAUT_OK;
}
