/* cells.c -- a polynomial or rational surface as Bezier cells, a polynomial one as Lagrange cells.
 *
 * Every span is cut into equal cells by de Casteljau's algorithm in homogeneous coordinates
 * ([Farin2002] 5.4), which changes nothing. A field f is no polynomial: VTK shows
 *
 *     sum_ij w_ij f_ij B_i B_j / sum_ij w_ij B_i B_j.
 *
 * Its f_ij are the values of f at the places (i / p, j / q) of the cell, so that the array, and what is drawn, which is a mean of
 * them, stays within the range of f, and corners have f itself; where f has no value, as at a pole, that of a place a little
 * inside. Asked for coefficients, they are found such that what is drawn equals f at the Chebyshev points of
 * the cell: with A_ki = B_i(t_k) and W = sum w_ij B_i B_j,
 *     w_ij f_ij = sum_kl inv(A_u)_ik inv(A_v)_jl (f W)(s_k, t_l).
 *
 * A Lagrange cell is given by its points at (i / p, j / q), S = sum B_i B_j P_ij, and so are its fields: what VTK draws between is
 * the polynomial of degrees p and q through them, for points the surface again.
 */
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "geometry/keep.h"
#include "geometry/operate/points.h"
#include "io/vtu/grid.h"
#include "numeric/bernstein.h"

#include <math.h>
#include <string.h>

enum { ORDER_MAX = VTU_DEGREE_MAX + 1, CELLS_WISHED = 4 };

int taut_vtu_cells_plan(const taut_surface *surface, const taut_write_options *options,
                        taut_vtu_cells *plan)
{
    const int divide = options->divide;
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    plan->lagrange = options->lagrange;
    plan->coefficients = options->coefficients && !options->lagrange;
    if (plan->lagrange && taut_surface_weights(surface) != NULL) {
        return 0;
    }
    for (int d = 0; d < 2; d++) {
        const int spans = taut_basis_span_count(bases[d]);
        plan->degree[d] = taut_basis_degree(bases[d]);
        plan->per_span[d] = divide > 0 ? divide : (CELLS_WISHED + spans - 1) / spans;
        if (plan->degree[d] < 1 || plan->degree[d] > VTU_DEGREE_MAX ||
            plan->per_span[d] > TAUT_POINTS_MAX / spans) {
            return 0;
        }
        plan->count[d] = plan->per_span[d] * spans;
    }
    return (double)taut_basis_span_count(bases[0]) * taut_basis_span_count(bases[1]) <=
           TAUT_OBJECTS_MAX;
}

/* What one direction needs: the nodes, Bernstein's values there, and their inverse. */
typedef struct node_rule {
    int order;
    double nodes[ORDER_MAX];
    double values[ORDER_MAX][ORDER_MAX]; /* [k][i]: B_i at node k */
    double inverse[ORDER_MAX][ORDER_MAX];
} node_rule;

/* Gauss-Jordan with the largest pivot; the matrix is regular and small. */
static void invert(node_rule *rule)
{
    const int n = rule->order;
    double a[ORDER_MAX][2 * ORDER_MAX];
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < n; i++) {
            a[k][i] = rule->values[k][i];
            a[k][n + i] = k == i;
        }
    }
    for (int c = 0; c < n; c++) {
        int pivot = c;
        for (int k = c + 1; k < n; k++) {
            pivot = fabs(a[k][c]) > fabs(a[pivot][c]) ? k : pivot;
        }
        for (int i = 0; i < 2 * n; i++) {
            const double kept = a[c][i];
            a[c][i] = a[pivot][i];
            a[pivot][i] = kept;
        }
        for (int i = 2 * n - 1; i >= 0; i--) {
            a[c][i] /= a[c][c];
        }
        for (int k = 0; k < n; k++) {
            const double factor = a[k][c];
            for (int i = 0; k != c && i < 2 * n; i++) {
                a[k][i] -= factor * a[c][i];
            }
        }
    }
    for (int k = 0; k < n; k++) {
        memcpy(rule->inverse[k], a[k] + n, (size_t)n * sizeof(double));
    }
}

static void make_rule(int degree, int coefficients, node_rule *rule)
{
    rule->order = degree + 1;
    if (!coefficients) {
        for (int k = 0; k <= degree; k++) {
            rule->nodes[k] = (double)k / degree;
            taut_bernstein_eval(degree, 0, rule->nodes[k], rule->values[k]);
        }
        return;
    }
    for (int k = 0; k <= degree; k++) {
        rule->nodes[k] = (1 - taut_cos(taut_acos(-1) * (2 * k + 1) / (2 * degree + 2))) / 2;
        taut_bernstein_eval(degree, 0, rule->nodes[k], rule->values[k]);
    }
    invert(rule);
}

/* The part [a, b] of a Bezier curve whose points, of four numbers, lie `stride` numbers apart. */
static void clip_curve(double *points, int degree, size_t stride, double a, double b)
{
    for (int r = 1; r <= degree; r++) { /* [0, b] */
        for (int i = degree; i >= r; i--) {
            double *p = points + stride * (size_t)i;
            for (size_t c = 0; c < 4; c++) {
                p[c] = b == 1 ? p[c] : (1 - b) * (p - stride)[c] + b * p[c];
            }
        }
    }
    for (int r = 1; a > 0 && r <= degree; r++) { /* [a/b, 1] of it */
        for (int i = 0; i <= degree - r; i++) {
            double *p = points + stride * (size_t)i;
            for (size_t c = 0; c < 4; c++) {
                p[c] = (1 - a / b) * p[c] + a / b * (p + stride)[c];
            }
        }
    }
}

/* All that one surface's cells share. */
typedef struct cell_work {
    const taut_vtu_cells *plan;
    node_rule rules[2];
    double net[ORDER_MAX * ORDER_MAX][4]; /* homogeneous, of the cell; [i][j] */
    double *v, *vectors;                  /* [nodes along v], and their six vectors */
    double *fields;                       /* [order u][nodes along v][TAUT_FIELDS] */
    double at[ORDER_MAX * ORDER_MAX];     /* one field at the nodes, then its coefficients */
    double half[ORDER_MAX * ORDER_MAX];
} cell_work;

/* out = in with the matrix applied along both directions: sum_kl mu[i][k] mv[j][l] in[k][l]. */
static void apply_both(const cell_work *work, double mu[][ORDER_MAX], double mv[][ORDER_MAX],
                       const double *in, double *half, double *out)
{
    const int nu = work->rules[0].order, nv = work->rules[1].order;
    for (int i = 0; i < nu; i++) {
        for (int l = 0; l < nv; l++) {
            double sum = 0;
            for (int k = 0; k < nu; k++) {
                sum += mu[i][k] * in[k * nv + l];
            }
            half[i * nv + l] = sum;
        }
    }
    for (int i = 0; i < nu; i++) {
        for (int j = 0; j < nv; j++) {
            double sum = 0;
            for (int l = 0; l < nv; l++) {
                sum += mv[j][l] * half[i * nv + l];
            }
            out[i * nv + j] = sum;
        }
    }
}

/* The corners in VTK's order: four corners, the edges v0, u1, v1, u0 without them, the inside with
 * u fastest. place(i, j) of the net [i][j], v fastest. */
static void order_corners(int p, int q, size_t first, int64_t *corners)
{
    const int64_t base = (int64_t)first;
    const int64_t row = q + 1;
    int n = 0;
    corners[n++] = base;
    corners[n++] = base + p * row;
    corners[n++] = base + p * row + q;
    corners[n++] = base + q;
    for (int i = 1; i < p; i++) {
        corners[n++] = base + i * row;
    }
    for (int j = 1; j < q; j++) {
        corners[n++] = base + p * row + j;
    }
    for (int i = 1; i < p; i++) {
        corners[n++] = base + i * row + q;
    }
    for (int j = 1; j < q; j++) {
        corners[n++] = base + j;
    }
    for (int j = 1; j < q; j++) {
        for (int i = 1; i < p; i++) {
            corners[n++] = base + i * row + j;
        }
    }
}

/* The net of part (a, b) of per_span of a Bezier piece. */
static void cut_net(const taut_surface *piece, cell_work *work, int a, int b)
{
    const taut_vtu_cells *plan = work->plan;
    const int p = plan->degree[0], q = plan->degree[1];
    const double *points = taut_surface_points(piece), *weights = taut_surface_weights(piece);
    for (int i = 0; i < (p + 1) * (q + 1); i++) {
        const double w = weights != NULL ? weights[i] : 1;
        for (int c = 0; c < 3; c++) {
            work->net[i][c] = w * points[3 * i + c];
        }
        work->net[i][3] = w;
    }
    for (int j = 0; j <= q; j++) {
        clip_curve(work->net[j], p, 4 * (size_t)(q + 1), (double)a / plan->per_span[0],
                   (double)(a + 1) / plan->per_span[0]);
    }
    for (int i = 0; i <= p; i++) {
        clip_curve(work->net[i * (q + 1)], q, 4, (double)b / plan->per_span[1],
                   (double)(b + 1) / plan->per_span[1]);
    }
}

/* The fields at node (k, l) of the cell whose nodes along v begin at column `column`. */
static const double *fields_at(const cell_work *work, int k, int l, int column)
{
    const size_t columns = (size_t)work->plan->count[1] * (size_t)work->rules[1].order;
    return work->fields + TAUT_FIELDS * ((size_t)k * columns + (size_t)(column + l));
}

/* The values of every field on the cell whose points begin at `first`. */
static void put_values(const cell_work *work, taut_vtu_grid *grid, size_t first, int column)
{
    const int nu = work->rules[0].order, nv = work->rules[1].order;
    for (int i = 0; i < nu * nv; i++) {
        memcpy(grid->fields + TAUT_FIELDS * (first + (size_t)i),
               fields_at(work, i / nv, i % nv, column), TAUT_FIELDS * sizeof(double));
    }
}

/* Their coefficients. */
static void fit_fields(cell_work *work, taut_vtu_grid *grid, size_t first, int column)
{
    const int nu = work->rules[0].order, nv = work->rules[1].order;
    double weights[ORDER_MAX * ORDER_MAX], at_nodes[ORDER_MAX * ORDER_MAX];
    for (int i = 0; i < nu * nv; i++) {
        weights[i] = work->net[i][3];
    }
    apply_both(work, work->rules[0].values, work->rules[1].values, weights, work->half, at_nodes);
    for (int f = 0; f < TAUT_FIELDS; f++) {
        for (int k = 0; k < nu; k++) {
            for (int l = 0; l < nv; l++) {
                work->at[k * nv + l] = at_nodes[k * nv + l] * fields_at(work, k, l, column)[f];
            }
        }
        apply_both(work, work->rules[0].inverse, work->rules[1].inverse, work->at, work->half,
                   work->at);
        for (int i = 0; i < nu * nv; i++) {
            grid->fields[TAUT_FIELDS * (first + (size_t)i) + (size_t)f] = work->at[i] / weights[i];
        }
    }
}

/* The net of a polynomial cell gives way to its points at the nodes; ends and edges of neighbours stay the same doubles. */
static void put_points(cell_work *work)
{
    const int n = work->rules[0].order * work->rules[1].order;
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < n; i++) {
            work->at[i] = work->net[i][c];
        }
        apply_both(work, work->rules[0].values, work->rules[1].values, work->at, work->half,
                   work->at);
        for (int i = 0; i < n; i++) {
            work->net[i][c] = work->at[i];
        }
    }
}

static void add_cell(cell_work *work, int index, int column, taut_vtu_grid *grid)
{
    const int p = work->plan->degree[0], q = work->plan->degree[1];
    const int type = work->plan->lagrange ? VTK_LAGRANGE_QUADRILATERAL : VTK_BEZIER_QUADRILATERAL;
    const size_t first = grid->points;
    int64_t *corners =
        taut_vtu_grid_add_cell(grid, type, (size_t)(p + 1) * (size_t)(q + 1), p, q, index);
    if (work->plan->lagrange) {
        put_points(work);
    }
    for (int i = 0; i < (p + 1) * (q + 1); i++) {
        const double w = work->net[i][3];
        const double point[3] = {work->net[i][0] / w, work->net[i][1] / w, work->net[i][2] / w};
        taut_vtu_grid_add_point(grid, point, w);
    }
    order_corners(p, q, first, corners);
    if (work->plan->coefficients) {
        fit_fields(work, grid, first, column);
    } else {
        put_values(work, grid, first, column);
    }
}

/* Node k of cell `cell`, counted over all spans; the end of a span is the span's, as what has a kink there has other values beyond. */
static double node_at(const taut_basis *basis, int per_span, int cell, double node)
{
    const double *breaks = taut_basis_breaks(basis);
    const int span = cell / per_span;
    const double share = (cell % per_span + node) / per_span;
    return fmin(breaks[span] + share * (breaks[span + 1] - breaks[span]),
                nextafter(breaks[span + 1], breaks[span]));
}

static const double inwards = 0.02; /* of a cell, where a node has no value */

/* Gives node (k, l) of the row of cells `row` the fields of a place a little inside of its cell. */
static taut_status mend_fields(const taut_surface *surface, int row, int k, int l, cell_work *work)
{
    const taut_vtu_cells *plan = work->plan;
    const int order = work->rules[1].order;
    const double s = inwards + (1 - 2 * inwards) * work->rules[0].nodes[k];
    const double t = inwards + (1 - 2 * inwards) * work->rules[1].nodes[l % order];
    double vectors[18];
    const taut_status status = taut_surface_eval(
        surface, node_at(taut_surface_u(surface), plan->per_span[0], row, s),
        node_at(taut_surface_v(surface), plan->per_span[1], l / order, t), 2, vectors);
    if (status == TAUT_OK) {
        taut_fields_of(vectors, work->fields + TAUT_FIELDS * ((size_t)k * (size_t)plan->count[1] *
                                                                  (size_t)order +
                                                              (size_t)l));
    }
    return status;
}

/* The fields at the nodes of one row of cells. */
static taut_status sample_row(const taut_surface *surface, int row, cell_work *work)
{
    const taut_vtu_cells *plan = work->plan;
    const int columns = plan->count[1] * work->rules[1].order;
    taut_status status = TAUT_OK;
    for (int k = 0; status == TAUT_OK && k < work->rules[0].order; k++) {
        const double u =
            node_at(taut_surface_u(surface), plan->per_span[0], row, work->rules[0].nodes[k]);
        status = taut_surface_eval_grid(surface, 1, &u, columns, work->v, 2, 1, work->vectors);
        for (int l = 0; status == TAUT_OK && l < columns; l++) {
            double *fields = work->fields + TAUT_FIELDS * ((size_t)k * (size_t)columns + (size_t)l);
            taut_fields_of(work->vectors + 18 * (size_t)l, fields);
            if (isnan(fields[TAUT_FIELD_H]) && !plan->coefficients) {
                status = mend_fields(surface, row, k, l, work);
            }
        }
    }
    return status;
}

static taut_status add_cells(const taut_surface *surface, const taut_model *pieces, int index,
                             cell_work *work, taut_vtu_grid *grid)
{
    const taut_vtu_cells *plan = work->plan;
    const int order = work->rules[1].order, spans_v = plan->count[1] / plan->per_span[1];
    const double row = (double)TAUT_FIELDS_WORK * plan->count[1] * order * work->rules[0].order;
    taut_status status = TAUT_OK;
    for (int l = 0; l < plan->count[1] * order; l++) {
        work->v[l] = node_at(taut_surface_v(surface), plan->per_span[1], l / order,
                             work->rules[1].nodes[l % order]);
    }
    for (int a = 0; status == TAUT_OK && a < plan->count[0]; a++) {
        status = sample_row(surface, a, work);
        for (int b = 0; status == TAUT_OK && b < plan->count[1]; b++) {
            const int piece = a / plan->per_span[0] * spans_v + b / plan->per_span[1];
            cut_net(taut_model_surface(pieces, piece), work, a % plan->per_span[0],
                    b % plan->per_span[1]);
            add_cell(work, index, b * order, grid);
        }
        if (status == TAUT_OK && taut_pulse_beat(grid->pulse, row)) {
            status = TAUT_INTERRUPTED;
        }
    }
    return status;
}

static taut_status add_surface(const taut_surface *surface, const taut_vtu_cells *plan, int index,
                               taut_arena *arena, taut_vtu_grid *grid, taut_error *error)
{
    const size_t columns = (size_t)plan->count[1] * (size_t)(plan->degree[1] + 1);
    const size_t rows = (size_t)(plan->degree[0] + 1);
    taut_model *pieces = NULL;
    cell_work *work = taut_arena_take(arena, 1, sizeof *work);
    double *v = taut_arena_take(arena, columns, sizeof(double));
    double *vectors = taut_arena_take(arena, columns, 18 * sizeof(double));
    double *fields = taut_arena_take(arena, columns * rows, TAUT_FIELDS * sizeof(double));
    taut_status status = TAUT_OK;

    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = taut_operate_pieces(surface, grid->pulse, &pieces, error);
    if (status != TAUT_OK) {
        return status;
    }
    *work = (cell_work){.plan = plan, .v = v, .vectors = vectors, .fields = fields};
    make_rule(plan->degree[0], plan->coefficients, &work->rules[0]);
    make_rule(plan->degree[1], plan->coefficients, &work->rules[1]);
    if (!taut_keep_model(arena, pieces)) {
        return taut_fail_memory(error);
    }
    return taut_fail_status(error, add_cells(surface, pieces, index, work, grid));
}

taut_status taut_vtu_cells_add(const taut_surface *surface, const taut_vtu_cells *plan, int index,
                               taut_vtu_grid *grid, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    const taut_status status = add_surface(surface, plan, index, arena, grid, error);
    taut_arena_free(arena);
    return status;
}
