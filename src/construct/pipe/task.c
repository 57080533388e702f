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

taut_status taut_pipe_check_length(double value, const char *where, taut_error *error)
{
    if (!(value >= length_min && value <= length_max)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, value, length_min,
                         "found %.17g, expected a positive length (1e-90 to 1e90)", value);
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

static taut_status check_end(const taut_pipe_end *end, const char *where, double direction[3],
                             taut_error *error)
{
    char place[48];
    double length = 0;
    taut_status status = TAUT_OK;

    snprintf(place, sizeof place, "%s/point", where);
    status = taut_pipe_check_point(end->point, place, error);
    snprintf(place, sizeof place, "%s/direction", where);
    if (status == TAUT_OK) {
        status = taut_pipe_check_point(end->direction, place, error);
    }
    length = taut_norm(end->direction);
    if (status == TAUT_OK && !(length >= length_min)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", place, length, 0,
                         "the direction is zero: which way does the pipe flow?");
    }
    snprintf(place, sizeof place, "%s/handle", where);
    if (status == TAUT_OK && end->handle != 0) {
        status = taut_pipe_check_length(end->handle, place, error);
    }
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        direction[k] = end->direction[k] / length;
    }
    return status;
}

/* [WangBai2018] section 2.4; -3 and below lose the tangent in either mode. */
static taut_status check_shape(const taut_pipe_problem *p, taut_error *error)
{
    static const char *const names[] = {"/shape/alpha", "/shape/beta", "/shape/gamma"};
    const double shape[] = {p->alpha, p->beta, p->gamma};
    const double shape_max = 1000; /* of the basis */
    for (int k = 0; k < 3 && p->shape == TAUT_PIPE_SHAPE_GIVEN; k++) {
        const double low = -3, high = k == 1 ? 3 : 1;
        if (!(fabs(shape[k]) <= shape_max)) {
            return taut_fail(error, isfinite(shape[k]) ? TAUT_NO_SOLUTION : TAUT_BAD_INPUT, "value",
                             names[k], shape[k], shape_max,
                             "PARAMETER_DOMAIN: %s is %g, expected at most 1000 in size",
                             names[k] + 7, shape[k]);
        }
        if (k == 1 && p->joint == TAUT_PIPE_CURVATURE_JOINT && shape[k] != 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", names[k], shape[k], 0,
                             "PARAMETER_DOMAIN: beta is %.17g, but has no part in a \"g2\" joint: "
                             "leave it out",
                             shape[k]);
        }
        if (k != 1 && shape[k] <= low) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", names[k], shape[k], low,
                             "TANGENT_LOST: %s is %.17g; at -3 the axis stands still at the joint, "
                             "below it turns back: take more than -3",
                             names[k] + 7, shape[k]);
        }
        if (!p->extended && !(shape[k] >= low && shape[k] <= high)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", names[k], shape[k],
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

static double largest_part(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* The feet of the common perpendicular, with n = d1 x d2 and w = q - p:
 *     s = det(w, d2, n) / n.n,   r = det(w, d1, n) / n.n */
static taut_status find_feet(taut_pipe_task *task, taut_error *error)
{
    const double parallel = 1e-9; /* sine: beyond it the feet lose more than half their digits */
    const double *p = task->problem->ends[0].point, *q = task->problem->ends[1].point;
    double n[3], w[3], square = 0, s = 0, r = 0;

    taut_cross(task->directions[0], task->directions[1], n);
    square = taut_dot(n, n);
    if (!(square > parallel * parallel)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", "/axes", sqrt(square), parallel,
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
    const taut_pipe_problem *p = task->problem;
    for (int i = 0; i < 4; i++) {
        char place[32];
        snprintf(place, sizeof place, "/polygon/%d", i);
        if (taut_pipe_check_point(p->polygon[i], place, error) != TAUT_OK) {
            return TAUT_BAD_INPUT;
        }
    }
    memcpy(task->polygon, p->polygon, sizeof task->polygon);
    return TAUT_OK;
}

static taut_status begin_ends(taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_problem *p = task->problem;
    const int feet = p->axis == TAUT_PIPE_FEET;
    taut_status status =
        check_end(&p->ends[0], feet ? "/axes/0" : "/from", task->directions[0], error);
    if (status == TAUT_OK) {
        status = check_end(&p->ends[1], feet ? "/axes/1" : "/to", task->directions[1], error);
    }
    if (status == TAUT_OK && feet) {
        status = find_feet(task, error);
    } else if (status == TAUT_OK) {
        memcpy(task->base, p->ends[0].point, sizeof task->base);
        taut_difference(p->ends[1].point, p->ends[0].point, task->across);
    }
    return status;
}

/* The scale, and everything in it. */
static void set_local(taut_pipe_task *task)
{
    const taut_pipe_problem *p = task->problem;
    double size = p->radius;
    for (int i = 0; i < 4 && p->axis == TAUT_PIPE_POLYGON; i++) {
        double d[3];
        taut_difference(task->polygon[i], task->polygon[0], d);
        size = fmax(size, largest_part(d));
    }
    if (p->axis != TAUT_PIPE_POLYGON) {
        size = fmax(size, largest_part(task->across));
        size = fmax(size, fmax(p->ends[0].handle, p->ends[1].handle));
    }
    task->scale = taut_pipe_power_below(size);
    task->radius = p->radius / task->scale;
    task->bend_radius = p->bend_radius / task->scale;
    for (int side = 0; side < 2; side++) {
        task->handles[side] = p->ends[side].handle / task->scale;
        task->tails[side] = task->lengths[side] / task->scale;
    }
    for (int k = 0; k < 3; k++) {
        task->across[k] /= task->scale;
    }
    task->shape[0] = p->alpha;
    task->shape[1] = p->beta;
    task->shape[2] = p->gamma;
}

static taut_status check_section(const taut_pipe_section *section, const char *where,
                                 taut_error *error)
{
    char place[48];
    taut_status status = TAUT_OK;

    snprintf(place, sizeof place, "%s/a", where);
    status = taut_pipe_check_length(section->a, place, error);
    snprintf(place, sizeof place, "%s/b", where);
    if (status == TAUT_OK) {
        status = taut_pipe_check_length(section->b, place, error);
    }
    snprintf(place, sizeof place, "%s/direction", where);
    if (status == TAUT_OK) {
        status = taut_pipe_check_point(section->direction, place, error);
    }
    if (status == TAUT_OK && !(taut_norm(section->direction) >= length_min)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", place, 0, 0,
                         "the direction is zero: where does the semi-axis a point?");
    }
    return status;
}

taut_status taut_pipe_begin(taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_problem *p = task->problem;
    const int elliptic = p->sections[0].a != 0 || p->sections[1].a != 0;
    const int unlike = p->radii[0] != 0 || p->radii[1] != 0;
    taut_status status =
        elliptic || unlike ? TAUT_OK : taut_pipe_check_length(p->radius, "/radius", error);

    for (int side = 0; side < 2 && status == TAUT_OK && unlike; side++) {
        status = taut_pipe_check_length(p->radii[side], side == 0 ? "/radii/0" : "/radii/1", error);
    }
    if (status == TAUT_OK && elliptic && unlike) {
        status = taut_fail(error, TAUT_BAD_INPUT, "value", "/radii", taut_none, taut_none,
                           "found radii beside sections, expected one of them");
    }
    for (int side = 0; side < 2 && status == TAUT_OK && elliptic; side++) {
        status =
            check_section(&p->sections[side], side == 0 ? "/sections/0" : "/sections/1", error);
    }

    for (int side = 0; side < 2 && status == TAUT_OK; side++) {
        if (p->lengths[side] != 0) {
            status = taut_pipe_check_length(
                p->lengths[side], side == 0 ? "/pipe_lengths/0" : "/pipe_lengths/1", error);
        }
    }
    if (status == TAUT_OK && p->bend_radius != 0) {
        status = taut_pipe_check_length(p->bend_radius, "/bend_radius", error);
    }
    if (status == TAUT_OK) {
        status = check_shape(p, error);
    }
    if (status == TAUT_OK) {
        status =
            p->axis == TAUT_PIPE_POLYGON ? begin_polygon(task, error) : begin_ends(task, error);
    }
    if (status == TAUT_OK) {
        set_local(task);
    }
    return status;
}

void taut_pipe_edges(const taut_pipe_task *task, const double handles[2], double edges[3][3])
{
    for (int k = 0; k < 3; k++) {
        edges[0][k] = handles[0] * task->directions[0][k];
        edges[2][k] = handles[1] * task->directions[1][k];
        edges[1][k] = task->across[k];
        if (task->problem->axis == TAUT_PIPE_ENDS) {
            edges[1][k] -= edges[0][k] + edges[2][k];
        }
    }
}

void taut_pipe_arc_of(const taut_pipe_task *task, const double edges[3][3], const double shape[3],
                      taut_pipe_arc *arc)
{
    if (task->problem->joint == TAUT_PIPE_CURVATURE_JOINT) {
        taut_pipe_arc_quintic(edges, shape, arc);
    } else {
        taut_pipe_arc_quasi(edges, shape, arc);
    }
}

/* V_1 = V_0 + h_1 d_1, V_2 = V_3 - h_2 d_2; or V_0 = V_1 - h_1 d_1, V_3 = V_2 + h_2 d_2. */
static void place_polygon(taut_pipe_task *task)
{
    const int feet = task->problem->axis == TAUT_PIPE_FEET;
    for (int k = 0; k < 3; k++) {
        const double first = task->base[k], last = first + task->scale * task->across[k];
        const double h1 = task->scale * task->handles[0] * task->directions[0][k];
        const double h2 = task->scale * task->handles[1] * task->directions[1][k];
        task->polygon[0][k] = feet ? first - h1 : first;
        task->polygon[1][k] = feet ? first : first + h1;
        task->polygon[2][k] = feet ? last : task->problem->ends[1].point[k] - h2;
        task->polygon[3][k] = feet ? last + h2 : task->problem->ends[1].point[k];
    }
}

/* Rings and straight pipes that rounding would swallow: 2^-44 of the largest coordinate leaves them
 * some eight binary digits. */
static taut_status check_sizes(const taut_pipe_task *task, taut_error *error)
{
    const taut_pipe_problem *p = task->problem;
    const taut_pipe_section *s = p->sections;
    const double sizes[] = {p->radius, p->lengths[0], p->lengths[1], s[0].a,     s[0].b,
                            s[1].a,    s[1].b,        p->radii[0],   p->radii[1]};
    static const char *const names[] = {"/radius",       "/pipe_lengths/0", "/pipe_lengths/1",
                                        "/sections/0/a", "/sections/0/b",   "/sections/1/a",
                                        "/sections/1/b", "/radii/0",        "/radii/1"};
    double least = 0;
    for (int i = 0; i < 4; i++) {
        least = fmax(least, 0x1p-44 * largest_part(task->polygon[i]));
    }
    for (int i = 0; i < 9; i++) {
        if (sizes[i] > 0 && sizes[i] < least) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", names[i], sizes[i], least,
                             "TOO_SMALL: %.6g is lost in the rounding of coordinates of this size; "
                             "move the origin near, or take more than %.6g",
                             sizes[i], least);
        }
    }
    return TAUT_OK;
}

taut_status taut_pipe_settle(taut_pipe_task *task, taut_error *error)
{
    if (task->problem->axis != TAUT_PIPE_POLYGON) {
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
        const double rounding = 0x1p-50 * fmax(largest_part(a), largest_part(b)) / task->scale;
        task->handles[side] = taut_norm(task->edges[2 * side]);
        if (!(task->handles[side] > rounding)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "no-solution",
                             side == 0 ? "/polygon/1" : "/polygon/2",
                             task->scale * task->handles[side], task->scale * rounding,
                             "DEGENERATE_EDGE: V_%d and V_%d coincide, so that pipe %d has no "
                             "direction: move them apart",
                             2 * side, 2 * side + 1, side + 1);
        }
    }
    return check_sizes(task, error);
}
