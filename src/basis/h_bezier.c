/* h_bezier.c -- the normalised basis of {1, t, sinh t, cosh t} on one segment, 0 < beta <= 700.
 * Formulas in quasi_kernel.h; [XuWang2006] section 3. */
#include "basis/quasi.h"

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

const taut_basis_ops taut_basis_h_bezier = {
    .type = "h-bezier",
    .needs = TAUT_MEMBER_BETA,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 0,
    .plan = h_bezier_plan,
    .fill = h_bezier_fill,
    .eval = h_bezier_eval,
};
