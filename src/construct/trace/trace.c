/* trace.c -- the construction `trace`: a net of curves on a surface.
 *
 *     1. the surface: of the model, or of what the problem makes
 *     2. the net (trace/net.h)
 *     3. the surface again, a quintic spline a lath, and what is told of them
 */
#include "taut/trace.h"

#include "construct/common/build.h"
#include "construct/common/of.h"
#include "construct/construct_ops.h"
#include "construct/trace/atlas.h"
#include "construct/trace/details.h"
#include "construct/trace/flat.h"
#include "core/fail.h"
#include "core/unit.h"
#include "problem/problem.h"
#include "trace/curve.h"
#include "trace/net.h"
#include "trace/piece.h"
#include "trace/straight.h"
#include "trace/strip.h"

#include <math.h>
#include <string.h>

static const double tolerance_default = 1e-6, step_tolerance = 1e-12, residual = 2e-7, lengths = 20;
/* Of laths, over the size of the surface. */
static const double least_width = 1e-9;

/* Lengths are parameters, which are from 1e-60 to 1e60 (docs/limits.md): of sizes below 2^this. */
enum { EXPONENT_MOST = 150 };

typedef struct request {
    const taut_trace_problem *problem;
    const taut_make_options *options;
} request;

static taut_status check_laths(const taut_trace_laths *laths, taut_error *error)
{
    const struct {
        const char *where, *reason;
        double value;
    } numbers[] = {{"/laths/width", "width", laths->width},
                   {"/laths/thickness", "value", laths->thickness},
                   {"/laths/play", "value", laths->play},
                   {"/laths/material/E", "material", laths->material.e},
                   {"/laths/material/G", "material", laths->material.g},
                   {"/laths/material/strength", "material", laths->material.strength}};
    const int told =
        (laths->material.e > 0) + (laths->material.g > 0) + (laths->material.strength > 0);

    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
        if (!(numbers[k].value >= 0) || isinf(numbers[k].value)) {
            return taut_fail(error, TAUT_BAD_INPUT, numbers[k].reason, numbers[k].where,
                             numbers[k].value, 0, "found %.17g, expected a positive number",
                             numbers[k].value);
        }
    }
    return told == 0 || told == 3
               ? TAUT_OK
               : taut_fail(error, TAUT_BAD_INPUT, "material", "/laths/material", told, 3,
                           "found %d numbers above 0, expected E, G and strength", told);
}

static taut_status check_sheet(const taut_trace_problem *problem, taut_error *error)
{
    const taut_trace_sheet *sheet = problem->sheet;
    const double values[3] = {sheet->size[0], sheet->size[1], sheet->gap};
    for (int k = 0; k < 3; k++) {
        if (!(values[k] >= 0) || isinf(values[k])) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", k < 2 ? "/sheet/size" : "/sheet/gap",
                             values[k], 0, "found %.17g, expected a number that is not negative",
                             values[k]);
        }
    }
    if ((sheet->size[0] > 0) != (sheet->size[1] > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/sheet/size", 0, 0,
                         "found a 0, expected two positive numbers");
    }
    if (problem->laths == NULL || !(problem->laths->width > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "missing", "/laths/width", taut_none, taut_none,
                         "found a sheet, expected laths with a width to cut from it");
    }
    return TAUT_OK;
}

static taut_status check_problem(const taut_trace_problem *problem, taut_error *error)
{
    if (problem == NULL || (problem->model == NULL) == (problem->of == NULL) ||
        problem->seed_count < 0 || (problem->seed_count > 0 && problem->seeds == NULL)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a net needs a model or a problem of its surface, and its seeds");
    }
    if (!(problem->max_length >= 0) || isinf(problem->max_length)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/max_length", problem->max_length, 0,
                         "found %.17g, expected a positive number", problem->max_length);
    }
    if (problem->net == TAUT_TRACE_GEODESIC && problem->seed_count == 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "net", "/seeds", taut_none, taut_none,
                         "geodesics need seeds with a place and a direction");
    }
    if (problem->panels && problem->net != TAUT_TRACE_PRINCIPAL) {
        return taut_fail(error, TAUT_BAD_INPUT, "net", "/panels", taut_none, taut_none,
                         "found panels, which only principal nets have");
    }
    if (problem->sheet != NULL) {
        const taut_status status = check_sheet(problem, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return problem->laths != NULL ? check_laths(problem->laths, error) : TAUT_OK;
}

static taut_status add_lath(const taut_net *net, const taut_lath *lath, taut_arena *arena,
                            taut_model *model, taut_record *domain, taut_error *error)
{
    taut_lath_part *parts = NULL;
    taut_curve *curve = NULL;
    int count = 0;
    taut_status status = taut_lath_parts(net->carrier, lath, arena, &parts, &count, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_curve_new(lath->name, parts[0].basis, parts[0].space, NULL, &curve, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = count > 1; k < count; k++) {
        const char *on = net->carrier_count > 1 ? taut_surface_name(parts[k].on->surface) : NULL;
        taut_construct_add_stretch(domain, lath->name, on, parts[k].basis, parts[k].window);
    }
    return taut_construct_add_curve(model, curve, error);
}

/* Millimetres in the document's unit, which is that of the surface. */
static double of_millimetres(const request *r, double length)
{
    const char *unit =
        r->problem->of != NULL ? r->problem->of->unit : taut_model_unit(r->problem->model);
    return length * taut_unit_ratio("mm", unit);
}

static double play_of(const request *r)
{
    static const double play_default = 0.2; /* mm */
    const taut_trace_laths *laths = r->problem->laths;
    return laths->has_play ? laths->play : fmin(of_millimetres(r, play_default), laths->thickness);
}

/* The flat pieces of laths that have a width. */
static taut_status add_pieces(const request *r, const taut_net *net, const taut_strip *strips,
                              taut_record *details, taut_error *error)
{
    static const double gap_default = 5; /* mm */
    const taut_trace_sheet *sheet = r->problem->sheet;
    const double gap =
        sheet != NULL && sheet->has_gap ? sheet->gap : of_millimetres(r, gap_default);
    taut_pieces pieces;

    if (strips == NULL || !(r->problem->laths->width > 0)) {
        return TAUT_OK;
    }
    const taut_status status =
        taut_pieces_new(net, strips, gap, net->options.tolerance, &pieces, error);
    if (status == TAUT_OK) {
        taut_trace_describe_flat(net, &pieces, details);
    }
    return status;
}

static taut_status add_surfaces(const taut_net *net, taut_model *model, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < net->carrier_count; k++) {
        taut_surface *surface = NULL;
        status = taut_surface_copy(net->carriers[k]->surface, &surface) == TAUT_OK
                     ? taut_construct_add_surface(model, surface, error)
                     : taut_fail_memory(error);
    }
    return status;
}

static taut_status fill(const request *r, const taut_model *of, const taut_net *net,
                        const taut_atlas *atlas, taut_arena *arena, taut_model *model,
                        taut_error *error)
{
    taut_record *details = taut_record_new();
    taut_strip *strips = NULL;

    if (details == NULL) {
        return taut_fail_memory(error);
    }
    taut_status status = add_surfaces(net, model, error);
    if (status == TAUT_OK && r->problem->laths != NULL) {
        status = taut_strips_new(net, play_of(r), &strips, error);
    }
    if (status == TAUT_OK) {
        status = taut_trace_describe(net, strips, details);
        status = status == TAUT_OK ? TAUT_OK : taut_fail_status(error, status);
    }
    taut_atlas_describe(atlas, details);
    if (status == TAUT_OK) {
        status = add_pieces(r, net, strips, details, error);
    }
    taut_record *domain = taut_record_add_list(details, "domain");
    for (int k = 0; status == TAUT_OK && k < net->count; k++) {
        status = add_lath(net, &net->laths[k], arena, model, domain, error);
    }
    if (r->problem->of != NULL) {
        taut_construct_describe_of(r->problem->of, of, details);
    }
    if (status != TAUT_OK) {
        taut_record_free(details);
        return status;
    }
    return taut_construct_set_details(model, details, error);
}

/* Flat pieces of laths as long as the surface are to have sides that differ by more than the rounding of their
 * places on the sheet. */
static taut_status check_width(const taut_trace_laths *laths, const taut_carrier *carrier,
                               taut_error *error)
{
    const double width = laths != NULL ? ldexp(laths->width, -carrier->scale) : 0;
    const double least = least_width * carrier->size;
    if (width > 0 && width < least) {
        return taut_fail(error, TAUT_NO_SOLUTION, "width", "/laths/width", laths->width,
                         ldexp(least, carrier->scale),
                         "found %.6g, expected a width of at least %.3g on a surface that is %.3g "
                         "large",
                         laths->width, ldexp(least, carrier->scale),
                         ldexp(carrier->size, carrier->scale));
    }
    return TAUT_OK;
}

static taut_status build(void *context, taut_arena *arena, taut_model *model, taut_error *error)
{
    const request *r = context;
    const taut_model *of = NULL;
    taut_atlas atlas;
    taut_pulse pulse = {.monitor = &r->options->monitor, .what = "tracing", .done = taut_none};
    taut_net net = {
        .problem = r->problem, .arena = arena, .threads = r->options->threads, .pulse = &pulse};
    taut_status status =
        taut_construct_of(r->problem->model, r->problem->of, r->options, arena, &of, error);

    if (status == TAUT_OK) {
        status = taut_atlas_new(arena, r->problem, of, &atlas, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const taut_carrier *carrier = atlas.carriers[atlas.home];
    if (!(carrier->scale > -EXPONENT_MOST) || !(carrier->scale < EXPONENT_MOST)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "extreme-size", "/of", ldexp(0.5, carrier->scale),
                         ldexp(1, EXPONENT_MOST),
                         "the surface is %.3g large, and lengths along it cannot be parameters",
                         ldexp(carrier->size, carrier->scale));
    }
    if (!(carrier->widest > 0)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "singular", "/of", taut_none, taut_none,
                         "the surface has no normal anywhere");
    }
    status = check_width(r->problem->laths, carrier, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = 0; k < atlas.count; k++) {
        taut_straight_find(atlas.carriers[k]);
    }
    const double most = r->problem->max_length > 0 ? ldexp(r->problem->max_length, -carrier->scale)
                                                   : lengths * carrier->size;
    net.carrier_count = atlas.count;
    net.carriers = atlas.carriers;
    net.carrier = carrier;
    net.options = (taut_lath_options){.follow = {.tolerance = step_tolerance, .max_length = most},
                                      .tolerance = r->options->tolerance > 0 ? r->options->tolerance
                                                                             : tolerance_default,
                                      .residual = residual};
    status = taut_net_trace(&net, &r->options->monitor, error);
    return status == TAUT_OK ? fill(r, of, &net, &atlas, arena, model, error) : status;
}

taut_status taut_trace_make(const taut_trace_problem *problem, const taut_make_options *options,
                            taut_model **model, taut_error *error)
{
    static const taut_make_options none;
    request r = {problem, options != NULL ? options : &none};
    const taut_status status = check_problem(problem, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_trace_make needs a place for the model");
    }
    return taut_construct_build(build, &r, model, error);
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    return taut_trace_make(data, options, model, error);
}

const taut_construct_ops taut_construct_trace = {.make = make};
