/* curve.c -- taut/operations.h for curves: a change of basis, applied. */
#include "taut/operations.h"

#include "core/fail.h"
#include "core/memory.h"
#include "geometry/lattice.h"
#include "geometry/operate/change.h"
#include "geometry/operate/points.h"

/* The curve after *change, which is freed; passes a failed status on. */
static taut_status apply_change(taut_status status, const taut_curve *curve,
                                taut_change *const *change, taut_curve **result, taut_error *error)
{
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_changed(curve, *change, taut_curve_name(curve), result, error);
    taut_change_free(*change);
    return status;
}

/* Part i of the curve, whose points `whole` holds, added to a model. */
static taut_status add_part(const taut_curve *curve, const taut_lattice *whole,
                            const taut_change *change, int dashes, int i, taut_model *model,
                            taut_error *error)
{
    char name[TAUT_NAME_MAX + 1];
    taut_lattice lattice;
    taut_curve *part = NULL;
    taut_status status = taut_lattice_change(whole, TAUT_ALONG_U, change, &lattice, error);

    if (status != TAUT_OK) {
        return status;
    }
    taut_operate_piece_name(taut_curve_name(curve), dashes, i, name);
    status = taut_lattice_into_curve(&lattice, name, change->to, &part, error);
    return status == TAUT_OK ? taut_operate_add_curve(model, part, error) : status;
}

taut_status taut_operate_add_curve_parts(const taut_curve *curve, const taut_change_list *list,
                                         int dashes, taut_model *to, taut_error *error)
{
    taut_lattice whole;
    taut_status status = taut_lattice_of_curve(curve, &whole, error);

    for (int i = 0; status == TAUT_OK && i < list->count; i++) {
        status = add_part(curve, &whole, list->items[i], dashes, i, to, error);
    }
    taut_lattice_free(&whole);
    return status;
}

/* A model of the curve after each of the changes; the list is freed; passes a failed status on. */
static taut_status model_of_parts(taut_status status, const taut_curve *curve,
                                  taut_change_list *list, taut_model **parts, taut_error *error)
{
    taut_model *made = NULL;

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_model_new(&made) == TAUT_OK
                 ? taut_operate_add_curve_parts(curve, list, 1, made, error)
                 : taut_fail_memory(error);
    taut_change_list_free(list);
    return taut_operate_end(status, made, parts);
}

taut_status taut_curve_split(const taut_curve *curve, double t, taut_model **pieces,
                             taut_error *error)
{
    taut_change_list list = {0, NULL};
    if (curve == NULL || pieces == NULL) {
        return taut_operate_null(error);
    }
    return model_of_parts(taut_operate_split(taut_curve_t(curve), t, &list, error), curve, &list,
                          pieces, error);
}

taut_status taut_curve_pieces(const taut_curve *curve, taut_model **pieces, taut_error *error)
{
    taut_change_list list = {0, NULL};
    if (curve == NULL || pieces == NULL) {
        return taut_operate_null(error);
    }
    const taut_basis *t = taut_curve_t(curve);
    return model_of_parts(t->ops->changes->pieces(t, &list, error), curve, &list, pieces, error);
}

taut_status taut_curve_refine(const taut_curve *curve, taut_curve **refined, taut_error *error)
{
    taut_change *change = NULL;
    if (curve == NULL || refined == NULL) {
        return taut_operate_null(error);
    }
    const taut_basis *t = taut_curve_t(curve);
    return apply_change(t->ops->changes->halve(t, &change, error), curve, &change, refined, error);
}

taut_status taut_curve_insert(const taut_curve *curve, double t, int times, taut_curve **refined,
                              taut_error *error)
{
    taut_change *change = NULL;
    if (curve == NULL || refined == NULL) {
        return taut_operate_null(error);
    }
    return apply_change(taut_operate_insert(taut_curve_t(curve), t, times, &change, error), curve,
                        &change, refined, error);
}

taut_status taut_curve_elevate(const taut_curve *curve, int times, taut_curve **raised,
                               taut_error *error)
{
    taut_change *change = NULL;
    if (curve == NULL || raised == NULL) {
        return taut_operate_null(error);
    }
    return apply_change(taut_operate_elevate(taut_curve_t(curve), times, &change, error), curve,
                        &change, raised, error);
}

taut_status taut_curve_reverse(const taut_curve *curve, taut_curve **reversed, taut_error *error)
{
    taut_change *change = NULL;
    if (curve == NULL || reversed == NULL) {
        return taut_operate_null(error);
    }
    const taut_basis *t = taut_curve_t(curve);
    return apply_change(t->ops->changes->reverse(t, &change, error), curve, &change, reversed,
                        error);
}

taut_status taut_curve_rerange(const taut_curve *curve, double lo, double hi, taut_curve **moved,
                               taut_error *error)
{
    taut_change *change = NULL;
    if (curve == NULL || moved == NULL) {
        return taut_operate_null(error);
    }
    return apply_change(taut_operate_rerange(taut_curve_t(curve), lo, hi, &change, error), curve,
                        &change, moved, error);
}

taut_status taut_curve_transform(const taut_curve *curve, const double *matrix, taut_curve **moved,
                                 taut_error *error)
{
    double *points = NULL;
    taut_status status = TAUT_OK;
    if (curve == NULL || matrix == NULL || moved == NULL) {
        return taut_operate_null(error);
    }
    status = taut_operate_points(matrix, (size_t)taut_basis_count(taut_curve_t(curve)),
                                 taut_curve_points(curve), &points, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(taut_curve_name(curve), taut_curve_t(curve), points,
                            taut_curve_weights(curve), moved, error);
    taut_free(points);
    return status;
}
