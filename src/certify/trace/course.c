/* course.c
 *
 *     sums up to a place within a span: Gauss's rule from the span's beginning to the place, of the polynomials
 *     through the nodes; |bend| is summed between the places where it vanishes
 */
#include "certify/trace/course.h"

#include "core/elementary/elementary.h"

#include <math.h>

enum { NODES = TAUT_NET_NODES, HEIGHTS = TAUT_NET_NODES, ROUNDS = 48 };
/* A node's measure over the largest one from which on it is looked between nodes. */
static const double near_most = 0.99;
/* w tau / 2 from which on sqrt(1 + h^2 tau^2) is taken in closed form. */
static const double sharp = 2;

/* mu - 1: the mean of sqrt(1 + h^2 tau^2) - 1 over the heights, by Gauss's rule; of a strip that twists much within its
 * width the integral in closed form, as the root is too sharp for a rule. */
static double mean_more(const taut_net_rule *rule, double width, double tau)
{
    const double edge = fabs(width / 2 * tau);
    double sum = 0;
    if (edge > sharp) {
        const double root = sqrt(1 + edge * edge);
        return (root + taut_log(edge + root) / edge) / 2 - 1;
    }
    for (int k = 0; k < HEIGHTS; k++) {
        const double y = edge * (1 + rule->nodes[k]) / 2;
        sum += rule->weights[k] / 2 * (y * y / (1 + sqrt(1 + y * y)));
    }
    return sum;
}

static void fill_span(const taut_net_rule *rule, const taut_net_cut *cut, int is_geodesic,
                      double size, const taut_net_spot *spots, taut_net_bent *span)
{
    const double width = cut->is_cut && !cut->only_bends ? cut->width : 0;

    double k_g[NODES], blur = 0;

    taut_net_sideways_bend(rule, spots, span->from, span->to, k_g);
    for (int i = 0; i < NODES; i++) {
        double sum =
            0; /* of what the nodes' directions may be off by, in their difference at this one */
        for (int k = 0; k < NODES; k++) {
            sum += fabs(rule->derive[i][k]) * spots[k].blur;
        }
        blur = fmax(blur, sum);
    }
    span->blur = blur * size / span->half;
    for (int i = 0; i < NODES; i++) {
        span->bend[TAUT_NET_K_N][i] = spots[i].k_n;
        span->bend[TAUT_NET_K_G][i] = is_geodesic ? 0 : k_g[i];
        span->bend[TAUT_NET_TAU][i] = spots[i].tau;
        span->more[i] = width > 0 ? mean_more(rule, width, spots[i].tau) : 0;
        const double ratio = spots[i].tau / span->bend[cut->weak][i];
        span->skew[i] = cut->only_bends ? (cut->weak == TAUT_NET_K_N ? -ratio : ratio) : 0;
    }
    for (int i = 0; cut->only_bends && i < NODES; i++) {
        span->slope[i] = 0;
        for (int k = 0; k < NODES; k++) {
            span->slope[i] += rule->derive[i][k] / span->half * span->skew[k];
        }
    }
}

/* The sums at x in [-1, 1] of a span that begins where it says. */
static void sum_to(const taut_net_course *course, const taut_net_bent *span, double x,
                   taut_net_course_at *at)
{
    const taut_net_rule *rule = course->rule;
    const taut_net_cut *cut = &course->cut;
    const double half = (1 + x) / 2;

    at->cut = span->cut + (1 + x) * span->half;
    at->theta = span->theta;
    at->x = span->x;
    at->y = span->y;
    for (int k = 0; k < NODES; k++) {
        const double here = -1 + half * (1 + rule->nodes[k]);
        const double weight = half * rule->weights[k] * span->half;
        const double more = cut->is_mean ? taut_net_rule_at(rule, span->more, here) : 0;
        double theta = span->theta;
        for (int j = 0; cut->flat >= 0 && j < NODES; j++) {
            const double there = -1 + (1 + here) / 2 * (1 + rule->nodes[j]);
            theta += (1 + here) / 2 * rule->weights[j] * span->half *
                     taut_net_rule_at(rule, span->bend[cut->flat], there);
        }
        at->cut += weight * more;
        at->x += weight * (1 + more) * (cut->flat >= 0 ? taut_cos(theta) : 1);
        at->y += cut->flat >= 0 ? weight * (1 + more) * taut_sin(theta) : 0;
        at->theta +=
            cut->flat >= 0 ? weight * taut_net_rule_at(rule, span->bend[cut->flat], here) : 0;
    }
}

int taut_net_course_new(taut_net_cells *cells, const taut_net_lines *lines,
                        const taut_net_line *line, const taut_net_rule *rule,
                        const taut_net_cut *cut, int unit, taut_net_course *course)
{
    const taut_basis *basis = taut_curve_t(line->space);
    const double *breaks = taut_basis_breaks(basis);
    taut_net_spot spots[NODES];

    *course = (taut_net_course){.rule = rule, .cut = *cut, .count = taut_basis_span_count(basis)};
    course->spans = taut_arena_take(cells->arena, (size_t)course->count + 1, sizeof *course->spans);
    if (course->spans == NULL) {
        return 0;
    }
    for (int i = 0; i < course->count; i++) {
        taut_net_bent *span = &course->spans[i], *next = span + 1;
        span->from = breaks[i];
        span->to = breaks[i + 1];
        span->half = ldexp(span->to - span->from, -unit) / 2;
        if (!taut_net_spots(cells, lines->net, line, rule, span->from, span->to, spots)) {
            return 0;
        }
        fill_span(rule, cut, lines->net == TAUT_TRACE_GEODESIC, ldexp(lines->size, -unit), spots,
                  span);
        taut_net_course_at end;
        if (cut->is_cut) {
            sum_to(course, span, 1, &end);
            next->cut = end.cut;
            next->x = end.x;
            next->y = end.y;
            next->theta = end.theta;
        }
        course->length += 2 * span->half;
        for (int k = 0; k < NODES; k++) {
            const double y = cut->width / 2 * span->bend[TAUT_NET_TAU][k];
            course->stretch += rule->weights[k] * span->half * span->more[k];
            course->edge += rule->weights[k] * span->half * (y * y / (1 + sqrt(1 + y * y)));
        }
    }
    return 1;
}

static const taut_net_bent *span_of(const taut_net_course *course, double t, int beyond, double *x)
{
    int i = 0;
    while (i + 1 < course->count &&
           (t > course->spans[i].to || (beyond && t == course->spans[i].to))) {
        i++;
    }
    const taut_net_bent *span = &course->spans[i];
    *x = fmin(fmax(2 * (t - span->from) / (span->to - span->from) - 1, -1), 1);
    return span;
}

static void bends_at(const taut_net_course *course, const taut_net_bent *span, double x,
                     taut_net_course_at *at)
{
    for (int k = 0; k < TAUT_NET_BENDS; k++) {
        at->bend[k] = taut_net_rule_at(course->rule, span->bend[k], x);
    }
    at->blur = span->blur;
    at->skew = course->cut.only_bends ? taut_net_rule_at(course->rule, span->skew, x) : 0;
    at->slope = course->cut.only_bends ? taut_net_rule_at(course->rule, span->slope, x) : 0;
}

static taut_net_course_at see(const taut_net_course *course, double t, int beyond)
{
    taut_net_course_at at = {.cut = 0};
    double x = 0;
    const taut_net_bent *span = span_of(course, t, beyond, &x);
    bends_at(course, span, x, &at);
    if (course->cut.is_cut) {
        sum_to(course, span, x, &at);
    }
    return at;
}

taut_net_course_at taut_net_course_see(const taut_net_course *course, double t)
{
    return see(course, t, 0);
}

taut_net_course_at taut_net_course_beyond(const taut_net_course *course, double t)
{
    return see(course, t, 1);
}

int taut_net_course_closer(taut_net_cells *cells, taut_trace_net net, const taut_net_line *line,
                           const taut_net_course *course, double t, int beyond, double part,
                           double *k_g)
{
    taut_net_spot spots[NODES];
    double x = 0, values[NODES];
    const taut_net_bent *span = span_of(course, t, beyond, &x);
    const double room = part * (span->to - span->from);
    const double from = fmax(t - room, span->from), to = fmin(t + room, span->to);

    if (net == TAUT_TRACE_GEODESIC || !(to > from) ||
        !taut_net_spots(cells, net, line, course->rule, from, to, spots)) {
        return 0;
    }
    taut_net_sideways_bend(course->rule, spots, from, to, values);
    *k_g =
        taut_net_rule_at(course->rule, values, fmin(fmax(2 * (t - from) / (to - from) - 1, -1), 1));
    return 1;
}

/* int |p| dx from a to b, where p does not change its sign. */
static double part_of(const taut_net_rule *rule, const double *values, double a, double b)
{
    double sum = 0;
    for (int k = 0; k < NODES; k++) {
        sum += rule->weights[k] *
               taut_net_rule_at(rule, values, a + (b - a) / 2 * (1 + rule->nodes[k]));
    }
    return fabs(sum) * (b - a) / 2;
}

/* Where the polynomial through the values vanishes between two nodes of different sign. */
static double root_of(const taut_net_rule *rule, const double *values, int i)
{
    double low = rule->nodes[i], high = rule->nodes[i + 1];
    for (int round = 0; round < ROUNDS; round++) {
        const double middle = (low + high) / 2;
        if ((taut_net_rule_at(rule, values, middle) > 0) == (values[i] > 0)) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

double taut_net_course_sum(const taut_net_course *course, int bend, int *changes)
{
    double sum = 0;
    *changes = 0;
    for (int i = 0; i < course->count; i++) {
        const taut_net_bent *span = &course->spans[i];
        const double *values = span->bend[bend];
        double from = -1, plain = 0, parts = 0;
        for (int k = 0; k < NODES; k++) {
            plain += course->rule->weights[k] * fabs(values[k]);
            if (k + 1 < NODES && values[k] * values[k + 1] < 0) {
                const double root = root_of(course->rule, values, k);
                parts += part_of(course->rule, values, from, root);
                from = root;
                *changes = 1;
            }
        }
        sum += span->half * (from == -1 ? plain : parts + part_of(course->rule, values, from, 1));
    }
    return sum;
}

static double measure_at(const taut_net_course *course, const taut_net_bent *span,
                         taut_net_measure *measure, double x)
{
    taut_net_course_at at = {.cut = 0};
    bends_at(course, span, x, &at);
    return measure(course, &at);
}

/* By golden section between two places of a span. */
static double climb(const taut_net_course *course, const taut_net_bent *span,
                    taut_net_measure *measure, double low, double high)
{
    const double golden = 0.6180339887498949;
    double most = 0;
    for (int round = 0; round < ROUNDS; round++) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        const double at_a = measure_at(course, span, measure, a);
        const double at_b = measure_at(course, span, measure, b);
        most = fmax(most, fmax(at_a, at_b));
        low = at_a > at_b ? low : a;
        high = at_a > at_b ? b : high;
    }
    return most;
}

double taut_net_course_most(const taut_net_course *course, taut_net_measure *measure, double from,
                            double to, int fine)
{
    double most = 0;
    for (int pass = 0; pass < 1 + (fine != 0); pass++) {
        for (int i = 0; i < course->count; i++) {
            const taut_net_bent *span = &course->spans[i];
            for (int k = 0; k < NODES; k++) {
                const double x = course->rule->nodes[k];
                const double t = span->from + (span->to - span->from) * (1 + x) / 2;
                if (!(t >= from) || !(t <= to)) {
                    continue;
                }
                taut_net_course_at at = {.cut = 0};
                for (int j = 0; j < TAUT_NET_BENDS; j++) {
                    at.bend[j] = span->bend[j][k];
                }
                at.blur = span->blur;
                at.skew = span->skew[k];
                at.slope = span->slope[k];
                const double here = measure(course, &at);
                if (pass == 0) {
                    most = fmax(most, here);
                } else if (here >= near_most * most) {
                    const double low = k > 0 ? course->rule->nodes[k - 1] : -1;
                    const double high = k + 1 < NODES ? course->rule->nodes[k + 1] : 1;
                    most = fmax(most, climb(course, span, measure, low, high));
                }
            }
        }
    }
    return most;
}
