/* match.c -- which point of one edge belongs to which of the other. */
#include "measure/join/side.h"

#include "core/vec3.h"
#include "geometry/exponent.h"

#include <math.h>
#include <string.h>

enum {
    PLACE_WORK = 15,
    JET_WORK = 60
}; /* operations of a point alive at a place, of order 0; else */

/* Operations, as pulses count them. */
static double work_of_spot(const taut_join_side *side, int order)
{
    return (double)taut_basis_local(side->along) * taut_basis_local(side->across) *
           (order == 0 ? PLACE_WORK : JET_WORK);
}

void taut_join_spot(const taut_join_side *side, int span, double t, int order, taut_spot *spot)
{
    const int last = taut_basis_span_count(side->across) - 1, held = side->held;
    const int high = (int)side->edge % 2 == 1;
    const double at = high ? taut_basis_hi(side->across) : taut_basis_lo(side->across);
    int spans[2], shift[2];
    double parameters[2];
    taut_spot raw;

    if (taut_pulse_beat(side->pulse, work_of_spot(side, order))) {
        memset(spot, 0, sizeof *spot);
        return;
    }
    spans[held] = high ? last : 0;
    spans[1 - held] = span;
    parameters[held] = at;
    parameters[1 - held] = t;
    shift[held] = side->shift_across;
    shift[1 - held] = taut_range_exponent(side->along);
    taut_spot_at(side->surface, spans[0], spans[1], parameters[0], parameters[1], order,
                 side->scale, shift, &raw);
    for (int k = 0; k < TAUT_JET; k++) {
        const int i = taut_jet_power[k][0], j = taut_jet_power[k][1]; /* along, across */
        const int from = held == 1 ? k : taut_jet_index(j, i);
        const double sign =
            (i % 2 == 1 ? side->sign_along : 1) * (j % 2 == 1 ? side->sign_across : 1);
        spot->bound[k] = raw.bound[from];
        for (int c = 0; c < 3; c++) {
            spot->x[c].c[k] = sign * raw.x[c].c[from];
        }
    }
}

double taut_join_parameter(const taut_join_side *side, double part)
{
    const double lo = taut_basis_lo(side->along), hi = taut_basis_hi(side->along);
    const double p = side->sign_along > 0 ? part : 1 - part;
    return p <= 0 ? lo : p >= 1 ? hi : fmin(hi, lo + p * (hi - lo));
}

void taut_join_position(const taut_join_side *side, double t, double *x)
{
    taut_spot spot;
    taut_join_spot(side, taut_basis_span(side->along, t), t, 0, &spot);
    for (int c = 0; c < 3; c++) {
        x[c] = spot.x[c].c[0];
    }
}

double taut_join_affine_gap(const taut_join_side *a, const taut_join_side *b, int samples)
{
    double gap = 0;
    for (int i = 0; i <= samples; i++) {
        double x[3], y[3];
        taut_join_position(a, taut_join_parameter(a, (double)i / samples), x);
        taut_join_position(b, taut_join_parameter(b, (double)i / samples), y);
        gap = fmax(gap, taut_distance(x, y));
    }
    return gap;
}

/* The point of the side nearest to x, sought near the parameter *t and within `reach` of it, by
 * golden section on the distance; returns it. */
static double find_nearest(const taut_join_side *side, const double *x, double reach, double *t)
{
    const double golden = 0.6180339887498949;
    double lo = fmax(taut_basis_lo(side->along), *t - reach);
    double hi = fmin(taut_basis_hi(side->along), *t + reach);
    double y[3], best = 0;

    for (int i = 0; i < 60; i++) {
        const double p = hi - golden * (hi - lo), q = lo + golden * (hi - lo);
        double yp[3], yq[3];
        taut_join_position(side, p, yp);
        taut_join_position(side, q, yq);
        if (taut_distance(x, yp) <= taut_distance(x, yq)) {
            hi = q;
        } else {
            lo = p;
        }
    }
    *t = lo + (hi - lo) / 2;
    taut_join_position(side, *t, y);
    best = taut_distance(x, y);
    return best;
}

double taut_join_foot(const taut_join_side *side, const double *x, double part, int samples,
                      double *t)
{
    const double range = taut_basis_hi(side->along) - taut_basis_lo(side->along);
    double y[3], best = INFINITY;
    int at = 0;

    if (part == 0 || part == 1) {
        *t = taut_join_parameter(side, part);
        taut_join_position(side, *t, y);
        return taut_distance(x, y);
    }
    for (int i = 0; i <= samples; i++) {
        taut_join_position(side, taut_join_parameter(side, (double)i / samples), y);
        if (taut_distance(x, y) < best) {
            best = taut_distance(x, y);
            at = i;
        }
    }
    *t = taut_join_parameter(side, (double)at / samples);
    return find_nearest(side, x, range / samples, t);
}
