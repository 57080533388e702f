/* energy.c
 *
 * With S = D : E, F0 = diag(f) and J' = H J (H any), the density w = phi det F0 det J has
 *
 *     dw = tr(Sigma H),    Sigma = det F0 det J (phi 1 - F0^-1 S F0^-1 C)
 *
 * the tensor of Eshelby, as C' = -(H^T C + C H); and once more,
 *
 *     d2w (H, K) = tr K tr(Sigma H) + tr(Sigma_K H) - tr(Sigma H K),
 *     Sigma_K = det F0 det J (phi_K 1 - F0^-1 S_K F0^-1 C - F0^-1 S F0^-1 C_K)
 *
 * [LinhardWuechnerBletzinger2008]. A function N that moves y_d has H = e_d (J^-T grad N)^T. Held edges: rows int N_a y_s/|y_s| . dy_s of
 * splines of one degree less, multipliers by least squares.
 */
#include "certify/pattern/energy.h"

#include "certify/common/verdict.h"
#include "certify/pattern/gauss_bonnet.h"
#include "certify/pattern/skyline.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"
#include "measure/curvature/spot.h"
#include "numeric/quadrature.h"
#include "taut/measure.h"

#include <string.h>

enum {
    P = 5,
    ALIVE = P + 1,
    NODES = 6,
    CELL = ALIVE * ALIVE,
    GRID = 4 /* places a span */,
    TURNS = 24
};
/* The stiffness of what may not move, over the largest of the diagonal. */
static const double stiff = 1e4;
static const double corner = 0.05;
/* Two values of iint K dA that are not one. */
static const double uneven = 1e-4;
/* Operations, about: of a cell between knots without its Hessian and with it, and of a place on the grid. */
static const double work_of_cell[2] = {2e5, 6e5}, work_of_place = 5e3;

/* ---- bases at places of quadrature ---- */

typedef struct line {
    int spans, count;
    const taut_basis *basis;
    const double *breaks;
    double (*value)[NODES][ALIVE], (*slope)[NODES][ALIVE], (*test)[NODES][P];
    double node[NODES], weight[NODES];
    taut_basis *lower; /* of one degree less */
} line;

static taut_status fill_line(taut_arena *arena, const taut_basis *basis, line *l)
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    *l = (line){.spans = taut_basis_span_count(basis),
                .count = taut_basis_count(basis),
                .basis = basis,
                .breaks = taut_basis_breaks(basis)};
    const size_t n = (size_t)l->spans;
    l->value = taut_arena_take(arena, n, sizeof *l->value);
    l->slope = taut_arena_take(arena, n, sizeof *l->slope);
    l->test = taut_arena_take(arena, n, sizeof *l->test);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    spec.degree = P - 1;
    spec.knots++;
    spec.knot_count -= 2;
    taut_status status = taut_basis_new(&spec, l->count - 1, &l->lower, NULL);
    taut_gauss_rule(NODES, l->node, l->weight);
    for (int k = 0; status == TAUT_OK && k < l->spans; k++) {
        for (int q = 0; q < NODES; q++) {
            double both[2][ALIVE];
            const double t =
                l->breaks[k] + (l->breaks[k + 1] - l->breaks[k]) * (1 + l->node[q]) / 2;
            taut_basis_eval(basis, k, t, 1, both[0]);
            memcpy(l->value[k][q], both[0], sizeof both[0]);
            memcpy(l->slope[k][q], both[1], sizeof both[1]);
            taut_basis_eval(l->lower, k, t, 0, l->test[k][q]);
        }
    }
    taut_basis_free(l->lower);
    l->lower = NULL;
    return status == TAUT_OK ? TAUT_OK : TAUT_NO_MEMORY;
}

static double place_of(const line *l, int span, int q)
{
    return l->breaks[span] + (l->breaks[span + 1] - l->breaks[span]) * (1 + l->node[q]) / 2;
}

static double weight_of(const line *l, int span, int q)
{
    return l->weight[q] * (l->breaks[span + 1] - l->breaks[span]) / 2;
}

/* ---- the density ---- */

typedef double matrix[2][2];

static void multiply(const matrix a, const matrix b, matrix out)
{
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            out[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k];
        }
    }
}

typedef struct density {
    matrix inverse, c, sigma;
    double f[2]; /* of F0 */
    double det, phi;
    matrix stress; /* F0^-1 S F0^-1 */
} density;

/* F0^-1 (D : e) F0^-1, e the strain. */
static void stress_of(const double law[4], const double f[2], const matrix e, matrix out)
{
    out[0][0] = (law[0] * e[0][0] + law[2] * e[1][1]) / (f[0] * f[0]);
    out[1][1] = (law[2] * e[0][0] + law[1] * e[1][1]) / (f[1] * f[1]);
    out[0][1] = out[1][0] = 2 * law[3] * e[0][1] / (f[0] * f[1]);
}

/* 0 where J turns over. */
static int density_of(const double law[4], const double f[2], const matrix j, const double g[3],
                      density *d)
{
    const matrix metric = {{g[0], g[1]}, {g[1], g[2]}};
    matrix half, e, product;

    *d = (density){.f = {f[0], f[1]}, .det = j[0][0] * j[1][1] - j[0][1] * j[1][0]};
    if (!(d->det > 0)) {
        return 0;
    }
    d->inverse[0][0] = j[1][1] / d->det;
    d->inverse[0][1] = -j[0][1] / d->det;
    d->inverse[1][0] = -j[1][0] / d->det;
    d->inverse[1][1] = j[0][0] / d->det;
    multiply(metric, (const double(*)[2])d->inverse, half);
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            d->c[i][k] = d->inverse[0][i] * half[0][k] + d->inverse[1][i] * half[1][k];
        }
    }
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            e[i][k] = (d->c[i][k] / (f[i] * f[k]) - (i == k)) / 2;
        }
    }
    stress_of(law, f, (const double(*)[2])e, d->stress);
    d->phi = (d->stress[0][0] * f[0] * f[0] * e[0][0] + d->stress[1][1] * f[1] * f[1] * e[1][1] +
              2 * d->stress[0][1] * f[0] * f[1] * e[0][1]) /
             2;
    multiply((const double(*)[2])d->stress, (const double(*)[2])d->c, product);
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            d->sigma[i][k] = f[0] * f[1] * d->det * ((i == k ? d->phi : 0) - product[i][k]);
        }
    }
    return 1;
}

/* d2w of all pairs of H = e_k e_l^T, index 2 k + l. */
static void second_of(const double law[4], const density *d, double out[4][4])
{
    const double weight = d->f[0] * d->f[1] * d->det;
    for (int y = 0; y < 4; y++) { /* K = e_m e_n^T: C_K = -(e_n C_m. + C_.m e_n^T) */
        const int m = y / 2, n = y % 2;
        matrix ck = {{0, 0}, {0, 0}}, ek, sk, first, second, sigma;
        for (int i = 0; i < 2; i++) {
            ck[n][i] -= d->c[m][i];
            ck[i][n] -= d->c[i][m];
        }
        for (int i = 0; i < 2; i++) {
            for (int k = 0; k < 2; k++) {
                ek[i][k] = ck[i][k] / (2 * d->f[i] * d->f[k]);
            }
        }
        stress_of(law, d->f, (const double(*)[2])ek, sk);
        multiply((const double(*)[2])sk, (const double(*)[2])d->c, first);
        multiply((const double(*)[2])d->stress, (const double(*)[2])ck, second);
        double phi = 0; /* S : E_K */
        for (int i = 0; i < 2; i++) {
            for (int k = 0; k < 2; k++) {
                phi += d->stress[i][k] * ck[i][k] / 2;
            }
        }
        for (int i = 0; i < 2; i++) {
            for (int k = 0; k < 2; k++) {
                sigma[i][k] = weight * ((i == k ? phi : 0) - first[i][k] - second[i][k]);
            }
        }
        for (int x = 0; x < 4; x++) { /* H = e_k e_l^T: tr(A H) = A_lk, H K = e_k e_n^T [l = m] */
            const int k = x / 2, l = x % 2;
            out[x][y] = (m == n ? d->sigma[l][k] : 0) + sigma[l][k] - (l == m ? d->sigma[n][k] : 0);
        }
    }
}

/* ---- one piece ---- */

typedef struct work {
    const taut_cloth *cloth;
    const taut_cloth_piece *piece;
    taut_arena *arena;
    line lines[2];
    int n;
    double *gradient, *scale; /* [n]; scale: what strains of 1 would give */
    int rows;
    double *a;                   /* [rows][n] */
    double *pull;                /* multipliers */
    int edges[TAUT_CLOTH_EDGES]; /* first row of each, or -1 */
    taut_skyline hessian;
    taut_cloth_state *state;
    taut_pulse *pulse;
} work;

static int unknown(const work *w, int i, int j, int d)
{
    return (i * w->lines[1].count + j) * 2 + d;
}

/* J at a place of quadrature, and the gradients of the functions alive. */
static void jacobian_at(const work *w, int a, int b, int q, int r, matrix j, double grad[CELL][2])
{
    const line *s = &w->lines[0], *t = &w->lines[1];
    const int i0 = taut_basis_first(s->basis, a), j0 = taut_basis_first(t->basis, b);
    memset(j, 0, sizeof(matrix));
    for (int i = 0; i < ALIVE; i++) {
        for (int k = 0; k < ALIVE; k++) {
            const double *y = taut_surface_points(w->piece->flat) +
                              3 * ((size_t)(i0 + i) * (size_t)t->count + (size_t)(j0 + k));
            double *g = grad[i * ALIVE + k];
            g[0] = s->slope[a][q][i] * t->value[b][r][k];
            g[1] = s->value[a][q][i] * t->slope[b][r][k];
            for (int d = 0; d < 2; d++) {
                j[d][0] += y[d] * g[0];
                j[d][1] += y[d] * g[1];
            }
        }
    }
}

static void principal(const density *d, double strain[2])
{
    const double a = d->c[0][0] / (d->f[0] * d->f[0]), b = d->c[1][1] / (d->f[1] * d->f[1]);
    const double m = d->c[0][1] / (d->f[0] * d->f[1]);
    const double half = (a + b) / 2, radius = taut_hypot((a - b) / 2, m);
    strain[0] = sqrt(half - radius) - 1;
    strain[1] = sqrt(half + radius) - 1;
}

/* Along the thread, across it, and the angle that is lost between them. */
static void take_cloth(const density *d, taut_cloth_state *state)
{
    const double a = d->c[0][0] / (d->f[0] * d->f[0]), b = d->c[1][1] / (d->f[1] * d->f[1]);
    const double m = d->c[0][1] / (d->f[0] * d->f[1]);
    const double own[2] = {sqrt(a) - 1, sqrt(b) - 1};
    double *ranges[2] = {state->warp, state->weft};
    for (int k = 0; k < 2; k++) {
        ranges[k][0] = taut_certify_min(ranges[k][0], own[k]);
        ranges[k][1] = taut_certify_max(ranges[k][1], own[k]);
    }
    state->shear = taut_certify_max(state->shear, fabs(taut_asin(m / sqrt(a * b))));
}

/* How far apart the two are at one place: angles change by that. */
static void look_at_angle(const double strain[2], taut_cloth_state *state)
{
    state->angle = taut_certify_max(state->angle, (1 + strain[1]) / (1 + strain[0]) - 1);
}

/* Adds a place's second variation to a cell's matrix, its lower triangle: entry (2 x + d, 2 z + e). */
static void add_second(double weight, const double row[CELL][2], double second[4][4],
                       double cell[2 * CELL][2 * CELL])
{
    for (int x = 0; x < CELL; x++) {
        for (int d = 0; d < 2; d++) {
            double *to = cell[2 * x + d];
            double half[4];
            for (int o = 0; o < 4; o++) {
                half[o] =
                    weight * (second[2 * d][o] * row[x][0] + second[2 * d + 1][o] * row[x][1]);
            }
            for (int z = 0; z <= x; z++) {
                to[2 * z] += half[0] * row[z][0] + half[1] * row[z][1];
                to[2 * z + 1] += half[2] * row[z][0] + half[3] * row[z][1];
            }
        }
    }
}

static void add_cell(work *w, int i0, int j0, double cell[2 * CELL][2 * CELL])
{
    for (int x = 0; x < 2 * CELL; x++) {
        const int i = unknown(w, i0 + x / 2 / ALIVE, j0 + x / 2 % ALIVE, x % 2);
        double *to = w->hessian.rows[i] - w->hessian.first[i];
        for (int z = 0; z <= x; z++) {
            to[unknown(w, i0 + z / 2 / ALIVE, j0 + z / 2 % ALIVE, z % 2)] += cell[x][z];
        }
    }
}

/* F0 at a place. */
static void stretch_at(const work *w, const taut_cloth_across *across, double t, double f[2])
{
    double at[3][2] = {{0}}, shrink[2];
    if (w->cloth->fade_count > 0) {
        taut_cloth_window_on(w->cloth, across, t, at);
    }
    taut_cloth_shrink(w->cloth, w->piece, at[0], shrink);
    f[0] = 1 / shrink[0];
    f[1] = 1 / shrink[1];
}

static double gauss_at(const work *w, const taut_cloth_across *across, double t)
{
    double at[3][2];
    taut_forms forms;
    if (!taut_cloth_window_on(w->cloth, across, t, at) ||
        taut_surface_forms_points(across->piece->on, 1, &at[0][0], &at[0][1], 1, &forms) !=
            TAUT_OK) {
        return (double)NAN;
    }
    return forms.gaussian;
}

/* All integrals, and with `solved` gradient and Hessian. */
static void integrate(work *w, int solved)
{
    static const double plain[4] = {1, 1, 0, 0.5};
    const line *s = &w->lines[0], *t = &w->lines[1];
    double grad[CELL][2], row[CELL][2], second[4][4];
    double matrix_of_cell[2 * CELL][2 * CELL];
    taut_cloth_across across;

    for (int cell = 0;
         cell < s->spans * t->spans && !taut_pulse_beat(w->pulse, work_of_cell[solved != 0]);
         cell++) {
        const int a = cell / t->spans, b = cell % t->spans;
        const int i0 = taut_basis_first(s->basis, a), j0 = taut_basis_first(t->basis, b);
        memset(matrix_of_cell, 0, sizeof matrix_of_cell);
        for (int place = 0; place < NODES * NODES; place++) {
            const int q = place / NODES, r = place % NODES;
            const double weight = weight_of(s, a, q) * weight_of(t, b, r);
            const double at[2] = {place_of(s, a, q), place_of(t, b, r)};
            double g[3], f[2], strain[2];
            matrix j;
            density d, other;
            jacobian_at(w, a, b, q, r, j, grad);
            if (r == 0) {
                taut_cloth_across_at(w->cloth, w->piece, at[0], 1, &across);
            }
            stretch_at(w, &across, at[1], f);
            if (!taut_cloth_metric_on(w->cloth, &across, at[1], g) ||
                !density_of(w->cloth->law, f, (const double(*)[2])j, g, &d) ||
                !density_of(plain, f, (const double(*)[2])j, g, &other)) {
                w->state->is_folded = 1;
                continue;
            }
            const double area = sqrt(g[0] * g[2] - g[1] * g[1]);
            w->state->area += weight * area;
            w->state->curvature += weight * area * gauss_at(w, &across, at[1]);
            w->state->flat_area += weight * d.det;
            w->state->energy += weight * d.phi * f[0] * f[1] * d.det;
            w->state->plain += weight * other.phi * f[0] * f[1] * d.det;
            principal(&d, strain);
            w->state->largest =
                taut_certify_max(w->state->largest, fmax(fabs(strain[0]), fabs(strain[1])));
            look_at_angle(strain, w->state);
            const double apart = 1 / (1 + strain[0]) - 1 / (1 + strain[1]);
            w->state->conformal += weight * area * apart * apart / 2;
            if (!solved) {
                continue;
            }
            for (int x = 0; x < CELL; x++) {
                for (int l = 0; l < 2; l++) {
                    row[x][l] = d.inverse[0][l] * grad[x][0] + d.inverse[1][l] * grad[x][1];
                }
                for (int c = 0; c < 2; c++) {
                    const int i = unknown(w, i0 + x / ALIVE, j0 + x % ALIVE, c);
                    w->gradient[i] +=
                        weight * (row[x][0] * d.sigma[0][c] + row[x][1] * d.sigma[1][c]);
                    w->scale[i] += weight * d.det * (fabs(row[x][0]) + fabs(row[x][1]));
                }
            }
            second_of(w->cloth->law, &d, second);
            add_second(weight, (const double(*)[2])row, second, matrix_of_cell);
        }
        if (solved) {
            add_cell(w, i0, j0, matrix_of_cell);
        }
    }
}

/* ---- constraints ---- */

static double *row_of(work *w, int row)
{
    return w->a + (size_t)row * (size_t)w->n;
}

/* The basis along an edge. */
static const line *along(const work *w, int edge)
{
    return &w->lines[edge == TAUT_CLOTH_END || edge == TAUT_CLOTH_START];
}

/* The unknown of coefficient k of an edge. */
static int edge_unknown(const work *w, int edge, int k, int d)
{
    const int last[2] = {w->lines[0].count - 1, w->lines[1].count - 1};
    return edge == TAUT_CLOTH_RIGHT  ? unknown(w, k, 0, d)
           : edge == TAUT_CLOTH_LEFT ? unknown(w, k, last[1], d)
           : edge == TAUT_CLOTH_END  ? unknown(w, last[0], k, d)
                                     : unknown(w, 0, k, d);
}

static double edge_speed(const work *w, int edge, int a, int q, double way[2])
{
    const line *l = along(w, edge);
    way[0] = way[1] = 0;
    for (int i = 0; i < ALIVE; i++) {
        const int k = edge_unknown(w, edge, taut_basis_first(l->basis, a) + i, 0) / 2;
        for (int d = 0; d < 2; d++) {
            way[d] += l->slope[a][q][i] * taut_surface_points(w->piece->flat)[3 * k + d];
        }
    }
    return taut_hypot(way[0], way[1]);
}

/* The rows of a held edge; or, with multipliers there, what they add to the Hessian. */
static void add_edge(work *w, int edge, int bends)
{
    const line *l = along(w, edge);
    for (int a = 0; a < l->spans; a++) {
        const int first = taut_basis_first(l->basis, a);
        for (int q = 0; q < NODES; q++) {
            double way[2], pull = 0;
            const double speed = edge_speed(w, edge, a, q, way), weight = weight_of(l, a, q);
            for (int b = 0; b < P; b++) {
                const int row = w->edges[edge] + first + b;
                const double part = l->test[a][q][b] * weight;
                pull += bends ? part * w->pull[row] : 0;
                for (int i = 0; !bends && i < ALIVE; i++) {
                    for (int d = 0; d < 2; d++) {
                        row_of(w, row)[edge_unknown(w, edge, first + i, d)] +=
                            part * way[d] / speed * l->slope[a][q][i];
                    }
                }
            }
            const double normal[2] = {-way[1] / speed, way[0] / speed};
            for (int x = 0; bends && x < 2 * ALIVE; x++) {
                for (int z = 0; z < 2 * ALIVE; z++) {
                    const int i = edge_unknown(w, edge, first + x / 2, x % 2);
                    const int k = edge_unknown(w, edge, first + z / 2, z % 2);
                    if (k <= i) {
                        w->hessian.rows[i][k - w->hessian.first[i]] +=
                            pull / speed * normal[x % 2] * normal[z % 2] * l->slope[a][q][x / 2] *
                            l->slope[a][q][z / 2];
                    }
                }
            }
        }
    }
}

/* The chord between the middles of both ends keeps its direction. */
static void add_thread(work *w)
{
    const line *t = &w->lines[1];
    const int span = taut_basis_span(t->basis, 0.5), first = taut_basis_first(t->basis, span);
    const double turn[2] = {-taut_sin(w->cloth->thread), taut_cos(w->cloth->thread)};
    double value[ALIVE];
    taut_basis_eval(t->basis, span, 0.5, 0, value);
    for (int k = 0; k < ALIVE; k++) {
        for (int d = 0; d < 2; d++) {
            row_of(w, w->rows - 1)[unknown(w, w->lines[0].count - 1, first + k, d)] =
                turn[d] * value[k];
            row_of(w, w->rows - 1)[unknown(w, 0, first + k, d)] = -turn[d] * value[k];
        }
    }
}

/* Or both ends are straight and square to y_1: what it is at their functions is one. */
static void add_ends(work *w)
{
    const int last[2] = {0, w->lines[0].count - 1}, count = w->lines[1].count;
    for (int end = 0; end < 2; end++) {
        for (int k = 1; k < count; k++) {
            double *row = row_of(w, w->rows - 2 * (count - 1) + end * (count - 1) + k - 1);
            row[unknown(w, last[end], k, 0)] = 1;
            row[unknown(w, last[end], 0, 0)] = -1;
        }
    }
}

/* x [rows] that makes g + A^T x least, by the normal equations; dependent rows are held by a little. */
static taut_status fit_multipliers(work *w)
{
    const int m = w->rows;
    int *first = taut_arena_take(w->arena, (size_t)m, sizeof *first);
    taut_skyline normal;
    double most = 0;

    w->pull = taut_arena_take(w->arena, (size_t)m, sizeof *w->pull);
    if (first == NULL || taut_skyline_new(w->arena, m, first, &normal) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < m && !taut_pulse_beat(w->pulse, 2.0 * i * w->n); i++) {
        for (int k = 0; k <= i; k++) {
            double sum = 0;
            for (int x = 0; x < w->n; x++) {
                sum += row_of(w, i)[x] * row_of(w, k)[x];
            }
            normal.rows[i][k] = sum;
        }
        most = fmax(most, normal.rows[i][i]);
        for (int x = 0; x < w->n; x++) {
            w->pull[i] -= row_of(w, i)[x] * w->gradient[x];
        }
    }
    for (int i = 0; i < m; i++) {
        normal.rows[i][i] += 1e-14 * most;
    }
    if (taut_skyline_factor(&normal, w->pulse)) {
        taut_skyline_solve(&normal, w->pull);
    }
    return TAUT_OK;
}

static void judge_gradient(work *w)
{
    double most = 0, scale = 0;
    for (int x = 0; x < w->n; x++) {
        double sum = w->gradient[x];
        for (int i = 0; i < w->rows; i++) {
            sum += w->pull[i] * row_of(w, i)[x];
        }
        most = taut_certify_max(most, fabs(sum));
        scale = fmax(scale, w->scale[x]);
    }
    w->state->residual = most / scale;
}

/* The lowest eigenvalue, of the Hessian made stiff against what the constraints hold, by inverse iteration. */
static taut_status judge_stiffness(work *w)
{
    double most = 0, lowest = 0;
    double *x = taut_arena_take(w->arena, (size_t)w->n, sizeof *x);
    if (x == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        if (w->edges[e] >= 0) {
            add_edge(w, e, 1);
        }
    }
    for (int i = 0; i < w->n; i++) {
        /* not fmax: gcc 12 for 64-bit ARM stops on this loop with it, an error of its own */
        most = taut_certify_max(most, w->hessian.rows[i][i - w->hessian.first[i]]);
    }
    for (int row = 0; row < w->rows; row++) {
        const double *a = row_of(w, row);
        double norm = 0, operations = 2.0 * w->n;
        for (int i = 0; i < w->n; i++) {
            norm += a[i] * a[i];
        }
        for (int i = 0; i < w->n; i++) {
            operations += a[i] != 0 ? 2.0 * (i - w->hessian.first[i]) : 0;
            for (int k = w->hessian.first[i]; a[i] != 0 && k <= i; k++) {
                w->hessian.rows[i][k - w->hessian.first[i]] += stiff * most / norm * a[i] * a[k];
            }
        }
        if (taut_pulse_beat(w->pulse, operations)) {
            return TAUT_INTERRUPTED;
        }
    }
    for (int d = 0; d < 2; d++) { /* nor may a corner move */
        w->hessian.rows[d][d - w->hessian.first[d]] += stiff * most;
    }
    if (!taut_skyline_factor(&w->hessian, w->pulse)) {
        w->state->stiffness = -1;
        return TAUT_OK;
    }
    for (int i = 0; i < w->n; i++) {
        x[i] = 1 + 0.5 * ((i * 7) % 11) / 11.0 -
               (i % 3 == 0 ? 1.7 : 0); /* any start, the same each time */
    }
    for (int k = 0; k < TURNS && !taut_pulse_beat(w->pulse, 4 * taut_skyline_room(&w->hessian));
         k++) {
        double norm = 0;
        for (int i = 0; i < w->n; i++) {
            norm += x[i] * x[i];
        }
        norm = sqrt(norm);
        for (int i = 0; i < w->n; i++) {
            x[i] /= norm;
        }
        taut_skyline_solve(&w->hessian, x);
        double grown = 0;
        for (int i = 0; i < w->n; i++) {
            grown += x[i] * x[i];
        }
        lowest = 1 / sqrt(grown);
    }
    w->state->stiffness = lowest / most;
    return TAUT_OK;
}

/* ---- the whole ---- */

static int is_held(const work *w, int edge)
{
    return w->piece->is_sewn[edge] || !isnan(w->piece->held[edge]);
}

/* How many ends are points, all of whose coefficients are one. */
static int points_of(const work *w)
{
    return w->piece->is_point[TAUT_CLOTH_START] + w->piece->is_point[TAUT_CLOTH_END];
}

/* And rows that keep them one, before the thread's. */
static void add_points(work *w)
{
    const int count = w->lines[1].count;
    int row = w->rows - 1 - points_of(w) * 2 * (count - 1);
    for (int end = 0; end < 2; end++) {
        const int edge = end == 0 ? TAUT_CLOTH_START : TAUT_CLOTH_END;
        for (int k = 1; w->piece->is_point[edge] && k < count; k++) {
            for (int d = 0; d < 2; d++, row++) {
                row_of(w, row)[edge_unknown(w, edge, k, d)] = 1;
                row_of(w, row)[edge_unknown(w, edge, 0, d)] = -1;
            }
        }
    }
}

static taut_status make_room(work *w)
{
    const line *s = &w->lines[0], *t = &w->lines[1];
    int *first = taut_arena_take(w->arena, (size_t)w->n, sizeof *first);

    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        w->edges[e] = is_held(w, e) ? w->rows : -1;
        w->rows += is_held(w, e) ? along(w, e)->count - 1 : 0;
    }
    w->rows += points_of(w) * 2 * (t->count - 1);
    w->rows += w->cloth->is_straight ? 2 * (t->count - 1) : 1; /* of the ends, or of the thread */
    w->gradient = taut_arena_take(w->arena, (size_t)w->n, sizeof(double));
    w->scale = taut_arena_take(w->arena, (size_t)w->n, sizeof(double));
    w->a = taut_arena_take(w->arena, (size_t)w->rows * (size_t)w->n, sizeof(double));
    if (taut_arena_status(w->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < w->n;
         i++) { /* rows of constraints reach 2 P - 1 functions; the thread's, from end to end */
        const int row = i / 2 / t->count, reach = 2 * P - 1;
        first[i] = row == s->count - 1 || row < reach ? 0 : (row - reach) * t->count * 2;
    }
    return taut_skyline_new(w->arena, w->n, first, &w->hessian);
}

/* The density at a place of the flat piece; 0 where it turns over, or the surface has no metric. */
static int see_at(const work *w, const taut_cloth_across *across, const double at[2], density *d)
{
    double y[3][3], g[3], f[2];
    matrix j;
    taut_surface_eval(w->piece->flat, at[0], at[1], 1, y[0]);
    for (int c = 0; c < 2; c++) {
        j[c][0] = y[1][c];
        j[c][1] = y[2][c];
    }
    stretch_at(w, across, at[1], f);
    return taut_cloth_metric_on(w->cloth, across, at[1], g) &&
           density_of(w->cloth->law, f, (const double(*)[2])j, g, d);
}

double taut_cloth_strain_at(const taut_cloth *cloth, const taut_cloth_piece *piece, double s,
                            double t)
{
    const work w = {.cloth = cloth, .piece = piece};
    const double at[2] = {s, t};
    double strain[2];
    taut_cloth_across across;
    density d;
    if (!(s >= 0) || !(s <= 1) || !(t >= 0) || !(t <= 1)) {
        return (double)NAN;
    }
    taut_cloth_across_at(cloth, piece, s, 1, &across);
    if (!see_at(&w, &across, at, &d)) {
        return (double)NAN;
    }
    principal(&d, strain);
    return fabs(strain[0]) > fabs(strain[1]) ? strain[0] : strain[1];
}

/* Principal strains on a grid that has the border. */
static void look_around(work *w)
{
    const line *s = &w->lines[0], *t = &w->lines[1];
    taut_cloth_state *state = w->state;
    state->strain[0] = state->inner[0] = state->warp[0] = state->weft[0] = INFINITY;
    state->strain[1] = state->inner[1] = state->warp[1] = state->weft[1] = -INFINITY;
    /* at a point there is no strain */
    const int first = w->piece->is_point[TAUT_CLOTH_START];
    const int last = GRID * s->spans - w->piece->is_point[TAUT_CLOTH_END];
    for (int i = first; i <= last && !taut_pulse_beat(w->pulse, GRID * t->spans * work_of_place);
         i++) {
        taut_cloth_across across;
        taut_cloth_across_at(w->cloth, w->piece, (double)i / (GRID * s->spans), 1, &across);
        for (int k = 0; k <= GRID * t->spans; k++) {
            const double at[2] = {(double)i / (GRID * s->spans), (double)k / (GRID * t->spans)};
            double strain[2];
            density d;
            if (!see_at(w, &across, at, &d)) {
                state->is_folded = 1;
                continue;
            }
            principal(&d, strain);
            take_cloth(&d, state);
            state->strain[0] = taut_certify_min(state->strain[0], strain[0]);
            state->strain[1] = taut_certify_max(state->strain[1], strain[1]);
            const int is_corner =
                fmin(at[0], 1 - at[0]) < corner && fmin(at[1], 1 - at[1]) < corner;
            if (!is_corner) {
                state->inner[0] = taut_certify_min(state->inner[0], strain[0]);
                state->inner[1] = taut_certify_max(state->inner[1], strain[1]);
            }
            state->largest =
                taut_certify_max(state->largest, fmax(fabs(strain[0]), fabs(strain[1])));
            look_at_angle(strain, state);
        }
    }
}

/* From the middle of start to that of end. */
static double chord_of(const taut_cloth_piece *piece)
{
    double from[3], to[3];
    taut_surface_eval(piece->flat, 0, 0.5, 0, from);
    taut_surface_eval(piece->flat, 1, 0.5, 0, to);
    return taut_distance(from, to);
}

static taut_status look_in(work *w, int solved)
{
    taut_status status = fill_line(w->arena, taut_surface_u(w->piece->flat), &w->lines[0]);
    if (status == TAUT_OK) {
        status = fill_line(w->arena, taut_surface_v(w->piece->flat), &w->lines[1]);
    }
    w->n = 2 * w->lines[0].count * w->lines[1].count;
    if (status == TAUT_OK && solved) {
        status = make_room(w);
    }
    if (status != TAUT_OK) {
        return status;
    }
    integrate(w, solved);
    look_around(w);
    if (!solved) {
        return TAUT_OK;
    }
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        if (w->edges[e] >= 0) {
            add_edge(w, e, 0);
        }
    }
    add_points(w);
    if (w->cloth->is_straight) {
        add_ends(w);
    } else {
        add_thread(w);
    }
    status = fit_multipliers(w);
    if (status != TAUT_OK) {
        return status;
    }
    judge_gradient(w);
    w->state->torque = w->cloth->is_straight ? 0 : w->pull[w->rows - 1] * chord_of(w->piece);
    return judge_stiffness(w);
}

taut_status taut_cloth_look_at(const taut_cloth *cloth, const taut_cloth_piece *piece, int solved,
                               taut_pulse *pulse, taut_cloth_state *state)
{
    work w = {
        .cloth = cloth, .piece = piece, .arena = taut_arena_new(), .state = state, .pulse = pulse};
    *state = (taut_cloth_state){.residual = 0, .torque = (double)NAN, .stiffness = (double)NAN};
    const taut_status status = w.arena != NULL ? look_in(&w, solved) : TAUT_NO_MEMORY;
    taut_arena_free(w.arena);
    if (status == TAUT_OK && !piece->is_point[TAUT_CLOTH_START] &&
        !piece->is_point
             [TAUT_CLOTH_END]) { /* K may be too uneven for the places that are looked at */
        const double border = taut_cloth_gauss_bonnet(cloth, piece);
        if (fabs(border - state->curvature) > uneven) {
            state->curvature = border;
        }
    }
    return status;
}
