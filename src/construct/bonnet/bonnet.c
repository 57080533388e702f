/* bonnet.c -- construct `bonnet`: checks what is asked for, then coefficients, net, surface, one
 * surface after the other. */
#include "taut/bonnet.h"

#include "construct/bonnet/net.h"
#include "construct/common/build.h"
#include "construct/construct_ops.h"
#include "core/constants.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

/* F_0^4, which curvatures divide by, must stay finite: cosh(177)^4 does; on Enneper's surface
 * (1 + q^2)^4. */
static const double farthest = 177, farthest_enneper = 1e30;
/* A window this far from zero, in units of its own length, is a point in double precision. */
static const double farthest_start = 1e12;

static taut_status check_lambda(const taut_bonnet_problem *problem, taut_error *error)
{
    for (int i = 0; i < 2; i++) {
        const double lambda = problem->lambda[i];
        const char *where = problem->frames > 1 ? (i == 0 ? "/lambda/0" : "/lambda/1") : "/lambda";
        if (!isfinite(lambda)) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, lambda, 1,
                             "lambda is not a finite number");
        }
        if (lambda < 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "lambda", where, lambda, 0,
                             "lambda is %.17g, expected 0 or more: the other sign is this surface "
                             "turned by pi about the y axis",
                             lambda);
        }
        if (lambda > 1) {
            return taut_fail(error, TAUT_NO_SOLUTION, "lambda", where, lambda, 1,
                             "lambda is %.17g, expected less than 1 (or 1 with \"normalize\": "
                             "true): beyond, 1 - lambda^2 has no real root",
                             lambda);
        }
        if (lambda == 1 && !problem->normalize) {
            return taut_fail(
                error, TAUT_NO_SOLUTION, "lambda", where, lambda, 1,
                "lambda is %.17g, expected less than 1, where the surface grows without "
                "bound: \"normalize\": true has lambda = 1, Enneper's surface",
                lambda);
        }
    }
    return TAUT_OK;
}

/* w of the first frame that needs the longest window: lambda is monotone, so at an end. */
static double widest_scale(const taut_bonnet_problem *problem)
{
    const double lambda = fmin(problem->lambda[0], problem->lambda[problem->frames > 1]);
    return sqrt((1 - lambda) * (1 + lambda));
}

static taut_status check_lengths(const taut_bonnet_problem *problem, taut_error *error)
{
    if (!(problem->alpha > 0) || !isfinite(problem->alpha)) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", "/alpha", problem->alpha,
                                  "a positive length", "alpha is %.17g", problem->alpha);
    }
    if (!(problem->beta > 0) || !isfinite(problem->beta)) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", "/beta", problem->beta,
                                  "a positive length", "beta is %.17g", problem->beta);
    }
    if (!isfinite(problem->start[0]) || !isfinite(problem->start[1]) || !isfinite(problem->theta)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "", taut_none, taut_none,
                         "a number is not finite");
    }
    if (problem->bspline && problem->alpha >= TAUT_PI) {
        return taut_fail(error, TAUT_NO_SOLUTION, "segment-length", "/alpha", problem->alpha,
                         TAUT_PI,
                         "alpha is %.17g, expected less than pi, where the four functions of a "
                         "c-bspline become dependent: use more segments",
                         problem->alpha);
    }
    if (!problem->bspline && !problem->normalize && problem->alpha > TAUT_PI) {
        return taut_fail(error, TAUT_BAD_INPUT, "segment-length", "/alpha", problem->alpha, TAUT_PI,
                         "alpha is %.17g, expected at most pi for one c-bezier segment: use "
                         "\"mesh\": \"bspline\" with more segments",
                         problem->alpha);
    }
    if (problem->normalize && widest_scale(problem) * problem->alpha > TAUT_PI) {
        return taut_fail(error, TAUT_BAD_INPUT, "segment-length", "/alpha", problem->alpha,
                         TAUT_PI / widest_scale(problem),
                         "alpha is %.17g, expected at most pi / sqrt(1 - lambda^2) = %.6g for one "
                         "segment: make it of two windows",
                         problem->alpha, TAUT_PI / widest_scale(problem));
    }
    return TAUT_OK;
}

/* Where v ends: refused at the member that is to blame, its start where that is beyond already. */
static taut_status check_far(const taut_bonnet_problem *problem, double scale, taut_error *error)
{
    const int segments = problem->segments[1] > 0 ? problem->segments[1] : 1;
    const double start = problem->start[1], end = start + problem->beta * segments;
    const double most = scale > 0 ? fmin(farthest / scale, farthest_enneper) : farthest_enneper;

    if (fabs(start) > most) {
        return taut_fail(error, TAUT_NO_SOLUTION, "far-window", "/start/1", start, most,
                         "the window begins at v = %.6g, expected at most %.6g in size: beyond, "
                         "curvatures overflow. Begin nearer to 0, where the surface has its waist",
                         start, most);
    }
    if (fabs(end) > most) {
        return taut_fail(error, TAUT_NO_SOLUTION, "far-window", "/beta", end, most,
                         "the window reaches v = %.6g, expected at most %.6g in size: beyond, "
                         "curvatures overflow. From its start a beta of up to %.6g will do",
                         end, most, (most - start) / segments);
    }
    return TAUT_OK;
}

/* The window must be on this side of where numbers end. */
static taut_status check_window(const taut_bonnet_problem *problem, taut_error *error)
{
    const double lengths[2] = {problem->alpha, problem->beta};
    const double scale = problem->normalize ? widest_scale(problem) : 1;

    for (int d = 0; d < 2; d++) {
        if (fabs(problem->start[d]) > farthest_start * lengths[d]) {
            return taut_fail(error, TAUT_BAD_INPUT, "far-window", d == 0 ? "/start/0" : "/start/1",
                             problem->start[d], farthest_start * lengths[d],
                             "the window begins at %.6g, expected at most %g of its lengths from "
                             "zero: u may be moved by 2 pi",
                             problem->start[d], farthest_start);
        }
    }
    if (problem->normalize && fabs(problem->start[0]) + problem->alpha > farthest_enneper) {
        return taut_fail(error, TAUT_NO_SOLUTION, "far-window", "/alpha", problem->alpha,
                         farthest_enneper,
                         "the window reaches %.6g in p, expected at most %g: beyond, curvatures "
                         "overflow",
                         fabs(problem->start[0]) + problem->alpha, farthest_enneper);
    }
    return check_far(problem, scale, error);
}

/* Control points of all frames together. */
static double count_points(const taut_bonnet_problem *problem)
{
    const double frames = problem->frames > 1 ? problem->frames : 1;
    return frames * (fmax(problem->segments[0], 1) + 3) * (fmax(problem->segments[1], 1) + 3);
}

static taut_status check_rest(const taut_bonnet_problem *problem, taut_error *error)
{
    if (problem->sign != 1 && problem->sign != -1) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/sign", problem->sign, 1,
                         "expected \"+\" or \"-\"");
    }
    if (problem->normalize && (problem->sign != -1 || problem->bspline)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", problem->bspline ? "/mesh" : "/sign",
                         taut_none, taut_none,
                         "the normalised family has sign \"-\" and mesh \"bezier\"");
    }
    if (!problem->bspline && (problem->segments[0] > 1 || problem->segments[1] > 1)) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/segments", taut_none, taut_none,
                         "the quasi-Bezier mesh has one segment: use \"mesh\": \"bspline\"");
    }
    if (problem->segments[0] < 0 || problem->segments[1] < 0 ||
        problem->segments[0] > TAUT_COUNT_MAX / 2 || problem->segments[1] > TAUT_COUNT_MAX / 2 ||
        problem->frames < 0 || problem->frames > TAUT_OBJECTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/segments", taut_none, TAUT_COUNT_MAX / 2,
                         "segments and frames must be at least 1 and not more than taut takes");
    }
    if (count_points(problem) > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size",
                         problem->frames > 1 ? "/frames" : "/segments", count_points(problem),
                         TAUT_POINTS_MAX,
                         "the surfaces have %.0f points in all, expected at most %d",
                         count_points(problem), TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

/* What [XuWang2006] asks of the parameters (section 8 of the page), each refused by name with the
 * way out. */
static taut_status check_problem(const taut_bonnet_problem *problem, taut_error *error)
{
    taut_status (*const checks[])(const taut_bonnet_problem *, taut_error *) = {
        check_lambda, check_lengths, check_rest, check_window};
    taut_status status = TAUT_OK;

    for (size_t i = 0; i < sizeof checks / sizeof checks[0] && status == TAUT_OK; i++) {
        status = checks[i](problem, error);
    }
    return status;
}

/* Rows of five functions in each direction. */
static void make_rows(taut_arena *arena, int count, taut_bonnet_rows *rows)
{
    *rows = (taut_bonnet_rows){.count = count};
    for (int k = 0; k < 5; k++) {
        double **const row[] = {&rows->t, &rows->s, &rows->c, &rows->f, &rows->g};
        *row[k] = taut_arena_take(arena, (size_t)count, sizeof(double));
    }
}

/* The specs of the bases of one surface. */
static void fill_specs(const taut_bonnet_problem *problem, double lambda, taut_basis_spec specs[2])
{
    const double w = problem->normalize ? sqrt((1 - lambda) * (1 + lambda)) : 1;
    const double scale = w > 0 ? w : 1;
    const double lengths[2] = {problem->alpha * scale, problem->beta * scale};

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
        specs[d] = spec;
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

static taut_record *details_of(const taut_bonnet_problem *problem)
{
    taut_record *details = taut_record_new();
    if (problem->frames > 1) {
        taut_record *list = taut_record_add_list(details, "lambda");
        for (int i = 0; i < problem->frames; i++) {
            taut_record_add_number(list, NULL, taut_bonnet_frame_lambda(problem, i));
        }
    } else {
        taut_record_add_number(details, "lambda", problem->lambda[0]);
    }
    taut_record_add_number(details, "amplitude",
                           problem->bspline ? problem->alpha / taut_sin(problem->alpha) : 1);
    if (problem->normalize) {
        taut_record_add_bool(details, "normalize", 1);
    }
    return details;
}

/* The surfaces, one after the other on the same scratch. */
static taut_status add_surfaces(const taut_bonnet_problem *problem, const taut_monitor *monitor,
                                taut_arena *arena, taut_model *model, taut_error *error)
{
    const int frames = problem->frames > 1 ? problem->frames : 1;
    const int counts[2] = {(problem->segments[0] > 0 ? problem->segments[0] : 1) + 3,
                           (problem->segments[1] > 0 ? problem->segments[1] : 1) + 3};
    double *points =
        taut_arena_take(arena, 3 * (size_t)counts[0] * (size_t)counts[1], sizeof(double));
    taut_bonnet_rows u, v;

    assert((double)frames * counts[0] * counts[1] <= TAUT_POINTS_MAX); /* see check_rest */
    make_rows(arena, counts[0], &u);
    make_rows(arena, counts[1], &v);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < frames; i++) {
        const double lambda = taut_bonnet_frame_lambda(problem, i);
        taut_basis_spec specs[2];
        char name[32] = "bonnet";
        taut_status status = TAUT_OK;
        if (problem->frames > 1) {
            snprintf(name, sizeof name, "frame-%d", i);
        }
        fill_specs(problem, lambda, specs);
        fill_net(problem, lambda, &u, &v, points);
        status = taut_construct_add_net(model, name, specs, counts, points, NULL, NULL, error);
        if (status != TAUT_OK) {
            return status;
        }
        if (monitor != NULL && monitor->progress != NULL &&
            monitor->progress(monitor->context, (i + 1.0) / frames, "frames") != 0) {
            return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                             "stopped");
        }
    }
    return TAUT_OK;
}

typedef struct request {
    const taut_bonnet_problem *problem;
    const taut_monitor *monitor;
} request;

static taut_status fill_model(void *context, taut_arena *arena, taut_model *model,
                              taut_error *error)
{
    const request *asked = context;
    const taut_status status = add_surfaces(asked->problem, asked->monitor, arena, model, error);
    return status == TAUT_OK ? taut_construct_set_details(model, details_of(asked->problem), error)
                             : status;
}

taut_status taut_bonnet_make(const taut_bonnet_problem *problem, const taut_make_options *options,
                             taut_model **model, taut_error *error)
{
    request asked = {problem, options != NULL ? &options->monitor : NULL};
    taut_status status = TAUT_OK;

    if (problem == NULL || model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_bonnet_make needs a problem and a place for the model");
    }
    status = check_problem(problem, error);
    return status == TAUT_OK ? taut_construct_build(fill_model, &asked, model, error) : status;
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_bonnet_make(data, options, model, error);
}

const taut_construct_ops taut_construct_bonnet = {.make = make};
