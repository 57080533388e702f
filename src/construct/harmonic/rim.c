#include "construct/harmonic/rim.h"

#include "construct/harmonic/growth.h"
#include "construct/harmonic/wide_solve.h"
#include "numeric/quadrature.h"
#include "numeric/wide.h"

#include <math.h>
#include <string.h>

enum {
    WAYS = 4
}; /* to be odd and even, as taut_space.odd has them; and to be mirrored: 1, u <-> 1 - u, 2, v <-> 1 - v */

/* x, or -x where what is odd so changes sign when it is mirrored so. */
static taut_twice mirrored(int odd, int how, taut_twice x)
{
    const int both = odd & how;
    return both == 1 || both == 2 ? taut_twice_negative(x) : x;
}

/* The first point of orbit k: along row 0 to the middle, then along column 0. */
static void place_orbit(const taut_space *space, int k, int *i, int *j)
{
    const int row = space->m / 2;
    *i = k <= row ? 0 : k - row;
    *j = k <= row ? k : 0;
}

/* Where point (i, j) of a net of points is, mirrored. */
static int place_mirrored(const taut_space *space, int how, int i, int j)
{
    return ((how & 1) != 0 ? space->n - i : i) * (space->m + 1) +
           ((how & 2) != 0 ? space->m - j : j);
}

/* B[d,i](t), i = 0..d. */
static void bernstein(int d, taut_twice t, taut_twice *b)
{
    const taut_twice rest = taut_twice_less(taut_twice_of(1), t);
    b[0] = taut_twice_of(1);
    for (int k = 1; k <= d; k++) {
        b[k] = taut_twice_times(t, b[k - 1]);
        for (int i = k - 1; i > 0; i--) {
            b[i] = taut_twice_gain(taut_twice_times(t, b[i - 1]), rest, b[i]);
        }
        b[0] = taut_twice_times(rest, b[0]);
    }
}

/* The value on the edge u = 0 (side 0) or v = 0 (side 1) of a net, given the functions along it. */
static taut_twice on_side(const taut_space *space, int side, const taut_twice *net,
                          const taut_twice *along)
{
    const int d = side == 0 ? space->m : space->n, stride = side == 0 ? 1 : space->m + 1;
    taut_twice sum = {0, 0};
    for (int i = 0; i <= d; i++) {
        sum = taut_twice_gain(sum, along[i], net[i * stride]);
    }
    return sum;
}

/* The same of points that are odd and even, 1 and -1 on orbit k and 0 elsewhere. */
static taut_twice orbit_on_side(const taut_space *space, int side, int k, int odd,
                                const taut_twice *along)
{
    const int d = side == 0 ? space->m : space->n;
    int i = 0, j = 0;
    place_orbit(space, k, &i, &j);
    const int at = side == 0 ? j : i;
    if ((side == 0 ? i : j) != 0) {
        return taut_twice_of(0);
    }
    const taut_twice other = mirrored(odd, side == 0 ? 2 : 1, along[d - at]);
    return 2 * at == d ? taut_twice_scale(0.5, taut_twice_add(along[at], other))
                       : taut_twice_add(along[at], other);
}

/* Nonzero when it is to end: so many rows of so many numbers. */
static int beat(const taut_space *space, int rows, int numbers)
{
    return taut_pulse_beat(space->pulse, (double)TAUT_TWICE_WORK * rows * numbers);
}

/* The functions that are odd and even in one way, and room to solve for them. */
typedef struct way {
    int odd, count, width;
    const int *functions; /* [count] */
    taut_twice *r, *block, *scratch;
} way;

/* Their values and those of all orbits at a node of a side. */
static void fill_row(const taut_space *space, const way *w, int side, const taut_twice *along,
                     taut_twice weight, taut_twice *row)
{
    const size_t numbers = (size_t)(space->n + 1) * (size_t)(space->m + 1);
    for (int k = 0; k < w->count; k++) {
        const taut_twice *net = space->nets + (size_t)w->functions[k] * numbers;
        row[k] = taut_twice_times(weight, on_side(space, side, net, along));
    }
    for (int k = w->count; k < w->width; k++) {
        row[k] = taut_twice_times(weight, orbit_on_side(space, side, k - w->count, w->odd, along));
    }
}

/* Nodes to the middle, which counts by half: the other half of a side is as this one. */
static void solve_way(const taut_space *space, int nodes, const way *w)
{
    double t[TAUT_GAUSS_MAX], weights[TAUT_GAUSS_MAX];
    const int half = (nodes + 1) / 2;

    memset(w->r, 0, (size_t)w->count * (size_t)w->width * sizeof *w->r);
    taut_gauss_rule(nodes, t, weights);
    for (int s = 0; s < 2 * half && !beat(space, w->width, half); s++) {
        const int k = s / 2, side = s % 2;
        taut_twice along[TAUT_SPACE_DEGREE_MAX + 1];
        bernstein(side == 0 ? space->m : space->n, taut_twice_sum(t[k] / 2, 0.5), along);
        fill_row(space, w, side, along,
                 taut_twice_root(taut_twice_of(2 * k + 1 == nodes ? weights[k] / 2 : weights[k])),
                 w->block + s * w->width);
    }
    taut_wide_append(w->count, w->width, w->r, 2 * half, w->block, w->scratch, space->pulse);
    taut_wide_back(w->count, w->width, w->r, space->pulse);
}

int taut_rim_solve(const taut_space *space, taut_arena *arena, taut_rim *boundary)
{
    const int orbits = space->n / 2 + space->m / 2 + 1, most = space->count + orbits;
    const int nodes = (space->n > space->m ? space->n : space->m) + 2;
    int functions[4 * TAUT_SPACE_DEGREE_MAX];
    way w = {.functions = functions,
             .r = taut_arena_take(arena, (size_t)space->count * (size_t)most, sizeof *w.r),
             .block = taut_arena_take(arena, (size_t)(nodes + 1) * (size_t)most, sizeof *w.block),
             .scratch = taut_arena_take(arena, (size_t)most, sizeof *w.scratch)};
    taut_twice *response =
        taut_arena_take(arena, (size_t)space->count * (size_t)orbits, sizeof *response);

    if (w.r == NULL || w.block == NULL || w.scratch == NULL || response == NULL) {
        return 0;
    }
    for (w.odd = 0; w.odd < WAYS; w.odd++) {
        w.count = 0;
        for (int f = 0; f < space->count; f++) {
            functions[w.count] = f;
            w.count += space->odd[f] == w.odd;
        }
        w.width = w.count + orbits;
        solve_way(space, nodes, &w);
        for (int k = 0; k < w.count; k++) {
            memcpy(response + functions[k] * orbits, w.r + k * w.width + w.count,
                   (size_t)orbits * sizeof *response);
        }
    }
    *boundary = (taut_rim){space, orbits, response};
    return !taut_pulse_is_stopped(space->pulse);
}

/* parts [WAYS][orbits][3]: what is odd and even in each way of the boundary points of given - net. */
static void take_apart(const taut_rim *boundary, const double *given, const taut_twice *net,
                       taut_twice *parts)
{
    const taut_space *space = boundary->space;
    memset(parts, 0, (size_t)(WAYS * 3 * boundary->orbits) * sizeof *parts);
    for (int k = 0; k < boundary->orbits; k++) {
        int i = 0, j = 0;
        place_orbit(space, k, &i, &j);
        for (int t = 0; t < 3 * WAYS; t++) {
            const int c = t % 3, from = 3 * place_mirrored(space, t / 3, i, j) + c;
            const taut_twice rest =
                taut_twice_scale(0.25, taut_twice_less(taut_twice_of(given[from]), net[from]));
            for (int odd = 0; odd < WAYS; odd++) {
                taut_twice *const to = parts + 3 * (odd * boundary->orbits + k) + c;
                *to = taut_twice_add(*to, mirrored(odd, t / 3, rest));
            }
        }
    }
}

/* net += the sum of the ways' nets, of each of which there is the quarter with u, v <= 1/2. */
static void put_together(const taut_space *space, const taut_twice *quarters, taut_twice *net)
{
    const int lines = space->n / 2 + 1, columns = space->m / 2 + 1;
    for (int k = 0; k < lines * columns; k++) {
        const int i = k / columns, j = k % columns;
        for (int how = 0; how < WAYS; how++) {
            if (((how & 1) != 0 && 2 * i == space->n) || ((how & 2) != 0 && 2 * j == space->m)) {
                continue; /* it is its own image */
            }
            for (int t = 0; t < 3 * WAYS; t++) {
                const int c = t % 3, odd = t / 3;
                taut_twice *const to = net + 3 * place_mirrored(space, how, i, j) + c;
                *to = taut_twice_add(
                    *to, mirrored(odd, how, quarters[3 * (odd * lines * columns + k) + c]));
            }
        }
    }
}

/* net += the nearest net to what is left: given minus net so far. */
static void improve_net(const taut_rim *boundary, const double *given, taut_twice *parts,
                        taut_twice *quarters, taut_twice *net)
{
    const taut_space *space = boundary->space;
    const int lines = space->n / 2 + 1, columns = space->m / 2 + 1, orbits = boundary->orbits;

    take_apart(boundary, given, net, parts);
    memset(quarters, 0, (size_t)(WAYS * 3 * lines * columns) * sizeof *quarters);
    for (int f = 0; f < space->count && !beat(space, 3, orbits + lines * columns); f++) {
        const taut_twice *function =
            space->nets + (size_t)f * (size_t)((space->n + 1) * (space->m + 1));
        taut_twice sum[3] = {{0, 0}, {0, 0}, {0, 0}};
        taut_twice *to = quarters + 3 * space->odd[f] * lines * columns;
        for (int k = 0; k < orbits; k++) {
            taut_wide_gain(3, boundary->response[f * orbits + k],
                           parts + 3 * (space->odd[f] * orbits + k), sum);
        }
        for (int k = 0; k < lines * columns; k++) {
            taut_wide_gain(3, function[k / columns * (space->m + 1) + k % columns], sum,
                           to + 3 * k);
        }
    }
    put_together(space, quarters, net);
}

int taut_rim_net(const taut_rim *boundary, taut_arena *arena, const double *given, double *net)
{
    const taut_space *space = boundary->space;
    const size_t numbers = 3 * (size_t)(space->n + 1) * (size_t)(space->m + 1);
    taut_twice *sum = taut_arena_take(arena, numbers, sizeof *sum);
    taut_twice *parts = taut_arena_take(arena, (size_t)(WAYS * 3 * boundary->orbits), sizeof *sum);
    taut_twice *quarters = taut_arena_take(
        arena, (size_t)(WAYS * 3 * (space->n / 2 + 1) * (space->m / 2 + 1)), sizeof *sum);

    if (sum == NULL || parts == NULL || quarters == NULL) {
        return 0;
    }
    for (int pass = 0; pass < 3; pass++) { /* the second and third take out what rounding left */
        improve_net(boundary, given, parts, quarters, sum);
    }
    for (size_t k = 0; k < numbers; k++) {
        net[k] = taut_twice_round(sum[k]);
    }
    return 1;
}

/* The sum over boundary points of what one of them makes of point `at` of the net, in size: a quarter of the sum of what it makes
 * in all ways, as its orbit and as what is left of it when mirrored. */
static double growth_at(const taut_rim *boundary, int at)
{
    const taut_space *space = boundary->space;
    const int numbers = (space->n + 1) * (space->m + 1), orbits = boundary->orbits;
    taut_twice entries[WAYS * (TAUT_SPACE_DEGREE_MAX + 1)];
    double sum = 0;

    memset(entries, 0, (size_t)(WAYS * orbits) * sizeof *entries);
    for (int f = 0; f < space->count; f++) {
        taut_wide_gain(orbits, space->nets[(size_t)f * (size_t)numbers + (size_t)at],
                       boundary->response + f * orbits, entries + space->odd[f] * orbits);
    }
    for (int k = 0; k < WAYS * orbits; k++) {
        taut_twice all = {0, 0};
        for (int odd = 0; odd < WAYS; odd++) {
            all =
                taut_twice_add(all, mirrored(odd, k / orbits, entries[odd * orbits + k % orbits]));
        }
        sum += fabs(taut_twice_round(all));
    }
    return sum / 4;
}

double taut_rim_amplification(const taut_rim *boundary)
{
    const taut_space *space = boundary->space;
    const int lines = space->n / 2 + 1, columns = space->m / 2 + 1;
    double most = 0;

    for (int k = 0; k < lines * columns && !beat(space, space->count, boundary->orbits); k++) {
        const int at = k / columns * (space->m + 1) + k % columns;
        most = taut_larger_growth(most, growth_at(boundary, at));
    }
    return most;
}
