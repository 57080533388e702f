#include "core/decimal.h"

#include <math.h>
#include <string.h>

/* 10^1201 beside 64 bits of quotient is the most there is to hold. */
enum { LIMBS = 136, DIGITS_MAX = 800, LARGEST = 310, SMALLEST = -345, EXPONENT_MAX = 100000 };

/* A whole number: sum of limb[i] 2^(32 i). */
typedef struct whole {
    int count; /* without zeros at the top; 0: it is 0 */
    uint32_t limb[LIMBS];
} whole;

static void trim(whole *a)
{
    while (a->count > 0 && a->limb[a->count - 1] == 0) {
        a->count--;
    }
}

/* a = a factor + term */
static void multiply_add(whole *a, uint32_t factor, uint32_t term)
{
    uint64_t carry = term;
    for (int i = 0; i < a->count; i++) {
        carry += (uint64_t)a->limb[i] * factor;
        a->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry > 0) {
        a->limb[a->count++] = (uint32_t)carry;
    }
}

static void multiply_power_of_10(whole *a, int64_t power)
{
    for (; power >= 9; power -= 9) {
        multiply_add(a, 1000000000, 0);
    }
    for (; power > 0; power--) {
        multiply_add(a, 10, 0);
    }
}

static whole whole_of(uint64_t n)
{
    whole a = {.count = 2};
    a.limb[0] = (uint32_t)n;
    a.limb[1] = (uint32_t)(n >> 32);
    trim(&a);
    return a;
}

static int bits_of(uint64_t n)
{
    int bits = 0;
    for (; n > 0; n >>= 1) {
        bits++;
    }
    return bits;
}

static int bits_in(const whole *a)
{
    return a->count > 0 ? 32 * (a->count - 1) + bits_of(a->limb[a->count - 1]) : 0;
}

static void shift_left(whole *a, int by)
{
    const int limbs = by / 32, bits = by % 32;
    if (by <= 0 || a->count == 0) {
        return;
    }
    for (int i = a->count + limbs; i >= 0; i--) {
        const uint32_t high = i - limbs >= 0 && i - limbs < a->count ? a->limb[i - limbs] : 0;
        const uint32_t low = i - limbs >= 1 && i - limbs <= a->count ? a->limb[i - limbs - 1] : 0;
        a->limb[i] = (uint32_t)(((uint64_t)high << 32 | low) << bits >> 32);
    }
    a->count += limbs + 1;
    trim(a);
}

static void halve(whole *a)
{
    for (int i = 0; i < a->count; i++) {
        const uint32_t above = i + 1 < a->count ? a->limb[i + 1] : 0;
        a->limb[i] = a->limb[i] >> 1 | above << 31;
    }
    trim(a);
}

/* Below 0, 0, above 0 as a < b, a = b, a > b. */
static int compare(const whole *a, const whole *b)
{
    if (a->count != b->count) {
        return a->count - b->count;
    }
    for (int i = a->count - 1; i >= 0; i--) {
        if (a->limb[i] != b->limb[i]) {
            return a->limb[i] < b->limb[i] ? -1 : 1;
        }
    }
    return 0;
}

/* a -= b <= a */
static void subtract(whole *a, const whole *b)
{
    uint64_t borrow = 0;
    for (int i = 0; i < a->count; i++) {
        const uint64_t take = borrow + (i < b->count ? b->limb[i] : 0);
        borrow = a->limb[i] < take;
        a->limb[i] = (uint32_t)(a->limb[i] - take);
    }
    trim(a);
}

/* floor(a / b) < 2^64, and a becomes the rest; b stays. */
static uint64_t divide(whole *a, whole *b)
{
    const int more = bits_in(a) - bits_in(b);
    uint64_t quotient = 0;
    shift_left(b, more);
    for (int i = more; i >= 0; i--) {
        quotient <<= 1;
        if (compare(a, b) >= 0) {
            subtract(a, b);
            quotient |= 1;
        }
        if (i > 0) {
            halve(b);
        }
    }
    return quotient;
}

/* a / b > 0 as the nearest double. */
static double nearest_double(whole *a, whole *b)
{
    enum { QUOTIENT = 63, MANTISSA = 53, LEAST = -1022 };
    const int shift = QUOTIENT - (bits_in(a) - bits_in(b)); /* a / b = quotient 2^-shift */
    shift_left(shift > 0 ? a : b, shift > 0 ? shift : -shift);
    const uint64_t quotient = divide(a, b);
    const int top = bits_of(quotient) - 1 - shift; /* of the double */
    const int lost = top < LEAST ? LEAST - top : 0;
    const int drop = bits_of(quotient) - MANTISSA + lost; /* 10 or more bits */
    if (drop > 64) {
        return 0; /* less than half of the least double */
    }
    const uint64_t half = (uint64_t)1 << (drop - 1);
    const uint64_t below = quotient & (half - 1 + half); /* bits 0 .. drop-1 */
    uint64_t m = drop < 64 ? quotient >> drop : 0;
    m += below > half || (below == half && (a->count > 0 || (m & 1) != 0));
    return ldexp((double)m, drop - shift);
}

/* The digits of a text, the first of them not 0, with 10^power of the last. */
typedef struct digits {
    int count;
    char digit[DIGITS_MAX + 1];
    int64_t power;
} digits;

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static int64_t read_exponent(const char *text, const char *end)
{
    const int negative = text < end && *text == '-';
    int64_t exponent = 0;
    text += text < end && (*text == '-' || *text == '+');
    for (; text < end && is_digit(*text); text++) {
        exponent = exponent < EXPONENT_MAX ? 10 * exponent + (*text - '0') : exponent;
    }
    return negative ? -exponent : exponent;
}

/* What comes after DIGITS_MAX digits matters only by not being 0: no double, and nothing half way between two, has as many. */
static void read_digits(const char *text, const char *end, digits *d)
{
    int after_point = 0, has_rest = 0;
    d->count = 0;
    d->power = 0;
    for (; text < end && (is_digit(*text) || *text == '.'); text++) {
        if (*text == '.') {
            after_point = 1;
        } else if (d->count < DIGITS_MAX) {
            d->digit[d->count] = *text;
            d->count += d->count > 0 || *text != '0';
            d->power -= after_point;
        } else {
            has_rest |= *text != '0';
            d->power += !after_point;
        }
    }
    if (text < end) { /* at the e */
        d->power += read_exponent(text + 1, end);
    }
    if (has_rest) {
        d->digit[d->count++] = '1';
        d->power--;
    }
    for (; d->count > 0 && d->digit[d->count - 1] == '0'; d->count--) {
        d->power++;
    }
}

double taut_decimal_value(const char *text, size_t length)
{
    const char *const end = text + length;
    const double sign = length > 0 && *text == '-' ? -1 : 1;
    digits d;

    read_digits(text + (length > 0 && (*text == '-' || *text == '+')), end, &d);
    if (d.count == 0 || d.count + d.power < SMALLEST) {
        return sign * 0.0;
    }
    if (d.count + d.power > LARGEST) {
        return sign * (double)INFINITY;
    }
    whole a = {.count = 0}, b = whole_of(1);
    for (int i = 0; i < d.count; i++) {
        multiply_add(&a, 10, (uint32_t)(d.digit[i] - '0'));
    }
    multiply_power_of_10(d.power >= 0 ? &a : &b, d.power >= 0 ? d.power : -d.power);
    return sign * nearest_double(&a, &b);
}

uint64_t taut_decimal_digits(double x, int precision, int *exponent)
{
    const double log10_of_2 = 0.30102999566398120;
    uint64_t limit = 1;
    int two = 0;
    const uint64_t m = (uint64_t)ldexp(frexp(x, &two), 53);
    /* the exponent of the last digit, or one too few */
    int power = (int)floor((two - 1) * log10_of_2) - precision + 1;

    for (int i = 0; i < precision; i++) {
        limit *= 10;
    }
    for (;; power++) {
        whole a = whole_of(m), b = whole_of(1);
        shift_left(two >= 53 ? &a : &b, two >= 53 ? two - 53 : 53 - two);
        multiply_power_of_10(power < 0 ? &a : &b, power < 0 ? -power : power);
        uint64_t quotient = divide(&a, &b);
        if (quotient < limit) {
            shift_left(&a, 1);
            const int half = compare(&a, &b);
            *exponent = power;
            return quotient + (half > 0 || (half == 0 && (quotient & 1) != 0));
        }
    }
}
