#include "numeric/wide.h"

void taut_wide_gain(int count, taut_twice factor, const taut_twice *x, taut_twice *y)
{
    for (int i = 0; i < count; i++) {
        y[i] = taut_twice_gain(y[i], factor, x[i]);
    }
}
