/* jet.h -- second derivatives forwards: a number with its gradient and Hessian in a few variables.
 *
 * Sums are linear; f(a) has gradient f' a_i and Hessian f' a_ij + f'' a_i a_j. Source: [GriewankWalther2008] chapter 13.
 */
#ifndef TAUT_NUMERIC_JET_H
#define TAUT_NUMERIC_JET_H

#include "core/elementary/elementary.h"

enum { TAUT_JET_SIZE = 6, TAUT_JET_PAIRS = TAUT_JET_SIZE * (TAUT_JET_SIZE + 1) / 2 };

typedef struct taut_jet {
    double value;
    double by[TAUT_JET_SIZE];
    double second[TAUT_JET_PAIRS]; /* (i, j), j <= i, at i (i + 1) / 2 + j */
} taut_jet;

static inline taut_jet taut_jet_constant(double value)
{
    return (taut_jet){.value = value};
}

static inline taut_jet taut_jet_variable(double value, int index)
{
    taut_jet made = {.value = value};
    made.by[index] = 1.0;
    return made;
}

/* to += factor a */
static inline void taut_jet_add(double factor, const taut_jet *a, taut_jet *to)
{
    to->value += factor * a->value;
    for (int i = 0; i < TAUT_JET_SIZE; i++) {
        to->by[i] += factor * a->by[i];
    }
    for (int k = 0; k < TAUT_JET_PAIRS; k++) {
        to->second[k] += factor * a->second[k];
    }
}

/* f(a), given f, f' and f'' at its value. */
static inline taut_jet taut_jet_apply(const taut_jet *a, double value, double slope, double bend)
{
    taut_jet made = {.value = value};
    for (int i = 0, k = 0; i < TAUT_JET_SIZE; i++) {
        made.by[i] = slope * a->by[i];
        for (int j = 0; j <= i; j++, k++) {
            made.second[k] = slope * a->second[k] + bend * a->by[i] * a->by[j];
        }
    }
    return made;
}

static inline taut_jet taut_jet_exp(const taut_jet *a)
{
    const double value = taut_exp(a->value);
    return taut_jet_apply(a, value, value, value);
}

/* log |a| */
static inline taut_jet taut_jet_log(const taut_jet *a)
{
    const double inverse = 1.0 / a->value;
    return taut_jet_apply(a, taut_log(a->value < 0 ? -a->value : a->value), inverse,
                          -inverse * inverse);
}

#endif /* TAUT_NUMERIC_JET_H */
