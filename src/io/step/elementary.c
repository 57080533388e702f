#include "io/step/elementary.h"

#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "taut/join.h"

#include <math.h>
#include <string.h>

enum { RING = 9, ROWS_MAX = 5 };
static const double half_right = 0.70710678118654752440; /* sqrt(1/2) */
/* How far a net may be from that of a form, of the largest coordinate: rounding of rings that are small
 * beside it, or of what is long between them. */
static const double rounded = 4096 * TAUT_UNIT_ROUNDOFF;

/* The points of a circle, from its centre, over its radius. */
static const double places[RING][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                       {-1, -1}, {0, -1}, {1, -1}, {1, 0}};

/* A net seen with its rings as rows. */
typedef struct rows {
    int count;
    size_t step[2]; /* points from a row to the next, and in a row */
    const double *points, *weights;
} rows;

static const double *point_at(const rows *net, int row, int j)
{
    return net->points + 3 * ((size_t)row * net->step[0] + (size_t)j * net->step[1]);
}

static double weight_at(const rows *net, int row, int j)
{
    return net->weights[(size_t)row * net->step[0] + (size_t)j * net->step[1]];
}

/* Are the knots those of Bezier pieces of a degree, one after the other? */
static int is_of_pieces(const taut_basis *basis, int degree, int count)
{
    return taut_basis_degree(basis) == degree && taut_basis_count(basis) == count &&
           taut_basis_span_count(basis) * degree + 1 == count;
}

/* The rows where the surface has rings along direction `around`; 0: it has none. */
static int find_rows(const taut_surface *surface, int around, rows *net)
{
    const taut_basis *ring = around == 1 ? taut_surface_v(surface) : taut_surface_u(surface);
    const taut_basis *across = around == 1 ? taut_surface_u(surface) : taut_surface_v(surface);
    const int count = taut_basis_count(across), degree = taut_basis_degree(across);
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    *net = (rows){.count = count,
                  .step = {around == 1 ? nv : 1, around == 1 ? 1 : nv},
                  .points = taut_surface_points(surface),
                  .weights = taut_surface_weights(surface)};
    return net->weights != NULL && is_of_pieces(ring, 2, RING) && count <= ROWS_MAX &&
           (degree == 1 ? count == 2 : is_of_pieces(across, 2, count));
}

/* Is each row as a ring wants it, times a weight of its own? */
static int are_weights_of_rings(const rows *net)
{
    for (int i = 0; i < net->count; i++) {
        const double first = weight_at(net, i, 0);
        for (int j = 0; j < RING; j++) {
            const double wanted = first * (j % 2 == 1 ? half_right : 1);
            if (!(fabs(weight_at(net, i, j) - wanted) <= 4 * TAUT_UNIT_ROUNDOFF * wanted)) {
                return 0;
            }
        }
    }
    return 1;
}

static void make_unit(double v[3])
{
    const double size = taut_norm(v);
    for (int k = 0; k < 3; k++) {
        v[k] /= size;
    }
}

/* The circle through a row, if it is one at all: `distance` tells. A point: radius 0. */
static void find_ring(const rows *net, int row, taut_step_ring *ring)
{
    double across[3];
    memset(ring, 0, sizeof *ring);
    for (int k = 0; k < 3; k++) {
        ring->centre[k] = 0.5 * (0.5 * point_at(net, row, 0)[k] + 0.5 * point_at(net, row, 4)[k]) +
                          0.5 * (0.5 * point_at(net, row, 2)[k] + 0.5 * point_at(net, row, 6)[k]);
    }
    taut_difference(point_at(net, row, 0), ring->centre, ring->ahead);
    taut_difference(point_at(net, row, 2), ring->centre, ring->aside);
    ring->radius = 0.25 * (taut_distance(point_at(net, row, 0), point_at(net, row, 4)) +
                           taut_distance(point_at(net, row, 2), point_at(net, row, 6)));
    ring->other = ring->radius;
    taut_cross(ring->ahead, ring->aside, across);
    if (!(taut_norm(across) > 0)) {
        ring->radius = ring->other = 0;
        return;
    }
    make_unit(ring->ahead);
    taut_cross(across, ring->ahead, ring->aside);
    make_unit(ring->aside);
}

static void ring_axis(const taut_step_ring *ring, double axis[3])
{
    taut_cross(ring->ahead, ring->aside, axis);
}

/* The largest distance of a row from the points of a ring, each `reach` times as far from a line through
 * `origin` along `axis` (NULL: as they are). */
static double row_distance(const rows *net, int row, const taut_step_ring *ring,
                           const double *origin, const double *axis, double reach)
{
    double worst = 0;
    for (int j = 0; j < RING; j++) {
        double x[3];
        memcpy(x, ring->centre, sizeof x);
        taut_add_scaled(ring->radius * places[j][0], ring->ahead, x);
        taut_add_scaled(ring->other * places[j][1], ring->aside, x);
        if (axis != NULL) {
            double way[3];
            taut_difference(x, origin, way);
            taut_add_scaled(-taut_dot(way, axis), axis, way);
            taut_add_scaled(reach - 1, way, x);
        }
        const double apart = taut_distance(x, point_at(net, row, j));
        if (!isfinite(apart)) {
            return INFINITY;
        }
        worst = fmax(worst, apart);
    }
    return worst;
}

/* About an axis through `origin`. */
static void turn_vector(const double axis[3], double angle, double v[3])
{
    const double c = taut_cos(angle), s = taut_sin(angle), along = taut_dot(axis, v) * (1 - c);
    double side[3];
    taut_cross(axis, v, side);
    for (int k = 0; k < 3; k++) {
        v[k] = c * v[k] + s * side[k] + along * axis[k];
    }
}

static void turn_ring(const taut_step_form *form, double angle, taut_step_ring *ring)
{
    double way[3];
    taut_difference(ring->centre, form->origin, way);
    turn_vector(form->axis, angle, way);
    turn_vector(form->axis, angle, ring->ahead);
    turn_vector(form->axis, angle, ring->aside);
    memcpy(ring->centre, form->origin, sizeof way);
    taut_add_scaled(1, way, ring->centre);
}

/* A ring put across an axis, the way round that it has. */
static void set_across(const double axis[3], taut_step_ring *ring)
{
    double own[3];
    ring_axis(ring, own);
    taut_add_scaled(-taut_dot(ring->ahead, axis), axis, ring->ahead);
    make_unit(ring->ahead);
    taut_cross(axis, ring->ahead, ring->aside);
    if (taut_dot(own, axis) < 0) {
        for (int k = 0; k < 3; k++) {
            ring->aside[k] = -ring->aside[k];
        }
    }
}

/* Rings of one radius on one axis, or about one centre in one plane. */
static void fit_straight(const rows *net, double largest, taut_step_form *form)
{
    taut_step_ring *const a = &form->rings[0], *const b = &form->rings[1];
    taut_step_ring *const wide = a->radius >= b->radius ? a : b, *const other = wide == a ? b : a;
    const double centre[3] = {other->centre[0], other->centre[1], other->centre[2]};
    const double radius = other->radius;
    double way[3];
    taut_difference(b->centre, a->centre, way);
    form->kind = taut_norm(way) > rounded * largest ? TAUT_STEP_CYLINDER : TAUT_STEP_PLANE;
    if (form->kind == TAUT_STEP_CYLINDER) {
        make_unit(way);
        set_across(way, wide);
        memcpy(form->axis, way, sizeof way);
    } else {
        ring_axis(wide, form->axis);
    }
    *other = *wide;
    if (form->kind == TAUT_STEP_CYLINDER) {
        memcpy(other->centre, centre, sizeof centre);
    } else {
        other->radius = other->other = radius;
    }
    memcpy(form->origin, wide->centre, sizeof form->origin);
    memcpy(form->ahead, wide->ahead, sizeof form->ahead);
    form->distance =
        fmax(row_distance(net, 0, a, NULL, NULL, 1), row_distance(net, 1, b, NULL, NULL, 1));
}

/* Affine images of circles, in one plane about one centre and with half diameters along the same lines: the longer ones are those of
 * one ring, and the other is within it, or a point. */
static void fit_flat(const rows *net, taut_step_form *form)
{
    taut_step_ring *rings = form->rings;
    double across[3];
    for (int i = 0; i < 2; i++) {
        find_ring(net, i, &rings[i]);
        rings[i].radius = 0.5 * taut_distance(point_at(net, i, 0), point_at(net, i, 4));
        rings[i].other = 0.5 * taut_distance(point_at(net, i, 2), point_at(net, i, 6));
    }
    const int outer = rings[1].radius > rings[0].radius;
    taut_step_ring *const wide = &rings[outer], *const other = &rings[1 - outer];
    taut_difference(point_at(net, outer, 2), wide->centre, wide->aside);
    taut_cross(wide->ahead, wide->aside, across);
    form->kind = TAUT_STEP_PLANE;
    form->distance = INFINITY;
    if (!(taut_norm(across) > 0) || !(other->other < wide->other) ||
        (other->radius > 0) != (other->other > 0)) {
        return;
    }
    make_unit(wide->aside);
    make_unit(across);
    memcpy(form->axis, across, sizeof form->axis);
    memcpy(form->origin, wide->centre, sizeof form->origin);
    memcpy(form->ahead, wide->ahead, sizeof form->ahead);
    memcpy(other->centre, wide->centre, sizeof other->centre);
    memcpy(other->ahead, wide->ahead, sizeof other->ahead);
    memcpy(other->aside, wide->aside, sizeof other->aside);
    form->distance = fmax(row_distance(net, 0, &rings[0], NULL, NULL, 1),
                          row_distance(net, 1, &rings[1], NULL, NULL, 1));
}

/* The axis of the turn from one ring to the other, and where it is. */
static double find_turn(taut_step_form *form)
{
    const taut_step_ring *a = &form->rings[0], *b = &form->rings[1];
    double from[3], to[3], way[3];
    ring_axis(a, from);
    ring_axis(b, to);
    taut_cross(from, to, form->axis);
    const double sine = taut_norm(form->axis), angle = taut_atan2(sine, taut_dot(from, to));
    taut_difference(b->centre, a->centre, way);
    make_unit(form->axis);
    if (taut_dot(way, from) < 0) { /* the rings look back, both of them */
        for (int k = 0; k < 3; k++) {
            from[k] = -from[k];
        }
    }
    form->radius = 0.5 * taut_norm(way) / taut_sin(0.5 * angle);
    taut_cross(form->axis, from, form->ahead); /* to the line that it turns about */
    make_unit(form->ahead);
    memcpy(form->origin, a->centre, sizeof form->origin);
    taut_add_scaled(form->radius, form->ahead, form->origin);
    for (int k = 0; k < 3; k++) {
        form->ahead[k] = -form->ahead[k];
    }
    return angle;
}

/* Rows on the way, of arcs of one angle. */
static void fit_turned(const rows *net, taut_step_form *form)
{
    const double angle = find_turn(form);
    const double step = angle / (net->count - 1), reach = 1 / taut_cos(step);
    form->kind = TAUT_STEP_TORUS;
    form->distance = 0;
    for (int i = 0; i < net->count; i++) {
        taut_step_ring ring = form->rings[0];
        turn_ring(form, i * step, &ring);
        const double apart =
            row_distance(net, i, &ring, form->origin, form->axis, i % 2 == 1 ? reach : 1);
        const double weight = i % 2 == 1 ? 1 / reach : 1;
        const double unlike = fabs(weight_at(net, i, 0) / weight_at(net, 0, 0) / weight - 1);
        /* a weight that is off moves a point by as much of the way between control points */
        const double by = 4 * unlike * reach * (form->radius + form->rings[0].radius);
        form->distance = fmax(form->distance, apart + by);
        if (!isfinite(by)) {
            form->distance = INFINITY;
        }
    }
    if (!(form->radius > form->rings[0].radius)) {
        form->distance = INFINITY; /* it would meet its axis */
    }
}

/* Does du x dv point against the form's normal? */
static int points_inwards(const taut_surface *surface, const taut_step_form *form)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double part = 0.375;
    double x[TAUT_SURFACE_VECTORS(1)][3], normal[3], way[3];
    (void)taut_surface_eval(
        surface, taut_basis_lo(u) + part * (taut_basis_hi(u) - taut_basis_lo(u)),
        taut_basis_lo(v) + part * (taut_basis_hi(v) - taut_basis_lo(v)), 1, &x[0][0]);
    taut_cross(x[1], x[2], normal);
    if (form->kind == TAUT_STEP_PLANE) {
        return taut_dot(normal, form->axis) < 0;
    }
    taut_difference(x[0], form->origin, way);
    taut_add_scaled(-taut_dot(way, form->axis), form->axis, way);
    if (form->kind == TAUT_STEP_TORUS) { /* from the circle in its middle */
        const double far = taut_norm(way);
        double middle[3];
        memcpy(middle, form->origin, sizeof middle);
        taut_add_scaled(form->radius / far, way, middle);
        taut_difference(x[0], middle, way);
    }
    return taut_dot(normal, way) < 0;
}

static void fit_rows(const rows *net, double largest, taut_step_form *form)
{
    form->is_round = 1;
    find_ring(net, 0, &form->rings[0]);
    find_ring(net, net->count - 1, &form->rings[1]);
    if (!(fmax(form->rings[0].radius, form->rings[1].radius) > 0)) {
        form->distance = INFINITY;
    } else if (net->count == 2) {
        fit_straight(net, largest, form);
    } else {
        fit_turned(net, form);
    }
}

static int closes(const rows *net)
{
    for (int i = 0; i < net->count; i++) {
        if (memcmp(point_at(net, i, 0), point_at(net, i, RING - 1), 3 * sizeof(double)) != 0) {
            return 0;
        }
    }
    return 1;
}

void taut_step_recognise(const taut_surface *surface, taut_step_form *form)
{
    *form = (taut_step_form){.kind = TAUT_STEP_SPLINE};
    for (int around = 1; around >= 0 && form->kind == TAUT_STEP_SPLINE; around--) {
        taut_step_form found = {.around = around};
        double largest = 0;
        rows net;
        if (!find_rows(surface, around, &net) || !are_weights_of_rings(&net) || !closes(&net)) {
            continue;
        }
        for (size_t i = 0; i < taut_point_count(surface); i++) {
            largest = fmax(largest, taut_largest_coordinate(net.points + 3 * i));
        }
        fit_rows(&net, largest, &found);
        if (net.count == 2 && !(found.distance <= rounded * largest)) {
            found = (taut_step_form){.around = around};
            fit_flat(&net, &found);
        }
        /* weights within four roundings move a circle by as much of its radius */
        found.distance += 32 * TAUT_UNIT_ROUNDOFF *
                          fmax(found.radius, fmax(found.rings[0].radius, found.rings[1].radius));
        if (found.distance <= rounded * largest) {
            found.inwards = points_inwards(surface, &found);
            *form = found;
        }
    }
}

static size_t put_placement(taut_part21 *out, const double origin[3], const double axis[3],
                            const double ahead[3])
{
    const size_t point = TAUT_NEW(out, "CARTESIAN_POINT('',%)", TAUT_REALS(3, origin, 1));
    const size_t up = TAUT_NEW(out, "DIRECTION('',%)", TAUT_REALS(3, axis, 1));
    const size_t right = TAUT_NEW(out, "DIRECTION('',%)", TAUT_REALS(3, ahead, 1));
    return TAUT_NEW(out, "AXIS2_PLACEMENT_3D('',%,%,%)", TAUT_REF(point), TAUT_REF(up),
                    TAUT_REF(right));
}

size_t taut_step_put_form(taut_part21 *out, const taut_step_form *form)
{
    const size_t at = put_placement(out, form->origin, form->axis, form->ahead);
    if (form->kind == TAUT_STEP_PLANE) {
        return TAUT_NEW(out, "PLANE('',%)", TAUT_REF(at));
    }
    if (form->kind == TAUT_STEP_CYLINDER) {
        return TAUT_NEW(out, "CYLINDRICAL_SURFACE('',%,%)", TAUT_REF(at),
                        TAUT_REAL(form->rings[0].radius));
    }
    return TAUT_NEW(out, "TOROIDAL_SURFACE('',%,%,%)", TAUT_REF(at), TAUT_REAL(form->radius),
                    TAUT_REAL(form->rings[0].radius));
}

static size_t put_circle(taut_part21 *out, const double centre[3], const double axis[3],
                         const double ahead[3], double radius)
{
    const size_t at = put_placement(out, centre, axis, ahead);
    return TAUT_NEW(out, "CIRCLE('',%,%)", TAUT_REF(at), TAUT_REAL(radius));
}

/* The seam, from the first point of one ring to that of the other. */
static size_t put_seam(taut_part21 *out, const taut_step_form *form, const double *from,
                       const double *to)
{
    double way[3], centre[3];
    if (form->kind == TAUT_STEP_TORUS) {
        memcpy(centre, form->origin, sizeof centre);
        taut_difference(from, form->origin, way);
        const double high = taut_dot(way, form->axis);
        taut_add_scaled(high, form->axis, centre);
        taut_add_scaled(-high, form->axis, way);
        const double radius = taut_norm(way);
        make_unit(way);
        return put_circle(out, centre, form->axis, way, radius);
    }
    taut_difference(to, from, way);
    const double length = taut_norm(way);
    make_unit(way);
    const size_t begin = TAUT_NEW(out, "CARTESIAN_POINT('',%)", TAUT_REALS(3, from, 1));
    const size_t direction = TAUT_NEW(out, "DIRECTION('',%)", TAUT_REALS(3, way, 1));
    const size_t vector = TAUT_NEW(out, "VECTOR('',%,%)", TAUT_REF(direction), TAUT_REAL(length));
    return TAUT_NEW(out, "LINE('',%,%)", TAUT_REF(begin), TAUT_REF(vector));
}

size_t taut_step_put_form_edge(taut_part21 *out, const taut_step_form *form,
                               const taut_surface *surface, int edge)
{
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface));
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    const double *points = taut_surface_points(surface);
    if (taut_step_is_ring(form, edge)) {
        const taut_step_ring *ring = &form->rings[edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1];
        double axis[3];
        ring_axis(ring, axis);
        return put_circle(out, ring->centre, axis, ring->ahead, ring->radius);
    }
    const size_t first = edge == TAUT_EDGE_U1 ? (nu - 1) * nv : edge == TAUT_EDGE_V1 ? nv - 1 : 0;
    const size_t last = edge == TAUT_EDGE_U0   ? nv - 1
                        : edge == TAUT_EDGE_V0 ? (nu - 1) * nv
                                               : nu * nv - 1;
    return put_seam(out, form, points + 3 * first, points + 3 * last);
}
