/* geometry.c -- B-splines of ISO 10303-42, with the numbers that the model has. */
#include "geometry/exponent.h"
#include "io/step/entities.h"

#include <string.h>

/* One direction, or a piece of it: degree, points and knots, clamped; each end is there once more than in
 * knots, so that those of a piece are a part of the whole's. */
typedef struct direction {
    int degree;
    size_t first, count, knot_count;
    const double *knots;
} direction;

static direction direction_of(const taut_basis *basis, const taut_step_range *range)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    const size_t count = (size_t)(range->to - range->from) + 1;
    return (direction){spec.degree, (size_t)range->from, count, count + (size_t)spec.degree - 1,
                       spec.knots + range->from + 1};
}

static size_t put_points(taut_part21 *out, size_t count, const double *points)
{
    const size_t first = out->count + 1;
    for (size_t i = 0; i < count; i++) {
        TAUT_NEW(out, "CARTESIAN_POINT('',%)", TAUT_REALS(3, points + 3 * i, 1));
    }
    return first;
}

/* Are `count` points, `step` apart, each the same as the one `across` further? */
static int are_equal(const double *points, size_t count, size_t step, size_t across)
{
    for (size_t i = 0; i < count; i++) {
        if (memcmp(points + 3 * i * step, points + 3 * (i * step + across), 3 * sizeof *points) !=
            0) {
            return 0;
        }
    }
    return 1;
}

size_t taut_step_put_net(taut_part21 *out, const taut_surface *surface)
{
    return put_points(out, taut_point_count(surface), taut_surface_points(surface));
}

size_t taut_step_put_surface(taut_part21 *out, const taut_surface *surface, size_t points,
                             const taut_step_range ranges[2])
{
    const direction u = direction_of(taut_surface_u(surface), &ranges[0]);
    const direction v = direction_of(taut_surface_v(surface), &ranges[1]);
    const size_t row = (size_t)taut_basis_count(taut_surface_v(surface));
    const size_t first = u.first * row + v.first;
    const double *net = taut_surface_points(surface) + 3 * first;
    const double *weights = taut_surface_weights(surface);
    const int closed_u = are_equal(net, v.count, 1, (u.count - 1) * row);
    const int closed_v = are_equal(net, u.count, row, v.count - 1);
    const taut_part21_value grid = {.kind = PART21_GRID,
                                    .ref = points + first,
                                    .count = u.count,
                                    .across = v.count,
                                    .step = row};
    if (weights == NULL) {
        return TAUT_NEW(out,
                        "B_SPLINE_SURFACE_WITH_KNOTS('',%,%,%,.UNSPECIFIED.,%,%,.U.,%,%,%,%,"
                        ".UNSPECIFIED.)",
                        TAUT_NUMBER(u.degree), TAUT_NUMBER(v.degree), grid, TAUT_TRUTH(closed_u),
                        TAUT_TRUTH(closed_v), TAUT_TIMES(u.knot_count, u.knots),
                        TAUT_TIMES(v.knot_count, v.knots), TAUT_KNOTS(u.knot_count, u.knots),
                        TAUT_KNOTS(v.knot_count, v.knots));
    }
    const taut_part21_value table = {.kind = PART21_TABLE,
                                     .reals = weights + first,
                                     .count = u.count,
                                     .across = v.count,
                                     .step = row};
    return TAUT_NEW(out,
                    "(BOUNDED_SURFACE()B_SPLINE_SURFACE(%,%,%,.UNSPECIFIED.,%,%,.U.)"
                    "\nB_SPLINE_SURFACE_WITH_KNOTS(%,%,%,%,.UNSPECIFIED.)"
                    "\nGEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(%)"
                    "REPRESENTATION_ITEM('')SURFACE())",
                    TAUT_NUMBER(u.degree), TAUT_NUMBER(v.degree), grid, TAUT_TRUTH(closed_u),
                    TAUT_TRUTH(closed_v), TAUT_TIMES(u.knot_count, u.knots),
                    TAUT_TIMES(v.knot_count, v.knots), TAUT_KNOTS(u.knot_count, u.knots),
                    TAUT_KNOTS(v.knot_count, v.knots), table);
}

/* A curve on a run of points, with every step-th weight. */
static size_t put_spline(taut_part21 *out, const char *name, const direction *t,
                         taut_part21_value run, int closed, const double *weights, size_t step)
{
    if (weights == NULL) {
        return TAUT_NEW(out,
                        "B_SPLINE_CURVE_WITH_KNOTS(%,%,%,.UNSPECIFIED.,%,.U.,%,%,.UNSPECIFIED.)",
                        TAUT_TEXT(name), TAUT_NUMBER(t->degree), run, TAUT_TRUTH(closed),
                        TAUT_TIMES(t->knot_count, t->knots), TAUT_KNOTS(t->knot_count, t->knots));
    }
    return TAUT_NEW(out,
                    "(BOUNDED_CURVE()B_SPLINE_CURVE(%,%,.UNSPECIFIED.,%,.U.)"
                    "\nB_SPLINE_CURVE_WITH_KNOTS(%,%,.UNSPECIFIED.)CURVE()"
                    "\nGEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(%)"
                    "REPRESENTATION_ITEM(%))",
                    TAUT_NUMBER(t->degree), run, TAUT_TRUTH(closed),
                    TAUT_TIMES(t->knot_count, t->knots), TAUT_KNOTS(t->knot_count, t->knots),
                    TAUT_REALS(t->count, weights, step), TAUT_TEXT(name));
}

size_t taut_step_put_curve(taut_part21 *out, const taut_curve *curve)
{
    const taut_step_range whole = {0, taut_basis_count(taut_curve_t(curve)) - 1};
    const direction t = direction_of(taut_curve_t(curve), &whole);
    const double *points = taut_curve_points(curve);
    const taut_part21_value run = {
        .kind = PART21_RUN, .ref = put_points(out, t.count, points), .step = 1, .count = t.count};
    return put_spline(out, taut_curve_name(curve), &t, run, are_equal(points, 1, 1, t.count - 1),
                      taut_curve_weights(curve), 1);
}

size_t taut_step_put_row(taut_part21 *out, const taut_surface *surface, size_t points,
                         const taut_step_row *row)
{
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    const direction t = direction_of(
        row->along == 0 ? taut_surface_u(surface) : taut_surface_v(surface), &row->range);
    const size_t step = row->along == 0 ? nv : 1;
    const size_t first = (size_t)row->line * (row->along == 0 ? 1 : nv) + t.first * step;
    const double *weights = taut_surface_weights(surface), *net = taut_surface_points(surface);
    const int closed = are_equal(net + 3 * first, 1, 1, (t.count - 1) * step);
    const size_t own = out->count + 1;
    for (size_t i = 0; points == 0 && i < t.count; i++) {
        TAUT_NEW(out, "CARTESIAN_POINT('',%)", TAUT_REALS(3, net + 3 * (first + i * step), 1));
    }
    const taut_part21_value run = {.kind = PART21_RUN,
                                   .ref = points == 0 ? own : points + first,
                                   .step = points == 0 ? 1 : step,
                                   .count = t.count};
    return put_spline(out, "", &t, run, closed, weights != NULL ? weights + first : NULL, step);
}
