/* spans.c -- as few spans as the proof of a distance allows, wide where a piece is
 * straight.
 *
 * A long hyperbolic piece is straight but for layers at its ends: spans of one width would have to
 * be as narrow as those layers want all along. Here each span begins where the last one ends and
 * is as wide as its own proved distance (proof.c) lets it; widths then grow like e^(s/6), s
 * the distance to the end of the piece, and a piece of any length takes a few dozen.
 */
#include "geometry/nurbs/proof.h"

#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "taut/operations.h"

#include <math.h>
#include <string.h>

enum { SPANS_MAX = (TAUT_COUNT_MAX - 3) / 3 };

/* One piece at work: its points, line by line, and the ends found so far in all. */
typedef struct cutting {
    const taut_nurbs_side *side;
    int piece;
    int lines;
    double *points; /* [lines][4][3] */
    double *ends;   /* [room + 1] */
    int room, count;
    int most; /* spans of the side that are allowed */
} cutting;

static double distance_on(const cutting *c, double lo, double hi)
{
    const taut_nurbs_span span = taut_nurbs_span_of(c->side, c->piece, lo, hi);
    return taut_nurbs_along(&span, c->lines, c->points, 12, 3);
}

/* The widest span from lo, hi at the furthest; `guess` a width to try first. */
static double find_widest(const cutting *c, double lo, double hi, double guess, double share)
{
    double good = 0, bad = hi - lo, width = fmin(guess, bad / 2);

    if (distance_on(c, lo, hi) <= share) {
        return hi - lo;
    }
    while (lo + width > lo && bad - good > good / 64) {
        if (distance_on(c, lo, lo + width) <= share) {
            good = width;
        } else {
            bad = width;
        }
        width = good == 0 ? bad / 2 : fmin(2 * good, (good + bad) / 2);
    }
    return good;
}

static taut_status double_room(cutting *c)
{
    const int room = 2 * c->room;
    double *ends = taut_realloc(c->ends, (size_t)room + 1, sizeof *ends);
    if (ends == NULL) {
        return TAUT_NO_MEMORY;
    }
    c->ends = ends;
    c->room = room;
    return TAUT_OK;
}

/* Spans from lo to hi after those there are; *last is the distance on the last one. */
static taut_status march_spans(cutting *c, double lo, double hi, double share, double *last,
                               taut_error *error)
{
    double width = hi - lo;

    while (lo < hi) {
        width = find_widest(c, lo, hi, width, share);
        if (c->count >= c->most || !(lo + width > lo)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "too-many-points", NULL, c->count, c->most,
                             "a NURBS so near needs more than %d spans one way, more than fit: ask "
                             "for a larger tolerance",
                             c->count);
        }
        if (c->count >= c->room && double_room(c) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        const double end = width < hi - lo ? lo + width : hi;
        *last = distance_on(c, lo, end);
        lo = c->ends[++c->count] = end;
    }
    return TAUT_OK;
}

/* Would `count` equal spans do, in place of those from number `first` on? */
static int are_evened(cutting *c, int first, double share)
{
    const int count = c->count - first;
    const double lo = c->ends[first], hi = c->ends[c->count];
    int fits = 1;

    for (int k = 0; fits && k < count; k++) {
        fits =
            distance_on(c, lo + (hi - lo) * k / count, lo + (hi - lo) * (k + 1) / count) <= share;
    }
    for (int k = 1; fits && k < count; k++) {
        c->ends[first + k] = lo + (hi - lo) * k / count;
    }
    return fits;
}

/* The spans of one piece: equal ones if that takes no more; else such that the last one is no
 * sliver, its share being worth half a width, by asking all for less. */
static taut_status cut_piece(cutting *c, double share, taut_error *error)
{
    const taut_basis *piece = c->side->pieces.items[c->piece]->to;
    const double lo = taut_basis_lo(piece), hi = taut_basis_hi(piece);
    const int first = c->count;
    double last = 0, low = 0.5, high = 1; /* of the widths: too little, enough */
    taut_status status = march_spans(c, lo, hi, share, &last, error);
    const int count = c->count;

    if (status != TAUT_OK || count - first < 2 || are_evened(c, first, share)) {
        return status;
    }
    for (int step = 0; status == TAUT_OK && step < 30 && last < share / 64; step++) {
        const double middle = (low + high) / 2;
        c->count = first;
        status = march_spans(c, lo, hi, share * taut_pow(middle, 6), &last, error);
        if (c->count > count) {
            low = middle;
            last = 0;
        } else {
            high = middle;
        }
    }
    if (status == TAUT_OK && c->count > count) {
        /* the halvings ended on too many: by the steps of `widest` the last span does not always
         * grow steadily as the others shrink */
        c->count = first;
        status = march_spans(c, lo, hi, share * taut_pow(high, 6), &last, error);
    }
    return status;
}

/* Appends the lines of one patch, as they run along `direction`. */
static void gather_lines(const taut_lattice *patch, int direction, cutting *c)
{
    const int across = patch->count[1 - direction];
    const size_t step = direction == TAUT_ALONG_U ? 3 * (size_t)across : 3;
    const size_t line = direction == TAUT_ALONG_U ? 3 : 12;

    for (int l = 0; l < across; l++) {
        for (int i = 0; i < 4; i++) {
            memcpy(c->points + 12 * (size_t)c->lines + 3 * i,
                   patch->net + (size_t)l * line + (size_t)i * step, 3 * sizeof(double));
        }
        c->lines++;
    }
}

/* The lines of points along one piece, as those of Bezier-like pieces in the other direction. */
static taut_status find_lines(const taut_lattice *whole, int direction,
                              const taut_nurbs_side *other, cutting *c, taut_error *error)
{
    taut_lattice strip;
    taut_status status =
        taut_lattice_change(whole, direction, c->side->pieces.items[c->piece], &strip, error);
    if (status != TAUT_OK) {
        return status;
    }
    c->lines = 0;
    if (other->basis == NULL) {
        gather_lines(&strip, direction, c);
    }
    for (int q = 0; status == TAUT_OK && q < other->pieces.count; q++) {
        taut_lattice patch;
        status = taut_lattice_change(&strip, 1 - direction, other->pieces.items[q], &patch, error);
        if (status == TAUT_OK) {
            gather_lines(&patch, direction, c);
        }
        taut_lattice_free(&patch);
    }
    taut_lattice_free(&strip);
    return status;
}

static size_t line_count(const taut_nurbs_side *other)
{
    size_t lines = other->basis == NULL;
    for (int q = 0; q < other->pieces.count; q++) {
        lines += (size_t)taut_basis_count(other->pieces.items[q]->to);
    }
    return lines;
}

/* The rows of all spans, their ends being known. */
static taut_status fill_spans(taut_nurbs_side *s, taut_error *error)
{
    s->spans = taut_alloc((size_t)s->first[s->pieces.count], sizeof *s->spans);
    if (s->spans == NULL) {
        return taut_fail_memory(error);
    }
    for (int p = 0; p < s->pieces.count; p++) {
        for (int k = s->first[p]; k < s->first[p + 1]; k++) {
            s->spans[k] = taut_nurbs_span_of(s, p, s->ends[k], s->ends[k + 1]);
        }
    }
    return TAUT_OK;
}

/* As many spans as leave the spline of both sides within the limits, the other one having at least
 * one span per piece: so no work is spent on what would be refused. */
static int most_spans(const taut_nurbs_side *other)
{
    const int across = other->basis == NULL ? 1
                       : other->exact       ? taut_basis_count(other->basis)
                                            : 3 * other->pieces.count + 3;
    const int fit = (TAUT_POINTS_MAX / across - 3) / 3;
    return fit < SPANS_MAX ? fit : SPANS_MAX;
}

/* Piece by piece; the memory is there. */
static taut_status cut_pieces(const taut_lattice *whole, int direction,
                              const taut_nurbs_side *other, double share, int *first, cutting *c,
                              taut_error *error)
{
    c->ends[0] = taut_basis_lo(c->side->basis);
    first[0] = 0;
    for (c->piece = 0; c->piece < c->side->pieces.count; c->piece++) {
        taut_status status = find_lines(whole, direction, other, c, error);
        if (status != TAUT_OK) {
            return status;
        }
        status = cut_piece(c, share, error);
        if (status != TAUT_OK) {
            return status;
        }
        first[c->piece + 1] = c->count;
    }
    return TAUT_OK;
}

taut_status taut_nurbs_cut(const taut_lattice *whole, int direction, taut_nurbs_side *s,
                           const taut_nurbs_side *other, double share, taut_error *error)
{
    const size_t pieces = (size_t)s->pieces.count;
    cutting c = {.side = s, .room = s->pieces.count, .most = most_spans(other)};
    taut_status status = TAUT_OK;

    taut_free(s->spans);
    s->spans = NULL;
    if (s->first == NULL) {
        s->first = taut_alloc(pieces + 1, sizeof *s->first);
    }
    c.ends = taut_alloc(pieces + 1, sizeof *c.ends);
    c.points = taut_alloc(line_count(other), 12 * sizeof *c.points);
    status = s->first != NULL && c.ends != NULL && c.points != NULL
                 ? cut_pieces(whole, direction, other, share, s->first, &c, error)
                 : taut_fail_memory(error);
    taut_free(s->ends);
    s->ends = c.ends;
    taut_free(c.points);
    return status == TAUT_OK ? fill_spans(s, error) : status;
}
