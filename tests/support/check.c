#include "check.h"

#include <stdarg.h>
#include <stdlib.h>

int check_failures = 0;
static uint64_t state = 1;
static uint64_t first_seed = 1;

void check_fail(const char *file, int line, const char *what)
{
    check_failures++;
    fprintf(stderr, "%s:%d: %s  (seed %llu)\n    ", file, line, what,
            (unsigned long long)first_seed);
}

void check_say(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

void random_seed(uint64_t seed)
{
    const char *given = getenv("TAUT_TEST_SEED");
    state = given != NULL ? strtoull(given, NULL, 10) : seed;
    first_seed = state;
}

uint64_t random_bits(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
}

double random_in(double lo, double hi)
{
    return lo + (hi - lo) * ((double)(random_bits() >> 11) * 0x1p-53);
}

int random_int(int lo, int hi)
{
    return lo + (int)(random_bits() % (uint64_t)(hi - lo + 1));
}

double random_log(double lo, double hi)
{
    const int pick = random_int(0, 19);
    if (pick < 2) {
        return pick == 0 ? lo : hi;
    }
    return exp(random_in(log(lo), log(hi)));
}

#if defined(__SANITIZE_ADDRESS__)
enum { SANITIZED = 1 };
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif
#else
enum { SANITIZED = 0 };
#endif

int random_trials(int count)
{
    return SANITIZED ? (count + 3) / 4 : count;
}
