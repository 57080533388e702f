#include "construct/pattern/trail.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "geometry/stretch.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <string.h>

enum { GRID = 24, ROUNDS = 30, NODES = 8, FEWEST = 4, MOST = 128 /* pieces of a span */ };
/* Of the size: from the surface, and of quintics from the curve; and where they do not come near, a corner. */
static const double away_most = 1e-9, off_wanted = 4e-13, off_most = 1e-10;
/* A step of Newton's over the window that is rounding. */
static const double settled = 1e-15;

/* ---- the curve ---- */

static taut_status fail_curve(const char *name, const char *where, const char *what,
                              taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "curve", where, taut_none, taut_none,
                     "found the curve \"%.60s\", %s", name, what);
}

/* The only item of details.domain of that name, as a spline of points (u, v, 0), or NULL. */
static taut_status curve_in_window(const taut_pattern_ground *ground, const char *name,
                                   const taut_curve **curve)
{
    const taut_record *domain = taut_record_get(taut_model_details(ground->model), "domain");
    const taut_record *found = NULL;
    int times = 0;
    for (size_t k = 0; k < taut_record_count(domain); k++) {
        const taut_record *one = taut_record_at(domain, k);
        if (strcmp(taut_record_text(taut_record_get(one, "name")), name) == 0) {
            found = one;
            times++;
        }
    }
    if (times != 1) {
        return TAUT_OK;
    }
    taut_curve *made = NULL;
    const taut_status status = taut_stretch_read(found, ground->arena, &made);
    *curve = made;
    return status;
}

static const taut_curve *curve_in_space(const taut_model *model, const char *name)
{
    for (int k = 0; k < taut_model_curve_count(model); k++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, k)), name) == 0) {
            return taut_model_curve(model, k);
        }
    }
    return NULL;
}

/* ---- places ---- */

/* A place of the curve with first and second derivatives over its parameter, in the window and in space. */
typedef struct spot {
    double w[3][2], x[3][3];
} spot;

static void surface_at(const taut_carrier *carrier, const double at[2], int order,
                       double x[TAUT_CARRIER_VECTORS][3])
{
    int span[2];
    taut_carrier_cell(carrier, at, NULL, span);
    taut_carrier_at(carrier, span, at, order, x);
}

/* The place of the surface that is nearest to a point, from a guess on; how far it is. */
static double project(const taut_carrier *carrier, const double point[3], double at[2])
{
    double x[TAUT_CARRIER_VECTORS][3], gap[3];
    for (int round = 0; round < ROUNDS; round++) {
        surface_at(carrier, at, 1, x);
        taut_difference(point, x[0], gap);
        const double e = taut_dot(x[1], x[1]), f = taut_dot(x[1], x[2]), g = taut_dot(x[2], x[2]);
        const double p = taut_dot(x[1], gap), q = taut_dot(x[2], gap), area = e * g - f * f;
        const double step[2] = {(g * p - f * q) / area, (e * q - f * p) / area};
        if (!isfinite(step[0]) || !isfinite(step[1])) {
            break;
        }
        double most = 0;
        for (int d = 0; d < 2; d++) {
            const double before = at[d];
            at[d] = fmin(fmax(at[d] + step[d], carrier->lo[d]), carrier->hi[d]);
            most = fmax(most, fabs(at[d] - before) / (carrier->hi[d] - carrier->lo[d]));
        }
        if (!(most > settled)) {
            break;
        }
    }
    surface_at(carrier, at, 0, x);
    return taut_length_between(point, x[0]);
}

/* The curve's point and its derivatives, as the carrier has them. */
static void point_at(const taut_carrier *carrier, const taut_curve *curve, double t, int order,
                     double c[3][3])
{
    taut_curve_eval(curve, t, order, c[0]);
    for (int k = 0; k <= order; k++) {
        for (int d = 0; d < 3; d++) {
            c[k][d] = ldexp(c[k][d] - (k == 0 ? carrier->origin[d] : 0), -carrier->scale);
        }
    }
}

/* a and b of X_u a + X_v b = c, as nearly as can be. */
static void solve(const double x[TAUT_CARRIER_VECTORS][3], const double c[3], double out[2])
{
    const double e = taut_dot(x[1], x[1]), f = taut_dot(x[1], x[2]), g = taut_dot(x[2], x[2]);
    const double p = taut_dot(x[1], c), q = taut_dot(x[2], c), area = e * g - f * f;
    out[0] = (g * p - f * q) / area;
    out[1] = (e * q - f * p) / area;
}

/* X_uu a^2 + 2 X_uv ab + X_vv b^2 */
static void bend_of(const double x[TAUT_CARRIER_VECTORS][3], const double a[2], double out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = x[3][c] * a[0] * a[0] + 2 * x[4][c] * a[0] * a[1] + x[5][c] * a[1] * a[1];
    }
}

/* At the share q of the way along it. How far the curve is from the surface there. */
static double look_at(const taut_pattern_ground *ground, const taut_pattern_trail *trail, double q,
                      spot *s)
{
    const taut_carrier *carrier = ground->carrier;
    const double share = trail->is_back ? 1 - q : q, sign = trail->is_back ? -1 : 1;
    const double range = trail->hi - trail->lo;
    const double t = share < 1 ? trail->lo + share * range : trail->hi;
    double x[TAUT_CARRIER_VECTORS][3], c[3][3], bent[3], rest[3], away = 0;

    if (trail->is_window) {
        taut_curve_eval(trail->curve, t, 2, c[0]);
        for (int k = 0; k < 3; k++) {
            memcpy(s->w[k], c[k], sizeof s->w[k]);
        }
        for (int d = 0; d < 2; d++) {
            s->w[0][d] = fmin(fmax(s->w[0][d], carrier->lo[d]), carrier->hi[d]);
        }
        surface_at(carrier, s->w[0], 2, x);
    } else {
        point_at(carrier, trail->curve, t, 2, c);
        const int near = (int)(share * TAUT_TRAIL_STATIONS + 0.5);
        memcpy(s->w[0], trail->places[near], sizeof s->w[0]);
        away = project(carrier, c[0], s->w[0]);
        surface_at(carrier, s->w[0], 2, x);
        solve((const double(*)[3])x, c[1], s->w[1]);
        bend_of((const double(*)[3])x, s->w[1], bent);
        taut_difference(c[2], bent, rest);
        solve((const double(*)[3])x, rest, s->w[2]);
    }
    for (int d = 0; d < 2; d++) { /* over the share */
        s->w[1][d] *= sign * range;
        s->w[2][d] *= range * range;
    }
    bend_of((const double(*)[3])x, s->w[1], bent);
    for (int d = 0; d < 3; d++) {
        s->x[0][d] = x[0][d];
        s->x[1][d] = x[1][d] * s->w[1][0] + x[2][d] * s->w[1][1];
        s->x[2][d] = bent[d] + x[1][d] * s->w[2][0] + x[2][d] * s->w[2][1];
    }
    return away;
}

/* The place of a grid that is nearest to where a curve in space begins. */
static void find_start(const taut_carrier *carrier, const double point[3], double at[2])
{
    double least = INFINITY;
    for (int i = 0; i <= GRID; i++) {
        for (int k = 0; k <= GRID; k++) {
            const double share[2] = {(double)i / GRID, (double)k / GRID};
            double x[TAUT_CARRIER_VECTORS][3], place[2];
            for (int d = 0; d < 2; d++) {
                place[d] = carrier->lo[d] + share[d] * (carrier->hi[d] - carrier->lo[d]);
            }
            surface_at(carrier, place, 0, x);
            const double away = taut_length_between(point, x[0]);
            if (away < least) {
                least = away;
                memcpy(at, place, sizeof place);
            }
        }
    }
}

taut_status taut_pattern_trail_find(const taut_pattern_ground *ground, const char *name,
                                    const char *where, taut_pattern_trail *trail, taut_error *error)
{
    const taut_carrier *carrier = ground->carrier;
    double at[2] = {carrier->lo[0], carrier->lo[1]};

    *trail = (taut_pattern_trail){.name = name, .held = -1};
    if (curve_in_window(ground, name, &trail->curve) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    trail->is_window = trail->curve != NULL;
    trail->curve = trail->is_window ? trail->curve : curve_in_space(ground->model, name);
    if (trail->curve == NULL) {
        return fail_curve(name, where, "which the model does not have once", error);
    }
    const taut_basis *basis = taut_curve_t(trail->curve);
    trail->lo = taut_basis_lo(basis);
    trail->hi = taut_basis_hi(basis);
    for (int k = 0; k <= TAUT_TRAIL_STATIONS; k++) {
        const double t = trail->lo + (trail->hi - trail->lo) * k / TAUT_TRAIL_STATIONS;
        double c[3][3];
        if (trail->is_window) {
            taut_curve_eval(trail->curve, t, 0, c[0]);
            memcpy(at, c[0], sizeof at);
        } else {
            point_at(carrier, trail->curve, t, 0, c);
            if (k == 0) {
                find_start(carrier, c[0], at);
            }
            const double away = project(carrier, c[0], at);
            if (!(away <= away_most * carrier->size)) {
                return taut_fail(error, TAUT_BAD_INPUT, "curve", where, ldexp(away, carrier->scale),
                                 ldexp(away_most * carrier->size, carrier->scale),
                                 "the curve \"%.60s\" is %.3g away from the surface at t = %.6g",
                                 name, ldexp(away, carrier->scale), t);
            }
        }
        memcpy(trail->places[k], at, sizeof at);
    }
    memcpy(trail->ends[0], trail->places[0], sizeof at);
    memcpy(trail->ends[1], trail->places[TAUT_TRAIL_STATIONS], sizeof at);
    return TAUT_OK;
}

/* ---- as a side ---- */

/* All that a lath tells of a place, over arc length. */
static double station_at(const taut_pattern_ground *ground, const taut_pattern_trail *trail,
                         double q, double s, taut_station *at)
{
    spot here;
    const double away = look_at(ground, trail, q, &here);
    const double speed = taut_length(here.x[1]);
    const double gain = taut_dot(here.x[2], here.x[1]) / speed; /* d speed */
    *at = (taut_station){.on = ground->carrier, .s = s};
    memcpy(at->at, here.w[0], sizeof at->at);
    memcpy(at->x, here.x[0], sizeof at->x);
    for (int c = 0; c < 3; c++) {
        at->tangent[c] = here.x[1][c] / speed;
        at->acceleration[c] = (here.x[2][c] - gain * at->tangent[c]) / (speed * speed);
    }
    for (int d = 0; d < 2; d++) {
        at->ab[d] = here.w[1][d] / speed;
        at->bend[d] = (here.w[2][d] - gain * at->ab[d]) / (speed * speed);
    }
    return away;
}

static double length_between(const taut_pattern_ground *ground, const taut_pattern_trail *trail,
                             double a, double b)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES; k++) {
        spot here;
        look_at(ground, trail, (a + b) / 2 + (b - a) / 2 * nodes[k], &here);
        sum += weights[k] * (b - a) / 2 * taut_length(here.x[1]);
    }
    return sum;
}

/* The shares of the way where the curve's spans begin and end, `pieces` of each. */
static double share_of(const taut_pattern_trail *trail, int pieces, int k)
{
    const taut_basis *basis = taut_curve_t(trail->curve);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), all = spans * pieces;
    const int i = trail->is_back ? all - k : k;
    const int span = i < all ? i / pieces : spans - 1;
    const double part = (double)(i - span * pieces) / pieces;
    const double t = breaks[span] + part * (breaks[span + 1] - breaks[span]);
    const double share = (t - trail->lo) / (trail->hi - trail->lo);
    return k == 0 ? 0 : k == all ? 1 : trail->is_back ? 1 - share : share;
}

/* Its pieces as those of a lath; how far they are off halfway, and the curve from the surface. */
static taut_status cut(const taut_pattern_ground *ground, const taut_pattern_trail *trail,
                       int pieces, taut_lath *lath, double *off, double *away)
{
    const int count = pieces * taut_basis_span_count(taut_curve_t(trail->curve));
    taut_station last;

    *lath = (taut_lath){.count = count};
    lath->segments = taut_arena_take(ground->arena, (size_t)count, sizeof *lath->segments);
    if (lath->segments == NULL) {
        return TAUT_NO_MEMORY;
    }
    *off = 0;
    *away = station_at(ground, trail, 0, 0, &last);
    for (int k = 0; k < count; k++) {
        taut_segment *one = &lath->segments[k];
        const double a = share_of(trail, pieces, k), b = share_of(trail, pieces, k + 1);
        const double middle = (a + b) / 2, first = length_between(ground, trail, a, middle);
        const double whole = first + length_between(ground, trail, middle, b);
        double points[TAUT_QUINTIC][3], value[3], step[3], bend[3];
        spot here;
        one->from = last;
        *away = fmax(*away, station_at(ground, trail, b, last.s + whole, &one->to));
        taut_segment_space(one, points);
        taut_quintic_at(3, points[0], first / whole, value, step, bend);
        *away = fmax(*away, look_at(ground, trail, middle, &here));
        *off = fmax(*off, taut_length_between(value, here.x[0]));
        last = one->to;
    }
    lath->length = last.s;
    return TAUT_OK;
}

taut_status taut_pattern_trail_side(const taut_pattern_ground *ground,
                                    const taut_pattern_trail *trail, const char *where,
                                    taut_pattern_side *side, taut_error *error)
{
    const double size = ground->carrier->size;
    double off = INFINITY, away = 0;
    taut_lath lath;

    for (int pieces = FEWEST; pieces <= MOST && off > off_wanted * size; pieces *= 2) {
        if (cut(ground, trail, pieces, &lath, &off, &away) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        if (!(away <= away_most * size)) {
            return fail_curve(trail->name, where, "which leaves the surface", error);
        }
    }
    if (!(off <= off_most * size) || !(lath.length > 0)) {
        return fail_curve(trail->name, where, "which has a corner", error);
    }
    memcpy(lath.segments[0].from.at, side->ends[0], sizeof side->ends[0]);
    memcpy(lath.segments[lath.count - 1].to.at, side->ends[1], sizeof side->ends[1]);
    return taut_pattern_take_lath(ground->carrier, &lath, trail->held, ground->arena, side, error);
}

/* A polyline of the window as the trail of a side: count points (u, v, 0) at `at`. */
static taut_status take_polyline(const taut_pattern_ground *ground, size_t count, const double *at,
                                 const double *points, taut_pattern_trail *trail, taut_error *error)
{
    double *knots = taut_arena_take(ground->arena, count + 2, sizeof *knots);
    taut_basis *basis = NULL;
    taut_curve *curve = NULL;

    if (knots == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(knots + 1, at, count * sizeof *knots); /* of degree 1 */
    knots[0] = at[0];
    knots[count + 1] = at[count - 1];
    const taut_basis_spec spec = {
        .type = "bspline", .degree = 1, .knot_count = (int)count + 2, .knots = knots};
    taut_status status = taut_basis_new(&spec, (int)count, &basis, error);
    if (status == TAUT_OK) {
        status = taut_curve_new(NULL, basis, points, NULL, &curve, error);
    }
    taut_basis_free(basis);
    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_keep_curve(ground->arena, curve)) {
        return taut_fail_memory(error);
    }
    trail->curve = curve;
    trail->lo = at[0];
    trail->hi = at[count - 1];
    return TAUT_OK;
}

taut_status taut_pattern_trail_line(const taut_pattern_ground *ground, int held, double value,
                                    const double range[2], int backwards, taut_pattern_side *side,
                                    taut_error *error)
{
    const int along = 1 - held;
    const double *breaks = taut_basis_breaks(ground->carrier->basis[along]);
    const int spans = taut_basis_span_count(ground->carrier->basis[along]);
    const double lo = range != NULL ? range[0] : breaks[0],
                 hi = range != NULL ? range[1] : breaks[spans];
    double *at = taut_arena_take(ground->arena, (size_t)spans + 1, sizeof *at);
    double *points = taut_arena_take(ground->arena, (size_t)spans + 1, 3 * sizeof *points);
    taut_pattern_trail trail = {.name = "line", .is_window = 1, .is_back = backwards, .held = held};
    size_t count = 0;

    if (at == NULL || points == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k <= spans; k++) { /* both ends, and the breaks between them */
        if (k == 0 || k == spans || (breaks[k] > lo && breaks[k] < hi)) {
            at[count] = k == 0 ? lo : k == spans ? hi : breaks[k];
            points[3 * count + (size_t)held] = value;
            points[3 * count + (size_t)along] = at[count];
            count++;
        }
    }
    const taut_status status = take_polyline(ground, count, at, points, &trail, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int end = 0; end < 2; end++) {
        side->ends[end][held] = value;
        side->ends[end][along] = end == backwards ? lo : hi;
    }
    side->kind = TAUT_SIDE_LINE;
    return taut_pattern_trail_side(ground, &trail, "/of", side, error);
}
