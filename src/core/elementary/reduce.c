/* reduce.c -- an argument less the nearest multiple of pi/2, in twice the precision.
 *
 * Below 2^20 ([CodyWaite1980]): pi/2 in parts of 33 bits, by which multiples are exact,
 *     r = ((x - n p0) - n p1) - n p2 - n p3
 * No double but 0 comes nearer than 2^-61 to a multiple ([Muller2016] 11.2.1), so that 53 bits and
 * more are left.
 *
 * Above ([PayneHanek1983]): x 2/pi modulo 4 in whole numbers. x = m 2^e with a whole m < 2^53 needs the
 * bits of 2/pi from 2^(2 - e) down: those before make multiples of 4. 256 of them leave 128 after
 * the point and what 62 leading zeros may take.
 */
#include "core/elementary/internal.h"

static const double part[4] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                               0x1.b839a252049c1p-104};
static const taut_twice half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

static taut_twice reduce_small(double x, int *quadrant)
{
    const double n = taut_nearest_whole(x * 0x1.45f306dc9c883p-1);
    const taut_twice a = taut_twice_sum(x - n * part[0], -n * part[1]);
    const taut_twice b = taut_twice_sum(a.high, -n * part[2]);
    *quadrant = (int)n & 3;
    return taut_twice_sum(b.high, (a.low + b.low) - n * part[3]);
}

/* 256 bits of 2/pi from bit `first` behind the point on (the first is bit 0), as words of 32. */
static void take_bits(int first, uint32_t out[8])
{
    for (int i = 0; i < 8; i++) {
        const int at = first + 32 * i + 64, word = at / 32 - 2, shift = at % 32; /* first > -64 */
        const uint64_t here = word < 0 ? 0 : taut_table_two_over_pi[word];
        const uint64_t next = word + 1 < 0 ? 0 : taut_table_two_over_pi[word + 1];
        out[i] = (uint32_t)((here << 32 | next) >> (32 - shift));
    }
}

static taut_twice reduce_large(double x, int *quadrant)
{
    const uint64_t bits = taut_bits_of(x);
    const int e = (int)(bits >> 52 & 2047) - 1075; /* |x| = m 2^e, -33 < e < 972 */
    const uint64_t m = (bits & 0xfffffffffffffu) | 0x10000000000000u;
    const uint32_t halves[2] = {(uint32_t)m, (uint32_t)(m >> 32)};
    uint32_t digits[8],
        product[8] = {0}; /* product: of the digits as a whole number, the last 256 bits */
    /* the bit of weight 2^(1 - e) times m has weight 2 and above */
    take_bits(e - 2, digits);
    for (int i = 0; i < 2; i++) {
        uint64_t carry = 0;
        for (int j = 7; j >= i; j--) {
            const uint64_t sum = (uint64_t)digits[j] * halves[i] + product[j - i] + carry;
            product[j - i] = (uint32_t)sum;
            carry = sum >> 32;
        }
    }
    /* product[0] has two bits before the point */
    int whole = (int)(product[0] >> 30);
    const int is_above =
        (product[0] >> 29 & 1) != 0; /* nearer to the next: 1 - fraction, negative */
    taut_twice fraction = {0, 0};
    double unit = 0x1p-30;
    for (int i = 0; i < 7; i++, unit *= 0x1p-32) {
        uint32_t digit = i == 0 ? product[0] & 0x3fffffffu : product[i];
        digit = is_above ? (i == 0 ? 0x3fffffffu : 0xffffffffu) - digit : digit;
        fraction = taut_twice_add(fraction, taut_twice_of(digit * unit));
    }
    whole += is_above;
    taut_twice r = taut_twice_times(fraction, half_pi);
    if (is_above != (x < 0)) {
        r = taut_twice_negative(r);
    }
    *quadrant = (x < 0 ? -whole : whole) & 3;
    return r;
}

taut_twice taut_elementary_reduce(double x, int *quadrant)
{
    if (fabs(x) < 0.78) {
        *quadrant = 0;
        return taut_twice_of(x);
    }
    return fabs(x) < 0x1p20 ? reduce_small(x, quadrant) : reduce_large(x, quadrant);
}
