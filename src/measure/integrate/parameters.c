#include "measure/integrate/parameters.h"

#include <float.h>
#include <math.h>

static void add_entry(taut_parameters *parameters, double t, int span)
{
    parameters->t[parameters->count] = t;
    parameters->span[parameters->count] = span;
    parameters->count++;
}

/* The inner break that t is meant to be, or 0: i (hi - lo) / (n - 1) is a knot that the document
 * writes in decimals only to a few roundings of the ends. */
static int break_at(const taut_basis *basis, double t)
{
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const int span = taut_basis_span(basis, t);
    const double slack = 4 * DBL_EPSILON * fmax(fabs(breaks[0]), fabs(breaks[spans]));
    if (span > 0 && t - breaks[span] <= slack) {
        return span;
    }
    return span + 1 < spans && breaks[span + 1] - t <= slack ? span + 1 : 0;
}

taut_parameters *taut_parameters_new(taut_arena *arena, const taut_basis *basis, int grid,
                                     double only)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    taut_parameters *made = taut_arena_take(arena, 1, sizeof *made);
    double *t = taut_arena_take(arena, 2 * (size_t)grid, sizeof(double));
    int *span = taut_arena_take(arena, 2 * (size_t)grid, sizeof(int));
    int *first = taut_arena_take(arena, (size_t)grid + 1, sizeof(int));

    if (first == NULL) {
        return NULL;
    }
    *made = (taut_parameters){.grid = grid, .t = t, .span = span, .first = first};
    for (int i = 0; i < grid; i++) {
        const double part = grid > 1 ? (double)i / (grid - 1) : 0;
        const double at = grid == 1 ? only : part == 1 ? hi : fmin(hi, lo + part * (hi - lo));
        const int k = grid > 1 ? break_at(basis, at) : 0;
        first[i] = made->count;
        if (k > 0) {
            add_entry(made, taut_basis_breaks(basis)[k], k - 1);
            add_entry(made, taut_basis_breaks(basis)[k], k);
        } else {
            add_entry(made, at, taut_basis_span(basis, at));
        }
    }
    first[grid] = made->count;
    return made;
}
