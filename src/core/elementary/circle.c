/* circle.c -- sin, cos, tan by a table ([Gal1991] in spirit, with regular places):
 *
 *     x = quadrant pi/2 + r,  r = j/32 + d,  |d| <= 1/64
 *     sin r = sin(j/32) + cos(j/32) d + [ sin(j/32) (cos d - 1) + cos(j/32) (sin d - d) ]
 *
 * and the like for cos r; the first product is exact, and what is in brackets is below 2^-13 of the first term, or of d
 * where that is 0.
 */
#include "core/elementary/elementary.h"
#include "core/elementary/internal.h"

/* The sine and the cosine of r, |r| <= pi/4 and a rounding. */
static void near_0(taut_twice r, taut_twice *sine, taut_twice *cosine)
{
    const double sign = r.high < 0 ? -1 : 1;
    const int j = (int)(sign * r.high * 32 + 0.5);
    const taut_twice s = taut_table_sin[j], c = taut_table_cos[j];
    const double d = sign * r.high - j / 32.0, rest = sign * r.low, square = d * d;
    /* sin d - d and cos d - 1 */
    const double odd =
        d * square * (-1.0 / 6 + square * (1.0 / 120 + square * (-1.0 / 5040 + square / 362880)));
    const double even =
        square * (-0.5 + square * (1.0 / 24 + square * (-1.0 / 720 + square / 40320)));
    const taut_twice a = taut_twice_product(c.high, d), b = taut_twice_product(s.high, d);
    const taut_twice up = taut_twice_sum(s.high, a.high), down = taut_twice_quick(c.high, -b.high);
    const double up_low = (a.low + (s.low + c.low * d)) + (c.high * (odd + rest) + s.high * even);
    const double down_low = (c.low - (b.low + s.low * d)) - (s.high * (odd + rest) - c.high * even);
    const taut_twice sum = taut_twice_quick(up.high, up.low + up_low);
    *sine = sign < 0 ? taut_twice_negative(sum) : sum;
    *cosine = taut_twice_quick(down.high, down.low + down_low);
}

/* The sine of quadrant pi/2 + r, of the sine and the cosine of r. */
static double turned(int quadrant, taut_twice sine, taut_twice cosine)
{
    const double size = taut_twice_round((quadrant & 1) != 0 ? cosine : sine);
    return (quadrant & 2) != 0 ? -size : size;
}

/* The sine of quadrant pi/2 + r */
static double sine_of(int quadrant, taut_twice r)
{
    taut_twice sine, cosine;
    near_0(r, &sine, &cosine);
    return turned(quadrant, sine, cosine);
}

double taut_sin(double x)
{
    int quadrant = 0;
    if (!(fabs(x) < HUGE_VAL)) {
        return x - x;
    }
    if (fabs(x) < 0x1p-40) {
        return x;
    }
    const taut_twice r = taut_elementary_reduce(x, &quadrant);
    return sine_of(quadrant, r);
}

double taut_cos(double x)
{
    int quadrant = 0;
    if (!(fabs(x) < HUGE_VAL)) {
        return x - x;
    }
    const taut_twice r = taut_elementary_reduce(x, &quadrant);
    return sine_of(quadrant + 1, r);
}

void taut_sin_cos(double x, double *sine, double *cosine)
{
    int quadrant = 0;
    taut_twice near[2];
    if (!(fabs(x) < HUGE_VAL)) {
        *sine = *cosine = x - x;
        return;
    }
    near_0(taut_elementary_reduce(x, &quadrant), &near[0], &near[1]);
    *sine = fabs(x) < 0x1p-40 ? x : turned(quadrant, near[0], near[1]);
    *cosine = turned(quadrant + 1, near[0], near[1]);
}

double taut_tan(double x)
{
    int quadrant = 0;
    taut_twice sine, cosine;
    if (!(fabs(x) < HUGE_VAL)) {
        return x - x;
    }
    if (fabs(x) < 0x1p-40) {
        return x;
    }
    near_0(taut_elementary_reduce(x, &quadrant), &sine, &cosine);
    return taut_twice_round((quadrant & 1) != 0 ? taut_twice_over(taut_twice_negative(cosine), sine)
                                                : taut_twice_over(sine, cosine));
}
