/* loop.c -- K by blossoms: with a the knot at the seam,
 *
 *     g_i^l = f(t_(i+1+l), .., t_(p-1), a, .., a, t_(p+1), .., t_(p+i))     (a: 1 + l times)
 *     g_i^l = (1 - w) g_i^(l-1) + w g_(i+1)^(l-1),   w = (a - t_(i+l)) / (t_(p+i+1) - t_(i+l))
 *
 * leads from c_i = g_i^0 to P_i = g_i^(p-1-i).
 */
#include "geometry/nurbs/loop.h"

#include "core/vec3.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum { LOCAL = TAUT_DEGREE_MAX + 1 };

/* Knot k of those that go on with the period. */
static double knot_of(const taut_basis_spec *spec, int n, int k)
{
    const int p = spec->degree, m = n - p;
    const double range = spec->knots[n] - spec->knots[p];
    return k < p ? spec->knots[k + m] - range : k > n ? spec->knots[k - m] + range : spec->knots[k];
}

/* Distance of knot k from that at the seam, counted into the range from one end or the other. */
static double away(const taut_basis_spec *spec, int n, int from_end, int k)
{
    const int p = spec->degree;
    return from_end ? spec->knots[n] - knot_of(spec, n, n + p - k)
                    : knot_of(spec, n, k) - spec->knots[p];
}

/* rows [p][p]: of P_0 .. P_(p-1) over c_0 .. c_(p-1). */
static void insert_seam(const taut_basis_spec *spec, int n, int from_end, double *rows)
{
    const int p = spec->degree;

    for (int i = 0; i < p; i++) {
        rows[i * p + i] = 1;
    }
    for (int l = 1; l < p; l++) {
        for (int i = 0; i + l < p; i++) { /* row i + 1 is still that of l - 1 */
            const double below = away(spec, n, from_end, i + l);
            const double above = away(spec, n, from_end, p + i + 1);
            const double w = -below / (above - below);
            for (int j = 0; j < p; j++) {
                rows[i * p + j] = (1 - w) * rows[i * p + j] + w * rows[(i + 1) * p + j];
            }
        }
    }
}

taut_status taut_loop_new(const taut_basis *basis, taut_arena *arena, taut_loop *loop)
{
    taut_basis_spec spec;

    taut_basis_spec_of(basis, &spec);
    const size_t p = (size_t)spec.degree;
    *loop = (taut_loop){.degree = spec.degree, .count = taut_basis_count(basis)};
    loop->period = loop->count - loop->degree;
    loop->first = taut_arena_take(arena, p * p, sizeof(double));
    loop->last = taut_arena_take(arena, p * p, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    assert(spec.knots != NULL && loop->count >= taut_loop_least(loop->degree));
    insert_seam(&spec, loop->count, 0, loop->first);
    insert_seam(&spec, loop->count, 1, loop->last);
    return TAUT_OK;
}

void taut_loop_open(const taut_loop *loop, int first, double *values)
{
    const int p = loop->degree;
    double open[LOCAL];

    memcpy(open, values, ((size_t)p + 1) * sizeof(double));
    for (int a = 0; a <= p; a++) {
        const int i = first + a, k = loop->count - 1 - i;
        const double *row = i < p ? loop->first + i * p : k < p ? loop->last + k * p : NULL;
        if (row == NULL) {
            continue;
        }
        open[a] -= values[a];
        for (int j = i < p ? i : k; j < p; j++) {
            const int at = (i < p ? j : loop->count - 1 - j) - first;
            open[at] += row[j] * values[a];
        }
    }
    memcpy(values, open, ((size_t)p + 1) * sizeof(double));
}

/* The p points at one end, in the order from that end inwards. */
static void clamp_end(const taut_loop *loop, const double *rows, double *points[LOCAL])
{
    const int p = loop->degree;

    for (int i = 0; i < p - 1; i++) { /* those further in are still the c */
        double x[3] = {0, 0, 0};
        for (int j = i; j < p; j++) {
            taut_add_scaled(rows[i * p + j], points[j], x);
        }
        memcpy(points[i], x, sizeof x);
    }
}

void taut_loop_clamp(const taut_loop *loop, size_t step, double *points)
{
    const int p = loop->degree;
    double *end[LOCAL];

    for (int i = 0; i < p; i++) {
        end[i] = points + 3 * step * (size_t)i;
    }
    clamp_end(loop, loop->first, end);
    for (int i = 0; i < p; i++) {
        end[i] = points + 3 * step * (size_t)(loop->count - 1 - i);
    }
    clamp_end(loop, loop->last, end);
    memcpy(end[0], points, 3 * sizeof(double)); /* one point, to the bit */
}

void taut_loop_unclamp(const taut_loop *loop, size_t step, double *points)
{
    const int p = loop->degree;

    for (int i = p - 2; i >= 0; i--) {
        double *x = points + 3 * step * (size_t)i;
        for (int j = i + 1; j < p; j++) {
            taut_add_scaled(-loop->first[i * p + j], points + 3 * step * (size_t)j, x);
        }
        for (int c = 0; c < 3; c++) {
            x[c] /= loop->first[i * p + i];
        }
    }
    for (int j = 0; j < p; j++) {
        memcpy(points + 3 * step * (size_t)(loop->period + j), points + 3 * step * (size_t)j,
               3 * sizeof(double));
    }
}

void taut_loop_unclamp_slopes(const taut_loop *loop, size_t step, double *slopes)
{
    const int p = loop->degree;

    for (int i = 0; i < p - 1; i++) {
        double *x = slopes + 3 * step * (size_t)i;
        for (int c = 0; c < 3; c++) {
            x[c] /= loop->first[i * p + i];
        }
        for (int j = i + 1; j < p; j++) {
            taut_add_scaled(-loop->first[i * p + j], x, slopes + 3 * step * (size_t)j);
        }
    }
}

double taut_loop_greville(const taut_basis *basis, int j)
{
    const int n = taut_basis_count(basis), p = taut_basis_degree(basis);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    taut_basis_spec spec;
    double sum = 0;

    taut_basis_spec_of(basis, &spec);
    for (int k = 1; k <= p; k++) {
        sum += (knot_of(&spec, n, j + k) - lo) / p;
    }
    return fmin(hi, fmax(lo, lo + (sum < 0         ? sum + (hi - lo)
                                   : sum > hi - lo ? sum - (hi - lo)
                                                   : sum)));
}
