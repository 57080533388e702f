/* wide.h -- loops over numbers of two doubles (core/twice.h). */
#ifndef TAUT_NUMERIC_WIDE_H
#define TAUT_NUMERIC_WIDE_H

#include "core/twice.h"

/* y_i += factor x_i, i < count: taut_twice_gain of each, to the same bits. None waits for the one
 * before it, as terms of one sum do: where there are many sums of as many terms, add a term of all
 * at once. */
void taut_wide_gain(int count, taut_twice factor, const taut_twice *x, taut_twice *y);

#endif /* TAUT_NUMERIC_WIDE_H */
