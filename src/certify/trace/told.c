/* told.c
 *
 *     trace              the net's name
 *     laths, nodes       none there twice, and no lath without a curve
 *     steps, drift       of the way that led here: no more steps than the curve has spans, an end that moves within the surface
 *     border             of a node: does it lie where no curve goes on?
 *     kinks              of each the angle between the curve's own tangents on both sides of the place; no larger one left out
 *     left_out           what the reason says of the surface at the place
 *     hyperbolic_share   between the shares of the grid's places where K < 0 clearly, and where it may be by rounding
 *     singular_points    certify/trace/turns.h
 */
#include "certify/trace/told.h"

#include "basis/basis_ops.h"
#include "certify/trace/family.h"
#include "certify/trace/laths.h"
#include "certify/trace/side.h"
#include "certify/trace/turns.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <stdlib.h>
#include <string.h>

enum { GRID = 101, WIDE = 9, KINKS_MOST = 64 /* that a curve is told to have each way */ };
/* Over the window's side: a place on its border, and places that are one. */
static const double on_border = 1e-9, one_place = 1e-8;
/* A kink that must be told, and the least that may be. */
static const double plain_kink = 1e-6, least_kink = 1e-9;
/* K over H^2, or over the square of the largest R: below, its sign is rounding. */
static const double no_sign = 1e-9;
/* R over its largest value of a point that is flat, H too; the normal's jump at a crease, and where there is none, over the
 * largest: a bit beyond what curves end at. */
static const double round_point = 1e-7, flat_point = 1e-5, crease = 0.5e-9, no_normal = 1e-8;
/* Sines of less are directions along a line, which the figure is to be off by 1e-6. */
static const double along_share = 0.1;
/* Over the size: a curve that only touches the window is out of it within that each way; three times as long as curves of
 * lattices that are left out for it. */
static const double out_within = 3e-6;
/* As the largest R counts at least, over 1 over the size, and over |H|. */
static const double least_share = 1e-4;

static double number_at(const taut_record *list, size_t k)
{
    return taut_record_number(taut_record_at(list, k));
}

static void place_told(const taut_record *at, double place[2])
{
    place[0] = number_at(taut_record_get(at, "at"), 0);
    place[1] = number_at(taut_record_get(at, "at"), 1);
}

static const taut_basis *side_of(const taut_net_audit *audit, int on, int d)
{
    const taut_surface *surface = audit->cells->surfaces[on];
    return d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
}

static double width_of(const taut_net_audit *audit, int on, int d)
{
    return taut_basis_hi(side_of(audit, on, d)) - taut_basis_lo(side_of(audit, on, d));
}

static int is_inside(const taut_net_audit *audit, int on, const double at[2])
{
    for (int d = 0; d < 2; d++) {
        const taut_basis *side = side_of(audit, on, d);
        if (!(at[d] >= taut_basis_lo(side)) || !(at[d] <= taut_basis_hi(side))) {
            return 0;
        }
    }
    return 1;
}

/* ---- names ---- */

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* A name that is in a list twice; NULL. */
static taut_status name_twice(const taut_record *list, const char *member, taut_arena *arena,
                              const char **twice)
{
    const size_t count = taut_record_count(list);
    const char **names = taut_arena_take(arena, count + 1, sizeof *names);
    if (names == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        names[k] = taut_net_text(taut_record_at(list, k), member);
    }
    qsort(names, count, sizeof *names, by_name);
    for (size_t k = 1; k < count; k++) {
        *twice = strcmp(names[k - 1], names[k]) == 0 ? names[k] : *twice;
    }
    return TAUT_OK;
}

static taut_status look_at_names(const taut_net_audit *audit, taut_arena *arena, taut_net_off *off)
{
    const taut_record *details = taut_model_details(audit->lines->model);
    const taut_record *laths = taut_record_get(details, "laths");
    const taut_record *nodes = taut_record_get(details, "nodes");
    const char *twice = NULL;
    taut_status status = name_twice(laths, "name", arena, &twice);

    if (status == TAUT_OK) {
        status = name_twice(nodes, "node", arena, &twice);
    }
    if (twice != NULL) {
        taut_net_off_take(off, INFINITY, twice, "twice");
    }
    if (taut_record_count(laths) !=
        (size_t)audit->lines->count) { /* each curve has its own: figures.c */
        taut_net_off_take(off, INFINITY, "laths", "count");
    }
    return status;
}

/* ---- how it was found ---- */

/* Nothing in the model says how many steps there were, and how far they lead elsewhere if they are smaller: only what cannot be. */
static void look_at_way(const taut_net_audit *audit, taut_net_off *off)
{
    static const char *const nets[] = {"asymptotic", "principal", "geodesic", "isoparametric"};
    const taut_record *details = taut_model_details(audit->lines->model);
    const taut_record *drift = taut_record_get(details, "drift");
    const double moved = ldexp(drift != NULL ? taut_record_number(drift) : 0, -audit->unit);

    if (strcmp(taut_net_text(details, "trace"), nets[audit->lines->net]) != 0) {
        taut_net_off_take(off, INFINITY, "details", "trace");
    }
    if (!(moved >= 0) || !(moved <= audit->size)) {
        taut_net_off_take(off, INFINITY, "details", "drift");
    }
    if (taut_record_get(details, "left_out") == NULL) {
        taut_net_off_take(off, INFINITY, "details", "left_out");
    }
    for (int i = 0; i < audit->lines->count; i++) {
        const taut_net_line *line = &audit->lines->lines[i];
        const double steps = taut_net_number(taut_net_lath_of(audit->lines, line), "steps");
        const int spans = taut_basis_span_count(taut_curve_t(line->space));
        if (!(steps >= 0) || !(steps <= 64 + 8.0 * spans) || steps != floor(steps)) {
            taut_net_off_take(off, INFINITY, taut_curve_name(line->space), "steps");
        }
    }
}

/* ---- border ---- */

/* May curves go on across this side of a window, to another surface, or to the other side of their own? */
static int goes_on(const taut_net_audit *audit, int on, int d, int side)
{
    double at[2][2], x[2][3];
    if (audit->seams->count > 0 && taut_net_seams_join(audit->seams, on, 2 * d + side)) {
        return 1;
    }
    for (int k = 0; k < 2; k++) {
        const taut_basis *along = side_of(audit, on, d), *across = side_of(audit, on, 1 - d);
        at[k][d] = k == 0 ? taut_basis_lo(along) : taut_basis_hi(along);
        at[k][1 - d] = (taut_basis_lo(across) + taut_basis_hi(across)) / 2;
        if (taut_surface_eval(audit->cells->surfaces[on], at[k][0], at[k][1], 0, x[k]) != TAUT_OK) {
            return 0;
        }
    }
    return taut_distance(x[0], x[1]) <= on_border * audit->size;
}

static void look_at_borders(const taut_net_audit *audit, taut_net_off *off)
{
    const taut_record *nodes = taut_record_get(taut_model_details(audit->lines->model), "nodes");
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k);
        const int on = taut_net_surface_of(audit, node);
        const int is_told = taut_record_bool(taut_record_get(node, "border"));
        int is_near = 0, is_clear = 1; /* to a border; is it none for sure? */
        double at[2];
        place_told(node, at);
        for (int d = 0; d < 2; d++) {
            const double room = on_border * width_of(audit, on, d);
            const double away[2] = {at[d] - taut_basis_lo(side_of(audit, on, d)),
                                    taut_basis_hi(side_of(audit, on, d)) - at[d]};
            for (int side = 0; side < 2; side++) {
                is_near |= away[side] <= 2 * room;
                is_clear &= away[side] > room / 2 || goes_on(audit, on, d, side);
            }
        }
        if (is_told ? !is_near : !is_clear) {
            taut_net_off_take(off, INFINITY, taut_net_text(node, "node"), "border");
        }
    }
}

/* ---- kinks ---- */

typedef struct corner {
    double at[2][2]; /* in the windows before and behind it */
    int on[2];
    double angle;
} corner;

/* The curve's derivative at t as span i has it. */
static void way_of_span(const taut_curve *curve, int i, double t, double way[3])
{
    const taut_basis *basis = taut_curve_t(curve);
    const int local = basis->shape.local, first = basis->first[i];
    const double *points = taut_curve_points(curve) + 3 * first;
    double values[2 * (TAUT_DEGREE_MAX + 1)];

    basis->ops->eval(basis, i, t, 1, values);
    memset(way, 0, 3 * sizeof way[0]);
    for (int a = 0; a < local; a++) {
        taut_add_scaled(values[local + a], points + 3 * a, way);
    }
}

/* How a curve turns at break i; 0 where it is not known there. */
static int corner_at(const taut_net_line *line, int i, corner *c)
{
    const double t = taut_basis_breaks(taut_curve_t(line->space))[i];
    double way[2][3], across[3], point[3];
    int count = 0;

    for (int k = 0; k < line->count && count < 2; k++) {
        const taut_basis *stretch = taut_curve_t(line->window[k]);
        if (t >= taut_basis_lo(stretch) && t <= taut_basis_hi(stretch) &&
            taut_curve_eval(line->window[k], t, 0, point) == TAUT_OK) {
            memcpy(c->at[count], point, sizeof c->at[count]);
            c->on[count++] = line->on[k];
        }
    }
    if (count == 0 || taut_curve_weights(line->space) != NULL) {
        return 0;
    }
    if (count == 1) {
        memcpy(c->at[1], c->at[0], sizeof c->at[1]);
        c->on[1] = c->on[0];
    }
    for (int side = 0; side < 2; side++) {
        way_of_span(line->space, i - 1 + side, t, way[side]);
    }
    taut_cross(way[0], way[1], across);
    c->angle = taut_atan2(taut_norm(across), taut_dot(way[0], way[1]));
    return 1;
}

/* How far the angle of a kink that is told there is from this one; INFINITY where none is. */
static double kink_off(const taut_net_audit *audit, const taut_record *kink, const corner *c)
{
    const int on = taut_net_surface_of(audit, kink);
    double at[2], least = INFINITY;
    place_told(kink, at);
    for (int side = 0; side < 2; side++) {
        if (on == c->on[side] &&
            fabs(at[0] - c->at[side][0]) <= one_place * width_of(audit, on, 0) &&
            fabs(at[1] - c->at[side][1]) <= one_place * width_of(audit, on, 1)) {
            least = fmin(least, fabs(taut_net_number(kink, "angle") - c->angle));
        }
    }
    return least;
}

static int is_of_lath(const taut_record *kink, const taut_net_line *line)
{
    return strcmp(taut_net_text(kink, "lath"), taut_curve_name(line->space)) == 0;
}

static taut_status look_at_kinks(const taut_net_audit *audit, taut_arena *arena, taut_net_off *off)
{
    const taut_record *kinks = taut_record_get(taut_model_details(audit->lines->model), "kinks");
    const size_t count = taut_record_count(kinks);
    double *away = taut_arena_take(arena, count + 1, sizeof *away);
    if (away == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        away[k] = INFINITY;
    }
    for (int i = 0; i < audit->lines->count; i++) {
        const taut_net_line *line = &audit->lines->lines[i];
        const taut_basis *range = taut_curve_t(line->space);
        const char *name = taut_curve_name(line->space);
        size_t own = 0, corners = 0;
        for (size_t k = 0; k < count; k++) {
            own += (size_t)is_of_lath(taut_record_at(kinks, k), line);
        }
        for (int b = 1; b < taut_basis_span_count(range); b++) {
            double nearest = INFINITY;
            corner c;
            if (!corner_at(line, b, &c)) {
                continue; /* other claims say so */
            }
            corners += c.angle > least_kink;
            for (size_t k = 0; own > 0 && k < count; k++) {
                const taut_record *kink = taut_record_at(kinks, k);
                const double found =
                    is_of_lath(kink, line) ? kink_off(audit, kink, &c) : (double)INFINITY;
                away[k] = fmin(away[k], found);
                nearest = fmin(nearest, found);
            }
            if (c.angle > plain_kink && isinf(nearest) && own < KINKS_MOST) {
                taut_net_off_take(off, INFINITY, name, "kinks");
            }
        }
        if (own > corners) {
            taut_net_off_take(off, INFINITY, name, "kinks");
        }
    }
    for (size_t k = 0; k < count; k++) {
        const taut_record *kink = taut_record_at(kinks, k);
        const double told = taut_net_number(kink, "angle");
        taut_net_off_take(off, isnan(told) ? told : away[k], taut_net_text(kink, "lath"), "kink");
    }
    return TAUT_OK;
}

/* ---- what is left out ---- */

/* The largest |x_u x x_v| of a grid. */
static double widest(const taut_net_audit *audit, int on)
{
    double most = 0;
    for (int i = 0; i < WIDE * WIDE; i++) {
        const double at[2] = {taut_basis_lo(side_of(audit, on, 0)) +
                                  width_of(audit, on, 0) * (i / WIDE + 0.5) / WIDE,
                              taut_basis_lo(side_of(audit, on, 1)) +
                                  width_of(audit, on, 1) * (i % WIDE + 0.5) / WIDE};
        taut_forms f;
        if (taut_net_cells_look(audit->cells, on, at, NULL, &f)) {
            most = fmax(most, f.w);
        }
    }
    return most;
}

/* Does the normal jump across a knot there? */
static int is_crease(const taut_surface *surface, const double at[2])
{
    int span[2], is_on[2], jumps = 0;
    for (int d = 0; d < 2; d++) {
        is_on[d] = taut_net_on_break(surface, d, at, &span[d]);
    }
    for (int k = 1; k < 4; k++) {
        const int beside[2] = {span[0] - (k & 1), span[1] - (k >> 1)};
        taut_forms first, other;
        if (((k & 1) != 0 && !is_on[0]) || (k >= 2 && !is_on[1])) {
            continue;
        }
        taut_net_side_forms(surface, span, at, &first);
        taut_net_side_forms(surface, beside, at, &other);
        jumps |= !(taut_distance(first.normal, other.normal) <= crease);
    }
    return jumps;
}

/* Does a place lie on the line, or the edge, of a seed? */
static int is_on_seed(const taut_net_audit *audit, int on, const taut_trace_seed *seed,
                      const double at[2], double way[2])
{
    const int d = seed->edge >= TAUT_EDGE_V0; /* the parameter that the edge holds */
    double from[2] = {seed->at[0], seed->at[1]};

    if (seed->kind == TAUT_TRACE_EDGE) {
        const int is_high = seed->edge == TAUT_EDGE_U1 || seed->edge == TAUT_EDGE_V1;
        const taut_basis *side = side_of(audit, on, d);
        from[d] = is_high ? taut_basis_hi(side) : taut_basis_lo(side);
        from[1 - d] = at[1 - d];
        way[d] = 0;
        way[1 - d] = 1;
    } else {
        way[0] = seed->to[0] - from[0];
        way[1] = seed->to[1] - from[1];
    }
    const double across = (at[0] - from[0]) * way[1] - (at[1] - from[1]) * way[0];
    const double room = one_place * fmax(width_of(audit, on, 0), width_of(audit, on, 1));
    return (seed->kind == TAUT_TRACE_EDGE || seed->kind == TAUT_TRACE_LINE) &&
           fabs(across) <= room * taut_hypot(way[0], way[1]);
}

/* The least of what the net says of the directions of the document's lines there: 0 along its curves. */
static double along_off(const taut_net_audit *audit, int family, int on, const double at[2],
                        const taut_forms *f)
{
    const taut_trace_problem *p = audit->problem;
    const double radius = sqrt(fmax(f->mean * f->mean - f->gaussian, 0));
    double least = p != NULL ? (double)INFINITY : 0;
    for (int k = 0; p != NULL && k < p->seed_count; k++) {
        double way[2], off = INFINITY;
        if (!is_on_seed(audit, on, &p->seeds[k], at, way)) {
            continue;
        }
        if (audit->lines->net == TAUT_TRACE_ISOPARAMETRIC) {
            off = way[family == 0 ? 0 : 1] / taut_hypot(way[0], way[1]);
        } else if (taut_net_is_of_family(audit->lines->net, family, f, way, &off)) {
            off /= radius;
        } else {
            off = INFINITY;
        }
        least = fmin(least, along_share * fabs(off));
    }
    return least;
}

/* With the document: may a seed of it be there? Those of lattices and of laths may be anywhere. */
static int may_be_seed(const taut_net_audit *audit, int on, const double at[2])
{
    const taut_trace_problem *p = audit->problem;
    int may_be = p == NULL || p->seed_count == 0;
    for (int k = 0; !may_be && k < p->seed_count; k++) {
        const taut_trace_seed *seed = &p->seeds[k];
        double way[2];
        const int is_anywhere = seed->kind != TAUT_TRACE_EDGE && seed->kind != TAUT_TRACE_LINE &&
                                seed->kind != TAUT_TRACE_AT;
        may_be = is_anywhere || is_on_seed(audit, on, seed, at, way);
    }
    return may_be;
}

/* A step of the family's direction from a place, `side` of it as long as h in space, by the direction at `by`; 0: where the
 * net does not exist. */
static int step_to(const taut_net_audit *audit, int family, int on, const double from[2],
                   const double by[2], double h, double way[2], double to[2])
{
    const double last[2] = {way[0], way[1]};
    taut_forms f;
    if (!taut_net_cells_look(audit->cells, on, by, NULL, &f) || !f.regular ||
        !taut_net_family_way(audit->lines->net, family, &f, way) ||
        (audit->lines->net == TAUT_TRACE_ASYMPTOTIC && !(f.gaussian < 0))) {
        return 0;
    }
    const double a = way[0], b = way[1];
    const double length = sqrt(f.e * a * a + 2 * f.f * a * b + f.g * b * b);
    const double sign = a * last[0] + b * last[1] < 0 ? -1 : 1;
    for (int d = 0; d < 2; d++) {
        way[d] *= sign / length;
        to[d] = from[d] + h * way[d];
    }
    return 1;
}

/* Does the curve through a place leave the window, or what has the net, both ways at once? By the midpoint rule, so that it is
 * seen to bend out where it touches the border. */
static int leaves_both_ways(const taut_net_audit *audit, int family, int on, const double at[2])
{
    const double h = out_within * audit->size;
    int leaves = 1;
    for (int side = -1; leaves && side <= 1; side += 2) {
        double way[2] = {0, 0}, middle[2], end[2], none[2];
        int goes_on = step_to(audit, family, on, at, at, side * h / 2, way, middle);
        for (int d = 0; goes_on && d < 2; d++) {
            const taut_basis *basis = side_of(audit, on, d);
            middle[d] = fmin(fmax(middle[d], taut_basis_lo(basis)), taut_basis_hi(basis));
        }
        goes_on = goes_on && step_to(audit, family, on, at, middle, side * h, way, end);
        leaves = !goes_on || !is_inside(audit, on, end) ||
                 !step_to(audit, family, on, end, end, h, way, none);
    }
    return leaves;
}

/* How far a reason is from what the surface is there. */
static double reason_off(const taut_net_audit *audit, const taut_record *left, int family)
{
    const int on = taut_net_surface_of(audit, left);
    const char *word = taut_net_text(left, "reason");
    double at[2];
    taut_forms f;

    place_told(left, at);
    if (!is_inside(audit, on, at) || !may_be_seed(audit, on, at)) {
        return INFINITY;
    }
    if (strcmp(word, "crease") == 0) {
        return is_crease(audit->cells->surfaces[on], at) ? 0 : (double)INFINITY;
    }
    const int is_known = taut_net_cells_look(audit->cells, on, at, NULL, &f) && f.regular;
    if (strcmp(word, "singular") == 0) {
        return !is_known || f.w <= no_normal * widest(audit, on) ? 0 : (double)INFINITY;
    }
    if (!is_known) {
        return INFINITY;
    }
    const double largest =
        fmax(fmax(audit->roundest, least_share / audit->size), least_share * fabs(f.mean));
    const double radius = sqrt(fmax(f.mean * f.mean - f.gaussian, 0));
    if (strcmp(word, "elliptic") == 0) {
        return audit->lines->net == TAUT_TRACE_ASYMPTOTIC &&
                       f.gaussian >= -no_sign * fmax(f.mean * f.mean, radius * radius)
                   ? 0
                   : (double)INFINITY;
    }
    if (strcmp(word, "flat") == 0) {
        return radius <= round_point * largest && (audit->lines->net != TAUT_TRACE_ASYMPTOTIC ||
                                                   fabs(f.mean) <= flat_point * largest)
                   ? 0
                   : (double)INFINITY;
    }
    if (strcmp(word, "short") == 0) {
        return leaves_both_ways(audit, family, on, at) ? 0 : (double)INFINITY;
    }
    return strcmp(word, "along") == 0 ? along_off(audit, family, on, at, &f) : (double)INFINITY;
}

static void look_at_left_out(const taut_net_audit *audit, taut_net_off *off)
{
    static const char *const families[4][2] = {{"+", "-"}, {"max", "min"}, {"G", "G"}, {"u", "v"}};
    const taut_record *list = taut_record_get(taut_model_details(audit->lines->model), "left_out");
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *left = taut_record_at(list, k);
        const char *word = taut_net_text(left, "family");
        int family = -1;
        for (int i = 1; i >= 0; i--) {
            family = strcmp(word, families[audit->lines->net][i]) == 0 ? i : family;
        }
        taut_net_off_take(off, family >= 0 ? reason_off(audit, left, family) : (double)INFINITY,
                          "left_out", taut_net_text(left, "reason"));
    }
}

/* ---- the share of K < 0 ---- */

/* [0]: of places where K < 0 for sure, [1]: of those where it may be. */
static void share_of(const taut_net_audit *audit, int on, double share[2])
{
    const double area = audit->roundest * audit->roundest;
    int count[2] = {0, 0};
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double at[2] = {
                taut_basis_lo(side_of(audit, on, 0)) + width_of(audit, on, 0) * i / (GRID - 1),
                taut_basis_lo(side_of(audit, on, 1)) + width_of(audit, on, 1) * j / (GRID - 1)};
            taut_forms f;
            const int is_known = taut_net_cells_look(audit->cells, on, at, NULL, &f) && f.regular;
            const double room = is_known ? no_sign * fmax(f.mean * f.mean, area) : 0;
            count[0] += is_known && f.gaussian < -room;
            count[1] += !is_known || f.gaussian < room;
        }
    }
    for (int k = 0; k < 2; k++) {
        share[k] = count[k] / (double)(GRID * GRID);
    }
}

static void look_at_share(const taut_net_audit *audit, taut_net_off *off)
{
    const taut_record *details = taut_model_details(audit->lines->model);
    const double told = taut_net_number(details, "hyperbolic_share");
    const int surfaces = audit->lines->surface_count;
    double least = 0, most = 0;
    if (audit->is_saddle && told == 1) { /* no grid can tell more */
        return;
    }
    for (int on = 0; on < surfaces; on++) {
        double share[2] = {1, 1}; /* of minimal surfaces K < 0 everywhere */
        if (!audit->is_minimal) {
            share_of(audit, on, share);
        }
        least += share[0] / surfaces;
        most += share[1] / surfaces;
    }
    taut_net_off_take(off, isnan(told) ? told : fmax(fmax(least - told, told - most), 0), "net",
                      "hyperbolic_share");
}

taut_status taut_net_told_look(const taut_net_audit *audit, taut_arena *arena, taut_net_off *off)
{
    taut_status status = look_at_names(audit, arena, off);
    if (status == TAUT_OK) {
        status = look_at_kinks(audit, arena, off);
    }
    if (status == TAUT_OK) {
        look_at_way(audit, off);
        look_at_borders(audit, off);
        look_at_left_out(audit, off);
        look_at_share(audit, off);
        taut_net_turns_look(audit, off);
    }
    return status;
}
