/* pole.c
 *
 *     the place at a distance   int |X_v| dv from the pole on, by Gauss' rule on parts of spans and Newton's method
 *     the circle                a parameter line where it is one; else quintics through six places each of ever more parts of spans
 *     the turn                  int |X_uv x X_v| / |X_v|^2 du at the pole, as X_u = (v - pole) X_uv nearby
 */
#include "construct/pattern/pole.h"

#include "construct/pattern/trail.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { NODES = 10, PARTS = 4, ROUNDS = 30, DEGREE = 5, FEWEST = 4, MOST = 64, LOOK = 16 };
/* Of the window: places that are one, and quintics from the circle. */
static const double same_place = 1e-13, off_wanted = 1e-12;

static void surface_at(const taut_pattern_ground *ground, const double at[2], int order,
                       double x[TAUT_CARRIER_VECTORS][3])
{
    int span[2];
    taut_carrier_cell(ground->carrier, at, NULL, span);
    taut_carrier_at(ground->carrier, span, at, order, x);
}

/* |X_v| on the line where the other coordinate is `value`, v a border's own. */
static double speed_at(const taut_pattern_ground *ground, int held, double value, double v)
{
    double at[2], x[TAUT_CARRIER_VECTORS][3];
    at[held] = v;
    at[1 - held] = value;
    surface_at(ground, at, 1, x);
    return taut_norm(x[1 + held]);
}

static double length_between(const taut_pattern_ground *ground, int held, double value, double a,
                             double b)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int q = 0; q < NODES; q++) {
        sum += weights[q] / 2 * speed_at(ground, held, value, a + (b - a) * (1 + nodes[q]) / 2);
    }
    return sum * fabs(b - a);
}

/* Where a line from a pole is so long; NAN: nowhere. *whole: all of it, or as much as was looked at. */
static double walk(const taut_pattern_ground *ground, int pole, double value, double distance,
                   double *whole)
{
    const int held = pole / 2, is_back = pole % 2;
    const taut_basis *basis = ground->carrier->basis[held];
    const double *breaks = taut_basis_breaks(basis);
    const int count = taut_basis_span_count(basis) * PARTS;

    *whole = 0;
    for (int k = 0; k < count; k++) {
        const int cell = is_back ? count - 1 - k : k, span = cell / PARTS;
        const double range = breaks[span + 1] - breaks[span];
        const double low = breaks[span] + range * (cell % PARTS) / PARTS;
        const double high = cell % PARTS == PARTS - 1 ? breaks[span + 1] : low + range / PARTS;
        const double a = is_back ? high : low, b = is_back ? low : high;
        const double part = length_between(ground, held, value, a, b);
        if (*whole + part < distance) {
            *whole += part;
            continue;
        }
        double v = a + (b - a) * (distance - *whole) / part;
        for (int round = 0; round < ROUNDS; round++) {
            const double missing = distance - *whole - length_between(ground, held, value, a, v);
            const double step = missing / speed_at(ground, held, value, v) * (is_back ? -1 : 1);
            v = fmin(fmax(v + step, low), high);
            if (!(fabs(step) > same_place * range)) {
                break;
            }
        }
        return v;
    }
    return (double)NAN;
}

double taut_pattern_pole_reach(const taut_pattern_ground *ground, int pole)
{
    const int along = 1 - pole / 2;
    const double lo = ground->carrier->lo[along], hi = ground->carrier->hi[along];
    double least = INFINITY;
    for (int k = 0; k <= LOOK; k++) {
        double whole;
        walk(ground, pole, k < LOOK ? lo + (hi - lo) * k / LOOK : hi, INFINITY, &whole);
        least = fmin(least, whole);
    }
    return least;
}

/* Bezier coefficients of the quintic through values at equal steps, by elimination: the matrix is totally positive. */
static void through(const double values[DEGREE + 1], double points[DEGREE + 1])
{
    static const double choose[DEGREE + 1] = {1, 5, 10, 10, 5, 1};
    double a[DEGREE + 1][DEGREE + 1];
    for (int i = 0; i <= DEGREE; i++) {
        const double t = (double)i / DEGREE;
        for (int k = 0; k <= DEGREE; k++) {
            a[i][k] = choose[k];
            for (int p = 0; p < DEGREE; p++) {
                a[i][k] *= p < k ? t : 1 - t;
            }
        }
        points[i] = values[i];
    }
    for (int i = 0; i <= DEGREE; i++) {
        for (int k = i + 1; k <= DEGREE; k++) {
            const double share = a[k][i] / a[i][i];
            for (int c = i; c <= DEGREE; c++) {
                a[k][c] -= share * a[i][c];
            }
            points[k] -= share * points[i];
        }
    }
    for (int i = DEGREE; i >= 0; i--) {
        for (int c = i + 1; c <= DEGREE; c++) {
            points[i] -= a[i][c] * points[c];
        }
        points[i] /= a[i][i];
    }
}

static double middle_of(const double points[DEGREE + 1])
{
    return (points[0] + 5 * points[1] + 10 * points[2] + 10 * points[3] + 5 * points[4] +
            points[5]) /
           32;
}

/* Quintics over `parts` parts of each span, points (u, v, 0); how far they are off halfway. NAN: the circle leaves the window. */
static double fill(const taut_pattern_ground *ground, int pole, double distance, int parts,
                   double *knots, double *points)
{
    const int held = pole / 2, along = 1 - held;
    const double *breaks = taut_basis_breaks(ground->carrier->basis[along]);
    const int count = parts * taut_basis_span_count(ground->carrier->basis[along]);
    double off = 0, whole;

    for (int k = 0; k < count; k++) {
        const int span = k / parts;
        const double range = breaks[span + 1] - breaks[span];
        const double a = breaks[span] + range * (k % parts) / parts;
        const double b = k % parts == parts - 1 ? breaks[span + 1] : a + range / parts;
        double values[DEGREE + 1], own[DEGREE + 1];
        for (int i = 0; i <= DEGREE; i++) {
            values[i] =
                walk(ground, pole, i < DEGREE ? a + (b - a) * i / DEGREE : b, distance, &whole);
        }
        through(values, own);
        const double middle = walk(ground, pole, (a + b) / 2, distance, &whole);
        off = isfinite(middle) ? fmax(off, fabs(middle - middle_of(own))) : (double)NAN;
        for (int i = 0; i <= DEGREE; i++) {
            double *at = points + 3 * (DEGREE * k + i);
            at[held] = i == 0 || i == DEGREE ? values[i] : own[i];
            at[along] = i < DEGREE ? a + (b - a) * i / DEGREE : b;
            at[2] = 0;
        }
        for (int i = 1; i <= DEGREE; i++) {
            knots[DEGREE * k + i] = a;
            knots[DEGREE * (k + 1) + i] = b;
        }
    }
    knots[0] = breaks[0];
    knots[DEGREE * (count + 1) + 1] = breaks[taut_basis_span_count(ground->carrier->basis[along])];
    return off;
}

/* One parameter all along? */
static int is_line(const taut_pattern_ground *ground, int pole, size_t count, const double *points)
{
    const int held = pole / 2;
    const double range = ground->carrier->hi[held] - ground->carrier->lo[held];
    int all = 1;
    for (size_t k = 0; k < count; k++) {
        all &= fabs(points[3 * k + (size_t)held] - points[held]) <= off_wanted * range;
    }
    return all;
}

taut_status taut_pattern_pole_circle(const taut_pattern_ground *ground, int pole, double distance,
                                     int backwards, const char *where, taut_pattern_side *side,
                                     taut_error *error)
{
    const int held = pole / 2, along = 1 - held;
    const size_t spans = (size_t)taut_basis_span_count(ground->carrier->basis[along]);
    const size_t room = DEGREE * spans * MOST + DEGREE + 1;
    const double range = ground->carrier->hi[held] - ground->carrier->lo[held];
    double *knots = taut_arena_take(ground->arena, room + DEGREE + 1, sizeof *knots);
    double *points = taut_arena_take(ground->arena, room, 3 * sizeof *points);
    taut_pattern_trail trail = {.name = "circle", .is_window = 1, .is_back = backwards, .held = -1};
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;
    size_t count = 0;
    double off = INFINITY;

    if (knots == NULL || points == NULL) {
        return taut_fail_memory(error);
    }
    for (int parts = FEWEST; parts <= MOST && off > off_wanted * range; parts *= 2) {
        off = fill(ground, pole, distance, parts, knots, points);
        count = DEGREE * spans * (size_t)parts + 1;
    }
    if (!(off <= off_wanted * range)) {
        return taut_fail(error, TAUT_BAD_INPUT, "curve", where, off / range, off_wanted,
                         "found a circle around the pole that is too uneven over the window's "
                         "parameters, off by %.3g, expected %.3g",
                         off / range, off_wanted);
    }
    if (is_line(ground, pole, count, points)) {
        const taut_status status =
            taut_pattern_parameter_line(ground->carrier, held, points[held], backwards,
                                        ground->monitor, ground->arena, side, error);
        side->kind = TAUT_SIDE_CIRCLE;
        return status;
    }
    const taut_basis_spec spec = {
        .type = "bspline", .degree = DEGREE, .knot_count = (int)count + DEGREE + 1, .knots = knots};
    taut_status status = taut_basis_new(&spec, (int)count, &basis, error);
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, points, NULL, &curve, error);
    }
    taut_basis_free(basis);
    if (status == TAUT_OK && !taut_keep_curve(ground->arena, curve)) {
        status = taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    trail.curve = curve;
    trail.lo = knots[0];
    trail.hi = knots[count + DEGREE];
    for (int end = 0; end < 2; end++) {
        memcpy(side->ends[end], points + (end == backwards ? 0 : 3 * (count - 1)),
               sizeof side->ends[end]);
    }
    side->kind = TAUT_SIDE_CIRCLE;
    return taut_pattern_trail_side(ground, &trail, where, side, error);
}

void taut_pattern_circle_at(const taut_pattern_side *circle, int along, double value, double at[2])
{
    enum { HALVINGS = 200 };
    const int is_back = circle->ends[0][along] > circle->ends[1][along];
    double range[2] = {0, 1}, w[3][2];
    for (int round = 0; round < HALVINGS; round++) { /* monotonous */
        const double middle = (range[0] + range[1]) / 2;
        if (middle == range[0] || middle == range[1]) {
            break;
        }
        taut_pattern_side_at(circle, middle, w);
        range[(w[0][along] > value) != is_back] = middle;
    }
    taut_pattern_side_at(circle, (range[0] + range[1]) / 2, w);
    at[along] = value;
    at[1 - along] = w[0][1 - along];
}

double taut_pattern_pole_turn(const taut_pattern_ground *ground, int pole)
{
    const int held = pole / 2, along = 1 - held;
    const double *breaks = taut_basis_breaks(ground->carrier->basis[along]);
    const int spans = taut_basis_span_count(ground->carrier->basis[along]);
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < spans * NODES; k++) {
        const int span = k / NODES;
        const double range = breaks[span + 1] - breaks[span];
        double at[2], x[TAUT_CARRIER_VECTORS][3], turning[3];
        at[held] = pole % 2 == 0 ? ground->carrier->lo[held] : ground->carrier->hi[held];
        at[along] = breaks[span] + range * (1 + nodes[k % NODES]) / 2;
        surface_at(ground, at, 2, x);
        taut_cross(x[4], x[1 + held], turning);
        sum += weights[k % NODES] * range / 2 * taut_norm(turning) /
               taut_dot(x[1 + held], x[1 + held]);
    }
    return sum;
}
