/* trace.c -- are these curves a net of the surface? From the curves of the model, the surface, and
 * the curves' stretches in the window; the forms of the surface by taut_surface_forms_points and the
 * curves' own derivatives, none of them by the formulas that traced them.
 *
 *   surface       with the problem: numbers of the surface that differ from the model's that it was
 *                 traced on (exact), or claims that do not hold of what was made first
 *   on-surface    largest distance of C(s) from S(c(s)) over the size, PLACES in each span (check); a bound where
 *                 curves are straight in the window (certify/trace/straight.h), and where the surface is a polynomial, or a
 *                 quotient, of a degree that is small enough (certify/trace/compose.h)
 *   asymptotic    |k_n| / R of the curve's own tangent; its family by the sign of tau_g. This and principal are
 *                 exact, of the surface's curve over the window's line, where curves are straight there
 *   principal     |tau_g| / R; its family by k_n >= H or not
 *   geodesic      int |k_g| ds by the curve's own second derivative
 *   isoparametric sine of the angle to the parameter line
 *   length        |int |C'| ds - range| / range, Gauss 16 a span, and that of details
 *   ends          distance of the ends from where a curve of this net may end as it is told to, over the size
 *                 (certify/trace/ends.h)
 *   seams         where curves go on to another surface: how far its place and normal are from those of the
 *                 first one (certify/trace/seams.h)
 *   nodes         largest distance of the two curves of a node of details at their lengths, and of its point and
 *                 place from them; difference of its normal
 *   right-angled  |H| / R at the nodes of details, where the surface is minimal
 *   spacing       with the problem: how unequal the parts are that curves cut edges and lines in, and how far
 *                 curves are from the places that they are seeded at (certify/trace/spacing.h)
 *   complete      nodes missing or too many, by how the ends separate each other on the border
 *                 (certify/trace/complete.h); left out where that does not say
 *   isometric     with the problem: relative difference of the edges that strips which only bend are told to
 *                 have from those in space (certify/trace/isometric.h)
 *   pattern       pieces to cut that lie over each other or over the border of their sheet
 *                 (certify/trace/pieces.h)
 */
#include "taut/trace.h"

#include "certify/certify_ops.h"
#include "certify/common/of.h"
#include "certify/common/unit.h"
#include "certify/common/verdict.h"
#include "certify/trace/cells.h"
#include "certify/trace/complete.h"
#include "certify/trace/compose.h"
#include "certify/trace/crossings.h"
#include "certify/trace/ends.h"
#include "certify/trace/everywhere.h"
#include "certify/trace/figures.h"
#include "certify/trace/isometric.h"
#include "certify/trace/laths.h"
#include "certify/trace/lines.h"
#include "certify/trace/met.h"
#include "certify/trace/panels.h"
#include "certify/trace/pieces.h"
#include "certify/trace/seams.h"
#include "certify/trace/spacing.h"
#include "certify/trace/straight.h"
#include "certify/trace/told.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"
#include "problem/problem.h"
#include "taut/measure.h"

#include <stdio.h>
#include <string.h>

enum { PLACES = 8, NODES = 16, QUINTIC = TAUT_NET_QUINTIC };
static const double tolerance_default = 1e-6, net_limit = 1e-6, length_limit = 1e-9,
                    ends_limit = 1e-9, spacing_limit = 1e-9, isometric_limit = 1e-9,
                    figures_limit = 1e-6;
/* So near to an end without a border, over the size, the net may be anything. */
static const double near_end = 1e-3;
/* Ends and middles of curves that are one, over their length. */
static const double one_curve = 1e-9;
/* |H| / R of a surface that is seen to be minimal. */
static const double minimal = 1e-9;

/* All that the claims are judged from. The surface is at size 1: lengths times 2^-unit. */
typedef struct request {
    const taut_trace_problem *problem; /* or NULL */
    taut_net_lines lines;
    const taut_surface **surfaces; /* [lines.surface_count], scaled; the arena's */
    const taut_surface *surface;   /* the first one */
    taut_net_seams seams;          /* where they join */
    taut_net_cells *cells;         /* their polynomials, of one thread */
    taut_net_composer *composer;   /* as well */
    const taut_net_rule *rule;
    int unit;
    double size;                /* of it */
    double roundest;            /* the largest R of a grid */
    int is_minimal;             /* H vanishes on that grid, to rounding */
    taut_net_straight straight; /* minimal by its coefficients: curves are straight in the window */
    int is_everywhere;          /* the net, by proof */
    double tolerance;
    const taut_crew *crew;
} request;

/* A place of a curve. */
typedef struct place {
    double x[3], tangent[3], second[3]; /* of the curve, over its length */
    double speed;                       /* |C'| */
    int on;                             /* which surface */
    double at[2];
    double s[3][3]; /* S, S_u, S_v */
    taut_forms forms;
    double ab[2]; /* the tangent in S_u, S_v */
} place;

/* What a claim has found so far. */
typedef struct worst {
    double residual;
    const char *name; /* of whose it is, and where; or NULL */
    double t;
    char where[96]; /* instead */
} worst;

static void take(worst *w, double residual, const char *name, double t)
{
    const double larger = taut_certify_max(w->residual, residual);
    if (w->name == NULL || !(larger == w->residual)) {
        w->name = name;
        w->t = t;
    }
    w->residual = larger;
}

/* The place of c[0] with derivatives c[1], c[2], all times 2^-unit, over p->at on p->on; 0 where that leaves the
 * window. */
static int fill_place(const request *r, const double c[3][3], place *p)
{
    const taut_surface *surface = r->surfaces[p->on];
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(basis[d]), hi = taut_basis_hi(basis[d]);
        const double room = 1e-9 * (hi - lo);
        if (!(p->at[d] >= lo - room) || !(p->at[d] <= hi + room)) {
            return 0;
        }
        p->at[d] = fmin(fmax(p->at[d], lo), hi);
    }
    if (!taut_net_cells_look(r->cells, p->on, p->at, p->s, &p->forms)) {
        return 0;
    }
    p->speed = taut_length(c[1]);
    const double along = taut_dot(c[2], c[1]) / (p->speed * p->speed);
    for (int k = 0; k < 3; k++) {
        p->x[k] = c[0][k];
        p->tangent[k] = c[1][k] / p->speed;
        p->second[k] = (c[2][k] - along * c[1][k]) / (p->speed * p->speed);
    }
    const double a = taut_dot(p->tangent, p->s[1]), b = taut_dot(p->tangent, p->s[2]);
    const double area = p->forms.w * p->forms.w;
    p->ab[0] = (p->forms.g * a - p->forms.f * b) / area;
    p->ab[1] = (p->forms.e * b - p->forms.f * a) / area;
    return 1;
}

/* 0 where the curve's stretches in the window do not reach t, or leave the window. */
static int place_at(const request *r, const taut_net_line *line, double t, place *p)
{
    const double scale = ldexp(1, -r->unit);
    double c[3][3];

    taut_curve_eval(line->space, t, 2, c[0]);
    for (int k = 0; k < 3; k++) {
        c[0][k] *= scale; /* the parameter is a length too */
        c[2][k] /= scale;
    }
    return taut_net_line_window(line, t, p->at, &p->on) && fill_place(r, (const double(*)[3])c, p);
}

static double radius_of(const taut_forms *f)
{
    return sqrt(fmax(f->mean * f->mean - f->gaussian, 0));
}

/* What the net says of a direction; 0 is as it should be. */
static double net_residual(const request *r, const taut_net_line *line, const place *p)
{
    const taut_forms *f = &p->forms;
    const double a = p->ab[0], b = p->ab[1], radius = radius_of(f);
    const double normal = f->l * a * a + 2 * f->m * a * b + f->n * b * b;
    const double twist = ((f->m * a + f->n * b) * (f->e * a + f->f * b) -
                          (f->l * a + f->m * b) * (f->f * a + f->g * b)) /
                         f->w;
    double sideways[3];

    switch (r->lines.net) {
    case TAUT_TRACE_ASYMPTOTIC:
        return (line->family == 0 ? twist < 0 : twist > 0) ? 1 : fabs(normal) / radius;
    case TAUT_TRACE_PRINCIPAL:
        return (line->family == 0 ? normal < f->mean : normal > f->mean) ? 1 : fabs(twist) / radius;
    case TAUT_TRACE_GEODESIC:
        taut_cross(f->normal, p->tangent, sideways);
        return fabs(taut_dot(p->second, sideways));
    default:
        return line->family == 0 ? fabs(a) * f->w / sqrt(f->g) : fabs(b) * f->w / sqrt(f->e);
    }
}

/* Does the curve end where there is no normal, as details say? The claim `ends` sees whether it does. */
static int ends_singular(const request *r, const taut_net_line *line, double t)
{
    const taut_record *ended =
        taut_record_get(taut_net_lath_of(&r->lines, line), "ended"); /* [2] */
    const size_t end = t == taut_basis_lo(taut_curve_t(line->space)) ? 0 : 1;
    return strcmp(taut_record_text(taut_record_at(ended, end)), "singular") == 0;
}

/* Is this end one where the net itself ends, or the surface's normal? Then it may be anything near to it. */
static int is_soft(const request *r, const taut_net_line *line, double t)
{
    place p;
    if (ends_singular(r, line, t)) {
        return 1;
    }
    if (r->lines.net == TAUT_TRACE_GEODESIC || r->lines.net == TAUT_TRACE_ISOPARAMETRIC ||
        !place_at(r, line, t, &p)) {
        return 0;
    }
    const double radius = radius_of(&p.forms);
    return radius < 1e-4 * r->roundest || (r->lines.net == TAUT_TRACE_ASYMPTOTIC &&
                                           fabs(p.forms.gaussian) < 1e-4 * radius * radius);
}

/* The same less what rounding of the surface may make of it, where R is little. */
static double residual_of(const request *r, const taut_net_line *line, const place *p)
{
    const double residual = net_residual(r, line, p);
    const int has_radius =
        r->lines.net == TAUT_TRACE_ASYMPTOTIC || r->lines.net == TAUT_TRACE_PRINCIPAL;
    const int is_blurred = has_radius && residual > net_limit && residual < 1;
    return is_blurred
               ? fmax(residual - taut_net_blur(r->surfaces[p->on], r->size, p->at, &p->forms), 0)
               : residual;
}

/* ---- on-surface and the net's own claim ---- */

typedef struct found {
    worst distance, net, length;
    taut_net_off figures;
    int is_proved, is_bounded; /* the net's claim exactly, the distance by a bound */
} found;

/* Bernstein's polynomials of degrees 5, 4 and 3 at the PLACES of a span, and of degree 4 at Gauss's nodes. */
typedef struct tables {
    double five[PLACES][QUINTIC + 1], four[PLACES][QUINTIC], three[PLACES][QUINTIC - 1];
    double nodes[NODES], weights[NODES], speed[NODES][QUINTIC];
} tables;

static void bernstein(int degree, double t, double *b)
{
    b[0] = 1;
    for (int n = 1; n <= degree; n++) {
        b[n] = t * b[n - 1];
        for (int i = n - 1; i > 0; i--) {
            b[i] = (1 - t) * b[i] + t * b[i - 1];
        }
        b[0] = (1 - t) * b[0];
    }
}

static void fill_tables(tables *t)
{
    taut_gauss_rule(NODES, t->nodes, t->weights);
    for (int k = 0; k < NODES; k++) {
        bernstein(QUINTIC - 1, (1 + t->nodes[k]) / 2, t->speed[k]);
    }
    for (int k = 0; k < PLACES; k++) {
        bernstein(QUINTIC, (k + 0.5) / PLACES, t->five[k]);
        bernstein(QUINTIC - 1, (k + 0.5) / PLACES, t->four[k]);
        bernstein(QUINTIC - 2, (k + 0.5) / PLACES, t->three[k]);
    }
}

/* Place k of a span. */
static int place_of(const request *r, const tables *t, const taut_net_span *span, int k, place *p)
{
    const double h = ldexp(span->to - span->from, -r->unit);
    double c[3][3] = {{0}};

    p->on = span->on;
    p->at[0] = p->at[1] = 0;
    for (int i = 0; i <= QUINTIC; i++) {
        p->at[0] += t->five[k][i] * span->window[i][0];
        p->at[1] += t->five[k][i] * span->window[i][1];
        for (int d = 0; d < 3; d++) {
            const double *x = &span->space[i][d]; /* [j][3] */
            c[0][d] += t->five[k][i] * x[0];
            c[1][d] += i < QUINTIC ? t->four[k][i] * (x[3] - x[0]) : 0;
            c[2][d] += i < QUINTIC - 1 ? t->three[k][i] * ((x[6] - x[3]) - (x[3] - x[0])) : 0;
        }
    }
    for (int d = 0; d < 3; d++) {
        c[1][d] *= QUINTIC / h;
        c[2][d] *= QUINTIC * (QUINTIC - 1) / (h * h);
    }
    return fill_place(r, (const double(*)[3])c, p);
}

/* One span of a curve, from a to b; span: its coefficients, or NULL. */
static void look_at_span(const request *r, const taut_net_line *line, const tables *rules,
                         const taut_net_span *span, double a, double b, const double clear[2],
                         found *f)
{
    const char *name = taut_curve_name(line->space);
    double away[3];
    place p;

    for (int k = 0; k < PLACES; k++) {
        const double t = a + (b - a) * (k + 0.5) / PLACES;
        if (span != NULL ? !place_of(r, rules, span, k, &p) : !place_at(r, line, t, &p)) {
            take(&f->distance, INFINITY, name, t);
            continue;
        }
        taut_difference(p.x, p.s[0], away);
        take(&f->distance, taut_norm(away) / r->size, name, t);
        if (r->lines.net != TAUT_TRACE_GEODESIC && t > clear[0] && t < clear[1]) {
            take(&f->net, residual_of(r, line, &p), name, t);
        }
    }
}

/* The length of a span. */
static double length_of(const request *r, const taut_net_line *line, const tables *rules,
                        const taut_net_span *span, double a, double b)
{
    double sum = 0, scale = (b - a) / 2;
    for (int k = 0; k < NODES; k++) {
        double c[2][3] = {{0}};
        if (span == NULL) {
            taut_curve_eval(line->space, a + (b - a) * (1 + rules->nodes[k]) / 2, 1, c[0]);
        }
        for (int i = 0; span != NULL && i < QUINTIC; i++) {
            for (int d = 0; d < 3; d++) {
                c[1][d] += rules->speed[k][i] * (span->space[i + 1][d] - span->space[i][d]);
            }
        }
        sum += rules->weights[k] * taut_length(c[1]);
    }
    if (span != NULL) {
        scale = ldexp(QUINTIC, r->unit) / 2;
    }
    return sum * scale;
}

/* int |k_g| ds of a geodesic over a span. */
static double turn_of(const request *r, const taut_net_line *line, const tables *rules, double a,
                      double b)
{
    double turn = 0;
    for (int k = 0; k < NODES; k++) {
        place p;
        const double t = a + (b - a) * (1 + rules->nodes[k]) / 2;
        turn += place_at(r, line, t, &p)
                    ? rules->weights[k] * ldexp((b - a) / 2, -r->unit) * residual_of(r, line, &p)
                    : INFINITY;
    }
    return turn;
}

/* How far the curve is from the surface at most, of all places: `most` of its spans. */
static void bound_distance(const request *r, const taut_net_line *line, double most, found *f)
{
    const double distance = most / r->size;
    f->is_bounded &= distance <= r->tolerance;
    if (distance <= r->tolerance) {
        take(&f->distance, distance, taut_curve_name(line->space), 0);
    }
}

/* What is proved of a curve that is a straight line of the window; f->is_proved and ->is_bounded say whether
 * it could be, of all so far. */
static void prove_straight(const request *r, const taut_net_line *line, found *f)
{
    double way[2];

    taut_net_straight_way(&r->straight, r->lines.net, line->family, way);
    const double angle = taut_net_straight_residual(line, way);
    const double distance =
        taut_net_straight_distance(r->surface, &r->straight, line, r->unit, way) / r->size;
    f->is_proved &= angle <= net_limit;
    f->is_bounded &= distance <= r->tolerance;
    if (angle <= net_limit) {
        take(&f->net, angle, taut_curve_name(line->space), 0);
    }
    if (distance <= r->tolerance) {
        take(&f->distance, distance, taut_curve_name(line->space), 0);
    }
}

static taut_net_audit audit_of(const request *r)
{
    return (taut_net_audit){.lines = &r->lines,
                            .cells = r->cells,
                            .rule = r->rule,
                            .problem = r->problem,
                            .unit = r->unit,
                            .size = r->size,
                            .tolerance = r->tolerance,
                            .roundest = r->roundest,
                            .is_minimal = r->straight.is_known,
                            .is_saddle =
                                r->straight.is_known ||
                                (r->is_everywhere && r->lines.net == TAUT_TRACE_ASYMPTOTIC),
                            .seams = &r->seams};
}

static void look_at_line(const request *r, const taut_net_line *line, found *f)
{
    const taut_basis *basis = taut_curve_t(line->space);
    const double *breaks = taut_basis_breaks(basis);
    const int spans = taut_basis_span_count(basis), is_quintic = taut_net_line_is_quintic(line);
    const int is_geodesic = r->lines.net == TAUT_TRACE_GEODESIC;
    const int is_straight = r->straight.is_known && (r->lines.net == TAUT_TRACE_ASYMPTOTIC ||
                                                     r->lines.net == TAUT_TRACE_PRINCIPAL);
    const double room = near_end * r->lines.size;
    const double clear[2] = {is_soft(r, line, breaks[0]) ? breaks[0] + room : -INFINITY,
                             is_soft(r, line, breaks[spans]) ? breaks[spans] - room : INFINITY};
    double length = 0, turn = 0, most = 0;
    tables rules;

    fill_tables(&rules);
    for (int i = 0; i < spans; i++) {
        const double a = breaks[i], b = breaks[i + 1];
        taut_net_span span;
        const int is_known = is_quintic && taut_net_span_of(line, i, r->unit, &span);
        look_at_span(r, line, &rules, is_known ? &span : NULL, a, b, clear, f);
        length += length_of(r, line, &rules, is_known ? &span : NULL, a, b);
        turn += is_geodesic ? turn_of(r, line, &rules, a, b) : 0;
        if (!is_straight && most < INFINITY) {
            most = is_known ? fmax(most, taut_net_compose_distance(r->composer, &span)) : INFINITY;
        }
    }
    take(&f->length, fabs(length - line->length) / line->length, taut_curve_name(line->space),
         breaks[0]);
    take(&f->length, taut_net_lath_off(&r->lines, line), taut_curve_name(line->space), breaks[0]);
    if (is_geodesic) {
        take(&f->net, turn, taut_curve_name(line->space), breaks[0]);
    }
    const taut_net_audit audit = audit_of(r);
    taut_net_figures_of(&audit, line, clear, &f->figures);
    if (is_straight) {
        prove_straight(r, line, f);
    } else {
        f->is_proved = 0;
        bound_distance(r, line, most, f);
    }
}

static taut_status add(taut_certificate *certificate, const char *name, taut_claim_kind kind,
                       const worst *w, double limit)
{
    char where[96];
    taut_claim claim = {
        .claim = name, .kind = kind, .residual = w->residual, .limit = limit, .where = w->where};
    if (w->name != NULL) {
        snprintf(where, sizeof where, "%.40s at %.6g", w->name, w->t);
        claim.where = where;
    }
    claim.holds = isinf(w->residual) ? TAUT_FALSE : taut_certify_below(w->residual, limit);
    return taut_certificate_add(certificate, &claim);
}

/* ---- ends ---- */

static taut_status add_ends(const request *r, taut_certificate *certificate)
{
    const taut_net_audit audit = audit_of(r);
    const double longest = taut_net_longest(&audit);
    worst w = {.residual = 0};
    for (int k = 0; k < r->lines.count; k++) {
        const taut_net_line *line = &r->lines.lines[k];
        const taut_basis *basis = taut_curve_t(line->space);
        for (int end = 0; end < 2; end++) {
            take(&w, taut_net_end_away(&audit, line, end, longest), taut_curve_name(line->space),
                 end == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis));
        }
    }
    return add(certificate, "ends", TAUT_CHECK, &w, ends_limit);
}

/* ---- nodes ---- */

/* The surface of this name, where there are several. */
static int surface_named(const request *r, const taut_record *name)
{
    for (int k = 1; k < r->lines.surface_count; k++) {
        if (strcmp(taut_surface_name(r->surfaces[k]), taut_record_text(name)) == 0) {
            return k;
        }
    }
    return 0;
}

/* How far what is written down of a node is from the curves' place, over the size: its point, its place in the window,
 * and its normal. */
static double node_off(const request *r, const taut_record *node, const double x[3])
{
    const taut_record *at = taut_record_get(node, "at");
    const double u = taut_record_number(taut_record_at(at, 0));
    const double v = taut_record_number(taut_record_at(at, 1));
    const int on = surface_named(r, taut_record_get(node, "surface"));
    double point[3], normal[3], there[3], away = 0;
    taut_forms forms;

    if (taut_surface_eval(r->surfaces[on], u, v, 0, there) != TAUT_OK ||
        taut_surface_forms_points(r->surfaces[on], 1, &u, &v, 1, &forms) != TAUT_OK) {
        return INFINITY;
    }
    for (size_t c = 0; c < 3; c++) {
        point[c] =
            ldexp(taut_record_number(taut_record_at(taut_record_get(node, "point"), c)), -r->unit);
        normal[c] = taut_record_number(taut_record_at(taut_record_get(node, "normal"), c));
    }
    away = taut_certify_max(taut_distance(point, x), taut_distance(there, x)) / r->size;
    return forms.regular ? taut_certify_max(away, taut_distance(normal, forms.normal)) : away;
}

static taut_status add_nodes(const request *r, taut_arena *arena, taut_certificate *certificate)
{
    const taut_record *nodes = taut_record_get(taut_model_details(r->lines.model), "nodes");
    worst w = {.residual = 0};

    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k), *s = taut_record_get(node, "s");
        const char *name = taut_record_text(taut_record_get(node, "node"));
        const taut_net_line *lines[2];
        double x[2][3], residual = INFINITY;
        if (taut_net_lines_of_node(&r->lines, name, lines)) {
            taut_status status = TAUT_OK;
            for (int side = 0; status == TAUT_OK && side < 2; side++) {
                const taut_basis *basis = taut_curve_t(lines[side]->space);
                const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
                const double t = taut_record_number(taut_record_at(s, (size_t)side));
                const double room = 1e-8 * r->lines.size;
                status =
                    t >= lo - room && t <= hi + room
                        ? taut_curve_eval(lines[side]->space, fmin(fmax(t, lo), hi), 0, x[side])
                        : TAUT_BAD_INPUT;
            }
            residual =
                status == TAUT_OK ? ldexp(taut_distance(x[0], x[1]), -r->unit) / r->size : INFINITY;
            for (int c = 0; c < 3; c++) {
                x[0][c] = ldexp(x[0][c], -r->unit);
            }
            residual = residual < INFINITY ? taut_certify_max(residual, node_off(r, node, x[0]))
                                           : residual;
        }
        take(&w, residual, name, taut_record_number(taut_record_at(s, 0)));
    }
    char where[96];
    double unmet = 0;
    const taut_status status = taut_net_met(&r->lines, arena, &unmet, where);
    if (unmet > 0) {
        take(&w, INFINITY, where, 0);
    }
    return status == TAUT_OK ? add(certificate, "nodes", TAUT_CHECK, &w, r->tolerance) : status;
}

/* ---- right angles ---- */

/* Is the surface minimal: by the problem it was made by, or seen on a grid? */
static int makes_right_angles(const request *r)
{
    return (r->problem != NULL && r->problem->of != NULL &&
            strcmp(taut_problem_construction(r->problem->of), "bonnet") == 0) ||
           r->is_minimal;
}

/* |H| / R at the nodes of an asymptotic net of a minimal surface: the cosine of the angle there. */
static taut_status add_right_angled(const request *r, taut_certificate *certificate)
{
    const taut_record *nodes = taut_record_get(taut_model_details(r->lines.model), "nodes");
    worst w = {.residual = 0};

    if (r->lines.net != TAUT_TRACE_ASYMPTOTIC || !makes_right_angles(r)) {
        return TAUT_OK;
    }
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const taut_record *node = taut_record_at(nodes, k), *at = taut_record_get(node, "at");
        const double u = taut_record_number(taut_record_at(at, 0));
        const double v = taut_record_number(taut_record_at(at, 1));
        const int on = surface_named(r, taut_record_get(node, "surface"));
        taut_forms forms;
        const int is_told =
            taut_surface_forms_points(r->surfaces[on], 1, &u, &v, 1, &forms) == TAUT_OK &&
            forms.regular;
        take(&w, is_told ? fabs(forms.mean) / radius_of(&forms) : INFINITY,
             taut_record_text(taut_record_get(node, "node")),
             taut_record_number(taut_record_at(taut_record_get(node, "s"), 0)));
    }
    return add(certificate, "right-angled", TAUT_CHECK, &w, net_limit);
}

/* ---- spacing ---- */

static taut_status add_spacing(const request *r, const worst *distance, taut_arena *arena,
                               taut_certificate *certificate)
{
    worst w = {.residual = 0};
    int seed = 0;
    const double fit = fmin(distance->residual, r->tolerance);
    const taut_status status =
        taut_net_spacing(&r->lines, r->cells, r->unit, fit, r->problem, arena, &w.residual, &seed);
    if (status != TAUT_OK || w.residual < 0) {
        return status;
    }
    snprintf(w.where, sizeof w.where, "/seeds/%d", seed);
    return add(certificate, "spacing", TAUT_CHECK, &w, spacing_limit);
}

/* ---- strips that only bend ---- */

static taut_status add_isometric(const request *r, taut_certificate *certificate)
{
    const char *name = NULL;
    worst w = {.residual = 0};
    w.residual = taut_net_isometric(&r->lines, r->cells, r->unit, r->problem, &name);
    if (w.residual < 0) {
        return TAUT_OK;
    }
    snprintf(w.where, sizeof w.where, "%.60s", name != NULL ? name : "");
    return add(certificate, "isometric", TAUT_CHECK, &w, isometric_limit);
}

/* ---- the whole ---- */

static taut_status add_surface(const request *r, taut_arena *arena, const taut_audit *audit,
                               taut_certificate *certificate, taut_error *error)
{
    const taut_trace_problem *p = r->problem;
    const taut_certify_given given = {p != NULL ? p->model : NULL, p != NULL ? p->of : NULL,
                                      p != NULL ? p->surface : NULL, r->lines.surface_count > 1, 0};
    return p != NULL ? taut_certify_of(r->lines.model, r->lines.surface, &given, arena, audit,
                                       certificate, error)
                     : TAUT_OK;
}

static void look_at_surface(request *r, const taut_surface *surface)
{
    enum { GRID = 17 };
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double u =
                taut_basis_lo(bu) + (taut_basis_hi(bu) - taut_basis_lo(bu)) * (i + 0.5) / GRID;
            const double v =
                taut_basis_lo(bv) + (taut_basis_hi(bv) - taut_basis_lo(bv)) * (j + 0.5) / GRID;
            taut_forms forms;
            if (taut_surface_forms_points(surface, 1, &u, &v, 1, &forms) == TAUT_OK &&
                forms.regular) {
                r->roundest = fmax(r->roundest, radius_of(&forms));
                r->is_minimal &= fabs(forms.mean) <= minimal * radius_of(&forms);
            }
        }
    }
}

static taut_status add_figures(const request *r, taut_certificate *certificate)
{
    taut_record *figures = taut_record_new();
    const taut_record *nodes = taut_record_get(taut_model_details(r->lines.model), "nodes");
    double length = 0;

    for (int k = 0; k < r->lines.count; k++) {
        length += r->lines.lines[k].length;
    }
    taut_record_add_number(figures, "laths", r->lines.count);
    taut_record_add_number(figures, "node_count", (double)taut_record_count(nodes));
    taut_record_add_number(figures, "total_length", length);
    const taut_status status = taut_record_status(figures);
    taut_certificate_set_figures(certificate, figures);
    return status;
}

/* A net exists everywhere by proof: K < 0 on minimal surfaces of the family, or by Bernstein coefficients. */
static taut_status look_everywhere(request *r)
{
    const taut_trace_net net = r->lines.net;
    r->is_everywhere = r->straight.is_known;
    if (!r->is_everywhere && r->lines.surface_count == 1 &&
        (net == TAUT_TRACE_ASYMPTOTIC || net == TAUT_TRACE_PRINCIPAL)) {
        return taut_net_everywhere(r->cells, net, &r->is_everywhere);
    }
    return TAUT_OK;
}

/* ---- all curves, each by one thread ---- */

typedef struct lookers {
    const request *r;
    request *own; /* a worker's: cells and composer of its own */
    found *found; /* a curve's */
} lookers;

static void look_at(void *context, int worker, int64_t task)
{
    const lookers *all = context;
    look_at_line(&all->own[worker], &all->r->lines.lines[task], &all->found[task]);
}

static void free_arena(void *arena)
{
    taut_arena_free(arena);
}

static void merge(worst *all, const worst *one)
{
    const double larger = taut_certify_max(all->residual, one->residual);
    if (one->name != NULL && (all->name == NULL || !(larger == all->residual))) {
        all->name = one->name;
        all->t = one->t;
    }
    all->residual = larger;
}

static taut_status look_at_lines(const request *r, taut_arena *arena, found *f)
{
    const int workers = taut_crew_workers(r->crew, r->lines.count);
    lookers all = {.r = r,
                   .own = taut_arena_take(arena, (size_t)workers, sizeof *all.own),
                   .found = taut_arena_take(arena, (size_t)r->lines.count, sizeof *all.found)};
    taut_status status = taut_arena_status(arena);

    for (int k = 0; status == TAUT_OK && k < workers; k++) {
        taut_arena *scratch = k == 0 ? arena : taut_arena_new();
        all.own[k] = *r;
        if (k > 0 && (scratch == NULL || !taut_arena_keep(arena, scratch, free_arena) ||
                      taut_net_cells_new(scratch, r->lines.surface_count, r->surfaces,
                                         &all.own[k].cells) != TAUT_OK)) {
            return TAUT_NO_MEMORY;
        }
        status = taut_net_composer_new(scratch, all.own[k].cells, &all.own[k].composer);
    }
    for (int k = 0; status == TAUT_OK && k < r->lines.count; k++) {
        all.found[k] = (found){.is_proved = 1, .is_bounded = 1};
    }
    if (status == TAUT_OK &&
        taut_crew_run(r->crew, workers, r->lines.count, TAUT_PULSE_WORK, look_at, &all)) {
        return TAUT_INTERRUPTED;
    }
    for (int k = 0; status == TAUT_OK && k < workers; k++) {
        status = taut_arena_status(all.own[k].cells->arena);
    }
    *f = (found){.is_proved = 1, .is_bounded = 1};
    for (int k = 0; status == TAUT_OK && k < r->lines.count; k++) {
        merge(&f->distance, &all.found[k].distance);
        merge(&f->net, &all.found[k].net);
        merge(&f->length, &all.found[k].length);
        if (all.found[k].figures.where[0] != '\0' &&
            !(all.found[k].figures.residual <= f->figures.residual)) {
            f->figures = all.found[k].figures;
        }
        f->is_proved &= all.found[k].is_proved;
        f->is_bounded &= all.found[k].is_bounded;
    }
    return status;
}

/* Between two parts of the proof, either of which may take long. */
static taut_status watch(const request *r)
{
    return taut_crew_beat(r->crew, TAUT_PULSE_WORK) ? TAUT_INTERRUPTED : TAUT_OK;
}

static taut_status prove(request *r, taut_arena *arena, taut_certificate *certificate)
{
    static const char *const names[] = {"asymptotic", "principal", "geodesic", "isoparametric"};
    found f;
    taut_status status = look_at_lines(r, arena, &f);

    if (status == TAUT_OK) {
        status = look_everywhere(r);
    }
    if (status == TAUT_OK) {
        status = watch(r);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const taut_net_audit audit = audit_of(r);
    taut_net_crossings_look(&audit, &f.figures);
    status = watch(r);
    if (status == TAUT_OK) {
        status = taut_net_panels_look(&audit, arena, &f.figures);
    }
    if (status == TAUT_OK) {
        status = watch(r);
    }
    if (status == TAUT_OK) {
        status = taut_net_told_look(&audit, arena, &f.figures);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = add(certificate, "on-surface", f.is_bounded ? TAUT_BOUND : TAUT_CHECK, &f.distance,
                 r->tolerance);
    if (status == TAUT_OK) {
        status = add(certificate, names[r->lines.net], f.is_proved ? TAUT_EXACT : TAUT_CHECK,
                     &f.net, net_limit);
    }
    if (status == TAUT_OK) {
        status = add(certificate, "length", TAUT_CHECK, &f.length, length_limit);
    }
    if (status == TAUT_OK) {
        worst w = {.residual = f.figures.residual};
        snprintf(w.where, sizeof w.where, "%.90s", f.figures.where);
        status = add(certificate, "figures", TAUT_CHECK, &w, figures_limit);
    }
    if (status == TAUT_OK) {
        status = add_ends(r, certificate);
    }
    if (status == TAUT_OK && r->lines.surface_count > 1) {
        status = taut_net_seams_add(&r->seams, &r->lines, certificate);
    }
    if (status == TAUT_OK) {
        status = add_nodes(r, arena, certificate);
        status = status == TAUT_OK ? watch(r) : status;
    }
    if (status == TAUT_OK) {
        status = add_right_angled(r, certificate);
        status = status == TAUT_OK ? watch(r) : status;
    }
    if (status == TAUT_OK) {
        status = add_spacing(r, &f.distance, arena, certificate);
        status = status == TAUT_OK ? watch(r) : status;
    }
    if (status == TAUT_OK) {
        status = taut_net_complete_add(&r->lines, r->is_everywhere, arena, certificate);
        status = status == TAUT_OK ? watch(r) : status;
    }
    if (status == TAUT_OK) {
        status = add_isometric(r, certificate);
    }
    if (status == TAUT_OK) {
        status = taut_net_pieces_add(&r->lines, r->problem, r->tolerance, arena, certificate);
        status = status == TAUT_OK ? watch(r) : status;
    }
    return status == TAUT_OK ? add_figures(r, certificate) : status;
}

/* All by one power of two. */
static taut_status scale_surfaces(request *r, taut_arena *arena)
{
    const int count = r->lines.surface_count;
    r->surfaces = taut_arena_take(arena, (size_t)count, sizeof *r->surfaces);
    if (r->surfaces == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < count; k++) {
        const int unit = taut_certify_unit_of(taut_model_surface(r->lines.model, k));
        r->unit = k == 0 || unit > r->unit ? unit : r->unit;
    }
    for (int k = 0; k < count; k++) {
        taut_surface *scaled = NULL;
        if (taut_certify_scaled(taut_model_surface(r->lines.model, k), r->unit, &scaled) !=
                TAUT_OK ||
            !taut_keep_surface(arena, scaled)) {
            return TAUT_NO_MEMORY;
        }
        r->surfaces[k] = scaled;
    }
    r->surface = r->surfaces[0];
    return TAUT_OK;
}

static taut_status certify_in(taut_arena *arena, const taut_model *model,
                              const taut_trace_problem *problem, const taut_audit *audit,
                              taut_certificate *certificate, taut_error *error)
{
    request r = {.problem = problem,
                 .tolerance = audit->tolerance > 0 ? audit->tolerance : tolerance_default,
                 .crew = &audit->crew};
    taut_net_rule rule;
    taut_status status = taut_net_lines_new(arena, model, problem, &r.lines, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (scale_surfaces(&r, arena) != TAUT_OK ||
        taut_net_seams_new(arena, r.lines.surface_count, r.surfaces, &r.seams) != TAUT_OK ||
        taut_net_cells_new(arena, r.lines.surface_count, r.surfaces, &r.cells) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    r.size = ldexp(r.lines.size, -r.unit);
    r.is_minimal = 1;
    taut_net_rule_fill(&rule);
    r.rule = &rule;
    for (int k = 0; k < r.lines.surface_count; k++) {
        look_at_surface(&r, r.surfaces[k]);
    }
    if (r.lines.surface_count == 1) {
        taut_net_straight_look(r.surface, &r.straight);
    }
    status = add_surface(&r, arena, audit, certificate, error);
    if (status != TAUT_OK) {
        return status;
    }
    return prove(&r, arena, certificate) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = arena != NULL
                                   ? certify_in(arena, model, data, audit, certificate, error)
                                   : taut_fail_memory(error);
    taut_arena_free(arena);
    return status;
}

/* ---- which curves ---- */

static const taut_curve *curve_of(const taut_model *model, const char *name, int *index)
{
    *index = -1;
    for (int k = 0; k < taut_model_curve_count(model); k++) {
        if (strcmp(taut_curve_name(taut_model_curve(model, k)), name) == 0) {
            *index = k;
            return taut_model_curve(model, k);
        }
    }
    return NULL;
}

/* Ends and middle of a curve in space, either way around. */
static int are_one_curve(const taut_curve *a, const taut_curve *b)
{
    double x[2][3][3], length[2];
    for (int k = 0; k < 2; k++) {
        const taut_basis *basis = taut_curve_t(k == 0 ? a : b);
        const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
        length[k] = hi - lo;
        for (int i = 0; i < 3; i++) {
            taut_curve_eval(k == 0 ? a : b, lo + (hi - lo) * i / 2, 0, x[k][i]);
        }
    }
    const double room = one_curve * length[0];
    const int same =
        taut_distance(x[0][0], x[1][0]) <= room && taut_distance(x[0][2], x[1][2]) <= room;
    const int turned =
        taut_distance(x[0][0], x[1][2]) <= room && taut_distance(x[0][2], x[1][0]) <= room;
    return (same || turned) && taut_distance(x[0][1], x[1][1]) <= room &&
           fabs(length[0] - length[1]) <= room;
}

/* How many curves of a family the seeds of the document may make. */
static int most_of(const taut_trace_problem *problem, int family)
{
    int most = 0;
    for (int k = 0; k < problem->seed_count; k++) {
        const taut_trace_seed *seed = &problem->seeds[k];
        int families = seed->family != 0 ? seed->family : 3;
        families &= problem->families != 0 ? problem->families : 3;
        const int is_parted = seed->kind == TAUT_TRACE_EDGE || seed->kind == TAUT_TRACE_LINE ||
                              seed->kind == TAUT_TRACE_LATH;
        if (problem->net != TAUT_TRACE_GEODESIC && !(families & (1 << family))) {
            continue;
        }
        if (!is_parted && seed->kind != TAUT_TRACE_AT) {
            return TAUT_TRACE_LATHS_MAX;
        }
        most += is_parted ? seed->count + 2 * (seed->ends != 0) : 1;
    }
    return problem->seed_count > 0                                       ? most
           : problem->families == 0 || problem->families & (1 << family) ? TAUT_TRACE_LATHS_MAX
                                                                         : 0;
}

/* With the document: a curve that its seeds can make, and that is not there already. */
static int is_asked(const taut_model *model, const taut_trace_problem *problem, const char *name,
                    int counts[2])
{
    const int family = name[0] == 'B';
    int index = -1;
    const taut_curve *curve = problem != NULL ? curve_of(model, name, &index) : NULL;
    for (int k = 0; curve != NULL && k < index; k++) {
        const taut_curve *before = taut_model_curve(model, k);
        if ((taut_curve_name(before)[0] == 'B') == family && are_one_curve(before, curve)) {
            return 0;
        }
    }
    counts[family]++;
    return problem == NULL || counts[family] <= most_of(problem, family);
}

/* The first surface, or all where curves go on from one to the next, and the curves A1, A2, ..., B1, ... in any order: those of details.domain. */
static void identify(const taut_model *model, const void *data, taut_identity *identity)
{
    const taut_trace_problem *problem = data;
    const taut_record *domain = taut_record_get(taut_model_details(model), "domain");
    const taut_surface *given = problem != NULL && problem->model != NULL
                                    ? taut_certify_named(problem->model, problem->surface)
                                    : NULL;
    const char *name = given != NULL ? taut_surface_name(given) : NULL;
    const char *before = "";
    int counts[2] = {0, 0};

    const int is_carried = problem != NULL
                               ? problem->carry
                               : taut_record_get(taut_record_at(domain, 0), "surface") != NULL;
    const int several = is_carried ? taut_model_surface_count(model) : 1;

    for (int k = 0; k < (several > 1 ? several : 1); k++) {
        taut_identity_surface(identity, k, several > 1 ? NULL : name, NULL, NULL);
    }
    for (size_t k = 0; k < taut_record_count(domain); k++) {
        const char *curve = taut_record_text(taut_record_get(taut_record_at(domain, k), "name"));
        if (strcmp(curve, before) != 0 && is_asked(model, problem, curve, counts)) {
            taut_identity_curve(identity, taut_identity_find_curve(identity, curve), curve, NULL);
        }
        before = curve;
    }
}

const taut_certify_ops taut_certify_trace = {.certify = certify, .identify = identify};

taut_status taut_trace_certify(const taut_model *model, const taut_trace_problem *problem,
                               const taut_certify_options *options, taut_certificate **certificate,
                               taut_error *error)
{
    return taut_certify_with(&taut_certify_trace, "trace", model, problem, options, certificate,
                             error);
}
