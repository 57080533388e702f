/* double.h -- sums and products of twice the precision of double, so that what is left
 * of an identity is the model's own rounding and not that of the proof.
 *
 * A number is hi + lo with |lo| <= 2^-53 |hi|; relative error of an operation about 2^-104
 * ([Dekker1971]; the products by fma).
 */
#ifndef TAUT_CERTIFY_ASYMPTOTIC_DOUBLE_H
#define TAUT_CERTIFY_ASYMPTOTIC_DOUBLE_H

#include <math.h>

typedef struct taut_double {
    double hi, lo;
} taut_double;

static inline taut_double taut_double_of(double x)
{
    return (taut_double){x, 0.0};
}

static inline taut_double taut_double_sum(double a, double b)
{
    const double s = a + b, part = s - a;
    return (taut_double){s, (a - (s - part)) + (b - part)};
}

static inline taut_double taut_double_add(taut_double a, taut_double b)
{
    taut_double high = taut_double_sum(a.hi, b.hi);
    const taut_double low = taut_double_sum(a.lo, b.lo);
    high.lo += low.hi;
    high = taut_double_sum(high.hi, high.lo);
    high.lo += low.lo;
    return taut_double_sum(high.hi, high.lo);
}

static inline taut_double taut_double_negative(taut_double a)
{
    return (taut_double){-a.hi, -a.lo};
}

static inline taut_double taut_double_multiply(taut_double a, taut_double b)
{
    const double p = a.hi * b.hi;
    const double rest = fma(a.hi, b.hi, -p) + (a.hi * b.lo + a.lo * b.hi);
    return taut_double_sum(p, rest);
}

/* a / d for a plain number d. */
static inline taut_double taut_double_divide(taut_double a, double d)
{
    const double q = a.hi / d;
    const taut_double product = taut_double_multiply(taut_double_of(q), taut_double_of(d));
    const taut_double rest = taut_double_add(a, taut_double_negative(product));
    return taut_double_sum(q, (rest.hi + rest.lo) / d);
}

#endif /* TAUT_CERTIFY_ASYMPTOTIC_DOUBLE_H */
