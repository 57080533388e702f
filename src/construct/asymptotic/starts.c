#include "construct/asymptotic/starts.h"

#include <assert.h>
#include <string.h>

/* Least eigenvalue of the Hessian over the value: below it the point lies in a valley that runs
 * to infinity, where the gradient vanishes too. */
static const double least_curvature = 1e-6;

/* Gradient over value with which a rough descent counts as having arrived. */
static const double arrived = 1e-3;

typedef struct rough_end {
    double value;
    double x[TAUT_MINIMISE_MAX];
} rough_end;

static int descend(const taut_start_plan *plan, double *x, int rough, taut_minimum *minimum)
{
    if (taut_pulse_report(plan->pulse)) {
        return 0;
    }
    if (plan->begin != NULL) {
        plan->begin(plan->context, x);
    }
    return taut_minimise(plan->count, plan->objective, plan->hessian, plan->context, x, plan->work,
                         rough, minimum);
}

static int go_down(const taut_start_plan *plan, rough_end *ends)
{
    uint64_t noise = 1;
    int found = 0;
    *plan->rule = plan->coarse;
    for (int number = 0; number < plan->starts; number++) {
        taut_minimum minimum;
        rough_end end;
        int at = found;
        memset(&end, 0, sizeof end);
        if (!plan->start(plan->context, number, &noise, end.x) ||
            !descend(plan, end.x, 1, &minimum) || minimum.gradient > arrived * minimum.value) {
            continue;
        }
        end.value = minimum.value;
        for (; at > 0 && ends[at - 1].value > end.value; at--) {
            ends[at] = ends[at - 1];
        }
        ends[at] = end;
        found++;
    }
    return found;
}

int taut_starts_run(const taut_start_plan *plan, double *x, double *value)
{
    rough_end ends[TAUT_STARTS_MAX];
    double gradient[TAUT_MINIMISE_MAX];
    int found = 0, polished = 0;

    assert(plan->count <= TAUT_MINIMISE_MAX && plan->starts <= TAUT_STARTS_MAX);
    if (plan->count == 0) {
        *value = 0.0;
        return 1;
    }
    found = go_down(plan, ends);
    *plan->rule = plan->fine;
    for (int k = 0; k < found && !polished; k++) {
        taut_minimum minimum;
        polished = descend(plan, ends[k].x, 0, &minimum) && minimum.converged &&
                   minimum.curvature > least_curvature * minimum.value;
        if (polished) {
            memcpy(x, ends[k].x, sizeof ends[k].x);
            polished = plan->objective(plan->context, x, value, gradient);
        }
    }
    return polished;
}
