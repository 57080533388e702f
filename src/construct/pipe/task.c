/* task.c -- the numbers of a problem checked and brought to local coordinates ([WangBai2018] 2.4,
 * 3.1). */
#include "construct/pipe/task.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Squares and cubes of lengths must neither overflow nor vanish. */
static const double length_min = 1e-90, length_max = 1e90;
/* Over the radius. */
static const double tolerance_default = 1e-6, tolerance_min = 1e-12, tolerance_max = 0.1;

taut_status taut_pipe_check_length(double value, const char *where, taut_error *error)
{
    if (!(value >= length_min && value <= length_max)) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, value,
                                  "a positive length (1e-90 to 1e90)", "found %.17g", value);
    }
    return TAUT_OK;
}

taut_status taut_pipe_check_point(const double point[3], const char *where, taut_error *error)
{
    for (int k = 0; k < 3; k++) {
        if (!(fabs(point[k]) <= length_max)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, point[k], length_max,
                             "a coordinate is %.17g, expected at most 1e90 in size", point[k]);
        }
    }
    return TAUT_OK;
}

taut_status taut_pipe_check_choices(const taut_pipe_choice *choices, size_t count,
                                    taut_error *error)
{
    for (size_t i = 0; i < count; i++) {
        const taut_pipe_choice *c = &choices[i];
        if (c->chosen < 0 || c->chosen > c->last) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", c->where, c->chosen, c->last,
                             "found choice %d, expected one from 0 to %d", c->chosen, c->last);
        }
    }
    return TAUT_OK;
}

taut_status taut_pipe_tolerance(const taut_make_options *options, double *tolerance,
                                taut_error *error)
{
    const double asked = options != NULL ? options->tolerance : 0;
    const double found = asked > 0 ? asked : tolerance_default;
    if (!(found >= tolerance_min && isfinite(found))) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, found, tolerance_min,
                         "a tolerance of %g is below what rounding leaves: 1e-12 of the radius",
                         found);
    }
    *tolerance = fmin(found, tolerance_max);
    return TAUT_OK;
}

/* A direction that is there. */
static taut_status check_direction(const double direction[3], const char *where,
                                   const char *question, taut_error *error)
{
    const taut_status status = taut_pipe_check_point(direction, where, error);
    if (status == TAUT_OK && !(taut_norm(direction) >= length_min)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_norm(direction), 0,
                         "the direction is zero: %s", question);
    }
    return status;
}

static taut_status check_end(const taut_pipe_end *end, const char *where, double direction[3],
                             taut_error *error)
{
    char place[48];
    taut_status status = TAUT_OK;

    snprintf(place, sizeof place, "%s/point", where);
    status = taut_pipe_check_point(end->point, place, error);
    if (status != TAUT_OK) {
        return status;
    }
    snprintf(place, sizeof place, "%s/direction", where);
    status = check_direction(end->direction, place, "which way does the pipe flow?", error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < 3; k++) {
        direction[k] = end->direction[k] / taut_norm(end->direction);
    }
    snprintf(place, sizeof place, "%s/handle", where);
    return end->handle != 0 ? taut_pipe_check_length(end->handle, place, error) : TAUT_OK;
}

/* [WangBai2018] section 2.4; -3 and below lose the tangent in either mode. */
static taut_status check_shape(const taut_pipe_problem *p, taut_error *error)
{
    static const char *const names[] = {"/shape/alpha", "/shape/beta", "/shape/gamma"};
    const double shape[] = {p->shape.alpha, p->shape.beta, p->shape.gamma};
    const double shape_max = 1000; /* of the basis */
    for (int k = 0; k < 3 && p->shape.kind == TAUT_PIPE_SHAPE_GIVEN; k++) {
        const double low = -3, high = k == 1 ? 3 : 1;
        if (!(fabs(shape[k]) <= shape_max)) {
            const int finite = isfinite(shape[k]);
            return taut_fail(error, finite ? TAUT_NO_SOLUTION : TAUT_BAD_INPUT,
                             finite ? "parameter-domain" : "value", names[k], shape[k], shape_max,
                             "PARAMETER_DOMAIN: %s is %g, expected at most 1000 in size",
                             names[k] + 7, shape[k]);
        }
        if (k == 1 && p->joint == TAUT_PIPE_G2 && shape[k] != 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "parameter-domain", names[k], shape[k], 0,
                             "PARAMETER_DOMAIN: beta is %.17g, but has no part in a \"g2\" joint: "
                             "leave it out",
                             shape[k]);
        }
        if (k != 1 && shape[k] <= low) {
            return taut_fail(error, TAUT_NO_SOLUTION, "tangent-lost", names[k], shape[k], low,
                             "TANGENT_LOST: %s is %.17g; at -3 the axis has no speed at the joint, "
                             "below it turns back: take more than -3",
                             names[k] + 7, shape[k]);
        }
        if (!p->shape.extended && !(shape[k] >= low && shape[k] <= high)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "parameter-domain", names[k], shape[k],
                             shape[k] > high ? high : low,
                             "PARAMETER_DOMAIN: %s is %.17g, outside [%g, %g]: the axis may leave "
                             "the hull of its polygon (\"domain\": \"extended\" allows it)",
                             names[k] + 7, shape[k], low, high);
        }
    }
    return TAUT_OK;
}

/* The power of two at or below the largest coordinate: dividing by it is exact. */
double taut_pipe_power_below(double size)
{
    int exponent = 0;
    if (!(size > 0)) {
        return 1;
    }
    (void)frexp(size, &exponent);
    return ldexp(1, exponent - 1);
}

/* The feet of the common perpendicular, with n = d1 x d2 and w = q - p:
 *     s = det(w, d2, n) / n.n,   r = det(w, d1, n) / n.n */
static taut_status find_feet(taut_pipe_task *task, taut_error *error)
{
    const double parallel = 1e-9; /* sine: beyond it the feet lose more than half their digits */
    const double *p = task->problem->axis.ends[0].point, *q = task->problem->axis.ends[1].point;
    double n[3], w[3], square = 0, s = 0, r = 0;

    taut_cross(task->directions[0], task->directions[1], n);
    square = taut_dot(n, n);
    if (!(square > parallel * parallel)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "parallel-axes", "/axes", sqrt(square), parallel,
                         "PARALLEL_AXES: parallel lines have no common perpendicular of their own; "
                         "give \"from\" and \"to\" instead, where each pipe ends");
    }
    taut_difference(q, p, w);
    s = taut_det(w, task->directions[1], n) / square;
    r = taut_det(w, task->directions[0], n) / square;
    for (int k = 0; k < 3; k++) {
        task->base[k] = p[k] + s * task->directions[0][k];
        task->across[k] = w[k] + r * task->directions[1][k] - s * task->directions[0][k];
    }
    return TAUT_OK;
}

static taut_status begin_polygon(taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_axis *axis = &task->problem->axis;
    for (int i = 0; i < 4; i++) {
        char place[32];
        snprintf(place, sizeof place, "/polygon/%d", i);
        if (taut_pipe_check_point(axis->polygon[i], place, error) != TAUT_OK) {
            return TAUT_BAD_INPUT;
        }
    }
    memcpy(task->polygon, axis->polygon, sizeof task->polygon);
    return TAUT_OK;
}

static taut_status begin_ends(taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_end *ends = task->problem->axis.ends;
    const int feet = task->problem->axis.kind == TAUT_PIPE_FEET;
    taut_status status =
        check_end(&ends[0], feet ? "/axes/0" : "/from", task->directions[0], error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_end(&ends[1], feet ? "/axes/1" : "/to", task->directions[1], error);
    if (status != TAUT_OK) {
        return status;
    }
    if (feet) {
        return find_feet(task, error);
    }
    memcpy(task->base, ends[0].point, sizeof task->base);
    taut_difference(ends[1].point, ends[0].point, task->across);
    return TAUT_OK;
}

/* The scale, and everything in it. */
static void set_local(taut_pipe_task *task)
{
    const taut_pipe_problem *p = task->problem;
    double size = task->outer;
    if (p->axis.kind == TAUT_PIPE_POLYGON) {
        for (int i = 0; i < 4; i++) {
            double d[3];
            taut_difference(task->polygon[i], task->polygon[0], d);
            size = fmax(size, taut_largest_coordinate(d));
        }
    } else {
        size = fmax(size, taut_largest_coordinate(task->across));
        size = fmax(size, fmax(p->axis.ends[0].handle, p->axis.ends[1].handle));
    }
    task->scale = taut_pipe_power_below(size);
    task->radius = task->outer / task->scale;
    task->bend_radius = p->bend_radius / task->scale;
    for (int side = 0; side < 2; side++) {
        task->handles[side] =
            p->axis.kind == TAUT_PIPE_POLYGON ? 0 : p->axis.ends[side].handle / task->scale;
        task->tails[side] = task->lengths[side] / task->scale;
    }
    for (int k = 0; k < 3; k++) {
        task->across[k] /= task->scale;
    }
    task->shape[0] = p->shape.alpha;
    task->shape[1] = p->shape.beta;
    task->shape[2] = p->shape.gamma;
}

static taut_status check_ellipse(const taut_pipe_ellipse *ellipse, const char *where,
                                 taut_error *error)
{
    char place[48];
    taut_status status = TAUT_OK;

    snprintf(place, sizeof place, "%s/a", where);
    status = taut_pipe_check_length(ellipse->a, place, error);
    if (status != TAUT_OK) {
        return status;
    }
    snprintf(place, sizeof place, "%s/b", where);
    status = taut_pipe_check_length(ellipse->b, place, error);
    if (status != TAUT_OK) {
        return status;
    }
    snprintf(place, sizeof place, "%s/direction", where);
    return check_direction(ellipse->direction, place, "where does the semi-axis a point?", error);
}

/* Checks the section; the radius of the circle around it. */
static taut_status begin_section(taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_section *s = &task->problem->section;
    if (s->kind == TAUT_PIPE_ROUND) {
        task->outer = s->radius;
        return taut_pipe_check_length(s->radius, "/radius", error);
    }
    for (int side = 0; side < 2; side++) {
        const char *const where[2][2] = {{"/radii/0", "/radii/1"}, {"/sections/0", "/sections/1"}};
        const int elliptic = s->kind == TAUT_PIPE_ELLIPTIC;
        const taut_status status =
            elliptic ? check_ellipse(&s->ellipses[side], where[1][side], error)
                     : taut_pipe_check_length(s->radii[side], where[0][side], error);
        if (status != TAUT_OK) {
            return status;
        }
        task->outer = fmax(task->outer, elliptic ? fmax(s->ellipses[side].a, s->ellipses[side].b)
                                                 : s->radii[side]);
    }
    return TAUT_OK;
}

taut_status taut_pipe_begin(taut_pipe_task *task, taut_error *error)
{
    static const char *const places[2] = {"/pipe_lengths/0", "/pipe_lengths/1"};
    const taut_pipe_problem *p = task->problem;
    taut_status status = begin_section(task, error);

    for (int side = 0; side < 2 && status == TAUT_OK; side++) {
        if (p->lengths[side] != 0) {
            status = taut_pipe_check_length(p->lengths[side], places[side], error);
        }
    }
    if (status == TAUT_OK && p->bend_radius != 0) {
        status = taut_pipe_check_length(p->bend_radius, "/bend_radius", error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = check_shape(p, error);
    if (status != TAUT_OK) {
        return status;
    }
    status =
        p->axis.kind == TAUT_PIPE_POLYGON ? begin_polygon(task, error) : begin_ends(task, error);
    if (status != TAUT_OK) {
        return status;
    }
    set_local(task);
    return TAUT_OK;
}

void taut_pipe_edges(const taut_pipe_task *task, const double handles[2], double edges[3][3])
{
    for (int k = 0; k < 3; k++) {
        edges[0][k] = handles[0] * task->directions[0][k];
        edges[2][k] = handles[1] * task->directions[1][k];
        edges[1][k] = task->across[k];
        if (task->problem->axis.kind == TAUT_PIPE_ENDS) {
            edges[1][k] -= edges[0][k] + edges[2][k];
        }
    }
}

void taut_pipe_arc_of(const taut_pipe_task *task, const double edges[3][3], const double shape[3],
                      taut_pipe_arc *arc)
{
    if (task->problem->joint == TAUT_PIPE_G2) {
        taut_pipe_arc_quintic(edges, shape, arc);
    } else {
        taut_pipe_arc_quasi(edges, shape, arc);
    }
}

/* V_1 = V_0 + h_1 d_1, V_2 = V_3 - h_2 d_2; or V_0 = V_1 - h_1 d_1, V_3 = V_2 + h_2 d_2. */
static void place_polygon(taut_pipe_task *task)
{
    const int feet = task->problem->axis.kind == TAUT_PIPE_FEET;
    for (int k = 0; k < 3; k++) {
        const double first = task->base[k], last = first + task->scale * task->across[k];
        const double h1 = task->scale * task->handles[0] * task->directions[0][k];
        const double h2 = task->scale * task->handles[1] * task->directions[1][k];
        task->polygon[0][k] = feet ? first - h1 : first;
        task->polygon[1][k] = feet ? first : first + h1;
        task->polygon[2][k] = feet ? last : task->problem->axis.ends[1].point[k] - h2;
        task->polygon[3][k] = feet ? last + h2 : task->problem->axis.ends[1].point[k];
    }
}

/* Rings and straight pipes that rounding would swallow: 2^-44 of the largest coordinate leaves them
 * some eight binary digits. */
static taut_status check_sizes(const taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_problem *p = task->problem;
    const taut_pipe_section *s = &p->section;
    const int elliptic = s->kind == TAUT_PIPE_ELLIPTIC, round = s->kind == TAUT_PIPE_ROUND;
    const struct {
        const char *name;
        double size;
    } sizes[] = {
        {"/radius", task->outer},
        {"/pipe_lengths/0", p->lengths[0]},
        {"/pipe_lengths/1", p->lengths[1]},
        {"/sections/0/a", elliptic ? s->ellipses[0].a : 0},
        {"/sections/0/b", elliptic ? s->ellipses[0].b : 0},
        {"/sections/1/a", elliptic ? s->ellipses[1].a : 0},
        {"/sections/1/b", elliptic ? s->ellipses[1].b : 0},
        {"/radii/0", !elliptic && !round ? s->radii[0] : 0},
        {"/radii/1", !elliptic && !round ? s->radii[1] : 0},
    };
    double least = 0;
    for (int i = 0; i < 4; i++) {
        least = fmax(least, 0x1p-44 * taut_largest_coordinate(task->polygon[i]));
    }
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const double size = sizes[i].size;
        if (size > 0 && size < least) {
            return taut_fail(error, TAUT_NO_SOLUTION, "too-small", sizes[i].name, size, least,
                             "TOO_SMALL: %.6g is lost in the rounding of coordinates of this size; "
                             "move the origin near, or take more than %.6g",
                             size, least);
        }
    }
    return TAUT_OK;
}

taut_status taut_pipe_settle(taut_pipe_task *task, taut_error *error)
{
    if (task->problem->axis.kind != TAUT_PIPE_POLYGON) {
        place_polygon(task);
    }
    for (int i = 0; i < 3; i++) {
        taut_difference(task->polygon[i + 1], task->polygon[i], task->edges[i]);
        for (int k = 0; k < 3; k++) {
            task->edges[i][k] /= task->scale;
        }
    }
    for (int side = 0; side < 2; side++) {
        const double *a = task->polygon[2 * side], *b = task->polygon[2 * side + 1];
        const double rounding =
            0x1p-50 * fmax(taut_largest_coordinate(a), taut_largest_coordinate(b)) / task->scale;
        task->handles[side] = taut_norm(task->edges[2 * side]);
        if (!(task->handles[side] > rounding)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "degenerate-edge",
                             side == 0 ? "/polygon/1" : "/polygon/2",
                             task->scale * task->handles[side], task->scale * rounding,
                             "DEGENERATE_EDGE: V_%d and V_%d coincide, so that pipe %d has no "
                             "direction: move them apart",
                             2 * side, 2 * side + 1, side + 1);
        }
    }
    return check_sizes(task, error);
}
