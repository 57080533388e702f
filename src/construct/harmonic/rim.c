#include "construct/harmonic/rim.h"

#include "construct/harmonic/growth.h"
#include "construct/harmonic/wide_solve.h"
#include "numeric/quadrature.h"
#include "numeric/wide.h"

#include <math.h>
#include <string.h>

void taut_rim_place(int n, int m, int k, int *i, int *j)
{
    if (k <= 2 * m + 1) {
        *i = k <= m ? 0 : n;
        *j = k <= m ? k : k - m - 1;
    } else {
        const int rest = k - 2 * (m + 1);
        *i = rest < n - 1 ? rest + 1 : rest - n + 2;
        *j = rest < n - 1 ? 0 : m;
    }
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

/* The value on side 0..3 (u0, u1, v0, v1) of a net, given the functions along it. */
static taut_twice on_side(const taut_space *space, int side, const taut_twice *net,
                          const taut_twice *along)
{
    const int d = side < 2 ? space->m : space->n, columns = space->m + 1;
    const int first = side == 1 ? space->n * columns : side == 3 ? space->m : 0;
    const int stride = side < 2 ? 1 : columns;
    taut_twice sum = {0, 0};
    for (int i = 0; i <= d; i++) {
        sum = taut_twice_gain(sum, along[i], net[first + i * stride]);
    }
    return sum;
}

/* Of boundary point k the function on a side, 0 where the point is not of it. */
static taut_twice point_on_side(const taut_space *space, int side, int k, const taut_twice *along)
{
    int i = 0, j = 0;
    taut_rim_place(space->n, space->m, k, &i, &j);
    if (side < 2) {
        return i == (side == 0 ? 0 : space->n) ? along[j] : taut_twice_of(0);
    }
    return j == (side == 2 ? 0 : space->m) ? along[i] : taut_twice_of(0);
}

/* Nonzero when it is to end: so many rows of so many numbers. */
static int beat(const taut_space *space, int rows, int numbers)
{
    return taut_pulse_beat(space->pulse, (double)TAUT_TWICE_WORK * rows * numbers);
}

int taut_rim_solve(const taut_space *space, taut_arena *arena, taut_rim *boundary)
{
    const int unknowns = space->count, points = 2 * (space->n + space->m),
              width = unknowns + points;
    const int nodes = (space->n > space->m ? space->n : space->m) + 2;
    const size_t numbers = (size_t)(space->n + 1) * (size_t)(space->m + 1);
    double t[TAUT_GAUSS_MAX], w[TAUT_GAUSS_MAX];
    taut_twice *r = taut_arena_take(arena, (size_t)unknowns * (size_t)width, sizeof *r);
    taut_twice *block = taut_arena_take(arena, (size_t)nodes * (size_t)width, sizeof *block);
    taut_twice *scratch = taut_arena_take(arena, (size_t)width, sizeof *scratch);
    taut_twice *response =
        taut_arena_take(arena, (size_t)unknowns * (size_t)points, sizeof *response);

    if (r == NULL || block == NULL || scratch == NULL || response == NULL) {
        return 0;
    }
    taut_gauss_rule(nodes, t, w);
    for (int side = 0; side < 4; side++) {
        for (int s = 0; s < nodes && !beat(space, unknowns, nodes); s++) {
            taut_twice along[TAUT_SPACE_DEGREE_MAX + 1], *row = block + s * width;
            const taut_twice weight = taut_twice_root(taut_twice_of(w[s] / 2));
            const taut_twice at = taut_twice_sum(t[s] / 2, 0.5);
            bernstein(side < 2 ? space->m : space->n, at, along);
            for (int k = 0; k < unknowns; k++) {
                row[k] = taut_twice_times(
                    weight, on_side(space, side, space->nets + (size_t)k * numbers, along));
            }
            for (int k = 0; k < points; k++) {
                row[unknowns + k] = taut_twice_times(weight, point_on_side(space, side, k, along));
            }
        }
        taut_wide_append(unknowns, width, r, nodes, block, scratch, space->pulse);
    }
    taut_wide_back(unknowns, width, r, space->pulse);
    for (int i = 0; i < unknowns; i++) {
        memcpy(response + i * points, r + i * width + unknowns, (size_t)points * sizeof *r);
    }
    *boundary = (taut_rim){space, points, response};
    return !taut_pulse_is_stopped(space->pulse);
}

/* net += sum_k coefficient_k net_k with the coefficients of the rest: given minus net so far. */
static void improve_net(const taut_rim *boundary, const double *given, taut_twice *rest,
                        taut_twice *coefficients, taut_twice *net)
{
    const taut_space *space = boundary->space;
    const int columns = space->m + 1, numbers = (space->n + 1) * columns;

    for (int k = 0; k < boundary->count; k++) {
        int i = 0, j = 0;
        taut_rim_place(space->n, space->m, k, &i, &j);
        for (int c = 0; c < 3; c++) {
            const int at = 3 * (i * columns + j) + c;
            rest[3 * k + c] = taut_twice_less(taut_twice_of(given[at]), net[at]);
        }
    }
    for (int f = 0; f < space->count && !beat(space, 3, boundary->count); f++) {
        const taut_twice *response = boundary->response + f * boundary->count;
        memset(coefficients + 3 * f, 0, 3 * sizeof *coefficients);
        for (int k = 0; k < boundary->count; k++) {
            taut_wide_gain(3, response[k], rest + 3 * k, coefficients + 3 * f);
        }
    }
    for (int f = 0; f < space->count && !beat(space, 3, numbers); f++) {
        const taut_twice *function = space->nets + (size_t)f * (size_t)numbers;
        for (int k = 0; k < numbers; k++) {
            taut_wide_gain(3, function[k], coefficients + 3 * f, net + 3 * k);
        }
    }
}

void taut_rim_net(const taut_rim *boundary, const double *given, taut_twice *scratch, double *net)
{
    const size_t numbers = 3 * (size_t)(boundary->space->n + 1) * (size_t)(boundary->space->m + 1);
    taut_twice *rest = scratch, *coefficients = rest + 3 * boundary->count;
    taut_twice *sum = coefficients + 3 * boundary->space->count;

    memset(sum, 0, numbers * sizeof *sum);
    for (int pass = 0; pass < 3; pass++) { /* the second and third take out what rounding left */
        improve_net(boundary, given, rest, coefficients, sum);
    }
    for (size_t k = 0; k < numbers; k++) {
        net[k] = taut_twice_round(sum[k]);
    }
}

double taut_rim_amplification(const taut_rim *boundary)
{
    const taut_space *space = boundary->space;
    const int numbers = (space->n + 1) * (space->m + 1);
    double most = 0;

    for (int at = 0; at < numbers && !beat(space, space->count, boundary->count); at++) {
        double sum = 0;
        taut_twice entries[4 * TAUT_SPACE_DEGREE_MAX];
        memset(entries, 0, (size_t)boundary->count * sizeof *entries);
        for (int f = 0; f < space->count; f++) {
            taut_wide_gain(boundary->count, space->nets[(size_t)f * (size_t)numbers + (size_t)at],
                           boundary->response + f * boundary->count, entries);
        }
        for (int k = 0; k < boundary->count; k++) {
            sum += fabs(taut_twice_round(entries[k]));
        }
        most = taut_larger_growth(most, sum);
    }
    return most;
}
