/* pipe.c -- the certificate of `pipe`: from the finished surfaces and their axis alone.
 *
 *     joint1, joint2  the blend meets the straight pipes, with equal normals    joint.c
 *     curvature1, -2  equal principal curvatures; about a quintic               joint.c
 *     embedded        radius over the largest radius of the composite axis      reach.c
 *     tube            the surfaces are at the radius from the axis              tube.c
 *     ends            the axis starts and ends as asked; with a problem         ends.c
 *     optimal         no neighbour of chosen shape numbers is better            ends.c
 *
 * A run of many has claims of its own: run.c.
 *
 * Limits are what rounding of the control points explains, at most 1e-6 (docs/pipe.md); where it
 * explains more, the claim is open.
 */
#include "taut/pipe.h"

#include "certify/certify_ops.h"
#include "certify/pipe/parts.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "problem/pipe.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double tolerance_default = 1e-6;

static taut_status find_parts(const taut_model *model, taut_pipe_parts *parts, taut_error *error)
{
    parts->blend = taut_pipe_find_surface(model, "blend");
    parts->pipes[0] = taut_pipe_find_surface(model, "pipe1");
    parts->pipes[1] = taut_pipe_find_surface(model, "pipe2");
    parts->axis = taut_pipe_find_curve(model, "axis");
    if (parts->blend == NULL || parts->pipes[0] == NULL || parts->pipes[1] == NULL ||
        parts->axis == NULL) {
        return taut_fail(
            error, TAUT_BAD_INPUT, "missing", "", taut_none, taut_none,
            "a pipe has surfaces \"blend\", \"pipe1\", \"pipe2\" and a curve \"axis\"");
    }
    return taut_pipe_read_axis(parts, error);
}

/* The lengths of the straight pipes, the radius of a round one: the problem's, or what the model
 * shows. */
static taut_status find_data(const taut_model *model, taut_pipe_parts *parts, taut_error *error)
{
    const taut_record *lengths = taut_record_get(taut_model_details(model), "pipe_lengths");
    const taut_pipe_problem *problem = parts->problem;
    double x[3];
    taut_status status = TAUT_OK;
    taut_surface_eval(parts->blend, taut_basis_lo(taut_surface_u(parts->blend)),
                      taut_basis_lo(taut_surface_v(parts->blend)), 0, x);
    parts->radius =
        problem == NULL
            ? taut_pipe_radius_told(model, taut_distance(x, taut_curve_points(parts->axis)))
        : problem->section.kind == TAUT_PIPE_ROUND ? problem->section.radius
                                                   : 0;
    for (int side = 0; side < 2; side++) {
        const double length = problem != NULL
                                  ? problem->lengths[side]
                                  : taut_record_number(taut_record_at(lengths, (size_t)side));
        parts->line.lengths[side] = length > 0 ? length / parts->line.scale : INFINITY;
        taut_pipe_add_sizes(parts->pipes[side], parts);
    }
    taut_pipe_add_sizes(parts->blend, parts);
    status = taut_pipe_read_sections(model, parts);
    if (status == TAUT_OK && !(parts->radius > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/surfaces/0", parts->radius, 0,
                         "the blend begins on its own axis: it has no radius");
    }
    return status;
}

static taut_status claim_embedded(const taut_pipe_parts *parts, taut_certificate *certificate)
{
    const taut_pipe_figures *f = &parts->figures;
    const double scale = parts->line.scale;
    char where[96] = "";

    if (isfinite(f->rho) && f->by_distance) {
        snprintf(where, sizeof where, "arc lengths %.9g and %.9g from the start of the blend",
                 f->binding[0] * scale, f->binding[1] * scale);
    } else if (isfinite(f->rho)) {
        snprintf(where, sizeof where, "the curvature at t = %.9g", f->curvature_at);
    }
    return taut_pipe_claim_embedded(parts, where, certificate);
}

static taut_record *figures_of(const taut_pipe_parts *parts, double fit_error)
{
    const taut_pipe_figures *f = &parts->figures;
    const double scale = parts->line.scale, a = parts->radius;
    const double length = f->length * scale;
    const double ends[2] = {f->ends[0] / scale, f->ends[1] / scale};
    taut_record *figures = taut_record_new(), *list = NULL;

    taut_record_add_number(figures, "length", length);
    taut_record_add_number(figures, "max_curvature", f->curvature / scale);
    taut_record_add_number(figures, "max_curvature_at", f->curvature_at);
    taut_record_add_number(figures, "total_curvature", f->turning);
    taut_record_add_number(figures, "total_torsion", f->torsion);
    taut_record_add_number(figures, "bending", f->bending / scale);
    taut_record_add_number(figures, "largest_radius", f->rho * scale);
    if (parts->canal) {
        double measures[2];
        taut_pipe_canal_measures(parts, &measures[0], &measures[1]);
        taut_record_add_number(figures, "area", measures[0]);
        taut_record_add_number(figures, "volume", measures[1]);
    } else if (parts->ellipses[0].a > 0) {
        taut_record_add_number(figures, "area", taut_pipe_section_area(parts));
        taut_record_add_number(figures, "volume", taut_pipe_section_volume(parts));
        if (!parts->unlike) {
            taut_record_add_number(figures, "section_turn", parts->turn);
        }
    } else {
        taut_record_add_number(figures, "area", 2 * TAUT_PI * a * length);
        taut_record_add_number(figures, "volume", TAUT_PI * a * a * length);
    }
    taut_record_add_numbers(figures, "joint_curvature", 2, ends);
    list = taut_record_add_list(figures, "joint_jump");
    for (int side = 0; side < 2; side++) { /* of the principal curvatures, the largest */
        taut_record_add_number(list, NULL,
                               a * ends[side] < 1 ? ends[side] / (1 - a * ends[side]) : INFINITY);
    }
    taut_record_add_number(figures, "fit_error", fit_error);
    taut_record_add_text(figures, "binding",
                         !isfinite(f->rho) ? "none"
                         : f->by_distance  ? "distance"
                                           : "curvature");
    return figures;
}

static taut_status add_claims(const taut_model *model, const taut_pipe_parts *parts,
                              double tolerance, taut_certificate *certificate, taut_error *error)
{
    const taut_pipe_problem *problem = parts->problem;
    taut_record *figures = NULL;
    double fit_error = 0;
    taut_status status = TAUT_OK;

    for (int side = 0; side < 2 && status == TAUT_OK; side++) {
        status = taut_pipe_claim_joint(parts, side, certificate);
    }
    for (int side = 0; side < 2 && status == TAUT_OK && parts->quintic; side++) {
        status = taut_pipe_claim_curvature(parts, side, certificate);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = claim_embedded(parts, certificate);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_claim_tube(parts, tolerance, &fit_error, certificate);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_claim_caps(model, parts, parts->pipes, certificate);
    if (status == TAUT_OK && problem != NULL) {
        status = taut_pipe_claim_ends(parts, certificate);
    }
    if (status == TAUT_OK && problem != NULL && problem->shape.kind != TAUT_PIPE_SHAPE_GIVEN) {
        status = taut_pipe_claim_optimal(parts, certificate, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    figures = figures_of(parts, fit_error);
    taut_certificate_set_figures(certificate, figures);
    return taut_record_status(figures);
}

static taut_status claim_blend(const taut_model *model, taut_pipe_parts *parts, taut_arena *arena,
                               const taut_certify_options *options, taut_certificate *certificate,
                               taut_error *error)
{
    const double tolerance = options->tolerance > 0 ? options->tolerance : tolerance_default;
    taut_status status = taut_pipe_line_of(parts->axis, arena, &parts->line, error);
    if (status != TAUT_OK) {
        return status;
    }
    parts->line.flat = parts->quintic;
    status = find_data(model, parts, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_find_figures(parts);
    if (status != TAUT_OK) {
        return status;
    }
    return add_claims(model, parts, tolerance, certificate, error);
}

/* What a blend is held against where a run was asked for: the same radius, joints and shape, and
 * ends that it does not have. */
static taut_pipe_problem blend_of_run(const taut_pipe_run_problem *run)
{
    return (taut_pipe_problem){.axis = {.kind = TAUT_PIPE_ENDS},
                               .section = {.kind = TAUT_PIPE_ROUND, .radius = run->radius},
                               .shape = run->shape,
                               .joint = run->joint,
                               .bend_radius = run->bend_radius};
}

/* The other way round: a run of no pipes. */
static taut_pipe_run_problem run_of_blend(const taut_pipe_problem *blend)
{
    const taut_pipe_section *s = &blend->section;
    return (taut_pipe_run_problem){.route = {.kind = TAUT_PIPE_LEGS},
                                   .radius = s->kind == TAUT_PIPE_ROUND ? s->radius : 0,
                                   .bend_radius = blend->bend_radius};
}

static taut_status certify_run(const taut_model *model, const taut_pipe_request *request,
                               const taut_certify_options *options, taut_certificate *certificate,
                               taut_error *error)
{
    const taut_pipe_run_problem *asked = request != NULL && request->is_run ? &request->run : NULL;
    taut_pipe_run_problem other;
    if (request != NULL && !request->is_run) {
        other = run_of_blend(&request->blend);
        asked = &other;
    }
    return taut_pipe_claim_run(model, asked, options, certificate, error);
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    const taut_pipe_request *request = data;
    taut_pipe_problem asked;
    taut_pipe_parts parts = {.size = 0};
    taut_arena *arena = NULL;
    taut_status status = TAUT_OK;

    if (taut_pipe_is_run(model)) {
        return certify_run(model, request, options, certificate, error);
    }
    if (request != NULL) {
        asked = request->is_run ? blend_of_run(&request->run) : request->blend;
        parts.problem = &asked;
    }
    status = find_parts(model, &parts, error);
    if (status != TAUT_OK) {
        return status;
    }
    arena = taut_arena_new();
    status = claim_blend(model, &parts, arena, options, certificate, error);
    taut_arena_free(arena);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

const taut_certify_ops taut_certify_pipe = {.certify = certify};

taut_status taut_pipe_certify(const taut_model *model, const taut_pipe_problem *problem,
                              const taut_certify_options *options, taut_certificate **certificate,
                              taut_error *error)
{
    taut_pipe_request request = {.is_run = 0};
    if (problem != NULL) {
        request.blend = *problem;
    }
    return taut_certify_with(&taut_certify_pipe, "pipe", model, problem != NULL ? &request : NULL,
                             options, certificate, error);
}

taut_status taut_pipe_run_certify(const taut_model *model, const taut_pipe_run_problem *problem,
                                  const taut_certify_options *options,
                                  taut_certificate **certificate, taut_error *error)
{
    taut_pipe_request request = {.is_run = 1};
    if (problem != NULL) {
        request.run = *problem;
    }
    return taut_certify_with(&taut_certify_pipe, "pipe", model, problem != NULL ? &request : NULL,
                             options, certificate, error);
}
