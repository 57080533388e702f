/* test_rational.c -- the doubles of rational texts against fractions: quotients of whole numbers of up to 330 digits, and the
 * middles between doubles.
 * links: gmp */
#include "check.h"

#include "io/json/number_value.h"

#include <float.h>
#include <gmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static size_t put_digits(char *text, int digits)
{
    for (int i = 0; i < digits; i++) {
        text[i] = (char)('0' + random_int(i == 0, 9));
    }
    return (size_t)digits;
}

/* The double after x, from 0 on; 2^1024 after the largest. */
static void set_next(mpq_t next, double x, double towards)
{
    const double there = nextafter(x, towards);
    mpq_set_d(next, isinf(there) ? DBL_MAX : there);
    if (isinf(there)) {
        mpz_ui_pow_ui(mpq_numref(next), 2, 1024);
    }
}

static int is_even(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits % 2 == 0;
}

/* Is no neighbour nearer, and none as near that is even? In fractions, which are exact. */
static int is_nearest(double found, const char *text)
{
    mpq_t exact, here, next;
    mpq_inits(exact, here, next, (mpq_ptr)NULL);
    CHECK(mpq_set_str(exact, text, 10) == 0, "%s", text);
    mpq_canonicalize(exact);
    mpq_abs(exact, exact);
    const double size = fabs(found);
    if (isinf(size)) { /* from half way between the largest and 2^1024 on */
        mpz_ui_pow_ui(mpq_numref(here), 2, 1024);
        mpz_ui_pow_ui(mpq_numref(next), 2, 970);
        mpq_sub(here, here, next);
        const int right = mpq_cmp(exact, here) >= 0;
        mpq_clears(exact, here, next, (mpq_ptr)NULL);
        return right;
    }
    int right = 1;
    for (int side = 0; side < 2; side++) {
        set_next(next, size, side == 0 ? HUGE_VAL : -1);
        mpq_set_d(here, size);
        mpq_sub(next, next, exact);
        mpq_abs(next, next);
        mpq_sub(here, here, exact);
        mpq_abs(here, here);
        const int order = mpq_cmp(here, next);
        right = right && (order < 0 || (order == 0 && is_even(size)));
    }
    mpq_clears(exact, here, next, (mpq_ptr)NULL);
    return right;
}

/* (2 m + 1) 2^(e - 1), the middle between two doubles, times k / k and a unit of the numerator more or less: `by`. */
static void put_middle(char *text, int e, int digits, int by)
{
    char factor[400];
    mpz_t top, bottom, k;
    mpz_inits(top, bottom, k, (mpz_ptr)NULL);
    factor[put_digits(factor, digits)] = '\0';
    mpz_set_str(k, factor, 10);
    mpz_add_ui(k, k, 1);
    const uint64_t m = e > -1074 ? (UINT64_C(1) << 52) + (uint64_t)random_int(0, 1 << 30) * 4194301u
                                 : (uint64_t)random_int(0, 1 << 30);
    mpz_set_str(top, "0", 10);
    mpz_set_ui(top, (unsigned)(m >> 31));
    mpz_mul_2exp(top, top, 32);
    mpz_add_ui(top, top, (unsigned)(2 * (m & 0x7fffffff) + 1));
    mpz_set_ui(bottom, 1);
    if (e > 1) {
        mpz_mul_2exp(top, top, (unsigned)(e - 1));
    } else {
        mpz_mul_2exp(bottom, bottom, (unsigned)(1 - e));
    }
    mpz_mul(top, top, k);
    mpz_mul(bottom, bottom, k);
    if (by > 0) {
        mpz_add_ui(top, top, 1);
    } else if (by < 0) {
        mpz_sub_ui(top, top, 1);
    }
    gmp_sprintf(text, "%Zd/%Zd", top, bottom);
    mpz_clears(top, bottom, k, (mpz_ptr)NULL);
}

/* On the middle between two doubles, and as near to it as fractions of so many digits come. */
static void test_middles(void)
{
    for (int trial = 0; trial < random_trials(6000); trial++) {
        char text[3000];
        double value = nan("");
        const int e = trial % 7 == 0 ? -1074 : random_int(-1074, 971);
        put_middle(text, e, random_int(1, 300), trial % 3 - 1);
        CHECK(taut_rational_value(text, &value) && is_nearest(value, text), "2^%d: %s gives %.17g",
              e, text, value);
    }
}

/* The longest text there is, half way and beside it. */
static void test_longest(void)
{
    static char text[TAUT_RATIONAL_MAX + 1];
    const size_t half = (TAUT_RATIONAL_MAX - 1) / 2;
    for (int last = 0; last < 2; last++) {
        double value = 0;
        memset(text, '0', 2 * half + 1);
        memcpy(text, "9007199254740993", 16); /* 2^53 + 1, halved: half way */
        text[half - 1] = (char)('0' + last);
        text[half] = '/';
        text[half + 1] = '2';
        text[2 * half + 1] = '\0';
        CHECK(taut_rational_value(text, &value) && is_nearest(value, text), "%d: %.17g", last,
              value);
    }
}

int main(void)
{
    random_seed(9);
    for (int trial = 0; trial < random_trials(20000); trial++) {
        const int most = trial % 4 == 0 ? 330 : trial % 2 == 0 ? 40 : 19;
        char text[800];
        size_t n = 0;
        double value = 0;
        text[n] = '-';
        n += (size_t)random_int(0, 1);
        n += put_digits(text + n, random_int(1, most));
        if (trial % 3 != 0) {
            text[n++] = '/';
            n += put_digits(text + n, random_int(1, most));
        }
        text[n] = '\0';
        if (!taut_rational_value(text, &value)) {
            CHECK(n > TAUT_RATIONAL_MAX, "refused: %s", text);
            continue;
        }
        CHECK(is_nearest(value, text), "%s gives %.17g", text, value);
    }
    test_middles();
    test_longest();
    return check_failures != 0;
}
