/* bonnet.c -- construct `bonnet`: checks what is asked for (check.c), then coefficients, net,
 * surface, frame by frame. */
#include "taut/bonnet.h"

#include "construct/bonnet/check.h"
#include "construct/bonnet/net.h"
#include "construct/construct_ops.h"
#include "core/arena.h"
#include "core/fail.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

/* Rows of five functions in each direction. */
static taut_status take_rows(taut_arena *arena, int count, taut_bonnet_rows *rows,
                             taut_error *error)
{
    double *all = taut_arena_take(arena, 5 * (size_t)count, sizeof(double));
    if (all == NULL) {
        return taut_fail_memory(error);
    }
    *rows = (taut_bonnet_rows){count,
                               all,
                               all + count,
                               all + 2 * (long)count,
                               all + 3 * (long)count,
                               all + 4 * (long)count};
    return TAUT_OK;
}

/* The specs of the bases of one frame. */
static void specs_of(const taut_bonnet_problem *problem, double lambda, taut_basis_spec *u,
                     taut_basis_spec *v)
{
    const double w = problem->normalize ? sqrt((1 - lambda) * (1 + lambda)) : 1;
    const double scale = w > 0 ? w : 1;
    const double lengths[2] = {problem->alpha * scale, problem->beta * scale};
    taut_basis_spec *specs[2] = {u, v};

    for (int d = 0; d < 2; d++) {
        const int segments = problem->segments[d] > 0 ? problem->segments[d] : 1;
        taut_basis_spec spec = {.has_range = 1};
        spec.range[0] = problem->start[d] * scale;
        spec.range[1] = spec.range[0] + segments * lengths[d];
        if (!(w > 0)) {
            spec.type = "bezier";
            spec.degree = 3;
        } else if (problem->bspline) {
            spec.type = d == 0 ? "c-bspline" : "h-bspline";
            spec.segments = segments;
        } else {
            spec.type = d == 0 ? "c-bezier" : "h-bezier";
        }
        if (w > 0) {
            *(d == 0 ? &spec.alpha : &spec.beta) = lengths[d];
        }
        *specs[d] = spec;
    }
}

static void fill_net(const taut_bonnet_problem *problem, double lambda, taut_bonnet_rows *u,
                     taut_bonnet_rows *v, double *points)
{
    const double w = sqrt((1 - lambda) * (1 + lambda));
    const double *start = problem->start;
    if (problem->normalize && lambda == 1) {
        const double p[2] = {start[0], start[0] + problem->alpha};
        const double q[2] = {start[1], start[1] + problem->beta};
        taut_bonnet_enneper_net(problem->theta, p, q, points);
    } else if (problem->normalize) {
        taut_bonnet_bezier_rows(0, w * start[0], w * problem->alpha, u);
        taut_bonnet_bezier_rows(1, w * start[1], w * problem->beta, v);
        taut_bonnet_normalised_net(lambda, problem->theta, u, v, points);
    } else {
        if (problem->bspline) {
            taut_bonnet_bspline_rows(0, start[0], problem->alpha, u->count - 3, u);
            taut_bonnet_bspline_rows(1, start[1], problem->beta, v->count - 3, v);
        } else {
            taut_bonnet_bezier_rows(0, start[0], problem->alpha, u);
            taut_bonnet_bezier_rows(1, start[1], problem->beta, v);
        }
        taut_bonnet_net(lambda, problem->sign, problem->theta, u, v, points);
    }
}

/* One frame into the model. */
static taut_status add_frame(const taut_bonnet_problem *problem, double lambda, const char *name,
                             taut_bonnet_rows *u, taut_bonnet_rows *v, double *points,
                             taut_model *model, taut_error *error)
{
    taut_basis_spec spec_u, spec_v;
    taut_basis *basis_u = NULL, *basis_v = NULL;
    taut_surface *surface = NULL;
    taut_status status = TAUT_OK;

    specs_of(problem, lambda, &spec_u, &spec_v);
    fill_net(problem, lambda, u, v, points);
    status = taut_basis_new(&spec_u, u->count, &basis_u, error);
    if (status == TAUT_OK) {
        status = taut_basis_new(&spec_v, v->count, &basis_v, error);
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(name, basis_u, basis_v, points, NULL, &surface, error);
    }
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        status = taut_fail_memory(error);
    }
    taut_basis_free(basis_u);
    taut_basis_free(basis_v);
    return status;
}

static taut_record *details_of(const taut_bonnet_problem *problem, int frames)
{
    taut_record *details = taut_record_new();
    if (problem->frames > 1) {
        taut_record *list = taut_record_add_list(details, "lambda");
        for (int i = 0; i < frames; i++) {
            taut_record_add_number(list, NULL, taut_bonnet_frame_lambda(problem, i));
        }
    } else {
        taut_record_add_number(details, "lambda", problem->lambda[0]);
    }
    taut_record_add_number(details, "amplitude",
                           problem->bspline ? problem->alpha / sin(problem->alpha) : 1);
    if (problem->normalize) {
        taut_record_add_bool(details, "normalize", 1);
    }
    return details;
}

static taut_status fill_model(const taut_bonnet_problem *problem, const taut_monitor *monitor,
                              taut_arena *arena, taut_model *model, taut_error *error)
{
    const int frames = problem->frames > 1 ? problem->frames : 1;
    const int nu = (problem->segments[0] > 0 ? problem->segments[0] : 1) + 3;
    const int nv = (problem->segments[1] > 0 ? problem->segments[1] : 1) + 3;
    double *points = NULL;
    taut_bonnet_rows u, v;
    taut_record *details = NULL;
    taut_status status = TAUT_OK;

    assert((double)frames * nu * nv <= TAUT_POINTS_MAX); /* see taut_bonnet_check */
    points = taut_arena_take(arena, 3 * (size_t)nu * (size_t)nv, sizeof(double));
    status = points != NULL ? take_rows(arena, nu, &u, error) : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = take_rows(arena, nv, &v, error);
    }
    for (int i = 0; i < frames && status == TAUT_OK; i++) {
        char name[32] = "bonnet";
        if (problem->frames > 1) {
            snprintf(name, sizeof name, "frame-%d", i);
        }
        status = add_frame(problem, taut_bonnet_frame_lambda(problem, i), name, &u, &v, points,
                           model, error);
        if (status == TAUT_OK && monitor->progress != NULL &&
            monitor->progress(monitor->context, (i + 1.0) / frames, "frames") != 0) {
            status = taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                               "stopped");
        }
    }
    if (status == TAUT_OK) {
        details = details_of(problem, frames);
        taut_model_set_details(model, details);
        status = taut_record_status(details) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    return status;
}

taut_status taut_bonnet_make(const taut_bonnet_problem *problem, const taut_make_options *options,
                             taut_model **model, taut_error *error)
{
    static const taut_make_options none;
    taut_arena *arena = NULL;
    taut_model *made = NULL;
    taut_status status = TAUT_OK;

    if (problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_bonnet_make needs a problem and a place for the model");
    }
    status = taut_bonnet_check(problem, error);
    if (status != TAUT_OK) {
        return status;
    }
    arena = taut_arena_new();
    if (arena == NULL || taut_model_new(&made) != TAUT_OK) {
        status = taut_fail_memory(error);
    } else {
        status =
            fill_model(problem, &(options != NULL ? options : &none)->monitor, arena, made, error);
    }
    taut_arena_free(arena);
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    *model = made;
    return TAUT_OK;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_bonnet_make(data, options, model, error);
}

const taut_construct_ops taut_construct_bonnet = {.make = make};
