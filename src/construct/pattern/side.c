#include "construct/pattern/side.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "trace/between.h"

#include <stdio.h>
#include <string.h>

/* Of steps, of the quintics' distance from the surface, and of k_g times the size. */
static const double step_tolerance = 1e-12, distance = 4e-13, turning = 2e-7;
/* Of borders whose speed is uneven: what they are off, over the length of a quintic, is strain. */
static const double fine_step = 1e-13, fine_distance = 2e-14;
/* Lengths are at most so many sizes. */
static const double lengths = 50;

/* Of the widest cell: what has an area; of the window: one line of it. */
static const double least_area = 1e-9, same_line = 1e-9;

static const char *const edges[] = {"u0", "u1", "v0", "v1"};

/* Does the normal jump there? At a pole there is none that could. */
static int is_crease(const taut_carrier *carrier, const double at[2])
{
    double x[TAUT_CARRIER_VECTORS][3];
    taut_form_pair forms;

    taut_carrier_forms_at(carrier, at, x, &forms);
    return forms.w > least_area * carrier->widest && taut_carrier_is_crease(carrier, at);
}

int taut_pattern_crease_between(const taut_carrier *carrier, const double from[2],
                                const double to[2], double at[2])
{
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = carrier->basis[d];
        const double *breaks = taut_basis_breaks(basis), way = to[d] - from[d];
        const double low = fmin(from[d], to[d]), high = fmax(from[d], to[d]);
        const double margin = same_line * (carrier->hi[d] - carrier->lo[d]);
        for (int k = taut_basis_span(basis, low); k < taut_basis_span_count(basis); k++) {
            if (breaks[k] > low + margin && breaks[k] < high - margin) {
                at[d] = breaks[k];
                at[1 - d] = from[1 - d] + (to[1 - d] - from[1 - d]) * ((breaks[k] - from[d]) / way);
                if (is_crease(carrier, at)) {
                    return 1;
                }
            } else if (breaks[k] >= high) {
                break;
            }
        }
    }
    return 0;
}

/* The lath as splines; of a border the coordinate `held` stays what it is at the ends, which rounding may change (-1: none). */
static taut_status take_lath(const taut_carrier *carrier, const taut_lath *lath, int held,
                             taut_arena *arena, taut_pattern_side *side, taut_error *error)
{
    taut_lath_part *parts = NULL;
    taut_curve *curve = NULL;
    int count = 0;

    taut_status status = taut_lath_parts(carrier, lath, arena, &parts, &count, error);
    if (status != TAUT_OK) {
        return status;
    }
    side->part = parts[0];
    side->length = lath->length;
    const size_t points = (size_t)parts[0].count;
    double *window = taut_arena_take(arena, points, 3 * sizeof(double));
    if (window == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t k = 0; k < points; k++) {
        if (held >= 0) {
            parts[0].window[2 * k + (size_t)held] = side->ends[0][held];
        }
        memcpy(window + 3 * k, parts[0].window + 2 * k, 2 * sizeof(double));
    }
    for (size_t d = 0; d < 2; d++) { /* on its border exactly */
        parts[0].window[d] = window[d] = side->ends[0][d];
        parts[0].window[2 * (points - 1) + d] = window[3 * (points - 1) + d] = side->ends[1][d];
    }
    status = taut_curve_new(NULL, parts[0].basis, window, NULL, &curve, error);
    if (status != TAUT_OK) {
        return status;
    }
    side->window = curve;
    return taut_keep_curve(arena, curve) ? TAUT_OK : taut_fail_memory(error);
}

/* Follows `length` from the side's beginning along a direction in space; the end is where it is to be. */
static taut_status follow(const taut_carrier *carrier, taut_linefield_kind kind,
                          const taut_pattern_side *side, const double along[3], double length,
                          const taut_monitor *monitor, taut_arena *arena, taut_lath *lath,
                          taut_error *error)
{
    const taut_lath_options options = {
        .follow = {.tolerance = side->is_fine ? fine_step : step_tolerance,
                   .max_length = length,
                   .monitor = monitor},
        .tolerance = side->is_fine ? fine_distance : distance,
        .residual = turning};
    taut_linefield_fault fault = TAUT_LINEFIELD_FINE;
    const taut_status status =
        taut_lath_trace(carrier, kind, side->ends[0], along, 0, &options, arena, lath, &fault);

    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    if (fault != TAUT_LINEFIELD_FINE || lath->count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "singular", "/of", taut_none, taut_none,
                         "the surface has no normal at (%.6g, %.6g)", side->ends[0][0],
                         side->ends[0][1]);
    }
    if (lath->kink_count > 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "crease", "/of", taut_none, taut_none,
                         "the surface has a kink at (%.6g, %.6g)", lath->kinks[0].at[0],
                         lath->kinks[0].at[1]);
    }
    memcpy(lath->segments[lath->count - 1].to.at, side->ends[1], sizeof(double[2]));
    return TAUT_OK;
}

static const taut_linefield_kind geodesic = {TAUT_TRACE_GEODESIC, 0};

static taut_status find_geodesic(const taut_carrier *carrier, const double from[2],
                                 const double to[2], const taut_monitor *monitor, taut_arena *arena,
                                 taut_between *way, taut_error *error)
{
    const taut_follow_options options = {
        .tolerance = step_tolerance, .max_length = lengths * carrier->size, .monitor = monitor};
    const taut_status status = taut_geodesic_between(carrier, from, to, &options, arena, way);

    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    double kink[2];
    if (!way->is_found && taut_pattern_crease_between(carrier, from, to, kink)) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "crease", "/of", taut_none, taut_none,
            "no geodesic from (%.6g, %.6g) to (%.6g, %.6g) was found over the kink that the "
            "surface has at (%.6g, %.6g): run a seam along it, or cut it there into surfaces of "
            "their own",
            from[0], from[1], to[0], to[1], kink[0], kink[1]);
    }
    if (!way->is_found) {
        return taut_fail(
            error, TAUT_NO_SOLUTION, "no-geodesic", "/seams", taut_none, taut_none,
            "no geodesic from (%.6g, %.6g) to (%.6g, %.6g) was found inside the window", from[0],
            from[1], to[0], to[1]);
    }
    return TAUT_OK;
}

taut_status taut_pattern_geodesic_lath(const taut_carrier *carrier, const double from[2],
                                       const double to[2], const taut_monitor *monitor,
                                       taut_arena *arena, taut_lath *lath, taut_error *error)
{
    taut_pattern_side side = {.border = -1};
    taut_between way;
    const taut_status status = find_geodesic(carrier, from, to, monitor, arena, &way, error);

    memcpy(side.ends[0], from, sizeof side.ends[0]);
    memcpy(side.ends[1], to, sizeof side.ends[1]);
    return status == TAUT_OK ? follow(carrier, geodesic, &side, way.along, way.length, monitor,
                                      arena, lath, error)
                             : status;
}

taut_status taut_pattern_take_lath(const taut_carrier *carrier, const taut_lath *lath, int held,
                                   taut_arena *arena, taut_pattern_side *side, taut_error *error)
{
    return take_lath(carrier, lath, held, arena, side, error);
}

taut_status taut_pattern_geodesic(const taut_carrier *carrier, const double from[2],
                                  const double to[2], const taut_monitor *monitor,
                                  taut_arena *arena, taut_pattern_side *side, taut_error *error)
{
    taut_lath lath;
    const taut_status status =
        taut_pattern_geodesic_lath(carrier, from, to, monitor, arena, &lath, error);

    memcpy(side->ends[0], from, sizeof side->ends[0]);
    memcpy(side->ends[1], to, sizeof side->ends[1]);
    side->kind = TAUT_SIDE_GEODESIC;
    return status == TAUT_OK ? take_lath(carrier, &lath, -1, arena, side, error) : status;
}

/* From a place on along a direction in space to the border: how far, where, and the direction there. */
static taut_status walk_out(const taut_carrier *carrier, const double at[2], const double along[3],
                            const taut_monitor *monitor, taut_arena *arena, double *length,
                            double end[2], double way[3], taut_error *error)
{
    const taut_follow_options options = {
        .tolerance = step_tolerance, .max_length = lengths * carrier->size, .monitor = monitor};
    taut_walk walk;
    taut_walk_state state;
    int span[2];

    taut_carrier_cell(carrier, at, NULL, span);
    if (taut_walk_start(carrier, geodesic, at, span, along, &state) != TAUT_LINEFIELD_FINE) {
        return taut_fail(error, TAUT_NO_SOLUTION, "singular", "/of", taut_none, taut_none,
                         "the surface has no normal at (%.6g, %.6g)", at[0], at[1]);
    }
    const taut_status status = taut_follow(geodesic, &state, &options, arena, &walk);
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    if (walk.count == 0 || (walk.end != TAUT_END_EDGE && walk.end != TAUT_END_CORNER)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-geodesic", "/seams", taut_none, taut_none,
                         "the geodesic from (%.6g, %.6g) on does not come to a border", at[0],
                         at[1]);
    }
    const taut_station *last = &walk.pieces[walk.count - 1].to;
    *length = last->s;
    memcpy(end, walk.end_at, 2 * sizeof(double));
    memcpy(way, last->tangent, 3 * sizeof(double));
    for (int k = 0; k < 2; k++) {
        if (walk.edges[k] >= 0) { /* on it exactly */
            const int held = walk.edges[k] / 2;
            end[held] = walk.edges[k] % 2 == 0 ? carrier->lo[held] : carrier->hi[held];
        }
    }
    return TAUT_OK;
}

taut_status taut_pattern_square_ends(const taut_carrier *carrier, const taut_station *station,
                                     const taut_monitor *monitor, taut_arena *arena,
                                     double ends[2][2], double ways[2][3], double *length,
                                     taut_error *error)
{
    double out[2][3], lengths_of[2] = {0, 0};
    taut_status status = TAUT_OK;

    taut_cross(station->normal, station->tangent, out[1]);
    for (int c = 0; c < 3; c++) {
        out[0][c] = -out[1][c];
    }
    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        status = walk_out(carrier, station->at, out[k], monitor, arena, &lengths_of[k], ends[k],
                          ways[k], error);
        for (int c = 0; status == TAUT_OK && c < 3; c++) {
            ways[k][c] = -ways[k][c];
        }
    }
    *length = lengths_of[0] + lengths_of[1];
    return status;
}

taut_status taut_pattern_geodesic_along(const taut_carrier *carrier, const double ends[2][2],
                                        const double way[3], double length,
                                        const taut_monitor *monitor, taut_arena *arena,
                                        taut_pattern_side *side, taut_error *error)
{
    taut_lath lath;
    memcpy(side->ends, ends, sizeof side->ends);
    side->kind = TAUT_SIDE_GEODESIC;
    const taut_status status =
        follow(carrier, geodesic, side, way, length, monitor, arena, &lath, error);
    return status == TAUT_OK ? take_lath(carrier, &lath, -1, arena, side, error) : status;
}

/* Of side->ends, which are on it. */
static taut_status follow_line(const taut_carrier *carrier, int held, const taut_monitor *monitor,
                               taut_arena *arena, taut_pattern_side *side, taut_error *error)
{
    const int along = 1 - held, backwards = side->ends[0][along] > side->ends[1][along];
    const taut_linefield_kind kind = {TAUT_TRACE_ISOPARAMETRIC, held};
    double x[TAUT_CARRIER_VECTORS][3];
    taut_form_pair forms;
    taut_lath lath;

    taut_carrier_forms_at(carrier, side->ends[0], x, &forms);
    double way[3];
    for (int c = 0; c < 3; c++) {
        way[c] = backwards ? -x[1 + along][c] : x[1 + along][c];
    }
    const taut_status status =
        follow(carrier, kind, side, way, lengths * carrier->size, monitor, arena, &lath, error);
    return status == TAUT_OK ? take_lath(carrier, &lath, held, arena, side, error) : status;
}

taut_status taut_pattern_parameter_line(const taut_carrier *carrier, int held, double value,
                                        int backwards, const taut_monitor *monitor,
                                        taut_arena *arena, taut_pattern_side *side,
                                        taut_error *error)
{
    const int along = 1 - held;
    for (int end = 0; end < 2; end++) {
        side->ends[end][held] = value;
        side->ends[end][along] = end == backwards ? carrier->lo[along] : carrier->hi[along];
    }
    side->kind = TAUT_SIDE_LINE;
    return follow_line(carrier, held, monitor, arena, side, error);
}

taut_status taut_pattern_border(const taut_carrier *carrier, int edge, int backwards,
                                const taut_monitor *monitor, taut_arena *arena,
                                taut_pattern_side *side, taut_error *error)
{
    const int held = edge / 2;
    const double value = edge % 2 == 0 ? carrier->lo[held] : carrier->hi[held];

    side->border = edge;
    snprintf(side->name, sizeof side->name, "%s", edges[edge]);
    return taut_pattern_parameter_line(carrier, held, value, backwards, monitor, arena, side,
                                       error);
}

void taut_pattern_side_at(const taut_pattern_side *side, double x, double w[3][2])
{
    const taut_basis *basis = taut_curve_t(side->window);
    const double lo = taut_basis_lo(basis), range = taut_basis_hi(basis) - lo;
    double values[3][3], scale = 1;

    taut_curve_eval(side->window, x < 1 ? lo + x * range : lo + range, 2, values[0]);
    for (int k = 0; k < 3; k++, scale *= range) {
        for (int d = 0; d < 2; d++) {
            w[k][d] = scale * values[k][d];
        }
    }
}
