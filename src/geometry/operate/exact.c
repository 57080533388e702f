/* exact.c -- splitting in rational arithmetic: the pieces as they are made in doubles, then
 * each with the points of its surface over the piece's range, by the module `exact`. */
#include "core/exact.h"
#include "core/arena.h"
#include "core/fail.h"
#include "taut/operations.h"

#include <string.h>

static void *take(void *context, size_t count, size_t size)
{
    return taut_arena_take(context, count, size);
}

static int is_cut(const taut_surface *surface, const char *name)
{
    return name == NULL || strcmp(name, taut_surface_name(surface)) == 0;
}

static taut_status check_surface(const taut_surface *surface, taut_error *error)
{
    if (strcmp(taut_basis_type(taut_surface_u(surface)), "bezier") != 0 ||
        strcmp(taut_basis_type(taut_surface_v(surface)), "bezier") != 0 ||
        taut_surface_weights(surface) != NULL) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, taut_none, taut_none,
                         "rational arithmetic is for polynomial surfaces on \"bezier\" bases");
    }
    return TAUT_OK;
}

/* Surface `whole` over the range of `piece`, added to a model. */
static taut_status add_piece(const taut_exact_ops *ops, const taut_surface *whole, int direction,
                             const taut_surface *piece, taut_model *model, taut_error *error)
{
    const int along_v = direction == TAUT_ALONG_V;
    const taut_basis *old = along_v ? taut_surface_v(whole) : taut_surface_u(whole);
    const taut_basis *part = along_v ? taut_surface_v(piece) : taut_surface_u(piece);
    const double range[4] = {taut_basis_lo(old), taut_basis_hi(old), taut_basis_lo(part),
                             taut_basis_hi(part)};
    const taut_exact_numbers numbers = {taut_surface_points(whole), taut_surface_exact(whole)};
    taut_arena *arena = taut_arena_new();
    const taut_exact_memory memory = {arena, take};
    taut_exact_net net;
    taut_surface *made = NULL;
    taut_status status = TAUT_OK;

    if (arena == NULL || !ops->rerange(taut_basis_degree(taut_surface_u(whole)),
                                       taut_basis_degree(taut_surface_v(whole)), &numbers, along_v,
                                       range, &memory, &net)) {
        status = taut_fail_memory(error);
    } else {
        status = taut_surface_new_exact(taut_surface_name(piece), taut_surface_u(piece),
                                        taut_surface_v(piece), net.values, NULL, net.texts, &made,
                                        error);
    }
    if (status == TAUT_OK && taut_model_add_surface(model, made) != TAUT_OK) {
        taut_surface_free(made);
        status = taut_fail_memory(error);
    }
    taut_arena_free(arena);
    return status;
}

static taut_status add_copies(const taut_model *from, int surface, taut_model *to,
                              taut_error *error)
{
    taut_surface *copy = NULL;
    if (taut_surface_copy(taut_model_surface(from, surface), &copy) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (taut_model_add_surface(to, copy) != TAUT_OK) {
        taut_surface_free(copy);
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

static taut_status add_curves(const taut_model *from, taut_model *to, taut_error *error)
{
    for (int i = 0; i < taut_model_curve_count(from); i++) {
        taut_curve *copy = NULL;
        if (taut_curve_copy(taut_model_curve(from, i), &copy) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        if (taut_model_add_curve(to, copy) != TAUT_OK) {
            taut_curve_free(copy);
            return taut_fail_memory(error);
        }
    }
    return TAUT_OK;
}

/* `rounded` has two pieces for each surface that is cut, and one for each that is not. */
static taut_status fill(const taut_model *model, const char *name, int direction,
                        const taut_model *rounded, taut_model *to, taut_error *error)
{
    const taut_exact_ops *ops = NULL;
    taut_status status = taut_exact_load(&ops, error);
    int next = 0;

    for (int i = 0; i < taut_model_surface_count(model) && status == TAUT_OK; i++) {
        const taut_surface *whole = taut_model_surface(model, i);
        if (!is_cut(whole, name)) {
            status = add_copies(rounded, next++, to, error);
            continue;
        }
        for (int k = 0; k < 2 && status == TAUT_OK; k++) {
            status =
                add_piece(ops, whole, direction, taut_model_surface(rounded, next++), to, error);
        }
    }
    return status == TAUT_OK ? add_curves(rounded, to, error) : status;
}

taut_status taut_model_split_exact(const taut_model *model, const char *name, int direction,
                                   double t, taut_model **split, taut_error *error)
{
    taut_model *rounded = NULL, *made = NULL;
    taut_status status = taut_model_split(model, name, direction, t, &rounded, error);

    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        if (is_cut(taut_model_surface(model, i), name)) {
            status = check_surface(taut_model_surface(model, i), error);
        }
    }
    if (status == TAUT_OK && taut_model_new(&made) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        status = fill(model, name, direction, rounded, made, error);
    }
    if (status == TAUT_OK) {
        status = taut_model_set_unit(made, taut_model_unit(model));
    }
    taut_model_free(rounded);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *split = made;
    return TAUT_OK;
}
