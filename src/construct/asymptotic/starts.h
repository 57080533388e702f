/* starts.h -- minimisation from several starts, and the repeatable noise that makes them differ. */
#ifndef TAUT_ASYMPTOTIC_STARTS_H
#define TAUT_ASYMPTOTIC_STARTS_H

#include "construct/asymptotic/curve_energy.h"
#include "core/pulse.h"
#include "numeric/minimise.h"

#include <stdint.h>

enum { TAUT_STARTS_MAX = 16, TAUT_STARTS_WORK = TAUT_MINIMISE_WORK(TAUT_MINIMISE_MAX) };

typedef struct taut_start_plan {
    int count;  /* unknowns; 0: nothing to find, the value is 0 */
    int starts; /* at most TAUT_STARTS_MAX */
    taut_objective objective;
    taut_hessian hessian; /* or NULL */
    /* Start number `number` into x; 0 if there is none. */
    int (*start)(void *context, int number, uint64_t *noise, double *x);
    /* Called before each descent from x, to fix the region it stays in; may be NULL. */
    void (*begin)(void *context, const double *x);
    void *context;
    const taut_curve_rule **rule; /* where the objective looks for its rule */
    const taut_curve_rule *coarse, *fine;
    double *work;      /* double[TAUT_STARTS_WORK] */
    taut_pulse *pulse; /* told of each descent */
} taut_start_plan;

/* The lowest minimum: every start goes down roughly on the coarse rule, then the lowest is polished
 * on the fine one; one that is no minimum (a valley that falls for ever, a slope that ends at the
 * domain's edge) gives way to the next.
 * x: double[TAUT_MINIMISE_MAX]; the objective was last called there. Returns 0 if none is found, and where the pulse is
 * stopped. */
int taut_starts_run(const taut_start_plan *plan, double *x, double *value);

/* splitmix64 ([Steele2014]); the same seed means the same starts everywhere. */
static inline uint64_t taut_noise_bits(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* Close to a normal deviate: the sum of four uniform ones, scaled to variance 1. */
static inline double taut_noise(uint64_t *state)
{
    double sum = -2.0;
    for (int k = 0; k < 4; k++) {
        sum += (double)(taut_noise_bits(state) >> 11) * 0x1p-53;
    }
    return sum * 1.7320508075688772;
}

#endif /* TAUT_ASYMPTOTIC_STARTS_H */
