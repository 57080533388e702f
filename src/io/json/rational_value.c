/* rational_value.c -- from a rational number p / q to the nearest double, half to even.
 *
 * A quotient of the first digits in two doubles is right but where it lies near the middle of two doubles, or where
 * numbers are so large or small that two doubles hold less. There v is taken to a neighbour for as long as p / q lies
 * beyond the middle between them, which is told in whole numbers:
 *
 *     v = m 2^e,    p / q  <>  (2 m + 1) 2^(e - 1)
 */
#include "io/json/number_value.h"

#include "core/twice.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* So many digits, beside the 2^1075 and 2^54 that they are compared with. */
enum { LIMBS = TAUT_RATIONAL_MAX * 7 / 64 + 40, DIGITS_MAX = 19 };

/* A whole number: its digits; as the first of them, at most 19, times a power of ten. */
typedef struct digits {
    const char *text;
    size_t count;
    uint64_t first;
    int64_t power;
} digits;

/* sum of limb[i] 2^(32 i) */
typedef struct whole {
    int count;
    uint32_t limb[LIMBS];
} whole;

/* Reads digits up to the first other character; NULL if there is none. */
static const char *read_digits(const char *text, digits *number)
{
    const char *at = text;
    *number = (digits){.text = text};
    for (; *at >= '0' && *at <= '9'; at++) {
        if (number->first <= (UINT64_MAX - 9) / 10) {
            number->first = 10 * number->first + (uint64_t)(*at - '0');
        } else {
            number->power++;
        }
    }
    number->count = (size_t)(at - text);
    return at > text ? at : NULL;
}

/* ---- nearly ---- */

static taut_twice twice_of(uint64_t n)
{
    return taut_twice_sum((double)(n >> 32) * 0x1p32, (double)(n & 0xffffffffu));
}

/* x 10^power, x >= 0; infinite where that is. */
static taut_twice scale(taut_twice x, int64_t power)
{
    while (power != 0 && x.high > 0) {
        const int64_t part = power > 22 ? 22 : power < -22 ? -22 : power;
        double ten = 1;
        for (int64_t k = part < 0 ? -part : part; k > 0; k--) {
            ten *= 10;
        }
        if (part > 0 && x.high > DBL_MAX / ten) {
            return (taut_twice){HUGE_VAL, 0};
        }
        x = part < 0 ? taut_twice_over_number(x, ten) : taut_twice_scale(ten, x);
        power -= part;
    }
    return x;
}

/* Is x, right to 2^-60 of it, far enough from the middle of two doubles? */
static int is_clear(taut_twice x)
{
    const double slack = 0x1p-58 * x.high;
    return x.high > 0x1p-900 && x.high < 0x1p1000 &&
           x.high + (x.low + slack) == x.high + (x.low - slack);
}

/* ---- exactly ---- */

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

/* a = the digits times 2^shift */
static void fill(whole *a, const digits *number, int shift)
{
    a->count = 0;
    for (size_t i = 0; i < number->count;) {
        uint32_t part = 0, factor = 1;
        for (; i < number->count && factor < 1000000000; i++, factor *= 10) {
            part = 10 * part + (uint32_t)(number->text[i] - '0');
        }
        multiply_add(a, factor, part);
    }
    for (; shift >= 31; shift -= 31) {
        multiply_add(a, UINT32_C(1) << 31, 0);
    }
    multiply_add(a, UINT32_C(1) << shift, 0);
}

static int compare(const whole *a, const whole *b)
{
    if (a->count != b->count) {
        return a->count < b->count ? -1 : 1;
    }
    for (int i = a->count - 1; i >= 0; i--) {
        if (a->limb[i] != b->limb[i]) {
            return a->limb[i] < b->limb[i] ? -1 : 1;
        }
    }
    return 0;
}

/* p / q against the middle between the double of these bits and the next: -1, 0, 1. */
static int compare_middle(const digits *p, const digits *q, uint64_t bits)
{
    const uint64_t fraction = bits & ((UINT64_C(1) << 52) - 1), exponent = bits >> 52;
    const uint64_t m = exponent > 0 ? fraction | UINT64_C(1) << 52 : fraction, middle = 2 * m + 1;
    const int e = (exponent > 0 ? (int)exponent : 1) - 1076;
    whole left, right, low;

    fill(&left, p, e < 0 ? -e : 0);
    fill(&right, q, e > 0 ? e : 0);
    low = right;
    multiply_add(&right, (uint32_t)(middle >> 32), 0); /* times 54 bits, in two parts */
    multiply_add(&right, UINT32_C(1) << 31, 0);
    multiply_add(&right, 2, 0);
    multiply_add(&low, (uint32_t)middle, 0);
    uint64_t carry = 0;
    for (int i = 0; i < right.count || carry > 0 || i < low.count; i++) {
        carry +=
            (i < right.count ? right.limb[i] : 0) + (uint64_t)(i < low.count ? low.limb[i] : 0);
        right.limb[i] = (uint32_t)carry;
        right.count = i < right.count ? right.count : i + 1;
        carry >>= 32;
    }
    while (right.count > 0 && right.limb[right.count - 1] == 0) {
        right.count--;
    }
    return compare(&left, &right);
}

/* From v, which is near, to the nearest; infinite from the middle beyond the largest double on. */
static double settle(const digits *p, const digits *q, double v)
{
    static const uint64_t infinite = UINT64_C(0x7ff) << 52;
    uint64_t bits = 0;
    int beyond = 0;

    v = v > DBL_MAX ? DBL_MAX : v;
    memcpy(&bits, &v, sizeof bits);
    for (; bits < infinite; bits++) {
        beyond = compare_middle(p, q, bits);
        if (beyond < 0 || (beyond == 0 && bits % 2 == 0)) {
            break;
        }
    }
    for (; bits > 0 && bits < infinite; bits--) {
        beyond = compare_middle(p, q, bits - 1);
        if (beyond > 0 || (beyond == 0 && bits % 2 == 0)) {
            break;
        }
    }
    memcpy(&v, &bits, sizeof v);
    return v;
}

int taut_rational_value(const char *text, double *value)
{
    const int negative = *text == '-';
    digits top = {.text = NULL}, bottom = {.text = "1", .count = 1, .first = 1};
    const char *rest = read_digits(text + negative, &top);

    if (rest != NULL && *rest == '/') {
        rest = read_digits(rest + 1, &bottom);
    }
    if (rest == NULL || *rest != '\0' || rest - text > TAUT_RATIONAL_MAX || bottom.first == 0) {
        return 0;
    }
    const taut_twice near = scale(taut_twice_over(twice_of(top.first), twice_of(bottom.first)),
                                  top.power - bottom.power);
    const double size = top.first == 0   ? 0
                        : is_clear(near) ? taut_twice_round(near)
                                         : settle(&top, &bottom, near.high + near.low);
    *value = negative ? -size : size;
    return 1;
}
