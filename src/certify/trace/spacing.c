/* spacing.c
 *
 *     the measure along the seed's line by Gauss's rule between the surface's breaks
 *     the measures at which curves of the family cross it, by their places in the window
 *     of each place that cuts it in equal parts: the nearest of them
 *     on curves that others are seeded on the measure along them, and the nodes at the lengths that details give, which the claim
 *     `nodes` finds on both curves
 *     of a lattice the border once around as well (certify/trace/border.h)
 *     of a place that a curve is seeded at the nearest curve of the family, in space; of geodesics its direction and its end too
 */
#include "certify/trace/spacing.h"

#include "certify/trace/border.h"
#include "certify/trace/family.h"
#include "certify/trace/side.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <math.h>
#include <string.h>

enum { PIECES = 16 /* between two breaks */, NODES = 8, HALVINGS = 60, ROUNDS = 8 };
/* Over the window's sides: a place lies on the line. Of |k_n| and such, over R: the line runs along the family. */
static const double on_line = 1e-12, along = 1e-5;
/* Over the size: a curve begins or ends at a place; and the sine of a geodesic's angle to where it is sent. */
static const double at_end = 1e-9, same_way = 1e-6;
/* Over the window's sides: a place that is said to have no curve as it would be too short. */
static const double short_place = 1e-6;
/* Of a part, as curves are seeded round the border by a rule that has an error where the net ends. */
static const double bare_border = 0.1;
/* K over H^2 that no rounding makes; and of the line, how far it is seen beside a place. */
static const double plainly = 1e-6, beside_it = 1e-4;
/* Over a part: no curve is measured again. */
static const double enough = 1e-9;
static const taut_trace_seed as_default = {.kind = TAUT_TRACE_CELLS, .count = 8};

typedef struct line {
    taut_net_cells *cells;
    int on;     /* the surface that it lies on */
    double fit; /* how far curves are from it, in the document's unit */
    const taut_surface *surface;
    taut_trace_net net;
    taut_trace_by by;
    double from[2], way[2];
    double *t, *sum; /* [count + 1] */
    int count;
    int sides
        [2]; /* of a break that a curve of the net runs on, up to its node and on: 0 below, 1 above; -1: not asked */
} line;

static void place_on(const line *l, double t, double at[2])
{
    const taut_basis *basis[2] = {taut_surface_u(l->surface), taut_surface_v(l->surface)};
    for (int d = 0; d < 2; d++) {
        at[d] = fmin(fmax(l->from[d] + t * l->way[d], taut_basis_lo(basis[d])),
                     taut_basis_hi(basis[d]));
    }
}

static double rate_at(const line *l, double t)
{
    double at[2];
    taut_forms f;

    if (l->by == TAUT_TRACE_PARAMETER) {
        return 1;
    }
    place_on(l, t, at);
    if (!taut_net_cells_look(l->cells, l->on, at, NULL, &f)) {
        return 0;
    }
    const double u = l->way[0], v = l->way[1];
    const double speed = sqrt(f.e * u * u + 2 * f.f * u * v + f.g * v * v);
    if (l->by == TAUT_TRACE_LENGTH || l->net == TAUT_TRACE_ISOPARAMETRIC) {
        return speed;
    }
    const double measure = l->net == TAUT_TRACE_ASYMPTOTIC
                               ? sqrt(fmax(-f.gaussian, 0))
                               : sqrt(fmax(f.mean * f.mean - f.gaussian, 0));
    return sqrt(measure) * speed;
}

static double measure_between(const line *l, double a, double b)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES; k++) {
        sum += weights[k] * rate_at(l, (a + b) / 2 + (b - a) / 2 * nodes[k]);
    }
    return sum * (b - a) / 2;
}

static void add_break(double t, double *breaks, int *count)
{
    int k = *count;
    if (!(t > 0) || !(t < 1)) {
        return;
    }
    for (; k > 0 && breaks[k - 1] > t; k--) {
        breaks[k] = breaks[k - 1];
    }
    breaks[k] = t;
    (*count)++;
}

static taut_status measure_line(taut_arena *arena, line *l)
{
    const taut_basis *basis[2] = {taut_surface_u(l->surface), taut_surface_v(l->surface)};
    const size_t most =
        (size_t)taut_basis_span_count(basis[0]) + (size_t)taut_basis_span_count(basis[1]) + 2;
    double *breaks = taut_arena_take(arena, most, sizeof *breaks);
    int count = 0;

    l->t = taut_arena_take(arena, PIECES * most + 1, sizeof *l->t);
    l->sum = taut_arena_take(arena, PIECES * most + 1, sizeof *l->sum);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int d = 0; d < 2; d++) {
        for (int k = 1; l->way[d] != 0 && k < taut_basis_span_count(basis[d]); k++) {
            add_break((taut_basis_breaks(basis[d])[k] - l->from[d]) / l->way[d], breaks, &count);
        }
    }
    for (int i = 0; i <= count; i++) {
        const double a = i > 0 ? breaks[i - 1] : 0, b = i < count ? breaks[i] : 1;
        for (int k = 1; k <= PIECES; k++) {
            const double before = l->t[l->count], next = k < PIECES ? a + (b - a) * k / PIECES : b;
            l->sum[l->count + 1] = l->sum[l->count] + measure_between(l, before, next);
            l->t[++l->count] = next;
        }
    }
    return TAUT_OK;
}

static double measure_to(const line *l, double t)
{
    int k = 0;
    while (k + 1 < l->count && l->t[k + 1] < t) {
        k++;
    }
    return l->sum[k] + measure_between(l, l->t[k], t);
}

/* t near to where the measure is `target`: to ask what the surface is like there, not to measure by. */
static double reach(const line *l, double target)
{
    int k = 0;
    while (k + 1 < l->count && l->sum[k + 1] < target) {
        k++;
    }
    const double part = l->sum[k + 1] - l->sum[k];
    const double share = part > 0 ? (target - l->sum[k]) / part : 1;
    return l->t[k] + fmin(fmax(share, 0), 1) * (l->t[k + 1] - l->t[k]);
}

/* How far the family's direction goes along d for 1 along the other parameter, or more times both. 0 where the net does not
 * exist. */
static int slope_of(taut_trace_net net, int family, const taut_forms *f, int d, double *slope)
{
    double way[2];
    if (!taut_net_family_way(net, family, f, way)) {
        return 0;
    }
    *slope = way[d] * copysign(1, way[1 - d]);
    return 1;
}

/* Of a line on the border, where a knot meets it: the curve has a corner there, as curvatures jump, and may have the
 * window on neither side of it. */
static int only_touches(const line *l, int family, const double at[2])
{
    const int d = l->way[0] != 0; /* held */
    const int e = 1 - d;
    const taut_basis *basis = d == 0 ? taut_surface_u(l->surface) : taut_surface_v(l->surface);
    const int is_low = at[d] == taut_basis_lo(basis), is_high = at[d] == taut_basis_hi(basis);
    int span[2], known = 0;

    if (l->way[d] != 0 || (!is_low && !is_high) ||
        !taut_net_on_break(l->surface, e, at, &span[e])) {
        return 0;
    }
    taut_net_on_break(l->surface, d, at, &span[d]);
    for (int side = 0; side < 2; side++) {
        const int cell[2] = {span[0] - (e == 0 && side), span[1] - (e == 1 && side)};
        taut_forms f;
        double slope = 0;
        taut_net_side_forms(l->surface, cell, at, &f);
        if (!slope_of(l->net, family, &f, e, &slope)) {
            continue;
        }
        slope *= is_low ? 1 : -1; /* into the window */
        if (side == 0 ? slope >= 0 : slope <= 0) {
            return 0;
        }
        known++;
    }
    return known > 0;
}

/* In a corner of the window: does the curve leave it at once, both ways? */
static int only_passes(const line *l, int family, const double at[2], const taut_forms *f)
{
    double inside = 1, slope = 0;
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(l->surface) : taut_surface_v(l->surface);
        const int is_low = at[d] == taut_basis_lo(basis), is_high = at[d] == taut_basis_hi(basis);
        inside *= is_low ? 1 : is_high ? -1 : 0;
    }
    return inside != 0 && slope_of(l->net, family, f, 0, &slope) && !(inside * slope > 0);
}

/* Is there a curve of the family at t of the line, and does it cross it? */
static int is_wanted(const line *l, int family, double t)
{
    double at[2];
    taut_forms f;

    place_on(l, t, at);
    if (!taut_net_cells_look(l->cells, l->on, at, NULL, &f) || !f.regular) {
        return 0;
    }
    const double square = f.mean * f.mean - f.gaussian, a = l->way[0], b = l->way[1];
    if (l->net == TAUT_TRACE_ISOPARAMETRIC) {
        return fabs(family == 0 ? a : b) > along * (fabs(a) + fabs(b));
    }
    if (!(square > 0) || (l->net == TAUT_TRACE_ASYMPTOTIC && !(-f.gaussian > 1e-9 * square))) {
        return 0;
    }
    double off = 0;
    const int is_family = taut_net_is_of_family(l->net, family, &f, l->way, &off);
    return (!is_family || fabs(off) > along * sqrt(square)) && !only_touches(l, family, at) &&
           !only_passes(l, family, at, &f);
}

/* How far a place of the window is to the left of the line, and its t. */
static double beside(const line *l, const double at[2], double *t)
{
    const double x = at[0] - l->from[0], y = at[1] - l->from[1];
    const double square = l->way[0] * l->way[0] + l->way[1] * l->way[1];
    *t = (x * l->way[0] + y * l->way[1]) / square;
    return (l->way[0] * y - l->way[1] * x) / square;
}

/* Adds the measures at which a stretch of a curve in the window crosses the line. */
static void add_crossings(const line *l, const taut_curve *stretch, double *crossings, int *count)
{
    const taut_basis *basis = taut_curve_t(stretch);
    const double *breaks = taut_basis_breaks(basis);
    double at[3], t = 0, before = 0;

    for (int k = 0; k <= taut_basis_span_count(basis); k++) {
        taut_curve_eval(stretch, breaks[k], 0, at);
        const double here = beside(l, at, &t);
        int crosses = fabs(here) <= on_line;
        if (!crosses && k > 0 && fabs(before) > on_line && (here > 0) != (before > 0)) {
            double low = breaks[k - 1], high = breaks[k];
            for (int round = 0; round < HALVINGS; round++) {
                const double middle = (low + high) / 2;
                taut_curve_eval(stretch, middle, 0, at);
                *((beside(l, at, &t) > 0) == (before > 0) ? &low : &high) = middle;
            }
            crosses = 1;
        }
        if (crosses && t >= -on_line && t <= 1 + on_line) {
            crossings[(*count)++] = measure_to(l, fmin(fmax(t, 0), 1));
        }
        before = here;
    }
}

/* The measures at which curves of a family cross the line. NULL: no memory. */
static double *find_crossings(const line *l, const taut_net_lines *lines, int family,
                              taut_arena *arena, int *count)
{
    size_t most = 1;
    for (int i = 0; i < lines->count; i++) {
        const taut_net_line *curve = &lines->lines[i];
        for (int k = 0; k < curve->count; k++) {
            most += (size_t)taut_basis_span_count(taut_curve_t(curve->window[k])) + 1;
        }
    }
    double *crossings = taut_arena_take_raw(arena, most, sizeof *crossings);
    *count = 0;
    for (int i = 0; crossings != NULL && i < lines->count; i++) {
        const taut_net_line *curve = &lines->lines[i];
        for (int k = 0; curve->family == family && k < curve->count; k++) {
            if (curve->on[k] == l->on) {
                add_crossings(l, curve->window[k], crossings, count);
            }
        }
    }
    return crossings;
}

/* Are both ends of the line one place in space, as where the window closes? */
static int is_closed(const line *l)
{
    double at[2], x[2][3];
    for (int end = 0; end < 2; end++) {
        place_on(l, end, at);
        if (taut_surface_eval(l->surface, at[0], at[1], 0, x[end]) != TAUT_OK) {
            return 0;
        }
    }
    return taut_distance(x[0], x[1]) <= at_end;
}

/* Is K clearly above 0 there and beside it, as across a knot line, so that no asymptotic curve is? */
static int is_elliptic(const line *l, double t)
{
    int all = l->net == TAUT_TRACE_ASYMPTOTIC;

    for (int k = -1; all && k <= 1; k++) {
        double at[2];
        taut_forms f;
        place_on(l, fmin(fmax(t + k * beside_it, 0), 1), at);
        all = taut_net_cells_look(l->cells, l->on, at, NULL, &f) && f.regular &&
              f.gaussian > plainly * f.mean * f.mean;
    }
    return all;
}

/* Do details tell of a seed of the family, at this measure of the line, that was left out? */
static int is_left_out(const line *l, const taut_net_lines *lines, int family, double measure,
                       double room)
{
    const taut_record *list = taut_record_get(taut_model_details(lines->model), "left_out");
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *left = taut_record_at(list, k), *place = taut_record_get(left, "at");
        const double at[2] = {taut_record_number(taut_record_at(place, 0)),
                              taut_record_number(taut_record_at(place, 1))};
        double t = 0;
        if (strcmp(taut_record_text(taut_record_get(left, "family")), family == 0 ? "+" : "-") ==
                0 &&
            fabs(beside(l, at, &t)) <= at_end && t >= -at_end && t <= 1 + at_end &&
            fabs(measure_to(l, fmin(fmax(t, 0), 1)) - measure) <= room) {
            return 1;
        }
    }
    return 0;
}

static taut_status judge(const line *l, const taut_net_lines *lines, int family,
                         const taut_trace_seed *seed, taut_arena *arena, double *worst)
{
    const double whole = l->sum[l->count], part = whole / (seed->count + 1);
    int count = 0;
    const double *crossings = find_crossings(l, lines, family, arena, &count);
    const int closes = is_closed(l), last = seed->count + 1;

    *worst = 0;
    if (crossings == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = seed->ends ? 0 : 1; k <= seed->count + (seed->ends ? 1 : 0); k++) {
        const int is_end = k == 0 || k == last;
        double best = INFINITY;
        if (part > 0 && !is_end && lines->surface_count == 1 &&
            is_elliptic(l, reach(l, k * part)) &&
            !is_left_out(l, lines, family, k * part, same_way * part)) {
            *worst = INFINITY;
        }
        if (!(part > 0) || !is_wanted(l, family, reach(l, k * part)) ||
            (is_end && lines->surface_count > 1)) { /* it may lie on the next surface */
            continue;
        }
        for (int i = 0; i < count; i++) {
            best = fmin(best, fabs(crossings[i] - k * part));
            best = is_end && closes ? fmin(best, fabs(crossings[i] - (last - k) * part)) : best;
        }
        *worst = fmax(*worst, best / part);
    }
    return TAUT_OK;
}

/* The surface that a seed lies on. */
static int surface_of(const taut_net_lines *lines, const taut_trace_problem *problem,
                      const taut_trace_seed *seed)
{
    const char *name = seed->surface != NULL ? seed->surface : problem->surface;
    for (int k = 0; name != NULL && lines->surface_count > 1 && k < lines->surface_count; k++) {
        if (strcmp(taut_surface_name(taut_model_surface(lines->model, k)), name) == 0) {
            return k;
        }
    }
    return 0;
}

static line line_of(const taut_net_lines *lines, taut_net_cells *cells, double fit,
                    const taut_trace_problem *problem, const taut_trace_seed *seed)
{
    const int on = surface_of(lines, problem, seed);
    const taut_surface *surface = cells->surfaces[on];
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const double lo[2] = {taut_basis_lo(bu), taut_basis_lo(bv)};
    const double hi[2] = {taut_basis_hi(bu), taut_basis_hi(bv)};
    line l = {.cells = cells,
              .on = on,
              .surface = surface,
              .net = problem->net,
              .by = seed->by,
              .fit = fit * lines->size};

    for (int d = 0; d < 2; d++) {
        double from = seed->at[d], to = seed->to[d];
        if (seed->kind == TAUT_TRACE_EDGE) {
            const int held = seed->edge == TAUT_EDGE_U0 || seed->edge == TAUT_EDGE_U1 ? 0 : 1;
            const int high = seed->edge == TAUT_EDGE_U1 || seed->edge == TAUT_EDGE_V1;
            from = d == held && high ? hi[d] : lo[d];
            to = d == held && !high ? lo[d] : hi[d];
        }
        l.from[d] = from;
        l.way[d] = to - from;
    }
    return l;
}

/* ---- along curves of the net ---- */

/* A curve that is parted, and where others cross it, as lengths along it that details.nodes gives. */
typedef struct parted {
    const line *l; /* surface, net, by */
    const taut_net_line *curve;
    double turn; /* where its node is */
    int closes;  /* its ends are one place */
    double *sum; /* [spans + 1]: the measure at its breaks */
    double whole;
    double *crossings; /* measures */
    int count;
    const taut_record *left_out;
} parted;

/* The forms at t of the curve; 0 where they are not known. */
static int forms_on(const parted *p, double t, taut_forms *f)
{
    double at[2];
    int on = 0;
    if (!taut_net_line_window(p->curve, t, at, &on)) {
        return 0;
    }
    const taut_surface *surface = p->l->cells->surfaces[on];
    const int side = p->l->sides[t >= p->turn];
    int span[2], is_on = 0;
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        at[d] = fmin(fmax(at[d], taut_basis_lo(basis)), taut_basis_hi(basis));
        const int is_break = taut_net_on_break(surface, d, at, &span[d]);
        span[d] -= is_break && side == 0;
        is_on |= is_break;
    }
    if (is_on && side >= 0) {
        taut_net_side_forms(surface, span, at, f);
        return f->regular;
    }
    return taut_net_cells_look(p->l->cells, on, at, NULL, f);
}

static double rate_on(const parted *p, double t)
{
    taut_forms f;
    if (p->l->by != TAUT_TRACE_CONFORMAL || p->l->net == TAUT_TRACE_ISOPARAMETRIC) {
        return 1;
    }
    if (!forms_on(p, t, &f)) {
        return 0;
    }
    const double square =
        p->l->net == TAUT_TRACE_ASYMPTOTIC ? -f.gaussian : f.mean * f.mean - f.gaussian;
    return sqrt(sqrt(fmax(square, 0)));
}

static double measure_on(const parted *p, double a, double b)
{
    double nodes[NODES], weights[NODES], sum = 0;
    taut_gauss_rule(NODES, nodes, weights);
    for (int k = 0; k < NODES; k++) {
        sum += weights[k] * rate_on(p, (a + b) / 2 + (b - a) / 2 * nodes[k]);
    }
    return sum * (b - a) / 2;
}

static double measure_up_to(const parted *p, double t)
{
    const taut_basis *basis = taut_curve_t(p->curve->space);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    const int span = taut_basis_span(basis, fmin(fmax(t, lo), hi));
    return p->sum[span] + measure_on(p, taut_basis_breaks(basis)[span], fmin(fmax(t, lo), hi));
}

/* Does a node's name begin with this curve's (side 0), or end with it? */
static int is_of(const char *node, const char *curve, int side)
{
    const size_t length = strlen(curve), whole = strcspn(node, ".");
    const char *from = side == 0 ? node : node + whole - length;
    return whole > length && strncmp(from, curve, length) == 0 &&
           !(side == 0 && node[length] >= '0' && node[length] <= '9');
}

static int ends_meet(const taut_net_line *curve)
{
    const taut_basis *basis = taut_curve_t(curve->space);
    double x[2][3];
    return taut_curve_eval(curve->space, taut_basis_lo(basis), 0, x[0]) == TAUT_OK &&
           taut_curve_eval(curve->space, taut_basis_hi(basis), 0, x[1]) == TAUT_OK &&
           taut_distance(x[0], x[1]) <= at_end * curve->length;
}

static taut_status part_curve(const taut_net_lines *lines, const line *l,
                              const taut_net_line *curve, double turn, taut_arena *arena, parted *p)
{
    const taut_record *nodes = taut_record_get(taut_model_details(lines->model), "nodes");
    const taut_basis *basis = taut_curve_t(curve->space);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);

    *p = (parted){.l = l,
                  .curve = curve,
                  .turn = turn,
                  .left_out = taut_record_get(taut_model_details(lines->model), "left_out")};
    p->sum = taut_arena_take(arena, (size_t)spans + 1, sizeof *p->sum);
    p->crossings = taut_arena_take(arena, taut_record_count(nodes) + 1, sizeof *p->crossings);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < spans; k++) {
        p->sum[k + 1] = p->sum[k] + measure_on(p, breaks[k], breaks[k + 1]);
    }
    p->whole = p->sum[spans];
    p->closes = ends_meet(curve);
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k);
        if (is_of(taut_record_text(taut_record_get(node, "node")), taut_curve_name(curve->space),
                  curve->family)) {
            const taut_record *s = taut_record_get(node, "s");
            p->crossings[p->count++] =
                measure_up_to(p, taut_record_number(taut_record_at(s, (size_t)curve->family)));
        }
    }
    return TAUT_OK;
}

/* Is there a curve of the other family where the measure is `target`? *rate: of the measure there. */
static int exists_on(const parted *p, double target, double *rate)
{
    const taut_basis *basis = taut_curve_t(p->curve->space);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    taut_forms f;
    int k = 0;
    while (k + 1 < spans && p->sum[k + 1] < target) {
        k++;
    }
    const double part = p->sum[k + 1] - p->sum[k];
    const double share = part > 0 ? fmin(fmax((target - p->sum[k]) / part, 0), 1) : 1;
    const double t = breaks[k] + share * (breaks[k + 1] - breaks[k]);
    if (!forms_on(p, t, &f) || !f.regular) {
        return 0;
    }
    *rate = rate_on(p, t);
    const double square = f.mean * f.mean - f.gaussian;
    return p->l->net == TAUT_TRACE_ISOPARAMETRIC ||
           (square > 0 && (p->l->net != TAUT_TRACE_ASYMPTOTIC || -f.gaussian > 1e-9 * square));
}

/* Is a curve of the other family said to be too short where the measure is `target`? Whether it is, the claim `figures` sees. */
static int is_short(const parted *p, double target)
{
    const taut_basis *t_basis = taut_curve_t(p->curve->space);
    const double lo = taut_basis_lo(t_basis), hi = taut_basis_hi(t_basis);
    double at[2], t = lo + (hi - lo) * target / p->whole;
    int on = 0, found = 0;
    for (int round = 0; taut_record_count(p->left_out) > 0 && round < ROUNDS; round++) {
        t = fmin(fmax(t + (target - measure_up_to(p, t)) / rate_on(p, t), lo), hi);
    }
    for (size_t k = 0; !found && k < taut_record_count(p->left_out); k++) {
        const taut_record *left = taut_record_at(p->left_out, k);
        const taut_record *place = taut_record_get(left, "at");
        found = strcmp(taut_record_text(taut_record_get(left, "reason")), "short") == 0 &&
                taut_net_line_window(p->curve, t, at, &on);
        for (size_t d = 0; found && d < 2; d++) {
            const taut_surface *surface = p->l->cells->surfaces[on];
            const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
            found = fabs(taut_record_number(taut_record_at(place, d)) - at[d]) <=
                    short_place * (taut_basis_hi(basis) - taut_basis_lo(basis));
        }
    }
    return found;
}

/* How far the nearest crossing is from a target, over a part, by more than the curve itself is from its place; 0 where there is
 * no curve to cross or one that is too short, and at the ends of the curve, where the other one may leave the window at once. */
static double miss(const parted *p, double target, double part)
{
    const double room = 1e-9 * part;
    double best = INFINITY, rate = 0;
    if (!(target > room) || !(target < p->whole - room) || !exists_on(p, target, &rate)) {
        return 0;
    }
    for (int k = 0; k < p->count; k++) {
        best = fmin(best, fabs(p->crossings[k] - target));
    }
    const double away = fmax(best - p->l->fit * rate, 0);
    return away > room && is_short(p, target) ? 0 : away / part;
}

static taut_status judge_lath(const taut_net_lines *lines, const line *l,
                              const taut_trace_seed *seed, taut_arena *arena, double *worst)
{
    const taut_net_line *curve = NULL;
    parted p;
    for (int i = 0; i < lines->count; i++) {
        const char *name = taut_curve_name(lines->lines[i].space);
        curve = strcmp(name, seed->lath) == 0 ? &lines->lines[i] : curve;
    }
    *worst = INFINITY; /* the curve is missing */
    if (curve == NULL) {
        return TAUT_OK;
    }
    if (part_curve(lines, l, curve, INFINITY, arena, &p) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const double part = p.whole / (seed->count + 1);
    *worst = 0;
    for (int k = 1; k <= seed->count; k++) {
        *worst = fmax(*worst, miss(&p, k * part, part));
    }
    return TAUT_OK;
}

/* Is a curve at s where the seed is, in the window? */
static int is_there(const line *l, const taut_net_line *curve, double s, const double at[2])
{
    double there[2];
    int on = 0, is_near = taut_net_line_window(curve, s, there, &on) && on == l->on;
    for (int d = 0; is_near && d < 2; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(l->surface) : taut_surface_v(l->surface);
        is_near = fabs(there[d] - at[d]) <= 1e-9 * (taut_basis_hi(basis) - taut_basis_lo(basis));
    }
    return is_near;
}

/* The two curves that cross at a place, and the length of the first and the second there; 0: none do. */
static int crossing_at(const taut_net_lines *lines, const line *l, const double at[2],
                       const taut_net_line *through[2], double s[2])
{
    const taut_record *nodes = taut_record_get(taut_model_details(lines->model), "nodes");
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k);
        const char *name = taut_record_text(taut_record_get(node, "node"));
        for (size_t d = 0; d < 2; d++) {
            s[d] = taut_record_number(taut_record_at(taut_record_get(node, "s"), d));
        }
        through[0] = through[1] = NULL;
        for (int i = 0; i < lines->count; i++) {
            const taut_net_line *one = &lines->lines[i];
            if (is_of(name, taut_curve_name(one->space), one->family) &&
                is_there(l, one, s[one->family], at)) {
                through[one->family] = one;
            }
        }
        if (through[0] != NULL && through[1] != NULL) {
            return 1;
        }
    }
    return 0;
}

/* How much more than a part there is on the border without an end of a curve, over a part: where corners are reached. */
static taut_status judge_border(const taut_net_lines *lines, const line *l, int unit, double part,
                                taut_arena *arena, double *worst)
{
    for (int family = 0; family < 2; family++) {
        double gap = 0;
        if (taut_net_border_gap(lines, l->cells, l->on, family, l->by, ldexp(part, -unit), arena,
                                &gap) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        const double more = ldexp(gap, unit) / part - 1;
        *worst = more > bare_border ? fmax(*worst, more) : *worst;
    }
    return TAUT_OK;
}

/* The worst of all multiples of a part from a place of a curve. */
static double miss_any(const parted *p, double middle, double part)
{
    const double room = 1e-9 * part;
    const double first = ceil((-middle - room) / part),
                 last = floor((p->whole - middle + room) / part);
    double worst = 0;
    for (double k = first; k <= last && last - first < TAUT_TRACE_LATHS_MAX; k++) {
        worst = fmax(worst, miss(p, middle + k * part, part));
    }
    return worst;
}

/* The lattice of `cells` on the two curves through its node; -1 where only one family was asked for. */
static taut_status judge_cells(const taut_net_lines *lines, const line *l, int unit,
                               const taut_trace_seed *seed, int families, taut_arena *arena,
                               double *worst)
{
    const taut_net_line *through[2];
    double at[2] = {seed->at[0], seed->at[1]}, s[2];
    parted p[2];

    *worst = -1;
    for (int d = 0; d < 2 && !seed->has_at; d++) {
        const taut_basis *basis = d == 0 ? taut_surface_u(l->surface) : taut_surface_v(l->surface);
        const double lo = taut_basis_lo(basis);
        at[d] = lo + (taut_basis_hi(basis) - lo) / 2;
    }
    if (families != 3) {
        return TAUT_OK;
    }
    *worst = INFINITY;
    if (!crossing_at(lines, l, at, through, s)) {
        return TAUT_OK;
    }
    for (int f = 0; f < 2; f++) {
        if (part_curve(lines, l, through[f], s[f], arena, &p[f]) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    const double part = seed->kind == TAUT_TRACE_CELLS ? fmax(p[0].whole, p[1].whole) / seed->count
                                                       : seed->cell * rate_on(&p[0], s[0]);
    *worst = 0;
    for (int f = 0; f < 2; f++) {
        const double middle = measure_up_to(&p[f], s[f]);
        double here = miss_any(&p[f], middle, part);
        if (here > enough && p[f].closes) { /* it may be parted against its own way */
            here = fmin(here, miss_any(&p[f], middle > 0.5 * p[f].whole ? 0 : p[f].whole, part));
        }
        *worst = fmax(*worst, here);
    }
    return judge_border(lines, l, unit, part, arena, worst);
}

/* ---- at places ---- */

/* A place of the surface, over the size of the surface, and the way that the curve is sent. */
typedef struct target {
    double x[3], way[3];
} target;

static int target_of(const line *l, const double at[2], const double way[2], target *t)
{
    double s[3][3];
    if (taut_surface_eval(l->surface, at[0], at[1], 1, s[0]) != TAUT_OK) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        t->x[c] = s[0][c];
        t->way[c] = way[0] * s[1][c] + way[1] * s[2][c];
    }
    return 1;
}

/* The place of a curve nearest to a point, and how far it is; unit: of the surfaces. */
static double nearest(const taut_curve *curve, int unit, const double x[3], double *t)
{
    enum { LOOK = 4, STEPS = 12 };
    const taut_basis *basis = taut_curve_t(curve);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis);
    const double scale = ldexp(1, -unit);
    double best = INFINITY, c[2][3], away[3];

    for (int i = 0; i <= LOOK * spans; i++) {
        const int k = i / LOOK, j = i % LOOK;
        const double here = j == 0 ? breaks[k] : breaks[k] + (breaks[k + 1] - breaks[k]) * j / LOOK;
        taut_curve_eval(curve, here, 0, c[0]);
        for (int d = 0; d < 3; d++) {
            away[d] = scale * c[0][d] - x[d];
        }
        const double distance = taut_length(away);
        *t = distance < best ? here : *t;
        best = fmin(best, distance);
    }
    for (int round = 0; round < STEPS; round++) {
        double along_it = 0, square = 0;
        taut_curve_eval(curve, *t, 1, c[0]);
        for (int d = 0; d < 3; d++) {
            away[d] = scale * c[0][d] - x[d];
            along_it += away[d] * scale * c[1][d];
            square += scale * c[1][d] * scale * c[1][d];
        }
        best = fmin(best, taut_length(away));
        *t = fmin(fmax(*t - along_it / square, breaks[0]), breaks[spans]);
    }
    return best;
}

/* Does a geodesic that passes through its seed at t go where it is sent? */
static int goes(const line *l, const taut_net_line *curve, const taut_trace_seed *seed,
                const target *from, double t, int unit, double size)
{
    static const double none[2] = {0, 0};
    const double lo = taut_basis_lo(taut_curve_t(curve->space));
    const double hi = taut_basis_hi(taut_curve_t(curve->space));
    double c[2][3], across[3], end = 0;
    target to;

    if ((seed->has_to || !seed->both) && !(ldexp(t - lo, -unit) <= at_end * size)) {
        return 0;
    }
    if (seed->has_to) {
        return target_of(l, seed->to, none, &to) &&
               nearest(curve->space, unit, to.x, &end) <= at_end * size &&
               ldexp(hi - end, -unit) <= at_end * size;
    }
    taut_curve_eval(curve->space, t, 1, c[0]);
    taut_cross(c[1], from->way, across);
    const double lengths = taut_length(c[1]) * taut_length(from->way);
    return taut_length(across) <= same_way * lengths &&
           (seed->both || taut_dot(c[1], from->way) > 0);
}

/* How far the nearest curve of a family is from its seed, over the size; 0 where there is none to be. */
static double judge_at(const taut_net_lines *lines, const line *l, int unit, int family,
                       const taut_trace_seed *seed)
{
    const double size = ldexp(lines->size, -unit);
    double best = INFINITY, t = 0;
    target from;
    taut_forms f;

    if (!target_of(l, seed->at, seed->direction, &from) ||
        !taut_net_cells_look(l->cells, l->on, seed->at, NULL, &f) || !f.regular) {
        return 0;
    }
    const double square = f.mean * f.mean - f.gaussian;
    if ((l->net == TAUT_TRACE_ASYMPTOTIC && !(-f.gaussian > 1e-9 * square)) ||
        (l->net == TAUT_TRACE_PRINCIPAL && !(square > 0))) {
        return 0;
    }
    for (int i = 0; i < lines->count; i++) {
        const taut_net_line *curve = &lines->lines[i];
        if (curve->family != family) {
            continue;
        }
        const double away = nearest(curve->space, unit, from.x, &t) / size;
        if (away < best && (l->net != TAUT_TRACE_GEODESIC || away > at_end ||
                            goes(l, curve, seed, &from, t, unit, size))) {
            best = away;
        }
    }
    return best;
}

/* Of parts of curves of the net. A curve that runs on a break is measured beside it, where curvatures jump there: on one
 * side or on the other, and each way from its node anew. */
static taut_status judge_parts(const taut_net_lines *lines, line *l, int unit,
                               const taut_trace_seed *seed, int families, taut_arena *arena,
                               double *worst)
{
    const int is_lath = seed->kind == TAUT_TRACE_LATH;
    *worst = INFINITY;
    for (int k = -1; k < 4 && *worst > enough; k++) {
        double here = 0;
        l->sides[0] = k < 0 ? -1 : k % 2;
        l->sides[1] = k < 0 ? -1 : k / 2;
        const taut_status status = is_lath
                                       ? judge_lath(lines, l, seed, arena, &here)
                                       : judge_cells(lines, l, unit, seed, families, arena, &here);
        if (status != TAUT_OK) {
            return status;
        }
        *worst = fmin(*worst, here);
    }
    return TAUT_OK;
}

/* How far a seed is from being met: the worst of its families; -1 where that is not known. */
static taut_status judge_seed(const taut_net_lines *lines, taut_net_cells *cells, int unit,
                              double fit, const taut_trace_problem *problem,
                              const taut_trace_seed *seed, taut_arena *arena, double *worst)
{
    int families = seed->family != 0 ? seed->family : 3;
    line l = line_of(lines, cells, fit, problem, seed);

    families &= problem->families != 0 ? problem->families : 3;
    families = problem->net == TAUT_TRACE_GEODESIC ? 1 : families;
    *worst = -1;
    if (problem->net == TAUT_TRACE_GEODESIC && seed->kind != TAUT_TRACE_AT) {
        return TAUT_OK;
    }
    if (seed->kind == TAUT_TRACE_LATH || seed->kind == TAUT_TRACE_CELL ||
        seed->kind == TAUT_TRACE_CELLS) {
        return judge_parts(lines, &l, unit, seed, families, arena, worst);
    }
    if (seed->kind != TAUT_TRACE_AT && measure_line(arena, &l) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int family = 0; family < 2; family++) {
        double here = -1;
        if (!(families & (1 << family))) {
            continue;
        }
        if (seed->kind == TAUT_TRACE_AT) {
            here = judge_at(lines, &l, unit, family, seed);
        } else if (judge(&l, lines, family, seed, arena, &here) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        *worst = fmax(*worst, here);
    }
    return TAUT_OK;
}

taut_status taut_net_spacing(const taut_net_lines *lines, taut_net_cells *cells, int unit,
                             double fit, const taut_trace_problem *problem, taut_arena *arena,
                             double *residual, int *where)
{
    const int count = problem == NULL ? 0 : problem->seed_count > 0 ? problem->seed_count : 1;

    *residual = -1;
    for (int k = 0; k < count; k++) {
        const taut_trace_seed *seed = problem->seed_count > 0 ? &problem->seeds[k] : &as_default;
        double here = -1;
        const taut_status status = judge_seed(lines, cells, unit, fit, problem, seed, arena, &here);
        if (status != TAUT_OK) {
            return status;
        }
        if (!(here <= *residual)) {
            *residual = here;
            *where = k;
        }
    }
    return TAUT_OK;
}
