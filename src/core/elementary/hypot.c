/* hypot.c -- sqrt(x^2 + y^2): the squares and their sum with their rounding errors ([Dekker1971]), and a
 * step of Newton's for the root, so that only the last addition rounds. */
#include "core/elementary/elementary.h"
#include "core/elementary/internal.h"

/* 2^-440 < large < 2^440 */
static taut_twice hypot_of(double large, double small)
{
    const taut_twice a = taut_twice_product(large, large), b = taut_twice_product(small, small);
    const taut_twice sum = taut_twice_quick(a.high, b.high);
    const double root = sqrt(sum.high);
    const taut_twice square = taut_twice_product(root, root);
    const double rest = (sum.high - square.high) + ((sum.low + (a.low + b.low)) - square.low);
    return (taut_twice){root, rest / (2 * root)};
}

double taut_hypot(double x, double y)
{
    const double a = fabs(x), b = fabs(y);
    int k = 0;
    if (a == HUGE_VAL || b == HUGE_VAL) {
        return HUGE_VAL;
    }
    const double large = a > b ? a : b, small = a > b ? b : a;
    if (isnan(a) || isnan(b)) {
        return a + b;
    }
    if (small <= large * 0x1p-30) { /* 0 too */
        return large;
    }
    if (large < 0x1p400 && large > 0x1p-400) {
        return taut_twice_round(hypot_of(large, small));
    }
    frexp(large, &k);
    return taut_elementary_scaled(hypot_of(ldexp(large, -k), ldexp(small, -k)), k);
}
