#include "certify/trace/ends.h"

#include "certify/common/verdict.h"
#include "certify/trace/figures.h"
#include "certify/trace/laths.h"
#include "certify/trace/side.h"
#include "core/vec3.h"
#include "problem/problem.h"

#include <stdio.h>
#include <string.h>

enum { EDGES = 4, SEAM_PLACES = 16 };
static const double crease_limit = 1e-9;
/* A curve ends where R is below 1e-8 of its largest value, which a grid sees to a factor of two: nearer to R = 0
 * rounding turns directions. */
static const double roundness = 2e-8;
/* H over the largest R: less is no umbilic, more no flat point. */
static const double least_mean = 1e-7, flat_mean = 1e-5;
/* -K / R^2 that is 0 but for rounding. */
static const double no_saddle = 1e-12;
/* The sine between the curve and the line K = 0: less is no cusp, more touches no envelope. Over the window's side, how far K is
 * looked at for it. */
static const double least_sine = 1e-5, most_sine = 1e-2, aside = 1e-4;
/* Over the size, and between normals: two borders of a surface are one line. As when it was traced; borderline ones are none. */
static const double same_line = 0.5e-12, same_normal = 0.5e-9;
/* Lengths told and found, over the longest. */
static const double same_length = 1e-9;

/* An end of a curve. */
typedef struct place {
    const taut_surface *surface;
    int on;
    double at[2], x[3], tangent[3]; /* of the curve in space */
    double s[3][3];                 /* S, S_u, S_v */
    taut_forms forms;
} place;

static const taut_basis *side_of(const taut_surface *surface, int d)
{
    return d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
}

static int place_of(const taut_net_audit *audit, const taut_net_line *line, int end, place *p)
{
    const taut_basis *range = taut_curve_t(line->space);
    const double t = end == 0 ? taut_basis_lo(range) : taut_basis_hi(range);
    double c[2][3];

    if (!taut_net_line_window(line, t, p->at, &p->on) ||
        taut_curve_eval(line->space, t, 1, c[0]) != TAUT_OK) {
        return 0;
    }
    p->surface = audit->cells->surfaces[p->on];
    for (int d = 0; d < 2; d++) {
        const double lo = taut_basis_lo(side_of(p->surface, d));
        const double hi = taut_basis_hi(side_of(p->surface, d)), room = 1e-9 * (hi - lo);
        if (!(p->at[d] >= lo - room) || !(p->at[d] <= hi + room)) {
            return 0;
        }
        p->at[d] = fmin(fmax(p->at[d], lo), hi);
    }
    for (int k = 0; k < 3; k++) {
        p->x[k] = ldexp(c[0][k], -audit->unit);
        p->tangent[k] = c[1][k] / taut_length(c[1]);
    }
    return taut_net_cells_look(audit->cells, p->on, p->at, p->s, &p->forms);
}

/* ---- where something vanishes ---- */

typedef double value_of(const taut_forms *forms);

static double gaussian_of(const taut_forms *forms)
{
    return forms->gaussian;
}

static double radius_of(const taut_forms *forms)
{
    return sqrt(fmax(forms->mean * forms->mean - forms->gaussian, 0));
}

static double normal_of(const taut_forms *forms)
{
    return forms->w;
}

/* A value at a place of the window so far from p; NaN outside, and where there is none. */
static double value_beside(const place *p, value_of *value, double u, double v)
{
    taut_forms forms;
    return taut_surface_forms_points(p->surface, 1, &u, &v, 1, &forms) == TAUT_OK ? value(&forms)
                                                                                  : (double)NAN;
}

/* How far p is from where the value vanishes: itself over its slope. */
static double distance_to_zero(const place *p, value_of *value)
{
    const double here = value(&p->forms);
    double slope = 0;

    for (int d = 0; d < 2; d++) {
        for (int side = -1; side <= 1; side += 2) {
            const double lo = taut_basis_lo(side_of(p->surface, d));
            const double hi = taut_basis_hi(side_of(p->surface, d));
            double at[2] = {p->at[0], p->at[1]};
            at[d] = fmin(fmax(at[d] + side * aside * (hi - lo), lo), hi);
            const double way = fabs(at[d] - p->at[d]) * taut_norm(p->s[1 + d]);
            const double there = way > 0 ? value_beside(p, value, at[0], at[1]) : (double)NAN;
            slope = isnan(there) ? slope : fmax(slope, fabs(there - here) / way);
        }
    }
    return fabs(here) / slope;
}

/* The sine between the direction that does not bend and the line K = 0 there; NaN on the border, where K is not known on both
 * sides. */
static double sine_of_end(const place *p)
{
    const taut_forms *f = &p->forms;
    double way[2] = {-f->m, f->l}, slope[2];

    if (fabs(f->n) > fabs(f->l)) {
        way[0] = f->n;
        way[1] = -f->m;
    }
    for (int d = 0; d < 2; d++) {
        const double step =
            aside * (taut_basis_hi(side_of(p->surface, d)) - taut_basis_lo(side_of(p->surface, d)));
        double at[2][2] = {{p->at[0], p->at[1]}, {p->at[0], p->at[1]}};
        at[0][d] -= step;
        at[1][d] += step;
        slope[d] = (value_beside(p, gaussian_of, at[1][0], at[1][1]) -
                    value_beside(p, gaussian_of, at[0][0], at[0][1])) /
                   (2 * step);
    }
    /* the gradient's length, and along the direction */
    const double steep = sqrt(fmax(
        (f->g * slope[0] * slope[0] - 2 * f->f * slope[0] * slope[1] + f->e * slope[1] * slope[1]) /
            (f->w * f->w),
        0));
    const double length =
        sqrt(f->e * way[0] * way[0] + 2 * f->f * way[0] * way[1] + f->g * way[1] * way[1]);
    return fabs(slope[0] * way[0] + slope[1] * way[1]) / (length * steep);
}

static double judge_parabolic(const taut_net_audit *audit, const place *p, int is_envelope)
{
    if (audit->lines->net != TAUT_TRACE_ASYMPTOTIC || !p->forms.regular) {
        return INFINITY;
    }
    const double sine = sine_of_end(p);
    return (is_envelope ? sine > most_sine : sine < least_sine) ? INFINITY
                                                                : distance_to_zero(p, gaussian_of);
}

static double judge_round(const taut_net_audit *audit, const place *p, int is_flat)
{
    const double mean = fabs(p->forms.mean) / audit->roundest;
    const int has_radius =
        audit->lines->net == TAUT_TRACE_ASYMPTOTIC || audit->lines->net == TAUT_TRACE_PRINCIPAL;

    if (!has_radius || !p->forms.regular || (is_flat ? mean > flat_mean : mean < least_mean)) {
        return INFINITY;
    }
    return taut_net_radius(&p->forms) <= roundness * audit->roundest
               ? 0
               : distance_to_zero(p, radius_of);
}

/* ---- borders ---- */

/* Is the surface one beyond its borders of direction d, with one normal? Then curves go on across them. */
static int wraps(const taut_net_audit *audit, const taut_surface *surface, int d)
{
    const taut_basis *held = side_of(surface, d), *along = side_of(surface, 1 - d);
    const double lo = taut_basis_lo(along), width = taut_basis_hi(along) - lo;

    for (int i = 0; i < SEAM_PLACES; i++) {
        double x[2][3];
        taut_forms f[2];
        for (int side = 0; side < 2; side++) {
            double at[2];
            at[d] = side == 0 ? taut_basis_lo(held) : taut_basis_hi(held);
            at[1 - d] = lo + width * (i + 0.5) / SEAM_PLACES;
            if (taut_surface_eval(surface, at[0], at[1], 0, x[side]) != TAUT_OK ||
                taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &f[side]) != TAUT_OK ||
                !f[side].regular) {
                return 0;
            }
        }
        if (!(taut_distance(x[0], x[1]) <= same_line * audit->size) ||
            !(taut_distance(f[0].normal, f[1].normal) <= same_normal)) {
            return 0;
        }
    }
    return 1;
}

/* Do curves go on across this edge? Then it is no end. */
static int goes_on(const taut_net_audit *audit, const place *p, int edge)
{
    return (audit->lines->net != TAUT_TRACE_ISOPARAMETRIC &&
            taut_net_seams_join(audit->seams, p->on, edge)) ||
           wraps(audit, p->surface, edge / 2);
}

static double border_away(const place *p, int edge)
{
    const taut_basis *basis = side_of(p->surface, edge / 2);
    const double border = edge % 2 == 0 ? taut_basis_lo(basis) : taut_basis_hi(basis);
    return fabs(p->at[edge / 2] - border) * taut_norm(p->s[1 + edge / 2]);
}

/* `edge u0` and `corner u0v0`: the word's edges, of which curves do not go on across one. */
static double judge_border(const taut_net_audit *audit, const place *p, const char *word)
{
    static const char *const edges[EDGES] = {"u0", "u1", "v0", "v1"};
    char known[32];

    for (int e = 0; e < EDGES; e++) {
        const int u = e % 2, v = 2 + e / 2; /* of a corner */
        snprintf(known, sizeof known, "edge %s", edges[e]);
        if (strcmp(word, known) == 0) {
            return goes_on(audit, p, e) ? INFINITY : border_away(p, e);
        }
        snprintf(known, sizeof known, "corner %s%s", edges[u], edges[v]);
        if (strcmp(word, known) == 0) {
            return goes_on(audit, p, u) && goes_on(audit, p, v)
                       ? INFINITY
                       : fmax(border_away(p, u), border_away(p, v));
        }
    }
    return INFINITY;
}

/* Does the net exist on a side of a break? */
static int has_net(const taut_net_audit *audit, const taut_forms *f)
{
    const double square = f->mean * f->mean - f->gaussian;
    return audit->lines->net == TAUT_TRACE_ASYMPTOTIC
               ? f->gaussian < -no_saddle * fabs(square)
               : audit->lines->net != TAUT_TRACE_PRINCIPAL || square > 0;
}

/* Does the normal jump there, across a break of direction d, or the net end as the curvature jumps? A border that the surface goes
 * on across is a break too. */
static int is_crease(const taut_net_audit *audit, const place *p, int d)
{
    const taut_basis *basis = side_of(p->surface, d);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    double at[2][2] = {{p->at[0], p->at[1]}, {p->at[0], p->at[1]}};
    int span[2] = {0, 0}, first[2];
    taut_forms after, before;

    int is_on = taut_net_on_break(p->surface, d, p->at, &span[d]);
    taut_net_on_break(p->surface, 1 - d, p->at, &span[1 - d]);
    first[1 - d] = span[1 - d];
    first[d] = span[d] - 1;
    if (!is_on && (p->at[d] == lo || p->at[d] == hi) && wraps(audit, p->surface, d)) {
        is_on = 1;
        span[d] = 0;
        first[d] = taut_basis_span_count(basis) - 1;
        at[0][d] = lo;
        at[1][d] = hi;
    }
    if (!is_on) {
        return 0;
    }
    taut_net_side_forms(p->surface, span, at[0], &after);
    taut_net_side_forms(p->surface, first, at[1], &before);
    return before.regular && after.regular &&
           (taut_distance(before.normal, after.normal) > crease_limit ||
            has_net(audit, &before) != has_net(audit, &after));
}

/* ---- seeds and lengths ---- */

static const char *word_of(const taut_record *lath, int end)
{
    return taut_record_text(taut_record_at(taut_record_get(lath, "ended"), (size_t)end));
}

/* Two places of the window that differ by rounding alone. */
static int are_one(const taut_surface *surface, const double a[2], const double b[2])
{
    int near = 1;
    for (int d = 0; d < 2; d++) {
        const taut_basis *basis = side_of(surface, d);
        near &= fabs(a[d] - b[d]) <= 1e-12 * (taut_basis_hi(basis) - taut_basis_lo(basis));
    }
    return near;
}

/* Does the document, or without it the lath, say that a geodesic begins there, or ends? */
static int is_seed(const taut_net_audit *audit, const taut_record *lath, const place *p, int end)
{
    const taut_trace_problem *problem = audit->problem;
    const taut_record *known = taut_record_get(lath, end == 0 ? "seed" : "to");
    const double told[2] = {taut_record_number(taut_record_at(known, 0)),
                            taut_record_number(taut_record_at(known, 1))};

    if (audit->lines->net != TAUT_TRACE_GEODESIC) {
        return 0;
    }
    for (int k = 0; problem != NULL && k < problem->seed_count; k++) {
        const taut_trace_seed *seed = &problem->seeds[k];
        if (end == 0 ? !seed->both && are_one(p->surface, seed->at, p->at)
                     : seed->has_to && are_one(p->surface, seed->to, p->at)) {
            return 1;
        }
    }
    return problem == NULL && are_one(p->surface, told, p->at);
}

/* How long the curve is from its seed to an end, times 2^-unit. */
static double length_to(const taut_net_audit *audit, const taut_net_line *line,
                        const taut_record *lath, int end)
{
    const taut_basis *range = taut_curve_t(line->space);
    double away = INFINITY;
    const double seed = taut_net_seed_at(audit, line, lath, &away);
    return ldexp(end == 0 ? seed - taut_basis_lo(range) : taut_basis_hi(range) - seed,
                 -audit->unit);
}

double taut_net_longest(const taut_net_audit *audit)
{
    const taut_trace_problem *problem = audit->problem;
    double longest = 0;

    if (problem != NULL) {
        return problem->max_length > 0 ? ldexp(problem->max_length, -audit->unit)
                                       : 20 * audit->size;
    }
    for (int k = 0; k < audit->lines->count; k++) {
        const taut_net_line *line = &audit->lines->lines[k];
        const taut_record *lath = taut_net_lath_of(audit->lines, line);
        for (int end = 0; end < 2; end++) {
            if (strcmp(word_of(lath, end), "length") == 0) {
                longest = fmax(longest, length_to(audit, line, lath, end));
            }
        }
    }
    return longest > 0 ? longest : (double)INFINITY;
}

/* ---- an end ---- */

static double judge_word(const taut_net_audit *audit, const taut_record *lath, const place ends[2],
                         int end)
{
    const place *p = &ends[end];
    const char *word = word_of(lath, end);

    if (strncmp(word, "edge ", 5) == 0 || strncmp(word, "corner ", 7) == 0) {
        return judge_border(audit, p, word);
    }
    if (strcmp(word, "closed") == 0) {
        return taut_dot(ends[0].tangent, ends[1].tangent) > 0 ? taut_distance(ends[0].x, ends[1].x)
                                                              : (double)INFINITY;
    }
    if (strcmp(word, "parabolic") == 0 || strcmp(word, "envelope") == 0) {
        return judge_parabolic(audit, p, word[0] == 'e');
    }
    if (strcmp(word, "flat") == 0 || strcmp(word, "umbilic") == 0) {
        return judge_round(audit, p, word[0] == 'f');
    }
    if (strcmp(word, "crease") == 0) {
        return is_crease(audit, p, 0) || is_crease(audit, p, 1) ? 0 : (double)INFINITY;
    }
    if (strcmp(word, "singular") == 0) {
        return p->forms.regular ? distance_to_zero(p, normal_of) : 0;
    }
    if (strcmp(word, "seed") == 0) {
        return is_seed(audit, lath, p, end) ? 0 : (double)INFINITY;
    }
    return strcmp(word, "length") == 0 ? 0 : (double)INFINITY;
}

double taut_net_end_away(const taut_net_audit *audit, const taut_net_line *line, int end,
                         double longest)
{
    const taut_record *lath = taut_net_lath_of(audit->lines, line);
    const int is_length = strcmp(word_of(lath, end), "length") == 0;
    const int is_between =
        strcmp(word_of(lath, 0), "seed") == 0 && strcmp(word_of(lath, 1), "seed") == 0;
    place ends[2];

    if (lath == NULL || !place_of(audit, line, 0, &ends[0]) ||
        !place_of(audit, line, 1, &ends[1])) {
        return INFINITY;
    }
    double away = judge_word(audit, lath, ends, end);
    if (is_length || !(line->length <= ldexp(longest, audit->unit) || is_between)) {
        const double over = length_to(audit, line, lath, end) - longest;
        const double most = is_length ? fabs(over) : over;
        away = taut_certify_max(away, most < INFINITY && most <= same_length * longest ? 0 : most);
    }
    return away / audit->size;
}
