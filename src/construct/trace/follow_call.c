/* follow_call.c -- taut_trace_follow: one curve of a field, handed on step by step as it is followed. */
#include "taut/trace.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "trace/follow.h"
#include "trace/straight.h"

#include <math.h>
#include <string.h>

static const double step_tolerance = 1e-12, lengths = 20;

/* Lengths are parameters, which are from 1e-60 to 1e60 (docs/limits.md): of sizes below 2^this. */
enum { EXPONENT_MOST = 150 };

/* Who is handed the steps, and in which unit. */
typedef struct receiver {
    taut_trace_sink *sink;
    void *context;
    const taut_carrier *carrier;
} receiver;

static int hand_on(const receiver *r, const taut_station *at)
{
    const int scale = r->carrier->scale;
    taut_trace_step step = {.s = ldexp(at->s, scale),
                            .at = {at->at[0], at->at[1]},
                            .k_n = ldexp(at->k_n, -scale),
                            .k_g = ldexp(at->k_g, -scale),
                            .tau_g = ldexp(at->tau_g, -scale)};
    taut_carrier_point(r->carrier, at->x, step.point);
    memcpy(step.tangent, at->tangent, sizeof step.tangent);
    memcpy(step.normal, at->normal, sizeof step.normal);
    return r->sink(r->context, &step);
}

static int receive(void *context, const taut_piece *piece)
{
    return hand_on(context, &piece->to);
}

static taut_status check(const taut_carrier *carrier, const double at[2], const double way[2],
                         double max_length, taut_error *error)
{
    if (!(carrier->scale > -EXPONENT_MOST) || !(carrier->scale < EXPONENT_MOST)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "extreme-size", NULL, ldexp(0.5, carrier->scale),
                         ldexp(1, EXPONENT_MOST), "the surface is too large or too small");
    }
    for (int d = 0; d < 2; d++) {
        if (!(at[d] >= carrier->lo[d]) || !(at[d] <= carrier->hi[d])) {
            return taut_fail(error, TAUT_BAD_INPUT, "outside", "/at", at[d],
                             at[d] < carrier->lo[d] ? carrier->lo[d] : carrier->hi[d],
                             "found %s = %.17g, expected a number from %.17g to %.17g",
                             d == 0 ? "u" : "v", at[d], carrier->lo[d], carrier->hi[d]);
        }
    }
    if (!isfinite(way[0]) || !isfinite(way[1]) || (way[0] == 0 && way[1] == 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "direction", "/way", taut_none, taut_none,
                         "found (%g, %g), expected two numbers that are not both 0", way[0],
                         way[1]);
    }
    return max_length >= 0 && isfinite(max_length)
               ? TAUT_OK
               : taut_fail(error, TAUT_BAD_INPUT, "value", "/max_length", max_length, 0,
                           "found %.17g, expected a positive number", max_length);
}

static taut_status no_curve(taut_linefield_fault fault, const double at[2], taut_error *error)
{
    static const char *const reasons[] = {"singular", "elliptic", "flat", "singular", "crease"};
    static const char *const says[] = {
        "the curve has no direction", "the Gauss curvature is positive",
        "both principal curvatures are equal", "the surface has no normal", "the normal jumps"};
    return taut_fail(error, TAUT_NO_SOLUTION, reasons[fault], "/at", taut_none, taut_none,
                     "%s at (%.6g, %.6g)", says[fault], at[0], at[1]);
}

static taut_status follow(taut_arena *arena, const taut_surface *surface, taut_linefield_kind kind,
                          const double at[2], const double way[2], double max_length,
                          const receiver *to, taut_trace_end *end, taut_error *error)
{
    taut_carrier *carrier = NULL;
    taut_walk *walk = taut_arena_take(arena, 1, sizeof *walk);
    double x[TAUT_CARRIER_VECTORS][3], along[3];
    taut_walk_state state;
    taut_station first;
    int span[2];

    if (walk == NULL || taut_carrier_new(arena, surface, &carrier) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_status status = check(carrier, at, way, max_length, error);
    if (status != TAUT_OK) {
        return status;
    }
    receiver own = {to->sink, to->context, carrier};
    const taut_follow_options options = {
        .tolerance = step_tolerance,
        .max_length = max_length > 0 ? ldexp(max_length, -carrier->scale) : lengths * carrier->size,
        .sink = receive,
        .context = &own};
    taut_straight_find(carrier);
    taut_carrier_cell(carrier, at, way, span);
    taut_carrier_at(carrier, span, at, 1, x);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    const taut_linefield_fault fault =
        taut_carrier_is_crease(carrier, at)
            ? TAUT_LINEFIELD_CREASE
            : taut_walk_start(carrier, kind, at, span, along, &state);
    if (fault != TAUT_LINEFIELD_FINE) {
        return no_curve(fault, at, error);
    }
    taut_carrier_cell(carrier, at, state.y + TAUT_WALK_A, span); /* the one that it runs into */
    taut_walk_start(carrier, kind, at, span, along, &state);
    taut_walk_station(kind, &state, &first);
    if (hand_on(&own, &first)) {
        *end = (taut_trace_end){.word = taut_walk_end_word(TAUT_END_SINK), .at = {at[0], at[1]}};
        return TAUT_OK;
    }
    status = taut_follow(kind, &state, &options, arena, walk);
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    if (walk->end == TAUT_END_STALLED) {
        return taut_fail(error, TAUT_NOT_CONVERGED, "stalled", NULL, taut_none, taut_none,
                         "the curve from (%.6g, %.6g) could not be followed beyond (%.6g, %.6g)",
                         at[0], at[1], walk->end_at[0], walk->end_at[1]);
    }
    const double length = walk->count > 0 ? walk->pieces[walk->count - 1].to.s : 0;
    *end = (taut_trace_end){.word = taut_walk_end_word(walk->end),
                            .at = {walk->end_at[0], walk->end_at[1]},
                            .length = ldexp(length, carrier->scale),
                            .steps = walk->count};
    return TAUT_OK;
}

taut_status taut_trace_follow(const taut_surface *surface, taut_trace_net net, int family,
                              const double at[2], const double way[2], double max_length,
                              taut_trace_sink *sink, void *context, taut_trace_end *end,
                              taut_error *error)
{
    const receiver to = {sink, context, NULL};
    const taut_linefield_kind kind = {net, family == 2};
    taut_trace_end found;

    if (surface == NULL || at == NULL || way == NULL || sink == NULL || (int)net < 0 ||
        net > TAUT_TRACE_ISOPARAMETRIC || family < 1 ||
        family > (net == TAUT_TRACE_GEODESIC ? 1 : 2)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_trace_follow needs a surface, a net, a family of it, a place, a "
                         "direction and a sink");
    }
    taut_arena *arena = taut_arena_new();
    const taut_status status =
        arena != NULL ? follow(arena, surface, kind, at, way, max_length, &to, &found, error)
                      : taut_fail_memory(error);
    taut_arena_free(arena);
    if (status == TAUT_OK && end != NULL) {
        *end = found;
    }
    return status;
}
