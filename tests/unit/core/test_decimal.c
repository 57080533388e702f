/* test_decimal.c -- decimals and doubles, against the C library's printf and strtod where those round right.
 *
 * needs: strtod
 */
#include "check.h"

#include "core/decimal.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static void check_value(const char *text)
{
    const double expected = strtod(text, NULL), found = taut_decimal_value(text, strlen(text));
    CHECK(memcmp(&found, &expected, sizeof found) == 0, "%.60s: found %a, expected %a", text, found,
          expected);
}

static void check_digits(double x)
{
    char printed[64], own[64];
    for (int precision = 1; precision <= 18; precision++) {
        int exponent = 0;
        const uint64_t digits = taut_decimal_digits(x, precision, &exponent);
        snprintf(own, sizeof own, "%llue%d", (unsigned long long)digits, exponent);
        snprintf(printed, sizeof printed, "%.*e", precision - 1, x);
        /* both as the text of whole digits: the point taken out */
        char plain[64];
        size_t n = 0;
        for (const char *c = printed; *c != 'e'; c++) {
            if (*c != '.') {
                plain[n++] = *c;
            }
        }
        const int last = atoi(strchr(printed, 'e') + 1) - precision + 1;
        snprintf(plain + n, sizeof plain - n, "e%d", last);
        const int is_rounded_up = strlen(own) > 1 && (int)strcspn(own, "e") == precision + 1;
        CHECK(is_rounded_up || strcmp(own, plain) == 0, "%a to %d digits: %s, expected %s", x,
              precision, own, plain);
        CHECK(!is_rounded_up || strtod(own, NULL) == strtod(printed, NULL),
              "%a to %d digits: %s, expected %s", x, precision, own, printed);
    }
}

/* x, its exact value with all digits, and what lies a little above and below. */
static void check_exact(double x)
{
    char text[1200];
    const int length = snprintf(text, sizeof text, "%.780e", x);
    char *const last = strchr(text, 'e') - 1;
    CHECK(length > 0 && length < (int)sizeof text, "%a", x);
    check_value(text);
    *last = '1';
    check_value(text);
}

/* The middle between a double and the next is a decimal with one digit more, from sums of their digits. */
static void check_middle(double x)
{
    enum { PLACES = 1080 };
    char a[1500], b[1500], middle[1500];
    int carry = 0;
    snprintf(a, sizeof a, "%.*f", PLACES, x);
    snprintf(b, sizeof b, "%.*f", PLACES, nextafter(x, INFINITY));
    const size_t n = strlen(a);
    if (strlen(b) != n) {
        return;
    }
    middle[0] = '0';
    for (size_t i = n; i-- > 0;) { /* the sum, with a digit in front */
        const int sum = a[i] - '0' + b[i] - '0' + carry;
        middle[i + 1] = a[i] == '.' ? '.' : (char)('0' + sum % 10);
        carry = a[i] == '.' ? carry : sum / 10;
    }
    middle[0] = (char)('0' + carry);
    middle[n + 1] = '\0';
    int rest = 0; /* halved */
    for (size_t i = 0; i <= n; i++) {
        if (middle[i] != '.') {
            const int now = 10 * rest + middle[i] - '0';
            middle[i] = (char)('0' + now / 2);
            rest = now % 2;
        }
    }
    CHECK(rest == 0, "%a", x);
    check_value(middle);
    strcpy(middle + n + 1, "00001");
    check_value(middle);
    for (size_t i = n; middle[i] != '.' && i > 0;
         i--) { /* a little below, where its last digit is not 0 */
        if (middle[i] > '0') {
            middle[i]--;
            middle[i + 1] = '\0';
            check_value(middle);
            return;
        }
    }
}

static void test_random(void)
{
    for (int i = 0; i < random_trials(3000); i++) {
        const uint64_t bits = random_bits() & 0x7fffffffffffffff;
        double x = 0;
        memcpy(&x, &bits, sizeof x);
        if (isfinite(x) && x > 0) {
            check_digits(x);
            check_exact(x);
        }
        check_middle(ldexp(random_in(0.5, 1), random_int(-1040, 60)));
        char text[64];
        snprintf(text, sizeof text, "%llu.%llue%d", (unsigned long long)random_bits(),
                 (unsigned long long)random_bits() >> 1, random_int(-350, 300));
        check_value(text);
    }
}

static void test_edges(void)
{
    static const char *const texts[] = {"0",
                                        "-0",
                                        "-0e9",
                                        "0.000",
                                        "+1",
                                        ".5",
                                        "5.",
                                        "1e400",
                                        "-1e400",
                                        "1e-400",
                                        "-1e-400",
                                        "1e99999999999999999999",
                                        "1e-99999999999999999999",
                                        "0e99999999999999999999",
                                        "1.7976931348623157e308",
                                        "1.7976931348623158e308",
                                        "1.7976931348623159e308",
                                        "179769313486231580793e288",
                                        "4.9e-324",
                                        "2.4703282292062327e-324",
                                        "2.4703282292062328e-324",
                                        "2.2250738585072011e-308",
                                        "2.2250738585072014e-308",
                                        "9007199254740993",
                                        "9007199254740992.99999",
                                        "9007199254740993.00001",
                                        "1.868775676978051e196",
                                        "9.5466761359362636e-153",
                                        "123456789E-5",
                                        "1e+5"};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        check_value(texts[i]);
    }
    for (int k = -1074; k <= 1023; k++) {
        check_digits(ldexp(1, k));
        check_exact(ldexp(1, k));
        check_middle(ldexp(1, k < 60 ? k : 0));
        if (k > -1074) {
            check_exact(nextafter(ldexp(1, k), 0));
        }
    }
    for (int k = -323; k <= 308; k++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", k);
        check_value(text);
        check_digits(strtod(text, NULL));
    }
    check_digits(DBL_MAX);
    check_digits(DBL_TRUE_MIN);
}

/* More digits than are kept: what is beyond says above or below the middle of 1 and the next double. */
static void test_many_digits(void)
{
    static const char middle[] = "1.00000000000000011102230246251565404236316680908203125";
    char text[3000];
    memset(text, '0', sizeof text);
    memcpy(text, middle, sizeof middle - 1);
    text[2990] = '\0';
    check_value(text);
    text[2980] = '3';
    check_value(text);
    CHECK(taut_decimal_value(text, 2990) > 1 && taut_decimal_value(text, 2980) == 1,
          "the digit beyond");
    memset(text, '0', sizeof text);
    text[0] = '7';
    text[2990] = '\0';
    check_value(text);
    memcpy(text + 2900, "e-2890", 7);
    check_value(text);
}

int main(void)
{
    random_seed(20261123);
    test_random();
    test_edges();
    test_many_digits();
    return check_failures != 0;
}
