#include "numeric/bracket.h"

#include <float.h>
#include <math.h>

enum { ROUNDS = 100, CLIMBS = 60 };

/* The part of the way from a to b where inverse quadratic interpolation through a, b and c vanishes, or a half where that is not to be
 * trusted. */
static double part_of(const double at[3], const double f[3])
{
    const double a = f[0], b = f[1], c = f[2];
    const double xi = (at[0] - at[1]) / (at[2] - at[1]), phi = (a - b) / (c - b);
    if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)) {
        return 0.5;
    }
    return a / (b - a) * (c / (b - c)) +
           (at[2] - at[0]) / (at[1] - at[0]) * (a / (c - a)) * (b / (c - b));
}

double taut_bracket_root(taut_bracket_function *f, const void *context, double low, double high,
                         double f_low, double f_high)
{
    const double room = 2 * DBL_EPSILON * fmax(fabs(low), fabs(high));
    double at[3] = {high, low, low}, value[3] = {f_high, f_low, f_low}; /* newest, across, before */
    double part = 0.5;

    for (int round = 0; round < ROUNDS; round++) {
        const int best = fabs(value[0]) < fabs(value[1]) ? 0 : 1;
        const double least = room / fabs(at[1] - at[0]);
        if (value[best] == 0 || !(least < 0.5)) {
            return at[best];
        }
        part = round > 0 ? fmin(fmax(part_of(at, value), least), 1 - least) : part;
        const double t = at[0] + part * (at[1] - at[0]), now = f(context, t);
        const int stays = (now > 0) == (value[0] > 0); /* the root lies between t and at[1] */
        at[2] = at[stays ? 0 : 1];
        value[2] = value[stays ? 0 : 1];
        at[1] = stays ? at[1] : at[0];
        value[1] = stays ? value[1] : value[0];
        at[0] = t;
        value[0] = now;
    }
    return at[0];
}

/* The best three places so far, the last of them the worst. */
typedef struct climb {
    double at[3], value[3];
} climb;

static void take(climb *c, double t, double value)
{
    int place = 3;
    while (place > 0 && value >= c->value[place - 1]) {
        place--;
    }
    for (int i = 2; i > place; i--) {
        c->at[i] = c->at[i - 1];
        c->value[i] = c->value[i - 1];
    }
    if (place < 3) {
        c->at[place] = t;
        c->value[place] = value;
    }
}

/* The step from the best place to the top of the parabola through the three; no number where there is none. */
static double to_top(const climb *c)
{
    const double p = c->at[1] - c->at[0], q = c->at[2] - c->at[0];
    const double rise = q * (c->value[1] - c->value[0]), fall = p * (c->value[2] - c->value[0]);
    const double bent = 2 * (rise - fall);
    return (q * rise - p * fall) / bent;
}

double taut_bracket_most(taut_bracket_function *f, const void *context, double low, double high,
                         double *at)
{
    const double golden = 0.3819660112501051, fine = 1.5e-8;
    const double first = low + golden * (high - low), value = f(context, first);
    climb c = {{first, first, first}, {value, -HUGE_VAL, -HUGE_VAL}};
    double step = 0, before = 0; /* the last step, and the one before it */

    for (int round = 0; round < CLIMBS; round++) {
        const double middle = (low + high) / 2, room = fine * fabs(c.at[0]) + 1e-3 * fine;
        if (fabs(c.at[0] - middle) <= 2 * room - (high - low) / 2) {
            break;
        }
        const double top = to_top(&c); /* not a number while there are no three places */
        const double there = c.at[0] + top;
        if (fabs(before) > room && fabs(top) < fabs(before) / 2 && there > low && there < high) {
            before = step;
            step = there - low < 2 * room || high - there < 2 * room
                       ? copysign(room, middle - c.at[0])
                       : top;
        } else {
            before = c.at[0] < middle ? high - c.at[0] : low - c.at[0];
            step = golden * before;
        }
        const double t = c.at[0] + (fabs(step) >= room ? step : copysign(room, step));
        const double now = f(context, t);
        const double best = c.at[0];
        if (now >= c.value[0]) {
            low = t >= best ? best : low;
            high = t >= best ? high : best;
        } else {
            low = t < best ? t : low;
            high = t < best ? high : t;
        }
        take(&c, t, now);
    }
    *at = c.at[0];
    return c.value[0];
}
