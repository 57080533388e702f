/* Bisection: intervals that hold more than one eigenvalue are cut until they hold one, or are too
 * short to cut; the cuts of one round are counted side by side. */
#include "core/elementary/elementary.h"
#include "numeric/eigen/internal.h"

#include <math.h>
#include <string.h>

enum { ROUNDS_MAX = 4096 };

/* An interval this much shorter than its ends is not cut further. */
static const double shortest = 0x1p-44;

/* Where the cuts of a round are, and what they tell. */
struct cuts {
    double *at, *log;
    int *below;
};

double taut_eigen_place(const taut_bracket *interval, int j, int parts)
{
    const double a = interval->low, b = interval->high, t = (double)j / parts;
    if (a > 0.0) {
        if (b > 64.0 * a) {
            return a * taut_pow(b / a, t);
        }
        const double root = (1.0 - t) * sqrt(a) + t * sqrt(b);
        return root * root;
    }
    if (b > 64.0 * fabs(a)) {
        return b * taut_pow(1.0 / 64.0, 1.0 - t);
    }
    return (1.0 - t) * a + t * b;
}

/* All eigenvalues in one interval: low and high are moved out by factors of 4 until none is
 * outside. Returns 0 when they would overflow first. */
static int enclose_all(const taut_counter *counter, taut_bracket *all)
{
    const int n = counter->pencil->k.n, steps = TAUT_LANES / 2;
    double high = counter->pencil->norm, low = -0x1p-40 * high;

    for (int i = 0; i < 100; i++) {
        double shift[TAUT_LANES], log[TAUT_LANES];
        int below[TAUT_LANES], up = 0, down = 0;
        for (int l = 0; l < steps; l++) {
            shift[l] = ldexp(high, 2 * l);
            shift[steps + l] = ldexp(low, 2 * l);
        }
        if (taut_counter_run(counter, 2 * steps, shift, below, log) != TAUT_OK) {
            return 0;
        }
        while (up < steps - 1 && below[up] < n) {
            up++;
        }
        while (down < steps - 1 && below[steps + down] > 0) {
            down++;
        }
        high = shift[up];
        low = shift[steps + down];
        if (below[up] == n && below[steps + down] == 0) {
            *all = (taut_bracket){low, high, log[steps + down], log[up], 0.0, 0, n};
            return 1;
        }
    }
    return 0;
}

static int is_short(const taut_bracket *interval)
{
    return interval->high - interval->low <=
           shortest * (fabs(interval->low) + fabs(interval->high)) + 0x1p-1000;
}

/* Hands a finished interval to its eigenvalues. */
static void settle_bracket(const taut_bracket *done, taut_bracket *bracket)
{
    for (int j = 0; j < done->inside; j++) {
        bracket[done->below + j] = *done;
        bracket[done->below + j].guess = done->low + 0.5 * (done->high - done->low);
    }
}

/* Divides `old` by `count` cuts, ascending, from cut `from` on, and appends the non-empty pieces
 * that need more cutting to list; others are settled. What cuts tell is forced to be monotone.
 * Returns the new length of the list. */
static int divide_bracket(const taut_bracket *old, const struct cuts *cuts, int from, int count,
                          taut_bracket *list, int length, taut_bracket *bracket)
{
    const int total = old->below + old->inside;
    taut_bracket piece = *old;
    piece.high = old->low;
    piece.high_log = old->low_log;
    for (int c = from; c <= from + count; c++) {
        const int is_cut = c < from + count;
        int upto = is_cut ? cuts->below[c] : total;
        upto = upto < piece.below ? piece.below : upto > total ? total : upto;
        piece.low = piece.high;
        piece.low_log = piece.high_log;
        piece.high = is_cut ? cuts->at[c] : old->high;
        piece.high_log = is_cut ? cuts->log[c] : old->high_log;
        piece.inside = upto - piece.below;
        if (piece.inside == 1 || (piece.inside > 1 && is_short(&piece))) {
            settle_bracket(&piece, bracket);
        } else if (piece.inside > 1) {
            list[length++] = piece;
        }
        piece.below = upto;
    }
    return length;
}

taut_status taut_eigen_isolate(const taut_pencil *pencil, taut_arena *arena, taut_bracket *bracket)
{
    const int lanes = TAUT_LANES;
    const size_t most = (size_t)pencil->k.n + (size_t)lanes; /* cuts in a round */
    const taut_counter counter = taut_counter_of(pencil, arena);
    taut_bracket *list = taut_arena_take(arena, most, sizeof *list);
    taut_bracket *next = taut_arena_take(arena, most, sizeof *next);
    const struct cuts cuts = {taut_arena_take(arena, most, sizeof(double)),
                              taut_arena_take(arena, most, sizeof(double)),
                              taut_arena_take(arena, most, sizeof(int))};
    taut_bracket all;
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (!enclose_all(&counter, &all)) {
        return TAUT_NOT_CONVERGED;
    }
    int length = divide_bracket(&all, &cuts, 0, 0, list, 0, bracket);
    for (int round = 0; length > 0 && round < ROUNDS_MAX; round++) {
        const int count = length >= lanes ? 1 : lanes / length;
        for (int i = 0; i < length; i++) {
            for (int c = 0; c < count; c++) {
                cuts.at[i * count + c] = taut_eigen_place(&list[i], c + 1, count + 1);
            }
        }
        if (taut_counter_run(&counter, length * count, cuts.at, cuts.below, cuts.log) != TAUT_OK) {
            return TAUT_INTERRUPTED;
        }
        int more = 0;
        for (int i = 0; i < length; i++) {
            more = divide_bracket(&list[i], &cuts, i * count, count, next, more, bracket);
        }
        memcpy(list, next, (size_t)more * sizeof *list);
        length = more;
    }
    return length == 0 ? TAUT_OK : TAUT_NOT_CONVERGED;
}
