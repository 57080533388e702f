/* low.c -- the patch of bidegree n + 3. Its corner twists are found together with its inner points:
 * from the least slopes of a, b, c, Gauss-Newton steps lower A_2 over both, kept within what leaves
 * weights positive and c away from 0.
 */
#include "construct/asymptotic/low.h"

#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/plate.h"
#include "construct/asymptotic/ribbon.h"
#include "core/fail.h"
#include "core/memory.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <string.h>

enum { STEPS_MAX = 12, HALVINGS_MAX = 5, EXTRA_NODES = 6 };
static const double enough = 1e-6; /* relative fall of A_2 that is worth another step */

typedef struct search {
    taut_low low;
    taut_low_limits limits;
    taut_patch *patch;
    taut_plate_freedom freedoms[TAUT_LOW_FREE];
    taut_plate_options options; /* of the steps: fewer nodes than the last solution */
} search;

/* (C4) for this patch: c must not change sign. */
static taut_status check_regular(const taut_low *l, taut_error *error)
{
    const double zero[TAUT_LOW_FREE] = {0};
    for (int e = 0; e < 4; e++) {
        double abc[3][4], from = 0.0, to = 1.0;
        if (l->quad->edges[e].straight) {
            continue;
        }
        taut_low_cubics(l, e, zero, abc);
        if (abc[2][0] * abc[2][3] > 0) {
            continue;
        }
        for (int step = 0; step < 60; step++) {
            double value = 0.0;
            const double middle = 0.5 * (from + to);
            taut_bernstein_point(3, 1, abc[2], middle, &value, NULL);
            if (value * abc[2][0] > 0) {
                from = middle;
            } else {
                to = middle;
            }
        }
        return taut_fail(error, TAUT_NO_SOLUTION, "singular", "", from, taut_none,
                         "edge %s is singular at parameter %.6f: its normal would have to turn "
                         "over (sigma %+d and %+d at its ends, no inflection between); other legs, "
                         "or \"singular\": \"report\", build it",
                         taut_asymptotic_edge_name(e), from, taut_quad_sigma(l->quad, e, 0),
                         taut_quad_sigma(l->quad, e, 1));
    }
    return TAUT_OK;
}

static taut_status check_inflections(const taut_quad *quad, taut_error *error)
{
    for (int e = 0; e < 4; e++) {
        taut_ribbon ribbon;
        taut_ribbon_fill(quad, e, &ribbon);
        if (ribbon.inflections > 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "inflection", "", ribbon.inflection[0],
                             taut_none,
                             "edge %s has an inflection at parameter %.6f, where the patch of "
                             "degree n+3 would be singular: take surface \"5n-7\"",
                             taut_asymptotic_edge_name(e), ribbon.inflection[0]);
        }
    }
    return TAUT_OK;
}

/* A_2 of the patch at x, its inner points solved. */
static taut_status energy_at(search *s, const double *x, double *energy, taut_error *error)
{
    taut_low_write(&s->low, x, s->patch);
    return taut_plate_solve(s->patch, 0, NULL, NULL, &s->options, energy, error);
}

/* Each number of x moves the rows beside the two edges of its corner; affine, so the same at every
 * x. */
static void fill_freedoms(search *s)
{
    const double zero[TAUT_LOW_FREE] = {0};
    const int m = s->patch->m;
    for (int j = 0; j < TAUT_LOW_FREE; j++) {
        taut_plate_freedom *const freedom = &s->freedoms[j];
        double unit[TAUT_LOW_FREE] = {0};
        unit[j] = 1.0;
        memset(freedom, 0, sizeof *freedom);
        freedom->parts = 2;
        for (int i = 0; i < 2; i++) {
            const int e = taut_quad_corner[j / 3][i].edge;
            const double sign = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0 ? 1.0 : -1.0;
            double with[TAUT_LOW_LENGTH][4], without[TAUT_LOW_LENGTH][4];
            taut_low_cross(&s->low, e, unit, with);
            taut_low_cross(&s->low, e, zero, without);
            freedom->part[i].edge = e;
            for (int k = 1; k < m; k++) {
                const double share = k == 1 || k == m - 1 ? 0.5 : 1.0;
                for (int d = 0; d < 4; d++) {
                    freedom->part[i].row[k][d] = share * sign / m * (with[k][d] - without[k][d]);
                }
            }
        }
    }
}

/* One step from x towards the least of the quadratic model within the limits; *x and *energy
 * change only if A_2 falls. */
static taut_status take_step(search *s, double *x, double *energy, taut_error *error)
{
    double factors[TAUT_LOW_FREE], target[TAUT_LOW_FREE], next[TAUT_LOW_FREE], value = 0.0;
    double r[TAUT_LOW_FREE * TAUT_LOW_FREE], length = 1.0;
    taut_status status =
        taut_plate_step(s->patch, TAUT_LOW_FREE, s->freedoms, factors, r, &s->options, error);
    for (int j = 0; j < TAUT_LOW_FREE; j++) {
        target[j] = x[j] + factors[j];
    }
    if (status != TAUT_OK || !taut_low_nearest(&s->limits, r, target, next)) {
        return status;
    }
    for (int halving = 0; halving < HALVINGS_MAX && status == TAUT_OK; halving++) {
        for (int j = 0; j < TAUT_LOW_FREE; j++) {
            target[j] = x[j] + length * (next[j] - x[j]); /* the limits are convex */
        }
        status = energy_at(s, target, &value, error);
        if (status == TAUT_OK && value < *energy) {
            memcpy(x, target, sizeof target);
            *energy = value;
            return TAUT_OK;
        }
        length *= 0.5;
    }
    return status;
}

static taut_status lower_energy(search *s, double *x, taut_error *error)
{
    double energy = 0.0, before = INFINITY;
    taut_status status = energy_at(s, x, &energy, error);
    for (int k = 0; k < STEPS_MAX && status == TAUT_OK; k++) {
        before = energy;
        status = take_step(s, x, &energy, error);
        if (!(energy < (1.0 - enough) * before)) {
            break;
        }
    }
    return status;
}

static taut_status find_patch(search *s, int report_singular, double *energy, taut_error *error)
{
    const double zero[TAUT_LOW_FREE] = {0};
    const taut_plate_options last = {0, s->options.monitor};
    double x[TAUT_LOW_FREE];
    taut_status status = report_singular ? TAUT_OK : check_regular(&s->low, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_patch_boundary(s->low.quad, s->patch);
    taut_low_limit(&s->low, s->patch, &s->limits);
    if (!taut_low_nearest(&s->limits, NULL, zero, x)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "negative-weight", "", taut_none, taut_none,
                         "no corner twists keep the weights of the patch of degree n+3 positive "
                         "and its boundary regular: take surface \"5n-7\"");
    }
    fill_freedoms(s);
    status = lower_energy(s, x, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_low_write(&s->low, x, s->patch);
    return taut_plate_solve(s->patch, 0, NULL, NULL, &last, energy, error);
}

taut_status taut_low_fill(const taut_quad *quad, int report_singular, const taut_monitor *monitor,
                          taut_patch *patch, double *energy, taut_error *error)
{
    search *s = NULL;
    taut_low low;
    taut_status status = check_inflections(quad, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_low_corners(quad, &low, error);
    if (status != TAUT_OK) {
        return status;
    }
    s = taut_alloc_zero(1, sizeof *s);
    if (s == NULL) {
        return taut_fail_memory(error);
    }
    s->low = low;
    s->patch = patch;
    s->options.nodes = patch->m + EXTRA_NODES;
    s->options.monitor = monitor;
    status = find_patch(s, report_singular, energy, error);
    taut_free(s);
    return status;
}
