/* test_bracket.c -- roots and largest values between two places: against closed forms, with few calls, and with jumps and kinks. */
#include "check.h"

#include "numeric/bracket.h"

#include <math.h>

static int calls;

typedef struct shape {
    int kind;
    double place;
} shape;

static double at(const void *context, double t)
{
    const shape *s = context;
    const double d = t - s->place;
    calls++;
    switch (s->kind) {
    case 0:
        return exp(d) - 1;
    case 1:
        return d * d * d + d / 8;
    case 2:
        return d < 0 ? -1 : 2; /* a jump */
    case 3:
        return d * d * d * d * d; /* flat */
    case 4:
        return -d * d * (1 + d / 3);
    case 5:
        return -fabs(d); /* a kink */
    case 6:
        return cos(d);
    default:
        return 1; /* level */
    }
}

static void test_roots(void)
{
    /* The most calls that were seen, of 1000 places each. */
    const struct {
        int most;
        double near;
    } rows[] = {{11, 3e-16}, {12, 4e-16}, {54, 9e-16}, {80, 1e-15}};

    for (int kind = 0; kind < 4; kind++) {
        int most = 0;
        double off = 0;
        for (int k = 1; k <= 1000; k++) {
            const shape s = {kind, k / 1001.0};
            calls = 0;
            const double t = taut_bracket_root(at, &s, 0, 1, at(&s, 0), at(&s, 1));
            most = calls > most ? calls : most;
            off = fmax(off, fabs(t - s.place));
        }
        CHECK(most <= rows[kind].most, "kind %d: %d calls", kind, most);
        CHECK(off <= rows[kind].near, "kind %d: %g off", kind, off);
    }
}

static void test_most(void)
{
    const struct {
        int most;
        double near, value;
    } rows[] = {{16, 2e-8, 0}, {45, 2e-8, 0}, {27, 3e-8, 1}, {60, 1, 1}};

    for (int kind = 4; kind < 8; kind++) {
        int most = 0;
        double off = 0, less = 0;
        for (int k = 1; k <= 1000; k++) {
            const shape s = {kind, k / 1001.0};
            double t = -1;
            calls = 0;
            const double value = taut_bracket_most(at, &s, 0, 1, &t);
            most = calls > most ? calls : most;
            off = fmax(off, fabs(t - s.place));
            less = fmax(less, rows[kind - 4].value - value);
            CHECK(t >= 0 && t <= 1, "kind %d: at %g", kind, t);
        }
        CHECK(most <= rows[kind - 4].most, "kind %d: %d calls", kind, most);
        CHECK(off <= rows[kind - 4].near, "kind %d: %g off", kind, off);
        CHECK(less <= (kind == 5 ? 2e-8 : 2e-15), "kind %d: %g less", kind, less);
    }
    /* At an end: as near as the place's rounding allows. */
    const shape rising = {0, 0};
    double t;
    CHECK_NEAR(taut_bracket_most(at, &rising, 0, 1, &t), exp(1) - 1, 1e-7, "at %g", t);
}

int main(void)
{
    test_roots();
    test_most();
    return check_failures != 0;
}
