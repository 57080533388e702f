/* c_bezier.c -- the normalised basis of {1, t, sin t, cos t} on one segment, 0 < alpha <= pi.
 * Formulas in quasi_kernel.h; [XuWang2006] section 3. */
#include "basis/quasi_change.h"

static taut_status c_bezier_plan(const taut_basis_spec *spec, int functions,
                                 taut_basis_shape *shape, taut_error *error)
{
    (void)functions;
    return taut_quasi_plan(&taut_quasi_c, spec, 0, shape, error);
}

static void c_bezier_fill(taut_basis *basis)
{
    taut_quasi_fill(&taut_quasi_c, basis);
}

static void c_bezier_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    taut_quasi_bezier_eval(&taut_quasi_c, basis, span, t, order, values);
}

static taut_status c_bezier_split(const taut_basis *basis, double t, taut_change_list *list,
                                  taut_error *error)
{
    return taut_quasi_bezier_split(&taut_quasi_c, basis, t, list, error);
}

static taut_status c_bezier_halve(const taut_basis *basis, taut_change **change, taut_error *error)
{
    return taut_quasi_bezier_halve(&taut_quasi_c, basis, change, error);
}

const taut_change_ops taut_changes_c_bezier = {
    .split = c_bezier_split,
    .pieces = taut_quasi_bezier_pieces,
    .halve = c_bezier_halve,
    .insert = NULL,
    .elevate = NULL,
    .reverse = taut_quasi_reverse,
    .rerange = taut_quasi_rerange,
    .to_bspline = taut_quasi_to_bspline,
    .growth = taut_quasi_c_growth,
};

const taut_basis_ops taut_basis_c_bezier = {
    .type = "c-bezier",
    .needs = TAUT_MEMBER_ALPHA,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 0,
    .plan = c_bezier_plan,
    .fill = c_bezier_fill,
    .eval = c_bezier_eval,
    .linear = taut_quasi_bezier_linear,
    .changes = &taut_changes_c_bezier,
};
