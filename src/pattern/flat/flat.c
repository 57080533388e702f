/* flat.c -- flattening by Newton's method on the Lagrangian.
 *
 *     start    the axis t = 1/2 unrolled by its geodesic curvature, cross lines straight at their angle
 *     alone    W least in the default law, then in the law asked for, no edge held
 *     held     lengths of edges from their natural ones to those told, at once or in steps
 *     a step   H dx + A' dl = -(g + A' l), A dx - e dl = -c:  the band of H is factored, S = A H^-1 A' + e is
 *              dense; e at rounding, for rows that depend on each other (straight ends of a straight band)
 *              shifted until the Hessian is positive on the constraints, by the inertia of H and S
 *              halved while det J <= 0 at a Gauss point
 *
 */
#include "pattern/flat/flat.h"

#include "core/elementary/elementary.h"
#include "numeric/band.h"
#include "numeric/quadrature.h"
#include "pattern/flat/density.h"
#include "pattern/flat/line.h"
#include "pattern/flat/sums.h"

#include <math.h>
#include <string.h>

enum {
    DEGREE = TAUT_FLAT_DEGREE,
    LOCAL = TAUT_FLAT_LOCAL,
    GAUSS = TAUT_FLAT_GAUSS,
    STEPS_MAX = 60,
    FINE = 32, /* spans: on more of them no way is gone in steps, */
    FINEST = 64,
    FINEST_STEPS = 24, /* and on more than these, where each takes a second, none is long */
    SHIFTS_MAX = 24,
    HALVINGS_MAX = 40,
    LEAST_STEP = 64 /* of a continuation: 1 over this */
};

static const taut_flat_law default_law = {1, 1, 0, 0.5};
/* A step below this, over the size, is the last but one, or the last where Newton's next would be below `rounding`. */
static const double small_step = 1e-7, rounding = 1e-16;
/* Operations, about, of a place: of the metric, of the density, and of its second variation. */
static const double work_of_metric = 2e3, work_of_density = 2e2, work_of_form = 2e3;
/* Rows that depend on each other: e over the largest of S. */
static const double dependent = 1e-13;

typedef taut_flat_line line;

/* ---- the work of one call ---- */

typedef struct work {
    taut_arena *arena;
    const taut_flat_strip *strip;
    const taut_flat_options *options;
    line lines[2];
    double *metric; /* [spans][GAUSS][spans][GAUSS][3] */
    double *
        shrink; /* [spans][GAUSS][spans][GAUSS][2]: 1/F0, where it is not one everywhere; or NULL */
    taut_flat_sums sums;
    double (*j)[2][2];     /* of all places of t at one of s */
    taut_flat_form *forms; /* and these */
    char *is_there;
    int n, width;   /* unknowns, half band */
    int is_turning; /* rotation is left to the thread's row */
    double *y, *step, *gradient, *slope;
    char *pinned;
    taut_band hessian;
    int rows, edges[TAUT_FLAT_EDGES], room; /* of constraints; the first row of each edge, or -1 */
    double *a, *c, *multiplier, *change, *solved, *schur;
    double *length[TAUT_FLAT_EDGES]; /* |X_s| of held edges, at Gauss points */
    double *target[TAUT_FLAT_EDGES]; /* and l */
    double *natural[TAUT_FLAT_EDGES];
    double size, energy, stretch[2]; /* stretch: 1/F0 */
    taut_flat_law law;
    double residual;
    int is_stable, steps;
    double
        shift; /* of the diagonal, that the last step which needed one took; the next one looks from below it on */
} work;

static int unknown(const work *w, int i, int j, int k)
{
    return (i * w->lines[1].count + j) * 2 + k;
}

/* Of the places of t at place q of span a of s. */
static double *metric_along(const work *w, int a, int q)
{
    return w->metric + (size_t)(a * GAUSS + q) * (size_t)(w->lines[1].spans * GAUSS) * 3;
}

/* 1/F0 at place m of t of those at a place of s. */
static const double *shrink_at(const work *w, int a, int q, int m)
{
    return w->shrink == NULL
               ? w->stretch
               : w->shrink +
                     ((size_t)(a * GAUSS + q) * (size_t)(w->lines[1].spans * GAUSS) + (size_t)m) *
                         2;
}

/* W of a net; INFINITY where it folds at a Gauss point, and once it is to end. */
static double energy_of(work *w, const double *y)
{
    const line *s = &w->lines[0], *t = &w->lines[1];
    double sum = 0;
    taut_flat_form f;
    if (taut_pulse_beat(w->options->pulse,
                        s->spans * GAUSS * (t->spans * GAUSS * work_of_density))) {
        return INFINITY;
    }
    for (int k = 0; k < s->spans * GAUSS; k++) {
        const double *g = metric_along(w, k / GAUSS, k % GAUSS);
        taut_flat_sums_slopes(&w->sums, y, k / GAUSS, k % GAUSS, w->j);
        for (int m = 0; m < t->spans * GAUSS; m++) {
            if (!taut_flat_density(&w->law, shrink_at(w, k / GAUSS, k % GAUSS, m),
                                   (const double(*)[2])w->j[m], g + 3 * m, 0, &f)) {
                return INFINITY;
            }
            sum += f.w * s->weight[k / GAUSS][k % GAUSS] * t->weight[m / GAUSS][m % GAUSS];
        }
    }
    return sum;
}

static void assemble(work *w)
{
    const line *s = &w->lines[0], *t = &w->lines[1];

    memset(w->hessian.a, 0, sizeof(double) * (size_t)w->n * ((size_t)w->width + 1));
    memset(w->gradient, 0, sizeof(double) * (size_t)w->n);
    for (int a = 0; a < s->spans &&
                    !taut_pulse_beat(w->options->pulse, t->spans * GAUSS * GAUSS * work_of_form);
         a++) {
        taut_flat_sums_begin(&w->sums);
        for (int q = 0; q < GAUSS; q++) {
            const double *g = metric_along(w, a, q);
            taut_flat_sums_slopes(&w->sums, w->y, a, q, w->j);
            for (int m = 0; m < t->spans * GAUSS; m++) {
                w->is_there[m] = (char)taut_flat_density(&w->law, shrink_at(w, a, q, m),
                                                         (const double(*)[2])w->j[m], g + 3 * m, 1,
                                                         &w->forms[m]);
            }
            taut_flat_sums_add(&w->sums, a, q, w->forms, w->is_there, w->gradient);
        }
        taut_flat_sums_end(&w->sums, a, &w->hessian);
    }
}

/* ---- constraints ---- */

/* The unknown of coefficient k along an edge. */
static int edge_unknown(const work *w, int edge, int k, int d)
{
    switch (edge) {
    case TAUT_FLAT_RIGHT:
        return unknown(w, k, 0, d);
    case TAUT_FLAT_LEFT:
        return unknown(w, k, w->lines[1].count - 1, d);
    case TAUT_FLAT_START:
        return unknown(w, 0, k, d);
    default:
        return unknown(w, w->lines[0].count - 1, k, d);
    }
}

static int edge_way(int edge)
{
    return edge == TAUT_FLAT_START || edge == TAUT_FLAT_END;
}

/* y_s on an edge at a Gauss point. */
static double edge_speed(const work *w, const double *y, int edge, int a, int q, double slope[2])
{
    const line *l = &w->lines[edge_way(edge)];
    slope[0] = slope[1] = 0;
    for (int i = 0; i < LOCAL; i++) {
        for (int d = 0; d < 2; d++) {
            slope[d] += l->slope[a][q][i] * y[edge_unknown(w, edge, a + i, d)];
        }
    }
    return taut_hypot(slope[0], slope[1]);
}

static double *row_of(work *w, int row)
{
    return w->a + (size_t)row * (size_t)w->n;
}

/* The rows of a held edge, and what their multipliers add to the Hessian. */
static void add_edge(work *w, int edge)
{
    const line *l = &w->lines[edge_way(edge)];
    for (int a = 0; a < l->spans; a++) {
        for (int q = 0; q < GAUSS; q++) {
            double way[2], pull = 0;
            const double speed = edge_speed(w, w->y, edge, a, q, way), weight = l->weight[a][q];
            for (int b = 0; b < DEGREE; b++) {
                const int row = w->edges[edge] + a + b;
                const double part = l->test[a][q][b] * weight;
                pull += part * w->multiplier[row];
                w->c[row] += part * (speed - w->target[edge][a * GAUSS + q]);
                for (int i = 0; i < LOCAL; i++) {
                    for (int d = 0; d < 2; d++) {
                        row_of(w, row)[edge_unknown(w, edge, a + i, d)] +=
                            part * way[d] / speed * l->slope[a][q][i];
                    }
                }
            }
            const double normal[2] = {-way[1] / speed, way[0] / speed};
            for (int x = 0; x < 2 * LOCAL; x++) {
                for (int z = 0; z <= x; z++) {
                    const int i = edge_unknown(w, edge, a + x / 2, x % 2);
                    const int k = edge_unknown(w, edge, a + z / 2, z % 2);
                    taut_band_row(&w->hessian, i)[i - k] += pull / speed * normal[x % 2] *
                                                            normal[z % 2] * l->slope[a][q][x / 2] *
                                                            l->slope[a][q][z / 2];
                }
            }
        }
    }
}

/* Of the middle of an end: the functions of t at 1/2. */
static int middle(const work *w, double value[LOCAL])
{
    const int span = taut_flat_span(w->lines[1].spans, w->lines[1].graded, 0.5);
    taut_flat_basis(w->lines[1].spans, w->lines[1].graded, DEGREE, span, 0.5, value, NULL);
    return span;
}

static void add_constraints(work *w)
{
    int row = 0;
    memset(w->a, 0, sizeof(double) * (size_t)w->room * (size_t)w->n);
    memset(w->c, 0, sizeof(double) * (size_t)w->room);
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        if (w->edges[e] >= 0) {
            add_edge(w, e);
            row = w->edges[e] + w->lines[edge_way(e)].spans + DEGREE - 1;
        }
    }
    const int last = w->lines[0].count - 1;
    if (!w->is_turning) {
        for (int k = 1; k < w->lines[1].count; k++, row++) {
            row_of(w, row)[unknown(w, last, k, 0)] = 1;
            row_of(w, row)[unknown(w, last, 0, 0)] = -1;
            w->c[row] = w->y[unknown(w, last, k, 0)] - w->y[unknown(w, last, 0, 0)];
        }
    } else {
        double value[LOCAL];
        const int span = middle(w, value);
        const double turn[2] = {-taut_sin(w->options->thread), taut_cos(w->options->thread)};
        for (int k = 0; k < LOCAL; k++) {
            for (int d = 0; d < 2; d++) {
                const int to = unknown(w, last, span + k, d), from = unknown(w, 0, span + k, d);
                row_of(w, row)[to] += turn[d] * value[k];
                row_of(w, row)[from] -= turn[d] * value[k];
                w->c[row] += turn[d] * value[k] * (w->y[to] - w->y[from]);
            }
        }
        row++;
    }
    w->rows = row;
    for (int k = 0; k < w->rows; k++) {
        for (int i = 0; i < w->n; i++) {
            if (w->pinned[i]) {
                row_of(w, k)[i] = 0;
            }
        }
    }
}

/* ---- a step ---- */

static double pin(work *w)
{
    double most = 0;
    for (int i = 0; i < w->n; i++) {
        most = fmax(most, taut_band_row(&w->hessian, i)[0]);
    }
    for (int i = 0; i < w->n; i++) {
        double *row = taut_band_row(&w->hessian, i);
        for (int d = 0; d <= w->width && d <= i; d++) {
            if (w->pinned[i] || w->pinned[i - d]) {
                row[d] = d == 0 ? most : 0;
            }
        }
        if (w->pinned[i]) {
            w->gradient[i] = 0;
        }
    }
    return most;
}

/* S x = b for a symmetric S of n rows (leading dimension ld), which is destroyed; *positive: its pivots
 * above 0. 0 where one is 0. */
static int solve_symmetric(int n, int ld, double *s, double *b, int *positive)
{
    *positive = 0;
    for (int k = 0; k < n; k++) {
        const double pivot = s[k * ld + k];
        if (!(fabs(pivot) > 0)) {
            return 0;
        }
        *positive += pivot > 0;
        for (int i = k + 1; i < n; i++) {
            const double f = s[i * ld + k] / pivot;
            for (int c = k + 1; c < n; c++) {
                s[i * ld + c] -= f * s[k * ld + c];
            }
            b[i] -= f * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int c = k + 1; c < n; c++) {
            b[k] -= s[k * ld + c] * b[c];
        }
        b[k] /= s[k * ld + k];
    }
    return 1;
}

/* The Lagrangian's gradient into w->slope; its largest entry. */
static double lagrangian(work *w)
{
    double most = 0;
    for (int i = 0; i < w->n; i++) {
        double sum = w->gradient[i];
        for (int k = 0; k < w->rows; k++) {
            sum += w->multiplier[k] * row_of(w, k)[i];
        }
        w->slope[i] = w->pinned[i] ? 0 : sum;
        most = fmax(most, fabs(w->slope[i]));
    }
    return most;
}

/* The largest of S's diagonal that the held rows have. */
static double most_of(const work *w)
{
    double most = 0;
    for (int k = 0; k < w->rows; k++) {
        most = fmax(most, w->schur[k * w->room + k]);
    }
    return most;
}

/* So many right-hand sides are carried at once, in registers; the last ones by themselves. */
enum { ABREAST = 8 };

/* Of `count` <= ABREAST of the columns, of which row i begins at x + i ld: sums in the order of the rows, as of each alone. */
static inline void solve_abreast(const taut_band *factor, int first, size_t ld, size_t count,
                                 double *x)
{
    const int n = factor->n, w = factor->width;
    for (int i = first; i < n; i++) {
        const double *row = taut_band_row(factor, i);
        double *xi = x + (size_t)i * ld, sum[ABREAST];
        const int reach = i - first < w ? i - first : w;
        for (size_t r = 0; r < count; r++) {
            sum[r] = xi[r];
        }
        for (int d = 1; d <= reach; d++) {
            const double *above = xi - (size_t)d * ld;
            for (size_t r = 0; r < count; r++) {
                sum[r] -= row[d] * above[r];
            }
        }
        for (size_t r = 0; r < count; r++) {
            xi[r] = sum[r];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        double *xi = x + (size_t)i * ld, sum[ABREAST];
        const double pivot = taut_band_row(factor, i)[0];
        for (size_t r = 0; r < count; r++) {
            sum[r] = xi[r] / pivot;
        }
        for (int d = 1; d <= w && i + d < n; d++) {
            const double l = taut_band_row(factor, i + d)[d];
            const double *below = xi + (size_t)d * ld;
            for (size_t r = 0; r < count; r++) {
                sum[r] -= l * below[r];
            }
        }
        for (size_t r = 0; r < count; r++) {
            xi[r] = sum[r];
        }
    }
}

/* The first row that is not zero: those before it stay so. */
static int first_row(int n, size_t ld, size_t count, const double *x)
{
    int i = 0;
    for (int is_zero = 1; i < n && is_zero; i += is_zero) {
        for (size_t r = 0; r < count; r++) {
            is_zero &= x[(size_t)i * ld + r] == 0;
        }
    }
    return i;
}

/* As taut_band_solve, bit for bit, which reads and writes every column once a row of the band. */
static void solve_columns(const taut_band *factor, int count, taut_pulse *pulse, double *x)
{
    const size_t ld = (size_t)count;
    const double of_each = 4.0 * factor->n * factor->width;
    size_t r = 0;
    for (; r + ABREAST <= ld && !taut_pulse_beat(pulse, ABREAST * of_each); r += ABREAST) {
        solve_abreast(factor, first_row(factor->n, ld, ABREAST, x + r), ld, ABREAST, x + r);
    }
    for (; r < ld && !taut_pulse_beat(pulse, of_each); r++) {
        solve_abreast(factor, first_row(factor->n, ld, 1, x + r), ld, 1, x + r);
    }
}

/* The factor of the Hessian with `shift` on its diagonal; where rotation is free a stiffness `hold` on
 * one unknown, which the last row takes off again. 1: solved, step and multipliers are there, and the Hessian is positive
 * on the constraints. */
static int try_step(work *w, const double *matrix, double shift, double hold, int held)
{
    const size_t n = (size_t)w->n;
    const int rows = w->rows + w->is_turning, columns = rows + 1;
    int negative = 0, positive = 0;

    memcpy(w->hessian.a, matrix, n * ((size_t)w->width + 1) * sizeof *matrix);
    for (int i = 0; i < w->n; i++) {
        taut_band_row(&w->hessian, i)[0] += shift;
    }
    if (w->is_turning) {
        taut_band_row(&w->hessian, held)[0] += hold;
        memset(row_of(w, w->rows), 0, n * sizeof(double));
        row_of(w, w->rows)[held] = 1;
        w->c[w->rows] = 0;
    }
    if (taut_band_factor_signed(&w->hessian, &negative, w->options->pulse) != TAUT_OK) {
        return 0;
    }
    for (int i = 0; i < w->n; i++) {
        for (int k = 0; k < rows; k++) {
            w->solved[i * columns + k] = row_of(w, k)[i];
        }
        w->solved[i * columns + rows] = -w->slope[i];
    }
    solve_columns(&w->hessian, columns, w->options->pulse, w->solved);
    if (taut_pulse_is_stopped(w->options->pulse)) {
        return 0;
    }
    memset(w->schur, 0, sizeof(double) * (size_t)w->room * (size_t)w->room);
    for (int k = 0; k < rows; k++) {
        const double *a = row_of(w, k);
        double right = w->c[k];
        for (int i = 0; i < w->n; i++) {
            if (a[i] != 0) {
                const double *x = w->solved + (size_t)i * (size_t)columns;
                for (int m = 0; m < rows; m++) {
                    w->schur[k * w->room + m] += a[i] * x[m];
                }
                right += a[i] * x[rows];
            }
        }
        w->step[k] = right; /* the multipliers, for now */
    }
    const double slack = dependent * most_of(w);
    for (int k = 0; k < w->rows; k++) {
        w->schur[k * w->room + k] += slack;
    }
    if (w->is_turning) {
        w->schur[w->rows * w->room + w->rows] -= 1 / hold;
    }
    if (!solve_symmetric(rows, w->room, w->schur, w->step, &positive) ||
        negative + positive != w->rows) {
        return 0;
    }
    memcpy(w->change, w->step, sizeof(double) * (size_t)rows);
    for (int k = 0; k < w->rows; k++) {
        w->multiplier[k] += w->change[k];
    }
    for (int i = 0; i < w->n; i++) {
        const double *x = w->solved + (size_t)i * (size_t)columns;
        double sum = x[rows];
        for (int m = 0; m < rows; m++) {
            sum -= x[m] * w->change[m];
        }
        w->step[i] = sum;
    }
    return 1;
}

/* One step; *length: over the size. 0 where there is none. */
static int newton_step(work *w, double *matrix, double *trial, double *length)
{
    /* a corner that a turn moves: across the thread, along which the corner that is pinned lies */
    const double thread = w->options->thread;
    const int across = fabs(taut_cos(thread)) >= fabs(taut_sin(thread));
    const int held = unknown(w, w->options->is_point[1] ? 0 : w->lines[0].count - 1, 0, across);
    double most = 0, part = 1, shift = 0;
    int done = 0;

    assemble(w);
    add_constraints(w);
    const double diagonal = pin(w);
    w->residual = lagrangian(w) / (diagonal * w->size);
    memcpy(matrix, w->hessian.a, sizeof *matrix * (size_t)w->n * ((size_t)w->width + 1));
    for (int k = 0; !done && k < SHIFTS_MAX && !taut_pulse_is_stopped(w->options->pulse); k++) {
        done = try_step(w, matrix, shift, diagonal, held);
        w->is_stable = done && shift == 0;
        if (done && shift > 0) {
            w->shift = shift;
        }
        shift = shift > 0 ? 4 * shift : fmax(1e-8 * diagonal, w->shift / 16);
    }
    if (!done) {
        return 0;
    }
    for (int i = 0; i < w->n; i++) {
        most = fmax(most, fabs(w->step[i]));
    }
    const int is_free = w->rows == 1;
    for (int k = 0; k < HALVINGS_MAX; k++, part /= 2) {
        for (int i = 0; i < w->n; i++) {
            trial[i] = w->y[i] + part * w->step[i];
        }
        const double energy = energy_of(w, trial);
        /* with nothing held it must fall, but for what rounding does near the end */
        if (energy < INFINITY && (!is_free || k > 20 || energy <= w->energy * (1 + 1e-9) + 1e-30 ||
                                  most < 1e-6 * w->size)) {
            memcpy(w->y, trial, sizeof *trial * (size_t)w->n);
            w->energy = energy;
            *length = part * most / w->size;
            w->steps++;
            return 1;
        }
    }
    return 0;
}

/* Stationary, from w->y; 0 where it is not reached. */
static int newton(work *w, double *matrix, double *trial)
{
    double length = INFINITY, before;
    const int steps = w->lines[0].spans > FINEST ? FINEST_STEPS : STEPS_MAX;
    w->energy = energy_of(w, w->y);
    w->shift = 0;
    memset(w->multiplier, 0, sizeof(double) * (size_t)w->room);
    for (int k = 0; k < steps && w->energy < INFINITY; k++) {
        before = length;
        if (!newton_step(w, matrix, trial, &length)) {
            return 0;
        }
        /* lengths end by their squares: this is what the next one would be */
        const double next = length * length * length / (before * before);
        if (k > 0 && (before < small_step || (length < small_step && next < rounding))) {
            return w->is_stable;
        }
    }
    return 0;
}

/* ---- the start ---- */

/* The geodesic curvature of the axis, by differences of the metric: a start needs no more. */
static double axis_bend(const work *w, double s)
{
    const double h = 1e-4, at = fmin(fmax(s, h), 1 - h);
    double g[3], a[3], b[3], c[3], d[3];
    w->strip->metric(w->strip->context, at, 0.5, g);
    w->strip->metric(w->strip->context, at - h, 0.5, a);
    w->strip->metric(w->strip->context, at + h, 0.5, b);
    w->strip->metric(w->strip->context, at, 0.5 - h, c);
    w->strip->metric(w->strip->context, at, 0.5 + h, d);
    const double ss = (b[0] - a[0]) / (2 * h), sm = (b[1] - a[1]) / (2 * h);
    const double st = (d[0] - c[0]) / (2 * h);
    const double det = g[0] * g[2] - g[1] * g[1];
    return (g[0] * (sm - st / 2) - g[1] * ss / 2) / (sqrt(det) * g[0]); /* times the speed */
}

/* A x = b by elimination with row exchanges; a [n][n], b [n][columns]. */
static void solve_dense(int n, double *a, int columns, double *b)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++) {
            best = fabs(a[i * n + k]) > fabs(a[best * n + k]) ? i : best;
        }
        for (int c = 0; c < n; c++) {
            const double x = a[k * n + c];
            a[k * n + c] = a[best * n + c];
            a[best * n + c] = x;
        }
        for (int c = 0; c < columns; c++) {
            const double x = b[k * columns + c];
            b[k * columns + c] = b[best * columns + c];
            b[best * columns + c] = x;
        }
        for (int i = 0; i < n; i++) {
            if (i != k) {
                const double f = a[i * n + k] / a[k * n + k];
                for (int c = k; c < n; c++) {
                    a[i * n + c] -= f * a[k * n + c];
                }
                for (int c = 0; c < columns; c++) {
                    b[i * columns + c] -= f * b[k * columns + c];
                }
            }
        }
    }
    for (int k = 0; k < n; k++) {
        for (int c = 0; c < columns; c++) {
            b[k * columns + c] /= a[k * n + k];
        }
    }
}

double taut_flat_greville(int spans, int graded, int i)
{
    double sum = 0;
    for (int k = 1; k <= DEGREE; k++) {
        sum += taut_flat_knot(spans, graded, i + k);
    }
    return sum / DEGREE;
}

/* The matrix of a direction's functions at the Greville points. */
static void collocation(int spans, int graded, double *a)
{
    const int n = spans + DEGREE;
    memset(a, 0, sizeof *a * (size_t)n * (size_t)n);
    for (int i = 0; i < n; i++) {
        const double x = taut_flat_greville(spans, graded, i);
        const int span = taut_flat_span(spans, graded, x);
        taut_flat_basis(spans, graded, DEGREE, span, x, a + i * n + span, NULL);
    }
}

/* Adds one stretch of the axis by Simpson's rule: place and angle. */
static void walk_axis(const work *w, double from, double to, double place[2], double *angle)
{
    const double h = to - from, mid = from + h / 2;
    double g[3], speed[3], theta[3];
    const double at[3] = {from, mid, to};
    const double b0 = axis_bend(w, from), b1 = axis_bend(w, mid), b2 = axis_bend(w, to);
    theta[0] = *angle;
    theta[1] = *angle + h / 24 * (5 * b0 + 8 * b1 - b2);
    theta[2] = *angle + h / 6 * (b0 + 4 * b1 + b2);
    for (int k = 0; k < 3; k++) {
        w->strip->metric(w->strip->context, at[k], 0.5, g);
        speed[k] = sqrt(g[0]);
    }
    place[0] += h / 6 *
                (speed[0] * taut_cos(theta[0]) + 4 * speed[1] * taut_cos(theta[1]) +
                 speed[2] * taut_cos(theta[2]));
    place[1] += h / 6 *
                (speed[0] * taut_sin(theta[0]) + 4 * speed[1] * taut_sin(theta[1]) +
                 speed[2] * taut_sin(theta[2]));
    *angle = theta[2];
}

/* The length of a cross line from the axis to t, with its sign. */
static double cross_length(const work *w, double s, double t)
{
    double node[GAUSS], weight[GAUSS], g[3], sum = 0;
    taut_gauss_rule(GAUSS, node, weight);
    for (int q = 0; q < GAUSS; q++) {
        w->strip->metric(w->strip->context, s, 0.5 + (t - 0.5) * (1 + node[q]) / 2, g);
        sum += weight[q] / 2 * sqrt(g[2]);
    }
    return sum * (t - 0.5);
}

/* Ends that are one place up to rounding. */
static void close_points(work *w)
{
    const int last = w->lines[0].count - 1;
    for (int end = 0; end < 2; end++) {
        for (int k = 1; w->options->is_point[end] && k < w->lines[1].count; k++) {
            for (int d = 0; d < 2; d++) {
                w->y[unknown(w, end * last, k, d)] = w->y[unknown(w, end * last, 0, d)];
            }
        }
    }
}

static void turn_start(work *w)
{
    double value[LOCAL], from[2] = {0, 0}, to[2] = {0, 0};
    const int span = middle(w, value), last = w->lines[0].count - 1;
    for (int k = 0; k < LOCAL; k++) {
        for (int d = 0; d < 2; d++) {
            from[d] += value[k] * w->y[unknown(w, 0, span + k, d)];
            to[d] += value[k] * w->y[unknown(w, last, span + k, d)];
        }
    }
    const double thread = w->options->thread; /* of the chord once it is made smaller */
    const double angle =
        taut_atan2(taut_sin(thread) / w->stretch[1], taut_cos(thread) / w->stretch[0]) -
        taut_atan2(to[1] - from[1], to[0] - from[0]);
    w->size = taut_hypot(to[0] - from[0], to[1] - from[1]);
    for (int i = 0; i < w->n; i += 2) {
        const double x = w->y[i] - from[0], y = w->y[i + 1] - from[1];
        w->y[i] = (taut_cos(angle) * x - taut_sin(angle) * y) * w->stretch[0];
        w->y[i + 1] = (taut_sin(angle) * x + taut_cos(angle) * y) * w->stretch[1];
        w->size = fmax(w->size, fmax(fabs(w->y[i]), fabs(w->y[i + 1])));
    }
    close_points(w);
    if (!w->is_turning) {
        const double end = w->y[unknown(w, last, 0, 0)];
        double mean = 0;
        for (int k = 0; k <= w->lines[1].count - 1; k++) {
            w->y[unknown(w, 0, k, 0)] = 0;
            mean += (w->y[unknown(w, last, k, 0)] - end) / w->lines[1].count;
        }
        for (int k = 0; k < w->lines[1].count; k++) {
            w->y[unknown(w, last, k, 0)] = end + mean;
        }
    }
}

/* From places at the Greville points, y [count][count][2], to the net through them. */
static taut_status pass_through(taut_arena *arena, const int spans[2], int graded, double *y)
{
    const int ns = spans[0] + DEGREE, nt = spans[1] + DEGREE, most = ns > nt ? ns : nt;
    const size_t count = (size_t)ns * (size_t)nt;
    double *a = taut_arena_take(arena, (size_t)most * (size_t)most, sizeof *a);
    double *swapped = taut_arena_take(arena, count, 2 * sizeof *swapped);

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    collocation(spans[0], graded, a);
    solve_dense(ns, a, 2 * nt, y);
    for (int i = 0; i < ns; i++) {
        for (int j = 0; j < nt; j++) {
            memcpy(swapped + (j * ns + i) * 2, y + (i * nt + j) * 2, 2 * sizeof *y);
        }
    }
    collocation(spans[1], graded, a);
    solve_dense(nt, a, 2 * ns, swapped);
    for (int i = 0; i < ns; i++) {
        for (int j = 0; j < nt; j++) {
            memcpy(y + (i * nt + j) * 2, swapped + (j * ns + i) * 2, 2 * sizeof *y);
        }
    }
    return TAUT_OK;
}

/* The places in w->y as a net, turned and made smaller. */
static taut_status interpolate(work *w)
{
    const int spans[2] = {w->lines[0].spans, w->lines[1].spans};
    const taut_status status = pass_through(w->arena, spans, w->options->graded, w->y);
    if (status == TAUT_OK) {
        turn_start(w);
    }
    return status;
}

static taut_status unroll(work *w)
{
    enum { STOPS = 16 };
    const int ns = w->lines[0].count, nt = w->lines[1].count;
    double place[2] = {0, 0}, angle = 0, before = 0;

    for (int i = 0; i < ns; i++) {
        const double s = taut_flat_greville(w->lines[0].spans, w->lines[0].graded, i);
        double g[3];
        for (int k = 0; i > 0 && k < STOPS; k++) {
            walk_axis(w, before + (s - before) * k / STOPS, before + (s - before) * (k + 1) / STOPS,
                      place, &angle);
        }
        before = s;
        w->strip->metric(w->strip->context, s, 0.5, g);
        /* at a point rounding may leave less than nothing */
        const double turn = angle + taut_atan2(sqrt(fmax(g[0] * g[2] - g[1] * g[1], 0)), g[1]);
        for (int j = 0; j < nt; j++) {
            const double reach =
                cross_length(w, s, taut_flat_greville(w->lines[1].spans, w->lines[1].graded, j));
            w->y[unknown(w, i, j, 0)] = place[0] + reach * taut_cos(turn);
            w->y[unknown(w, i, j, 1)] = place[1] + reach * taut_sin(turn);
        }
    }
    return interpolate(w);
}

/* ---- from the default law and natural lengths to what is asked for ---- */

static void set_share(work *w, double share, int is_law)
{
    static const taut_flat_law *const from = &default_law;
    if (is_law) {
        const taut_flat_law *to = w->options->law;
        w->law = (taut_flat_law){
            from->d11 + share * (to->d11 - from->d11), from->d22 + share * (to->d22 - from->d22),
            from->d12 + share * (to->d12 - from->d12), from->d33 + share * (to->d33 - from->d33)};
        return;
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const line *l = &w->lines[edge_way(e)];
        for (int k = 0; w->options->held[e] != NULL && k < l->spans * GAUSS; k++) {
            w->target[e][k] = w->length[e][k] * taut_pow(w->natural[e][k], 1 - share) *
                              taut_pow(w->options->held[e][k], share);
        }
    }
}

/* At once, or in steps of a quarter, halved where one fails and raised by half where it does not. */
static int go(work *w, int is_law, double *matrix, double *trial, double *kept)
{
    double share = 0, step = 1;
    while (share < 1) {
        const double next = fmin(1, share + step);
        memcpy(kept, w->y, sizeof *kept * (size_t)w->n);
        set_share(w, next, is_law);
        if (newton(w, matrix, trial)) {
            share = next;
            step *= 1.5;
            continue;
        }
        memcpy(w->y, kept, sizeof *kept * (size_t)w->n);
        if (!is_law && w->lines[0].spans > FINE) {
            return 0; /* what coarse splines hide shows: the cloth gives way at what is held */
        }
        step = step == 1 ? 0.25 : step / 2;
        if (step < 1.0 / LEAST_STEP) {
            return 0;
        }
    }
    return 1;
}

static taut_status solve(work *w, const taut_flat *from)
{
    const size_t n = (size_t)w->n;
    double *matrix = taut_arena_take_raw(w->arena, n * ((size_t)w->width + 1), sizeof *matrix);
    double *trial = taut_arena_take(w->arena, n, sizeof *trial);
    double *kept = taut_arena_take(w->arena, n, sizeof *kept);
    double slope[2];
    int first[TAUT_FLAT_EDGES], is_held = 0;

    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        first[e] = w->edges[e];
        is_held = is_held || first[e] >= 0;
        w->edges[e] = -1;
    }
    if (from != NULL) {
        memcpy(w->y, from->points, n * sizeof *w->y);
        close_points(w);
        for (size_t i = 0; i < n; i++) {
            w->size = fmax(w->size, fabs(w->y[i]));
        }
        w->law = w->options->law != NULL ? *w->options->law : default_law;
    } else {
        if (unroll(w) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        w->law = default_law;
        if (!newton(w, matrix, trial) ||
            (w->options->law != NULL && !go(w, 1, matrix, trial, kept))) {
            return TAUT_NOT_CONVERGED;
        }
    }
    if (!is_held) {
        return from == NULL || newton(w, matrix, trial) ? TAUT_OK : TAUT_NOT_CONVERGED;
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const line *l = &w->lines[edge_way(e)];
        w->edges[e] = first[e];
        for (int k = 0; first[e] >= 0 && k < l->spans * GAUSS; k++) {
            w->natural[e][k] =
                edge_speed(w, w->y, e, k / GAUSS, k % GAUSS, slope) / w->length[e][k];
        }
    }
    return go(w, 0, matrix, trial, kept) ? TAUT_OK : TAUT_NOT_CONVERGED;
}

/* ---- the call ---- */

static void edge_place(int edge, double x, double at[2])
{
    at[0] = edge == TAUT_FLAT_START ? 0 : edge == TAUT_FLAT_END ? 1 : x;
    at[1] = edge == TAUT_FLAT_RIGHT ? 0 : edge == TAUT_FLAT_LEFT ? 1 : x;
}

static double speed_in_space(const taut_flat_strip *strip, int edge, double x)
{
    double at[2], g[3];
    edge_place(edge, x, at);
    strip->metric(strip->context, at[0], at[1], g);
    return sqrt(edge_way(edge) ? g[2] : g[0]);
}

static taut_status prepare(work *w)
{
    const taut_flat_options *o = w->options;
    const int spans[2] = {o->spans[0] > 0 ? o->spans[0] : 16, o->spans[1] > 0 ? o->spans[1] : 4};
    int rows = 2;

    for (int d = 0; d < 2; d++) {
        if (!taut_flat_line_fill(w->arena, spans[d], o->graded, &w->lines[d])) {
            return TAUT_NO_MEMORY;
        }
    }
    w->is_turning = !o->straight;
    w->n = 2 * w->lines[0].count * w->lines[1].count;
    w->width = 2 * (DEGREE * w->lines[1].count + DEGREE) + 1;
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const size_t places = (size_t)w->lines[edge_way(e)].spans * GAUSS;
        w->edges[e] = -1;
        if (o->held[e] != NULL) {
            w->edges[e] = rows - 2;
            rows += w->lines[edge_way(e)].spans + DEGREE - 1;
            w->length[e] = taut_arena_take(w->arena, places, sizeof(double));
            w->target[e] = taut_arena_take(w->arena, places, sizeof(double));
            w->natural[e] = taut_arena_take(w->arena, places, sizeof(double));
        }
    }
    w->room = rows + (o->straight ? w->lines[1].count : 0);
    const size_t n = (size_t)w->n, room = (size_t)w->room;
    const size_t across = (size_t)spans[1] * GAUSS;
    w->metric = taut_arena_take(w->arena, (size_t)spans[0] * GAUSS * across, sizeof(double[3]));
    w->shrink =
        w->strip->shrink != NULL
            ? taut_arena_take(w->arena, (size_t)spans[0] * GAUSS * across, sizeof(double[2]))
            : NULL;
    w->j = taut_arena_take(w->arena, across, sizeof *w->j);
    w->forms = taut_arena_take(w->arena, across, sizeof *w->forms);
    w->is_there = taut_arena_take(w->arena, across, 1);
    w->y = taut_arena_take(w->arena, n, sizeof(double));
    w->step = taut_arena_take(w->arena, n + room, sizeof(double));
    w->gradient = taut_arena_take(w->arena, n, sizeof(double));
    w->slope = taut_arena_take(w->arena, n, sizeof(double));
    w->change = taut_arena_take(w->arena, room, sizeof(double));
    w->pinned = taut_arena_take(w->arena, n, 1);
    w->hessian = (taut_band){w->n, w->width,
                             taut_arena_take(w->arena, n * ((size_t)w->width + 1), sizeof(double))};
    w->a = taut_arena_take(w->arena, room * n, sizeof(double));
    w->solved = taut_arena_take(w->arena, (room + 1) * n, sizeof(double));
    w->c = taut_arena_take(w->arena, room, sizeof(double));
    w->multiplier = taut_arena_take(w->arena, room, sizeof(double));
    w->schur = taut_arena_take(w->arena, room * room, sizeof(double));
    if (!taut_flat_sums_new(w->arena, &w->lines[0], &w->lines[1], &w->sums) ||
        taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; o->straight && k < w->lines[1].count; k++) {
        w->pinned[unknown(w, 0, k, 0)] = 1;
    }
    const int fixed = o->is_point[1] ? w->lines[0].count - 1 : 0;
    for (int k = 0; k < (o->is_point[0] || o->is_point[1] ? w->lines[1].count : 1); k++) {
        w->pinned[unknown(w, fixed, k, 0)] = w->pinned[unknown(w, fixed, k, 1)] = 1;
    }
    w->stretch[0] = 1 - o->warp;
    w->stretch[1] = 1 - o->weft;
    return TAUT_OK;
}

static double sample(work *w)
{
    const line *s = &w->lines[0], *t = &w->lines[1];
    double area = 0;
    for (int k = 0; k < s->spans * GAUSS &&
                    !taut_pulse_beat(w->options->pulse, t->spans * GAUSS * work_of_metric);
         k++) {
        double *g = metric_along(w, k / GAUSS, k % GAUSS);
        for (int m = 0; m < t->spans * GAUSS; m++, g += 3) {
            w->strip->metric(w->strip->context, s->at[k / GAUSS][k % GAUSS],
                             t->at[m / GAUSS][m % GAUSS], g);
            area += sqrt(g[0] * g[2] - g[1] * g[1]) * s->weight[k / GAUSS][k % GAUSS] *
                    t->weight[m / GAUSS][m % GAUSS];
            if (w->shrink != NULL) {
                w->strip->shrink(
                    w->strip->context, s->at[k / GAUSS][k % GAUSS], t->at[m / GAUSS][m % GAUSS],
                    w->shrink + 2 * ((size_t)k * (size_t)(t->spans * GAUSS) + (size_t)m));
            }
        }
    }
    for (int e = 0; e < TAUT_FLAT_EDGES; e++) {
        const line *l = &w->lines[edge_way(e)];
        for (int k = 0; w->edges[e] >= 0 && k < l->spans * GAUSS; k++) {
            w->length[e][k] = speed_in_space(w->strip, e, l->at[k / GAUSS][k % GAUSS]);
        }
    }
    return area;
}

static double flat_area(work *w)
{
    const line *s = &w->lines[0], *t = &w->lines[1];
    double sum = 0;
    for (int k = 0; k < s->spans * GAUSS; k++) {
        taut_flat_sums_slopes(&w->sums, w->y, k / GAUSS, k % GAUSS, w->j);
        for (int m = 0; m < t->spans * GAUSS; m++) {
            const double(*j)[2] = (const double(*)[2])w->j[m];
            sum += (j[0][0] * j[1][1] - j[0][1] * j[1][0]) * s->weight[k / GAUSS][k % GAUSS] *
                   t->weight[m / GAUSS][m % GAUSS];
        }
    }
    return sum;
}

/* The middle of `start` into the origin. */
static void place_origin(work *w)
{
    double value[LOCAL], from[2] = {0, 0};
    const int span = middle(w, value);
    for (int k = 0; k < LOCAL; k++) {
        for (int d = 0; d < 2; d++) {
            from[d] += value[k] * w->y[unknown(w, 0, span + k, d)];
        }
    }
    for (int i = 0; i < w->n; i++) {
        w->y[i] -= from[i % 2];
    }
}

static taut_status finish(work *w, double area, taut_flat *flat)
{
    place_origin(w);
    *flat = (taut_flat){.spans = {w->lines[0].spans, w->lines[1].spans},
                        .graded = w->options->graded,
                        .count = {w->lines[0].count, w->lines[1].count},
                        .points = w->y,
                        .law = w->law,
                        .warp = w->options->warp,
                        .weft = w->options->weft,
                        .energy = w->energy,
                        .area = area,
                        .flat_area = flat_area(w),
                        .residual = w->residual,
                        .is_stable = w->is_stable,
                        .steps = w->steps,
                        .torque = w->is_turning && w->rows > 0 ? w->multiplier[w->rows - 1] : 0};
    for (int d = 0; d < 2; d++) {
        flat->knots[d] = taut_arena_take(w->arena, (size_t)flat->count[d] + LOCAL, sizeof(double));
        for (int k = 0; flat->knots[d] != NULL && k < flat->count[d] + LOCAL; k++) {
            flat->knots[d][k] = taut_flat_knot(flat->spans[d], flat->graded, k);
        }
    }
    return taut_arena_status(w->arena) == TAUT_OK ? TAUT_OK : TAUT_NO_MEMORY;
}

taut_status taut_flatten(taut_arena *arena, const taut_flat_strip *strip,
                         const taut_flat_options *options, const taut_flat *from, taut_flat *flat)
{
    work w = {.arena = arena, .strip = strip, .options = options};
    taut_status status = prepare(&w);

    if (status != TAUT_OK) {
        return status;
    }
    const double area = sample(&w);
    status = solve(&w, from);
    if (taut_pulse_is_stopped(options->pulse)) {
        status = TAUT_INTERRUPTED;
    }
    if (status != TAUT_OK) {
        *flat = (taut_flat){.energy = w.energy, .steps = w.steps};
        return status;
    }
    return finish(&w, area, flat);
}

taut_status taut_flat_of_places(taut_arena *arena, const taut_flat_strip *strip,
                                const taut_flat_options *options, const double *places,
                                taut_flat *flat)
{
    work w = {.arena = arena, .strip = strip, .options = options};
    taut_status status = prepare(&w);

    if (status != TAUT_OK) {
        return status;
    }
    const double area = sample(&w);
    memcpy(w.y, places, (size_t)w.n * sizeof *places);
    w.law = options->law != NULL ? *options->law : default_law;
    status = interpolate(&w);
    if (status != TAUT_OK) {
        return status;
    }
    w.energy = energy_of(&w, w.y);
    w.is_stable = 1;
    return finish(&w, area, flat);
}

taut_status taut_flat_halve(taut_arena *arena, const taut_flat *from, taut_flat *to)
{
    *to = *from;
    for (int d = 0; d < 2; d++) {
        to->spans[d] = 2 * from->spans[d];
        to->count[d] = to->spans[d] + DEGREE;
        to->knots[d] = NULL;
    }
    to->points =
        taut_arena_take(arena, (size_t)to->count[0] * (size_t)to->count[1], 2 * sizeof(double));
    for (int k = 0; to->points != NULL && k < to->count[0] * to->count[1]; k++) {
        double y[3][2];
        taut_flat_at(from, taut_flat_greville(to->spans[0], to->graded, k / to->count[1]),
                     taut_flat_greville(to->spans[1], to->graded, k % to->count[1]), y);
        memcpy(to->points + 2 * k, y[0], sizeof y[0]);
    }
    return to->points != NULL ? pass_through(arena, to->spans, to->graded, to->points)
                              : TAUT_NO_MEMORY;
}

taut_status taut_flat_copy(taut_arena *arena, const taut_flat *from, taut_flat *to)
{
    const size_t count[2] = {(size_t)from->count[0], (size_t)from->count[1]};
    *to = *from;
    to->points = taut_arena_copy(arena, from->points, 2 * count[0] * count[1], sizeof(double));
    for (int d = 0; d < 2; d++) {
        to->knots[d] = taut_arena_copy(arena, from->knots[d], count[d] + LOCAL, sizeof(double));
    }
    return taut_arena_status(arena);
}

void taut_flat_at(const taut_flat *flat, double s, double t, double y[3][2])
{
    double value[2][LOCAL], slope[2][LOCAL];
    const int a = taut_flat_span(flat->spans[0], flat->graded, s),
              b = taut_flat_span(flat->spans[1], flat->graded, t);
    taut_flat_basis(flat->spans[0], flat->graded, DEGREE, a, s, value[0], slope[0]);
    taut_flat_basis(flat->spans[1], flat->graded, DEGREE, b, t, value[1], slope[1]);
    memset(y, 0, sizeof(double[3][2]));
    for (int i = 0; i < LOCAL; i++) {
        for (int j = 0; j < LOCAL; j++) {
            const double *p = flat->points + ((a + i) * flat->count[1] + b + j) * 2;
            for (int d = 0; d < 2; d++) {
                y[0][d] += value[0][i] * value[1][j] * p[d];
                y[1][d] += slope[0][i] * value[1][j] * p[d];
                y[2][d] += value[0][i] * slope[1][j] * p[d];
            }
        }
    }
}

void taut_flat_strain(const double shrink[2], const double g[3], const double y[3][2],
                      double strain[2], double cloth[3])
{
    const double j[2][2] = {{y[1][0], y[2][0]}, {y[1][1], y[2][1]}};
    double inverse[2][2], det, c[3] = {0, 0, 0};
    strain[0] = strain[1] = NAN;
    if (taut_flat_stretch(j, g, inverse, &det, c)) {
        const double p = shrink[0], q = shrink[1];
        const double a = c[0] * p * p, b = c[1] * q * q, m = c[2] * p * q;
        const double half = (a + b) / 2, radius = taut_hypot((a - b) / 2, m);
        strain[0] = sqrt(half + radius) - 1;
        strain[1] = sqrt(half - radius) - 1;
        if (cloth != NULL) {
            cloth[0] = sqrt(a) - 1;
            cloth[1] = sqrt(b) - 1;
            cloth[2] = taut_atan2(m, sqrt(a * b - m * m));
        }
    }
}

double taut_flat_edge_length(const taut_flat *flat, const taut_flat_strip *strip,
                             taut_flat_edge edge, double *stretch)
{
    const int e = (int)edge, d = edge_way(e), spans = flat->spans[d];
    double node[GAUSS], weight[GAUSS], sum = 0;
    taut_gauss_rule(GAUSS, node, weight);
    for (int k = 0; k < spans * GAUSS; k++) {
        const double x = taut_flat_place(spans, flat->graded, k / GAUSS, node[k % GAUSS]);
        double y[3][2], at[2];
        edge_place(e, x, at);
        taut_flat_at(flat, at[0], at[1], y);
        const double speed = taut_hypot(y[1 + d][0], y[1 + d][1]);
        sum += speed * weight[k % GAUSS] * taut_flat_half(spans, flat->graded, k / GAUSS);
        if (stretch != NULL) {
            stretch[k] = speed / speed_in_space(strip, e, x);
        }
    }
    return sum;
}

void taut_flat_measure(const taut_flat_strip *strip, taut_flat *flat)
{
    double node[GAUSS], weight[GAUSS];
    const double all[2] = {1 - flat->warp, 1 - flat->weft};
    const int count[2] = {flat->spans[0] * GAUSS, flat->spans[1] * GAUSS};
    taut_gauss_rule(GAUSS, node, weight);
    flat->area = flat->energy = 0;
    for (int k = 0; k < count[0] * count[1]; k++) {
        const int m = k / count[1], n = k % count[1];
        const double s = taut_flat_place(flat->spans[0], flat->graded, m / GAUSS, node[m % GAUSS]),
                     t = taut_flat_place(flat->spans[1], flat->graded, n / GAUSS, node[n % GAUSS]);
        const double part =
            weight[m % GAUSS] * taut_flat_half(flat->spans[0], flat->graded, m / GAUSS) *
            weight[n % GAUSS] * taut_flat_half(flat->spans[1], flat->graded, n / GAUSS);
        double y[3][2], g[3], shrink[2] = {all[0], all[1]};
        taut_flat_form f = {.w = 0};
        taut_flat_at(flat, s, t, y);
        strip->metric(strip->context, s, t, g);
        if (strip->shrink != NULL) {
            strip->shrink(strip->context, s, t, shrink);
        }
        const double j[2][2] = {{y[1][0], y[2][0]}, {y[1][1], y[2][1]}};
        taut_flat_density(&flat->law, shrink, j, g, 0, &f);
        flat->area += part * sqrt(g[0] * g[2] - g[1] * g[1]);
        flat->energy += part * f.w;
    }
}
