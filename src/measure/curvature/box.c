/* box.c -- extremes of each coordinate over the surface.
 *
 * Basis functions are not negative and sum to 1, so on a cell no coordinate leaves the range of the
 * cell's net. The corners of all cells give a first box; only cells whose net reaches out of it
 * are searched: sampled, and from the best samples climbed by Newton's method within the cell.
 */
#include "measure/curvature/box.h"

#include "geometry/exponent.h"
#include "measure/curvature/spot.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { CLIMBS = 3, STEPS = 60, SAMPLES_MAX = 24 };
/* Operations, as pulses count them, of a cell and of a control point that a value takes in. */
enum { CELL_WORK = 1000, POINT_WORK = 10 };

typedef struct climb {
    const taut_surface *surface;
    int span[2];
    double lo[2], hi[2];
    int axis;
    double sign; /* +1 looks for the largest, -1 for the smallest */
    int scale;
    int shift[2];
    const taut_crew *crew;
} climb;

/* Nonzero when it is to end: of one value. */
static int beat_of_value(const taut_surface *surface, const taut_crew *crew)
{
    return taut_crew_beat(crew, (double)POINT_WORK * taut_basis_local(taut_surface_u(surface)) *
                                    taut_basis_local(taut_surface_v(surface)));
}

/* sign * coordinate, its gradient and second derivatives by parameters divided by 2^shift. */
static void eval_coordinate(const climb *c, const double t[2], int order, double *f, double g[2],
                            double h[3])
{
    taut_spot spot;
    (void)beat_of_value(c->surface, c->crew);
    taut_spot_at(c->surface, c->span[0], c->span[1], t[0], t[1], order, c->scale, c->shift, &spot);
    const double *x = spot.x[c->axis].c;
    *f = c->sign * x[0];
    g[0] = c->sign * x[1];
    g[1] = c->sign * x[2];
    h[0] = c->sign * 2 * x[3];
    h[1] = c->sign * x[4];
    h[2] = c->sign * 2 * x[5];
}

/* A direction of ascent within the cell: parameters at a bound that the gradient leaves are held;
 * Newton's step for the others where the function is concave, else along the gradient, a quarter of
 * the cell. Returns 0 where nothing is free. */
static int find_ascent(const climb *c, const double t[2], const double g[2], const double h[3],
                       double step[2])
{
    int is_free[2];
    for (int d = 0; d < 2; d++) {
        is_free[d] = !(t[d] <= c->lo[d] && g[d] <= 0) && !(t[d] >= c->hi[d] && g[d] >= 0);
        step[d] = 0;
    }
    const double det = h[0] * h[2] - h[1] * h[1];
    if (is_free[0] && is_free[1] && h[0] < 0 && det > 0) {
        step[0] = (h[1] * g[1] - h[2] * g[0]) / det;
        step[1] = (h[1] * g[0] - h[0] * g[1]) / det;
    } else {
        for (int d = 0; d < 2; d++) {
            const double bend = d == 0 ? h[0] : h[2];
            const double reach = ldexp(c->hi[d] - c->lo[d], -c->shift[d]) / 4;
            if (is_free[d]) {
                step[d] = bend < 0 ? -g[d] / bend : copysign(reach, g[d]);
            }
        }
    }
    return (is_free[0] || is_free[1]) && (g[0] * step[0] + g[1] * step[1] > 0);
}

/* The largest value found climbing from t. */
static double climb_from(const climb *c, double t[2])
{
    double f = 0, g[2], h[3], step[2];

    eval_coordinate(c, t, 2, &f, g, h);
    for (int i = 0; i < STEPS && find_ascent(c, t, g, h, step); i++) {
        const double gain = g[0] * step[0] + g[1] * step[1];
        double next[2], value = f, g2[2], h2[3];
        int halvings = 0;
        for (double part = 1; halvings < 40; part /= 2, halvings++) {
            for (int d = 0; d < 2; d++) {
                next[d] = t[d] + ldexp(part * step[d], c->shift[d]);
                next[d] = fmin(c->hi[d], fmax(c->lo[d], next[d]));
            }
            eval_coordinate(c, next, 2, &value, g2, h2);
            if (value > f) {
                break;
            }
        }
        if (!(value > f)) {
            break;
        }
        memcpy(t, next, sizeof next);
        memcpy(g, g2, sizeof g2);
        memcpy(h, h2, sizeof h2);
        const double rise = value - f;
        f = value;
        if (gain < 0x1p-50 && rise < 0x1p-50) {
            break;
        }
    }
    return f;
}

/* Samples the closed cell and climbs from the best few. */
static double search_cell(const climb *c)
{
    const taut_basis *bases[2] = {taut_surface_u(c->surface), taut_surface_v(c->surface)};
    double best[CLIMBS], at[CLIMBS][2], largest = -INFINITY;
    int count[2], kept = 0;

    for (int d = 0; d < 2; d++) {
        count[d] = 2 * taut_basis_local(bases[d]) + 1;
        count[d] = count[d] > SAMPLES_MAX ? SAMPLES_MAX : count[d];
    }
    for (int i = 0; i < count[0] * count[1]; i++) {
        const double part[2] = {(double)(i / count[1]) / (count[0] - 1),
                                (double)(i % count[1]) / (count[1] - 1)};
        double t[2], f = 0, g[2], h[3];
        int place = kept;
        for (int d = 0; d < 2; d++) {
            t[d] = part[d] == 1 ? c->hi[d] : c->lo[d] + part[d] * (c->hi[d] - c->lo[d]);
        }
        eval_coordinate(c, t, 0, &f, g, h);
        while (place > 0 && f > best[place - 1]) {
            place--;
        }
        kept = kept < CLIMBS ? kept + 1 : kept;
        for (int k = kept - 1; k > place; k--) {
            best[k] = best[k - 1];
            memcpy(at[k], at[k - 1], sizeof at[k]);
        }
        if (place < CLIMBS) {
            best[place] = f;
            memcpy(at[place], t, sizeof t);
        }
    }
    for (int k = 0; k < kept; k++) {
        largest = fmax(largest, climb_from(c, at[k]));
    }
    return largest;
}

/* Widens the box to hold x. */
static void take_into_box(const double x[3], double box[2][3])
{
    for (int c = 0; c < 3; c++) {
        box[0][c] = x[c] < box[0][c] ? x[c] : box[0][c];
        box[1][c] = x[c] > box[1][c] ? x[c] : box[1][c];
    }
}

static void empty_box(double box[2][3])
{
    for (int c = 0; c < 3; c++) {
        box[0][c] = INFINITY;
        box[1][c] = -INFINITY;
    }
}

/* The box of the net alive on a cell. */
static void net_box(const taut_surface *surface, const int span[2], double box[2][3])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *points = taut_surface_points(surface);
    const int64_t columns = taut_basis_count(v);

    empty_box(box);
    for (int a = 0; a < taut_basis_local(u); a++) {
        const double *row = points + 3 * ((taut_basis_first(u, span[0]) + a) * columns +
                                          taut_basis_first(v, span[1]));
        for (int b = 0; b < taut_basis_local(v); b++) {
            take_into_box(row + 3 * (ptrdiff_t)b, box);
        }
    }
}

/* The box of the corners of all cells. */
static void corner_box(const taut_surface *surface, const taut_crew *crew, double box[2][3])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double *bu = taut_basis_breaks(u), *bv = taut_basis_breaks(v);
    empty_box(box);
    for (int i = 0; i <= taut_basis_span_count(u); i++) {
        for (int j = 0; j <= taut_basis_span_count(v); j++) {
            double x[3];
            (void)beat_of_value(surface, crew);
            taut_surface_eval(surface, bu[i], bv[j], 0, x);
            take_into_box(x, box);
        }
        taut_crew_beat(crew, CELL_WORK * (double)taut_basis_span_count(v));
    }
}

/* What reaches out of the net's box by a rounding is put back on it. */
static void clip_to_net(const taut_surface *surface, double slack, double box[2][3])
{
    const double *points = taut_surface_points(surface);
    const size_t count = taut_point_count(surface);
    for (size_t c = 0; c < 3; c++) {
        double lo = points[c], hi = points[c];
        for (size_t k = 1; k < count; k++) {
            lo = fmin(lo, points[3 * k + c]);
            hi = fmax(hi, points[3 * k + c]);
        }
        box[0][c] = box[0][c] < lo && box[0][c] >= lo - slack ? lo : box[0][c];
        box[1][c] = box[1][c] > hi && box[1][c] <= hi + slack ? hi : box[1][c];
    }
}

/* Searches the cell at hand for what its net has outside the box. */
static void search_beyond(climb *c, double slack, double box[2][3])
{
    const double *breaks[2] = {taut_basis_breaks(taut_surface_u(c->surface)),
                               taut_basis_breaks(taut_surface_v(c->surface))};
    double net[2][3];

    net_box(c->surface, c->span, net);
    for (int d = 0; d < 2; d++) {
        c->lo[d] = breaks[d][c->span[d]];
        c->hi[d] = breaks[d][c->span[d] + 1];
    }
    for (int side = 0; side < 6; side++) {
        double *found = &box[side / 3][side % 3];
        c->axis = side % 3;
        c->sign = side < 3 ? -1 : 1;
        if (c->sign * net[side / 3][side % 3] > c->sign * *found + slack) {
            *found = c->sign * fmax(c->sign * *found, ldexp(search_cell(c), c->scale));
        }
    }
}

void taut_box_of(const taut_surface *surface, const taut_crew *crew, double box[2][3])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double size = taut_half_size(taut_point_count(surface), taut_surface_points(surface));
    const double slack = 1e-12 * size;
    climb c = {.surface = surface, .scale = taut_exponent(size) + 1, .crew = crew};

    c.shift[0] = taut_range_exponent(u);
    c.shift[1] = taut_range_exponent(v);
    corner_box(surface, crew, box);
    for (c.span[0] = 0; c.span[0] < taut_basis_span_count(u); c.span[0]++) {
        for (c.span[1] = 0; c.span[1] < taut_basis_span_count(v); c.span[1]++) {
            search_beyond(&c, slack, box);
        }
        taut_crew_beat(crew, CELL_WORK * (double)taut_basis_span_count(v));
    }
    clip_to_net(surface, slack, box);
}
