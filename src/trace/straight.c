#include "trace/straight.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <string.h>

enum { LOOK = 13, NODES = TAUT_CARRIER_RULE, ROUNDS = 12 };
/* The sine between two directions of the window, its sides made 1, that is rounding; a component below
 * the second is 0. -K over R^2 below which it may vanish near by. */
static const double same_way = 1e-12, no_component = 1e-14, least_gauss = 1e-3;
/* Over the whole: a step of Newton whose square is rounding. */
static const double last_step = 1e-9;

/* The direction of a family at a place, its sides made 1; 0 where there is none. */
static int way_at(const taut_carrier *carrier, taut_linefield_kind kind, const double at[2],
                  double way[2])
{
    double x[TAUT_CARRIER_VECTORS][3];
    taut_form_pair forms;

    taut_carrier_forms_at(carrier, at, x, &forms);
    if (taut_linefield_direction(carrier, kind, &forms, way) != TAUT_LINEFIELD_FINE) {
        return 0;
    }
    const double square = forms.m * forms.m - forms.l * forms.n, area = forms.w * forms.w;
    const double radius = taut_form_pair_radius(&forms);
    for (int d = 0; d < 2; d++) {
        way[d] /= carrier->hi[d] - carrier->lo[d];
    }
    const double length = taut_hypot(way[0], way[1]);
    way[0] /= length;
    way[1] /= length;
    return radius > 1e-3 * carrier->roundest &&
           (kind.net != TAUT_TRACE_ASYMPTOTIC || square > least_gauss * radius * radius * area);
}

static int find_way(const taut_carrier *carrier, taut_linefield_kind kind, double way[2])
{
    const double middle[2] = {carrier->lo[0] + (carrier->hi[0] - carrier->lo[0]) / 2,
                              carrier->lo[1] + (carrier->hi[1] - carrier->lo[1]) / 2};
    double there[2];

    if (!way_at(carrier, kind, middle, way)) {
        return 0;
    }
    for (int i = 0; i < LOOK; i++) {
        for (int j = 0; j < LOOK; j++) {
            const double at[2] = {
                carrier->lo[0] + (carrier->hi[0] - carrier->lo[0]) * i / (LOOK - 1),
                carrier->lo[1] + (carrier->hi[1] - carrier->lo[1]) * j / (LOOK - 1)};
            if (!way_at(carrier, kind, at, there) ||
                !(fabs(way[0] * there[1] - way[1] * there[0]) <= same_way)) {
                return 0;
            }
        }
    }
    for (int d = 0; d < 2; d++) {
        way[d] = fabs(way[d]) <= no_component ? 0 : way[d] * (carrier->hi[d] - carrier->lo[d]);
    }
    const double length = taut_hypot(way[0], way[1]);
    way[0] /= length;
    way[1] /= length;
    return 1;
}

void taut_straight_find(taut_carrier *carrier)
{
    static const taut_trace_net nets[] = {TAUT_TRACE_ASYMPTOTIC, TAUT_TRACE_PRINCIPAL};
    taut_gauss_rule(NODES, carrier->rule[0], carrier->rule[1]);
    for (int k = 0; k < 2; k++) {
        for (int family = 0; family < 2 && !carrier->wraps[0] && !carrier->wraps[1]; family++) {
            const taut_linefield_kind kind = {nets[k], family};
            carrier->is_straight[k][family] = find_way(carrier, kind, carrier->way[k][family]);
        }
    }
}

const double *taut_straight_way(const taut_carrier *carrier, taut_linefield_kind kind)
{
    const int net = kind.net == TAUT_TRACE_ASYMPTOTIC  ? 0
                    : kind.net == TAUT_TRACE_PRINCIPAL ? 1
                                                       : -1;
    return net >= 0 && carrier->is_straight[net][kind.family] ? carrier->way[net][kind.family]
                                                              : NULL;
}

/* Per length of the line: of the curve, of its twist, of the measure. */
static void rates_at(const taut_carrier *carrier, taut_linefield_kind kind, const int span[2],
                     const double at[2], const double *way, double rates[3])
{
    double x[TAUT_CARRIER_VECTORS][3], along[3];
    taut_form_pair forms;

    taut_carrier_at(carrier, span, at, 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    rates[0] = taut_length(along);
    const double ab[2] = {way[0] / rates[0], way[1] / rates[0]};
    rates[1] = fabs(taut_linefield_torsion(&forms, ab)) * rates[0];
    rates[2] = taut_linefield_measure(kind.net, &forms) * rates[0];
}

/* The integrals of the rates over the line from a state on; t may be negative. */
static void integrate(const taut_carrier *carrier, taut_linefield_kind kind,
                      const taut_walk_state *from, const double *way, double t, double sums[3])
{
    const double *nodes = carrier->rule[0], *weights = carrier->rule[1];
    sums[0] = sums[1] = sums[2] = 0;
    for (int k = 0; k < NODES; k++) {
        const double here = t * (1 + nodes[k]) / 2;
        const double at[2] = {from->y[0] + here * way[0], from->y[1] + here * way[1]};
        double rates[3];
        rates_at(carrier, kind, from->span, at, way, rates);
        for (int i = 0; i < 3; i++) {
            sums[i] += weights[k] / 2 * fabs(t) * rates[i];
        }
    }
}

/* +1 where the state goes along the line's direction. */
static double sign_of(const taut_carrier *carrier, const taut_walk_state *from, const double *way)
{
    double x[TAUT_CARRIER_VECTORS][3], along[3];
    taut_carrier_at(carrier, from->span, from->y, 1, x);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    return taut_dot(along, from->tangent) < 0 ? -1 : 1;
}

void taut_straight_move(const taut_carrier *carrier, taut_linefield_kind kind,
                        const taut_walk_state *from, double t, taut_walk_state *to)
{
    const double *way = taut_straight_way(carrier, kind);
    const double sign = sign_of(carrier, from, way);
    double sums[3], x[TAUT_CARRIER_VECTORS][3], along[3];

    integrate(carrier, kind, from, way, t, sums);
    *to = *from;
    to->y[TAUT_WALK_U] += t * way[0];
    to->y[TAUT_WALK_V] += t * way[1];
    const double forth = t * sign < 0 ? -1 : 1;
    to->s += forth * sums[0];
    to->y[TAUT_WALK_TWIST] += forth * sums[1];
    to->y[TAUT_WALK_MEASURE] += forth * sums[2];
    taut_carrier_at(carrier, from->span, to->y, 1, x);
    taut_linefield_tangent((const double(*)[3])x, way, along);
    const double length = taut_length(along);
    for (int c = 0; c < 3; c++) {
        to->tangent[c] = sign * along[c] / length;
    }
}

double taut_straight_reach(const taut_carrier *carrier, taut_linefield_kind kind,
                           const taut_walk_state *from, double h)
{
    const double *way = taut_straight_way(carrier, kind);
    const double sign = sign_of(carrier, from, way);
    double rates[3], sums[3];

    rates_at(carrier, kind, from->span, from->y, way, rates);
    double t = h / rates[0];
    for (int round = 0; round < ROUNDS; round++) {
        const double signed_t = sign * t;
        const double at[2] = {from->y[0] + signed_t * way[0], from->y[1] + signed_t * way[1]};
        integrate(carrier, kind, from, way, signed_t, sums);
        rates_at(carrier, kind, from->span, at, way, rates);
        const double step = ((t < 0 ? -sums[0] : sums[0]) - h) / rates[0];
        t -= step;
        if (fabs(step) <= last_step * fabs(t)) {
            break;
        }
    }
    return sign * t;
}

void taut_straight_station(const double *way, const double x[TAUT_CARRIER_VECTORS][3],
                           taut_station *at)
{
    double along[3], second[3];
    taut_linefield_tangent(x, way, along);
    const double speed = taut_length(along), sign = taut_dot(along, at->tangent) < 0 ? -1 : 1;
    for (int c = 0; c < 3; c++) {
        second[c] =
            way[0] * way[0] * x[3][c] + 2 * way[0] * way[1] * x[4][c] + way[1] * way[1] * x[5][c];
    }
    /* t' = 1/speed, t'' = -speed'/speed^3, speed' = along . second / speed */
    const double bend = -taut_dot(along, second) / (speed * speed * speed * speed);
    for (int d = 0; d < 2; d++) {
        at->ab[d] = sign * way[d] / speed;
        at->bend[d] = bend * way[d];
    }
}
