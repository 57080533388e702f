#include "construct/film/arc.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>

enum { BISECTIONS = 200 };

/* a / sin a - 1, which grows from 0 to infinity over (0, pi). */
static double excess(double a)
{
    const double x = a * a;
    return a < 1e-2 ? x / 6 * (1 + x * (7.0 / 60 + x * (31.0 / 2520))) : a / taut_sin(a) - 1;
}

double taut_film_arc_angle(double chord, double length)
{
    const double wanted = (length - chord) / chord;
    double low = 0, high = TAUT_PI;

    for (int k = 0; k < BISECTIONS && high - low > 0x1p-52 * high; k++) {
        const double middle = 0.5 * (low + high);
        if (excess(middle) < wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5 * (low + high);
}

double taut_film_arc_length(double chord, double radius)
{
    return 2 * radius * taut_asin(fmin(1, chord / (2 * radius)));
}

double taut_film_arc_of_sag(double chord, double sag)
{
    return taut_film_arc_length(chord, chord * (1 + 4 * sag * sag) / (8 * sag));
}

double taut_film_arc_elastic(double chord, double unstressed, double k)
{
    double low = 0, high = 0.5 * TAUT_PI; /* R falls with the angle, the cable's force grows */

    if (k * (chord * (0.5 * TAUT_PI) - unstressed) < 0.5 * chord) {
        return 0;
    }
    for (int n = 0; n < BISECTIONS && high - low > 0x1p-52 * high; n++) {
        const double middle = 0.5 * (low + high);
        const double length = chord * (1 + excess(middle));
        if (k * (length - unstressed) * 2 * taut_sin(middle) < chord) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5 * chord / taut_sin(0.5 * (low + high));
}
