/* touching.h -- circles that touch a curve in one point and pass through another of its points: the
 * least of their radii over all pairs is its global radius of curvature ([GonzalezMaddocks1999]).
 */
#ifndef TAUT_TEST_TOUCHING_H
#define TAUT_TEST_TOUCHING_H

/* A point, the first and the second derivative there. */
typedef double touching_jet[3][3];

/* |x - y|^2 / (2 dist(y, tangent line at x)); INFINITY where y is on the line. */
double touching_radius(const touching_jet x, const double y[3]);
double touching_curvature_radius(const touching_jet x);

/* The few best pairs of a grid. */
enum { TOUCHING_KEPT_MOST = 4 };
typedef struct touching_kept {
    int most, count; /* most <= TOUCHING_KEPT_MOST; begin with count 0 */
    double values[TOUCHING_KEPT_MOST], at[TOUCHING_KEPT_MOST][2];
} touching_kept;
/* Keeps the pair if it is among the best and finite. */
void touching_keep(touching_kept *kept, double value, const double at[2]);

/* The least value near a start in [0, 1]^2: steps along the axes and diagonals, halved where none
 * goes down, until they are shorter than `shortest`. */
typedef double touching_pair(const void *context, const double t[2]);
double touching_descend(touching_pair *value, const void *context, const double start[2],
                        double step, double shortest);

/* The least value on [lo, hi], where there is one minimum. */
typedef double touching_point(const void *context, double t);
double touching_least(touching_point *value, const void *context, double lo, double hi);

#endif /* TAUT_TEST_TOUCHING_H */
