/* film_curves_cut.h -- a boundary of curves, cut into polygons whose corners a centre can be joined up with. */
#ifndef TAUT_IO_PROBLEM_FILM_CURVES_CUT_H
#define TAUT_IO_PROBLEM_FILM_CURVES_CUT_H

#include "taut/curve.h"

enum {
    TAUT_FILM_CURVES_MAX = 12,
    TAUT_FILM_POLYGONS_MAX = 3 * TAUT_FILM_CURVES_MAX, /* triangles, of all polygons of three */
    TAUT_FILM_LINES_MAX = 4 * TAUT_FILM_CURVES_MAX,
    TAUT_FILM_CENTRE = -1 /* the corner of a triangle that is no corner of the boundary */
};

/* Side k runs from corner k to the next. */
typedef struct taut_film_polygon {
    int count;
    int corners[TAUT_FILM_CURVES_MAX]; /* corner c is where curve c begins */
    int sides[TAUT_FILM_CURVES_MAX];   /* c: curve c; -1 - l: line l */
} taut_film_polygon;

typedef struct taut_film_cut {
    int polygon_count, line_count, patch_count; /* patches: one at each corner of each polygon */
    taut_film_polygon polygons[TAUT_FILM_POLYGONS_MAX];
    int from[TAUT_FILM_LINES_MAX]; /* of a line, the corner of its first end */
} taut_film_cut;

/* Curves that go round, each from where the one before it ends. A corner of more than 155 degrees is an open one.
 *
 *     more than half of all corners are open          triangles about the centre
 *     some are, or there are more than six sides      two polygons, cut by a line from corner to corner
 *     else, and where no line is good enough          itself, with open corners triangles about the centre
 *
 * and so on with the polygons. Of all lines, or where there are no more than six sides, of those from an open corner, it is the one
 * whose smallest angle with the boundary is the largest, where that is above 20 degrees; of lines out of the plane of a corner, what
 * both their angles are more than that of the corner is taken off. No more than `patches_most` patches are made of triangles. */
void taut_film_curves_cut(int count, const taut_curve *const *curves, int patches_most,
                          taut_film_cut *cut);

#endif /* TAUT_IO_PROBLEM_FILM_CURVES_CUT_H */
