/* strain.c
 *
 * With G = (X_s, X_t)^T (X_s, X_t) and B = (F0 y_s, F0 y_t)^T (F0 y_s, F0 y_t) all principal strains are in [-e, e] where
 *
 *     G - (1 - e)^2 B > 0   and   (1 + e)^2 B - G > 0   (positive definite)
 *
 * as C = J^-T G J^-1. Over a cell each entry is within its change of what it is in the middle: half a side times its derivative, which
 * is made of derivatives of the first two orders of X and y, enclosed (geometry/chart/enclose.h). Cells that this leaves open are halved.
 */
#include "certify/pattern/strain.h"

#include "core/vec3.h"

#include <math.h>

enum { CELLS = 24000 /* of a piece */, ALL_CELLS = 160000, DEPTH = 24 };
/* Of the entries: what rounding may change. */
static const double rounding = 1e-12;
/* Operations, about, of a cell. */
static const double work_of_cell = 5e4;

typedef struct gauge {
    taut_chart chart;
    const taut_surface *flat;
    double stretch[2]; /* F0 */
    double factor[2];  /* (1 - e)^2, (1 + e)^2 */
    int cells, most;   /* that were looked at, and that may be */
    taut_pulse *pulse;
} gauge;

typedef enum verdict { OPEN = 0, FINE, WRONG } verdict;

/* Of a metric in the middle of a cell and over it: the entries, and their derivatives by s and t. */
typedef struct metric {
    double at[3];
    taut_range slope[2][3];
} metric;

static metric metric_of(const double first[2][3], const taut_range x[6][3])
{
    metric m;
    for (int k = 0; k < 3; k++) {
        m.at[k] = taut_dot(first[k == 2], first[k > 0]);
    }
    for (int d = 0; d < 2; d++) { /* of X_s is X_ss or X_st, of X_t is X_st or X_tt */
        const taut_range *s = x[3 + d], *t = x[4 + d];
        m.slope[d][0] = taut_range_scale(2, taut_range_dot(x[1], s));
        m.slope[d][1] = taut_range_add(taut_range_dot(s, x[2]), taut_range_dot(x[1], t));
        m.slope[d][2] = taut_range_scale(2, taut_range_dot(x[2], t));
    }
    return m;
}

/* Is sign (g - factor b) positive definite over the cell, or not even in its middle? */
static verdict judge(const metric *g, const metric *b, double factor, int sign,
                     const double half[2])
{
    double at[3], off[3];
    for (int k = 0; k < 3; k++) {
        at[k] = sign * (g->at[k] - factor * b->at[k]);
        off[k] = rounding * (fabs(g->at[k]) + factor * fabs(b->at[k]));
        for (int d = 0; d < 2; d++) {
            const taut_range slope =
                taut_range_minus(g->slope[d][k], taut_range_scale(factor, b->slope[d][k]));
            off[k] += half[d] * taut_range_size(slope);
        }
    }
    if (!(at[0] > 0 && at[2] > 0 && at[0] * at[2] > at[1] * at[1])) {
        return WRONG;
    }
    const double across = fabs(at[1]) + off[1];
    return at[0] > off[0] && at[2] > off[2] && (at[0] - off[0]) * (at[2] - off[2]) > across * across
               ? FINE
               : OPEN;
}

/* *along: the longer side. */
static verdict look_at(gauge *w, const taut_chart_part *part, int *along)
{
    const double middle[2] = {(part->from[0] + part->to[0]) / 2, (part->from[1] + part->to[1]) / 2};
    const double half[2] = {(part->to[0] - part->from[0]) / 2, (part->to[1] - part->from[1]) / 2};
    taut_range x[6][3], y[6][3];
    double at[3][3], flat[3][3];
    if (!taut_chart_at(&w->chart, middle[0], middle[1], at) ||
        taut_surface_eval(w->flat, middle[0], middle[1], 1, flat[0]) != TAUT_OK) {
        return WRONG;
    }
    for (int k = 1; k < 3; k++) {
        for (int c = 0; c < 2; c++) {
            flat[k][c] *= w->stretch[c];
        }
    }
    double frame[3][3], level[3][3];
    if (!taut_enclose_frame((const double(*)[3])at, frame) ||
        !taut_enclose_frame((const double(*)[3])flat, level)) {
        return WRONG;
    }
    for (int k = 0; k < 3; k++) {
        for (int c = 0; c < 2; c++) {
            level[k][c] *= w->stretch[c];
        }
    }
    if (!taut_chart_enclose(&w->chart, part, (const double(*)[3])frame, x) ||
        !taut_enclose_surface(w->flat, part->from, part->to, (const double(*)[3])level, y)) {
        return WRONG;
    }
    const metric g = metric_of((const double(*)[3])at + 1, (const taut_range(*)[3])x);
    const metric b = metric_of((const double(*)[3])flat + 1, (const taut_range(*)[3])y);
    const verdict low = judge(&g, &b, w->factor[0], 1, half);
    const verdict high = judge(&g, &b, w->factor[1], -1, half);
    *along = half[1] * sqrt(g.at[2]) > half[0] * sqrt(g.at[0]);
    return low == WRONG || high == WRONG ? WRONG : low == FINE && high == FINE ? FINE : OPEN;
}

static int prove(gauge *w, const taut_chart_part *part, int depth)
{
    int along = 0;
    if (w->cells++ >= w->most || taut_pulse_beat(w->pulse, work_of_cell)) {
        return 0;
    }
    const verdict found = look_at(w, part, &along);
    if (found != OPEN || depth == 0) {
        return found == FINE;
    }
    taut_chart_part low = *part, high = *part;
    low.to[along] = high.from[along] = (part->from[along] + part->to[along]) / 2;
    return prove(w, &low, depth - 1) && prove(w, &high, depth - 1);
}

static int holds(gauge *w, double e)
{
    const taut_basis *bases[2] = {taut_surface_u(w->flat), taut_surface_v(w->flat)};
    const double *breaks[2] = {taut_basis_breaks(bases[0]), taut_basis_breaks(bases[1])};
    int all = 1;
    w->cells = 0;
    w->factor[0] = e < 1 ? (1 - e) * (1 - e) : 0;
    w->factor[1] = (1 + e) * (1 + e);
    for (int i = 0; all && i < taut_basis_span_count(bases[0]); i++) {
        for (int k = 0; all && k < taut_basis_span_count(bases[1]); k++) {
            const taut_chart_part part = {{breaks[0][i], breaks[1][k]},
                                          {breaks[0][i + 1], breaks[1][k + 1]}};
            all = prove(w, &part, DEPTH);
        }
    }
    return all;
}

double taut_cloth_strain_bound(const taut_cloth *cloth, const taut_cloth_piece *piece, double found,
                               double limit, taut_pulse *pulse)
{
    gauge w = {.chart = taut_cloth_chart(cloth, piece), .flat = piece->flat, .pulse = pulse};
    double shrink[2];
    w.most = cloth->piece_count > ALL_CELLS / CELLS ? ALL_CELLS / cloth->piece_count : CELLS;
    if (cloth->fade_count > 0 || !(found <= limit) || piece->is_point[TAUT_CLOTH_START] ||
        piece->is_point[TAUT_CLOTH_END] || !taut_chart_is_smooth(&w.chart) ||
        !taut_basis_is_smooth(taut_surface_u(w.flat)) ||
        !taut_basis_is_smooth(taut_surface_v(w.flat))) {
        return (double)NAN;
    }
    taut_cloth_shrink(cloth, piece, (const double[2]){0, 0}, shrink); /* the same everywhere */
    w.stretch[0] = 1 / shrink[0];
    w.stretch[1] = 1 / shrink[1];
    if (!holds(&w, limit)) {
        return (double)NAN;
    }
    const double near = (found + limit) / 2; /* takes about twice the cells */
    return w.cells < w.most / 3 && holds(&w, near) ? near : limit;
}
