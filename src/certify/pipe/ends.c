/* ends.c -- is it the pipe that was asked for?
 *
 *   ends     the larger of: distances of the axis from the given points or lines, and of handles
 *            from given ones, over the radius; sines between its ends and the given directions;
 *            differences of given shape numbers
 *   optimal  where the shape was chosen: the largest part of the goal that a neighbour in the legal
 *            box would save, of the 26 neighbours at each of two distances that leave room for the
 *            pipe
 */
#include "certify/pipe/parts.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The distance of x from the line through p along d. */
static double distance_from_line(const double x[3], const double p[3], const double d[3])
{
    double w[3];
    taut_difference(x, p, w);
    taut_add_scaled(-taut_dot(w, d), d, w);
    return taut_norm(w);
}

/* How far end `side` of the axis is from where it was asked to be. */
static double end_residual(const taut_pipe_parts *parts, int side)
{
    const taut_pipe_axis *axis = &parts->problem->axis;
    const taut_pipe_end *end = &axis->ends[side];
    const double *points = &parts->polygon[0][0], *x = points + 9 * side;
    double d[3], worst = 0;
    taut_pipe_unit(end->direction, d);
    worst = taut_distance(parts->line.tangent[side], d);
    if (end->handle > 0) {
        const double handle = taut_distance(points + 6 * side, points + 6 * side + 3);
        worst = fmax(worst, fabs(handle - end->handle) / parts->radius);
    }
    return fmax(worst, (axis->kind == TAUT_PIPE_ENDS ? taut_distance(x, end->point)
                                                     : distance_from_line(x, end->point, d)) /
                           parts->radius);
}

static double ends_residual(const taut_pipe_parts *parts)
{
    const double *shape = parts->shape;
    const taut_pipe_problem *p = parts->problem;
    double worst = parts->quintic == (p->joint == TAUT_PIPE_G2) ? 0 : 1;
    if (p->axis.kind == TAUT_PIPE_POLYGON) {
        for (int i = 0; i < 4; i++) {
            worst =
                fmax(worst, taut_distance(parts->polygon[i], p->axis.polygon[i]) / parts->radius);
        }
    } else {
        worst = fmax(worst, fmax(end_residual(parts, 0), end_residual(parts, 1)));
    }
    if (p->shape.kind == TAUT_PIPE_SHAPE_GIVEN) {
        worst = fmax(worst,
                     fmax(fabs(shape[0] - p->shape.alpha),
                          fmax(fabs(shape[1] - p->shape.beta), fabs(shape[2] - p->shape.gamma))));
    }
    return worst;
}

/* A rounding of each coordinate over the handle, and over the radius; lines are as good as the
 * distance to their points. A given polygon is kept bit for bit. */
static double ends_noise(const taut_pipe_parts *parts)
{
    const taut_pipe_problem *p = parts->problem;
    const double *points = &parts->polygon[0][0];
    const double none[3] = {0, 0, 0};
    double noise = 2 * DBL_EPSILON, far = 0, sine = 1, shape = 0;
    for (int side = 0; side < 2 && parts->quintic; side++) { /* shape numbers, read off points */
        shape += 16 * DBL_EPSILON *
                 (1 + parts->size / taut_distance(points + 6 * side, points + 6 * side + 3));
    }
    if (p->axis.kind == TAUT_PIPE_POLYGON) {
        return shape;
    }
    for (int side = 0; side < 2; side++) {
        noise += taut_pipe_sideways(parts, side, none) /
                 taut_distance(points + 6 * side, points + 6 * side + 3);
        if (p->axis.ends[side].handle > 0) {
            noise += 4 * DBL_EPSILON * (parts->size + p->axis.ends[side].handle) / parts->radius;
        }
        for (int k = 0; k < 3; k++) {
            far = fmax(far, fmax(fabs(p->axis.ends[side].point[k]), parts->sizes[k]));
        }
    }
    if (p->axis.kind == TAUT_PIPE_FEET) { /* nearly parallel lines place their feet badly */
        double a[3], b[3], n[3];
        taut_pipe_unit(p->axis.ends[0].direction, a);
        taut_pipe_unit(p->axis.ends[1].direction, b);
        taut_cross(a, b, n);
        sine = fmax(taut_norm(n), 1e-9);
        noise += 4 * DBL_EPSILON * far / (parts->radius * sine);
    }
    return noise + shape;
}

taut_status taut_pipe_claim_ends(const taut_pipe_parts *parts, taut_certificate *certificate)
{
    return taut_pipe_add_claim("ends", TAUT_EXACT, ends_residual(parts), 0, ends_noise(parts), "",
                               certificate);
}

/* The goal about a curve, and whether the pipe has room there: asked only where the goal is below
 * `bound`. INFINITY where it has none. */
static taut_status find_goal(const taut_pipe_parts *parts, taut_pipe_line *line, double bound,
                             double *goal)
{
    const double room = 0.999; /* what a choice leaves: docs/pipe.md */
    const int sharpest = parts->problem->shape.kind == TAUT_PIPE_LEAST_CURVATURE;
    taut_pipe_figures figures = {.rho = 0};
    taut_status status = TAUT_OK;

    memcpy(line->lengths, parts->line.lengths, sizeof line->lengths);
    if (sharpest) {
        taut_pipe_bound_curvature(line, &figures);
        *goal = figures.curvature;
    } else {
        taut_pipe_integrate(line, &figures);
        *goal = figures.bending;
    }
    if (!(*goal < bound)) {
        return TAUT_OK;
    }
    if (!sharpest) {
        taut_pipe_bound_curvature(line, &figures);
    }
    status = taut_pipe_bound_reach(line, &figures);
    if (!(parts->radius < room * figures.rho * line->scale)) {
        *goal = INFINITY;
    }
    return status;
}

static taut_status find_goal_of_curve(const taut_pipe_parts *parts, const taut_curve *curve,
                                      taut_arena *arena, double bound, double *goal,
                                      taut_error *error)
{
    taut_pipe_line line;
    const taut_status status = taut_pipe_line_of(curve, arena, &line, error);
    return status == TAUT_OK ? find_goal(parts, &line, bound, goal) : status;
}

/* The goal with other shape numbers. */
static taut_status goal_of(const taut_pipe_parts *parts, const double shape[3], double bound,
                           double *goal, taut_error *error)
{
    taut_curve *curve = NULL;
    taut_arena *arena = NULL;
    taut_status status = taut_pipe_axis_with(parts, shape, &curve, error);
    if (status != TAUT_OK) {
        return status;
    }
    arena = taut_arena_new();
    status = find_goal_of_curve(parts, curve, arena, bound, goal, error);
    taut_arena_free(arena);
    taut_curve_free(curve);
    return status;
}

enum { GOAL_WORK = 2500000 }; /* operations that find one goal, as pulses count them */
static const double low[3] = {-3, -3, -3}, high[3] = {1, 3, 1};

/* Neighbour `code` (three digits to base 3) at a part `step` of the box; 0 where it is outside or
 * the point itself. */
static int neighbour(const double shape[3], int code, double step, double out[3])
{
    int moved = 0;
    for (int k = 0; k < 3; k++, code /= 3) {
        out[k] = shape[k] + (code % 3 - 1) * step * (high[k] - low[k]);
        if (out[k] > high[k] || out[k] < low[k] + (k == 1 ? 0 : 0.01)) {
            return 0;
        }
        moved += code % 3 != 1;
    }
    return moved > 0;
}

taut_status taut_pipe_claim_optimal(const taut_pipe_parts *parts, taut_certificate *certificate,
                                    taut_error *error)
{
    static const double steps[] = {1.0 / 64, 1.0 / 4096};
    const double limit = 1e-13; /* rounding of the quadrature: a few hundred terms */
    const double *shape = parts->shape;
    double here = 0, saved = 0;
    char where[96] = "";
    taut_status status = goal_of(parts, shape, 0, &here, error);

    for (int i = 0; i < 54 && status == TAUT_OK && here > 0; i++) {
        double other[3], there = 0;
        if (!neighbour(shape, i % 27, steps[i / 27], other) || (parts->quintic && other[1] != 0)) {
            continue;
        }
        status = goal_of(parts, other, here, &there, error);
        if (taut_crew_beat(parts->crew, GOAL_WORK)) {
            return TAUT_INTERRUPTED;
        }
        if (status == TAUT_OK && (here - there) / here > saved) {
            saved = (here - there) / here;
            snprintf(where, sizeof where, "alpha = %.6g, beta = %.6g, gamma = %.6g", other[0],
                     other[1], other[2]);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    return taut_pipe_add_claim("optimal", TAUT_CHECK, isfinite(saved) ? saved : 1, limit, limit,
                               where, certificate);
}
