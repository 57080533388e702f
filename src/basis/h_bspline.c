/* h_bspline.c -- uniform C^2 splines over {1, t, sinh t, cosh t}, 0 < beta <= 700, on any number of
 * segments; not clamped. Formulas in quasi.c; [XuWang2006] section 4. */
#include "basis/quasi_change.h"

static taut_status h_bspline_plan(const taut_basis_spec *spec, int functions,
                                  taut_basis_shape *shape, taut_error *error)
{
    (void)functions;
    return taut_quasi_plan(&taut_quasi_h, spec, 1, shape, error);
}

static void h_bspline_fill(taut_basis *basis)
{
    taut_quasi_fill(&taut_quasi_h, basis);
}

static void h_bspline_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    taut_quasi_bspline_eval(&taut_quasi_h, basis, span, t, order, values);
}

static taut_status h_bspline_split(const taut_basis *basis, double t, taut_change_list *list,
                                   taut_error *error)
{
    return taut_quasi_bspline_split(&taut_quasi_h, basis, t, list, error);
}

static taut_status h_bspline_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    return taut_quasi_bspline_halve(&taut_quasi_h, basis, change, error);
}

static taut_status h_bspline_pieces(const taut_basis *basis, taut_change_list *list,
                                    taut_error *error)
{
    return taut_quasi_bspline_pieces(&taut_quasi_h, basis, list, error);
}

const taut_change_ops taut_changes_h_bspline = {
    .split = h_bspline_split,
    .pieces = h_bspline_pieces,
    .halve = h_bspline_halve,
    .insert = NULL,
    .elevate = NULL,
    .reverse = taut_quasi_reverse,
    .rerange = taut_quasi_rerange,
    .to_bspline = taut_quasi_to_bspline,
    .growth = taut_quasi_h_growth,
};

const taut_basis_ops taut_basis_h_bspline = {
    .type = "h-bspline",
    .needs = TAUT_MEMBER_BETA | TAUT_MEMBER_SEGMENTS,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 0,
    .layers = 1,
    .plan = h_bspline_plan,
    .fill = h_bspline_fill,
    .eval = h_bspline_eval,
    .linear = taut_quasi_bspline_linear,
    .changes = &taut_changes_h_bspline,
};
