/* outline.c -- does the boundary of a film project onto a convex curve, run through once (outline.h)?
 *
 *     for every edge, for every span on it
 *         x, y, w    the outermost coefficients of the piece
 *         a, a x a', |a|^2   by Bernstein coefficients; while a x a' is not shown to be of its sign
 *                    and what that may turn back is more than rounding: halves
 *         the angle from the last tangent of the span before
 *
 * v0 and u1 are run through in the direction of their parameter, u0 and v1 against it, for J > 0.
 */
#include "certify/plateau/outline.h"

#include "certify/common/field.h"
#include "certify/common/verdict.h"
#include "certify/plateau/piece.h"
#include "core/elementary/elementary.h"

#include <math.h>
#include <string.h>

enum { DEPTH_MAX = 7 };
static const double rounding = 1e-13; /* of an angle turned back: halves would not make it less */
static const double up = 1 + 0x1p-40;
static const double sharp =
    0x1p20; /* of its error at least: a tangent whose direction is known to 1e-6 */
static const double corner_most = 3.1; /* an angle that is told from its like the other way round */

typedef taut_outline_number near_number;

/* One span of an edge: a, a x a' and |a|^2; the first and the last tangent. */
typedef struct stretch {
    taut_field a[2];
    taut_field turn, speed; /* a x a', |a|^2 */
    near_number first[2], last[2];
    double length;
} stretch;

static near_number coefficient(const taut_field *f, int k)
{
    return (near_number){f->a[k], f->e[k]};
}

/* The length of the control polygon, which is no less than the curve's, as weights are positive. */
static double polygon_length(const taut_field x[4])
{
    double length = 0, before[2] = {0, 0};

    for (int k = 0; k <= x[0].p; k++) {
        const double w = x[3].p > 0 ? x[3].a[k] : x[3].a[0];
        const double we = x[3].p > 0 ? x[3].e[k] : x[3].e[0];
        double at[2];
        for (int c = 0; c < 2; c++) {
            at[c] = x[c].a[k] / w;
            length += k > 0 ? fabs(at[c] - before[c]) : 0;
            length += 2 * (x[c].e[k] / w + fabs(at[c]) * (we / w + 0x1p-50)) / (1 - we / w);
            before[c] = at[c];
        }
    }
    return up * length;
}

static int make_stretch(taut_arena *arena, const taut_flux_task *task, int edge, int i, int j,
                        stretch *s)
{
    taut_field given[4], x[4], d[4], da[2], *a = s->a;

    if (!taut_field_of_edge(arena, task->surface, edge, edge < 2 ? j : i,
                            taut_certify_origin(task, i, j), task->exponent, given)) {
        return 0;
    }
    taut_certify_turn(arena, task, given, x);
    for (int c = 0; c < 4; c++) {
        d[c] = taut_field_du(arena, &x[c]);
    }
    for (int c = 0; c < 2; c++) {
        const taut_field one = taut_field_product(arena, &x[3], &d[c]);
        const taut_field other = taut_field_product(arena, &d[3], &x[c]);
        a[c] = x[3].p > 0 ? taut_field_difference(arena, &one, &other) : one;
        da[c] = taut_field_du(arena, &a[c]);
    }
    const taut_field one = taut_field_product(arena, &a[0], &da[1]);
    const taut_field other = taut_field_product(arena, &a[1], &da[0]);
    const taut_field square = taut_field_product(arena, &a[0], &a[0]);
    const taut_field second = taut_field_product(arena, &a[1], &a[1]);
    s->turn = taut_field_difference(arena, &one, &other);
    s->speed = taut_field_sum(arena, &square, &second);
    if (taut_arena_status(arena) != TAUT_OK || s->turn.a == NULL || s->speed.a == NULL ||
        x[0].a == NULL) {
        return 0;
    }
    for (int c = 0; c < 2; c++) {
        s->first[c] = coefficient(&a[c], 0);
        s->last[c] = coefficient(&a[c], a[c].p);
    }
    s->length = polygon_length(x);
    return 1;
}

/* What the curve may turn back over the width of this part; forward: 1 or -1, the sense in which a x a' has
 * to be positive. */
static double turned_back(taut_arena *arena, const taut_field *turn, const taut_field *speed,
                          double forward, double width, int depth)
{
    const double low = forward > 0 ? taut_field_low(turn) : -taut_field_high(turn);
    const double slowest = taut_field_low(speed);
    taut_field turns[2], speeds[2];

    if (low >= 0 && slowest > 0) {
        return 0;
    }
    if (slowest > 0 && -low * width <= rounding * slowest) {
        return up * -low * width / slowest;
    }
    if (depth >= DEPTH_MAX) {
        return slowest > 0 ? up * -low * width / slowest : INFINITY;
    }
    taut_field_halve(arena, turn, 0, &turns[0], &turns[1]);
    taut_field_halve(arena, speed, 0, &speeds[0], &speeds[1]);
    return turned_back(arena, &turns[0], &speeds[0], forward, 0.5 * width, depth + 1) +
           turned_back(arena, &turns[1], &speeds[1], forward, 0.5 * width, depth + 1);
}

/* How far the tangent turns back from one span to the next: its sine over its cosine is no less. */
static double turned_at_knot(const near_number before[2], const near_number after[2],
                             double forward)
{
    double cross = forward * (before[0].value * after[1].value - before[1].value * after[0].value);
    double dot = before[0].value * after[0].value + before[1].value * after[1].value;

    for (int c = 0; c < 2; c++) {
        for (int k = 0; k < 2; k++) {
            const double size = fabs(before[c].value), other = fabs(after[k].value);
            const double error = before[c].error * (other + after[k].error) +
                                 size * (after[k].error + 0x1p-51 * other);
            cross -= c != k ? up * error : 0;
            dot -= c == k ? up * error : 0;
        }
    }
    if (cross >= 0) {
        return 0; /* to the left by less than pi */
    }
    return dot > 0 ? up * -cross / dot : INFINITY;
}

/* Adds edge u0, u1, v0 or v1 (0..3). */
static taut_status add_edge(const taut_flux_task *task, int edge, taut_outline_bound *bound)
{
    const taut_basis *u = taut_surface_u(task->surface), *v = taut_surface_v(task->surface);
    const int spans = taut_basis_span_count(edge < 2 ? v : u);
    const int across = edge % 2 == 0 ? 0 : taut_basis_span_count(edge < 2 ? u : v) - 1;
    const double forward = (edge == 1 || edge == 2 ? 1 : -1) * task->sign;
    near_number last[2] = {{0, 0}, {0, 0}};
    taut_status status = TAUT_OK;

    for (int k = 0; status == TAUT_OK && k < spans; k++) {
        taut_arena *arena = taut_arena_new();
        stretch s;
        if (make_stretch(arena, task, edge, edge < 2 ? across : k, edge < 2 ? k : across, &s)) {
            bound->turned_back += turned_back(arena, &s.turn, &s.speed, forward, 1, 0);
            bound->turned_back += k > 0 ? turned_at_knot(last, s.first, forward) : 0;
            bound->length += s.length;
            last[0] = s.last[0];
            last[1] = s.last[1];
        } else {
            bound->turned_back = INFINITY;
        }
        status = taut_arena_status(arena);
        taut_arena_free(arena);
    }
    return status;
}

taut_status taut_certify_outline(const taut_flux_task *task, taut_outline_bound *bound)
{
    taut_outline_bound found = {0, 0};
    taut_status status = TAUT_OK;

    for (int edge = 0; status == TAUT_OK && edge < 4; edge++) {
        status = add_edge(task, edge, &found);
    }
    found.turned_back *= up;
    found.length *= up;
    *bound = found;
    return status;
}

/* ---- sides of a boundary of many ---- */

/* Adds the angle that a turns by; 0 where its direction is not known well enough. */
static int add_angle(taut_arena *arena, const taut_field a[2], int depth, double *angle)
{
    const int last = a[0].p;
    double mean[2] = {0, 0};
    int ahead = a[0].a != NULL && a[1].a != NULL && a[1].p == last;

    for (int k = 0; ahead && k <= last; k++) {
        mean[0] += a[0].a[k];
        mean[1] += a[1].a[k];
    }
    const double size = fabs(mean[0]) + fabs(mean[1]);
    for (int k = 0; ahead && k <= last; k++) {
        const double along = mean[0] * a[0].a[k] + mean[1] * a[1].a[k];
        ahead = along > sharp * size * (a[0].e[k] + a[1].e[k]);
    }
    if (ahead) { /* all in one half plane: by less than pi */
        const double x = a[0].a[0], y = a[1].a[0], to[2] = {a[0].a[last], a[1].a[last]};
        *angle += taut_atan2(x * to[1] - y * to[0], x * to[0] + y * to[1]);
        return 1;
    }
    taut_field halves[2][2];
    if (depth >= DEPTH_MAX || a[0].a == NULL || a[1].a == NULL) {
        return 0;
    }
    for (int c = 0; c < 2; c++) {
        taut_field_halve(arena, &a[c], 0, &halves[0][c], &halves[1][c]);
    }
    return add_angle(arena, halves[0], depth + 1, angle) &&
           add_angle(arena, halves[1], depth + 1, angle);
}

static double angle_between(const near_number before[2], const near_number after[2])
{
    const double angle =
        taut_atan2(before[0].value * after[1].value - before[1].value * after[0].value,
                   before[0].value * after[0].value + before[1].value * after[1].value);
    return fabs(angle) < corner_most ? angle : INFINITY;
}

static void turn_round(near_number a[2])
{
    a[0].value = -a[0].value;
    a[1].value = -a[1].value;
}

taut_status taut_certify_outline_side(const taut_flux_task *task, int edge, int is_backward,
                                      taut_outline_side *side)
{
    const taut_basis *u = taut_surface_u(task->surface), *v = taut_surface_v(task->surface);
    const int spans = taut_basis_span_count(edge < 2 ? v : u);
    const int across = edge % 2 == 0 ? 0 : taut_basis_span_count(edge < 2 ? u : v) - 1;
    taut_outline_side found = {.bound = {0, 0}};
    taut_status status = add_edge(task, edge, &found.bound);

    for (int k = 0; status == TAUT_OK && k < spans; k++) {
        taut_arena *arena = taut_arena_new();
        stretch s;
        if (!make_stretch(arena, task, edge, edge < 2 ? across : k, edge < 2 ? k : across, &s) ||
            !add_angle(arena, s.a, 0, &found.turned)) {
            found.turned = INFINITY;
        } else {
            found.turned += k > 0 ? angle_between(found.end, s.first) : 0;
            if (k == 0) {
                memcpy(found.begin, s.first, sizeof found.begin);
            }
            memcpy(found.end, s.last, sizeof found.end);
        }
        status = taut_arena_status(arena);
        taut_arena_free(arena);
    }
    if (is_backward) {
        near_number first[2];
        memcpy(first, found.begin, sizeof first);
        memcpy(found.begin, found.end, sizeof first);
        memcpy(found.end, first, sizeof first);
        turn_round(found.begin);
        turn_round(found.end);
        found.turned = -found.turned;
    }
    *side = found;
    return status;
}

double taut_certify_outline_corner(const taut_outline_side *before, const taut_outline_side *after,
                                   double sense, double *turned)
{
    *turned += angle_between(before->end, after->begin);
    return turned_at_knot(before->end, after->begin, sense);
}
