/* The elementary functions against MPFR, on arguments of all sizes and where they are hard; errors in units of
 * the last place of the exact value. `TRIALS [SEED]`: so many times three arguments of each function, or nine pairs,
 * in place of 6,000. links: mpfr gmp */
#include "check.h"

#include "core/elementary/elementary.h"

#include <float.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

enum { PRECISION = 256 };

typedef struct function {
    const char *name;
    double (*own)(double);
    int (*exact)(mpfr_t, const mpfr_t, mpfr_rnd_t);
    double lo, hi; /* where it is finite and not a constant */
    double limit;  /* units in the last place: above the worst of a million arguments */
} function;

static const function functions[] = {
    {"exp", taut_exp, mpfr_exp, -746, 710, 0.51},
    {"exp2", taut_exp2, mpfr_exp2, -1075, 1024, 0.51},
    {"expm1", taut_expm1, mpfr_expm1, -40, 710, 0.53},
    {"log", taut_log, mpfr_log, 0, DBL_MAX, 0.51},
    {"log2", taut_log2, mpfr_log2, 0, DBL_MAX, 0.51},
    {"log10", taut_log10, mpfr_log10, 0, DBL_MAX, 0.51},
    {"sin", taut_sin, mpfr_sin, -DBL_MAX, DBL_MAX, 0.51},
    {"cos", taut_cos, mpfr_cos, -DBL_MAX, DBL_MAX, 0.51},
    {"tan", taut_tan, mpfr_tan, -DBL_MAX, DBL_MAX, 0.51},
    {"asin", taut_asin, mpfr_asin, -1, 1, 0.51},
    {"acos", taut_acos, mpfr_acos, -1, 1, 0.51},
    {"atan", taut_atan, mpfr_atan, -DBL_MAX, DBL_MAX, 0.51},
    {"sinh", taut_sinh, mpfr_sinh, -711, 711, 0.53},
    {"cosh", taut_cosh, mpfr_cosh, -711, 711, 0.51},
    {"tanh", taut_tanh, mpfr_tanh, -20, 20, 0.53},
};

/* |found - exact| in units of the last place of a double of the size of `exact`. */
static double error_of(double found, const mpfr_t exact)
{
    mpfr_t difference;
    double error = 0;
    if (isinf(found)) { /* rounds to 2^1024 */
        mpfr_init2(difference, PRECISION);
        mpfr_set_ui_2exp(difference, 1, 1024, MPFR_RNDN);
        mpfr_setsign(difference, difference, found < 0, MPFR_RNDN);
        mpfr_sub(difference, difference, exact, MPFR_RNDN);
        error = mpfr_sgn(difference) * (found > 0 ? 1 : -1) <= 0
                    ? 0
                    : fabs(mpfr_get_d(difference, MPFR_RNDN)) / 0x1p971;
        mpfr_clear(difference);
        return error;
    }
    const mpfr_exp_t e = mpfr_zero_p(exact) ? -1074 : mpfr_get_exp(exact) - 53;
    mpfr_init2(difference, PRECISION);
    mpfr_sub_d(difference, exact, found, MPFR_RNDN);
    mpfr_mul_2si(difference, difference, -(e < -1074 ? -1074 : e), MPFR_RNDN);
    error = fabs(mpfr_get_d(difference, MPFR_RNDN));
    mpfr_clear(difference);
    return error;
}

static double error_at(const function *f, double x)
{
    mpfr_t at;
    mpfr_init2(at, PRECISION);
    mpfr_set_d(at, x, MPFR_RNDN);
    f->exact(at, at, MPFR_RNDN);
    const double error = error_of(f->own(x), at);
    mpfr_clear(at);
    return error;
}

/* The worst argument so far, and how bad. */
typedef struct worst {
    double error, x, y;
} worst;

static void try_at(const function *f, double x, worst *w)
{
    if (!(x >= f->lo && x <= f->hi) || (f->lo == 0 && x == 0)) {
        return;
    }
    const double error = error_at(f, x);
    if (!(error <= w->error)) {
        *w = (worst){error, x, 0};
    }
}

/* A double of any size. */
static double any_size(void)
{
    return ldexp(random_in(1, 2), random_int(-1074, 1023)) * (random_int(0, 1) == 0 ? 1 : -1);
}

/* The double next to k pi/2, `steps` on. */
static double near_multiple(double k, int steps)
{
    mpfr_t pi;
    mpfr_init2(pi, 1300);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul_d(pi, pi, k / 2, MPFR_RNDN);
    double x = mpfr_get_d(pi, MPFR_RNDN);
    mpfr_clear(pi);
    for (; steps > 0; steps--) {
        x = nextafter(x, HUGE_VAL);
    }
    return x;
}

/* Near the ends, near 0 and 1, near multiples of pi/2 of all sizes, where tables change, and the doubles that
 * come nearest of all to a multiple of pi/2 ([Muller2016] 11.2.1). */
static void try_hard(const function *f, worst *w)
{
    static const double places[] = {1,
                                    0.5,
                                    0.25,
                                    2,
                                    1.4140625,
                                    0.70703125,
                                    0.78,
                                    0x1p20,
                                    0x1p-40,
                                    0x1p-22,
                                    709.78271289338397,
                                    -745.13321910194122,
                                    -708.39641853226408,
                                    710.4758600739439,
                                    1023.9999,
                                    -1074,
                                    -1022,
                                    0x1p-1022,
                                    5e-324,
                                    DBL_MAX,
                                    6381956970095103.0 * 0x1p797,
                                    0x1.6ac5b262ca1ffp+849,
                                    5.31937264832654141671e+255};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        double up = places[i], down = places[i];
        for (int k = 0; k < 30; k++) {
            try_at(f, up, w);
            try_at(f, down, w);
            try_at(f, -up, w);
            try_at(f, -down, w);
            up = nextafter(up, HUGE_VAL);
            down = nextafter(down, -HUGE_VAL);
        }
    }
    for (int k = 0; k < 400; k++) {
        const double n = k < 200 ? k : floor(ldexp(random_in(1, 2), random_int(8, 1000)));
        for (int steps = 0; steps < 3; steps++) {
            try_at(f, near_multiple(n, steps), w);
        }
        try_at(f, ldexp(1 + 0.0078125 * random_int(0, 128), random_int(-3, 3)), w);
        try_at(f, random_int(-32 * 40, 32 * 40) / 32.0 + random_in(-1, 1) * 0x1p-40, w);
        try_at(f, (random_int(-32 * 40, 32 * 40) + 0.5) / 32.0 + random_in(-1, 1) * 0x1p-40, w);
    }
}

static void test_function(const function *f, int trials)
{
    worst w = {0, 0, 0};
    for (int i = 0; i < trials; i++) {
        try_at(f, any_size(), &w);
        try_at(f, ldexp(random_in(-1, 1), random_int(-12, 12)), &w);
        try_at(f, random_in(fmax(f->lo, -800), fmin(f->hi, 800)), &w);
    }
    try_hard(f, &w);
    printf("%-6s %.4f ulp at %.17g\n", f->name, w.error, w.x);
    CHECK(w.error <= f->limit, "%s: %.4f ulp at %a", f->name, w.error, w.x);
}

typedef struct function2 {
    const char *name;
    double (*own)(double, double);
    int (*exact)(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);
    double limit;
} function2;

static const function2 functions2[] = {
    {"pow", taut_pow, mpfr_pow, 0.53},
    {"atan2", taut_atan2, mpfr_atan2, 0.51},
    {"hypot", taut_hypot, mpfr_hypot, 0.51},
};

static void try_both(const function2 *f, double x, double y, worst *w)
{
    mpfr_t a, b;
    mpfr_init2(a, PRECISION);
    mpfr_init2(b, PRECISION);
    mpfr_set_d(a, x, MPFR_RNDN);
    mpfr_set_d(b, y, MPFR_RNDN);
    f->exact(a, a, b, MPFR_RNDN);
    if (mpfr_number_p(a)) {
        const double error = error_of(f->own(x, y), a);
        if (!(error <= w->error)) {
            *w = (worst){error, x, y};
        }
    }
    mpfr_clear(a);
    mpfr_clear(b);
}

static void test_function2(const function2 *f, int trials)
{
    worst w = {0, 0, 0};
    for (int i = 0; i < trials; i++) {
        const double x = any_size(), y = any_size(),
                     near_1 = 1 + ldexp(random_in(-1, 1), random_int(-52, -1));
        const double power = random_in(-745.2, 710) / log(fabs(x));
        try_both(f, x, y, &w);
        try_both(f, x, random_in(-2, 2) * x, &w);
        try_both(f, x, ldexp(x, random_int(-70, 70)) * random_in(-1, 1), &w);
        try_both(f, random_in(0, 4), random_in(-20, 20), &w);
        try_both(f, fabs(x), power, &w);
        try_both(f, near_1, random_in(-745.2, 710) / log1p(near_1 - 1), &w);
        try_both(f, random_int(-12, 12), random_int(-12, 12), &w);
        try_both(f, random_in(-3, 3), random_int(-300, 300), &w);
        try_both(f, random_int(0, 1 << 26) * 0x1p-1074, random_int(0, 1 << 26) * 0x1p-1074, &w);
    }
    printf("%-6s %.4f ulp at %.17g, %.17g\n", f->name, w.error, w.x, w.y);
    CHECK(w.error <= f->limit, "%s: %.4f ulp at %a, %a", f->name, w.error, w.x, w.y);
}

/* Powers of ten and of small whole numbers that are doubles come out exactly. */
static void test_exact(void)
{
    double ten = 1;
    for (int k = 0; k <= 22; k++, ten *= 10) {
        CHECK(taut_pow(10, k) == ten, "10^%d", k);
        CHECK(taut_log10(ten) == k, "log10 1e%d", k);
    }
    for (int k = -1074; k < 1024; k++) {
        CHECK(taut_exp2(k) == ldexp(1, k), "2^%d", k);
        CHECK(taut_log2(ldexp(1, k)) == k, "log2 2^%d", k);
    }
    for (int n = 3; n <= 20; n++) {
        for (double k = 1, power = n; power < 0x1p53; k++, power *= n) {
            CHECK(taut_pow(n, k) == power && taut_pow(-n, k) == (fmod(k, 2) != 0 ? -power : power),
                  "%d^%g", n, k);
        }
    }
    CHECK(taut_hypot(3, 4) == 5 && taut_hypot(0x3p-1074, 0x4p-1074) == 0x5p-1074, "3, 4, 5");
}

static int is_same(double a, double b)
{
    return (isnan(a) && isnan(b)) || memcmp(&a, &b, sizeof a) == 0;
}

/* C17, Annex F.10. */
static void test_special(void)
{
    static const double inf = HUGE_VAL, none = NAN, pi = 0x1.921fb54442d18p+1;
    const struct {
        double (*own)(double);
        double x, value;
    } one[] = {
        {taut_exp, 0, 1},           {taut_exp, -inf, 0},     {taut_exp, inf, inf},
        {taut_exp, 1e4, inf},       {taut_exp, -1e4, 0},     {taut_exp, 709.79, inf},
        {taut_exp, 999, inf},       {taut_exp, -999, 0},     {taut_exp2, 0, 1},
        {taut_exp2, -inf, 0},       {taut_exp2, inf, inf},   {taut_exp2, 1024, inf},
        {taut_exp2, -1080, 0},      {taut_expm1, 0, 0},      {taut_expm1, -0.0, -0.0},
        {taut_expm1, -inf, -1},     {taut_expm1, inf, inf},  {taut_log, 1, 0},
        {taut_log, 0, -inf},        {taut_log, -0.0, -inf},  {taut_log, -1, none},
        {taut_log, inf, inf},       {taut_log, -inf, none},  {taut_log2, 1, 0},
        {taut_log2, 0, -inf},       {taut_log2, -1, none},   {taut_log2, inf, inf},
        {taut_log10, 1, 0},         {taut_log10, 0, -inf},   {taut_log10, -1, none},
        {taut_log10, inf, inf},     {taut_sin, 0, 0},        {taut_sin, -0.0, -0.0},
        {taut_sin, inf, none},      {taut_sin, -inf, none},  {taut_cos, 0, 1},
        {taut_cos, inf, none},      {taut_tan, -0.0, -0.0},  {taut_tan, inf, none},
        {taut_asin, -0.0, -0.0},    {taut_asin, 1, pi / 2},  {taut_asin, -1, -pi / 2},
        {taut_asin, 1.5, none},     {taut_asin, inf, none},  {taut_acos, 1, 0},
        {taut_acos, -1, pi},        {taut_acos, 0, pi / 2},  {taut_acos, -1.5, none},
        {taut_acos, inf, none},     {taut_atan, -0.0, -0.0}, {taut_atan, inf, pi / 2},
        {taut_atan, -inf, -pi / 2}, {taut_sinh, -0.0, -0.0}, {taut_sinh, inf, inf},
        {taut_sinh, -inf, -inf},    {taut_sinh, -711, -inf}, {taut_sinh, 801, inf},
        {taut_cosh, 0, 1},          {taut_cosh, inf, inf},   {taut_cosh, -inf, inf},
        {taut_cosh, -711, inf},     {taut_cosh, 801, inf},   {taut_tanh, -0.0, -0.0},
        {taut_tanh, inf, 1},        {taut_tanh, -inf, -1},   {taut_tanh, -800, -1},
    };
    for (size_t i = 0; i < sizeof one / sizeof *one; i++) {
        CHECK(is_same(one[i].own(one[i].x), one[i].value), "row %zu: f(%g) = %g, not %g", i,
              one[i].x, one[i].own(one[i].x), one[i].value);
    }
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        CHECK(isnan(functions[i].own(NAN)), "%s of NaN", functions[i].name);
    }
    const struct {
        double (*own)(double, double);
        double x, y, value;
    } two[] = {
        {taut_pow, 0, 3, 0},
        {taut_pow, -0.0, 3, -0.0},
        {taut_pow, -0.0, 2, 0},
        {taut_pow, -0.0, -3, -inf},
        {taut_pow, 0, -3, inf},
        {taut_pow, -0.0, -2, inf},
        {taut_pow, 0, -inf, inf},
        {taut_pow, -1, inf, 1},
        {taut_pow, -1, -inf, 1},
        {taut_pow, 1, none, 1},
        {taut_pow, none, 0, 1},
        {taut_pow, -2, 0.5, none},
        {taut_pow, 0.5, -inf, inf},
        {taut_pow, 2, -inf, 0},
        {taut_pow, 0.5, inf, 0},
        {taut_pow, -2, inf, inf},
        {taut_pow, -inf, -3, -0.0},
        {taut_pow, -inf, -2, 0},
        {taut_pow, -inf, 3, -inf},
        {taut_pow, -inf, 2, inf},
        {taut_pow, inf, -1, 0},
        {taut_pow, inf, 1, inf},
        {taut_pow, none, 1, none},
        {taut_pow, 2, none, none},
        {taut_pow, 2, 1e300, inf},
        {taut_pow, 0.5, 1e300, 0},
        {taut_pow, -2, 1025, -inf},
        {taut_pow, 1e300, 1e-300, 1},
        {taut_pow, -0.0, 0.5, 0},
        {taut_pow, -1, 0x1p60, 1},
        {taut_atan2, 0, 0, 0},
        {taut_atan2, -0.0, 0, -0.0},
        {taut_atan2, 0, -0.0, pi},
        {taut_atan2, -0.0, -0.0, -pi},
        {taut_atan2, 0, -1, pi},
        {taut_atan2, -0.0, 1, -0.0},
        {taut_atan2, -1, 0, -pi / 2},
        {taut_atan2, 1, -inf, pi},
        {taut_atan2, -1, inf, -0.0},
        {taut_atan2, inf, 1, pi / 2},
        {taut_atan2, inf, inf, pi / 4},
        {taut_atan2, -inf, -inf, -3 * pi / 4},
        {taut_atan2, none, 1, none},
        {taut_atan2, 1, none, none},
        {taut_hypot, inf, none, inf},
        {taut_hypot, none, -inf, inf},
        {taut_hypot, none, 1, none},
        {taut_hypot, 1, none, none},
        {taut_hypot, -0.0, 0, 0},
        {taut_hypot, -2, 0, 2},
        {taut_hypot, DBL_MAX, DBL_MAX, inf},
    };
    for (size_t i = 0; i < sizeof two / sizeof *two; i++) {
        CHECK(is_same(two[i].own(two[i].x, two[i].y), two[i].value),
              "row %zu: f(%g, %g) = %g, not %g", i, two[i].x, two[i].y,
              two[i].own(two[i].x, two[i].y), two[i].value);
    }
}

/* Of both functions at once, the bits of each. */
static void test_pairs(int trials)
{
    static const double marks[] = {
        0,        -0.0,      0x1p-41, -0x1p-41, 0x1p-40, 0.25, -0.25, 0x1.fffffffffffffp-3,
        1e22,     700,       711,     -711,     799,     800,  -801,  DBL_MAX,
        HUGE_VAL, -HUGE_VAL, NAN};
    const int count = (int)(sizeof marks / sizeof *marks);

    for (int k = 0; k < count + trials; k++) {
        const double x = k < count ? marks[k] : ldexp(random_in(-1, 1), k % 40 - 28);
        double first, second;
        taut_sin_cos(x, &first, &second);
        CHECK(is_same(first, taut_sin(x)), "sine of %a beside the cosine", x);
        CHECK(is_same(second, taut_cos(x)), "cosine of %a beside the sine", x);
        taut_sinh_cosh(x, &first, &second);
        CHECK(is_same(first, taut_sinh(x)), "sinh of %a beside cosh", x);
        CHECK(is_same(second, taut_cosh(x)), "cosh of %a beside sinh", x);
    }
}

int main(int argc, char **argv)
{
    const int trials = argc > 1 ? atoi(argv[1]) : random_trials(6000);
    random_seed(argc > 2 ? (unsigned)atoi(argv[2]) : 21);
    test_pairs(random_trials(20000));
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        test_function(&functions[i], trials);
    }
    for (size_t i = 0; i < sizeof functions2 / sizeof *functions2; i++) {
        test_function2(&functions2[i], trials);
    }
    test_exact();
    test_special();
    printf("%d arguments of each function of one, %d pairs of each of two\n", 3 * trials,
           9 * trials);
    return check_failures != 0;
}
