/* run_arc.c -- elbows that are arcs.
 *
 * The axis is the rational curve of degree 2 on V_0, the corner and V_3 with the weights 1, cos(A / 2), 1; the
 * tube about it a piece of a torus on the rings at both ends and one between, whose points are where the
 * tangents of the circles that the others go along meet.
 */
#include "construct/pipe/model.h"
#include "construct/pipe/run.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROWS = 3, HERMITE = 7 };

static const double part_angle = TAUT_PI / 12; /* within 2e-12 of a polynomial of degree 7 */

static void make_unit(double v[3])
{
    const double size = taut_norm(v);
    for (int k = 0; k < 3; k++) {
        v[k] /= size;
    }
}

void taut_pipe_round_settle(const double from[3], const double to[3], taut_pipe_elbow *elbow)
{
    const double(*polygon)[3] = (const double(*)[3])elbow->problem.axis.polygon;
    taut_pipe_round *const round = &elbow->round;
    double sine = 0;
    taut_cross(from, to, round->axis);
    sine = taut_norm(round->axis);
    round->angle = taut_atan2(sine, taut_dot(from, to));
    /* the handle over tan(angle / 2) */
    round->radius = taut_distance(polygon[0], polygon[1]) * (1 + taut_dot(from, to)) / sine;
    make_unit(round->axis);
    memcpy(round->ahead, from, sizeof round->ahead);
    taut_cross(from, round->axis, round->out);
    make_unit(round->out);
    memcpy(round->centre, polygon[0], sizeof round->centre);
    taut_add_scaled(-round->radius, round->out, round->centre);
}

/* The direction from the centre at an angle, and that of flow there. */
static void directions_at(const taut_pipe_round *round, double angle, double out[3],
                          double ahead[3])
{
    const double c = taut_cos(angle), s = taut_sin(angle);
    for (int k = 0; k < 3; k++) {
        out[k] = c * round->out[k] + s * round->ahead[k];
        ahead[k] = c * round->ahead[k] - s * round->out[k];
    }
}

/* The polynomial of degree 7 with point and three derivatives of the arc at both its ends: of n = 7,
 *     b_i = sum over k of C(i, k) (n - k)! / n! P^(k),  and from the other end with (-1)^k */
static void fit_part(const taut_pipe_round *round, const double origin[3], double scale, double lo,
                     double hi, taut_pipe_arc *arc)
{
    static const double chosen[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    static const double falling[4] = {1, 7, 42, 210};
    const double step = hi - lo, radius = round->radius / scale;
    arc->degree = HERMITE;
    for (int end = 0; end < 2; end++) {
        const double by = end == 0 ? step : -step;
        double out[3], ahead[3];
        directions_at(round, end == 0 ? lo : hi, out, ahead);
        for (int i = 0; i < 4; i++) {
            double *const point = arc->points[end == 0 ? i : HERMITE - i];
            double power = radius;
            for (int k = 0; k < 3; k++) {
                point[k] = (round->centre[k] - origin[k]) / scale;
            }
            for (int k = 0; k <= i; k++) { /* derivatives: out, ahead, -out, -ahead */
                taut_add_scaled((k < 2 ? 1 : -1) * power * chosen[i][k] / falling[k],
                                k % 2 == 0 ? out : ahead, point);
                power *= by;
            }
        }
    }
    taut_pipe_arc_finish(arc);
}

int taut_pipe_round_parts(const taut_pipe_round *round, const double origin[3], double scale,
                          taut_pipe_arc parts[TAUT_PIPE_ROUND_PARTS])
{
    const int count = (int)ceil(round->angle / part_angle);
    for (int i = 0; i < count; i++) {
        fit_part(round, origin, scale, round->angle * i / count, round->angle * (i + 1) / count,
                 &parts[i]);
    }
    return count;
}

/* A ring across the axis at an angle, its first vector u, spread from the axis of the turn by `reach`. */
static void set_ring(const taut_pipe_run *run, const taut_pipe_round *round, double angle,
                     const double u[3], double reach, double points[TAUT_PIPE_RING][3])
{
    static const double places[TAUT_PIPE_RING][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                                     {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    const double a = run->problem->radius;
    double out[3], ahead[3], w[3];
    directions_at(round, angle, out, ahead);
    taut_cross(ahead, u, w);
    for (int j = 0; j < TAUT_PIPE_RING; j++) {
        double way[3] = {0, 0, 0};
        taut_add_scaled(round->radius, out, way);
        taut_add_scaled(a * places[j][0], u, way);
        taut_add_scaled(a * places[j][1], w, way);
        taut_add_scaled((reach - 1) * taut_dot(way, out), out, way);
        for (int k = 0; k < 3; k++) {
            points[j][k] = round->centre[k] + way[k];
        }
    }
}

/* u made a unit vector across a direction. */
static void put_across(const double direction[3], double u[3])
{
    for (int round = 0; round < 2; round++) { /* again: what rounding left */
        taut_add_scaled(-taut_dot(u, direction), direction, u);
        make_unit(u);
    }
}

taut_status taut_pipe_round_sweep(taut_pipe_run *run, taut_pipe_elbow *elbow, double u[3],
                                  taut_error *error)
{
    const taut_pipe_round *const round = &elbow->round;
    double(*rings)[TAUT_PIPE_RING][3] = taut_arena_take(run->arena, ROWS, sizeof *rings);
    if (rings == NULL) {
        return taut_fail_memory(error);
    }
    put_across(round->ahead, u);
    const double along_out = taut_dot(u, round->out), along_axis = taut_dot(u, round->axis);
    for (int i = 0; i < ROWS; i++) {
        const double angle = 0.5 * i * round->angle;
        double out[3], ahead[3], turned[3];
        directions_at(round, angle, out, ahead);
        for (int k = 0; k < 3; k++) {
            turned[k] = along_out * out[k] + along_axis * round->axis[k];
        }
        set_ring(run, round, angle, turned, i == 1 ? 1 / taut_cos(angle) : 1, rings[i]);
        memcpy(u, turned, sizeof turned);
    }
    elbow->points = &rings[0][0][0];
    elbow->blend.rows = ROWS;
    return TAUT_OK;
}

taut_status taut_pipe_round_add(const taut_pipe_run *run, const taut_pipe_elbow *elbow,
                                const char *name, const taut_basis *v, taut_model *model,
                                taut_error *error)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = 2};
    const double middle = taut_cos(0.5 * elbow->round.angle), along[ROWS] = {1, middle, 1};
    const double(*polygon)[3] = (const double(*)[3])elbow->problem.axis.polygon;
    double weights[ROWS * TAUT_PIPE_RING], points[ROWS][3];
    const taut_basis *u = NULL;
    taut_curve *axis = NULL;
    char axis_name[40];
    taut_status status = taut_pipe_basis(&spec, ROWS, run->arena, &u, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_pipe_weights(ROWS, weights);
    for (int j = 0; j < TAUT_PIPE_RING; j++) {
        weights[TAUT_PIPE_RING + j] *= middle;
    }
    status = taut_pipe_add_surface(model, name, u, v, elbow->points, weights, error);
    if (status != TAUT_OK || strcmp(name, elbow->name) != 0) {
        return status;
    }
    memcpy(points[0], polygon[0], sizeof points[0]);
    memcpy(points[1], polygon[1], sizeof points[0]);
    memcpy(points[2], polygon[3], sizeof points[0]);
    snprintf(axis_name, sizeof axis_name, "axis-%s", elbow->name);
    status = taut_curve_new(axis_name, u, &points[0][0], along, &axis, error);
    if (status == TAUT_OK && taut_model_add_curve(model, axis) != TAUT_OK) {
        taut_curve_free(axis);
        return taut_fail_memory(error);
    }
    return status;
}
