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

/* The surface after *change, which is freed; passes a failed status on. */
static taut_status apply_change(taut_status status, const taut_surface *surface, int direction,
                                taut_change *const *change, taut_surface **result,
                                taut_error *error)
{
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_surface_changed(surface, direction, *change, taut_surface_name(surface), result,
                                  error);
    taut_change_free(*change);
    return status;
}

/* Part i of the surface, added to a model. */
static taut_status add_part(const taut_surface *surface, int direction, const taut_change *change,
                            int dashes, int i, taut_model *model, taut_error *error)
{
    char name[TAUT_NAME_MAX + 1];
    taut_surface *part = NULL;
    taut_operate_piece_name(taut_surface_name(surface), dashes, i, name);
    const taut_status status = taut_surface_changed(surface, direction, change, name, &part, error);
    return status == TAUT_OK ? taut_operate_add_surface(model, part, error) : status;
}

taut_status taut_operate_add_surface_parts(const taut_surface *surface, int direction,
                                           const taut_change_list *list, int dashes, taut_model *to,
                                           taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int i = 0; status == TAUT_OK && i < list->count; i++) {
        status = add_part(surface, direction, list->items[i], dashes, i, to, error);
    }
    return status;
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
    status = taut_model_new(&made) == TAUT_OK
                 ? taut_operate_add_surface_parts(surface, direction, &list, 1, made, error)
                 : taut_fail_memory(error);
    taut_change_list_free(&list);
    return taut_operate_end(status, made, pieces);
}

/* What cutting into patches works with, and frees. */
typedef struct cutting {
    const taut_surface *surface;
    taut_change_list across, along;
    taut_lattice whole;
    int dashes;
    taut_pulse *pulse;
    taut_model *to;
} cutting;

enum { PATCH_WORK = 5000 }; /* operations of a patch, as pulses count them */

/* Adds patch i, out of a strip whose basis along u is its own already. */
static taut_status add_patch(const cutting *c, const taut_lattice *strip, const taut_basis *u,
                             const taut_change *along, int i, taut_error *error)
{
    char name[TAUT_NAME_MAX + 1];
    taut_lattice patch;
    taut_surface *piece = NULL;
    taut_status status = taut_lattice_change(strip, TAUT_ALONG_V, along, &patch, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_operate_piece_name(taut_surface_name(c->surface), c->dashes, i, name);
    status = taut_lattice_into_surface(&patch, name, u, along->to, &piece, error);
    return status == TAUT_OK ? taut_operate_add_surface(c->to, piece, error) : status;
}

/* Adds strip i, patch by patch. */
static taut_status add_strip(const cutting *c, int i, taut_error *error)
{
    const taut_change *across = c->across.items[i];
    taut_lattice strip;
    taut_status status = taut_lattice_change(&c->whole, TAUT_ALONG_U, across, &strip, error);

    for (int j = 0; status == TAUT_OK && j < c->along.count; j++) {
        status = add_patch(c, &strip, across->to, c->along.items[j], i * c->along.count + j, error);
        if (status == TAUT_OK && taut_pulse_beat(c->pulse, PATCH_WORK)) {
            status = taut_fail_status(error, TAUT_INTERRUPTED);
        }
    }
    taut_lattice_free(&strip);
    return status;
}

static taut_status cut_into_patches(cutting *c, taut_error *error)
{
    const taut_basis *u = taut_surface_u(c->surface), *v = taut_surface_v(c->surface);
    taut_status status = u->ops->changes->pieces(u, &c->across, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = v->ops->changes->pieces(v, &c->along, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_lattice_of_surface(c->surface, &c->whole, error);
    for (int i = 0; status == TAUT_OK && i < c->across.count; i++) {
        status = add_strip(c, i, error);
    }
    return status;
}

taut_status taut_operate_add_patches(const taut_surface *surface, int dashes, taut_pulse *pulse,
                                     taut_model *to, taut_error *error)
{
    cutting c = {.surface = surface, .dashes = dashes, .pulse = pulse, .to = to};
    const double patches = (double)taut_basis_span_count(taut_surface_u(surface)) *
                           taut_basis_span_count(taut_surface_v(surface));
    if (patches > TAUT_OBJECTS_MAX) {
        return taut_fail(error, TAUT_NO_SOLUTION, "too-many-objects", NULL, patches,
                         TAUT_OBJECTS_MAX, "%.0f pieces, but a model holds at most %d surfaces",
                         patches, TAUT_OBJECTS_MAX);
    }
    const taut_status status = cut_into_patches(&c, error);
    taut_change_list_free(&c.across);
    taut_change_list_free(&c.along);
    taut_lattice_free(&c.whole);
    return status;
}

taut_status taut_surface_pieces(const taut_surface *surface, taut_model **pieces, taut_error *error)
{
    return taut_operate_pieces(surface, NULL, pieces, error);
}

taut_status taut_operate_pieces(const taut_surface *surface, taut_pulse *pulse, taut_model **pieces,
                                taut_error *error)
{
    taut_model *made = NULL;

    if (surface == NULL || pieces == NULL) {
        return taut_operate_null(error);
    }
    if (taut_model_new(&made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return taut_operate_end(taut_operate_add_patches(surface, 1, pulse, made, error), made, pieces);
}

taut_status taut_surface_refine(const taut_surface *surface, int direction, taut_surface **refined,
                                taut_error *error)
{
    taut_change *change = NULL;
    if (!is_asked(surface, direction, refined)) {
        return taut_operate_null(error);
    }
    const taut_basis *basis = taut_surface_along(surface, direction);
    return apply_change(basis->ops->changes->halve(basis, &change, error), surface, direction,
                        &change, refined, error);
}

taut_status taut_surface_insert(const taut_surface *surface, int direction, double t, int times,
                                taut_surface **refined, taut_error *error)
{
    taut_change *change = NULL;
    if (!is_asked(surface, direction, refined)) {
        return taut_operate_null(error);
    }
    return apply_change(
        taut_operate_insert(taut_surface_along(surface, direction), t, times, &change, error),
        surface, direction, &change, refined, error);
}

taut_status taut_surface_elevate(const taut_surface *surface, int direction, int times,
                                 taut_surface **raised, taut_error *error)
{
    taut_change *change = NULL;
    if (!is_asked(surface, direction, raised)) {
        return taut_operate_null(error);
    }
    return apply_change(
        taut_operate_elevate(taut_surface_along(surface, direction), times, &change, error),
        surface, direction, &change, raised, error);
}

taut_status taut_surface_reverse(const taut_surface *surface, int direction,
                                 taut_surface **reversed, taut_error *error)
{
    taut_change *change = NULL;
    if (!is_asked(surface, direction, reversed)) {
        return taut_operate_null(error);
    }
    const taut_basis *basis = taut_surface_along(surface, direction);
    return apply_change(basis->ops->changes->reverse(basis, &change, error), surface, direction,
                        &change, reversed, error);
}

taut_status taut_surface_rerange(const taut_surface *surface, int direction, double lo, double hi,
                                 taut_surface **moved, taut_error *error)
{
    taut_change *change = NULL;
    if (!is_asked(surface, direction, moved)) {
        return taut_operate_null(error);
    }
    return apply_change(
        taut_operate_rerange(taut_surface_along(surface, direction), lo, hi, &change, error),
        surface, direction, &change, moved, error);
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
