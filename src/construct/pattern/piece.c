#include "construct/pattern/piece.h"

#include "core/vec3.h"
#include "numeric/quadrature.h"

enum { NODES = 8, CELLS = 16 };

/* The place of an edge at x, and its first and second derivative by x. */
static void bound_at(const taut_pattern_bound *bound, double x, double w[3][2])
{
    const double range = bound->to - bound->from;
    taut_pattern_side_at(bound->line, x < 1 ? bound->from + x * range : bound->to, w);
    for (int d = 0; d < 2; d++) {
        w[1][d] *= range;
        w[2][d] *= range * range;
    }
}

/* A circle around a tip. */
static int is_cap(const taut_pattern_bound *bound, const taut_pattern_bound *opposite)
{
    return bound->line != NULL && bound->line->kind == TAUT_SIDE_CIRCLE && opposite->is_point;
}

/* Adds what an edge across, not straight or not in proportion, is off its chord: faded out along the piece. Of a circle around a tip not
 * around it, where lines of equal t run into the tip. */
static void add_bulge(const taut_pattern_bound *bound, const taut_pattern_bound *opposite,
                      double fade, double fading, double t, double w[6][2])
{
    double at[3][2];
    if (bound->line == NULL) {
        return;
    }
    const int is_around = is_cap(bound, opposite);
    bound_at(bound, t, at);
    for (int d = 0; d < 2; d++) {
        const int is_kept = is_around && d == 1 - opposite->border / 2;
        const double share = is_kept ? 1 : fade, slope = is_kept ? 0 : fading;
        const double chord = bound->ends[1][d] - bound->ends[0][d];
        const double off = at[0][d] - ((1 - t) * bound->ends[0][d] + t * bound->ends[1][d]);
        w[0][d] += share * off;
        w[1][d] += slope * off;
        w[2][d] += share * (at[1][d] - chord);
        w[4][d] += slope * (at[1][d] - chord);
        w[5][d] += share * at[2][d];
    }
}

taut_chart taut_pattern_piece_chart(const taut_pattern_piece *piece)
{
    static const int ends[2] = {TAUT_FLAT_START, TAUT_FLAT_END};
    taut_chart chart = {.surface = piece->carrier->surface};
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const taut_pattern_bound *bound = &piece->bounds[e];
        chart.edges[e] = bound->line != NULL ? bound->line->window : NULL;
        chart.part[e][0] = bound->from;
        chart.part[e][1] = bound->to;
    }
    for (int k = 0; k < 2; k++) {
        const taut_pattern_bound *bound = &piece->bounds[ends[k]],
                                 *opposite = &piece->bounds[ends[1 - k]];
        chart.kept[k] = is_cap(bound, opposite) ? 2 - opposite->border / 2 : 0;
    }
    return chart;
}

/* The long edges at one s. */
static void sides_at(const taut_pattern_piece *piece, double s, double sides[2][3][2])
{
    bound_at(&piece->bounds[TAUT_FLAT_RIGHT], s, sides[0]);
    bound_at(&piece->bounds[TAUT_FLAT_LEFT], s, sides[1]);
}

static void window_between(const taut_pattern_piece *piece, double sides[2][3][2], double s,
                           double t, double w[6][2])
{
    double(*right)[2] = sides[0], (*left)[2] = sides[1];
    for (int d = 0; d < 2; d++) {
        w[0][d] = (1 - t) * right[0][d] + t * left[0][d];
        w[1][d] = (1 - t) * right[1][d] + t * left[1][d];
        w[2][d] = left[0][d] - right[0][d];
        w[3][d] = (1 - t) * right[2][d] + t * left[2][d];
        w[4][d] = left[1][d] - right[1][d];
        w[5][d] = 0;
    }
    const taut_pattern_bound *start = &piece->bounds[TAUT_FLAT_START],
                             *end = &piece->bounds[TAUT_FLAT_END];
    add_bulge(start, end, 1 - s, -1, t, w);
    add_bulge(end, start, s, 1, t, w);
}

void taut_pattern_piece_window(const taut_pattern_piece *piece, double s, double t, double w[6][2])
{
    double sides[2][3][2];
    sides_at(piece, s, sides);
    window_between(piece, sides, s, t, w);
}

int taut_pattern_is_sewn(const taut_pattern_piece *piece, int edge)
{
    const taut_pattern_side *line = piece->bounds[edge].line;
    return line != NULL && line->is_seam;
}

double taut_pattern_bound_length(const taut_pattern_piece *piece, int edge)
{
    const taut_pattern_bound *bound = &piece->bounds[edge];
    double nodes[NODES], weights[NODES], sum = 0;
    if (bound->line != NULL) {
        return fabs(bound->to - bound->from) * bound->line->length;
    }
    taut_gauss_rule(NODES, nodes, weights);
    for (int i = 0; i < CELLS * NODES; i++) {
        double g[3];
        const double t = (i / NODES + (1 + nodes[i % NODES]) / 2) / CELLS;
        taut_pattern_piece_metric(piece, edge == TAUT_FLAT_END, t, g);
        sum += weights[i % NODES] / (2 * CELLS) * sqrt(g[2]);
    }
    return sum;
}

static void space_at(const taut_carrier *carrier, const double at[2], int order,
                     double x[TAUT_CARRIER_VECTORS][3])
{
    double inside[2];
    int span[2];
    for (int d = 0; d < 2; d++) { /* rounding may leave the window */
        inside[d] = fmin(fmax(at[d], carrier->lo[d]), carrier->hi[d]);
    }
    taut_carrier_cell(carrier, inside, NULL, span);
    taut_carrier_at(carrier, span, at, order, x);
}

static void along(const double x[TAUT_CARRIER_VECTORS][3], const double w[2], double out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = x[1][c] * w[0] + x[2][c] * w[1];
    }
}

/* X_ab of two directions of the window, and their own derivative w_ab. */
static void second(const double x[TAUT_CARRIER_VECTORS][3], const double a[2], const double ab[2],
                   double out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = x[3][c] * a[0] * a[0] + 2 * x[4][c] * a[0] * a[1] + x[5][c] * a[1] * a[1] +
                 x[1][c] * ab[0] + x[2][c] * ab[1];
    }
}

static void metric_in(const taut_pattern_piece *piece, const double w[6][2], double g[3])
{
    double x[TAUT_CARRIER_VECTORS][3], xs[3], xt[3];
    space_at(piece->carrier, w[0], 1, x);
    along((const double(*)[3])x, w[1], xs);
    along((const double(*)[3])x, w[2], xt);
    g[0] = taut_dot(xs, xs);
    g[1] = taut_dot(xs, xt);
    g[2] = taut_dot(xt, xt);
}

void taut_pattern_piece_metric(const taut_pattern_piece *piece, double s, double t, double g[3])
{
    double w[6][2];
    taut_pattern_piece_window(piece, s, t, w);
    metric_in(piece, (const double(*)[2])w, g);
}

void taut_pattern_across_metric(const void *context, double s, double t, double g[3])
{
    const taut_pattern_across *across = context;
    taut_pattern_kept *kept = across->kept;
    double w[6][2];
    if (!(kept->s == s)) {
        sides_at(across->piece, s, kept->sides);
        kept->s = s;
    }
    window_between(across->piece, kept->sides, s, t, w);
    metric_in(across->piece, (const double(*)[2])w, g);
}

void taut_pattern_across_shrink(const void *context, double s, double t, double shrink[2])
{
    const taut_pattern_across *across = context;
    taut_pattern_piece_shrink(across->piece, s, t, shrink);
}

void taut_pattern_piece_shrink(const taut_pattern_piece *piece, double s, double t,
                               double shrink[2])
{
    double c[2] = {piece->shares[0], piece->shares[1]}, w[6][2], x[3], at[2];

    if (piece->fade_count > 0) {
        taut_pattern_piece_window(piece, s, t, w);
        for (int d = 0; d < 2; d++) { /* rounding may leave the window */
            at[d] = fmin(fmax(w[0][d], piece->carrier->lo[d]), piece->carrier->hi[d]);
        }
        taut_surface_eval(piece->carrier->surface, at[0], at[1], 0, x);
    }
    for (int k = 0; k < piece->fade_count; k++) {
        const taut_pattern_fade *fade = &piece->fades[k];
        const double z = fmin(1, taut_border_distance(&fade->border, x) / fade->length);
        for (int d = 0; d < 2; d++) {
            c[d] *= fade->is_faded[d] ? z * z * (3 - 2 * z) : 1;
        }
    }
    shrink[0] = 1 - c[0];
    shrink[1] = 1 - c[1];
}

void taut_pattern_piece_bends(const taut_pattern_piece *piece, double s, double t, double bend[2],
                              double *gauss)
{
    double w[6][2], x[TAUT_CARRIER_VECTORS][3], first[3], bent[3], sideways[3];
    taut_form_pair forms;
    taut_pattern_piece_window(piece, s, t, w);
    space_at(piece->carrier, w[0], 2, x);
    taut_carrier_forms((const double(*)[3])x, &forms);
    for (int k = 0; k < 2; k++) {
        along((const double(*)[3])x, w[1 + k], first);
        second((const double(*)[3])x, w[1 + k], w[k == 0 ? 3 : 5], bent);
        taut_cross(forms.normal, first, sideways);
        bend[k] = taut_dot(bent, sideways) / taut_dot(first, first);
    }
    *gauss = forms.w > 0 ? taut_form_pair_gauss(&forms) : 0;
}

void taut_pattern_bound_speed(const taut_pattern_piece *piece, int edge, double x, double speed[2])
{
    const int is_across = edge == TAUT_FLAT_START || edge == TAUT_FLAT_END;
    const double fixed = edge == TAUT_FLAT_END || edge == TAUT_FLAT_LEFT;
    double w[6][2], at[TAUT_CARRIER_VECTORS][3], first[3], bent[3];
    taut_pattern_piece_window(piece, is_across ? fixed : x, is_across ? x : fixed, w);
    space_at(piece->carrier, w[0], 2, at);
    along((const double(*)[3])at, w[1 + is_across], first);
    second((const double(*)[3])at, w[1 + is_across], w[is_across ? 5 : 3], bent);
    speed[0] = taut_norm(first);
    speed[1] = taut_dot(first, bent) / speed[0];
}
