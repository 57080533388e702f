#include "geometry/lattice.h"

#include "core/fail.h"
#include "core/memory.h"
#include "geometry/net.h"
#include "taut/operations.h"

#include <string.h>

static size_t point_count(const taut_lattice *lattice)
{
    return (size_t)lattice->count[0] * (size_t)lattice->count[1];
}

/* Takes memory; the counts and dim are in place. */
static taut_status take_net(taut_lattice *lattice, taut_error *error)
{
    if (point_count(lattice) > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-many-points", NULL,
                         (double)point_count(lattice), TAUT_POINTS_MAX,
                         "%zu control points, expected at most %d", point_count(lattice),
                         TAUT_POINTS_MAX);
    }
    lattice->net = taut_alloc_aligned(point_count(lattice) * (size_t)lattice->dim, sizeof(double));
    return lattice->net != NULL ? TAUT_OK : taut_fail_memory(error);
}

static taut_status fill_net(const double *points, const double *weights, taut_lattice *lattice,
                            taut_error *error)
{
    const taut_status status = take_net(lattice, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (weights != NULL) {
        taut_net_homogeneous(point_count(lattice), points, weights, lattice->net);
    } else {
        memcpy(lattice->net, points, 3 * point_count(lattice) * sizeof(double));
    }
    return TAUT_OK;
}

taut_status taut_lattice_of_curve(const taut_curve *curve, taut_lattice *lattice, taut_error *error)
{
    const double *weights = taut_curve_weights(curve);
    *lattice =
        (taut_lattice){{taut_basis_count(taut_curve_t(curve)), 1}, weights != NULL ? 4 : 3, NULL};
    return fill_net(taut_curve_points(curve), weights, lattice, error);
}

taut_status taut_lattice_of_surface(const taut_surface *surface, taut_lattice *lattice,
                                    taut_error *error)
{
    const double *weights = taut_surface_weights(surface);
    *lattice = (taut_lattice){
        {taut_basis_count(taut_surface_u(surface)), taut_basis_count(taut_surface_v(surface))},
        weights != NULL ? 4 : 3,
        NULL};
    return fill_net(taut_surface_points(surface), weights, lattice, error);
}

void taut_lattice_free(taut_lattice *lattice)
{
    taut_free(lattice->net);
    *lattice = (taut_lattice){{0, 0}, 0, NULL};
}

taut_status taut_lattice_change(const taut_lattice *in, int direction, const taut_change *change,
                                taut_lattice *out, taut_error *error)
{
    const size_t columns = (size_t)in->count[1], dim = (size_t)in->dim;
    taut_status status = TAUT_OK;

    *out = (taut_lattice){{in->count[0], in->count[1]}, in->dim, NULL};
    out->count[direction] = taut_basis_count(change->to);
    status = take_net(out, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (direction == TAUT_ALONG_U) {
        taut_change_apply(change, 1, in->count[0], columns * dim, in->net, out->net);
    } else {
        taut_change_apply(change, (size_t)in->count[0], in->count[1], dim, in->net, out->net);
    }
    return TAUT_OK;
}

/* Points and weights of a lattice: its own net without weights, else double[count][4] in *memory,
 * to be freed. */
static taut_status split_weights(const taut_lattice *lattice, const double **points,
                                 const double **weights, double **memory, taut_error *error)
{
    const size_t count = point_count(lattice);

    *points = lattice->net;
    if (lattice->dim == 3) {
        return TAUT_OK;
    }
    double *x = taut_alloc(4 * count, sizeof(double)), *w = x != NULL ? x + 3 * count : NULL;
    if (x == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        w[i] = lattice->net[4 * i + 3];
        for (size_t c = 0; c < 3; c++) {
            x[3 * i + c] = lattice->net[4 * i + c] / w[i];
        }
    }
    *points = *memory = x;
    *weights = w;
    return TAUT_OK;
}

taut_status taut_lattice_into_curve(taut_lattice *lattice, const char *name, const taut_basis *t,
                                    taut_curve **curve, taut_error *error)
{
    const double *points = NULL, *weights = NULL;
    double *memory = NULL;
    taut_status status = split_weights(lattice, &points, &weights, &memory, error);

    if (status == TAUT_OK) {
        status = taut_curve_new(name, t, points, weights, curve, error);
    }
    taut_free(memory);
    taut_lattice_free(lattice);
    return status;
}

taut_status taut_lattice_into_surface(taut_lattice *lattice, const char *name, const taut_basis *u,
                                      const taut_basis *v, taut_surface **surface,
                                      taut_error *error)
{
    const double *points = NULL, *weights = NULL;
    double *memory = NULL;
    taut_status status = split_weights(lattice, &points, &weights, &memory, error);

    if (status == TAUT_OK) {
        status = taut_surface_new(name, u, v, points, weights, surface, error);
    }
    taut_free(memory);
    taut_lattice_free(lattice);
    return status;
}

/* The lattice after a change, which takes its place; it is empty where that fails. */
static taut_status change_in_place(taut_lattice *lattice, int direction, const taut_change *change,
                                   taut_error *error)
{
    taut_lattice before = *lattice;
    const taut_status status = taut_lattice_change(&before, direction, change, lattice, error);
    taut_lattice_free(&before);
    return status;
}

taut_status taut_curve_changed(const taut_curve *curve, const taut_change *change, const char *name,
                               taut_curve **changed, taut_error *error)
{
    taut_lattice lattice;
    taut_status status = taut_lattice_of_curve(curve, &lattice, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = change_in_place(&lattice, TAUT_ALONG_U, change, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_lattice_into_curve(&lattice, name, change->to, changed, error);
}

taut_status taut_surface_changed(const taut_surface *surface, int direction,
                                 const taut_change *change, const char *name,
                                 taut_surface **changed, taut_error *error)
{
    const taut_basis *u = direction == TAUT_ALONG_U ? change->to : taut_surface_u(surface);
    const taut_basis *v = direction == TAUT_ALONG_V ? change->to : taut_surface_v(surface);
    taut_lattice lattice;
    taut_status status = taut_lattice_of_surface(surface, &lattice, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = change_in_place(&lattice, direction, change, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_lattice_into_surface(&lattice, name, u, v, changed, error);
}

const taut_basis *taut_surface_along(const taut_surface *surface, int direction)
{
    return direction == TAUT_ALONG_U ? taut_surface_u(surface) : taut_surface_v(surface);
}
