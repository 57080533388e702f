/* descent.c -- the second derivative of the area along moves d, from below.
 *
 *     d.H d = iint |x_v (N.d_u) - x_u (N.d_v)|^2 / W^3 + 2 N.(d_u x d_v) / W,
 *     N = x_u x x_v,  W = |N|                       (G a^2 - 2 F a b + E b^2 of docs/plateau.md)
 *
 *     choose the fewest nodes a cell whose remainder is small beside the integral of the bounds
 *     sum the integrand at the nodes, with the surface moved to its first point and of unit size
 *     less the remainder, less what rounding of all that the integrand is made of can do to it
 */
#include "certify/plateau/descent.h"

#include "certify/common/verdict.h"
#include "certify/dirichlet/remainder.h"
#include "core/arena.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "geometry/keep.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stddef.h>

enum { LINES = 16 /* evaluated at once */, VALUES = 9, POINT_WORK = 500 /* as pulses count */ };

/* A remainder this small, of what a relative error of 1 could do, needs no more nodes; and Gauss
 * points there may be. */
static const double goal = 0x1p-26, points_most = 4e6;
/* Relative errors of derivatives as they are evaluated, of the sums of absolute values that they are
 * made of: sums over functions alive, their recursions, the quotient, thousands of roundings. */
static const double evaluation = 0x1p-36;
static const double up = 1 + 0x1p-40; /* more than the roundings of a bound */

/* Gauss nodes on the cells of one direction. */
typedef struct axis {
    double *t, *weights; /* over the direction's own range */
    int count;
    double rounding; /* relative, of a function, by that of t */
} axis;

typedef struct work {
    taut_arena *arena;
    const taut_gradient_rule *rule;
    taut_surface *surface, *moves; /* of about unit size; scaled to 1 at most */
    axis u, v;
    double *lines, *changes; /* [LINES][v.count][3][3] */
    double remainder, scale; /* of the rule chosen; of certify/dirichlet/remainder.h */
    int nodes;
} work;

static taut_status fill_axis(const taut_basis *basis, const taut_cells *cells, work *w, axis *a)
{
    const double *breaks = taut_basis_breaks(basis);
    const int nodes = w->nodes;
    const double local = taut_basis_local(basis);
    double node[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX];

    a->count = cells->count * nodes;
    a->t = taut_arena_take(w->arena, (size_t)a->count, sizeof(double));
    a->weights = taut_arena_take(w->arena, (size_t)a->count, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_gauss_rule(nodes, node, weight);
    for (int k = 0; k < a->count; k++) {
        const int cell = k / nodes, span = cells->span[cell];
        const double t = taut_cells_at(cells, cell, node[k % nodes]);
        const double width = cells->hi[cell] - cells->lo[cell];
        a->t[k] = t < breaks[span + 1] ? t : breaks[span];
        a->weights[k] = 0.5 * weight[k % nodes] * width;
        /* Markov's inequality: the slope of a polynomial is local^2 times its size at most */
        a->rounding = fmax(a->rounding, 4 * local * local * TAUT_UNIT_ROUNDOFF * fabs(t) / width);
    }
    return TAUT_OK;
}

/* The fewest nodes that do, or those with the least remainder. 0: no bound is known. */
static taut_status choose_rule(work *w, const taut_remainder_request *in)
{
    const double pairs = (double)w->rule->cells[0]->count * w->rule->cells[1]->count;
    double remainder[TAUT_REMAINDER_RULES];
    const taut_status status = taut_gradient_remainder(in, w->arena, remainder, &w->scale);

    for (int k = 0; k < TAUT_REMAINDER_RULES && status == TAUT_OK; k++) {
        const int nodes = taut_remainder_nodes[k];
        if (isfinite(remainder[k]) && isfinite(w->scale) && pairs * nodes * nodes <= points_most &&
            (w->nodes == 0 || (w->remainder > goal * w->scale && remainder[k] < w->remainder))) {
            w->nodes = nodes;
            w->remainder = remainder[k];
        }
    }
    return status;
}

/* The integrand; the measure of the cell is not in it. */
static double second_of(const double *x, const double *d)
{
    const double *xu = x + 3, *xv = x + 6, *du = d + 3, *dv = d + 6;
    double normal[3], moved[3], twist[3];

    taut_cross(xu, xv, normal);
    taut_cross(du, dv, twist);
    const double along_u = taut_dot(normal, du), along_v = taut_dot(normal, dv);
    const double element = taut_length(normal);
    for (int c = 0; c < 3; c++) {
        moved[c] = (xv[c] * along_u - xu[c] * along_v) / element;
    }
    return (taut_dot(moved, moved) + 2 * taut_dot(normal, twist)) / element;
}

static taut_status integrate(work *w, double *second)
{
    const size_t line = VALUES * (size_t)w->v.count;

    for (int from = 0; from < w->u.count; from += LINES) {
        const int count = w->u.count - from < LINES ? w->u.count - from : LINES;
        taut_status status = taut_surface_eval_grid(w->surface, count, w->u.t + from, w->v.count,
                                                    w->v.t, 1, 1, w->lines);
        if (status == TAUT_OK) {
            status = taut_surface_eval_grid(w->moves, count, w->u.t + from, w->v.count, w->v.t, 1,
                                            1, w->changes);
        }
        if (status != TAUT_OK) {
            return status;
        }
        for (int i = 0; i < count; i++) {
            double sum = 0;
            for (int k = 0; k < w->v.count; k++) {
                const size_t at = line * (size_t)i + VALUES * (size_t)k;
                sum += w->v.weights[k] * second_of(w->lines + at, w->changes + at);
            }
            *second += w->u.weights[from + i] * sum;
        }
        if (taut_crew_beat(w->rule->crew, POINT_WORK * (double)count * w->v.count)) {
            return TAUT_INTERRUPTED;
        }
    }
    return TAUT_OK;
}

/* A net of its own on the bases and weights of the surface. */
static taut_status keep_net(const taut_surface *surface, const double *points, taut_arena *arena,
                            taut_surface **made)
{
    const taut_status status =
        taut_surface_new("", taut_surface_u(surface), taut_surface_v(surface), points,
                         taut_surface_weights(surface), made, NULL);

    if (status != TAUT_OK) {
        return status;
    }
    return taut_keep_surface(arena, *made) ? TAUT_OK : TAUT_NO_MEMORY;
}

static taut_status prepare(work *w, const taut_surface *surface, const double *points,
                           const double *moves)
{
    taut_remainder_request in = {
        .basis = {taut_surface_u(surface), taut_surface_v(surface)},
        .cells = {w->rule->cells[0], w->rule->cells[1]},
        .points = points,
        .weights = taut_surface_weights(surface),
        .is_area = 1,
        .crew = w->rule->crew,
        .moves = moves,
    };
    taut_status status = keep_net(surface, points, w->arena, &w->surface);

    if (status == TAUT_OK) {
        status = keep_net(surface, moves, w->arena, &w->moves);
    }
    if (status == TAUT_OK) {
        status = choose_rule(w, &in);
    }
    if (status != TAUT_OK || w->nodes == 0) {
        return status;
    }
    if (fill_axis(in.basis[0], in.cells[0], w, &w->u) != TAUT_OK ||
        fill_axis(in.basis[1], in.cells[1], w, &w->v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    w->lines = taut_arena_take(w->arena, LINES * VALUES * (size_t)w->v.count, sizeof(double));
    w->changes = taut_arena_take(w->arena, LINES * VALUES * (size_t)w->v.count, sizeof(double));
    return taut_arena_status(w->arena);
}

/* *least: d.H d is no less. */
static taut_status bound_second(work *w, const taut_surface *surface, const double *points,
                                const double *moves, double *least)
{
    double second = 0;
    taut_status status = prepare(w, surface, points, moves);

    *least = -INFINITY;
    if (status != TAUT_OK || w->nodes == 0) {
        return status;
    }
    status = integrate(w, &second);
    const double sums = TAUT_UNIT_ROUNDOFF * 2 * ((double)w->u.count + w->v.count);
    const double relative = evaluation + sums + w->u.rounding + w->v.rounding;
    *least = second - up * (w->remainder + relative * w->scale);
    return status;
}

/* The gain of moves at most 1 along them, from |dA d| <= slope, and 2 A >= area. */
static double gain_of(double slope, double second, double area)
{
    return second > 0 && area > 0 ? up * (slope / second) * (slope / area) : (double)INFINITY;
}

taut_status taut_certify_descent(const taut_surface *surface, const taut_gradient_rule *rule,
                                 const taut_dirichlet_gradient *gradient, double error,
                                 const double *moves, double *gain)
{
    const size_t count = 3 * (size_t)taut_basis_count(taut_surface_u(surface)) *
                         (size_t)taut_basis_count(taut_surface_v(surface));
    const double *p = taut_surface_points(surface);
    taut_arena *arena = taut_arena_new();
    double *points = taut_arena_take(arena, count, sizeof(double));
    const double rounding = TAUT_UNIT_ROUNDOFF * 2 * (double)count;
    double *unit = taut_arena_take(arena, count, sizeof(double));
    double largest = 0, slope = 0, doubt = 0, area = 0, second = -INFINITY;
    work w = {.arena = arena, .rule = rule, .remainder = INFINITY};
    taut_status status = taut_arena_status(arena);

    *gain = INFINITY;
    for (size_t i = 0; i < count && status == TAUT_OK; i++) {
        largest = taut_certify_max(largest, fabs(moves[i]));
    }
    if (status == TAUT_OK && largest > 0 && isfinite(largest)) {
        for (size_t i = 0; i < count; i++) {
            points[i] = ldexp(p[i], -gradient->unit) - ldexp(p[i % 3], -gradient->unit);
            unit[i] = moves[i] / largest;
            slope += unit[i] * gradient->values[i];
            doubt += fabs(unit[i]) * (rounding * fabs(gradient->values[i]) + error);
            area += points[i] * gradient->values[i] -
                    fabs(points[i]) * (rounding * fabs(gradient->values[i]) + error);
        }
        status = bound_second(&w, surface, points, unit, &second);
        *gain = gain_of(fabs(slope) + up * doubt, second, area);
    }
    taut_arena_free(arena);
    return status;
}
