#include "core/unit.h"

#include <stddef.h>
#include <string.h>

/* Whole numbers of tenths of a millimetre, so that a ratio is one correctly rounded quotient. */
static const struct {
    const char *unit;
    double tenths;
} units[] = {{"mm", 10}, {"cm", 100}, {"m", 10000}, {"in", 254}, {"ft", 3048}};

static double tenths_of(const char *unit)
{
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(unit, units[i].unit) == 0) {
            return units[i].tenths;
        }
    }
    return 0;
}

double taut_unit_ratio(const char *from, const char *to)
{
    const double one = tenths_of(from), other = tenths_of(to);
    return other > 0 ? one / other : 0;
}
