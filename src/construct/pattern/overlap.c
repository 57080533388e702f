#include "construct/pattern/overlap.h"

#include <math.h>
#include <string.h>

enum { CHORDS = 2 };
/* Places that are one, over the piece's extent. */
static const double one_place = 1e-12;

/* Twice the area of a triangle, above 0 where it runs counter-clockwise. */
static double twice_area(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static int do_cross(const double a[2], const double b[2], const double c[2], const double d[2])
{
    for (int k = 0; k < 2; k++) { /* most are far from each other */
        if (fmax(a[k], b[k]) < fmin(c[k], d[k]) || fmax(c[k], d[k]) < fmin(a[k], b[k])) {
            return 0;
        }
    }
    return twice_area(a, b, c) * twice_area(a, b, d) < 0 &&
           twice_area(c, d, a) * twice_area(c, d, b) < 0;
}

taut_status taut_pattern_overlap(const taut_pattern_outline *outline, taut_arena *arena,
                                 int *is_crossed, double at[2])
{
    const taut_basis *basis = taut_curve_t(outline->cut);
    const double *breaks = taut_basis_breaks(basis);
    const int places = taut_basis_span_count(basis) * CHORDS;
    const double least =
        one_place * fmax(outline->high[0] - outline->low[0], outline->high[1] - outline->low[1]);
    int count = 0;
    double(*points)[2] = taut_arena_take(arena, (size_t)places, sizeof *points);

    *is_crossed = 0;
    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < places; k++) {
        const int i = k / CHORDS;
        const double t = breaks[i] + (breaks[i + 1] - breaks[i]) * (k % CHORDS) / CHORDS;
        double y[3];
        taut_curve_eval(outline->cut, t, 0, y);
        if (count == 0 || fabs(y[0] - points[count - 1][0]) > least ||
            fabs(y[1] - points[count - 1][1]) > least) { /* a tip is one of them */
            memcpy(points[count++], y, sizeof points[0]);
        }
    }
    if (count > 1 && fabs(points[count - 1][0] - points[0][0]) <= least &&
        fabs(points[count - 1][1] - points[0][1]) <= least) {
        count--;
    }
    for (int i = 0; i < count && !*is_crossed; i++) {
        for (int k = i + 2; k < count && !*is_crossed; k++) {
            if ((i > 0 || k < count - 1) &&
                do_cross(points[i], points[i + 1], points[k], points[(k + 1) % count])) {
                *is_crossed = 1;
                memcpy(at, points[i], sizeof points[i]);
            }
        }
    }
    return TAUT_OK;
}
