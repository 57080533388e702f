/* run.c -- the certificate of a run of pipes: from its surfaces and axes alone.
 *
 *     joints       each surface meets the next, with equal normals, and so do their axes
 *     curvatures   equal principal curvatures there; about quintics
 *     embedded     radius over the largest radius of the whole axis               reach.c
 *     bend_radius  the least radius of curvature asked for, times the largest curvature
 *     tube         the surfaces are at the radius from their axes
 *     caps         discs over the free ends, where there are any                   caps.c
 *     ends         the run goes where it was asked to; with a problem: the largest distance, over
 *                  the radius, and difference of unit tangents. Each blend begins and ends at the
 *                  ends of its straight pipes, along them; or on the legs of its corner, along
 *                  them, and the corners that turn are as many as the blends. An open run begins
 *                  and ends where the first and last are.
 */
#include "certify/common/verdict.h"
#include "certify/pipe/parts.h"
#include "certify/pipe/sweep.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double tolerance_default = 1e-6, bend_of_corners = 3;
static const double turns_not = 1e-9; /* sine */

typedef struct taut_pipe_run_parts {
    taut_pipe_parts parts;                /* line: all pieces; radius, sizes, figures */
    const taut_pipe_run_problem *problem; /* or NULL */
    const taut_model *model;
    int count;                     /* of pieces, straight or not, in the order of flow */
    const taut_surface **surfaces; /* "pipe1", "blend1", ... */
    const taut_curve **curves;     /* their axes */
    double bend_radius;            /* asked for; 0: none */
    double wall;                   /* likewise */
    const char *prefix;            /* of claims: "", or "inner_" */
} taut_pipe_run_parts;

int taut_pipe_is_run(const taut_model *model)
{
    return taut_pipe_find_curve(model, "axis-blend1") != NULL;
}

static int is_blend(const taut_pipe_run_parts *run, int piece)
{
    return strncmp(taut_curve_name(run->curves[piece]), "axis-blend", 10) == 0;
}

static void find_tangent(const taut_pipe_run_parts *run, int piece, double t, double tangent[3])
{
    double d[2][3];
    taut_pipe_piece_eval(&run->parts.line.pieces[piece], t, 1, d);
    taut_pipe_unit(d[1], tangent);
}

/* Surfaces and their axes, by their names. */
static taut_status find_pieces(taut_pipe_run_parts *run, taut_arena *arena, taut_error *error)
{
    const int most = taut_model_surface_count(run->model);
    const taut_record *told = taut_record_get(taut_model_details(run->model), "blends");
    size_t blends = 0;
    run->surfaces = taut_arena_take(arena, (size_t)most + 1, sizeof *run->surfaces);
    run->curves = taut_arena_take(arena, (size_t)most + 1, sizeof *run->curves);
    if (run->surfaces == NULL || run->curves == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < most; i++) {
        const taut_surface *surface = taut_model_surface(run->model, i);
        const char *name = taut_surface_name(surface);
        char axis[64];
        if (strncmp(name, "pipe", 4) != 0 && strncmp(name, "blend", 5) != 0) {
            continue;
        }
        snprintf(axis, sizeof axis, "axis-%s", name);
        blends += strncmp(name, "blend", 5) == 0;
        run->surfaces[run->count] = surface;
        run->curves[run->count] = taut_pipe_find_curve(run->model, axis);
        if (run->curves[run->count++] == NULL) {
            return taut_fail(error, TAUT_BAD_INPUT, "missing", "/curves", taut_none, taut_none,
                             "surface \"%s\" of a run has no curve \"%s\"", name, axis);
        }
    }
    if (taut_record_kind_of(told) == TAUT_RECORD_LIST && taut_record_count(told) != blends) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/surfaces", (double)blends,
                         (double)taut_record_count(told),
                         "the details tell of %zu blends, of which %zu are here",
                         taut_record_count(told), blends);
    }
    if (run->count == 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "missing", "/surfaces", 0, 1,
                         "a run has surfaces \"pipe1\", \"blend1\", ...");
    }
    return TAUT_OK;
}

/* Radius and bend radius: the problem's, or what the model shows and tells. */
static void find_data(taut_pipe_run_parts *run)
{
    const taut_record *details = taut_model_details(run->model);
    const taut_pipe_run_problem *problem = run->problem;
    const taut_surface *first = run->surfaces[0];
    double x[3];
    taut_surface_eval(first, taut_basis_lo(taut_surface_u(first)),
                      taut_basis_lo(taut_surface_v(first)), 0, x);
    run->parts.radius =
        problem != NULL
            ? problem->radius
            : taut_pipe_radius_told(run->model, taut_distance(x, run->parts.line.origin));
    run->bend_radius = problem == NULL ? taut_record_number(taut_record_get(details, "bend_radius"))
                       : problem->bend_radius > 0 ? problem->bend_radius
                       : problem->route.kind == TAUT_PIPE_CORNERS
                           ? bend_of_corners * problem->radius
                           : 0;
    run->wall =
        problem != NULL ? problem->wall : taut_record_number(taut_record_get(details, "wall"));
    run->parts.flatness = 1;
    run->parts.axes = run->curves;
    run->parts.axis_count = run->count;
    for (int i = 0; i < run->count; i++) {
        taut_pipe_add_sizes(run->surfaces[i], &run->parts);
        if (is_blend(run, i)) {
            run->parts.quintic = taut_basis_degree(taut_curve_t(run->curves[i])) == 5;
        }
    }
}

/* Does the last piece end where the first begins, in its direction? */
static int comes_round(const taut_pipe_run_parts *run)
{
    const taut_pipe_line *line = &run->parts.line;
    const taut_pipe_piece *last = &line->pieces[line->count - 1];
    const double near = 1e-6 * run->parts.radius / line->scale;
    return taut_distance(last->points[last->degree], line->pieces[0].points[0]) < near &&
           taut_distance(line->tangent[0], line->tangent[1]) < 1e-6;
}

/* As the problem, or the details tell; else as it looks. */
static int is_closed(const taut_pipe_run_parts *run)
{
    const taut_record *told = taut_record_get(taut_model_details(run->model), "closed");
    return run->problem != NULL                            ? run->problem->route.closed != 0
           : taut_record_kind_of(told) == TAUT_RECORD_BOOL ? taut_record_bool(told)
                                                           : comes_round(run);
}

/* Where an arc ends comes from its corner, both legs and its radius: so many roundings of a coordinate for one. */
static const double arc_roundings = 6;

/* The joint after piece i, as that of a blend, at its end `side`, with what is beside it. The tangent
 * is that of what is beside it: of a straight pipe it is exact, of the polynomial near an arc it is
 * off by rounding, times the longest way along the flow over the least. */
static taut_status measure_joint(const taut_pipe_run_parts *run, int i, int side, int curved,
                                 taut_pipe_meeting *m)
{
    const int next = (i + 1) % run->count, blend = side ? i : next, other = side ? next : i;
    taut_pipe_parts joint = run->parts;
    joint.blend = run->surfaces[blend];
    joint.pipes[side] = run->surfaces[other];
    for (int k = 0; k < 3 && taut_basis_degree(taut_surface_u(joint.blend)) == 2; k++) {
        joint.sizes[k] *= arc_roundings;
    }
    find_tangent(run, other, 1 - side, joint.line.tangent[side]);
    return (curved ? taut_pipe_measure_curvatures : taut_pipe_measure_joint)(&joint, side, m);
}

/* The joint that is worst against its limit: where rounding explains everything, that is no more
 * than it ever is. */
static taut_status claim_joints(const taut_pipe_run_parts *run, int curved,
                                taut_certificate *certificate)
{
    const taut_pipe_line *line = &run->parts.line;
    taut_pipe_meeting worst = {.noise = 1};
    taut_claim_kind kind = TAUT_BOUND; /* a check if any joint is one */
    char where[160] = "";
    for (int i = 0; i + !line->closed < run->count; i++) {
        const int next = (i + 1) % run->count;
        const taut_pipe_piece *piece = &line->pieces[i];
        const double gap =
            taut_distance(piece->points[piece->degree], line->pieces[next].points[0]);
        taut_pipe_meeting m;
        const int side = is_blend(run, i);
        const taut_status status = measure_joint(run, i, side, curved, &m);
        if (status != TAUT_OK) {
            return status;
        }
        kind = m.kind == TAUT_CHECK ? TAUT_CHECK : kind;
        if (curved && side && is_blend(run, next)) { /* both are rounded */
            taut_pipe_meeting other;
            (void)measure_joint(run, i, 0, 1, &other);
            m.noise += other.noise;
        }
        if (!curved) {
            m.residual = taut_certify_max(m.residual, gap * line->scale / run->parts.radius);
        }
        if (i == 0 || (!isnan(worst.residual) && !(m.residual * taut_pipe_held(worst.noise) <=
                                                   worst.residual * taut_pipe_held(m.noise)))) {
            worst = m;
            snprintf(where, sizeof where, "%.32s.u1, %.32s.u0%s%s",
                     taut_surface_name(run->surfaces[i]), taut_surface_name(run->surfaces[next]),
                     m.where[0] != 0 ? ", " : "", m.where);
        }
    }
    char name[32];
    snprintf(name, sizeof name, "%s%s", run->prefix, curved ? "curvatures" : "joints");
    return taut_pipe_add_claim(name, kind, worst.residual, 0, worst.noise, where, certificate);
}

/* The piece at an arc length from the start of the run, and how far along it. */
static void describe_place(const taut_pipe_run_parts *run, double at, char *text, size_t size)
{
    const taut_pipe_line *line = &run->parts.line;
    double from = 0;
    int i = 0;
    for (;; i++) {
        const taut_pipe_line one = {.count = 1,
                                    .pieces = &line->pieces[i],
                                    .noise = line->noise}; /* else rounding is torsion */
        taut_pipe_figures f = {.length = 0};
        taut_pipe_integrate(&one, &f);
        if (i + 1 == run->count || at <= from + f.length) {
            break;
        }
        from += f.length;
    }
    snprintf(text, size, "%.6g along %.32s", (at - from) * line->scale,
             taut_surface_name(run->surfaces[i]));
}

/* Piece and parameter of the largest curvature. */
static void describe_curvature_place(const taut_pipe_run_parts *run, char *text, size_t size)
{
    const double at = run->parts.figures.curvature_at;
    const int i = (int)fmin(run->count - 1, floor(at));
    snprintf(text, size, "%.32s, t = %.9g", taut_surface_name(run->surfaces[i]), at - i);
}

static taut_status claim_embedded(const taut_pipe_run_parts *run, taut_certificate *certificate)
{
    const taut_pipe_figures *f = &run->parts.figures;
    char where[200] = "", from[80], to[80];

    if (isfinite(f->rho) && f->by_distance) {
        describe_place(run, f->binding[0], from, sizeof from);
        describe_place(run, f->binding[1], to, sizeof to);
        snprintf(where, sizeof where, "%s, %s", from, to);
    } else if (isfinite(f->rho)) {
        snprintf(where, sizeof where, "the curvature of ");
        describe_curvature_place(run, where + strlen(where), sizeof where - strlen(where));
    }
    return taut_pipe_claim_embedded(&run->parts, where, certificate);
}

/* Arcs are of the bend radius itself, which rounding may miss. */
static double noise_of_arcs(const taut_pipe_run_parts *run)
{
    double noise = 0;
    for (int i = 0; i < run->count; i++) {
        if (run->parts.line.pieces[i].radius > 0) {
            noise = fmax(noise, 4 * taut_pipe_circle_noise(run->curves[i], run->parts.size));
        }
    }
    return noise;
}

static taut_status claim_bend(const taut_pipe_run_parts *run, taut_certificate *certificate)
{
    const taut_pipe_line *line = &run->parts.line;
    const double open = 8 * line->noise * (1 + run->parts.figures.curvature);
    char where[80];
    describe_curvature_place(run, where, sizeof where);
    const double residual = run->bend_radius * run->parts.figures.curvature / line->scale;
    const double limit = 1 + noise_of_arcs(run);
    int proved = 0;
    const taut_status status =
        taut_pipe_prove_bend(&run->parts, limit * line->scale / run->bend_radius, &proved);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_claim claim = {
        .claim = "bend_radius",
        .kind = TAUT_BOUND,
        .residual = residual,
        .limit = limit,
        .holds = residual <= limit && proved ? TAUT_TRUE
                 : residual > 1 + open       ? TAUT_FALSE
                                             : TAUT_UNDECIDED,
        .where = residual > 1 + open || proved ? where : "how sharply the run bends is not bounded",
    };
    return taut_certificate_add(certificate, &claim);
}

/* One straight pipe asked for: a line, and where on it, if that is said. */
typedef struct asked_leg {
    const double *from, *to;
    double direction[3];
} asked_leg;

/* Corner i, over and over. */
static const double *corner_of(const taut_pipe_route *route, int i)
{
    return route->corners + 3 * (size_t)(i % route->count);
}

static asked_leg next_straight(const taut_pipe_route *route, int *i)
{
    const taut_pipe_leg *const leg = &route->legs[*i % route->count];
    const int is_span = leg->kind == TAUT_PIPE_LEG_SPAN;
    asked_leg out = {.from = leg->from, .to = is_span ? leg->to : leg->from};
    double d[3];
    taut_difference(out.to, out.from, d);
    taut_pipe_unit(is_span ? d : leg->direction, out.direction);
    *i += 1;
    return out;
}

/* Corners without a turn are passed over. */
static asked_leg next_between_corners(const taut_pipe_route *route, int *i)
{
    asked_leg out = {.from = corner_of(route, *i), .to = corner_of(route, *i + 1)};
    double d[3];
    taut_difference(out.to, out.from, d);
    taut_pipe_unit(d, out.direction);
    for (*i += 1; route->closed ? *i < 2 * route->count : *i + 1 < route->count; *i += 1) {
        double on[3], across[3];
        taut_difference(corner_of(route, *i + 1), out.to, d);
        taut_pipe_unit(d, on);
        taut_cross(out.direction, on, across);
        if (taut_norm(across) > turns_not || taut_dot(out.direction, on) < 0) {
            break;
        }
        out.to = corner_of(route, *i + 1);
    }
    return out;
}

/* The next leg of the route at or after *i. */
static asked_leg next_leg(const taut_pipe_route *route, int *i)
{
    return route->kind == TAUT_PIPE_LEGS ? next_straight(route, i) : next_between_corners(route, i);
}

static void to_absolute(const taut_pipe_line *line, const double local[3], double x[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = line->origin[k] + line->scale * local[k];
    }
}

/* How far end `t` of a piece is from what was asked of it. */
static double miss_of_leg(const taut_pipe_run_parts *run, int piece, int t, const asked_leg *asked)
{
    const taut_pipe_piece *b = &run->parts.line.pieces[piece];
    double x[3], d[3], tangent[3];
    to_absolute(&run->parts.line, b->points[t == 0 ? 0 : b->degree], x);
    taut_difference(x, t == 0 ? asked->to : asked->from, d);
    if (run->problem->route.kind == TAUT_PIPE_CORNERS) {
        taut_add_scaled(-taut_dot(d, asked->direction), asked->direction, d);
    }
    find_tangent(run, piece, t, tangent);
    return fmax(taut_norm(d) / run->parts.radius, taut_distance(tangent, asked->direction));
}

/* Where the run as a whole begins or ends. */
static double miss_of_free_end(const taut_pipe_run_parts *run, int side)
{
    const taut_pipe_route *route = &run->problem->route;
    const int last = route->count - 1;
    const taut_pipe_piece *b = &run->parts.line.pieces[side == 0 ? 0 : run->count - 1];
    const double *asked = NULL;
    double x[3];
    if (route->kind == TAUT_PIPE_CORNERS) {
        asked = corner_of(route, side == 0 ? 0 : last);
    } else {
        const taut_pipe_leg *const leg = &route->legs[side == 0 ? 0 : last];
        asked = side == 0 || leg->kind == TAUT_PIPE_LEG_POINT ? leg->from : leg->to;
    }
    to_absolute(&run->parts.line, b->points[side == 0 ? 0 : b->degree], x);
    return taut_distance(x, asked) / run->parts.radius;
}

static taut_status claim_ends(const taut_pipe_run_parts *run, taut_certificate *certificate)
{
    const taut_pipe_route *route = &run->problem->route;
    const int is_blend_only = route->count == 0;
    double worst = is_blend_only ? 1 : 0, shortest = INFINITY;
    int i = 0, blends = 0;
    char where[48] = "";

    asked_leg before = {.from = NULL}, after = {.from = NULL};
    for (int k = 0; k < run->count && !is_blend_only; k++) {
        if (!is_blend(run, k)) {
            continue;
        }
        before = blends == 0 ? next_leg(route, &i) : after;
        after = next_leg(route, &i);
        blends++;
        const double found = fmax(miss_of_leg(run, k, 0, &before), miss_of_leg(run, k, 1, &after));
        const taut_pipe_piece *piece = &run->parts.line.pieces[k];
        shortest = fmin(shortest, fmin(taut_distance(piece->points[0], piece->points[1]),
                                       taut_distance(piece->points[piece->degree],
                                                     piece->points[piece->degree - 1])));
        if (!(found <= worst)) {
            worst = found;
            snprintf(where, sizeof where, "%.32s", taut_surface_name(run->surfaces[k]));
        }
    }
    for (int side = 0; side < 2 && !route->closed && !is_blend_only; side++) {
        worst = fmax(worst, miss_of_free_end(run, side));
    }
    /* rounding of each coordinate, over the radius and over the legs that make the tangents */
    const double noise = 4 * DBL_EPSILON + 4 * DBL_EPSILON * run->parts.size / run->parts.radius +
                         8 * DBL_EPSILON * run->parts.size / (shortest * run->parts.line.scale);
    return taut_pipe_add_claim("ends", TAUT_EXACT, worst, 0, noise, where, certificate);
}

static taut_record *figures_of(const taut_pipe_run_parts *run, double fit_error)
{
    const taut_pipe_figures *f = &run->parts.figures;
    const double scale = run->parts.line.scale, a = run->parts.radius;
    taut_record *figures = taut_record_new();
    char where[80];

    describe_curvature_place(run, where, sizeof where);
    taut_record_add_number(figures, "length", f->length * scale);
    taut_record_add_number(figures, "max_curvature", f->curvature / scale);
    taut_record_add_text(figures, "max_curvature_at", where);
    taut_record_add_number(figures, "least_bend_radius", scale / f->curvature);
    taut_record_add_number(figures, "total_curvature", f->turning);
    taut_pipe_add_torsion(figures, f->torsion);
    taut_record_add_number(figures, "bending", f->bending / scale);
    taut_record_add_number(figures, "largest_radius", f->rho * scale);
    taut_record_add_number(figures, "area", 2 * TAUT_PI * a * f->length * scale);
    taut_record_add_number(figures, "volume", TAUT_PI * a * a * f->length * scale);
    if (run->wall > 0) {
        taut_record_add_number(figures, "wall_volume",
                               TAUT_PI * run->wall * (2 * a - run->wall) * f->length * scale);
    }
    taut_record_add_number(figures, "fit_error", fit_error);
    taut_record_add_text(figures, "binding",
                         !isfinite(f->rho) ? "none"
                         : f->by_distance  ? "distance"
                                           : "curvature");
    return figures;
}

/* The inside of a wall: joints and tube again, and the rings at the ends. */
static taut_status claim_wall(const taut_pipe_run_parts *run, const taut_surface *const ends[2],
                              double tolerance, taut_certificate *certificate)
{
    taut_pipe_run_parts inner = *run;
    double fit_error = 0;
    inner.prefix = "inner_";
    inner.parts.radius = run->parts.radius - run->wall;
    inner.surfaces =
        taut_arena_take(run->parts.line.arena, (size_t)run->count, sizeof *inner.surfaces);
    if (inner.surfaces == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < run->count; i++) {
        char name[64];
        snprintf(name, sizeof name, "inner-%.40s", taut_surface_name(run->surfaces[i]));
        inner.surfaces[i] = taut_pipe_find_surface(run->model, name);
        if (inner.surfaces[i] == NULL) {
            snprintf(name, sizeof name, "inner-%.40s is missing",
                     taut_surface_name(run->surfaces[i]));
            return taut_pipe_add_claim("inner_tube", TAUT_BOUND, 1, tolerance, tolerance, name,
                                       certificate);
        }
    }
    const taut_surface *inside[2] = {inner.surfaces[0], inner.surfaces[run->count - 1]};
    taut_status status = claim_joints(&inner, 0, certificate);
    if (status == TAUT_OK && run->parts.quintic) {
        status = claim_joints(&inner, 1, certificate);
    }
    if (status == TAUT_OK) {
        status = taut_pipe_claim_run_tube("inner_tube", &inner.parts, run->count, inner.surfaces,
                                          run->curves, tolerance, &fit_error, certificate);
    }
    return status == TAUT_OK
               ? taut_pipe_claim_caps(run->model, &run->parts, ends, inside, certificate)
               : status;
}

static taut_status add_claims(const taut_pipe_run_parts *run, double tolerance,
                              taut_certificate *certificate)
{
    const taut_surface *ends[2] = {run->surfaces[0], run->surfaces[run->count - 1]};
    taut_record *figures = NULL;
    double fit_error = 0;
    taut_status status = claim_joints(run, 0, certificate);
    if (status == TAUT_OK && run->parts.quintic) {
        status = claim_joints(run, 1, certificate);
    }
    if (status != TAUT_OK || taut_crew_beat(run->parts.crew, TAUT_PULSE_WORK)) {
        return status;
    }
    status = claim_embedded(run, certificate);
    if (status == TAUT_OK && run->bend_radius > 0) {
        status = claim_bend(run, certificate);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_claim_run_tube("tube", &run->parts, run->count, run->surfaces, run->curves,
                                      tolerance, &fit_error, certificate);
    if (status != TAUT_OK) {
        return status;
    }
    status = run->wall > 0 ? claim_wall(run, ends, tolerance, certificate)
                           : taut_pipe_claim_caps(run->model, &run->parts, ends, NULL, certificate);
    if (status == TAUT_OK && run->problem != NULL) {
        status = claim_ends(run, certificate);
    }
    if (status != TAUT_OK) {
        return status;
    }
    figures = figures_of(run, fit_error);
    taut_certificate_set_figures(certificate, figures);
    return taut_record_status(figures);
}

static taut_status claim_run(taut_pipe_run_parts *run, taut_arena *arena, double tolerance,
                             taut_certificate *certificate, taut_error *error)
{
    taut_status status = find_pieces(run, arena, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_pipe_line_of_run(run->curves, run->count, arena, &run->parts.line, error);
    if (status != TAUT_OK) {
        return status;
    }
    find_data(run);
    run->parts.line.closed = is_closed(run);
    if (!(run->parts.radius > 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/surfaces/0", run->parts.radius, 0,
                         "the run begins on its own axis: it has no radius");
    }
    status = taut_pipe_find_figures(&run->parts);
    if (status != TAUT_OK || taut_crew_beat(run->parts.crew, TAUT_PULSE_WORK)) {
        return status;
    }
    return add_claims(run, tolerance, certificate);
}

taut_status taut_pipe_claim_run(const taut_model *model, const taut_pipe_run_problem *problem,
                                const taut_audit *audit, taut_certificate *certificate,
                                taut_error *error)
{
    const double tolerance = audit->tolerance > 0 ? audit->tolerance : tolerance_default;
    taut_pipe_run_parts run = {
        .model = model, .problem = problem, .prefix = "", .parts = {.crew = &audit->crew}};
    taut_arena *const arena = taut_arena_new();
    const taut_status status = claim_run(&run, arena, tolerance, certificate, error);
    taut_arena_free(arena);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}
