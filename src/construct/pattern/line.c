#include "construct/pattern/line.h"

#include "geometry/keep.h"

#include <string.h>

enum { P = 5 };

/* The spline of these points, in the arena. */
static taut_status keep(size_t knot_count, const double *knots, size_t count, const double *points,
                        taut_arena *arena, const taut_curve **curve)
{
    const taut_basis_spec spec = {
        .type = "bspline", .degree = P, .knot_count = (int)knot_count, .knots = knots};
    taut_basis *basis = NULL;
    taut_curve *made = NULL;
    taut_status status = taut_basis_new(&spec, (int)count, &basis, NULL);
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, points, NULL, &made, NULL);
    }
    taut_basis_free(basis);
    *curve = made;
    return status == TAUT_OK && taut_keep_curve(arena, made) ? TAUT_OK : TAUT_NO_MEMORY;
}

taut_status taut_pattern_quintics(int spans, const taut_pattern_station *at, taut_arena *arena,
                                  const taut_curve **curve)
{
    const size_t count = 3 * (size_t)spans + 3;
    double *points = taut_arena_take(arena, count, 3 * sizeof(double));
    double *knots = taut_arena_take(arena, count + P + 1, sizeof(double));

    if (points == NULL || knots == NULL) {
        return TAUT_NO_MEMORY;
    }
    /* by blossoms: before and after a station the points next to it are those of its own Taylor polynomial */
    for (int k = 0; k <= spans; k++) {
        const double a = k > 0 ? at[k].x - at[k - 1].x : 0,
                     b = k < spans ? at[k + 1].x - at[k].x : 0; /* the steps before and after */
        double(*p)[3] = (double(*)[3])(points + 9 * (size_t)k);
        for (int d = 0; d < 2; d++) {
            const double y = at[k].y[0][d], v = at[k].y[1][d], w = at[k].y[2][d];
            p[0][d] = y - 2 * a / 5 * v + a * a / 20 * w;
            p[1][d] = y + (b - a) / 5 * v - a * b / 20 * w;
            p[2][d] = y + 2 * b / 5 * v + b * b / 20 * w;
        }
    }
    size_t n = 0;
    for (int k = 0; k <= spans; k++) {
        const int times = k == 0 || k == spans ? P + 1 : 3;
        for (int m = 0; m < times; m++) {
            knots[n++] = at[k].x;
        }
    }
    return keep(n, knots, count, points, arena, curve);
}

taut_status taut_pattern_straight(const double from[2], const double to[2], taut_arena *arena,
                                  const taut_curve **curve)
{
    const double knots[2 * (P + 1)] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    double points[P + 1][3];
    for (int k = 0; k <= P; k++) {
        for (int d = 0; d < 2; d++) {
            points[k][d] = k == P ? to[d] : from[d] + (to[d] - from[d]) * k / P;
        }
        points[k][2] = 0;
    }
    return keep(sizeof knots / sizeof knots[0], knots, P + 1, points[0], arena, curve);
}

taut_status taut_pattern_join(int count, const taut_pattern_part *parts, taut_arena *arena,
                              const taut_curve **whole)
{
    size_t most = 0, n = 0, size = 0;
    for (int e = 0; e < count; e++) {
        taut_basis_spec spec;
        taut_basis_spec_of(taut_curve_t(parts[e].curve), &spec);
        most += (size_t)spec.knot_count;
    }
    double *knots = taut_arena_take(arena, most, sizeof(double));
    double *points = taut_arena_take(arena, most, 3 * sizeof(double));
    if (knots == NULL || points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int e = 0; e < count; e++) {
        const taut_pattern_part *part = &parts[e];
        const double range = part->end - part->begin;
        const int own = taut_basis_count(taut_curve_t(part->curve));
        const double *from = taut_curve_points(part->curve);
        taut_basis_spec spec;
        taut_basis_spec_of(taut_curve_t(part->curve), &spec);
        const int last = spec.knot_count - 1;
        for (int k = e == 0 ? 0 : P + 1; k <= last - (e < count - 1); k++) {
            const double x = part->is_back ? 1 - spec.knots[last - k] : spec.knots[k];
            knots[n++] = x < 1 ? part->begin + range * x : part->end;
        }
        for (int k = e == 0 ? 0 : 1; k < own; k++) {
            memcpy(points + 3 * size++, from + 3 * (part->is_back ? own - 1 - k : k),
                   3 * sizeof(double));
        }
    }
    memcpy(points + 3 * (size - 1), points, 3 * sizeof(double));
    return keep(n, knots, size, points, arena, whole);
}
