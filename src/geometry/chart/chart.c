#include "geometry/chart/chart.h"

#include <string.h>

/* A share of an edge's curve as its parameter. */
static double parameter_of(const taut_chart *chart, int edge, double x)
{
    const taut_basis *basis = taut_curve_t(chart->edges[edge]);
    const double *part = chart->part[edge];
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return fmin(fmax(lo + (part[0] + x * (part[1] - part[0])) * (hi - lo), lo), hi);
}

static double range_of(const taut_chart *chart, int edge)
{
    const taut_basis *basis = taut_curve_t(chart->edges[edge]);
    return (chart->part[edge][1] - chart->part[edge][0]) *
           (taut_basis_hi(basis) - taut_basis_lo(basis));
}

/* An edge over [a, b], and its derivatives by x. */
static int edge_over(const taut_chart *chart, int edge, double a, double b, taut_range w[3][2])
{
    const double x = parameter_of(chart, edge, a), y = parameter_of(chart, edge, b);
    const double range = range_of(chart, edge);
    taut_range all[3][3];
    if (!taut_enclose_curve(chart->edges[edge], fmin(x, y), fmax(x, y), all)) {
        return 0;
    }
    for (int d = 0; d < 2; d++) {
        w[0][d] = all[0][d];
        w[1][d] = taut_range_scale(range, all[1][d]);
        w[2][d] = taut_range_scale(range * range, all[2][d]);
    }
    return 1;
}

static void edge_at(const taut_chart *chart, int edge, double x, double w[2][2])
{
    double all[2][3];
    taut_curve_eval(chart->edges[edge], parameter_of(chart, edge, x), 1, all[0]);
    for (int d = 0; d < 2; d++) {
        w[0][d] = all[0][d];
        w[1][d] = range_of(chart, edge) * all[1][d];
    }
}

/* What start or end is off its chord, faded out along the piece. */
static int add_bulge(const taut_chart *chart, int end, const taut_chart_part *part,
                     taut_range w[6][2])
{
    const int edge = end == 0 ? TAUT_CHART_START : TAUT_CHART_END;
    const taut_range t = {part->from[1], part->to[1]};
    const taut_range fade = end == 0 ? (taut_range){1 - part->to[0], 1 - part->from[0]}
                                     : (taut_range){part->from[0], part->to[0]};
    double corners[2][2][2];
    taut_range at[3][2];
    if (chart->edges[edge] == NULL) {
        return 1;
    }
    if (!edge_over(chart, edge, t.lo, t.hi, at)) {
        return 0;
    }
    edge_at(chart, TAUT_CHART_RIGHT, end, corners[0]);
    edge_at(chart, TAUT_CHART_LEFT, end, corners[1]);
    for (int d = 0; d < 2; d++) {
        const int is_kept = chart->kept[end] == 1 + d;
        const taut_range share = is_kept ? taut_range_of(1) : fade;
        const double slope = is_kept ? 0 : end == 0 ? -1 : 1;
        const double chord = corners[1][0][d] - corners[0][0][d];
        const taut_range line =
            taut_range_add(taut_range_of(corners[0][0][d]), taut_range_scale(chord, t));
        const taut_range off = taut_range_minus(at[0][d], line);
        const taut_range turn = taut_range_minus(at[1][d], taut_range_of(chord));
        w[0][d] = taut_range_add(w[0][d], taut_range_times(share, off));
        w[1][d] = taut_range_add(w[1][d], taut_range_scale(slope, off));
        w[2][d] = taut_range_add(w[2][d], taut_range_times(share, turn));
        w[4][d] = taut_range_add(w[4][d], taut_range_scale(slope, turn));
        w[5][d] = taut_range_add(w[5][d], taut_range_times(share, at[2][d]));
    }
    return 1;
}

int taut_chart_window(const taut_chart *chart, const taut_chart_part *part, taut_range w[6][2])
{
    const taut_range t = {part->from[1], part->to[1]};
    const taut_basis *bases[2] = {taut_surface_u(chart->surface), taut_surface_v(chart->surface)};
    taut_range right[3][2], left[3][2];
    if (!edge_over(chart, TAUT_CHART_RIGHT, part->from[0], part->to[0], right) ||
        !edge_over(chart, TAUT_CHART_LEFT, part->from[0], part->to[0], left)) {
        return 0;
    }
    for (int d = 0; d < 2; d++) {
        for (int k = 0; k < 3; k++) { /* w, w_s, w_ss */
            static const int which[3] = {0, 1, 3};
            w[which[k]][d] = taut_range_add(
                right[k][d], taut_range_times(t, taut_range_minus(left[k][d], right[k][d])));
        }
        w[2][d] = taut_range_minus(left[0][d], right[0][d]);
        w[4][d] = taut_range_minus(left[1][d], right[1][d]);
        w[5][d] = taut_range_of(0);
    }
    if (!add_bulge(chart, 0, part, w) || !add_bulge(chart, 1, part, w)) {
        return 0;
    }
    for (int d = 0; d < 2; d++) { /* no place is outside */
        const double lo = taut_basis_lo(bases[d]), hi = taut_basis_hi(bases[d]);
        w[0][d].lo = fmin(fmax(w[0][d].lo, lo), hi);
        w[0][d].hi = fmin(fmax(w[0][d].hi, lo), hi);
    }
    return 1;
}

int taut_chart_enclose(const taut_chart *chart, const taut_chart_part *part,
                       const double frame[3][3], taut_range x[6][3])
{
    taut_range w[6][2], of[6][3];
    if (!taut_chart_window(chart, part, w)) {
        return 0;
    }
    const double from[2] = {w[0][0].lo, w[0][1].lo}, to[2] = {w[0][0].hi, w[0][1].hi};
    if (!taut_enclose_surface(chart->surface, from, to, frame, of)) {
        return 0;
    }
    static const int pairs[3][2] = {{1, 1}, {1, 2}, {2, 2}};
    for (int c = 0; c < 3; c++) {
        x[0][c] = of[0][c];
        for (int k = 1; k < 3; k++) {
            x[k][c] = taut_range_add(taut_range_times(of[1][c], w[k][0]),
                                     taut_range_times(of[2][c], w[k][1]));
        }
        for (int k = 0; k < 3; k++) {
            const taut_range *a = w[pairs[k][0]], *b = w[pairs[k][1]], *ab = w[3 + k];
            const taut_range mixed =
                taut_range_add(taut_range_times(a[0], b[1]), taut_range_times(a[1], b[0]));
            taut_range sum = taut_range_times(of[3][c], a == b ? taut_range_square(a[0])
                                                               : taut_range_times(a[0], b[0]));
            sum = taut_range_add(sum, taut_range_times(of[4][c], mixed));
            sum = taut_range_add(sum,
                                 taut_range_times(of[5][c], a == b ? taut_range_square(a[1])
                                                                   : taut_range_times(a[1], b[1])));
            sum = taut_range_add(sum, taut_range_times(of[1][c], ab[0]));
            x[3 + k][c] = taut_range_add(sum, taut_range_times(of[2][c], ab[1]));
        }
    }
    return 1;
}

int taut_chart_at(const taut_chart *chart, double s, double t, double x[3][3])
{
    const taut_chart_part part = {{s, t}, {s, t}};
    taut_range w[6][2];
    double of[3][3];
    if (!taut_chart_window(chart, &part, w) ||
        taut_surface_eval(chart->surface, (w[0][0].lo + w[0][0].hi) / 2,
                          (w[0][1].lo + w[0][1].hi) / 2, 1, of[0]) != TAUT_OK) {
        return 0;
    }
    memcpy(x[0], of[0], sizeof x[0]);
    for (int k = 1; k < 3; k++) {
        for (int c = 0; c < 3; c++) {
            x[k][c] =
                of[1][c] * (w[k][0].lo + w[k][0].hi) / 2 + of[2][c] * (w[k][1].lo + w[k][1].hi) / 2;
        }
    }
    return 1;
}

/* At each break so many functions are new as a derivative less is continuous. */
int taut_basis_is_smooth(const taut_basis *basis)
{
    int all = 1;
    for (int i = 1; i < taut_basis_span_count(basis); i++) {
        const int fresh = taut_basis_first(basis, i) - taut_basis_first(basis, i - 1);
        all &= fresh <= taut_basis_local(basis) - 2;
    }
    return all;
}

int taut_chart_is_smooth(const taut_chart *chart)
{
    int all = taut_basis_is_smooth(taut_surface_u(chart->surface)) &&
              taut_basis_is_smooth(taut_surface_v(chart->surface));
    for (int e = 0; e < TAUT_CHART_EDGES; e++) {
        all &= chart->edges[e] == NULL || taut_basis_is_smooth(taut_curve_t(chart->edges[e]));
    }
    return all;
}
