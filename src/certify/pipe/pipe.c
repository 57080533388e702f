/* pipe.c -- the certificate of `pipe`: from the finished surfaces and their axis alone.
 *
 *     joint1, joint2  the blend meets the straight pipes, with equal normals    joint.c
 *     curvature1, -2  equal principal curvatures; about a quintic               joint.c
 *     embedded        radius over the largest radius of the composite axis      reach.c
 *     tube            the surfaces are at the radius from the axis              tube.c
 *     regular, graph  of a canal surface                                        envelope.c
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
static const double radii_drawn = 3; /* of a straight pipe without a length */

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

/* How far the first point of the far ring of a straight pipe is from the joint, along it; local. */
static double length_shown(const taut_pipe_parts *parts, int side)
{
    const taut_pipe_line *line = &parts->line;
    const taut_surface *pipe = parts->pipes[side];
    const int rows = taut_basis_count(taut_surface_u(pipe));
    const size_t around = (size_t)taut_basis_count(taut_surface_v(pipe));
    const double *far =
        taut_surface_points(pipe) + (side == 0 ? 0 : 3 * around * (size_t)(rows - 1));
    const taut_pipe_piece *piece = &line->pieces[side == 0 ? 0 : line->count - 1];
    double x[3], way[3];
    taut_pipe_to_local(line, far, x);
    taut_difference(x, piece->points[side == 0 ? 0 : piece->degree], way);
    return fabs(taut_dot(way, line->tangent[side]));
}

/* The lengths of the straight pipes: the problem's; without it those that their rings show, as half
 * lines where they are drawn as half lines are and the model does not say that they are not. */
static void find_lengths(const taut_model *model, taut_pipe_parts *parts)
{
    const taut_record *told = taut_record_get(taut_model_details(model), "pipe_lengths");
    const taut_pipe_problem *problem = parts->problem;
    const double radius = parts->radius / parts->line.scale, half_line = radii_drawn * radius;
    for (int side = 0; side < 2; side++) {
        const double shown = length_shown(parts, side);
        const double asked = problem != NULL ? problem->lengths[side] / parts->line.scale : shown;
        const int is_endless =
            problem != NULL ? !(asked > 0)
                            : !(taut_record_number(taut_record_at(told, (size_t)side)) > 0) &&
                                  fabs(shown - half_line) <= tolerance_default * radius;
        parts->line.lengths[side] = is_endless ? INFINITY : asked;
        parts->drawn[side] = is_endless ? half_line : asked;
    }
}

/* The lengths of the straight pipes, the radius of a round one: the problem's, or what the model
 * shows. */
static taut_status find_data(const taut_model *model, taut_pipe_parts *parts, taut_error *error)
{
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
        taut_pipe_add_sizes(parts->pipes[side], parts);
    }
    taut_pipe_add_sizes(parts->blend, parts);
    status = taut_pipe_read_sections(model, parts);
    if (status == TAUT_OK && !(parts->radius > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/surfaces/0", parts->radius, 0,
                         "the blend begins on its own axis: it has no radius");
    }
    find_lengths(model, parts);
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
    taut_pipe_add_torsion(figures, f->torsion);
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
    if (parts->canal) {
        status = taut_pipe_claim_envelope(parts, certificate);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_claim_caps(model, parts, parts->pipes, NULL, certificate);
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
                               const taut_audit *audit, taut_certificate *certificate,
                               taut_error *error)
{
    const double tolerance = audit->tolerance > 0 ? audit->tolerance : tolerance_default;
    taut_status status = taut_pipe_line_of(parts->axis, arena, &parts->line, error);
    if (status != TAUT_OK) {
        return status;
    }
    parts->axes = &parts->axis;
    parts->axis_count = 1;
    status = find_data(model, parts, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_find_figures(parts);
    if (status != TAUT_OK || taut_crew_beat(parts->crew, TAUT_PULSE_WORK)) {
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
                               const taut_audit *audit, taut_certificate *certificate,
                               taut_error *error)
{
    const taut_pipe_run_problem *asked = request != NULL && request->is_run ? &request->run : NULL;
    taut_pipe_run_problem other;
    if (request != NULL && !request->is_run) {
        other = run_of_blend(&request->blend);
        asked = &other;
    }
    return taut_pipe_claim_run(model, asked, audit, certificate, error);
}

/* The largest coordinate of a surface or curve. */
static double largest_of(const double *points, int count)
{
    double largest = 0;
    for (int i = 0; i < 3 * count; i++) {
        largest = fmax(largest, fabs(points[i]));
    }
    return largest;
}

/* Models are looked at in units of their own size, of which the inverse must be a number too. */
static taut_status check_range(const taut_model *model, taut_error *error)
{
    static const double least = 0x1p-1000, most = 0x1p1000;
    double size = 0;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const taut_surface *s = taut_model_surface(model, i);
        size =
            fmax(size, largest_of(taut_surface_points(s), taut_basis_count(taut_surface_u(s)) *
                                                              taut_basis_count(taut_surface_v(s))));
    }
    for (int i = 0; i < taut_model_curve_count(model); i++) {
        const taut_curve *c = taut_model_curve(model, i);
        size = fmax(size, largest_of(taut_curve_points(c), taut_basis_count(taut_curve_t(c))));
    }
    if (size > 0 && (size < least || size > most)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/surfaces", size,
                         size < least ? least : most,
                         "the largest coordinate of the model is %g; pipes are judged from %.1e to "
                         "%.1e",
                         size, least, most);
    }
    return TAUT_OK;
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    const taut_pipe_request *request = data;
    taut_pipe_problem asked;
    taut_pipe_parts parts = {.crew = &audit->crew};
    taut_arena *arena = NULL;
    taut_status status = check_range(model, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (taut_pipe_is_run(model)) {
        return certify_run(model, request, audit, certificate, error);
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
    status = claim_blend(model, &parts, arena, audit, certificate, error);
    taut_arena_free(arena);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

/* Along a straight pipe, along a blend, around either; the axis of a blend. */
static const taut_expected_basis along_pipe = {.type = "bezier", .degree = {1, 1}};
static const taut_expected_basis along_blend = {.type = "bspline"};
static const taut_expected_basis along_arc = {.type = "bezier", .degree = {2, 2}};
static const taut_expected_basis around = {.type = "bspline"};

static taut_expected_basis axis_with(taut_pipe_joint joint)
{
    return joint == TAUT_PIPE_G2 ? (taut_expected_basis){.type = "bezier", .degree = {5, 5}}
                                 : (taut_expected_basis){.type = "ce-bezier"};
}

/* In the order of flow: straight pipe i, where it has a length, is before blend i. */
static void identify_run(const taut_pipe_run_problem *problem, taut_identity *identity)
{
    const char *told =
        taut_record_text(taut_record_get(taut_model_details(identity->model), "elbow"));
    const int arcs = problem != NULL ? problem->elbow == TAUT_PIPE_ELBOW_ARC
                                     : told != NULL && strcmp(told, "arc") == 0;
    const taut_expected_basis bent =
        arcs ? along_arc : axis_with(problem != NULL ? problem->joint : TAUT_PIPE_G1);
    const taut_expected_basis *along = arcs ? &along_arc : &along_blend;
    const double told_wall =
        taut_record_number(taut_record_get(taut_model_details(identity->model), "wall"));
    const int walled = (problem != NULL ? problem->wall : told_wall) > 0;
    int blends = 0;
    for (int i = 0; i < taut_model_surface_count(identity->model); i++) {
        const char *name = taut_surface_name(taut_model_surface(identity->model, i));
        const int is_blend = strncmp(name, "blend", 5) == 0;
        char piece[32], axis[64];
        if (!is_blend && strncmp(name, "pipe", 4) != 0) {
            continue;
        }
        snprintf(piece, sizeof piece, "%s%d", is_blend ? "blend" : "pipe", blends + 1);
        snprintf(axis, sizeof axis, "axis-%s", name);
        taut_identity_surface(identity, i, piece, is_blend ? along : &along_pipe, &around);
        taut_identity_curve(identity, taut_identity_find_curve(identity, axis), axis,
                            is_blend ? &bent : &along_pipe);
        blends += is_blend;
        if (walled) {
            snprintf(axis, sizeof axis, "inner-%s", piece);
            taut_identity_surface(identity, taut_identity_find_surface(identity, axis), axis,
                                  is_blend ? along : &along_pipe, &around);
        }
    }
}

static void identify_blend(const taut_pipe_problem *problem, taut_identity *identity)
{
    static const char *const names[3] = {"blend", "pipe1", "pipe2"};
    const taut_expected_basis axis = axis_with(problem != NULL ? problem->joint : TAUT_PIPE_G1);

    for (int k = 0; k < 3; k++) {
        taut_identity_surface(identity, taut_identity_find_surface(identity, names[k]), names[k],
                              k == 0 ? &along_blend : &along_pipe, &around);
    }
    taut_identity_curve(identity, taut_identity_find_curve(identity, "axis"), "axis", &axis);
}

static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    static const char *const caps[2] = {"cap1", "cap2"};
    const taut_pipe_request *request = data;
    int has_caps = 0;

    if (request != NULL ? request->is_run : taut_pipe_is_run(model)) {
        identify_run(request != NULL ? &request->run : NULL, identity);
    } else {
        identify_blend(request != NULL ? &request->blend : NULL, identity);
    }
    if (request != NULL) {
        has_caps = request->is_run
                       ? (request->run.caps || request->run.wall > 0) && !request->run.route.closed
                       : request->blend.caps;
    }
    for (int side = 0; side < 2; side++) {
        const int at = taut_identity_find_surface(identity, caps[side]);
        if (has_caps || (request == NULL && at >= 0)) {
            taut_identity_surface(identity, at, caps[side], &along_pipe, &around);
        }
    }
}

const taut_certify_ops taut_certify_pipe = {.certify = certify, .identify = identify};

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
