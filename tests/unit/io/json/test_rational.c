/* test_rational.c -- the doubles of rational texts against MPFR: quotients of whole numbers of up to 330 digits.
 * links: mpfr gmp */
#include "check.h"

#include "io/json/number_value.h"

#include <mpfr.h>
#include <stdlib.h>

static size_t put_digits(char *text, int digits)
{
    for (int i = 0; i < digits; i++) {
        text[i] = (char)('0' + random_int(i == 0, 9));
    }
    return (size_t)digits;
}

/* The error in units in the last place of doubles of that size, 2^-1022 the least. */
static double error_of(double found, const char *text)
{
    mpq_t q;
    mpfr_t exact;
    mpq_init(q);
    mpfr_init2(exact, 400);
    CHECK(mpq_set_str(q, text, 10) == 0, "%s", text);
    mpq_canonicalize(q);
    mpfr_set_q(exact, q, MPFR_RNDN);
    const double nearest = mpfr_get_d(exact, MPFR_RNDN);
    double error = HUGE_VAL;
    if (isinf(nearest) || isinf(found)) {
        error = nearest == found ? 0 : HUGE_VAL;
    } else {
        const long e = mpfr_zero_p(exact) ? -1021 : mpfr_get_exp(exact);
        mpfr_sub_d(exact, exact, found, MPFR_RNDN);
        mpfr_mul_2si(exact, exact, 53 - (e < -1021 ? -1021 : e), MPFR_RNDN);
        error = fabs(mpfr_get_d(exact, MPFR_RNDN));
    }
    mpq_clear(q);
    mpfr_clear(exact);
    return error;
}

int main(void)
{
    double worst = 0;
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
        const double error = error_of(value, text);
        worst = fmax(worst, error);
        CHECK(error <= 0.51, "%s: %.17g is off by %g", text, value, error);
    }
    printf("%.4f units in the last place\n", worst);
    return check_failures != 0;
}
