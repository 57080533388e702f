/* ce_bezier.c -- the "cubic quasi-Bezier" functions with three shape numbers, through their exact
 * quartic Bezier form ([WangBai2018] section 2):
 *
 *     Q_0 = V_0,  Q_1 = (1-alpha)/4 V_0 + (3+alpha)/4 V_1,  Q_2 = (3+beta)/6 V_1 + (3-beta)/6 V_2,
 *     Q_3 = (3+gamma)/4 V_2 + (1-gamma)/4 V_3,  Q_4 = V_3
 *
 * The legal box alpha, gamma in [-3, 1], beta in [-3, 3] is where all four are non-negative.
 * Outside of it the curve still exists (the paper's own example has alpha = 3), so a basis takes
 * any shape numbers up to TAUT_SHAPE_MAX in size; who needs the box asks for it. It is cut and
 * refined as its quartic Bezier form.
 */
#include "basis/change.h"
#include "core/fail.h"
#include "numeric/bernstein.h"

#include <math.h>

#define TAUT_SHAPE_MAX 1000.0 /* the sum of |functions| grows as this: 3 digits are lost there */

static taut_status ce_bezier_plan(const taut_basis_ops *ops, const taut_basis_spec *spec,
                                  int functions, taut_basis_shape *shape, taut_error *error)
{
    const double shapes[] = {spec->alpha, spec->beta, spec->gamma};
    static const char *const names[] = {"/alpha", "/beta", "/gamma"};

    (void)ops;
    (void)functions;
    for (int i = 0; i < 3; i++) {
        if (!(fabs(shapes[i]) <= TAUT_SHAPE_MAX)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", names[i], shapes[i], TAUT_SHAPE_MAX,
                             "%s is %.17g, expected at most %g in size", names[i] + 1, shapes[i],
                             TAUT_SHAPE_MAX);
        }
    }
    *shape = (taut_basis_shape){.count = 4, .local = 4, .span_count = 1, .degree = 4};
    return TAUT_OK;
}

/* data[i][j]: how much of V_i goes into Q_j, 4 by 5. */
static void ce_bezier_fill(taut_basis *basis)
{
    const double a = basis->spec.alpha, b = basis->spec.beta, c = basis->spec.gamma;
    double *data = basis->data;

    basis->breaks[0] = 0;
    basis->breaks[1] = 1;
    data[0] = 1;
    data[1] = (1 - a) / 4;
    data[5 + 1] = (3 + a) / 4;
    data[5 + 2] = (3 + b) / 6;
    data[10 + 2] = (3 - b) / 6;
    data[10 + 3] = (3 + c) / 4;
    data[15 + 3] = (1 - c) / 4;
    data[15 + 4] = 1;
}

static void ce_bezier_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    double quartic[(TAUT_ORDER_MAX + 1) * 5];

    (void)span;
    taut_bernstein_eval(4, order, t, quartic);
    for (int k = 0; k <= order; k++) {
        for (int i = 0; i < 4; i++) {
            double sum = 0;
            for (int j = 0; j < 5; j++) {
                sum += basis->data[5 * i + j] * quartic[5 * k + j];
            }
            values[4 * k + i] = sum;
        }
    }
}

/* The quartic form: rows from basis->data. */
static taut_status quartic_form(const taut_basis *basis, taut_change **change, taut_error *error)
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
static taut_status compose_forms(taut_status status, taut_change *form, taut_change *step,
                                 taut_change **change, taut_error *error)
{
    if (status == TAUT_OK) {
        status = taut_change_compose(form, step, change, error);
    }
    taut_change_free(form);
    taut_change_free(step);
    return status;
}

static taut_status fill_split(const taut_change *form, double t, taut_change_list *list,
                              taut_error *error)
{
    taut_status status = form->to->ops->changes->split(form->to, t, list, error);
    for (int i = 0; status == TAUT_OK && i < list->count; i++) {
        taut_change *step = list->items[i];
        list->items[i] = NULL;
        status = taut_change_compose(form, step, &list->items[i], error);
        taut_change_free(step);
    }
    return taut_change_list_done(status, list);
}

static taut_status ce_bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                   taut_error *error)
{
    taut_change *form = NULL;
    taut_status status = quartic_form(basis, &form, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = fill_split(form, t, list, error);
    taut_change_free(form);
    return status;
}

static taut_status ce_bezier_pieces(const taut_basis *basis, taut_change_list *list,
                                    taut_error *error)
{
    const taut_status status = taut_change_list_new(1, list, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_change_list_done(quartic_form(basis, &list->items[0], error), list);
}

static taut_status ce_bezier_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic_form(basis, &form, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = form->to->ops->changes->halve(form->to, &step, error);
    return compose_forms(status, form, step, change, error);
}

static taut_status ce_bezier_insert(const taut_basis *basis, double t, int times,
                                    taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic_form(basis, &form, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = form->to->ops->changes->insert(form->to, t, times, &step, error);
    return compose_forms(status, form, step, change, error);
}

static taut_status ce_bezier_elevate(const taut_basis *basis, taut_change **change,
                                     taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic_form(basis, &form, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = form->to->ops->changes->elevate(form->to, &step, error);
    return compose_forms(status, form, step, change, error);
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
    status = quartic_form(basis, &form, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = form->to->ops->changes->rerange(form->to, lo, hi, &step, error);
    return compose_forms(status, form, step, change, error);
}

static taut_status ce_bezier_to_bspline(const taut_basis *basis, int pieces, const double *ends,
                                        taut_change **change, taut_error *error)
{
    taut_change *form = NULL, *step = NULL;
    taut_status status = quartic_form(basis, &form, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = form->to->ops->changes->to_bspline(form->to, pieces, ends, &step, error);
    return compose_forms(status, form, step, change, error);
}

static const taut_change_ops ce_bezier_changes = {
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

const taut_basis_ops taut_basis_ce_bezier = {
    .type = "ce-bezier",
    .needs = TAUT_MEMBER_ALPHA | TAUT_MEMBER_BETA | TAUT_MEMBER_GAMMA,
    .allows = 0,
    .weights = 0,
    .plan = ce_bezier_plan,
    .fill = ce_bezier_fill,
    .eval = ce_bezier_eval,
    .linear = NULL,
    .changes = &ce_bezier_changes,
};
