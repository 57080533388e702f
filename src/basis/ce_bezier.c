/* ce_bezier.c -- the "cubic quasi-Bezier" functions with three shape numbers, through their exact
 * quartic Bezier form ([WangBai2018] section 2):
 *
 *     Q_0 = V_0,  Q_1 = (1-alpha)/4 V_0 + (3+alpha)/4 V_1,  Q_2 = (3+beta)/6 V_1 + (3-beta)/6 V_2,
 *     Q_3 = (3+gamma)/4 V_2 + (1-gamma)/4 V_3,  Q_4 = V_3
 *
 * The legal box alpha, gamma in [-3, 1], beta in [-3, 3] is where all four are non-negative.
 * Outside of it the curve still exists (the paper's own example has alpha = 3), so a basis takes
 * any shape numbers up to TAUT_SHAPE_MAX in size; who needs the box asks for it.
 */
#include "basis/basis_ops.h"
#include "basis/change.h"
#include "core/fail.h"
#include "numeric/bernstein.h"

#include <math.h>

#define TAUT_SHAPE_MAX 1000.0 /* the sum of |functions| grows as this: 3 digits are lost there */

static taut_status ce_bezier_plan(const taut_basis_spec *spec, int functions,
                                  taut_basis_shape *shape, taut_error *error)
{
    const double shapes[] = {spec->alpha, spec->beta, spec->gamma};
    static const char *const names[] = {"/alpha", "/beta", "/gamma"};

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

const taut_basis_ops taut_basis_ce_bezier = {
    .type = "ce-bezier",
    .needs = TAUT_MEMBER_ALPHA | TAUT_MEMBER_BETA | TAUT_MEMBER_GAMMA,
    .allows = 0,
    .weights = 0,
    .plan = ce_bezier_plan,
    .fill = ce_bezier_fill,
    .eval = ce_bezier_eval,
    .linear = NULL,
    .changes = &taut_changes_ce_bezier,
};
