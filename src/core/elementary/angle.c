/* angle.c -- atan, atan2, asin, acos by a table.
 *
 * The angle of (x, y), 0 <= y <= x, with c = j/32 next to y/x:
 *
 *     atan(y/x) = atan c + atan d,   d = (y - c x) / (x + c y),   |d| <= 1/64
 *
 * d in twice the precision, for c has six bits; the other octants by pi/2 and pi. asin x is the angle of
 * (sqrt(1 - x^2), x), acos x that of (x, sqrt(1 - x^2)), the root in twice the precision.
 */
#include "core/elementary/elementary.h"
#include "core/elementary/internal.h"

static const taut_twice pi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
static const taut_twice half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

taut_twice taut_elementary_angle(taut_twice y, taut_twice x)
{
    if (y.high > x.high) {
        return taut_twice_less(half_pi, taut_elementary_angle(x, y));
    }
    const int j = (int)(y.high / x.high * 32 + 0.5);
    const double c = j / 32.0;
    const taut_twice top = taut_twice_less(y, taut_twice_scale(c, x));
    const taut_twice bottom = taut_twice_add(x, taut_twice_scale(c, y));
    const taut_twice d = taut_twice_over(top, bottom);
    const double square = d.high * d.high;
    const double series =
        d.high * square *
        (-1.0 / 3 + square * (1.0 / 5 + square * (-1.0 / 7 + square * (1.0 / 9 - square / 11))));
    return taut_twice_add(taut_table_atan[j], taut_twice_quick(d.high, d.low + series));
}

double taut_atan(double x)
{
    if (fabs(x) < 0x1p-40 || isnan(x)) {
        return x;
    }
    const double size =
        fabs(x) > 0x1p70
            ? half_pi.high
            : taut_twice_round(taut_elementary_angle(taut_twice_of(fabs(x)), taut_twice_of(1)));
    return copysign(size, x);
}

double taut_atan2(double y, double x)
{
    int ey = 0, ex = 0;
    if (isnan(x) || isnan(y)) {
        return x + y;
    }
    if (isinf(x) || isinf(y)) { /* to the middle of an octant, or an axis */
        x = isinf(x) ? copysign(1, x) : copysign(0, x);
        y = isinf(y) ? copysign(1, y) : copysign(0, y);
    }
    if (y == 0) {
        return signbit(x) != 0 ? copysign(pi.high, y) : y;
    }
    if (x == 0) {
        return copysign(half_pi.high, y);
    }
    const double my = frexp(fabs(y), &ey), mx = frexp(fabs(x), &ex);
    if (ey - ex < -64) {
        return x > 0 ? y / x : copysign(pi.high, y);
    }
    if (ey - ex > 64) {
        return copysign(half_pi.high, y);
    }
    const taut_twice angle =
        taut_elementary_angle(taut_twice_of(ldexp(my, ey - ex)), taut_twice_of(mx));
    return copysign(taut_twice_round(x > 0 ? angle : taut_twice_less(pi, angle)), y);
}

/* sqrt(1 - x^2), |x| < 1 */
static taut_twice other_side(double x)
{
    const taut_twice square = taut_twice_product(x, x);
    return taut_twice_root(taut_twice_less(taut_twice_of(1), square));
}

double taut_asin(double x)
{
    if (!(fabs(x) < 1)) {
        return fabs(x) == 1 ? copysign(half_pi.high, x) : (x - x) / 0.0;
    }
    if (fabs(x) < 0x1p-40) {
        return x;
    }
    return copysign(taut_twice_round(taut_elementary_angle(taut_twice_of(fabs(x)), other_side(x))),
                    x);
}

double taut_acos(double x)
{
    if (!(fabs(x) < 1)) {
        return x == 1 ? 0 : x == -1 ? pi.high : (x - x) / 0.0;
    }
    if (fabs(x) < 0x1p-70) {
        return half_pi.high;
    }
    const taut_twice angle = taut_elementary_angle(other_side(x), taut_twice_of(fabs(x)));
    return taut_twice_round(x > 0 ? angle : taut_twice_less(pi, angle));
}
