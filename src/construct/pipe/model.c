#include "construct/pipe/model.h"

#include "core/fail.h"
#include "core/vec3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What the surfaces share while they are made. */
typedef struct model_maker {
    const taut_pipe_task *task;
    const taut_pipe_blend *blend;
    const taut_basis *u, *line, *v; /* of the blend, of the straight pipes, of all rings */
    double *points;                 /* double[rows][TAUT_PIPE_RING][3], absolute */
    double *weights;                /* double[rows][TAUT_PIPE_RING] */
    taut_model *model;
} model_maker;

taut_status taut_pipe_add_surface(taut_model *model, const char *name, const taut_basis *u,
                                  const taut_basis *v, const double *points, const double *weights,
                                  taut_error *error)
{
    taut_surface *surface = NULL;
    const taut_status status = taut_surface_new(name, u, v, points, weights, &surface, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

taut_status taut_pipe_add_curve(taut_model *model, const char *name, const taut_basis *t,
                                const double *points, taut_error *error)
{
    taut_curve *curve = NULL;
    const taut_status status = taut_curve_new(name, t, points, NULL, &curve, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_model_add_curve(model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

/* Points 0 and 4 of a ring lie opposite each other on it. */
void taut_pipe_cap_points(const double *ring, int side, double points[2][TAUT_PIPE_RING][3])
{
    double(*const centre)[3] = points[side];
    memcpy(points[1 - side], ring, sizeof points[0]);
    for (int j = 0; j < TAUT_PIPE_RING; j++) {
        for (int k = 0; k < 3; k++) {
            centre[j][k] = 0.5 * (ring[k] + ring[12 + k]);
        }
    }
}

/* A surface ruled from one ring to another. */
static taut_status add_rings(model_maker *m, const char *name, double points[2][TAUT_PIPE_RING][3],
                             taut_error *error)
{
    return taut_pipe_add_surface(m->model, name, m->line, m->v, &points[0][0][0], m->weights,
                                 error);
}

/* Straight pipe `side`: the ring of the blend, and the same moved along the axis. */
static taut_status add_straight(model_maker *m, int side, taut_error *error)
{
    const taut_pipe_task *task = m->task;
    const double *const ring =
        m->points + (side == 0 ? 0 : (size_t)(m->blend->rows - 1) * TAUT_PIPE_RING * 3);
    const double length =
        task->problem->lengths[side] > 0 ? task->problem->lengths[side] : 3 * task->outer;
    double points[2][TAUT_PIPE_RING][3], end[TAUT_PIPE_RING][3];
    taut_pipe_jet jet;

    taut_pipe_arc_jet(&task->arc, side, &jet);
    memcpy(points[side == 0], ring, sizeof points[0]);
    for (int j = 0; j < TAUT_PIPE_RING; j++) {
        for (int k = 0; k < 3; k++) {
            points[side][j][k] = ring[3 * j + k] + (side == 0 ? -length : length) * jet.tangent[k];
        }
    }
    const taut_status status = add_rings(m, side == 0 ? "pipe1" : "pipe2", points, error);
    if (status != TAUT_OK || !task->problem->caps) {
        return status;
    }
    memcpy(end, points[side], sizeof end);
    taut_pipe_cap_points(&end[0][0], side, points);
    return add_rings(m, side == 0 ? "cap1" : "cap2", points, error);
}

/* The six points of a quintic: those of the polygon, and one inside either end edge. */
static void set_quintic_points(const taut_pipe_task *task, double points[6][3])
{
    static const int places[4] = {0, 2, 3, 5};
    const double first = (3 + task->shape[0]) / 4, last = (3 + task->shape[2]) / 4;
    for (int i = 0; i < 4; i++) {
        memcpy(points[places[i]], task->polygon[i], sizeof points[0]);
    }
    for (int k = 0; k < 3; k++) {
        points[1][k] = task->polygon[0][k] + first * (task->polygon[1][k] - task->polygon[0][k]);
        points[4][k] = task->polygon[3][k] - last * (task->polygon[3][k] - task->polygon[2][k]);
    }
}

taut_status taut_pipe_add_axis(const taut_pipe_task *task, const char *name, taut_model *model,
                               taut_error *error)
{
    const double *shape = task->shape;
    const int quintic = task->problem->joint == TAUT_PIPE_G2;
    const taut_basis_spec quasi = {
        .type = "ce-bezier", .alpha = shape[0], .beta = shape[1], .gamma = shape[2]};
    const taut_basis_spec bezier = {.type = "bezier", .degree = 5};
    double points[6][3];
    const taut_basis *t = NULL;
    const taut_status status = quintic ? taut_pipe_basis(&bezier, 6, task->arena, &t, error)
                                       : taut_pipe_basis(&quasi, 4, task->arena, &t, error);
    if (status != TAUT_OK) {
        return status;
    }
    set_quintic_points(task, points);
    return taut_pipe_add_curve(model, name, t, quintic ? &points[0][0] : &task->polygon[0][0],
                               error);
}

/* The coefficients of t^4, t^3, ... of P - V_0, one list per coordinate ([WangBai2018] section
 * 3.2): for reading, never for evaluation. */
static void add_power(const taut_pipe_task *task, taut_record *details)
{
    static const char *const names[] = {"x", "y", "z"};
    taut_record *power = taut_record_add_object(details, "power");
    const double a = task->shape[0], b = task->shape[1], c = task->shape[2];
    for (int k = 0; k < 3; k++) {
        const double e1 = task->scale * task->edges[0][k], e2 = task->scale * task->edges[1][k],
                     e3 = task->scale * task->edges[2][k];
        /* P' = f1 e1 + f2 e2 + f3 e3 (section 2.3), integrated */
        const double values[5] = {
            -a * e1 - b * e2 + c * e3,
            (1 + 3 * a) * e1 + 2 * (b - 1) * e2 + (1 - c) * e3,
            -3 * (1 + a) * e1 + (3 - b) * e2,
            (3 + a) * e1,
            0,
        };
        taut_record_add_numbers(power, names[k], 5, values);
    }
}

static void add_warnings(const taut_pipe_task *task, taut_record *details)
{
    static const char *const names[] = {"alpha", "beta", "gamma"};
    taut_record *warnings = NULL;
    for (int k = 0; k < 3; k++) {
        if (fabs(task->shape[k]) > (k == 1 ? 3 : 1) && !(k != 1 && task->shape[k] < 0)) {
            char text[128];
            snprintf(text, sizeof text,
                     "%s is %g, outside [-3, %d]: the axis may leave the hull of its polygon",
                     names[k], task->shape[k], k == 1 ? 3 : 1);
            warnings = warnings != NULL ? warnings : taut_record_add_list(details, "warnings");
            taut_record_add_text(warnings, NULL, text);
        }
    }
}

void taut_pipe_add_axis_details(const taut_pipe_task *task, taut_record *details)
{
    taut_record *list = taut_record_add_list(details, "polygon");
    for (int i = 0; i < 4; i++) {
        taut_record_add_numbers(list, NULL, 3, task->polygon[i]);
    }
    list = taut_record_add_object(details, "shape");
    taut_record_add_number(list, "alpha", task->shape[0]);
    taut_record_add_number(list, "beta", task->shape[1]);
    taut_record_add_number(list, "gamma", task->shape[2]);
    list = taut_record_add_list(details, "handles");
    for (int side = 0; side < 2; side++) {
        taut_record_add_number(list, NULL, task->scale * task->handles[side]);
    }
}

static void add_section(const taut_pipe_section *section, taut_record *details)
{
    if (section->kind == TAUT_PIPE_ELLIPTIC) {
        taut_record *const list = taut_record_add_list(details, "sections");
        for (int side = 0; side < 2; side++) {
            const taut_pipe_ellipse *ellipse = &section->ellipses[side];
            taut_record *const item = taut_record_add_object(list, NULL);
            taut_record_add_number(item, "a", ellipse->a);
            taut_record_add_number(item, "b", ellipse->b);
            taut_record_add_numbers(item, "direction", 3, ellipse->direction);
        }
    } else if (section->kind != TAUT_PIPE_ROUND) {
        taut_record_add_numbers(details, "radii", 2, section->radii);
        taut_record_add_text(details, "surface",
                             section->kind == TAUT_PIPE_CANAL ? "canal" : "naive-sweep");
    }
}

static taut_record *details_of(const taut_pipe_task *task, const taut_pipe_blend *blend)
{
    const taut_pipe_problem *p = task->problem;
    taut_record *details = taut_record_new(), *list = NULL;

    taut_record_add_number(details, "radius", task->outer);
    taut_pipe_add_axis_details(task, details);
    taut_record_add_text(details, "domain", p->shape.extended ? "extended" : "strict");
    taut_record_add_text(details, "joint", p->joint == TAUT_PIPE_G1 ? "g1" : "g2");
    taut_record_add_text(details, "frame",
                         p->frame == TAUT_PIPE_FRENET ? "frenet" : "rotation-minimizing");
    add_section(&p->section, details);
    list = taut_record_add_list(details, "pipe_lengths");
    for (int side = 0; side < 2; side++) {
        if (p->lengths[side] > 0) {
            taut_record_add_number(list, NULL, p->lengths[side]);
        } else {
            taut_record_add_null(list, NULL);
        }
    }
    if (task->chose_shape) {
        taut_record_add_text(details, "chosen_shape",
                             p->shape.kind == TAUT_PIPE_LEAST_CURVATURE ? "curvature" : "bending");
    }
    if (task->evaluations > 0) {
        taut_record_add_number(details, "evaluations", task->evaluations);
    }
    taut_record_add_number(details, "segments", blend->segments);
    taut_record_add_bool(details, "turns_less_than_pi", task->reach.shortcut);
    list = taut_record_add_list(details, task->arc.degree == 5 ? "quintic" : "quartic");
    for (int i = 0; i <= task->arc.degree; i++) {
        double q[3];
        for (int k = 0; k < 3; k++) {
            q[k] = task->polygon[0][k] + task->scale * task->arc.points[i][k];
        }
        taut_record_add_numbers(list, NULL, 3, q);
    }
    if (p->joint == TAUT_PIPE_G1) {
        add_power(task, details);
    }
    add_warnings(task, details);
    return details;
}

static taut_status begin_maker(model_maker *m, taut_error *error)
{
    taut_arena *const arena = m->task->arena;
    const size_t count = (size_t)m->blend->rows * TAUT_PIPE_RING;
    taut_status status = taut_pipe_basis_u(&m->task->arc, m->blend, arena, &m->u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_basis_line(arena, &m->line, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_basis_v(arena, &m->v, error);
    if (status != TAUT_OK) {
        return status;
    }
    m->points = taut_arena_take(arena, 3 * count, sizeof *m->points);
    m->weights = taut_arena_take(arena, count, sizeof *m->weights);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; i < 3 * count; i++) {
        m->points[i] = m->task->polygon[0][i % 3] + m->task->scale * m->blend->points[i];
    }
    taut_pipe_straighten(&m->task->arc, m->blend, m->task->outer, m->points);
    taut_pipe_weights(m->blend->rows, m->weights);
    return TAUT_OK;
}

static taut_status fill_model(model_maker *m, taut_error *error)
{
    taut_record *details = NULL;
    taut_status status =
        taut_pipe_add_surface(m->model, "blend", m->u, m->v, m->points, m->weights, error);
    for (int side = 0; side < 2 && status == TAUT_OK; side++) {
        status = add_straight(m, side, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_add_axis(m->task, "axis", m->model, error);
    if (status != TAUT_OK) {
        return status;
    }
    details = details_of(m->task, m->blend);
    taut_model_set_details(m->model, details);
    return taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_pipe_to_model(const taut_pipe_task *task, const taut_pipe_blend *blend,
                               taut_model **model, taut_error *error)
{
    model_maker m = {.task = task, .blend = blend};
    taut_status status = begin_maker(&m, error);
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
