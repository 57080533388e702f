/* sum.h -- compensated summation (Neumaier's variant of Kahan's). */
#ifndef TAUT_NUMERIC_SUM_H
#define TAUT_NUMERIC_SUM_H

#include <math.h>

/* Zero-initialise; the error of the total is a few units in the last place of the sum of |terms|
 * times 2^-53, however many terms there are ([Higham2002] section 4.3). */
typedef struct taut_sum {
    double high, low;
} taut_sum;

static inline void taut_sum_add(taut_sum *sum, double term)
{
    const double total = sum->high + term;
    if (fabs(sum->high) >= fabs(term)) {
        sum->low += (sum->high - total) + term;
    } else {
        sum->low += (term - total) + sum->high;
    }
    sum->high = total;
}

static inline double taut_sum_total(const taut_sum *sum)
{
    return sum->high + sum->low;
}

/* What the computed a + b leaves over of the sum, exactly (ibid.). */
static inline double taut_sum_rest(double a, double b)
{
    const double sum = a + b;
    const double from_b = sum - a;
    return (a - (sum - from_b)) + (b - from_b);
}

#endif /* TAUT_NUMERIC_SUM_H */
