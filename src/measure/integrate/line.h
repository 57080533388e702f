/* line.h -- curves as they are measured: free ones and edges of surfaces alike.
 *
 * Points are scaled to size 1 and parameters to a range of about 1, by powers of two, and taken
 * relative to the first point.
 */
#ifndef TAUT_MEASURE_INTEGRATE_LINE_H
#define TAUT_MEASURE_INTEGRATE_LINE_H

#include "measure/integrate/parameters.h"
#include "taut/curve.h"
#include "taut/surface.h"

typedef struct taut_line {
    const taut_basis *basis; /* borrowed */
    int dim;                 /* 3, or 4: homogeneous */
    const double *net;       /* [count][dim] */
    int scale, shift;        /* points were divided by 2^scale, parameters by 2^shift */
} taut_line;

/* In the arena. The curve or surface must outlive the line. TAUT_NO_MEMORY. */
taut_status taut_line_of_curve(taut_arena *arena, const taut_curve *curve, taut_line *line);
taut_status taut_line_of_edge(taut_arena *arena, const taut_surface *surface, int edge,
                              taut_line *line);

/* d[k][3], k = 0..order: position and derivatives (scaled) at t + rest, t in the closed span, rest
 * a rounding error of it. bound[k], if not NULL: how large derivative k could be for the part of
 * the net alive there. */
void taut_line_eval(const taut_line *line, int span, double t, double rest, int order, double *d,
                    double *bound);

/* In the unit of the points; good to 1e-12 relative. TAUT_NO_MEMORY. */
taut_status taut_line_length(const taut_line *line, double *length);

/* At one parameter, scaled. */
typedef struct taut_bend {
    double d[4][3];     /* position, x', x'', x''' */
    double binormal[3]; /* x' x x'' */
    double speed;       /* |x'| */
    double curvature;   /* |x' x x''| / |x'|^3; NaN where x' = 0 */
    double trust;       /* curvature that rounding alone may make */
} taut_bend;

void taut_line_bend(const taut_line *line, int span, double t, int order, taut_bend *bend);

/* The largest curvature over the entries of a grid, scaled; NaN where undefined everywhere. */
double taut_line_curvature(const taut_line *line, const taut_parameters *lines);

/* Is the curve as good as straight here, so that its osculating plane means nothing? `largest` is
 * the largest curvature, `length` the length, both scaled. A binormal comes with an error of
 * about eps / (curvature * length): 2^-26, the root of eps, leaves it eight digits. On long splines
 * the second derivative carries more noise than that: five digits are asked of it. */
int taut_bend_is_straight(const taut_bend *bend, double largest, double length);

#endif /* TAUT_MEASURE_INTEGRATE_LINE_H */
