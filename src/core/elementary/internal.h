/* internal.h -- what the elementary functions share: tables, and values in twice the precision. */
#ifndef TAUT_CORE_ELEMENTARY_INTERNAL_H
#define TAUT_CORE_ELEMENTARY_INTERNAL_H

#include "core/twice.h"

#include <stdint.h>
#include <string.h>

extern const taut_twice taut_table_exp[64];
extern const double taut_table_inverse[128];
extern const taut_twice taut_table_log[128];
extern const taut_twice taut_table_sin[27], taut_table_cos[27];
extern const taut_twice taut_table_atan[33];
extern const uint32_t taut_table_two_over_pi[40];

static inline uint64_t taut_bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double taut_of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* 2^k, -1022 <= k <= 1023. */
static inline double taut_power_of_two(int k)
{
    return taut_of_bits((uint64_t)(k + 1023) << 52);
}

/* The nearest whole number, |x| < 2^51. */
static inline double taut_nearest_whole(double x)
{
    return (x + 0x1.8p52) - 0x1.8p52;
}

/* a 2^k rounded once, 1/4 < |a| < 4, into subnormal numbers, 0 and infinity too. */
double taut_elementary_scaled(taut_twice a, int k);

/* exp(x) = result 2^*k for |x| < 1100, to 2^-66; 1/2 < result < 4. */
taut_twice taut_elementary_exp(taut_twice x, int *k);

/* log(2^k m) for m as taut_elementary_split gives it, to 2^-66. */
taut_twice taut_elementary_log(double m, int k);

/* x = m 2^k with 0.7 < m < 1.42, for finite x > 0, subnormal ones too. */
double taut_elementary_split(double x, int *k);

/* x = (quadrant + 4 n) pi/2 + result, |result| <= pi/4 and a rounding more, to 2^-66, for finite x. */
taut_twice taut_elementary_reduce(double x, int *quadrant);

/* The angle of (x, y) in the first quadrant, x, y >= 0 and not both 0, between 2^-100 and 2^100, to 2^-64. */
taut_twice taut_elementary_angle(taut_twice y, taut_twice x);

#endif /* TAUT_CORE_ELEMENTARY_INTERNAL_H */
