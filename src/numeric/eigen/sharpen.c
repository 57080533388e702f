/* The root of f(s) = det (K - s M) in each bracket, by false position: a factorisation that only
 * counts costs a quarter of a step of inverse iteration and gains as many digits while the vector
 * is still unknown. An end that stays twice running is made to weigh less ([AndersonBjorck1973]),
 * so that both ends close in. */
#include "core/elementary/elementary.h"
#include "numeric/eigen/internal.h"

#include <math.h>

enum { ROUNDS_MAX = 16 };

/* A guess keeps this share of the bracket away from its ends. */
static const double margin = 0x1p-7;

/* A guess that moved by less of the gap to its neighbours is good enough: the next move would be
 * less by more than the same factor, and inverse iteration gains this many digits a step. */
static const double good_enough = 0x1p-9;

/* Where the chord through the ends crosses zero; the logarithms give |f(high)| / |f(low)|. */
static double crossing_of(const taut_bracket *bracket)
{
    const double ratio = taut_exp2(fmin(fmax(bracket->high_log - bracket->low_log, -60.0), 60.0));
    double t = 1.0 / (1.0 + ratio);
    t = t > margin ? t < 1.0 - margin ? t : 1.0 - margin : margin; /* margin when not a number */
    return bracket->low + t * (bracket->high - bracket->low);
}

/* log2 of the weight of the end that stays while f at the other moved from 2^before to 2^now. */
static double staying_weight(double before, double now)
{
    const double m = 1.0 - taut_exp2(fmin(now - before, 60.0));
    return m > 0x1p-10 ? taut_log2(m) : -1.0;
}

/* The guess becomes an end, and a new one is made; `side` remembers which end moved last: -1 low, 1
 * high. Returns the size of the move. */
static double narrow_bracket(taut_bracket *bracket, int index, int below, double log, int *side)
{
    const double old = bracket->guess;
    if (below <= index) {
        bracket->high_log += *side < 0 ? staying_weight(bracket->low_log, log) : 0.0;
        bracket->low = bracket->guess;
        bracket->low_log = log;
        *side = -1;
    } else {
        bracket->low_log += *side > 0 ? staying_weight(bracket->high_log, log) : 0.0;
        bracket->high = bracket->guess;
        bracket->high_log = log;
        *side = 1;
    }
    bracket->guess = crossing_of(bracket);
    return fabs(bracket->guess - old);
}

/* False position may crawl where f is far from straight: a bracket that two rounds have not cut to
 * a quarter is halved, in the measure of isolate.c. */
static void halve_slow_bracket(taut_bracket *bracket, double *length)
{
    if (bracket->high - bracket->low > 0.25 * *length) {
        bracket->guess = taut_eigen_place(bracket, 1, 2);
    }
    *length = bracket->high - bracket->low;
}

double taut_eigen_gap(int n, const taut_bracket *bracket, int j)
{
    const double up = j < n - 1 ? bracket[j + 1].guess - bracket[j].guess : INFINITY;
    const double down = j > 0 ? bracket[j].guess - bracket[j - 1].guess : INFINITY;
    const double gap = fmin(up, down);
    return isfinite(gap) ? gap : bracket[j].high - bracket[j].low;
}

taut_status taut_eigen_sharpen(const taut_pencil *pencil, taut_arena *arena, taut_bracket *bracket)
{
    const int n = pencil->k.n;
    const size_t size = (size_t)n;
    const taut_counter counter = taut_counter_of(pencil, arena);
    double *shift = taut_arena_take(arena, size, sizeof *shift);
    double *log = taut_arena_take(arena, size, sizeof *log);
    double *length = taut_arena_take(arena, size, sizeof *length);
    int *below = taut_arena_take(arena, size, sizeof *below);
    int *side = taut_arena_take(arena, size, sizeof *side);
    int *who = taut_arena_take(arena, size, sizeof *who);
    int count = 0;
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int j = 0; j < n; j++) {
        if (bracket[j].inside == 1) {
            bracket[j].guess = crossing_of(&bracket[j]);
            length[j] = bracket[j].high - bracket[j].low;
            who[count++] = j;
        }
    }
    for (int round = 0; round < ROUNDS_MAX && count > 0; round++) {
        for (int i = 0; i < count; i++) {
            shift[i] = bracket[who[i]].guess;
        }
        if (taut_counter_run(&counter, count, shift, below, log) != TAUT_OK) {
            return TAUT_INTERRUPTED;
        }
        int more = 0;
        for (int i = 0; i < count; i++) {
            const int j = who[i];
            const double move = narrow_bracket(&bracket[j], j, below[i], log[i], &side[j]);
            if (!(move <= good_enough * taut_eigen_gap(n, bracket, j))) {
                who[more++] = j;
                if (round % 2 == 1) {
                    halve_slow_bracket(&bracket[j], &length[j]);
                }
            }
        }
        count = more;
    }
    return TAUT_OK;
}
