#include "construct/plateau/climb.h"

#include <math.h>
#include <string.h>

enum { STEPS = 8, HALVINGS = 12 };

static const struct {
    double steepest;   /* |grad psi| that the start is brought down to */
    double gap_rough;  /* share of the area: below, the start is as good as a step makes it */
    double gain_least; /* of a step, over the gap: less and it was the last */
    double flops;      /* of all steps */
    double decimals;   /* share of the root of the gap that a decimal may move grad psi by */
} limits = {
    .steepest = 0.9999,
    .gap_rough = 1e-7,
    .gain_least = 1e-3,
    .flops = 1e10,
    .decimals = 3e-3,
};

/* Newton's step from psi, as much of it as makes the gap fall; *gain over the gap, 0 for none. */
static taut_status make_step(const taut_dual_climb *climb, double *psi, double *step, double *next,
                             taut_dual_value *reached, double *gain)
{
    double share = 1;
    taut_status status = climb->solve(climb->context, psi, step);

    *gain = 0;
    for (int k = 0; status == TAUT_OK && k < HALVINGS && *gain == 0; k++, share *= 0.5) {
        for (size_t i = 0; i < climb->count; i++) {
            next[i] = psi[i] + share * step[i];
        }
        if (taut_pulse_report(climb->pulse)) {
            status = TAUT_INTERRUPTED;
            break;
        }
        const taut_dual_value value = climb->evaluate(climb->context, next);
        if (value.steepest < 1 && value.gap < reached->gap) {
            *gain = 1 - value.gap / reached->gap;
            *reached = value;
            memcpy(psi, next, climb->count * sizeof(double));
        }
    }
    return status;
}

taut_status taut_dual_climb_up(const taut_dual_climb *climb, double *psi, double *step,
                               double *next, taut_dual_value *value)
{
    double gain = 1, flops = 0;
    taut_status status = climb->solve(climb->context, NULL, psi);

    if (status != TAUT_OK) {
        return status;
    }
    *value = climb->evaluate(climb->context, psi);
    if (!(value->steepest < limits.steepest)) {
        for (size_t i = 0; i < climb->count; i++) {
            psi[i] *= limits.steepest / value->steepest;
        }
        *value = climb->evaluate(climb->context, psi);
    }
    for (int k = 0; k < STEPS && gain > limits.gain_least &&
                    value->gap > limits.gap_rough * climb->area && flops <= limits.flops;
         k++) {
        status = make_step(climb, psi, step, next, value, &gain);
        if (status != TAUT_OK) {
            return status;
        }
        flops += climb->flops;
    }
    return value->steepest < 1 ? TAUT_OK : TAUT_NO_SOLUTION;
}

double taut_dual_decimals(double gap, double steep, int exponent)
{
    const double rough = fmax(gap, 1e-20);
    const double unit = ldexp(limits.decimals * sqrt(rough) / steep, exponent);
    double power = 1;

    while (unit * power < 1 && power < 1e22) {
        power *= 10;
    }
    return power < 1e22 ? power : 0;
}

double taut_dual_round(double x, double power)
{
    const double rounded = round(x * power) / power;
    return power > 0 && isfinite(rounded) ? rounded : x;
}
