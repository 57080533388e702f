#include "measure/integrate/parameters.h"

#include "core/memory.h"

#include <float.h>
#include <math.h>

void taut_parameters_free(taut_parameters *lines)
{
    if (lines != NULL) {
        taut_free(lines->t);
        taut_free(lines->span);
        taut_free(lines->first);
        taut_free(lines);
    }
}

static taut_parameters *lines_alloc(int grid)
{
    taut_parameters *lines = taut_alloc_zero(1, sizeof *lines);
    if (lines == NULL) {
        return NULL;
    }
    lines->grid = grid;
    lines->t = taut_alloc(2 * (size_t)grid, sizeof(double));
    lines->span = taut_alloc(2 * (size_t)grid, sizeof(int));
    lines->first = taut_alloc((size_t)grid + 1, sizeof(int));
    if (lines->t == NULL || lines->span == NULL || lines->first == NULL) {
        taut_parameters_free(lines);
        return NULL;
    }
    return lines;
}

static void add(taut_parameters *lines, double t, int span)
{
    lines->t[lines->count] = t;
    lines->span[lines->count] = span;
    lines->count++;
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

taut_status taut_parameters_new(const taut_basis *basis, int grid, double only,
                                taut_parameters **lines)
{
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    taut_parameters *made = lines_alloc(grid);

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < grid; i++) {
        const double part = grid > 1 ? (double)i / (grid - 1) : 0;
        const double t = grid == 1 ? only : part == 1 ? hi : fmin(hi, lo + part * (hi - lo));
        const int at = grid > 1 ? break_at(basis, t) : 0;
        made->first[i] = made->count;
        if (at > 0) {
            add(made, taut_basis_breaks(basis)[at], at - 1);
            add(made, taut_basis_breaks(basis)[at], at);
        } else {
            add(made, t, taut_basis_span(basis, t));
        }
    }
    made->first[grid] = made->count;
    *lines = made;
    return TAUT_OK;
}
