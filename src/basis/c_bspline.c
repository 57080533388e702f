/* c_bspline.c -- uniform C^2 splines over {1, t, sin t, cos t}, 0 < alpha < pi, on any number of
 * segments; not clamped. Formulas in quasi.c; [XuWang2006] section 4. */
#include "basis/quasi.h"

static taut_status c_bspline_plan(const taut_basis_spec *spec, int functions,
                                  taut_basis_shape *shape, taut_error *error)
{
    (void)functions;
    return taut_quasi_plan(&taut_quasi_c, spec, 1, shape, error);
}

static void c_bspline_fill(taut_basis *basis)
{
    taut_quasi_fill(&taut_quasi_c, basis);
}

static void c_bspline_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    taut_quasi_bspline_eval(&taut_quasi_c, basis, span, t, order, values);
}

const taut_basis_ops taut_basis_c_bspline = {
    .type = "c-bspline",
    .needs = TAUT_MEMBER_ALPHA | TAUT_MEMBER_SEGMENTS,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 0,
    .plan = c_bspline_plan,
    .fill = c_bspline_fill,
    .eval = c_bspline_eval,
};
