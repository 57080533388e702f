/* test_lowest.c -- the lowest eigenvalue by Lanczos against closed forms: linear elements on an interval,
 *
 *     lambda_k = 6 / h^2 (1 - cos(k pi h)) / (2 + cos(k pi h)),    ends held
 *
 * two of them, whose eigenvalues come in pairs or nearly so, shifts far below, and numbers out of range. */
#include "certify/common/lowest.h"

#include "check.h"

#include <math.h>

enum { MOST = 900 };

/* One interval, or two side by side. */
typedef struct bars {
    int count, parts;
    double h[2]; /* of each part */
    double shift;
    int solved;    /* how often */
    int whole;     /* so many solutions are right */
    double broken; /* what those after them are multiplied by */
} bars;

static void weigh(const void *of, const double *x, double *y)
{
    const bars *b = of;
    for (int p = 0; p < b->parts; p++) {
        const double *from = x + p * b->count;
        for (int i = 0; i < b->count; i++) {
            const double left = i > 0 ? from[i - 1] : 0, right = i < b->count - 1 ? from[i + 1] : 0;
            y[p * b->count + i] = b->h[p] / 6 * (left + 4 * from[i] + right);
        }
    }
}

static double stiff(const bars *b, const double *x)
{
    double sum = 0;
    for (int p = 0; p < b->parts; p++) {
        double last = 0;
        for (int i = 0; i <= b->count; i++) {
            const double here = i < b->count ? x[p * b->count + i] : 0;
            sum += (here - last) * (here - last) / b->h[p];
            last = here;
        }
    }
    return sum;
}

static void solve(const void *of, double *x)
{
    bars *b = (bars *)of;
    double upper[MOST];

    b->solved++;
    for (int p = 0; p < b->parts; p++) {
        const double h = b->h[p], d = 2 / h - b->shift * 4 * h / 6, o = -1 / h - b->shift * h / 6;
        double *to = x + p * b->count;
        for (int i = 0; i < b->count; i++) {
            const double pivot = d - (i > 0 ? o * upper[i - 1] : 0);
            upper[i] = o / pivot;
            to[i] = (to[i] - (i > 0 ? o * to[i - 1] : 0)) / pivot;
        }
        for (int i = b->count - 2; i >= 0; i--) {
            to[i] -= upper[i] * to[i + 1];
        }
    }
    for (int i = 0; i < b->parts * b->count; i++) {
        x[i] *= b->solved > b->whole ? b->broken : 1;
    }
}

static double exact(const bars *b, int part)
{
    const double s = sin(0.5 * 3.14159265358979323846 / (b->count + 1)); /* 1 - cos = 2 s^2 */
    return 12 / (b->h[part] * b->h[part]) * s * s / (3 - 2 * s * s);
}

static taut_status find(bars *b, taut_pulse *pulse, double *lowest, double *mass)
{
    static double x[2 * MOST], y[2 * MOST];
    taut_arena *arena = taut_arena_new();
    const taut_lowest form = {
        .count = b->parts * b->count, .of = b, .solve = solve, .weigh = weigh, .work = 1e4};

    b->solved = 0;
    const taut_status status = taut_certify_lowest(&form, arena, pulse, x);
    weigh(b, x, y);
    *mass = 0;
    for (int i = 0; i < form.count; i++) {
        *mass += x[i] * y[i];
    }
    *lowest = stiff(b, x);
    taut_arena_free(arena);
    return status;
}

static void test_intervals(void)
{
    static const int counts[] = {1, 2, 3, 24, 25, 26, 100, MOST};

    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        for (int parts = 1; parts <= 2; parts++) {
            for (int shifted = 0; shifted < 2; shifted++) {
                taut_pulse pulse = {.what = "lowest"};
                double lowest = NAN, mass = NAN;
                bars b = {.count = counts[k], .parts = parts, .broken = 1};
                b.h[0] = b.h[1] = 1.0 / (b.count + 1);
                b.shift = shifted ? -100 : 0;
                const taut_status status = find(&b, &pulse, &lowest, &mass);
                CHECK(status == TAUT_OK, "%d points: status %d", b.count, (int)status);
                CHECK_NEAR(mass, 1, 1e-13, "%d points", b.count);
                CHECK_NEAR(lowest / exact(&b, 0), 1, 1.5e-12, "%d points, %d parts, shift %g",
                           b.count, parts, b.shift);
                CHECK(b.solved <= 60, "%d points took %d", b.count, b.solved);
            }
        }
    }
}

/* The next eigenvalue lies nearer and nearer: inverse iteration would take up to millions of steps. */
static void test_near(void)
{
    for (double apart = 1e-2; apart > 2e-6; apart *= 0.1) {
        taut_pulse pulse = {.what = "lowest"};
        double lowest = NAN, mass = NAN;
        bars b = {.count = 50, .parts = 2, .broken = 1};

        b.h[0] = 1.0 / 51;
        b.h[1] = b.h[0] * (1 - 0.5 * apart);
        CHECK(find(&b, &pulse, &lowest, &mass) == TAUT_OK, "%g apart", apart);
        CHECK_NEAR(lowest / exact(&b, 0), 1, 1e-10, "%g apart, %d solved", apart, b.solved);
        CHECK(b.solved < 200, "%g apart: it took %d", apart, b.solved);
    }
}

/* A shift far below: all eigenvalues of (K - shift M)^-1 M are near each other, and Lanczos begins again. */
static void test_far(void)
{
    taut_pulse pulse = {.what = "lowest"};
    double lowest = NAN, mass = NAN;
    bars b = {.count = 200, .parts = 1, .h = {1.0 / 201, 0}, .shift = -3e4, .broken = 1};

    CHECK(find(&b, &pulse, &lowest, &mass) == TAUT_OK, "far");
    CHECK_NEAR(lowest / exact(&b, 0), 1, 5e-9, "%d solved", b.solved);
    CHECK(b.solved > 100 && b.solved < 400, "it took %d", b.solved);
}

/* Numbers out of range, at once and after a while. */
static void test_range(void)
{
    const double broken[] = {INFINITY, NAN, 1e200, 0};

    for (size_t k = 0; k < sizeof broken / sizeof *broken; k++) {
        for (int whole = 0; whole < 4; whole += 3) {
            taut_pulse pulse = {.what = "lowest"};
            double lowest = NAN, mass = NAN;
            bars b = {
                .count = 30, .parts = 1, .h = {1.0 / 31, 0}, .whole = whole, .broken = broken[k]};
            const taut_status status = find(&b, &pulse, &lowest, &mass);
            CHECK((whole > 0 && broken[k] == 0) || status == TAUT_NOT_CONVERGED,
                  "%g after %d: status %d", broken[k], whole, (int)status);
        }
    }
}

int main(void)
{
    test_intervals();
    test_near();
    test_far();
    test_range();
    return check_failures != 0;
}
