/* met.c
 *
 *     each curve as chords in the window, CHORDS a span, in boxes of a span
 *     where two chords cross: Newton on both parameters, for the places in the window to be one
 *     a node of these two curves at those parameters
 */
#include "certify/trace/met.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CHORDS = 6, ROUNDS = 8 };
/* Over the window: two places that are one. Over the size: how near to an end is not looked at, and how far a node's
 * lengths may be from the crossing. */
static const double one_place = 1e-11, near_end = 1e-6, same_node = 1e-6;

/* A span of a curve. */
typedef struct span {
    int on;
    double t[CHORDS + 1], at[CHORDS + 1][2]; /* over the window */
    double low[2], high[2];
} span;

typedef struct course {
    int count;
    span *spans;
    double low[2], high[2];
} course;

/* Over the window of its surface; 0 where the curve has no place there. */
static int place_of(const taut_net_lines *lines, const taut_net_line *line, double t, double at[2],
                    int *on)
{
    if (!taut_net_line_window(line, t, at, on)) {
        return 0;
    }
    const taut_surface *surface = taut_model_surface(lines->model, *on);
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        at[d] = (at[d] - taut_basis_lo(basis)) / (taut_basis_hi(basis) - taut_basis_lo(basis));
    }
    return 1;
}

static taut_status course_new(const taut_net_lines *lines, const taut_net_line *line,
                              taut_arena *arena, course *made)
{
    const taut_basis *basis = taut_curve_t(line->space);
    const double *breaks = taut_basis_breaks(basis);

    *made = (course){.low = {INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY}};
    made->spans = taut_arena_take(arena, (size_t)taut_basis_span_count(basis), sizeof *made->spans);
    if (made->spans == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < taut_basis_span_count(basis); i++) {
        span *s = &made->spans[made->count];
        int on[2] = {0, 0}, is_whole = 1;
        *s = (span){.low = {INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY}};
        for (int k = 0; k <= CHORDS; k++) { /* just inside, so that it is on one surface */
            const double inside = fmin(fmax((double)k / CHORDS, 1e-9), 1 - 1e-9);
            s->t[k] = breaks[i] + (breaks[i + 1] - breaks[i]) * inside;
            is_whole &= place_of(lines, line, s->t[k], s->at[k], &on[k > 0]);
            is_whole &= k == 0 || on[1] == on[0];
            for (int d = 0; d < 2; d++) {
                s->low[d] = fmin(s->low[d], s->at[k][d]);
                s->high[d] = fmax(s->high[d], s->at[k][d]);
            }
        }
        s->on = on[0];
        for (int d = 0; is_whole && d < 2; d++) {
            made->low[d] = fmin(made->low[d], s->low[d]);
            made->high[d] = fmax(made->high[d], s->high[d]);
        }
        made->count += is_whole;
    }
    return TAUT_OK;
}

static int are_apart(const double low[2], const double high[2], const double other_low[2],
                     const double other_high[2])
{
    return low[0] > other_high[0] || other_low[0] > high[0] || low[1] > other_high[1] ||
           other_low[1] > high[1];
}

/* Where the chords from a to b and from c to d cross, as parts of both in [0, 1]; 0 where they do not. */
static int chords_cross(const double a[2], const double b[2], const double c[2], const double d[2],
                        double part[2])
{
    const double u[2] = {b[0] - a[0], b[1] - a[1]}, v[2] = {d[0] - c[0], d[1] - c[1]};
    const double w[2] = {c[0] - a[0], c[1] - a[1]};
    const double det = u[0] * v[1] - u[1] * v[0];
    part[0] = (w[0] * v[1] - w[1] * v[0]) / det;
    part[1] = (w[0] * u[1] - w[1] * u[0]) / det;
    return part[0] >= 0 && part[0] <= 1 && part[1] >= 0 && part[1] <= 1;
}

/* Do the curves themselves cross near t[0], t[1]? Then these are where, by secants of `step`. */
static int refine(const taut_net_lines *lines, const taut_net_line *const both[2],
                  const double step[2], double t[2])
{
    const double start[2] = {t[0], t[1]};
    for (int round = 0; round < ROUNDS; round++) {
        double at[2][2], beside[2][2], rate[2][2];
        int on[4];
        for (int k = 0; k < 2; k++) {
            const double h = 1e-3 * step[k];
            if (!place_of(lines, both[k], t[k] - h, beside[0], &on[0]) ||
                !place_of(lines, both[k], t[k] + h, beside[1], &on[1]) ||
                !place_of(lines, both[k], t[k], at[k], &on[2 + k]) || on[0] != on[1]) {
                return 0;
            }
            for (int d = 0; d < 2; d++) {
                rate[k][d] = (beside[1][d] - beside[0][d]) / (2 * h);
            }
        }
        const double away[2] = {at[1][0] - at[0][0], at[1][1] - at[0][1]};
        if (on[2] == on[3] && fmax(fabs(away[0]), fabs(away[1])) <= one_place) {
            return 1;
        }
        const double det = rate[0][0] * rate[1][1] - rate[0][1] * rate[1][0];
        t[0] += (away[0] * rate[1][1] - away[1] * rate[1][0]) / det;
        t[1] += (away[0] * rate[0][1] - away[1] * rate[0][0]) / det;
        if (!(fabs(t[0] - start[0]) <= 2 * step[0]) || !(fabs(t[1] - start[1]) <= 2 * step[1])) {
            return 0;
        }
    }
    return 0;
}

static int is_near_end(const taut_net_lines *lines, const taut_net_line *line, double t)
{
    const taut_basis *basis = taut_curve_t(line->space);
    const double room = near_end * lines->size;
    return t < taut_basis_lo(basis) + room || t > taut_basis_hi(basis) - room;
}

/* The nodes of details, of each pair of curves together. */
typedef struct known {
    int count;      /* of curves */
    size_t *first;  /* [count^2 + 1] */
    double (*s)[2]; /* lengths on both */
} known;

/* i count + j of the two curves of a node; count^2 where there are none. */
static size_t pair_of(const taut_net_lines *lines, const taut_record *node)
{
    const size_t count = (size_t)lines->count;
    const taut_net_line *both[2];
    return taut_net_lines_of_node(lines, taut_record_text(taut_record_get(node, "node")), both)
               ? (size_t)(both[0] - lines->lines) * count + (size_t)(both[1] - lines->lines)
               : count * count;
}

static taut_status known_new(const taut_net_lines *lines, taut_arena *arena, known *all)
{
    const taut_record *nodes = taut_record_get(taut_model_details(lines->model), "nodes");
    const size_t pairs = (size_t)lines->count * (size_t)lines->count;
    const size_t count = taut_record_count(nodes);
    size_t *pair = taut_arena_take(arena, count + 1, sizeof *pair);
    size_t *filled = taut_arena_take(arena, pairs + 2, sizeof *filled);

    *all = (known){.count = lines->count,
                   .first = taut_arena_take(arena, pairs + 2, sizeof *all->first),
                   .s = taut_arena_take(arena, count + 1, sizeof *all->s)};
    if (pair == NULL || filled == NULL || all->first == NULL || all->s == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        pair[k] = pair_of(lines, taut_record_at(nodes, k));
        all->first[pair[k] + 1]++;
    }
    for (size_t k = 0; k <= pairs; k++) {
        all->first[k + 1] += all->first[k];
    }
    for (size_t k = 0; k < count; k++) {
        const taut_record *s = taut_record_get(taut_record_at(nodes, k), "s");
        double *at = all->s[all->first[pair[k]] + filled[pair[k]]++];
        at[0] = taut_record_number(taut_record_at(s, 0));
        at[1] = taut_record_number(taut_record_at(s, 1));
    }
    return TAUT_OK;
}

/* Is there a node of these two curves at these lengths? */
static int has_node(const taut_net_lines *lines, const known *all,
                    const taut_net_line *const both[2], const double t[2])
{
    const size_t pair =
        (size_t)(both[0] - lines->lines) * (size_t)all->count + (size_t)(both[1] - lines->lines);
    const double room = same_node * lines->size;
    for (size_t k = all->first[pair]; k < all->first[pair + 1]; k++) {
        if (fabs(all->s[k][0] - t[0]) <= room && fabs(all->s[k][1] - t[1]) <= room) {
            return 1;
        }
    }
    return 0;
}

static int unmet_of_spans(const taut_net_lines *lines, const known *all,
                          const taut_net_line *const both[2], const span *a, const span *b)
{
    int unmet = 0;
    for (int i = 0; i < CHORDS; i++) {
        for (int j = 0; j < CHORDS; j++) {
            const double step[2] = {a->t[i + 1] - a->t[i], b->t[j + 1] - b->t[j]};
            double part[2];
            if (!chords_cross(a->at[i], a->at[i + 1], b->at[j], b->at[j + 1], part)) {
                continue;
            }
            double t[2] = {a->t[i] + part[0] * step[0], b->t[j] + part[1] * step[1]};
            unmet += refine(lines, both, step, t) && !is_near_end(lines, both[0], t[0]) &&
                     !is_near_end(lines, both[1], t[1]) && !has_node(lines, all, both, t);
        }
    }
    return unmet;
}

static int unmet_of(const taut_net_lines *lines, const known *all,
                    const taut_net_line *const both[2], const course *a, const course *b)
{
    int unmet = 0;
    if (are_apart(a->low, a->high, b->low, b->high)) {
        return 0;
    }
    for (int i = 0; i < a->count; i++) {
        const span *s = &a->spans[i];
        if (are_apart(s->low, s->high, b->low, b->high)) {
            continue;
        }
        for (int j = 0; j < b->count; j++) {
            const span *o = &b->spans[j];
            if (s->on == o->on && !are_apart(s->low, s->high, o->low, o->high)) {
                unmet += unmet_of_spans(lines, all, both, s, o);
            }
        }
    }
    return unmet;
}

taut_status taut_net_met(const taut_net_lines *lines, taut_arena *arena, double *unmet,
                         char where[96])
{
    course *courses = taut_arena_take(arena, (size_t)lines->count + 1, sizeof *courses);
    known all;
    *unmet = 0;
    if (known_new(lines, arena, &all) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; courses != NULL && k < lines->count; k++) {
        if (course_new(lines, &lines->lines[k], arena, &courses[k]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    for (int i = 0; courses != NULL && i < lines->count; i++) {
        for (int j = 0; j < lines->count; j++) {
            const taut_net_line *const both[2] = {&lines->lines[i], &lines->lines[j]};
            const int is_pair = lines->net == TAUT_TRACE_GEODESIC
                                    ? i < j
                                    : both[0]->family == 0 && both[1]->family == 1;
            const int found = is_pair ? unmet_of(lines, &all, both, &courses[i], &courses[j]) : 0;
            if (found > 0 && *unmet == 0) {
                snprintf(where, 96, "%.40s and %.40s", taut_curve_name(both[0]->space),
                         taut_curve_name(both[1]->space));
            }
            *unmet += found;
        }
    }
    return courses != NULL ? TAUT_OK : TAUT_NO_MEMORY;
}
