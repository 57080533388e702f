/* run_model.c -- the surfaces and axes of a run, in the order of flow. */
#include "construct/pipe/model.h"
#include "construct/pipe/run.h"
#include "core/fail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { RING = 3 * TAUT_PIPE_RING };

typedef struct run_maker {
    const taut_pipe_run *run;
    const char *prefix;         /* of names: "", or "inner-", which has no axes of its own */
    const taut_basis *line, *v; /* along straight pipes, of all rings */
    taut_model *model;
} run_maker;

static taut_status add_surface(run_maker *m, const char *name, const taut_basis *u, int rows,
                               const double *points, taut_error *error)
{
    double *const weights =
        taut_arena_take(m->run->arena, (size_t)rows * TAUT_PIPE_RING, sizeof *weights);
    if (weights == NULL) {
        return taut_fail_memory(error);
    }
    taut_pipe_weights(rows, weights);
    return taut_pipe_add_surface(m->model, name, u, m->v, points, weights, error);
}

static const double *last_ring(const taut_pipe_elbow *e)
{
    return e->points + (size_t)(e->blend.rows - 1) * RING;
}

/* The rings of straight pipe i: those of the elbows at its ends, at free ends moved along it. */
static void set_rings(const taut_pipe_run *run, int i, double (*points)[TAUT_PIPE_RING][3])
{
    const taut_pipe_straight *s = &run->straights[i];
    const int before = run->closed ? (i + run->elbow_count - 1) % run->elbow_count : i - 1;
    if (before >= 0) {
        memcpy(points[0], last_ring(&run->elbows[before]), sizeof points[0]);
    }
    if (i < run->elbow_count) {
        memcpy(points[1], run->elbows[i].points, sizeof points[1]);
    }
    for (int j = 0; j < RING; j++) {
        const double way = s->to[j % 3] - s->from[j % 3];
        if (before < 0) {
            points[0][j / 3][j % 3] = points[1][j / 3][j % 3] - way;
        } else if (i >= run->elbow_count) {
            points[1][j / 3][j % 3] = points[0][j / 3][j % 3] + way;
        }
    }
}

static taut_status add_straight(run_maker *m, int i, taut_error *error)
{
    const taut_pipe_straight *const s = &m->run->straights[i];
    double points[2][TAUT_PIPE_RING][3], ends[2][3];
    char name[32], axis[40];
    taut_status status = TAUT_OK;
    if (!(s->length > 0)) {
        return TAUT_OK;
    }
    snprintf(name, sizeof name, "%spipe%d", m->prefix, i + 1);
    snprintf(axis, sizeof axis, "axis-pipe%d", i + 1);
    set_rings(m->run, i, points);
    status = add_surface(m, name, m->line, 2, &points[0][0][0], error);
    if (status != TAUT_OK || m->prefix[0] != '\0') {
        return status;
    }
    memcpy(ends[0], s->from, sizeof ends[0]);
    memcpy(ends[1], s->to, sizeof ends[1]);
    return taut_pipe_add_curve(m->model, axis, m->line, &ends[0][0], error);
}

static taut_status add_elbow(run_maker *m, const taut_pipe_elbow *e, taut_error *error)
{
    const taut_basis *u = NULL;
    char name[32], axis[40];
    snprintf(name, sizeof name, "%s%s", m->prefix, e->name);
    if (e->round.angle > 0) {
        return taut_pipe_round_add(m->run, e, name, m->v, m->model, error);
    }
    taut_status status = taut_pipe_basis_u(&e->task.arc, &e->blend, m->run->arena, &u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = add_surface(m, name, u, e->blend.rows, e->points, error);
    if (status != TAUT_OK || m->prefix[0] != '\0') {
        return status;
    }
    snprintf(axis, sizeof axis, "axis-%s", e->name);
    return taut_pipe_add_axis(&e->task, axis, m->model, error);
}

/* A disc over each free end, or, with a wall, a ring: the rings there are those of the first and the last of
 * `count` surfaces, and of as many after them. */
static taut_status add_caps(run_maker *m, int count, taut_error *error)
{
    const int walled = m->run->inner != NULL;
    taut_status status = TAUT_OK;
    for (int side = 0; side < 2 && status == TAUT_OK; side++) {
        double points[2][TAUT_PIPE_RING][3];
        const int first = side == 0 ? 0 : count - 1;
        for (int inside = 0; inside <= walled; inside++) {
            const taut_surface *end = taut_model_surface(m->model, first + inside * count);
            const int row = side == 0 ? 0 : taut_basis_count(taut_surface_u(end)) - 1;
            const double *ring = taut_surface_points(end) + (size_t)row * RING;
            if (inside) {
                memcpy(points[side], ring, sizeof points[0]);
            } else {
                taut_pipe_cap_points(ring, side, points);
            }
        }
        status = add_surface(m, side == 0 ? "cap1" : "cap2", m->line, 2, &points[0][0][0], error);
    }
    return status;
}

static void add_elbow_details(const taut_pipe_elbow *e, taut_record *list)
{
    const taut_pipe_task *task = &e->task;
    taut_record *const item = taut_record_add_object(list, NULL);
    taut_record_add_text(item, "surface", e->name);
    if (e->round.angle > 0) {
        taut_record *const points = taut_record_add_list(item, "polygon");
        for (int i = 0; i < 4; i++) {
            taut_record_add_numbers(points, NULL, 3, e->problem.axis.polygon[i]);
        }
        taut_record_add_number(item, "radius", e->round.radius);
        taut_record_add_number(item, "angle", e->round.angle);
        return;
    }
    taut_pipe_add_axis_details(task, item);
    taut_record_add_number(item, "least_bend_radius",
                           task->bend.curvature > 0 ? task->scale / task->bend.curvature
                                                    : INFINITY);
    taut_record_add_number(item, "segments", e->blend.segments);
}

static taut_record *details_of(const taut_pipe_run *run)
{
    taut_record *details = taut_record_new(), *list = NULL;
    taut_record_add_number(details, "radius", run->problem->radius);
    if (run->problem->wall > 0) {
        taut_record_add_number(details, "wall", run->problem->wall);
    }
    if (run->bend_radius > 0) {
        taut_record_add_number(details, "bend_radius", run->bend_radius);
    }
    taut_record_add_bool(details, "closed", run->closed);
    taut_record_add_text(details, "joint", run->problem->joint == TAUT_PIPE_G1 ? "g1" : "g2");
    if (run->problem->elbow == TAUT_PIPE_ELBOW_ARC) {
        taut_record_add_text(details, "elbow", "arc");
    }
    if (run->closed) {
        taut_record_add_number(details, "holonomy", run->holonomy);
    }
    list = taut_record_add_list(details, "blends");
    for (int i = 0; i < run->elbow_count; i++) {
        add_elbow_details(&run->elbows[i], list);
    }
    return details;
}

static taut_status add_pieces(run_maker *m, taut_error *error)
{
    const taut_pipe_run *const run = m->run;
    taut_status status = TAUT_OK;
    for (int i = 0; i < run->straight_count && status == TAUT_OK; i++) {
        status = add_straight(m, i, error);
        if (status == TAUT_OK && i < run->elbow_count) {
            status = add_elbow(m, &run->elbows[i], error);
        }
    }
    return status;
}

static taut_status fill_model(run_maker *m, taut_error *error)
{
    const taut_pipe_run *const run = m->run;
    taut_record *details = NULL;
    taut_status status = add_pieces(m, error);
    const int count = taut_model_surface_count(m->model);
    if (status == TAUT_OK && run->inner != NULL) {
        run_maker inside = *m;
        inside.run = run->inner;
        inside.prefix = "inner-";
        status = add_pieces(&inside, error);
    }
    if (status == TAUT_OK && !run->closed && (run->problem->caps || run->inner != NULL)) {
        status = add_caps(m, count, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    details = details_of(run);
    taut_model_set_details(m->model, details);
    return taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_pipe_run_model(taut_pipe_run *run, taut_model **model, taut_error *error)
{
    run_maker m = {.run = run, .prefix = ""};
    taut_status status = taut_pipe_basis_line(run->arena, &m.line, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_basis_v(run->arena, &m.v, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_new(&m.model) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = fill_model(&m, error);
    if (status != TAUT_OK) {
        taut_model_free(m.model);
        return status;
    }
    *model = m.model;
    return TAUT_OK;
}
