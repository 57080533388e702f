/* turning.c
 *
 *     the vector (k1 - k2)(cos 2 phi, sin 2 phi), phi from x_u to the first direction: 0 at umbilics, twice their index
 *     in turns round them
 *     of each cell, and of each stretch of a knot between its two sides, and of each crossing of two knots:
 *     halved until the vectors of its corners and of its middle lie within 60 degrees, or it is as small as may be
 *     then its turns once around: forwards, or not to be told where two corners are opposite
 */
#include "certify/trace/turning.h"

#include "certify/trace/side.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"

#include <math.h>

enum {
    FIRST = 6,  /* halvings of any cell */
    DEPTH = 28, /* of one whose corners differ */
    LOOKS = 1000000
};
/* Half of the sixty degrees; and the turn between two corners that may be one the other way. */
static const double near_enough = TAUT_PI / 6, opposite = 3.1;
/* Halves are unequal: zeros love the middle. */
static const double part = 0.4567;

/* A corner: its place, the cell whose polynomial counts, and the vector. */
typedef struct corner {
    double at[2], w[2];
    int span[2];
} corner;

typedef struct finder {
    const taut_surface *surface;
    int looks; /* so far: all along a line where the vector vanishes there is no end of them */
} finder;

static void look(finder *find, corner *c)
{
    taut_forms f;

    find->looks++;
    taut_net_side_forms(find->surface, c->span, c->at, &f);
    const double over = f.e * f.w;
    const double skew = f.m * f.e - f.l * f.f;
    c->w[0] = f.l / f.e - (f.n * f.e * f.e - 2 * f.m * f.e * f.f + f.l * f.f * f.f) / (over * f.w);
    c->w[1] = 2 * skew / over;
}

static double turn_between(const corner *a, const corner *b)
{
    return taut_atan2(a->w[0] * b->w[1] - a->w[1] * b->w[0], a->w[0] * b->w[0] + a->w[1] * b->w[1]);
}

/* The corners of a cell in their order around it: (lo, lo), (hi, lo), (hi, hi), (lo, hi). */
typedef struct cell {
    corner c[4];
} cell;

static corner between(finder *find, const corner *a, const corner *b)
{
    corner middle = *a;
    for (int d = 0; d < 2; d++) {
        middle.at[d] = a->at[d] + part * (b->at[d] - a->at[d]);
    }
    look(find, &middle);
    return middle;
}

/* Does the vector stay within 60 degrees, as far as the corners and the middle tell? */
static int is_clear(finder *find, const cell *one)
{
    const corner low = between(find, &one->c[0], &one->c[2]);
    const corner high = between(find, &one->c[2], &one->c[0]);
    for (int k = 0; k < 4; k++) {
        if (!(fabs(turn_between(&low, &one->c[k])) <= near_enough) ||
            !(fabs(turn_between(&high, &one->c[k])) <= near_enough)) {
            return 0;
        }
    }
    return 1;
}

/* Once around. */
static int turns_forwards(const cell *one)
{
    double around = 0;
    for (int k = 0; k < 4; k++) {
        const double turn = turn_between(&one->c[k], &one->c[(k + 1) % 4]);
        if (!(fabs(turn) < opposite)) {
            return 1;
        }
        around += turn;
    }
    return around > TAUT_PI;
}

/* Of a cell whose sides along direction d are no points. */
static void halve(finder *find, const cell *one, int d, cell *low, cell *high)
{
    const int at[2][4] = {{0, 1, 3, 2},
                          {0, 3, 1, 2}}; /* sides of direction d: from, to, from, to */
    *low = *high = *one;
    for (int side = 0; side < 2; side++) {
        const int from = at[d][2 * side], to = at[d][2 * side + 1];
        low->c[to] = high->c[from] = between(find, &one->c[from], &one->c[to]);
    }
}

static int search(finder *find, const cell *one, int depth)
{
    const int wide[2] = {one->c[0].at[0] < one->c[2].at[0], one->c[0].at[1] < one->c[2].at[1]};
    const int d = wide[0] && wide[1] ? depth % 2 : wide[1];
    cell low, high;

    if (depth >= FIRST && is_clear(find, one)) {
        return 0;
    }
    if (depth >= DEPTH || !wide[d] || find->looks > LOOKS) {
        return find->looks > LOOKS || turns_forwards(one);
    }
    halve(find, one, d, &low, &high);
    return search(find, &low, depth + 1) || search(find, &high, depth + 1);
}

/* The cell between two places, its corners of the polynomials of the spans from low to high. */
static int search_between(finder *find, const double from[2], const double to[2], const int low[2],
                          const int high[2])
{
    cell one;
    for (int k = 0; k < 4; k++) {
        const int is_high[2] = {k == 1 || k == 2, k >= 2};
        for (int d = 0; d < 2; d++) {
            one.c[k].at[d] = is_high[d] ? to[d] : from[d];
            one.c[k].span[d] = is_high[d] ? high[d] : low[d];
        }
        look(find, &one.c[k]);
    }
    return search(find, &one, 0);
}

int taut_net_turns_forwards(const taut_surface *surface)
{
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int count[2] = {taut_basis_span_count(basis[0]), taut_basis_span_count(basis[1])};
    finder find = {.surface = surface};
    const double *u = taut_basis_breaks(basis[0]), *v = taut_basis_breaks(basis[1]);

    /* 2 i: span i, 2 i + 1: the knot behind it */
    for (int i = 0; i < 2 * count[0] - 1; i++) {
        for (int j = 0; j < 2 * count[1] - 1; j++) {
            const int low[2] = {i / 2, j / 2}, high[2] = {(i + 1) / 2, (j + 1) / 2};
            const double from[2] = {u[(i + 1) / 2], v[(j + 1) / 2]};
            const double to[2] = {u[i / 2 + 1], v[j / 2 + 1]};
            if (search_between(&find, from, to, low, high)) {
                return 1;
            }
        }
    }
    return 0;
}
