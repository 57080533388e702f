#include "pattern/flat/line.h"

#include "numeric/quadrature.h"

#include <string.h>

enum { DEGREE = TAUT_FLAT_DEGREE, LOCAL = TAUT_FLAT_LOCAL, GAUSS = TAUT_FLAT_GAUSS };

double taut_flat_break(int spans, int graded, int k)
{
    static const double share = 0.9;
    const double x = (double)k / spans;
    return graded ? x + share * (x * x * (3 - 2 * x) - x) : x;
}

double taut_flat_half(int spans, int graded, int k)
{
    return (taut_flat_break(spans, graded, k + 1) - taut_flat_break(spans, graded, k)) / 2;
}

double taut_flat_place(int spans, int graded, int k, double node)
{
    return graded
               ? taut_flat_break(spans, graded, k) + taut_flat_half(spans, graded, k) * (1 + node)
               : (k + 0.5 + 0.5 * node) / spans;
}

double taut_flat_knot(int spans, int graded, int k)
{
    const int i = k - DEGREE;
    return i <= 0 ? 0 : i >= spans ? 1 : taut_flat_break(spans, graded, i);
}

void taut_flat_basis(int spans, int graded, int degree, int span, double x, double *value,
                     double *slope)
{
    const int first = DEGREE + span; /* the knot at the span's left */
    double lower[LOCAL] = {1};
    double n[LOCAL] = {1};

    for (int p = 1; p <= degree; p++) {
        double saved = 0;
        memcpy(lower, n, sizeof lower);
        for (int r = 0; r < p; r++) {
            const double right = taut_flat_knot(spans, graded, first + r + 1),
                         left = taut_flat_knot(spans, graded, first + r + 1 - p);
            const double part = lower[r] / (right - left);
            n[r] = saved + (right - x) * part;
            saved = (x - left) * part;
        }
        n[p] = saved;
    }
    memcpy(value, n, sizeof(double) * (size_t)(degree + 1));
    if (slope == NULL) {
        return;
    }
    for (int r = 0; r <= degree; r++) {
        const double a = r > 0 ? lower[r - 1] / (taut_flat_knot(spans, graded, first + r) -
                                                 taut_flat_knot(spans, graded, first + r - degree))
                               : 0;
        const double b = r < degree
                             ? lower[r] / (taut_flat_knot(spans, graded, first + r + 1) -
                                           taut_flat_knot(spans, graded, first + r + 1 - degree))
                             : 0;
        slope[r] = degree * (a - b);
    }
}

int taut_flat_span(int spans, int graded, double x)
{
    int lo = 0, hi = spans;
    while (hi - lo > 1) {
        const int k = (lo + hi) / 2;
        if (x < taut_flat_break(spans, graded, k)) {
            hi = k;
        } else {
            lo = k;
        }
    }
    return lo;
}

int taut_flat_line_fill(taut_arena *arena, int spans, int graded, taut_flat_line *l)
{
    double node[GAUSS], weight[GAUSS];
    const size_t n = (size_t)spans;

    l->spans = spans;
    l->graded = graded;
    l->count = spans + DEGREE;
    l->value = taut_arena_take(arena, n, sizeof *l->value);
    l->slope = taut_arena_take(arena, n, sizeof *l->slope);
    l->test = taut_arena_take(arena, n, sizeof *l->test);
    l->weight = taut_arena_take(arena, n, sizeof *l->weight);
    l->at = taut_arena_take(arena, n, sizeof *l->at);
    if (taut_arena_status(arena) != TAUT_OK) {
        return 0;
    }
    taut_gauss_rule(GAUSS, node, weight);
    for (int k = 0; k < spans; k++) {
        for (int q = 0; q < GAUSS; q++) {
            l->at[k][q] = taut_flat_place(spans, graded, k, node[q]);
            l->weight[k][q] = weight[q] * taut_flat_half(spans, graded, k);
            taut_flat_basis(spans, graded, DEGREE, k, l->at[k][q], l->value[k][q], l->slope[k][q]);
            taut_flat_basis(spans, graded, DEGREE - 1, k, l->at[k][q], l->test[k][q], NULL);
        }
    }
    return 1;
}
