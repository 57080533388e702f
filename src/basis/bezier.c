/* bezier.c -- Bernstein polynomials on a range: N_i(t) = B[n,i]((t-lo)/(hi-lo)). */
#include "basis/basis_ops.h"
#include "basis/change.h"
#include "numeric/bernstein.h"

static taut_status bezier_plan(const taut_basis_spec *spec, int functions, taut_basis_shape *shape,
                               taut_error *error)
{
    (void)functions;
    (void)error;
    *shape = (taut_basis_shape){spec->degree + 1, spec->degree + 1, 1, 0, spec->degree};
    return TAUT_OK;
}

static void bezier_fill(taut_basis *basis)
{
    if (!basis->spec.has_range) {
        basis->spec.range[0] = 0;
        basis->spec.range[1] = 1;
    }
    basis->breaks[0] = basis->spec.range[0];
    basis->breaks[1] = basis->spec.range[1];
}

/* d^k/dt^k brings a factor (hi-lo)^-k. */
static void bezier_eval(const taut_basis *basis, int span, double t, int order, double *values)
{
    const int local = basis->shape.local;
    const double width = basis->breaks[1] - basis->breaks[0];
    const double s = (t - basis->breaks[0]) / width;
    double scale = 1;

    (void)span;
    taut_bernstein_eval(local - 1, order, s, values);
    for (int k = 1; k <= order; k++) {
        scale /= width;
        for (int i = 0; i < local; i++) {
            values[k * local + i] *= scale;
        }
    }
}

static void bezier_linear(const taut_basis *basis, double *t)
{
    const double lo = basis->breaks[0], hi = basis->breaks[1];
    const int degree = basis->shape.degree;
    for (int i = 0; i <= degree; i++) {
        t[i] = i == degree ? hi : lo + (hi - lo) * i / degree;
    }
}

const taut_basis_ops taut_basis_bezier = {
    .type = "bezier",
    .needs = TAUT_MEMBER_DEGREE,
    .allows = TAUT_MEMBER_RANGE,
    .weights = 1,
    .plan = bezier_plan,
    .fill = bezier_fill,
    .eval = bezier_eval,
    .linear = bezier_linear,
    .changes = &taut_changes_bezier,
};
