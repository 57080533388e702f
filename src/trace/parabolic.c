#include "trace/parabolic.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"

#include <string.h>

enum { STAGES = 8, UNKNOWNS = 5 /* u, v, s, twist, measure */, ROUNDS = 80 };

/* When to begin: D / W over R, and how far K = 0 may be at this rate, over the size. */
static const double near_enough = 0.2, far_enough = 0.3;
/* D falls by this factor from level to level, and how near two runs have to end, over the size. */
static const double fall = 0.85, agreement = 1e-11, settled = 1e-16;
/* A change of the stages, over the size, that is no more than the rounding of a quotient 0 / 0. */
static const double rounding = 1e-11;
/* How far beyond a break, over its span, the curve may end. */
static const double on_knot = 1e-9;
/* The angle to the line K = 0 below which it is an envelope. */
static const double touching = 1e-4;

/* A rule on [0, 1]: nodes, weights, and the integrals of the Lagrange polynomials to each node. */
typedef struct collocation {
    double node[STAGES], weight[STAGES], inner[STAGES][STAGES];
} collocation;

static double lagrange(const double node[STAGES], int j, double t)
{
    double product = 1;
    for (int k = 0; k < STAGES; k++) {
        if (k != j) {
            product *= (t - node[k]) / (node[j] - node[k]);
        }
    }
    return product;
}

static void make_rule(collocation *rule)
{
    double node[STAGES], weight[STAGES];
    taut_gauss_rule(STAGES, node, weight);
    for (int i = 0; i < STAGES; i++) {
        rule->node[i] = (1 + node[i]) / 2;
        rule->weight[i] = weight[i] / 2;
    }
    for (int i = 0; i < STAGES; i++) {
        for (int j = 0; j < STAGES; j++) {
            rule->inner[i][j] = 0;
            for (int k = 0; k < STAGES; k++) {
                rule->inner[i][j] += rule->node[i] * rule->weight[k] *
                                     lagrange(rule->node, j, rule->node[i] * rule->node[k]);
            }
        }
    }
}

typedef struct work {
    const taut_carrier *carrier;
    int family;
    const int *span;
    const double *tangent;
} work;

/* In the cell, or as near to it as rounding leaves a curve whose end, K = 0, lies on a knot. */
static int is_inside(const work *w, const double at[2])
{
    for (int d = 0; d < 2; d++) {
        const double *breaks = taut_basis_breaks(w->carrier->basis[d]) + w->span[d];
        const double room = on_knot * (breaks[1] - breaks[0]);
        if (!(at[d] >= breaks[0] - room) || !(at[d] <= breaks[1] + room)) {
            return 0;
        }
    }
    return 1;
}

/* g_u and g_v. */
static void slope_of_g(const taut_form_pair *q, const double slopes[6][2], double g[2])
{
    for (int d = 0; d < 2; d++) {
        g[d] = 2 * q->m * slopes[4][d] - slopes[3][d] * q->n - q->l * slopes[5][d];
    }
}

/* d(u, v, s, twist, measure)/dD at D = d; 0 where there is none. A place that is not yet the curve's
 * may lie beyond K = 0, where g rises: *is_true is 0 then, and g' that of `usual` d, which brings it
 * back. */
static int slope_at(const work *w, const double y[UNKNOWNS], double d, double usual,
                    double out[UNKNOWNS], int *is_true)
{
    double x[TAUT_CARRIER_VECTORS][3], slopes[6][2], g[2], ab[2], tangent[3];
    taut_form_pair q;

    taut_carrier_at(w->carrier, w->span, y, 3, x);
    taut_carrier_forms((const double(*)[3])x, &q);
    if (!(q.w > 0)) {
        return 0;
    }
    taut_linefield_asymptotic(&q, w->family, d, ab);
    taut_linefield_tangent((const double(*)[3])x, ab, tangent);
    if (taut_dot(tangent, w->tangent) < 0) {
        ab[0] = -ab[0];
        ab[1] = -ab[1];
    }
    taut_carrier_slopes((const double(*)[3])x, &q, slopes);
    slope_of_g(&q, (const double(*)[2])slopes, g);
    double rate = g[0] * ab[0] + g[1] * ab[1];
    *is_true = rate < 0;
    rate = *is_true ? rate : usual * d;
    const double ds = 2 * d / rate;
    out[0] = ab[0] * ds;
    out[1] = ab[1] * ds;
    out[2] = ds;
    out[3] = d / q.w * ds;
    out[4] = sqrt(d / q.w) * ds;
    return isfinite(out[0]) && isfinite(out[1]);
}

/* From D = from to D = to in one piece: y is moved; 0 where it fails. */
static int advance(const work *w, const collocation *rule, double from, double to,
                   double y[UNKNOWNS])
{
    double slopes[STAGES][UNKNOWNS], stages[STAGES][UNKNOWNS];
    const double step = to - from, noise = rounding * w->carrier->size;
    double before = INFINITY, first[UNKNOWNS];
    int begins_true = 0;

    if (!slope_at(w, y, from, 0, first, &begins_true) || !begins_true) {
        return 0;
    }
    const double usual = 2 / first[2]; /* ds/dD = 2 D / g' */
    for (int i = 0; i < STAGES; i++) {
        memcpy(stages[i], y, sizeof stages[i]);
    }
    for (int round = 0, is_settled = 0; !is_settled; round++) {
        double change = 0;
        int all_true = 1;
        for (int i = 0; i < STAGES; i++) {
            int is_true = 0;
            if (!slope_at(w, stages[i], from + step * rule->node[i], usual, slopes[i], &is_true)) {
                return 0;
            }
            all_true &= is_true;
        }
        for (int i = 0; i < STAGES; i++) {
            for (int k = 0; k < UNKNOWNS; k++) {
                double sum = 0;
                for (int j = 0; j < STAGES; j++) {
                    sum += rule->inner[i][j] * slopes[j][k];
                }
                const double next = y[k] + step * sum;
                change = k < 3 ? fmax(change, fabs(next - stages[i][k])) : change;
                stages[i][k] = next;
            }
        }
        is_settled = all_true && (change <= settled || (change >= before / 2 && change <= noise));
        before = change;
        if (round == ROUNDS) {
            return 0;
        }
    }
    for (int k = 0; k < UNKNOWNS; k++) {
        double sum = 0;
        for (int j = 0; j < STAGES; j++) {
            sum += rule->weight[j] * slopes[j][k];
        }
        y[k] += step * sum;
    }
    return is_inside(w, y);
}

/* Is K = 0 so near, and the way down to it? *d: D there. */
static int begins(const work *w, const taut_walk_state *state, double *d)
{
    double x[TAUT_CARRIER_VECTORS][3], slopes[6][2], g[2], ab[2], tangent[3];
    taut_form_pair q;

    taut_carrier_at(w->carrier, w->span, state->y, 3, x);
    taut_carrier_forms((const double(*)[3])x, &q);
    const double square = q.m * q.m - q.l * q.n;
    if (!(square > 0) || !(sqrt(square) / q.w < near_enough * taut_form_pair_radius(&q))) {
        return 0;
    }
    *d = sqrt(square);
    taut_linefield_asymptotic(&q, w->family, *d, ab);
    taut_linefield_tangent((const double(*)[3])x, ab, tangent);
    taut_carrier_slopes((const double(*)[3])x, &q, slopes);
    slope_of_g(&q, (const double(*)[2])slopes, g);
    const double sign = taut_dot(tangent, state->tangent) < 0 ? -1 : 1;
    const double rate = sign * (g[0] * ab[0] + g[1] * ab[1]);
    return rate < 0 && -2 * square / rate < far_enough * w->carrier->size;
}

/* The tangent at a place where D is d, going on as before. */
static void set_tangent(const work *w, double d, taut_walk_state *state)
{
    double x[TAUT_CARRIER_VECTORS][3], ab[2], tangent[3];
    taut_form_pair q;

    taut_carrier_at(w->carrier, w->span, state->y, 2, x);
    taut_carrier_forms((const double(*)[3])x, &q);
    taut_linefield_asymptotic(&q, w->family, d, ab);
    taut_linefield_tangent((const double(*)[3])x, ab, tangent);
    const double sign = taut_dot(tangent, w->tangent) < 0 ? -1 : 1;
    for (int c = 0; c < 3; c++) {
        state->tangent[c] = sign * tangent[c];
    }
}

/* Does the curve touch the line g = 0 where it ends? */
static int is_touching(const work *w, const taut_walk_state *end)
{
    double x[TAUT_CARRIER_VECTORS][3], slopes[6][2], g[2], line[3], across[3];
    taut_form_pair q;

    taut_carrier_at(w->carrier, w->span, end->y, 3, x);
    taut_carrier_forms((const double(*)[3])x, &q);
    taut_carrier_slopes((const double(*)[3])x, &q, slopes);
    slope_of_g(&q, (const double(*)[2])slopes, g);
    const double along[2] = {-g[1], g[0]};
    taut_linefield_tangent((const double(*)[3])x, along, line);
    taut_cross(line, end->tangent, across);
    return taut_length(across) < touching * taut_length(line);
}

/* Down to D = 0 over `count` levels: equal ones, or with `fall` from one to the next, where what is
 * passed at an even speed is no longer the length but its root. */
static int run(const work *w, const collocation *rule, const taut_walk_state *state, double d,
               int count, int is_even, taut_parabolic *found)
{
    double y[UNKNOWNS] = {state->y[TAUT_WALK_U], state->y[TAUT_WALK_V], state->s,
                          state->y[TAUT_WALK_TWIST], state->y[TAUT_WALK_MEASURE]};
    double from = d;

    found->count = 0;
    for (int k = 1; k <= count; k++) {
        const double to = k == count ? 0 : is_even ? d * (count - k) / count : from * fall;
        taut_walk_state *at = &found->states[found->count];
        if (!advance(w, rule, from, to, y)) {
            found->count = 0;
            return 0;
        }
        *at = *state;
        for (int c = 0; c < 2; c++) {
            at->y[c] = fmin(fmax(y[c], w->carrier->lo[c]), w->carrier->hi[c]);
        }
        at->s = y[2];
        at->y[TAUT_WALK_TWIST] = y[3];
        at->y[TAUT_WALK_MEASURE] = y[4];
        set_tangent(w, to, at);
        found->d[found->count++] = to;
        from = to;
    }
    return 1;
}

/* Do two runs end at one place? */
static int agree(const work *w, const taut_walk_state *a, const taut_walk_state *b)
{
    const double room = agreement * w->carrier->size;
    double x[2][TAUT_CARRIER_VECTORS][3];
    taut_carrier_at(w->carrier, w->span, a->y, 0, x[0]);
    taut_carrier_at(w->carrier, w->span, b->y, 0, x[1]);
    return taut_length_between(x[0][0], x[1][0]) <= room && fabs(a->s - b->s) <= room;
}

/* In 4, 8, 16 equal levels until two runs agree; 0 where none do. */
static int settle(const work *w, const collocation *rule, const taut_walk_state *state, double d,
                  taut_parabolic *found)
{
    taut_walk_state before;
    for (int count = 4, runs = 0; count <= 16; count *= 2, runs++) {
        if (!run(w, rule, state, d, count, 1, found)) {
            return 0;
        }
        const taut_walk_state *end = &found->states[found->count - 1];
        if (runs > 0 && agree(w, &before, end)) {
            return 1;
        }
        before = *end;
    }
    return 0;
}

void taut_parabolic_finish(const taut_carrier *carrier, taut_linefield_kind kind,
                           const taut_walk_state *state, taut_parabolic *found)
{
    const work w = {carrier, kind.family, state->span, state->tangent};
    collocation rule;
    double d = 0;

    found->count = 0;
    if (!begins(&w, state, &d)) {
        return;
    }
    make_rule(&rule);
    if (!settle(&w, &rule, state, d, found)) {
        found->count = 0;
        return;
    }
    const taut_walk_state end = found->states[found->count - 1];
    found->is_envelope = is_touching(&w, &end);
    if (!found->is_envelope && !(run(&w, &rule, state, d, TAUT_PARABOLIC_LEVELS, 0, found) &&
                                 agree(&w, &end, &found->states[found->count - 1]))) {
        found->count = 0;
    }
}
