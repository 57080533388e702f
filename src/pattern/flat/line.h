/* line.h -- splines of degree 5 on uniform clamped knots over [0, 1], and their values at the Gauss points of all spans. */
#ifndef TAUT_PATTERN_LINE_H
#define TAUT_PATTERN_LINE_H

#include "pattern/flat/flat.h"

enum { TAUT_FLAT_LOCAL = TAUT_FLAT_DEGREE + 1 /* functions alive on a span */ };

typedef struct taut_flat_line {
    int spans, count;
    /* of the functions alive, their slopes, and those of one degree less: [spans] */
    double (*value)[TAUT_FLAT_GAUSS][TAUT_FLAT_LOCAL], (*slope)[TAUT_FLAT_GAUSS][TAUT_FLAT_LOCAL],
        (*test)[TAUT_FLAT_GAUSS][TAUT_FLAT_LOCAL];
    double (*at)[TAUT_FLAT_GAUSS], weight[TAUT_FLAT_GAUSS];
} taut_flat_line;

/* In the arena; 0 where there is no memory. */
int taut_flat_line_fill(taut_arena *arena, int spans, taut_flat_line *line);
/* Knot k of spans + 2 * 5 + 1, counted from the first of the left end's. */
double taut_flat_knot(int spans, int k);
int taut_flat_span(int spans, double x);
/* The degree + 1 functions alive on a span, and their slopes or NULL, by the recursion of de Boor; degree at most 5. */
void taut_flat_basis(int spans, int degree, int span, double x, double *value, double *slope);

#endif /* TAUT_PATTERN_LINE_H */
