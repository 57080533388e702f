/* growth.h -- the larger of two growths: what left the range of numbers is infinite, not lost. */
#ifndef TAUT_HARMONIC_GROWTH_H
#define TAUT_HARMONIC_GROWTH_H

#include <math.h>

/* In twice the precision infinity ends as a NaN, which fmax would pass over. */
static inline double taut_larger_growth(double most, double found)
{
    return isnan(found) ? HUGE_VAL : fmax(most, found);
}

#endif /* TAUT_HARMONIC_GROWTH_H */
