/* witnesses.h -- models whose witness `details.least` somebody has changed. */
#ifndef TAUT_TEST_WITNESSES_H
#define TAUT_TEST_WITNESSES_H

#include "taut/construct.h"

/* What becomes of the numbers of a witness: number `at` of them is changed, or each, one in three, where at is below 0. */
typedef struct witness_change {
    long at, seen;
    double by;                  /* so much of 1 is added, at random */
    double instead;             /* of number `at` */
    const char *without, *only; /* a member left out; the members that are changed, or NULL: all */
} witness_change;

/* A copy of the model with details.least alone, changed; free it. */
taut_model *witness_changed(const taut_model *model, witness_change change);

#endif /* TAUT_TEST_WITNESSES_H */
