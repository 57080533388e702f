/* ce_bezier_change.c -- a ce-bezier basis is cut and refined as its exact quartic Bezier form. */
#include "basis/change.h"

/* The quartic form: rows from basis->data (ce_bezier.c). */
static taut_status quartic(const taut_basis *basis, taut_change **change, taut_error *error)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 4};
    const taut_status status = taut_change_new(&spec, 0, 4, change, error);

    for (int j = 0; status == TAUT_OK && j < 5; j++) {
        for (int i = 0; i < 4; i++) {
            taut_change_row(*change, j)[i] = basis->data[5 * i + j];
        }
    }
    return status;
}

/* The quartic form and the step from there, in one; frees both, which may be NULL. */
static taut_status finish(taut_status status, taut_change *form, taut_change *step,
                          taut_change **change, taut_error *error)
{
    if (status == TAUT_OK) {
        status = taut_change_compose(form, step, change, error);
    }
    taut_change_free(form);
    taut_change_free(step);
    return status;
}

static taut_status ce_bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                   taut_error *error)
{
    taut_change *form = NULL;
    taut_change_list made = {0, NULL};
    taut_status status = quartic(basis, &form, error);

    if (status == TAUT_OK) {
        status = form->to->ops->changes->split(form->to, t, &made, error);
    }
    for (int i = 0; status == TAUT_OK && i < made.count; i++) {
        taut_change *both = NULL;
        status = taut_change_compose(form, made.items[i], &both, error);
        if (status == TAUT_OK) {
            taut_change_free(made.items[i]);
            made.items[i] = both;
        }
    }
    taut_change_free(form);
    if (status != TAUT_OK) {
        taut_change_list_free(&made);
        return status;
    }
    *list = made;
    return TAUT_OK;
}

static taut_status ce_bezier_pieces(const taut_basis *basis, taut_change_list *list,
                                    taut_error *error)
{
    taut_change_list made = {0, NULL};
    taut_status status = taut_change_list_new(1, &made, error);

    if (status == TAUT_OK) {
        status = quartic(basis, &made.items[0], error);
    }
    if (status != TAUT_OK) {
        taut_change_list_free(&made);
        return status;
    }
    *list = made;
    return TAUT_OK;
}

static taut_status ce_bezier_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic(basis, &form, error);

    if (status == TAUT_OK) {
        status = form->to->ops->changes->halve(form->to, &step, error);
    }
    return finish(status, form, step, change, error);
}

static taut_status ce_bezier_insert(const taut_basis *basis, double t, int times,
                                    taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic(basis, &form, error);

    if (status == TAUT_OK) {
        status = form->to->ops->changes->insert(form->to, t, times, &step, error);
    }
    return finish(status, form, step, change, error);
}

static taut_status ce_bezier_elevate(const taut_basis *basis, taut_change **change,
                                     taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic(basis, &form, error);

    if (status == TAUT_OK) {
        status = form->to->ops->changes->elevate(form->to, &step, error);
    }
    return finish(status, form, step, change, error);
}

/* B_i(1-t; alpha, beta, gamma) = B_{3-i}(t; gamma, -beta, alpha) ([WangBai2018] section 2.1). */
static taut_status ce_bezier_reverse(const taut_basis *basis, taut_change **change,
                                     taut_error *error)
{
    taut_basis_spec spec = basis->spec;
    spec.alpha = basis->spec.gamma;
    spec.beta = -basis->spec.beta;
    spec.gamma = basis->spec.alpha;
    return taut_change_select(&spec, 0, 0, 1, change, error);
}

/* [0, 1] is the only range of the type; elsewhere it is its quartic form. */
static taut_status ce_bezier_rerange(const taut_basis *basis, double lo, double hi,
                                     taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = TAUT_OK;

    if (lo == 0 && hi == 1) {
        return taut_change_select(&basis->spec, 0, 0, 0, change, error);
    }
    status = quartic(basis, &form, error);
    if (status == TAUT_OK) {
        status = form->to->ops->changes->rerange(form->to, lo, hi, &step, error);
    }
    return finish(status, form, step, change, error);
}

static taut_status ce_bezier_to_bspline(const taut_basis *basis, int panels, const double *ends,
                                        taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic(basis, &form, error);

    if (status == TAUT_OK) {
        status = form->to->ops->changes->to_bspline(form->to, panels, ends, &step, error);
    }
    return finish(status, form, step, change, error);
}

const taut_change_ops taut_changes_ce_bezier = {
    .split = ce_bezier_split,
    .pieces = ce_bezier_pieces,
    .halve = ce_bezier_halve,
    .insert = ce_bezier_insert,
    .elevate = ce_bezier_elevate,
    .reverse = ce_bezier_reverse,
    .rerange = ce_bezier_rerange,
    .to_bspline = ce_bezier_to_bspline,
    .growth = NULL,
};
