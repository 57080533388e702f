/* elementary.c -- what a call of an elementary function costs beside one of the C library, each over the same arguments.
 * Calls are independent of each other, as they are in tables of basis functions. The best of ROUNDS, ours and theirs in turn. */
#include "machine.h"

#include "core/elementary/elementary.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

enum { ROUNDS = 9, COUNT = 20000 };

typedef struct function {
    const char *name;
    double (*ours)(double), (*theirs)(double);
    double low, high; /* of the arguments */
} function;

typedef struct function_of_two {
    const char *name;
    double (*ours)(double, double), (*theirs)(double, double);
    double low[2], high[2];
} function_of_two;

static const function functions[] = {
    {"exp", taut_exp, exp, -20, 20},      {"exp2", taut_exp2, exp2, -20, 20},
    {"expm1", taut_expm1, expm1, -1, 1},  {"log", taut_log, log, 1e-3, 1e3},
    {"log2", taut_log2, log2, 1e-3, 1e3}, {"log10", taut_log10, log10, 1e-3, 1e3},
    {"sin", taut_sin, sin, -10, 10},      {"cos", taut_cos, cos, -10, 10},
    {"tan", taut_tan, tan, -10, 10},      {"sin near 1e10", taut_sin, sin, 1e10, 1.1e10},
    {"asin", taut_asin, asin, -1, 1},     {"acos", taut_acos, acos, -1, 1},
    {"atan", taut_atan, atan, -10, 10},   {"sinh", taut_sinh, sinh, -5, 5},
    {"cosh", taut_cosh, cosh, -5, 5},     {"tanh", taut_tanh, tanh, -5, 5},
};

static const function_of_two functions_of_two[] = {
    {"pow", taut_pow, pow, {0.1, -20}, {10, 20}},
    {"atan2", taut_atan2, atan2, {-1, -1}, {1, 1}},
    {"hypot", taut_hypot, hypot, {-1, -1}, {1, 1}},
};

static double arguments[2][COUNT];

/* Uniform, the same sequence in every run. */
static void fill(double low, double high, double *x)
{
    static uint64_t state = 20240613;
    for (int i = 0; i < COUNT; i++) {
        state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        x[i] = low + (high - low) * ((double)(state >> 11) * 0x1p-53);
    }
}

static double time_one(double (*call)(double))
{
    volatile double kept = 0;
    double sum = 0;
    const double start = bench_cpu_seconds();
    for (int i = 0; i < COUNT; i++) {
        sum += call(arguments[0][i]);
    }
    kept = sum;
    (void)kept;
    return bench_cpu_seconds() - start;
}

static double time_two(double (*call)(double, double))
{
    volatile double kept = 0;
    double sum = 0;
    const double start = bench_cpu_seconds();
    for (int i = 0; i < COUNT; i++) {
        sum += call(arguments[0][i], arguments[1][i]);
    }
    kept = sum;
    (void)kept;
    return bench_cpu_seconds() - start;
}

static void tell(const char *name, double ours, double theirs)
{
    printf("| %-14s | %6.1f | %6.1f | %5.1f |\n", name, 1e9 * ours / COUNT, 1e9 * theirs / COUNT,
           ours / theirs);
}

int main(void)
{
    printf(
        "%s, one thread, ns a call\n\n| function | ours | C library | ratio |\n|---|---|---|---|\n",
        bench_processor());
    for (size_t f = 0; f < sizeof functions / sizeof functions[0]; f++) {
        double ours = HUGE_VAL, theirs = HUGE_VAL;
        fill(functions[f].low, functions[f].high, arguments[0]);
        for (int round = 0; round < ROUNDS; round++) {
            ours = fmin(ours, time_one(functions[f].ours));
            theirs = fmin(theirs, time_one(functions[f].theirs));
        }
        tell(functions[f].name, ours, theirs);
    }
    for (size_t f = 0; f < sizeof functions_of_two / sizeof functions_of_two[0]; f++) {
        const function_of_two *of = &functions_of_two[f];
        double ours = HUGE_VAL, theirs = HUGE_VAL;
        fill(of->low[0], of->high[0], arguments[0]);
        fill(of->low[1], of->high[1], arguments[1]);
        for (int round = 0; round < ROUNDS; round++) {
            ours = fmin(ours, time_two(of->ours));
            theirs = fmin(theirs, time_two(of->theirs));
        }
        tell(of->name, ours, theirs);
    }
    return 0;
}
