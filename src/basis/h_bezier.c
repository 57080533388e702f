/* h_bezier.c -- the normalised basis of {1, t, sinh t, cosh t} on one segment, 0 < beta <= 700.
 * Formulas in quasi_kernel.h; [XuWang2006] section 3. */
#include "basis/quasi_change.h"

static taut_status h_bezier_plan(const taut_basis_spec *spec, int functions,
                                 taut_basis_shape *shape, taut_error *error)
{
    (void)functions;
    return taut_quasi_plan(&taut_quasi_h, spec, 0, shape, error);
}

static void h_bezier_fill(taut_basis *basis)
{
    taut_quasi_fill(&taut_quasi_h, basis);
}

static void h_bezier_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    taut_quasi_bezier_eval(&taut_quasi_h, basis, span, t, order, values);
}

static taut_status h_bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                  taut_error *error)
{
    return taut_quasi_bezier_split(&taut_quasi_h, basis, t, list, error);
}

static taut_status h_bezier_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    return taut_quasi_bezier_halve(&taut_quasi_h, basis, change, error);
}

const taut_change_ops taut_changes_h_bezier = {
    .split = h_bezier_split,
    .pieces = taut_quasi_bezier_pieces,
    .halve = h_bezier_halve,
    .insert = NULL,
    .elevate = NULL,
    .reverse = taut_quasi_reverse,
    .rerange = taut_quasi_rerange,
    .to_bspline = taut_quasi_to_bspline,
    .growth = taut_quasi_h_growth,
};

const taut_basis_ops taut_basis_h_bezier = {
    .type = "h-bezier",
    .needs = TAUT_MEMBER_BETA,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 0,
    .layers = 1,
    .plan = h_bezier_plan,
    .fill = h_bezier_fill,
    .eval = h_bezier_eval,
    .linear = taut_quasi_bezier_linear,
    .changes = &taut_changes_h_bezier,
};
