/* shapes.c -- lines, polylines, arcs, circles, ellipses and splines as what they are: B-splines, rational where they
 * are round, their parameter about the length along them.
 *
 * A bulge is the tangent of a quarter of the angle of its arc. An arc is cut in parts of at most a right angle, each
 * with the weights 1, cos(A / 2), 1. A round polyline has its straight pieces in degree 2 as well.
 */
#include "io/dxf/shapes.h"
#include "io/dxf/clamp.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

static const double arbitrary = 1.0 / 64;

static void set_unit(double v[3])
{
    const double size = taut_norm(v);
    for (int k = 0; k < 3; k++) {
        v[k] = size > 0 ? v[k] / size : 0;
    }
}

void taut_dxf_object_axes(const double normal[3], taut_dxf_placing placing)
{
    static const double up[3] = {0, 0, 1}, along[3] = {0, 1, 0};
    double n[3] = {normal[0], normal[1], normal[2]}, x[3], y[3];
    set_unit(n);
    taut_cross(fabs(n[0]) < arbitrary && fabs(n[1]) < arbitrary ? along : up, n, x);
    set_unit(x);
    taut_cross(n, x, y);
    for (int k = 0; k < 3; k++) {
        placing[k][0] = x[k];
        placing[k][1] = y[k];
        placing[k][2] = n[k];
        placing[k][3] = 0;
    }
}

void taut_dxf_compose(taut_dxf_placing second, taut_dxf_placing first, taut_dxf_placing out)
{
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 4; c++) {
            out[r][c] = c == 3 ? second[r][3] : 0;
            for (int k = 0; k < 3; k++) {
                out[r][c] += second[r][k] * first[k][c];
            }
        }
    }
}

/* Room for so many points more. */
static int grow(taut_arena *arena, taut_dxf_curve *curve, int degree, size_t points)
{
    *curve = (taut_dxf_curve){.degree = degree, .room = points};
    curve->points = taut_arena_take(arena, points, sizeof *curve->points);
    curve->knots = taut_arena_take(arena, points + (size_t)degree + 1, sizeof *curve->knots);
    return curve->points != NULL && curve->knots != NULL;
}

static void put_point(taut_dxf_curve *curve, const double x[3], double weight)
{
    double *point = curve->points[curve->count++];
    for (int k = 0; k < 3; k++) {
        point[k] = weight * x[k];
    }
    point[3] = weight;
}

/* The end of a piece: a knot as often as the degree. The ends of all are put by finish. */
static void put_knot(taut_dxf_curve *curve, double t)
{
    const size_t pieces = (curve->count - 1) / (size_t)curve->degree;
    for (int k = 0; k < curve->degree; k++) {
        curve->knots[(pieces - 1) * (size_t)curve->degree + 1 + (size_t)curve->degree + (size_t)k] =
            t;
    }
}

static double last_knot(const taut_dxf_curve *curve)
{
    return curve->count > 1 ? curve->knots[curve->count] : 0;
}

static void finish(taut_dxf_curve *curve)
{
    for (int k = 0; k <= curve->degree; k++) {
        curve->knots[k] = 0;
    }
    curve->knots[curve->count + (size_t)curve->degree] = curve->knots[curve->count];
}

/* A straight piece to x, of the curve's degree (1 or 2). */
static void line_to(taut_dxf_curve *curve, const double x[3])
{
    const double *from = curve->points[curve->count - 1];
    double middle[3];
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * from[k] + 0.5 * x[k];
    }
    const double t = last_knot(curve) + 2 * taut_distance(middle, x);
    if (curve->degree == 2) {
        put_point(curve, middle, 1);
    }
    put_point(curve, x, 1);
    put_knot(curve, t);
}

/* An ellipse: centre + cos(t) a + sin(t) b. */
typedef struct ellipse {
    double centre[3], a[3], b[3];
} ellipse;

static void point_of(const ellipse *e, double t, double reach, double x[3])
{
    memcpy(x, e->centre, sizeof e->centre);
    taut_add_scaled(reach * taut_cos(t), e->a, x);
    taut_add_scaled(reach * taut_sin(t), e->b, x);
}

static size_t parts_of(double sweep)
{
    return (size_t)fmax(1, ceil(fabs(sweep) / (0.5 * TAUT_PI) - 1e-9));
}

/* Pieces from angle `from` on; `end`, where it is not NULL, is the last point. */
static void arc_to(taut_dxf_curve *curve, const ellipse *e, double from, double sweep,
                   const double *end)
{
    const size_t parts = parts_of(sweep);
    const double step = sweep / (double)parts, middle = taut_cos(0.5 * step);
    const double size = fmax(taut_norm(e->a), taut_norm(e->b));
    for (size_t i = 0; i < parts; i++) {
        const double t = from + step * (double)i;
        double x[3];
        const double knot = last_knot(curve) + fabs(step) * size;
        point_of(e, t + 0.5 * step, 1 / middle, x);
        put_point(curve, x, middle);
        point_of(e, t + step, 1, x);
        put_point(curve, end != NULL && i + 1 == parts ? end : x, 1);
        put_knot(curve, knot);
    }
}

static taut_status whole_arc(const ellipse *e, double from, double sweep, taut_arena *arena,
                             taut_dxf_curve *curve, taut_error *error)
{
    double x[3];
    if (!grow(arena, curve, 2, 2 * parts_of(sweep) + 1)) {
        return taut_fail_memory(error);
    }
    point_of(e, from, 1, x);
    put_point(curve, x, 1);
    /* once around ends where it began */
    arc_to(curve, e, from, sweep, fabs(sweep) >= 2 * TAUT_PI ? x : NULL);
    finish(curve);
    return TAUT_OK;
}

/* Coordinates of an object to those of its block. */
static taut_status read_axes(taut_dxf_pairs pairs, taut_dxf_placing axes, taut_error *error)
{
    double normal[3] = {0, 0, 1};
    const taut_status status = taut_dxf_find_point(pairs, 210, normal, error);
    if (!(taut_norm(normal) > 0)) {
        normal[2] = 1;
    }
    taut_dxf_object_axes(normal, axes);
    return status;
}

static void place(taut_dxf_placing placing, const double x[3], double out[3])
{
    for (int r = 0; r < 3; r++) {
        out[r] = placing[r][3];
        for (int k = 0; k < 3; k++) {
            out[r] += placing[r][k] * x[k];
        }
    }
}

static taut_status line_shape(taut_dxf_pairs pairs, taut_arena *arena, taut_dxf_curve *curve,
                              taut_error *error)
{
    double ends[2][3] = {{0, 0, 0}, {0, 0, 0}};
    taut_status status = taut_dxf_find_point(pairs, 10, ends[0], error);
    if (status == TAUT_OK) {
        status = taut_dxf_find_point(pairs, 11, ends[1], error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (!grow(arena, curve, 1, 2)) {
        return taut_fail_memory(error);
    }
    put_point(curve, ends[0], 1);
    line_to(curve, ends[1]);
    finish(curve);
    return TAUT_OK;
}

/* ARC and CIRCLE: angles in degrees, counterclockwise. */
static taut_status circle_shape(taut_dxf_pairs pairs, int is_arc, taut_arena *arena,
                                taut_dxf_curve *curve, taut_error *error)
{
    const double turn = 2 * TAUT_PI;
    double centre[3] = {0, 0, 0}, radius = 0, angle[2] = {0, 0};
    taut_dxf_placing axes;
    ellipse e;
    taut_status status = read_axes(pairs, axes, error);
    status = status == TAUT_OK ? taut_dxf_find_point(pairs, 10, centre, error) : status;
    status = status == TAUT_OK ? taut_dxf_find(pairs, 40, &radius, error) : status;
    for (int k = 0; k < 2 && is_arc && status == TAUT_OK; k++) {
        status = taut_dxf_find(pairs, 50 + k, &angle[k], error);
        angle[k] *= TAUT_PI / 180;
    }
    if (status != TAUT_OK) {
        return status;
    }
    place(axes, centre, e.centre);
    for (int k = 0; k < 3; k++) {
        e.a[k] = radius * axes[k][0];
        e.b[k] = radius * axes[k][1];
    }
    double sweep = fmod(angle[1] - angle[0], turn);
    sweep += sweep <= 0 ? turn : 0;
    return whole_arc(&e, fmod(angle[0], turn), is_arc ? sweep : turn, arena, curve, error);
}

static taut_status ellipse_shape(taut_dxf_pairs pairs, taut_arena *arena, taut_dxf_curve *curve,
                                 taut_error *error)
{
    const double turn = 2 * TAUT_PI;
    double normal[3] = {0, 0, 1}, ratio = 1, angle[2] = {0, turn};
    ellipse e = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    taut_status status = taut_dxf_find_point(pairs, 10, e.centre, error);
    status = status == TAUT_OK ? taut_dxf_find_point(pairs, 11, e.a, error) : status;
    status = status == TAUT_OK ? taut_dxf_find_point(pairs, 210, normal, error) : status;
    status = status == TAUT_OK ? taut_dxf_find(pairs, 40, &ratio, error) : status;
    status = status == TAUT_OK ? taut_dxf_find(pairs, 41, &angle[0], error) : status;
    status = status == TAUT_OK ? taut_dxf_find(pairs, 42, &angle[1], error) : status;
    if (status != TAUT_OK) {
        return status;
    }
    set_unit(normal);
    taut_cross(normal, e.a, e.b);
    for (int k = 0; k < 3; k++) {
        e.b[k] *= ratio;
    }
    double sweep = fmod(angle[1] - angle[0], turn);
    sweep += sweep <= 0 ? turn : 0;
    if (fabs(sweep - turn) < 1e-9) {
        sweep = turn;
    }
    return whole_arc(&e, fmod(angle[0], turn), sweep, arena, curve, error);
}

/* A corner of a polyline and the bulge of what follows it. */
typedef struct corner {
    double x[3], bulge;
} corner;

/* From one corner to the next. */
static void go_to(taut_dxf_curve *curve, const corner *from, const double to[3])
{
    const double bulge = from->bulge, sweep = 4 * taut_atan(bulge);
    double chord[3], across[3];
    taut_difference(to, from->x, chord);
    const double half = 0.5 * taut_norm(chord);
    if (bulge == 0 || !(half > 0)) {
        line_to(curve, to);
        return;
    }
    /* the centre lies off the chord by half cot(sweep / 2), to the left of it */
    ellipse e;
    const double off = half * (1 - bulge * bulge) / (2 * bulge);
    across[0] = -chord[1] / (2 * half);
    across[1] = chord[0] / (2 * half);
    across[2] = 0;
    for (int k = 0; k < 3; k++) {
        e.centre[k] = 0.5 * from->x[k] + 0.5 * to[k] + off * across[k];
        e.a[k] = from->x[k] - e.centre[k];
    }
    e.b[0] = -e.a[1];
    e.b[1] = e.a[0];
    e.b[2] = 0;
    arc_to(curve, &e, 0, sweep, to);
}

static taut_status polyline(const corner *corners, size_t count, int closed, taut_arena *arena,
                            taut_dxf_curve *curve, taut_error *error)
{
    size_t pieces = 0;
    int round = 0;
    for (size_t i = 0; i + !closed < count; i++) {
        pieces += parts_of(4 * taut_atan(corners[i].bulge));
        round = round || corners[i].bulge != 0;
    }
    if (!grow(arena, curve, round ? 2 : 1, (round ? 2 : 1) * pieces + 1)) {
        return taut_fail_memory(error);
    }
    put_point(curve, corners[0].x, 1);
    for (size_t i = 0; i + !closed < count; i++) {
        const double *next = corners[(i + 1) % count].x;
        if (memcmp(next, corners[i].x, sizeof corners[i].x) != 0) {
            go_to(curve, &corners[i], next);
        }
    }
    finish(curve);
    return TAUT_OK;
}

/* Corners of an LWPOLYLINE: 10 begins one. */
static taut_status light_corners(taut_dxf_pairs pairs, corner *corners, size_t *count,
                                 taut_error *error)
{
    double elevation = 0;
    taut_status status = taut_dxf_find(pairs, 38, &elevation, error);
    *count = 0;
    for (size_t i = 0; i < pairs.count && status == TAUT_OK; i++) {
        const taut_dxf_pair *pair = &pairs.at[i];
        if (pair->code == 10) {
            corner *c = &corners[(*count)++];
            *c = (corner){.x = {0, 0, elevation}};
            status = taut_dxf_number(pair, &c->x[0], error);
        } else if (*count > 0 && (pair->code == 20 || pair->code == 42)) {
            corner *c = &corners[*count - 1];
            status = taut_dxf_number(pair, pair->code == 20 ? &c->x[1] : &c->bulge, error);
        }
    }
    return status;
}

/* The pairs of one of several entities, from pair `from` on. */
static taut_dxf_pairs entity_at(taut_dxf_pairs pairs, size_t from)
{
    size_t to = from + 1;
    while (to < pairs.count && pairs.at[to].code != 0) {
        to++;
    }
    return (taut_dxf_pairs){pairs.at + from, to - from};
}

/* Corners of a POLYLINE: VERTEX entities, but those of a frame that a spline was fitted to. */
static taut_status heavy_corners(taut_dxf_pairs pairs, int flat, corner *corners, size_t *count,
                                 taut_error *error)
{
    double elevation[3] = {0, 0, 0};
    taut_status status = taut_dxf_find_point(entity_at(pairs, 0), 10, elevation, error);
    *count = 0;
    for (size_t i = 1; i < pairs.count && status == TAUT_OK; i++) {
        if (!taut_dxf_is(&pairs.at[i], 0, "VERTEX")) {
            continue;
        }
        const taut_dxf_pairs vertex = entity_at(pairs, i);
        corner c = {.x = {0, 0, 0}};
        double flags = 0;
        status = taut_dxf_find_point(vertex, 10, c.x, error);
        status = status == TAUT_OK ? taut_dxf_find(vertex, 70, &flags, error) : status;
        status = status == TAUT_OK && flat ? taut_dxf_find(vertex, 42, &c.bulge, error) : status;
        c.x[2] = flat ? elevation[2] : c.x[2];
        if (!(fabs(flags) < 4096 && ((int)flags & 16) != 0)) {
            corners[(*count)++] = c;
        }
    }
    return status;
}

/* Of coordinates of an object; each point of the curve is placed. */
static void place_curve(taut_dxf_placing axes, taut_dxf_curve *curve)
{
    for (size_t i = 0; i < curve->count; i++) {
        double *p = curve->points[i], x[3];
        for (int r = 0; r < 3; r++) {
            x[r] = axes[r][0] * p[0] + axes[r][1] * p[1] + axes[r][2] * p[2] + axes[r][3] * p[3];
        }
        memcpy(p, x, sizeof x);
    }
}

static taut_status polyline_shape(taut_dxf_pairs pairs, int light, taut_arena *arena,
                                  taut_dxf_curve *curve, const char **why, taut_error *error)
{
    corner *corners = taut_arena_take(arena, pairs.count, sizeof *corners);
    taut_dxf_placing axes;
    double flags = 0;
    size_t count = 0;
    if (corners == NULL) {
        return taut_fail_memory(error);
    }
    taut_status status = taut_dxf_find(light ? pairs : entity_at(pairs, 0), 70, &flags, error);
    const int bits = fabs(flags) < 4096 ? (int)flags : 0, flat = light || !(bits & 8);
    if (status == TAUT_OK && !light && (bits & (16 | 64)) != 0) {
        *why = "a mesh";
        return TAUT_OK;
    }
    status =
        status == TAUT_OK ? read_axes(light ? pairs : entity_at(pairs, 0), axes, error) : status;
    if (status == TAUT_OK) {
        status = light ? light_corners(pairs, corners, &count, error)
                       : heavy_corners(pairs, flat, corners, &count, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    if (count < 2) {
        *why = "a polyline of one point";
        return TAUT_OK;
    }
    status = polyline(corners, count, bits & 1, arena, curve, error);
    if (status == TAUT_OK && flat) {
        place_curve(axes, curve);
    }
    return status;
}

/* All numbers of a code, in their order, at most `room`. */
static taut_status numbers_of(taut_dxf_pairs pairs, int code, size_t room, double *values,
                              size_t step, size_t *count, taut_error *error)
{
    taut_status status = TAUT_OK;
    *count = 0;
    for (size_t i = 0; i < pairs.count && status == TAUT_OK; i++) {
        if (pairs.at[i].code == code && *count < room) {
            status = taut_dxf_number(&pairs.at[i], &values[step * (*count)++], error);
        }
    }
    return status;
}

static taut_status spline_shape(taut_dxf_pairs pairs, taut_arena *arena, taut_dxf_curve *curve,
                                const char **why, taut_error *error)
{
    double degree = 3;
    size_t counts[3] = {0, 0, 0}, knots = 0, weights = 0;
    taut_status status = taut_dxf_find(pairs, 71, &degree, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!(degree >= 1 && degree <= TAUT_DEGREE_MAX && degree == floor(degree))) {
        *why = "a spline of no degree";
        return TAUT_OK;
    }
    if (!grow(arena, curve, (int)degree, pairs.count)) {
        return taut_fail_memory(error);
    }
    double *weight = taut_arena_take(arena, pairs.count, sizeof *weight);
    if (weight == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        status =
            numbers_of(pairs, 10 + 10 * k, pairs.count, &curve->points[0][k], 4, &counts[k], error);
    }
    status =
        status == TAUT_OK ? numbers_of(pairs, 41, pairs.count, weight, 1, &weights, error) : status;
    status = status == TAUT_OK ? numbers_of(pairs, 40, pairs.count, curve->knots, 1, &knots, error)
                               : status;
    if (status != TAUT_OK) {
        return status;
    }
    curve->count = counts[0];
    if (counts[0] == 0) {
        *why = "a spline by its fit points alone (save its control points)";
    } else if (counts[1] != counts[0] || counts[2] != counts[0] ||
               (weights != 0 && weights != counts[0]) ||
               knots != counts[0] + (size_t)curve->degree + 1 ||
               counts[0] <= (size_t)curve->degree) {
        *why = "a spline of numbers that do not go together";
    }
    for (size_t i = 0; *why == NULL && i < curve->count; i++) {
        const double w = weights > 0 ? weight[i] : 1;
        for (int k = 0; k < 3; k++) {
            curve->points[i][k] *= w;
        }
        curve->points[i][3] = w;
    }
    if (*why == NULL && !taut_dxf_clamp(curve, arena)) {
        *why = "a spline of broken knots";
    }
    return taut_arena_status(arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_dxf_shape(taut_dxf_pairs pairs, taut_arena *arena, taut_dxf_curve *curve,
                           taut_dxf_kind *kind, const char **why, taut_error *error)
{
    const taut_dxf_pair *first = &pairs.at[0];
    taut_status status = TAUT_OK;
    *kind = TAUT_DXF_MADE;
    *why = NULL;
    *curve = (taut_dxf_curve){.degree = 0};
    if (taut_dxf_is(first, 0, "LINE")) {
        status = line_shape(pairs, arena, curve, error);
    } else if (taut_dxf_is(first, 0, "ARC") || taut_dxf_is(first, 0, "CIRCLE")) {
        status = circle_shape(pairs, taut_dxf_is(first, 0, "ARC"), arena, curve, error);
    } else if (taut_dxf_is(first, 0, "ELLIPSE")) {
        status = ellipse_shape(pairs, arena, curve, error);
    } else if (taut_dxf_is(first, 0, "LWPOLYLINE") || taut_dxf_is(first, 0, "POLYLINE")) {
        status =
            polyline_shape(pairs, taut_dxf_is(first, 0, "LWPOLYLINE"), arena, curve, why, error);
    } else if (taut_dxf_is(first, 0, "SPLINE")) {
        status = spline_shape(pairs, arena, curve, why, error);
    } else {
        *kind = TAUT_DXF_OTHER;
        return TAUT_OK;
    }
    if (status == TAUT_OK && *why == NULL &&
        (curve->count < 2 || !(curve->knots[curve->count] > curve->knots[0]))) {
        *why = "a curve without length";
    }
    *kind = *why != NULL ? TAUT_DXF_UNREADABLE : TAUT_DXF_MADE;
    return status;
}
