/* exact.c -- splitting in rational arithmetic: the pieces as they are made in doubles, then
 * each with the points of its surface over the piece's range, by the module `exact`. */
#include "core/exact.h"
#include "core/arena.h"
#include "core/fail.h"
#include "geometry/operate/points.h"
#include "taut/operations.h"

#include <string.h>

static int is_cut(const taut_surface *surface, const char *name)
{
    return name == NULL || strcmp(name, taut_surface_name(surface)) == 0;
}

static taut_status check_surface(const taut_surface *surface, taut_error *error)
{
    if (strcmp(taut_basis_type(taut_surface_u(surface)), "bezier") != 0 ||
        strcmp(taut_basis_type(taut_surface_v(surface)), "bezier") != 0 ||
        taut_surface_weights(surface) != NULL) {
        return taut_fail(error, TAUT_NO_SOLUTION, "not-exact", NULL, taut_none, taut_none,
                         "rational arithmetic is for polynomial surfaces on \"bezier\" bases");
    }
    return TAUT_OK;
}

/* Surface `whole` over the range of `piece`, added to a model. */
static taut_status add_piece(const taut_exact_ops *ops, const taut_surface *whole, int direction,
                             const taut_surface *piece, taut_model *model, taut_arena *arena,
                             taut_error *error)
{
    const int along_v = direction == TAUT_ALONG_V;
    const taut_basis *old = along_v ? taut_surface_v(whole) : taut_surface_u(whole);
    const taut_basis *part = along_v ? taut_surface_v(piece) : taut_surface_u(piece);
    const double range[4] = {taut_basis_lo(old), taut_basis_hi(old), taut_basis_lo(part),
                             taut_basis_hi(part)};
    const taut_exact_numbers numbers = {taut_surface_points(whole), taut_surface_exact(whole)};
    const taut_exact_memory memory = taut_exact_memory_of(arena);
    taut_exact_net net;
    taut_surface *made = NULL;

    if (arena == NULL || !ops->rerange(taut_basis_degree(taut_surface_u(whole)),
                                       taut_basis_degree(taut_surface_v(whole)), &numbers, along_v,
                                       range, &memory, &net)) {
        return taut_fail_memory(error);
    }
    const taut_status status =
        taut_surface_new_exact(taut_surface_name(piece), taut_surface_u(piece),
                               taut_surface_v(piece), net.values, NULL, net.texts, &made, error);
    return status == TAUT_OK ? taut_operate_add_surface(model, made, error) : status;
}

/* Both pieces of a surface, from number `first` of `rounded` on. */
static taut_status add_pieces(const taut_exact_ops *ops, const taut_surface *whole, int direction,
                              const taut_model *rounded, int first, taut_model *to,
                              taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        taut_arena *arena = taut_arena_new();
        status = add_piece(ops, whole, direction, taut_model_surface(rounded, first + k), to, arena,
                           error);
        taut_arena_free(arena);
    }
    return status;
}

/* `rounded` has two pieces for each surface that is cut, and one for each that is not. */
static taut_status fill_model(const taut_model *model, const char *name, int direction,
                              const taut_model *rounded, taut_model *to, taut_error *error)
{
    const taut_exact_ops *ops = NULL;
    taut_status status = taut_exact_load(&ops, error);
    int next = 0;

    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *whole = taut_model_surface(model, i);
        const int cut = is_cut(whole, name);
        status = cut ? add_pieces(ops, whole, direction, rounded, next, to, error)
                     : taut_operate_copy_surface(taut_model_surface(rounded, next), to, error);
        next += cut ? 2 : 1;
    }
    for (int i = 0; status == TAUT_OK && i < taut_model_curve_count(rounded); i++) {
        status = taut_operate_copy_curve(taut_model_curve(rounded, i), to, error);
    }
    return status;
}

/* Once the pieces are made in doubles. */
static taut_status make_exact(const taut_model *model, const char *name, int direction,
                              const taut_model *rounded, taut_model **split, taut_error *error)
{
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    for (int i = 0; status == TAUT_OK && i < taut_model_surface_count(model); i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        status = is_cut(surface, name) ? check_surface(surface, error) : TAUT_OK;
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_operate_begin(model, &made, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = fill_model(model, name, direction, rounded, made, error);
    return taut_operate_end(status, made, split);
}

taut_status taut_model_split_exact(const taut_model *model, const char *name, int direction,
                                   double t, taut_model **split, taut_error *error)
{
    taut_model *rounded = NULL;
    taut_status status = taut_model_split(model, name, direction, t, &rounded, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = make_exact(model, name, direction, rounded, split, error);
    taut_model_free(rounded);
    return status;
}
