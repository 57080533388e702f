/* Bisection. By Sylvester's law the number of eigenvalues of (K, M) below s is the number of
 * negative pivots of K - s M ([Parlett1998] 3.3.1). Intervals that hold more than one eigenvalue
 * are cut until they hold one, or are too short to cut; the cuts of one round are counted side by
 * side. */
#include "numeric/eigen_internal.h"

#include "core/memory.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum { ROUNDS_MAX = 4096, CHUNK = 64 };

/* An interval this much shorter than its ends is not cut further. */
static const double shortest = 0x1p-44;

struct interval {
    double low, high;
    int below, inside;
};

struct counter {
    const taut_pencil *pencil;
    double *factor; /* double[CHUNK + width][width + 1][lanes] */
};

/* count[i] = eigenvalues below shift[i], for any number of shifts. The factors are not kept: rows
 * are made CHUNK at a time, and the last `width` of them carried over. */
static void count_below(const struct counter *counter, int shifts, const double *shift, int *count)
{
    const taut_pencil *p = counter->pencil;
    const int n = p->k.n, w = p->k.width, lanes = p->kernel->lanes;
    const size_t row = ((size_t)w + 1) * (size_t)lanes;

    for (int start = 0; start < shifts; start += lanes) {
        double minus[TAUT_LANES_MAX], negative[TAUT_LANES_MAX] = {0};
        for (int l = 0; l < lanes; l++) {
            minus[l] = -shift[start + l < shifts ? start + l : shifts - 1];
        }
        memset(counter->factor, 0, (size_t)w * row * sizeof(double));
        for (int first = 0; first < n; first += CHUNK) {
            const int end = first + CHUNK < n ? first + CHUNK : n;
            if (first > 0) {
                memmove(counter->factor, counter->factor + CHUNK * row,
                        (size_t)w * row * sizeof(double));
            }
            p->kernel->band_factor(first, end, w, p->k.a, p->m.a, 1.0, minus, p->tiny,
                                   counter->factor, negative);
        }
        for (int l = 0; l < lanes && start + l < shifts; l++) {
            count[start + l] = (int)negative[l];
        }
    }
}

/* The j-th of `parts` - 1 cuts of an interval: even steps of sqrt(s), in which the eigenvalues of
 * second order operators lie evenly, or of log(s) where the ends differ much. */
static double cut(const struct interval *interval, int j, int parts)
{
    const double a = interval->low, b = interval->high, t = (double)j / parts;
    if (a > 0.0) {
        if (b > 64.0 * a) {
            return a * pow(b / a, t);
        }
        const double root = (1.0 - t) * sqrt(a) + t * sqrt(b);
        return root * root;
    }
    if (b > 64.0 * fabs(a)) {
        return b * pow(1.0 / 64.0, 1.0 - t);
    }
    return (1.0 - t) * a + t * b;
}

/* All eigenvalues in one interval: low and high are moved out by factors of 4 until none is
 * outside. Returns 0 when they would overflow first. */
static int enclose(const struct counter *counter, struct interval *all)
{
    const taut_pencil *p = counter->pencil;
    const int n = p->k.n;
    double high = p->norm, low = -0x1p-40 * p->norm;
    int found = 0;

    for (int i = 0; i < 400 && !found; i++) {
        double shift[TAUT_LANES_MAX];
        int count[TAUT_LANES_MAX];
        const int lanes = p->kernel->lanes;
        for (int l = 0; l < lanes / 2; l++) {
            shift[2 * l] = high * ldexp(1.0, 2 * l);
            shift[2 * l + 1] = low * ldexp(1.0, 2 * l);
        }
        count_below(counter, lanes / 2 * 2, shift, count);
        int up = 0, down = 0;
        while (up < lanes / 2 - 1 && count[2 * up] < n) {
            up++;
        }
        while (down < lanes / 2 - 1 && count[2 * down + 1] > 0) {
            down++;
        }
        high = shift[2 * up];
        low = shift[2 * down + 1];
        found = count[2 * up] == n && count[2 * down + 1] == 0;
        if (!isfinite(high * 4.0) || !isfinite(low * 4.0)) {
            break;
        }
    }
    *all = (struct interval){low, high, 0, n};
    return found;
}

static int is_short(const struct interval *interval)
{
    return interval->high - interval->low <=
           shortest * (fabs(interval->low) + fabs(interval->high)) + 0x1p-1000;
}

/* Hands a finished interval to its eigenvalues. */
static void settle(const struct interval *done, taut_bracket *bracket)
{
    for (int j = 0; j < done->inside; j++) {
        bracket[done->below + j] = (taut_bracket){done->low, done->high, done->below, done->inside};
    }
}

/* Cuts `old` at the given places, ascending, and appends the non-empty pieces that need more
 * cutting to list; others are settled. Counts are forced to be monotone. Returns the new length of
 * the list. */
static int divide(const struct interval *old, int cuts, const double *at, const int *count,
                  struct interval *list, int length, taut_bracket *bracket)
{
    struct interval piece = {old->low, old->low, old->below, 0};
    const int total = old->below + old->inside;
    for (int c = 0; c <= cuts; c++) {
        int upto = c < cuts ? count[c] : total;
        upto = upto < piece.below ? piece.below : upto > total ? total : upto;
        piece.low = piece.high;
        piece.high = c < cuts ? at[c] : old->high;
        piece.inside = upto - piece.below;
        if (piece.inside == 1 || (piece.inside > 1 && is_short(&piece))) {
            settle(&piece, bracket);
        } else if (piece.inside > 1) {
            list[length++] = piece;
        }
        piece.below = upto;
    }
    return length;
}

taut_status taut_eigen_isolate(const taut_pencil *pencil, taut_bracket *bracket)
{
    const int n = pencil->k.n, w = pencil->k.width, lanes = pencil->kernel->lanes;
    const size_t most = (size_t)n + (size_t)lanes; /* cuts in a round */
    taut_status status = TAUT_NO_MEMORY;
    struct interval *list = taut_alloc(2 * most, sizeof *list);
    double *at = taut_alloc(most, sizeof *at);
    int *count = taut_alloc(most, sizeof *count);
    struct counter counter = {pencil,
                              taut_alloc_aligned(((size_t)CHUNK + (size_t)w) * ((size_t)w + 1),
                                                 (size_t)lanes * sizeof(double))};
    if (list == NULL || at == NULL || count == NULL || counter.factor == NULL) {
        goto done;
    }

    status = TAUT_NOT_CONVERGED;
    struct interval all;
    if (!enclose(&counter, &all)) {
        goto done;
    }
    int length = divide(&all, 0, NULL, NULL, list, 0, bracket);
    for (int round = 0; length > 0 && round < ROUNDS_MAX; round++) {
        const int cuts = length >= lanes ? 1 : lanes / length;
        for (int i = 0; i < length; i++) {
            for (int c = 0; c < cuts; c++) {
                at[i * cuts + c] = cut(&list[i], c + 1, cuts + 1);
            }
        }
        count_below(&counter, length * cuts, at, count);
        struct interval *next = list + most;
        int more = 0;
        for (int i = 0; i < length; i++) {
            more = divide(&list[i], cuts, at + i * cuts, count + i * cuts, next, more, bracket);
        }
        memcpy(list, next, (size_t)more * sizeof *list);
        length = more;
    }
    status = length == 0 ? TAUT_OK : TAUT_NOT_CONVERGED;

done:
    taut_free(counter.factor);
    taut_free(count);
    taut_free(at);
    taut_free(list);
    return status;
}
