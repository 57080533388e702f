/* surface.c -- taut/operations.h for surfaces: a change of basis along one direction, applied
 * to every row of control points. */
#include "taut/operations.h"

#include "core/fail.h"
#include "core/memory.h"
#include "geometry/lattice.h"
#include "geometry/operate/change.h"
#include "geometry/operate/points.h"

#include <string.h>

/* Nothing missing, and a direction that is one? */
static int is_asked(const taut_surface *surface, int direction, const void *result)
{
    return surface != NULL && result != NULL &&
           (direction == TAUT_ALONG_U || direction == TAUT_ALONG_V);
}

/* The surface after `change`, which is freed; passes a failed status on. */
static taut_status apply_change(taut_status status, const taut_surface *surface, int direction,
                                taut_change *change, taut_surface **result, taut_error *error)
{
    if (status != TAUT_OK) {
        return status;
    }
    status =
        taut_surface_changed(surface, direction, change, taut_surface_name(surface), result, error);
    taut_change_free(change);
    return status;
}

static taut_status add_changed(const taut_surface *surface, int direction,
                               const taut_change *change, int i, taut_model *model,
                               taut_error *error)
{
    char name[TAUT_NAME_MAX + 1];
    taut_surface *piece = NULL;
    taut_operate_piece_name(taut_surface_name(surface), 1, i, name);
    const taut_status status =
        taut_surface_changed(surface, direction, change, name, &piece, error);
    return status == TAUT_OK ? taut_operate_add_surface(model, piece, error) : status;
}

taut_status taut_surface_split(const taut_surface *surface, int direction, double t,
                               taut_model **pieces, taut_error *error)
{
    taut_change_list list = {0, NULL};
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (!is_asked(surface, direction, pieces)) {
        return taut_operate_null(error);
    }
    status = taut_operate_split(taut_surface_along(surface, direction), t, &list, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_model_new(&made) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    for (int i = 0; status == TAUT_OK && i < list.count; i++) {
        status = add_changed(surface, direction, list.items[i], i, made, error);
    }
    taut_change_list_free(&list);
    return taut_operate_end(status, made, pieces);
}

/* Adds patch i of the surface, out of a strip whose basis along u is its own already. */
static taut_status add_patch(const taut_surface *surface, const taut_lattice *strip,
                             const taut_basis *u, const taut_change *along, int i,
                             taut_model *model, taut_error *error)
{
    char name[TAUT_NAME_MAX + 1];
    taut_lattice patch;
    taut_surface *piece = NULL;
    taut_status status = taut_lattice_change(strip, TAUT_ALONG_V, along, &patch, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_operate_piece_name(taut_surface_name(surface), 1, i, name);
    status = taut_lattice_into_surface(&patch, name, u, along->to, &piece, error);
    return status == TAUT_OK ? taut_operate_add_surface(model, piece, error) : status;
}

/* Adds strip i of the surface, whose points `whole` holds, patch by patch. */
static taut_status add_strip(const taut_surface *surface, const taut_lattice *whole,
                             const taut_change *across, const taut_change_list *along, int i,
                             taut_model *model, taut_error *error)
{
    taut_lattice strip;
    taut_status status = taut_lattice_change(whole, TAUT_ALONG_U, across, &strip, error);

    for (int j = 0; status == TAUT_OK && j < along->count; j++) {
        status = add_patch(surface, &strip, across->to, along->items[j], i * along->count + j,
                           model, error);
    }
    taut_lattice_free(&strip);
    return status;
}

/* What taut_surface_pieces works with, and frees. */
typedef struct cutting {
    taut_change_list across, along;
    taut_lattice whole;
    taut_model *made;
} cutting;

static taut_status cut_into_patches(const taut_surface *surface, cutting *c, taut_error *error)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    taut_status status = u->ops->changes->pieces(u, &c->across, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = v->ops->changes->pieces(v, &c->along, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_new(&c->made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_lattice_of_surface(surface, &c->whole, error);
    for (int i = 0; status == TAUT_OK && i < c->across.count; i++) {
        status = add_strip(surface, &c->whole, c->across.items[i], &c->along, i, c->made, error);
    }
    return status;
}

taut_status taut_surface_pieces(const taut_surface *surface, taut_model **pieces, taut_error *error)
{
    cutting c = {.made = NULL};
    taut_status status = TAUT_OK;

    if (surface == NULL || pieces == NULL) {
        return taut_operate_null(error);
    }
    const double patches = (double)taut_basis_span_count(taut_surface_u(surface)) *
                           taut_basis_span_count(taut_surface_v(surface));
    if (patches > TAUT_OBJECTS_MAX) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-many-objects", NULL, patches,
                         TAUT_OBJECTS_MAX, "%.0f pieces, but a model holds at most %d surfaces",
                         patches, TAUT_OBJECTS_MAX);
    }
    status = cut_into_patches(surface, &c, error);
    taut_change_list_free(&c.across);
    taut_change_list_free(&c.along);
    taut_lattice_free(&c.whole);
    return taut_operate_end(status, c.made, pieces);
}

taut_status taut_surface_refine(const taut_surface *surface, int direction, taut_surface **refined,
                                taut_error *error)
{
    taut_change *change = NULL;
    taut_status status = TAUT_OK;
    if (!is_asked(surface, direction, refined)) {
        return taut_operate_null(error);
    }
    const taut_basis *basis = taut_surface_along(surface, direction);
    status = basis->ops->changes->halve(basis, &change, error);
    return apply_change(status, surface, direction, change, refined, error);
}

taut_status taut_surface_insert(const taut_surface *surface, int direction, double t, int times,
                                taut_surface **refined, taut_error *error)
{
    taut_change *change = NULL;
    taut_status status = TAUT_OK;
    if (!is_asked(surface, direction, refined)) {
        return taut_operate_null(error);
    }
    status = taut_operate_insert(taut_surface_along(surface, direction), t, times, &change, error);
    return apply_change(status, surface, direction, change, refined, error);
}

taut_status taut_surface_elevate(const taut_surface *surface, int direction, int times,
                                 taut_surface **raised, taut_error *error)
{
    taut_change *change = NULL;
    taut_status status = TAUT_OK;
    if (!is_asked(surface, direction, raised)) {
        return taut_operate_null(error);
    }
    status = taut_operate_elevate(taut_surface_along(surface, direction), times, &change, error);
    return apply_change(status, surface, direction, change, raised, error);
}

taut_status taut_surface_reverse(const taut_surface *surface, int direction,
                                 taut_surface **reversed, taut_error *error)
{
    taut_change *change = NULL;
    taut_status status = TAUT_OK;
    if (!is_asked(surface, direction, reversed)) {
        return taut_operate_null(error);
    }
    const taut_basis *basis = taut_surface_along(surface, direction);
    status = basis->ops->changes->reverse(basis, &change, error);
    return apply_change(status, surface, direction, change, reversed, error);
}

taut_status taut_surface_rerange(const taut_surface *surface, int direction, double lo, double hi,
                                 taut_surface **moved, taut_error *error)
{
    taut_change *change = NULL;
    taut_status status = TAUT_OK;
    if (!is_asked(surface, direction, moved)) {
        return taut_operate_null(error);
    }
    status = taut_operate_rerange(taut_surface_along(surface, direction), lo, hi, &change, error);
    return apply_change(status, surface, direction, change, moved, error);
}

/* to[j][i] = from[i][j], each of dim numbers. */
static void transpose(int rows, int columns, size_t dim, const double *from, double *to)
{
    for (size_t i = 0; i < (size_t)rows; i++) {
        for (size_t j = 0; j < (size_t)columns; j++) {
            memcpy(to + (j * (size_t)rows + i) * dim, from + (i * (size_t)columns + j) * dim,
                   dim * sizeof(double));
        }
    }
}

taut_status taut_surface_transpose(const taut_surface *surface, taut_surface **transposed,
                                   taut_error *error)
{
    double *memory = NULL, *weights = NULL;
    taut_status status = TAUT_OK;

    if (surface == NULL || transposed == NULL) {
        return taut_operate_null(error);
    }
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int nu = taut_basis_count(u), nv = taut_basis_count(v);
    memory = taut_alloc(4 * (size_t)nu * (size_t)nv, sizeof(double));
    if (memory == NULL) {
        return taut_fail_memory(error);
    }
    transpose(nu, nv, 3, taut_surface_points(surface), memory);
    if (taut_surface_weights(surface) != NULL) {
        weights = memory + 3 * (size_t)nu * (size_t)nv;
        transpose(nu, nv, 1, taut_surface_weights(surface), weights);
    }
    status = taut_surface_new(taut_surface_name(surface), v, u, memory, weights, transposed, error);
    taut_free(memory);
    return status;
}

taut_status taut_surface_transform(const taut_surface *surface, const double *matrix,
                                   taut_surface **moved, taut_error *error)
{
    double *points = NULL;
    taut_status status = TAUT_OK;
    if (surface == NULL || matrix == NULL || moved == NULL) {
        return taut_operate_null(error);
    }
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    status = taut_operate_points(matrix, (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v),
                                 taut_surface_points(surface), &points, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_new(taut_surface_name(surface), u, v, points,
                              taut_surface_weights(surface), moved, error);
    taut_free(points);
    return status;
}
