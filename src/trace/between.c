/* between.c
 *
 *     a polygon of the window, from one side to 64, each time shortened in space
 *     Newton on the angle at the start and the length: with the Jacobi field
 *
 *         j'' + K j = 0,  j(0) = 0,  j'(0) = 1        d end = T dl + j S dangle
 *
 * ([doCarmo1976] 5-5). Where j vanishes on the way, neighbours meet the curve again: it is a geodesic,
 * and not the shortest way.
 */
#include "trace/between.h"

#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <string.h>

enum { LEVELS = 6, POINTS = 64, ROUNDS = 20, NEWTON = 40, PARTS = 4 /* of a step, for j */ };
/* How near to the place the end has to come, over the size. */
static const double near_enough = 1e-15, still_near = 1e-11;
/* Newton's largest step in the angle. */
static const double largest_turn = 0.5;

static void space_at(const taut_carrier *carrier, const double at[2], int order,
                     double x[TAUT_CARRIER_VECTORS][3])
{
    int span[2];
    taut_carrier_cell(carrier, at, NULL, span);
    taut_carrier_at(carrier, span, at, order, x);
}

/* A point of the polygon to where the squares of both its sides are least. */
static void relax(const taut_carrier *carrier, const double before[2], double at[2],
                  const double after[2])
{
    double x[TAUT_CARRIER_VECTORS][3], a[TAUT_CARRIER_VECTORS][3], b[TAUT_CARRIER_VECTORS][3];
    double rest[3];

    space_at(carrier, at, 1, x);
    space_at(carrier, before, 0, a);
    space_at(carrier, after, 0, b);
    for (int c = 0; c < 3; c++) {
        rest[c] = (a[0][c] + b[0][c]) / 2 - x[0][c];
    }
    const double e = taut_dot(x[1], x[1]), f = taut_dot(x[1], x[2]), g = taut_dot(x[2], x[2]);
    const double p = taut_dot(x[1], rest), q = taut_dot(x[2], rest), area = e * g - f * f;
    if (area > 0) {
        const double moved[2] = {at[0] + (g * p - f * q) / area, at[1] + (e * q - f * p) / area};
        for (int d = 0; d < 2; d++) {
            at[d] = fmin(fmax(moved[d], carrier->lo[d]), carrier->hi[d]);
        }
    }
}

/* The polygon's first side and its length: where Newton starts. */
static void guess(const taut_carrier *carrier, const double from[2], const double to[2],
                  double along[3], double *length)
{
    double at[POINTS + 1][2] = {{from[0], from[1]}}, x[2][TAUT_CARRIER_VECTORS][3];

    memcpy(at[POINTS], to, sizeof at[POINTS]);
    for (int level = 0; level < LEVELS; level++) {
        const int step = POINTS >> (level + 1);
        for (int k = step; k < POINTS; k += 2 * step) {
            for (int d = 0; d < 2; d++) {
                at[k][d] = (at[k - step][d] + at[k + step][d]) / 2;
            }
        }
        for (int round = 0; round < ROUNDS; round++) {
            for (int k = step; k < POINTS; k += step) {
                relax(carrier, at[k - step], at[k], at[k + step]);
            }
        }
    }
    *length = 0;
    space_at(carrier, at[0], 0, x[0]);
    for (int k = 1; k <= POINTS; k++) {
        space_at(carrier, at[k], 0, x[k % 2]);
        const double side = taut_length_between(x[0][0], x[1][0]);
        if (k == 1) {
            taut_difference(x[1][0], x[0][0], along);
        }
        *length += side;
    }
}

/* K between two stations of a step. */
static double gauss_at(const taut_piece *piece, double t)
{
    const taut_carrier *carrier = piece->start.on;
    const double h = piece->h, r = 1 - t;
    double at[2], x[TAUT_CARRIER_VECTORS][3];
    taut_form_pair forms;
    for (int d = 0; d < 2; d++) {
        at[d] = r * r * (1 + 2 * t) * piece->from.at[d] + r * r * t * h * piece->from.ab[d] +
                t * t * (1 + 2 * r) * piece->to.at[d] - t * t * r * h * piece->to.ab[d];
    }
    taut_carrier_at(carrier, piece->start.span, at, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    return forms.w > 0 ? taut_form_pair_gauss(&forms) : 0;
}

/* j at the end of the walk; *positive: it did not vanish on the way. */
static double jacobi(const taut_walk *walk, int *positive)
{
    double j = 0, slope = 1;
    *positive = 1;
    for (int k = 0; k < walk->count; k++) {
        const taut_piece *piece = &walk->pieces[k];
        const double h = piece->h / PARTS;
        for (int part = 0; part < PARTS; part++) {
            const double k0 = gauss_at(piece, (double)part / PARTS);
            const double k1 = gauss_at(piece, (part + 0.5) / PARTS);
            const double k2 = gauss_at(piece, (part + 1.0) / PARTS);
            const double a1 = -k0 * j, s2 = slope + h / 2 * a1, a2 = -k1 * (j + h / 2 * slope);
            const double s3 = slope + h / 2 * a2, a3 = -k1 * (j + h / 2 * s2);
            const double s4 = slope + h * a3, a4 = -k2 * (j + h * s3);
            j += h / 6 * (slope + 2 * s2 + 2 * s3 + s4);
            slope += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            *positive &= j > 0 || (k == walk->count - 1 && part == PARTS - 1);
        }
    }
    return j;
}

/* One walk of that length: how far its end is from the place, and the steps to mend that. A walk that
 * leaves the window goes straight on. 0 where there is none. */
static taut_status shoot(const taut_carrier *carrier, const double from[2], const double goal[3],
                         const taut_follow_options *options, taut_arena *arena,
                         const taut_between *now, double *away, double step[2], int *positive,
                         int *is_walk)
{
    static const taut_linefield_kind kind = {TAUT_TRACE_GEODESIC, 0};
    taut_follow_options own = *options;
    taut_walk_state state;
    taut_walk *walk = taut_arena_take(arena, 1, sizeof *walk);
    double way[2], rest[3], sideways[3];
    int span[2];

    *is_walk = 0;
    if (walk == NULL) {
        return TAUT_NO_MEMORY;
    }
    own.max_length = now->length;
    taut_carrier_cell(carrier, from, NULL, span);
    if (taut_walk_start(carrier, kind, from, span, now->along, &state) != TAUT_LINEFIELD_FINE) {
        return TAUT_OK;
    }
    memcpy(way, state.y + TAUT_WALK_A, sizeof way);
    taut_carrier_cell(carrier, from, way, span);
    if (taut_walk_start(carrier, kind, from, span, now->along, &state) != TAUT_LINEFIELD_FINE) {
        return TAUT_OK;
    }
    const taut_status status = taut_follow(kind, &state, &own, arena, walk);
    if (status != TAUT_OK || walk->count == 0) {
        return status;
    }
    const taut_station *end = &walk->pieces[walk->count - 1].to;
    taut_difference(goal, end->x, rest);
    taut_add_scaled(end->s - now->length, end->tangent, rest);
    taut_cross(end->normal, end->tangent, sideways);
    const double j = jacobi(walk, positive);
    *away = taut_length(rest);
    step[0] = taut_dot(rest, end->tangent);
    step[1] = taut_dot(rest, sideways) / (j != 0 ? j : now->length);
    *is_walk =
        walk->end == TAUT_END_LENGTH || walk->end == TAUT_END_EDGE || walk->end == TAUT_END_CORNER;
    return TAUT_OK;
}

/* Turns the start about the normal. */
static void turn(const taut_carrier *carrier, const double from[2], double angle, double along[3])
{
    double x[TAUT_CARRIER_VECTORS][3], sideways[3], turned[3];
    taut_form_pair forms;

    taut_carrier_forms_at(carrier, from, x, &forms);
    taut_add_scaled(-taut_dot(along, forms.normal), forms.normal, along);
    taut_cross(forms.normal, along, sideways);
    const double length = taut_length(along);
    for (int c = 0; c < 3; c++) {
        turned[c] = (taut_cos(angle) * along[c] + taut_sin(angle) * sideways[c]) / length;
    }
    memcpy(along, turned, sizeof turned);
}

taut_status taut_geodesic_between(const taut_carrier *carrier, const double from[2],
                                  const double to[2], const taut_follow_options *options,
                                  taut_arena *arena, taut_between *found)
{
    double x[TAUT_CARRIER_VECTORS][3];
    taut_between best;
    double nearest = INFINITY;

    *found = (taut_between){.is_shortest = 1};
    guess(carrier, from, to, found->along, &found->length);
    if (!(taut_length(found->along) > 0)) {
        return TAUT_OK;
    }
    turn(carrier, from, 0, found->along);
    space_at(carrier, to, 0, x);
    best = *found;
    for (int round = 0; round < NEWTON; round++) {
        double away = 0, step[2];
        int is_walk = 0;
        const taut_status status = shoot(carrier, from, x[0], options, arena, found, &away, step,
                                         &found->is_shortest, &is_walk);
        if (status != TAUT_OK) {
            return status;
        }
        if (!is_walk || !isfinite(step[1])) {
            break;
        }
        if (away < nearest) {
            nearest = away;
            best = *found;
        } else if (nearest <= still_near * carrier->size) {
            break; /* rounding */
        }
        if (away <= near_enough * carrier->size) {
            break;
        }
        turn(carrier, from, fmin(fmax(step[1], -largest_turn), largest_turn), found->along);
        found->length = fmin(fmax(found->length + step[0], found->length / 2), 2 * found->length);
    }
    *found = best;
    found->is_found = nearest <= still_near * carrier->size;
    return TAUT_OK;
}
