/* test_number_text.c -- numbers as text: against printf and strtod, digit by digit.
 *
 * needs: strtod, of the C library, that rounds right
 */
#include "check.h"

#include "core/number_text.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* The significant digits of a number's text, without leading and trailing zeros. */
static void digits_of(const char *text, char *digits)
{
    size_t n = 0;
    for (const char *c = text; *c != '\0' && *c != 'e'; c++) {
        if (*c >= '0' && *c <= '9' && (n > 0 || *c != '0')) {
            digits[n++] = *c;
        }
    }
    while (n > 0 && digits[n - 1] == '0') {
        n--;
    }
    digits[n] = '\0';
}

/* The text reads back bit for bit, has the digits of the first of %.15g, %.16g, %.17g that does,
 * and is a JSON number. */
static void check_number(double x)
{
    char text[TAUT_NUMBER_ROOM], printed[64], digits[64], expected[64];
    const size_t length = taut_number_text(x, text);
    char *end = NULL;
    const double back = strtod(text, &end);
    int precision = 15;

    CHECK(length == strlen(text) && *end == '\0', "%a gives \"%s\"", x, text);
    CHECK(memcmp(&x, &back, sizeof x) == 0, "%a gives \"%s\", which is %a", x, text, back);
    for (; precision <= 17; precision++) {
        snprintf(printed, sizeof printed, "%.*g", precision, x);
        if (strtod(printed, NULL) == x) {
            break;
        }
    }
    digits_of(text, digits);
    digits_of(printed, expected);
    CHECK(strcmp(digits, expected) == 0, "%a gives \"%s\", printf \"%s\"", x, text, printed);
    const char *first = text + (text[0] == '-');
    CHECK(*first >= '0' && *first <= '9' &&
              !(first[0] == '0' && first[1] >= '0' && first[1] <= '9'),
          "%a gives \"%s\", which is not JSON", x, text);
}

static void test_random_bits(void)
{
    for (int i = 0; i < 60000; i++) {
        const uint64_t bits = random_bits();
        double x = 0;
        memcpy(&x, &bits, sizeof x);
        if (isfinite(x)) {
            check_number(x);
        }
    }
}

/* The sizes of coordinates, of all lengths of decimals, and their neighbours. */
static void test_usual_sizes(void)
{
    for (int i = 0; i < 60000; i++) {
        const double scale = pow(10, random_int(-16, 17));
        const double round = random_int(-1000000, 1000000) / pow(10, random_int(0, 12));
        check_number(random_in(-1, 1) * scale);
        check_number(round);
        check_number(nextafter(round, INFINITY));
    }
}

/* Powers of two, whose neighbours below are nearer; powers of ten; both with neighbours. */
static void test_edges(void)
{
    for (int k = -1074; k <= 1023; k++) {
        const double x = ldexp(1, k);
        check_number(x);
        check_number(nextafter(x, 0));
        check_number(-nextafter(x, INFINITY));
    }
    for (int k = -320; k <= 308; k++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", k);
        const double x = strtod(text, NULL);
        check_number(x);
        check_number(nextafter(x, 0));
        check_number(nextafter(x, INFINITY));
    }
    check_number(DBL_MAX);
    check_number(-DBL_MAX);
    check_number(DBL_TRUE_MIN);
    check_number(9007199254740993.0);
}

static void check_text(double x, const char *expected)
{
    char text[TAUT_NUMBER_ROOM];
    taut_number_text(x, text);
    CHECK(strcmp(text, expected) == 0, "found \"%s\", expected \"%s\"", text, expected);
}

static void test_layout(void)
{
    check_text(0, "0");
    check_text(-0.0, "-0");
    check_text(1, "1");
    check_text(-12, "-12");
    check_text(0.1, "0.1");
    check_text(-0.25, "-0.25");
    check_text(1e-5, "0.00001");
    check_text(1.5e-7, "1.5e-7");
    check_text(123456.789, "123456.789");
    check_text(1e15, "1000000000000000");
    check_text(1e22, "1e22");
    check_text(6.02214076e23, "6.02214076e23");
    check_text(0.1 + 0.2, "0.30000000000000004");
    check_text(INFINITY, "null");
    check_text(nan(""), "null");
}

int main(void)
{
    random_seed(20240611);
    test_random_bits();
    test_usual_sizes();
    test_edges();
    test_layout();
    return check_failures != 0;
}
