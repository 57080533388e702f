/* line.h -- splines of degree 5 on clamped knots over [0, 1], and their values at the Gauss points of all spans.
 *
 * Spans are equal, or `graded`: strain is singular in the corners of a piece, and break k of n lies at g(k/n),
 * g(x) = x + 0.9 (3 x^2 - 2 x^3 - x): of 16 spans the first is a quarter as wide as the mean, those in the middle 1.4 times.
 */
#ifndef TAUT_PATTERN_LINE_H
#define TAUT_PATTERN_LINE_H

#include "pattern/flat/flat.h"

enum { TAUT_FLAT_LOCAL = TAUT_FLAT_DEGREE + 1 /* functions alive on a span */ };

typedef struct taut_flat_line {
    int spans, graded, count;
    /* of the functions alive, their slopes, and those of one degree less: [spans] */
    double (*value)[TAUT_FLAT_GAUSS][TAUT_FLAT_LOCAL], (*slope)[TAUT_FLAT_GAUSS][TAUT_FLAT_LOCAL],
        (*test)[TAUT_FLAT_GAUSS][TAUT_FLAT_LOCAL];
    double (*at)[TAUT_FLAT_GAUSS], (*weight)[TAUT_FLAT_GAUSS];
} taut_flat_line;

/* In the arena; 0 where there is no memory. */
int taut_flat_line_fill(taut_arena *arena, int spans, int graded, taut_flat_line *line);
/* Knot k of spans + 2 * 5 + 1, counted from the first of the left end's. */
double taut_flat_knot(int spans, int graded, int k);
/* Between spans k - 1 and k. */
double taut_flat_break(int spans, int graded, int k);
/* Half of the width of span k, and its place from -1 to 1. */
double taut_flat_half(int spans, int graded, int k);
double taut_flat_place(int spans, int graded, int k, double node);
int taut_flat_span(int spans, int graded, double x);
/* The degree + 1 functions alive on a span, and their slopes or NULL, by the recursion of de Boor; degree at most 5. */
void taut_flat_basis(int spans, int graded, int degree, int span, double x, double *value,
                     double *slope);

#endif /* TAUT_PATTERN_LINE_H */
