/* chart.h -- a piece of a surface between four edges, as a map of (s, t) in [0, 1]^2:
 *
 *     (u, v) = (1 - t) right(s) + t left(s) + (1 - s) (start(t) - its chord) + s (end(t) - its chord)
 *
 * and where it and its derivatives are over a part of that square.
 */
#ifndef TAUT_GEOMETRY_CHART_CHART_H
#define TAUT_GEOMETRY_CHART_CHART_H

#include "geometry/chart/enclose.h"

/* Edges counter-clockwise: right (t = 0), end (s = 1), left, start. */
enum { TAUT_CHART_RIGHT = 0, TAUT_CHART_END, TAUT_CHART_LEFT, TAUT_CHART_START, TAUT_CHART_EDGES };

typedef struct taut_chart {
    const taut_surface *surface;
    const taut_curve
        *edges[TAUT_CHART_EDGES]; /* of the window, points (u, v, 0); start or end NULL: straight */
    double part[TAUT_CHART_EDGES][2]; /* shares of the curve's range, as s or t grows */
    int kept
        [2]; /* 1 + the coordinate in which start, or end, is what it is all along the piece; 0: none */
} taut_chart;

/* s, t, from and to. */
typedef struct taut_chart_part {
    double from[2], to[2];
} taut_chart_part;

/* Of the window: w, w_s, w_t, w_ss, w_st, w_tt. 0: not known. */
int taut_chart_window(const taut_chart *chart, const taut_chart_part *part, taut_range w[6][2]);
/* X, X_s, X_t, X_ss, X_st, X_tt along the rows of a frame, or NULL (enclose.h). */
int taut_chart_enclose(const taut_chart *chart, const taut_chart_part *part,
                       const double frame[3][3], taut_range x[6][3]);
/* Are its derivatives continuous, so that they change by no more than second derivatives let them? */
int taut_chart_is_smooth(const taut_chart *chart);
int taut_basis_is_smooth(const taut_basis *basis);
/* The place in space, and X_s, X_t there. 0: there is none. */
int taut_chart_at(const taut_chart *chart, double s, double t, double x[3][3]);

#endif /* TAUT_GEOMETRY_CHART_CHART_H */
