/* twice.h -- sums and products in twice the precision of double.
 *
 * A number is high + low, |low| <= 2^-53 |high|; an operation is good to 2^-100 of its operands
 * ([Dekker1971], [Knuth1998] 4.2.2), so that what is left of an identity is the rounding of the model
 * and not that of its proof. The low part of a product below 2^-960 is lost. A fused operation would
 * give the rest of a product at once, but not on every processor, and not rightly in every C
 * library.
 */
#ifndef TAUT_CORE_TWICE_H
#define TAUT_CORE_TWICE_H

#include <math.h>

typedef struct taut_twice {
    double high, low;
} taut_twice;

#define TAUT_TWICE_WORK 25 /* operations on doubles in taut_twice_gain, as pulses count them */

static inline taut_twice taut_twice_of(double x)
{
    return (taut_twice){x, 0};
}

static inline double taut_twice_round(taut_twice a)
{
    return a.high + a.low;
}

/* a + b exactly. */
static inline taut_twice taut_twice_sum(double a, double b)
{
    const double s = a + b, part = s - a;
    return (taut_twice){s, (a - (s - part)) + (b - part)};
}

/* The same where |a| >= |b| or a is 0. */
static inline taut_twice taut_twice_quick(double a, double b)
{
    const double s = a + b;
    return (taut_twice){s, b - (s - a)};
}

static inline taut_twice taut_twice_negative(taut_twice a)
{
    return (taut_twice){-a.high, -a.low};
}

static inline taut_twice taut_twice_size(taut_twice a)
{
    return a.high < 0 ? taut_twice_negative(a) : a;
}

static inline taut_twice taut_twice_add(taut_twice a, taut_twice b)
{
    taut_twice s = taut_twice_sum(a.high, b.high);
    const taut_twice t = taut_twice_sum(a.low, b.low);
    s = taut_twice_sum(s.high, s.low + t.high);
    return taut_twice_sum(s.high, s.low + t.low);
}

/* The upper half of a, 26 bits; a scaled one where the splitting would overflow. */
static inline double taut_twice_upper(double a)
{
    const double factor = 134217729; /* 2^27 + 1 */
    if (fabs(a) > 0x1p990) {
        const double part = a * 0x1p-30, split = factor * part;
        return (split - (split - part)) * 0x1p30;
    }
    const double split = factor * a;
    return split - (split - a);
}

/* a b exactly, by splitting both factors in halves. */
static inline taut_twice taut_twice_product(double a, double b)
{
    const double p = a * b, ah = taut_twice_upper(a), bh = taut_twice_upper(b);
    const double al = a - ah, bl = b - bh;
    return (taut_twice){p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

static inline taut_twice taut_twice_times(taut_twice a, taut_twice b)
{
    const taut_twice p = taut_twice_product(a.high, b.high);
    return taut_twice_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/* s + a b, to 2^-100 of the larger of s and a b. */
static inline taut_twice taut_twice_gain(taut_twice s, taut_twice a, taut_twice b)
{
    const taut_twice p = taut_twice_product(a.high, b.high), t = taut_twice_sum(s.high, p.high);
    const double cross = a.high * b.low + a.low * b.high;
    return taut_twice_sum(t.high, t.low + (s.low + (p.low + cross)));
}

static inline taut_twice taut_twice_scale(double factor, taut_twice a)
{
    return taut_twice_times(taut_twice_of(factor), a);
}

static inline taut_twice taut_twice_less(taut_twice a, taut_twice b)
{
    return taut_twice_add(a, taut_twice_negative(b));
}

static inline taut_twice taut_twice_over(taut_twice a, taut_twice b)
{
    const double q = a.high / b.high;
    const taut_twice rest = taut_twice_less(a, taut_twice_scale(q, b));
    return taut_twice_sum(q, (rest.high + rest.low) / b.high);
}

static inline taut_twice taut_twice_over_number(taut_twice a, double d)
{
    return taut_twice_over(a, taut_twice_of(d));
}

/* The square root of a > 0. */
static inline taut_twice taut_twice_root(taut_twice a)
{
    const double root = sqrt(a.high);
    const taut_twice rest = taut_twice_less(a, taut_twice_product(root, root));
    return taut_twice_quick(root, rest.high / (2 * root));
}

#endif /* TAUT_CORE_TWICE_H */
