/* figures.c
 *
 *     family, from, to         the name's, and the ends of the curve in the window
 *     twist, turn              int |tau_g| ds, int |k_g| ds
 *     k_n, k_g, tau_g          at the seed; the largest at its place, and at no node a larger one
 *     lengths, pattern_end     the sums of certify/trace/course.h
 *     least_radius, stress     the formulas of docs/trace.md of these bends
 */
#include "certify/trace/figures.h"

#include "basis/basis_ops.h"
#include "certify/common/verdict.h"
#include "certify/trace/crossings.h"
#include "certify/trace/flat.h"
#include "certify/trace/laths.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <stdio.h>
#include <string.h>

enum { SEEK = 8, CLOSER = 3 };
/* Where k_g grows without bound at an end, its integral is held to so much less. */
static const double soft_share = 1e-5;
/* And where a bend changes its sign, as nets of version 0.1 were summed by a rule across the kink. */
static const double kink_share = 1e-2;
/* So much less what is cut of strips whose edges are more than twice as long as their axes, where the root has an edge. */
static const double sharp_share = 1e-3;
/* Parts of a span that k_g is seen on once more, each of the one before. */
static const double closer = 1.0 / 16;
/* The largest curvature's share that the curvatures of a lath are held to, over the limit. */
static const double bend_share = 0.1;
/* Over 1 over the size: a lath that bends more somewhere passes a place where rounding turns directions, and is held to so
 * much of that. */
static const double tight_bend = 1e5, tight_share = 1e-3;
/* Over the range: places nearer to a break are seen from beyond it too. And of k_g: below, it is not looked at closer. */
static const double at_break = TAUT_NET_AT_KNOT, close_enough = 1e-7;

static double member_of(const taut_record *at, const char *list, size_t k)
{
    return taut_record_number(taut_record_at(taut_record_get(at, list), k));
}

/* ---- what the lath is ---- */

static taut_net_cut cut_of(const taut_net_audit *audit, const taut_record *lath)
{
    static const char *const strips[] = {"standing", "plank", "developable", "envelope"};
    const taut_trace_laths *asked = audit->problem != NULL ? audit->problem->laths : NULL;
    const double width = asked != NULL ? asked->width : taut_net_number(lath, "width");
    const double thickness = asked != NULL ? asked->thickness : taut_net_number(lath, "thickness");
    const char *strip = taut_record_text(taut_record_get(lath, "strip"));
    taut_net_cut cut = {.is_cut = audit->problem != NULL ? asked != NULL : strip[0] != '\0',
                        .width = width > 0 ? ldexp(width, -audit->unit) : 0,
                        .thickness = thickness > 0 ? ldexp(thickness, -audit->unit) : 0};

    for (int k = 0; k < 4; k++) {
        if (asked != NULL ? (int)asked->strip == k : strcmp(strip, strips[k]) == 0) {
            cut.strip = (taut_trace_strip)k;
        }
    }
    const int lies = cut.strip == TAUT_TRACE_PLANK || cut.strip == TAUT_TRACE_ENVELOPE;
    const taut_trace_net straight = lies ? TAUT_TRACE_GEODESIC : TAUT_TRACE_ASYMPTOTIC;
    cut.weak = lies ? TAUT_NET_K_N : TAUT_NET_K_G;
    cut.flat = audit->lines->net == straight ? -1 : lies ? TAUT_NET_K_G : TAUT_NET_K_N;
    cut.only_bends =
        cut.is_cut && (cut.strip == TAUT_TRACE_DEVELOPABLE || cut.strip == TAUT_TRACE_ENVELOPE);
    cut.is_mean = asked != NULL
                      ? asked->cut == TAUT_TRACE_CUT_MEAN
                      : taut_net_number(lath, "cut_length") != taut_net_number(lath, "length");
    return cut;
}

/* ---- ends ---- */

/* Of `from` and `to`, over the window. */
static double end_off(const taut_net_audit *audit, const taut_net_line *line,
                      const taut_record *lath, int end)
{
    const taut_basis *range = taut_curve_t(line->space);
    double at[2], off = 0;
    int on = 0;

    if (!taut_net_line_window(line, end == 0 ? taut_basis_lo(range) : taut_basis_hi(range), at,
                              &on)) {
        return INFINITY;
    }
    for (int d = 0; d < 2; d++) {
        const taut_surface *surface = audit->cells->surfaces[on];
        const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
        const double told = member_of(lath, end == 0 ? "from" : "to", (size_t)d);
        off = taut_certify_max(off,
                               fabs(told - at[d]) / (taut_basis_hi(basis) - taut_basis_lo(basis)));
    }
    return off;
}

static int is_of_family(const taut_net_audit *audit, const taut_net_line *line,
                        const taut_record *lath)
{
    static const char *const families[4][2] = {{"+", "-"}, {"max", "min"}, {"G", "G"}, {"u", "v"}};
    return strcmp(taut_record_text(taut_record_get(lath, "family")),
                  families[audit->lines->net][line->family]) == 0;
}

/* ---- bends ---- */

/* Is the seed on a knot line? Surfaces may bend otherwise beyond it, though the curve goes on to one side. */
static int is_on_knot(const taut_net_audit *audit, const taut_record *lath)
{
    const double at[2] = {member_of(lath, "seed", 0), member_of(lath, "seed", 1)};
    return taut_net_is_on_knot(audit->cells->surfaces[taut_net_surface_of(audit, lath)], at);
}

/* How far a place is from the box of the points that hold span i at least. */
static double box_away(const taut_curve *curve, int i, const double x[3])
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *points = taut_curve_points(curve) + 3 * basis->first[i];
    double away[3];
    for (int c = 0; c < 3; c++) {
        double low = points[c], high = points[c];
        for (int a = 1; a < basis->shape.local; a++) {
            low = fmin(low, points[3 * a + c]);
            high = fmax(high, points[3 * a + c]);
        }
        away[c] = fmax(fmax(low - x[c], x[c] - high), 0);
    }
    return taut_norm(away);
}

/* The nearest of some places of span i, where that is nearer. */
static void seek_in(const taut_net_line *line, int i, const double x[3], double *nearest,
                    double *best)
{
    const double *breaks = taut_basis_breaks(taut_curve_t(line->space)) + i;
    double there[3];
    for (int k = 0; k <= SEEK; k++) {
        const double t = breaks[0] + (breaks[1] - breaks[0]) * k / SEEK;
        if (taut_curve_eval(line->space, t, 0, there) == TAUT_OK &&
            taut_distance(there, x) < *nearest) {
            *nearest = taut_distance(there, x);
            *best = t;
        }
    }
}

/* The nearest of some places of the line. Spans are passed over whose points are all farther than places of the span
 * that is the nearest by its points. */
static double nearest_place(const taut_net_line *line, const double x[3], double room)
{
    const int spans = taut_basis_span_count(taut_curve_t(line->space));
    const int is_held = taut_curve_weights(line->space) == NULL;
    double least = INFINITY, near = INFINITY, nearest = INFINITY;
    double best = taut_basis_lo(taut_curve_t(line->space)), unused = best;
    int first = 0;

    for (int i = 0; is_held && i < spans; i++) {
        const double away = box_away(line->space, i, x);
        first = away < least ? i : first;
        least = fmin(least, away);
    }
    seek_in(line, first, x, &near, &unused);
    for (int i = 0; i < spans; i++) {
        if (!is_held || !(box_away(line->space, i, x) > near + room)) {
            seek_in(line, i, x, &nearest, &best);
        }
    }
    return best;
}

/* The nearest of some places, then along the tangent. */
double taut_net_seed_at(const taut_net_audit *audit, const taut_net_line *line,
                        const taut_record *lath, double *away)
{
    const taut_basis *range = taut_curve_t(line->space);
    const double lo = taut_basis_lo(range), hi = taut_basis_hi(range);
    const int on = taut_net_surface_of(audit, lath);
    double seed[3], x[2][3], way[3], best = lo;

    if (taut_surface_eval(audit->cells->surfaces[on], member_of(lath, "seed", 0),
                          member_of(lath, "seed", 1), 0, seed) != TAUT_OK) {
        return NAN;
    }
    for (int c = 0; c < 3; c++) {
        seed[c] = ldexp(seed[c], audit->unit);
    }
    best = nearest_place(line, seed, at_break * ldexp(audit->size, audit->unit));
    for (int round = 0; round < SEEK; round++) {
        if (taut_curve_eval(line->space, best, 1, x[0]) != TAUT_OK) {
            return NAN;
        }
        taut_difference(seed, x[0], way);
        best = fmin(fmax(best + taut_dot(way, x[1]) / taut_dot(x[1], x[1]), lo), hi);
        *away = ldexp(taut_norm(way), -audit->unit) / audit->size;
    }
    return best;
}

static double bend_size(const taut_net_course *course, const taut_net_course_at *at, int bend)
{
    (void)course;
    return fabs(at->bend[bend]);
}

static double normal_size(const taut_net_course *course, const taut_net_course_at *at)
{
    return bend_size(course, at, TAUT_NET_K_N);
}

static double sideways_size(const taut_net_course *course, const taut_net_course_at *at)
{
    return bend_size(course, at, TAUT_NET_K_G);
}

static double twist_size(const taut_net_course *course, const taut_net_course_at *at)
{
    return bend_size(course, at, TAUT_NET_TAU);
}

static taut_net_measure *const sizes[] = {normal_size, sideways_size, twist_size};

/* What k_g is at least, whatever rounding makes of the directions that it is found by. */
static double sideways_least(const taut_net_course *course, const taut_net_course_at *at)
{
    return fmax(sideways_size(course, at) - at->blur, 0);
}

/* How far a bend is from what it is at a parameter, from one side of it; `of_size`: from its absolute value. */
static double bend_beside(const taut_net_audit *audit, const taut_net_line *line,
                          const taut_net_course *course, int bend, double at, int side, double told,
                          int of_size)
{
    const taut_net_course_at seen =
        (side == 0 ? taut_net_course_see : taut_net_course_beyond)(course, at);
    double value = seen.bend[bend], away = fabs(told - (of_size ? fabs(value) : value));
    double part = closer;
    for (int k = 0; bend == TAUT_NET_K_G && away > close_enough * fabs(told) && k < CLOSER; k++) {
        if (taut_net_course_closer(audit->cells, audit->lines->net, line, course, at, side, part,
                                   &value)) {
            away = fmin(away, fabs(told - (of_size ? fabs(value) : value)));
        }
        part *= closer;
    }
    return bend == TAUT_NET_K_G ? fmax(away - seen.blur, 0) : away;
}

/* The same from either side, as surfaces may bend otherwise beyond a break; and at the parameter itself, as beside an
 * umbilic bends change within so little. */
static double bend_off(const taut_net_audit *audit, const taut_net_line *line,
                       const taut_net_course *course, int bend, double t, double told, int of_size)
{
    const taut_basis *range = taut_curve_t(line->space);
    const double room = at_break * (taut_basis_hi(range) - taut_basis_lo(range));
    double least = INFINITY;

    for (int k = 0; !isnan(t) && k < 4 && !(k == 2 && least <= close_enough * fabs(told)); k++) {
        const double at = k == 0 ? t - room : k == 1 ? t + room : t;
        least = taut_certify_min(bend_beside(audit, line, course, bend, at, k % 2, told, of_size),
                                 least);
    }
    return isnan(t) ? t : least;
}

static void look_at_bends(const taut_net_audit *audit, const taut_net_line *line,
                          const taut_record *lath, const taut_net_course *course,
                          const double clear[2], taut_net_off *off)
{
    static const char *const names[] = {"k_n", "k_g", "tau_g"};
    const char *name = taut_curve_name(line->space);
    double far = INFINITY;
    const double seed = taut_net_seed_at(audit, line, lath, &far);
    const int is_seed_clear = !(seed < clear[0]) && !(seed > clear[1]) && !is_on_knot(audit, lath);
    double most[TAUT_NET_BENDS], scale = 1 / audit->size;

    taut_net_off_take(off, far, name, "seed");
    for (int k = 0; k < TAUT_NET_BENDS; k++) {
        most[k] = taut_net_course_most(course, k == TAUT_NET_K_G ? sideways_least : sizes[k],
                                       clear[0], clear[1], 0);
        scale = fmax(scale, most[k]);
    }
    const double share = bend_share * (scale * audit->size > tight_bend ? tight_share : 1);
    for (int k = 0; k < TAUT_NET_BENDS; k++) {
        const taut_record *bend = taut_record_get(lath, names[k]);
        const double at = taut_net_number(bend, "max_at"),
                     largest = ldexp(taut_net_number(bend, "max"), audit->unit);
        const int is_clear = !(at < clear[0]) && !(at > clear[1]);
        double away = is_seed_clear ? bend_off(audit, line, course, k, seed,
                                               ldexp(taut_net_number(bend, "seed"), audit->unit), 0)
                                    : 0;
        away = taut_certify_max(away,
                                is_clear ? bend_off(audit, line, course, k, at, largest, 1) : 0) /
               scale;
        away = taut_certify_max(away, (most[k] - largest) / scale);
        taut_net_off_take(off, share * away, name, names[k]);
    }
}

/* ---- what is cut ---- */

/* Of the ribbon: the largest curvature of a line in it; of strips about their rulings, over their width. */
static double ribbon_size(const taut_net_course *course, const taut_net_course_at *at)
{
    const taut_net_cut *cut = &course->cut;
    const double bend = fabs(at->bend[cut->weak]), tau = at->bend[TAUT_NET_TAU];
    if (!cut->only_bends) {
        return bend / 2 + sqrt(bend * bend / 4 + tau * tau);
    }
    const double round = 1 + at->skew * at->skew;
    const double rate = at->slope - (cut->flat >= 0 ? at->bend[cut->flat] : 0) * round;
    return bend * round / (1 - cut->width / 2 * fabs(rate));
}

static void look_at_lengths(const taut_net_audit *audit, const taut_net_line *line,
                            const taut_record *lath, const taut_net_course *course,
                            taut_net_off *off)
{
    const taut_net_cut *cut = &course->cut;
    const taut_net_bent *end = &course->spans[course->count];
    const char *name = taut_curve_name(line->space);
    const double length = course->length;
    const double share = course->edge > length ? sharp_share : 1;

    if (cut->width > 0) { /* relative to what they are part of */
        const double stretch = ldexp(taut_net_number(lath, "mean_stretch"), -audit->unit);
        const double found = length + course->stretch;
        taut_net_off_take(off, share * fabs(stretch - course->stretch) / found, name,
                          "mean_stretch");
    }
    if (cut->width > 0 && !cut->only_bends) { /* of those the claim isometric */
        const double edge = ldexp(taut_net_number(lath, "edge_length"), -audit->unit);
        const double found = length + course->edge;
        taut_net_off_take(off, share * fabs(edge - found) / found, name, "edge_length");
    }
    taut_net_off_take(off,
                      fabs(ldexp(taut_net_number(lath, "cut_length"), -audit->unit) - end->cut) *
                          share / end->cut,
                      name, "cut_length");
    const double x = ldexp(member_of(lath, "pattern_end", 0), -audit->unit) - end->x;
    const double y = ldexp(member_of(lath, "pattern_end", 1), -audit->unit) - end->y;
    const double theta = member_of(lath, "pattern_end", 2) - end->theta;
    taut_net_off_take(off, taut_certify_max(share * taut_hypot(x, y) / end->cut, fabs(theta)), name,
                      "pattern_end");
}

static void look_at_radius(const taut_net_audit *audit, const taut_net_line *line,
                           const taut_record *lath, const taut_net_course *course,
                           const double clear[2], taut_net_off *off)
{
    const double most = taut_net_course_most(course, ribbon_size, clear[0], clear[1], 1);
    const taut_record *told = taut_record_get(lath, "least_radius");
    const double bend = told != NULL ? ldexp(1 / taut_record_number(told), audit->unit) : 0;
    const int is_whole = isinf(clear[0]) && isinf(clear[1]);
    const double away = (is_whole ? fabs(bend - most) : fmax(most - bend, 0)) * audit->size;
    taut_net_off_take(off, away / fmax(1, most * audit->size), taut_curve_name(line->space),
                      "least_radius");
}

/* ---- stresses, of the document's material ---- */

typedef struct stress {
    double bending, torsion, helix, combined;
} stress;

static stress stress_at(const taut_trace_material *m, const taut_net_course *course,
                        const taut_net_course_at *at)
{
    const taut_net_cut *cut = &course->cut;
    if (cut->only_bends) {
        const double bending = m->e * cut->thickness * ribbon_size(course, at) / 2;
        return (stress){bending, 0, 0, bending};
    }
    const double tau = fabs(at->bend[TAUT_NET_TAU]), across = cut->width * tau;
    stress s = {m->e * cut->thickness * fabs(at->bend[cut->weak]) / 2, m->g * cut->thickness * tau,
                m->e * across * across / 12, 0};
    s.combined = sqrt((s.bending + s.helix) * (s.bending + s.helix) + 3 * s.torsion * s.torsion);
    return s;
}

static void look_at_stress(const taut_net_audit *audit, const taut_net_line *line,
                           const taut_record *lath, const taut_net_course *course,
                           const double clear[2], taut_net_off *off)
{
    const taut_trace_material *m = &audit->problem->laths->material;
    const taut_record *told = taut_record_get(lath, "stress");
    const char *name = taut_curve_name(line->space);
    const double at = taut_net_number(told, "at");
    const double room = at_break * (course->spans[course->count - 1].to - course->spans[0].from);
    const taut_net_course_at sides[2] = {taut_net_course_see(course, at - room),
                                         taut_net_course_beyond(course, at + room)};
    const stress left = stress_at(m, course, &sides[0]), right = stress_at(m, course, &sides[1]);
    const stress s = left.combined > right.combined ? left : right;
    const double combined = taut_net_number(told, "combined");
    const int is_soft = !isinf(clear[0]) || !isinf(clear[1]);
    const int is_clear = !(at < clear[0]) && !(at > clear[1]);
    /* of a lath that hardly bends, to what a circle as large as the surface would ask of it */
    const double least = m->e * course->cut.thickness / audit->size / 2;
    double away = fabs(taut_net_number(told, "use") * m->strength - combined);

    if (is_clear) {
        away = taut_certify_max(away, isnan(at) ? at : fabs(combined - s.combined));
        away = taut_certify_max(away, fabs(taut_net_number(told, "bending") - s.bending));
        away = taut_certify_max(away, fabs(taut_net_number(told, "torsion") - s.torsion));
        away = taut_certify_max(away, fabs(taut_net_number(told, "helix") - s.helix));
    }
    for (int i = 0; i < course->count; i++) { /* none is larger */
        for (int k = 0; k < TAUT_NET_NODES; k++) {
            const taut_net_bent *span = &course->spans[i];
            const double t =
                span->from + (span->to - span->from) * (1 + course->rule->nodes[k]) / 2;
            taut_net_course_at here = {.skew = span->skew[k], .slope = span->slope[k]};
            for (int j = 0; j < TAUT_NET_BENDS; j++) {
                here.bend[j] = span->bend[j][k];
            }
            if (t >= clear[0] && t <= clear[1]) {
                away = taut_certify_max(away, stress_at(m, course, &here).combined - combined);
            }
        }
    }
    taut_net_off_take(off, isnan(combined) ? combined : away / fmax(combined, least), name,
                      "stress");
    const double weak =
        course->cut.only_bends
            ? 2 * s.bending / (m->e * course->cut.thickness)
            : taut_net_course_most(course, sizes[course->cut.weak], clear[0], clear[1], 1);
    /* one that is not told is as thick, or as wide, as one likes; strips that only bend have no width of their own */
    const taut_record *most_thick = taut_record_get(told, "t_max");
    const taut_record *most_wide = taut_record_get(told, "w_max");
    const double thickest =
        most_thick != NULL ? ldexp(taut_record_number(most_thick), -audit->unit) : (double)INFINITY;
    const double bent = 2 * m->strength / (m->e * thickest);
    away = (is_soft && bent > weak ? 0 : fabs(bent - weak)) * audit->size;
    taut_net_off_take(off, away / fmax(1, weak * audit->size), name, "stress t_max");
    const double twist = taut_net_course_most(course, twist_size, clear[0], clear[1], 1);
    const double widest =
        most_wide != NULL ? ldexp(taut_record_number(most_wide), -audit->unit) : (double)INFINITY;
    if (most_wide != NULL || !course->cut.only_bends) {
        away = fabs(sqrt(12 * m->strength / m->e) / widest - twist) * audit->size;
        taut_net_off_take(off, away / fmax(1, twist * audit->size), name, "stress w_max");
    }
}

/* ---- the whole of a lath ---- */

static void look_at_sums(const taut_record *lath, const char *name, const taut_net_course *course,
                         const double clear[2], taut_net_off *off)
{
    int changes[2];
    const double twist = taut_net_course_sum(course, TAUT_NET_TAU, &changes[0]);
    const double turn = taut_net_course_sum(course, TAUT_NET_K_G, &changes[1]);
    const double soft = isinf(clear[0]) && isinf(clear[1]) ? 1 : soft_share;
    const double twisted = changes[0] ? kink_share : 1, turned = changes[1] ? kink_share : 1;

    taut_net_off_take(off, twisted * fabs(taut_net_number(lath, "twist") - twist) / fmax(1, twist),
                      name, "twist");
    double blur = 0; /* what rounding may make of it */
    for (int i = 0; i < course->count; i++) {
        blur += 2 * course->spans[i].half * course->spans[i].blur;
    }
    const double away = fmax(fabs(taut_net_number(lath, "turn") - turn) - blur, 0);
    taut_net_off_take(off, fmin(soft, turned) * away / fmax(1, turn), name, "turn");
}

void taut_net_figures_of(const taut_net_audit *audit, const taut_net_line *line,
                         const double clear[2], taut_net_off *off)
{
    const taut_record *lath = taut_net_lath_of(audit->lines, line);
    const char *name = taut_curve_name(line->space);
    const taut_net_cut cut = cut_of(audit, lath);
    taut_net_course course;

    if (lath == NULL || !taut_net_course_new(audit->cells, audit->lines, line, audit->rule, &cut,
                                             audit->unit, &course)) {
        taut_net_off_take(off, INFINITY, name, "bends");
        return;
    }
    taut_net_off_take(off, is_of_family(audit, line, lath) ? 0 : INFINITY, name, "family");
    taut_net_off_take(off, end_off(audit, line, lath, 0), name, "from");
    taut_net_off_take(off, end_off(audit, line, lath, 1), name, "to");
    look_at_sums(lath, name, &course, clear, off);
    look_at_bends(audit, line, lath, &course, clear, off);
    taut_net_passed_look(audit, line, lath, off);
    if (cut.is_cut) {
        look_at_lengths(audit, line, lath, &course, off);
        look_at_radius(audit, line, lath, &course, clear, off);
        taut_net_slots_look(audit, line, lath, &course, off);
        taut_net_flat_look(audit, line, lath, &course, off);
    }
    if (cut.is_cut && audit->problem != NULL && cut.thickness > 0 &&
        audit->problem->laths->material.e > 0) {
        look_at_stress(audit, line, lath, &course, clear, off);
    }
}
