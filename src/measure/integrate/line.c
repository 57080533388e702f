#include "measure/integrate/line.h"

#include "basis/basis_ops.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "geometry/net.h"
#include "geometry/nurbs/cells.h"
#include "measure/curvature/place.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* points[k] Euclidean, weights or NULL: fills net, scale and shift. */
static taut_status scale_net(taut_arena *arena, const taut_basis *basis, const double *points,
                             const double *weights, taut_line *line)
{
    const int count = taut_basis_count(basis), dim = weights != NULL ? 4 : 3;
    double *net = taut_arena_take(arena, (size_t)count * (size_t)dim, sizeof(double));

    *line = (taut_line){.basis = basis, .dim = dim, .net = net};
    if (net == NULL) {
        return TAUT_NO_MEMORY;
    }
    line->scale = taut_exponent(taut_half_size((size_t)count, points)) + 1;
    line->shift = taut_range_exponent(basis);
    const double factor = taut_half_factor(line->scale);
    for (int64_t k = 0; k < count; k++) {
        double *out = net + k * dim;
        const double w = weights != NULL ? weights[k] / weights[0] : 1;
        for (int c = 0; c < 3; c++) {
            out[c] = w * ((points[3 * k + c] / 2 - points[c] / 2) * factor);
        }
        if (weights != NULL) {
            out[3] = w;
        }
    }
    return TAUT_OK;
}

taut_status taut_line_of_curve(taut_arena *arena, const taut_curve *curve, taut_line *line)
{
    return scale_net(arena, taut_curve_t(curve), taut_curve_points(curve),
                     taut_curve_weights(curve), line);
}

/* The control points of an edge: sum_a N_a(end) P[a][j], the functions at the end of their range.
 */
static void edge_net(const taut_surface *surface, int edge, const double *n, int first,
                     double *points, double *weights)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const double *net = taut_surface_points(surface), *w = taut_surface_weights(surface);
    const int held = edge / 2, columns = taut_basis_count(bases[1]);
    const int local = taut_basis_local(bases[held]), count = taut_basis_count(bases[1 - held]);

    for (int j = 0; j < count; j++) {
        double sum[4] = {0, 0, 0, 0};
        for (int a = 0; a < local; a++) {
            const int64_t at =
                held == 0 ? (int64_t)(first + a) * columns + j : (int64_t)j * columns + first + a;
            const double factor = n[a] * (w != NULL ? w[at] : 1);
            for (int c = 0; c < 3; c++) {
                sum[c] += factor * net[3 * at + c];
            }
            sum[3] += factor;
        }
        for (int c = 0; c < 3; c++) {
            points[3 * j + c] = w != NULL ? sum[c] / sum[3] : sum[c];
        }
        if (w != NULL) {
            weights[j] = sum[3];
        }
    }
}

taut_status taut_line_of_edge(taut_arena *arena, const taut_surface *surface, int edge,
                              taut_line *line)
{
    const taut_basis *held = edge < 2 ? taut_surface_u(surface) : taut_surface_v(surface);
    const taut_basis *runs = edge < 2 ? taut_surface_v(surface) : taut_surface_u(surface);
    const int span = edge % 2 == 0 ? 0 : taut_basis_span_count(held) - 1;
    const double t = edge % 2 == 0 ? taut_basis_lo(held) : taut_basis_hi(held);
    const size_t count = (size_t)taut_basis_count(runs);
    double n[TAUT_DEGREE_MAX + 1];
    double *points = taut_arena_take(arena, count, 3 * sizeof(double));
    double *weights = NULL;

    if (taut_surface_weights(surface) != NULL) {
        weights = taut_arena_take(arena, count, sizeof(double));
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_basis_eval(held, span, t, 0, n);
    edge_net(surface, edge, n, taut_basis_first(held, span), points, weights);
    return scale_net(arena, runs, points, weights, line);
}

/* The derivatives of the functions sum to 0: taken of differences from the first point alive. */
void taut_line_eval(const taut_line *line, int span, double t, double rest, int order, double *d,
                    double *bound)
{
    double n[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    double h[4][4] = {{0}};
    const int local = taut_basis_local(line->basis);
    const double *net = line->net + (int64_t)taut_basis_first(line->basis, span) * line->dim;
    double size = 0;

    taut_basis_eval_beside(line->basis, span, t, rest, order, n);
    for (int a = 1; a < local; a++) {
        for (int c = 0; c < line->dim; c++) {
            size = fmax(size, fabs(net[a * line->dim + c] - net[c]));
        }
    }
    for (int k = 0; k <= order; k++) {
        const double factor = ldexp(1, k * line->shift);
        double sum = 0;
        for (int a = 0; a < local; a++) {
            const double value = factor * n[k * local + a];
            sum += fabs(value);
            for (int c = 0; c < line->dim; c++) {
                h[k][c] += value * (net[a * line->dim + c] - (k > 0 ? net[c] : 0));
            }
        }
        if (bound != NULL) {
            bound[k] = size * sum;
        }
    }
    if (line->dim == 4) {
        taut_net_project_curve(order, h, d);
    } else {
        for (int k = 0; k <= order; k++) {
            memcpy(d + 3 * k, h[k], 3 * sizeof(double));
        }
    }
}

/* Length. */

enum { DEPTH_MAX = 60 };

typedef struct rule {
    int count;
    double nodes[TAUT_GAUSS_MAX], weights[TAUT_GAUSS_MAX];
} rule;

static double speed_integral(const taut_line *line, int span, double lo, double hi, const rule *r)
{
    const double half = (hi - lo) / 2;
    double sum = 0, d[6];
    for (int i = 0; i < r->count; i++) {
        double rest = 0;
        const double t = taut_node_place(lo, hi, r->nodes[i], &rest);
        taut_line_eval(line, span, t, rest, 1, d, NULL);
        sum += r->weights[i] * sqrt(taut_dot(d + 3, d + 3));
    }
    return sum * ldexp(half, -line->shift);
}

/* int |x'| over one cell: two rules until they agree, else halves. Where x' = 0 one piece a level
 * is left, whose share falls fourfold. `floor` is what may be neglected. */
static double cell_length(const taut_line *line, const taut_cells *cells, int k,
                          const rule rules[2], double floor)
{
    const int span = cells->span[k];
    double lo[DEPTH_MAX + 1], hi[DEPTH_MAX + 1];
    taut_sum sum = {0, 0};
    int depth = 0;

    lo[0] = cells->lo[k];
    hi[0] = cells->hi[k];
    while (depth >= 0) {
        const double a = speed_integral(line, span, lo[depth], hi[depth], &rules[0]);
        const double b = speed_integral(line, span, lo[depth], hi[depth], &rules[1]);
        const double middle = lo[depth] + (hi[depth] - lo[depth]) / 2;
        if (fabs(a - b) <= 1e-13 * b + floor || depth == DEPTH_MAX || !isfinite(b)) {
            taut_sum_add(&sum, b);
            depth--;
        } else {
            lo[depth + 1] = lo[depth];
            hi[depth + 1] = middle;
            lo[depth] = middle;
            depth++;
        }
    }
    return taut_sum_total(&sum);
}

taut_status taut_line_length(const taut_line *line, double *length)
{
    const int local = taut_basis_local(line->basis);
    taut_cells *cells = NULL;
    rule rules[2];
    taut_sum sum = {0, 0};

    if (taut_cells_new(line->basis, 1, NULL, 1, 0, &cells) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }

    for (int r = 0; r < 2; r++) {
        rules[r].count = (local < 4 ? 4 : local) + 2 * r;
        taut_gauss_rule(rules[r].count, rules[r].nodes, rules[r].weights);
    }
    for (int k = 0; k < cells->count; k++) {
        taut_sum_add(&sum, cell_length(line, cells, k, rules, DBL_EPSILON / 16));
    }
    taut_cells_free(cells);
    *length = ldexp(taut_sum_total(&sum), line->scale);
    return TAUT_OK;
}

/* Curvature. */

void taut_line_bend(const taut_line *line, int span, double t, int order, taut_bend *bend)
{
    double bound[4];
    taut_line_eval(line, span, t, 0, order, &bend->d[0][0], bound);
    taut_cross(bend->d[1], bend->d[2], bend->binormal);
    bend->speed = taut_length(bend->d[1]);
    bend->curvature = nan("");
    bend->trust = 0;
    /* a speed of 2^-40 of what the net allows is a sum that cancels but for its rounding */
    if (bend->speed > 0x1p-40 * bound[1]) {
        bend->curvature = taut_length(bend->binormal) / bend->speed / bend->speed / bend->speed;
        bend->trust = 8 * DBL_EPSILON * bound[2] / bend->speed / bend->speed;
    }
}

double taut_line_curvature(const taut_line *line, const taut_parameters *lines)
{
    double largest = nan("");
    for (int i = 0; i < lines->count; i++) {
        taut_bend bend;
        taut_line_bend(line, lines->span[i], lines->t[i], 2, &bend);
        largest = fmax(largest, bend.curvature);
    }
    return largest;
}

int taut_bend_is_straight(const taut_bend *bend, double largest, double length)
{
    return !(bend->curvature > 0x1p-26 * fmax(largest, 1 / length)) ||
           !(bend->curvature > 0x1p16 * bend->trust);
}
