/* check.h -- the smallest test harness that says what failed: CHECK, CHECK_NEAR, random numbers
 * that mean the same everywhere for the same seed. */
#ifndef TAUT_TEST_CHECK_H
#define TAUT_TEST_CHECK_H

#include "core/printf.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

extern int check_failures; /* counted; a test's main returns check_failures != 0 */

/* CHECK(condition, "n=%d", n): the message says the inputs. */
#define CHECK(condition, ...)                                                                      \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            check_fail(__FILE__, __LINE__, #condition);                                            \
            check_say(__VA_ARGS__);                                                                \
        }                                                                                          \
    } while (0)

/* |found - expected| <= tolerance; NaN fails. */
#define CHECK_NEAR(found, expected, tolerance, ...)                                                \
    do {                                                                                           \
        const double check_f = (found), check_e = (expected), check_t = (tolerance);               \
        if (!(fabs(check_f - check_e) <= check_t)) {                                               \
            check_fail(__FILE__, __LINE__, #found);                                                \
            check_say("found %.17g, expected %.17g, differ by %.3g > %.3g; ", check_f, check_e,    \
                      fabs(check_f - check_e), check_t);                                           \
            check_say(__VA_ARGS__);                                                                \
        }                                                                                          \
    } while (0)

void check_fail(const char *file, int line, const char *what);
void check_say(const char *format, ...) TAUT_PRINTF(1, 2);

/* splitmix64; TAUT_TEST_SEED in the environment replaces the seed, which is printed on failure. */
void random_seed(uint64_t seed);
uint64_t random_bits(void);
double random_in(double lo, double hi);  /* uniform in [lo, hi) */
int random_int(int lo, int hi);          /* uniform in lo..hi, both included */
double random_log(double lo, double hi); /* log-uniform, one in ten at an end */

/* How many random trials of a slow kind to make: a quarter of `count` where a sanitizer watches
 * every access, which takes ten times as long. */
int random_trials(int count);

#endif /* TAUT_TEST_CHECK_H */
