#include "geometry/nurbs/cells.h"

#include "basis/basis_ops.h"
#include "core/memory.h"

#include <math.h>
#include <string.h>

enum { DEPTH_MAX = 48 }; /* a pole nearer than 2^-48 of its span is no longer resolved */
static const double layer_width = 4;

/* What is asked about, and the cells so far; `room` of them fit. */
typedef struct cutting {
    const taut_basis *basis;
    int lines;
    const double *weights;
    size_t step, next;
    taut_cells *cells;
    int room;
    double *values; /* [local + 1][local] */
} cutting;

void taut_cells_free(taut_cells *cells)
{
    if (cells != NULL) {
        taut_free(cells->lo);
        taut_free(cells->hi);
        taut_free(cells->span);
        taut_free(cells);
    }
}

taut_status taut_cells_copy(const taut_cells *cells, taut_cells **copy)
{
    const size_t count = (size_t)cells->count;
    taut_cells *made = taut_alloc_zero(1, sizeof *made);

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->count = cells->count;
    made->lo = taut_alloc(count, sizeof(double));
    made->hi = taut_alloc(count, sizeof(double));
    made->span = taut_alloc(count, sizeof(int));
    if (made->lo == NULL || made->hi == NULL || made->span == NULL) {
        taut_cells_free(made);
        return TAUT_NO_MEMORY;
    }
    memcpy(made->lo, cells->lo, count * sizeof(double));
    memcpy(made->hi, cells->hi, count * sizeof(double));
    memcpy(made->span, cells->span, count * sizeof(int));
    *copy = made;
    return TAUT_OK;
}

/* Does w on some line vary by more than 4 among `local` + 1 places from lo to hi? As many as w has
 * bends: at the ends and in the middle alone a bump in between would go unseen. */
static int varies(const cutting *c, int span, double lo, double hi)
{
    const int local = taut_basis_local(c->basis);
    const double *first = c->weights + (size_t)taut_basis_first(c->basis, span) * c->step;

    for (int k = 0; k <= local; k++) {
        const double t = k < local ? lo + (hi - lo) * ((double)k / local) : hi;
        taut_basis_eval(c->basis, span, t, 0, c->values + k * local);
    }
    for (size_t l = 0; l < (size_t)c->lines; l++) {
        double least = INFINITY, largest = 0;
        for (int k = 0; k <= local; k++) {
            double w = 0;
            for (int i = 0; i < local; i++) {
                w += first[(size_t)i * c->step + l * c->next] * c->values[k * local + i];
            }
            least = fmin(least, w);
            largest = fmax(largest, w);
        }
        if (largest > 4 * least) {
            return 1;
        }
    }
    return 0;
}

/* Is [lo, hi] long against the exponentials in it? They fade towards the middle of the span: there
 * a cell may be as wide as it is far from the nearer end. */
static int has_layer(const taut_basis *basis, int span, double lo, double hi)
{
    const double *ends = taut_basis_breaks(basis) + span;
    return basis->ops->layers && hi - lo > fmax(layer_width, fmin(lo - ends[0], ends[1] - hi));
}

static taut_status add_cell(cutting *c, int span, double lo, double hi)
{
    taut_cells *p = c->cells;
    if (p->count == c->room) {
        const size_t room = 2 * (size_t)c->room;
        double *low = taut_realloc(p->lo, room, sizeof *low);
        p->lo = low != NULL ? low : p->lo;
        double *high = taut_realloc(p->hi, room, sizeof *high);
        p->hi = high != NULL ? high : p->hi;
        int *spans = taut_realloc(p->span, room, sizeof *spans);
        p->span = spans != NULL ? spans : p->span;
        if (low == NULL || high == NULL || spans == NULL) {
            return TAUT_NO_MEMORY;
        }
        c->room *= 2;
    }
    p->lo[p->count] = lo;
    p->hi[p->count] = hi;
    p->span[p->count++] = span;
    return TAUT_OK;
}

/* Cuts one span; the stack holds the right halves still to do. */
static taut_status cut_span(cutting *c, int span)
{
    const double *breaks = taut_basis_breaks(c->basis);
    double ends[DEPTH_MAX + 1];
    double lo = breaks[span];
    int depth = 0;

    ends[0] = breaks[span + 1];
    while (depth >= 0) {
        const double hi = ends[depth], middle = lo + 0.5 * (hi - lo);
        if (depth < DEPTH_MAX && middle > lo && middle < hi &&
            hi - lo > ldexp(breaks[span + 1] - breaks[span], -DEPTH_MAX) &&
            (has_layer(c->basis, span, lo, hi) ||
             (c->weights != NULL && varies(c, span, lo, hi)))) {
            ends[++depth] = middle;
            continue;
        }
        if (add_cell(c, span, lo, hi) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        lo = hi;
        depth--;
    }
    return TAUT_OK;
}

double taut_cells_finest(const taut_basis *basis, int span)
{
    const double *ends = taut_basis_breaks(basis) + span;
    return basis->ops->layers ? fmin(ends[1] - ends[0], 1) : ends[1] - ends[0];
}

taut_status taut_cells_new(const taut_basis *basis, int lines, const double *weights, size_t step,
                           size_t next, taut_cells **cells)
{
    const int spans = taut_basis_span_count(basis);
    taut_cells *made = taut_alloc_zero(1, sizeof *made);
    const size_t local = (size_t)taut_basis_local(basis);
    cutting c = {basis, lines, weights, step, next, made, spans, NULL};
    int is_whole = 1;

    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->lo = taut_alloc((size_t)spans, sizeof(double));
    made->hi = taut_alloc((size_t)spans, sizeof(double));
    made->span = taut_alloc((size_t)spans, sizeof(int));
    c.values = weights != NULL ? taut_alloc(local + 1, local * sizeof(double)) : NULL;
    is_whole = made->lo != NULL && made->hi != NULL && made->span != NULL &&
               (weights == NULL || c.values != NULL);
    for (int k = 0; is_whole && k < spans; k++) {
        is_whole = cut_span(&c, k) == TAUT_OK;
    }
    taut_free(c.values);
    if (!is_whole) {
        taut_cells_free(made);
        return TAUT_NO_MEMORY;
    }
    *cells = made;
    return TAUT_OK;
}
