#include "construct/asymptotic/plate.h"

#include "construct/asymptotic/bubble.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"
#include "numeric/dense.h"
#include "numeric/quadrature.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LENGTH = TAUT_QUAD_PATCH + 1, NODES_MAX = 2 * TAUT_QUAD_PATCH + 14 };

/* Value, u, v, uu, uv, vv of a function of (u, v), in this order. */
typedef double jet[6];

/* The columns of the least-squares problem: inner unknowns; three per freedom, its effect on x, y
 * and z; three for the patch as it stands. Along one line of nodes, u fixed, the inner ones are made
 * of 3 per narrow ones,
 *     (b_k(u) b_l(v) / W)'' = b_k(u) n_0l + b_k'(u) n_1l + b_k''(u) n_2l,
 * so that a line's rows are first brought down to as many, and then spread over all columns. */
typedef struct plate {
    const taut_patch *patch;
    int count; /* freedoms */
    const taut_plate_freedom *freedoms;
    int inner, others, columns, nodes;
    int per, narrow_columns; /* bubbles of a direction; 3 per + others */
    double node[NODES_MAX], weight[NODES_MAX];
    double bernstein[NODES_MAX][3][LENGTH]; /* at the nodes */
    double bubble[NODES_MAX][3][LENGTH];
    double small[(TAUT_PLATE_FREEDOMS + 1) * (TAUT_PLATE_FREEDOMS + 1)]; /* of the freedoms */
    double reduced[(TAUT_PLATE_FREEDOMS + 1) * 3 * (TAUT_PLATE_FREEDOMS + 1)];
    double *triangle;            /* [columns][columns] */
    double *block;               /* [columns][3 per], or the others alone */
    double *narrow;              /* of one line of nodes, [3 per + others][3 nodes] */
    double *line;                /* its triangle, [3 per + others][3 per + others] */
    double *rest;                /* of all lines, the columns beside the inner ones alone */
    double *bubble_coefficients; /* [m - 3][m + 1] */
} plate;

/* From a numerator's jet f to that of f / W:
 *     p_u = (f_u - W_u p) / W,   p_uu = (f_uu - 2 W_u p_u - W_uu p) / W, ... */
static void quotient(const double *w, const double *f, double *p)
{
    p[0] = f[0] / w[0];
    p[1] = (f[1] - w[1] * p[0]) / w[0];
    p[2] = (f[2] - w[2] * p[0]) / w[0];
    p[3] = (f[3] - 2 * w[1] * p[1] - w[3] * p[0]) / w[0];
    p[4] = (f[4] - w[1] * p[2] - w[2] * p[1] - w[4] * p[0]) / w[0];
    p[5] = (f[5] - 2 * w[2] * p[2] - w[5] * p[0]) / w[0];
}

/* Orders in u and v of each entry of a jet. */
static const int order_u[6] = {0, 1, 0, 2, 1, 0};
static const int order_v[6] = {0, 0, 1, 0, 1, 2};

/* The jets of the four components of the net at nodes a (u) and b (v). */
static void net_jets(const plate *p, int a, int b, jet out[4])
{
    const int m = p->patch->m;
    memset(out, 0, 4 * sizeof *out);
    for (int i = 0; i <= m; i++) {
        double along[3][4] = {{0}};
        for (int j = 0; j <= m; j++) {
            const double *const entry = p->patch->net[i * (m + 1) + j];
            for (int d = 0; d < 3; d++) {
                for (int k = 0; k < 4; k++) {
                    along[d][k] += p->bernstein[b][d][j] * entry[k];
                }
            }
        }
        for (int s = 0; s < 6; s++) {
            for (int k = 0; k < 4; k++) {
                out[k][s] += p->bernstein[a][order_u[s]][i] * along[order_v[s]][k];
            }
        }
    }
}

/* The jets of the four components of a freedom. */
static void freedom_jets(const plate *p, const taut_plate_freedom *freedom, int a, int b,
                         jet out[4])
{
    const int m = p->patch->m;
    memset(out, 0, 4 * sizeof *out);
    for (int i = 0; i < freedom->parts; i++) {
        const int e = freedom->part[i].edge;
        const int with_u = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_V1;
        const int across = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0 ? 1 : m - 1;
        double along[3][4] = {{0}};
        for (int d = 0; d < 3; d++) {
            for (int k = 0; k <= m; k++) {
                for (int c = 0; c < 4; c++) {
                    along[d][c] += p->bernstein[with_u ? a : b][d][k] * freedom->part[i].row[k][c];
                }
            }
        }
        for (int s = 0; s < 6; s++) {
            const int order = with_u ? order_u[s] : order_v[s];
            const double other =
                p->bernstein[with_u ? b : a][with_u ? order_v[s] : order_u[s]][across];
            for (int c = 0; c < 4; c++) {
                out[c][s] += other * along[order][c];
            }
        }
    }
}

/* The jet of a product. */
static void product(const double *f, const double *g, double *out)
{
    out[0] = f[0] * g[0];
    out[1] = f[1] * g[0] + f[0] * g[1];
    out[2] = f[2] * g[0] + f[0] * g[2];
    out[3] = f[3] * g[0] + 2 * f[1] * g[1] + f[0] * g[3];
    out[4] = f[4] * g[0] + f[1] * g[2] + f[2] * g[1] + f[0] * g[4];
    out[5] = f[5] * g[0] + 2 * f[2] * g[2] + f[0] * g[5];
}

/* Entries of one narrow column for the node in place `at` of the line: sqrt of the weight times
 * second derivatives, the mixed one counted twice. */
static void write_entries(const plate *p, int column, int at, double root, const double *value)
{
    double *const to = p->narrow + ((int64_t)column * p->nodes + at) * 3;
    to[0] = root * value[3];
    to[1] = root * sqrt(2.0) * value[4];
    to[2] = root * value[5];
}

/* The columns of the freedoms: R = S / W moves by (dS - R dW) / W. */
static void fill_freedoms(const plate *p, int a, int b, double root, const double *w, jet r[3])
{
    for (int j = 0; j < p->count; j++) {
        jet part[4], weight, moved, pulled;
        freedom_jets(p, &p->freedoms[j], a, b, part);
        quotient(w, part[3], weight);
        for (int k = 0; k < 3; k++) {
            quotient(w, part[k], moved);
            product(r[k], weight, pulled);
            for (int s = 0; s < 6; s++) {
                moved[s] -= pulled[s];
            }
            write_entries(p, 3 * p->per + 3 * j + k, b, root, moved);
        }
    }
}

/* All narrow columns at one node. */
static void fill_node(const plate *p, int a, int b)
{
    const double root = sqrt(p->weight[a] * p->weight[b]);
    jet net[4], r[3];
    net_jets(p, a, b, net);
    for (int d = 0; d < 3; d++) {
        for (int l = 0; l < p->per; l++) {
            jet f = {0}, value;
            for (int s = 0; s < 6; s++) {
                f[s] = order_u[s] == d ? p->bubble[b][order_v[s]][l] : 0.0;
            }
            quotient(net[3], f, value);
            write_entries(p, d * p->per + l, b, root, value);
        }
    }
    for (int k = 0; k < 3; k++) {
        quotient(net[3], net[k], r[k]);
        write_entries(p, 3 * p->per + 3 * p->count + k, b, root, r[k]);
    }
    fill_freedoms(p, a, b, root, net[3], r);
}

/* Adds rows of the other columns alone: the triangle's end of a line, or of all. */
static void add_rest(const plate *p, const double *triangle, int columns, double *to)
{
    const int first = columns - p->others;
    for (int j = 0; j < p->others; j++) {
        for (int i = 0; i < p->others; i++) {
            p->block[j * p->others + i] =
                i <= j ? triangle[(int64_t)(first + j) * columns + first + i] : 0.0;
        }
    }
    taut_qr_append(p->others, to, p->others, p->block);
}

/* The rows of one line of nodes, brought down and spread. */
static void add_line(const plate *p, int a)
{
    const int rows = 3 * p->per, per = p->per;
    memset(p->line, 0, (size_t)p->narrow_columns * (size_t)p->narrow_columns * sizeof *p->line);
    taut_qr_append(p->narrow_columns, p->line, 3 * p->nodes, p->narrow);
    add_rest(p, p->line, p->narrow_columns, p->rest);
    for (int k = 0; k < per; k++) {
        for (int l = 0; l < per; l++) {
            double *const to = p->block + (int64_t)(k * per + l) * rows;
            memset(to, 0, (size_t)rows * sizeof *to);
            for (int d = 0; d < 3; d++) {
                const double *const from = p->line + (int64_t)(d * per + l) * p->narrow_columns;
                for (int i = 0; i <= d * per + l; i++) {
                    to[i] += p->bubble[a][d][k] * from[i];
                }
            }
        }
    }
    for (int j = 0; j < p->others; j++) {
        memcpy(p->block + (int64_t)(p->inner + j) * rows,
               p->line + (int64_t)(rows + j) * p->narrow_columns, (size_t)rows * sizeof(double));
    }
    taut_qr_append(p->columns, p->triangle, rows, p->block);
}

/* The rest of all lines below the triangle, in its end. */
static void add_all_rest(const plate *p)
{
    add_rest(p, p->triangle, p->columns, p->rest);
    for (int j = 0; j < p->others; j++) {
        for (int i = 0; i <= j; i++) {
            p->triangle[(int64_t)(p->inner + j) * p->columns + p->inner + i] =
                p->rest[j * p->others + i];
        }
    }
}

static void fill_tables(plate *p)
{
    const int m = p->patch->m, per = m - 3;
    taut_gauss_rule(p->nodes, p->node, p->weight);
    for (int a = 0; a < p->nodes; a++) {
        double values[3 * LENGTH];
        p->node[a] = 0.5 + 0.5 * p->node[a];
        p->weight[a] *= 0.5;
        taut_bernstein_eval(m, 2, p->node[a], values);
        for (int d = 0; d < 3; d++) {
            memcpy(p->bernstein[a][d], values + d * (m + 1), (size_t)(m + 1) * sizeof *values);
        }
        taut_bubble_eval(m, p->node[a], values);
        for (int d = 0; d < 3; d++) {
            memcpy(p->bubble[a][d], values + d * per, (size_t)per * sizeof *values);
        }
    }
    taut_bubble_bernstein(m, p->bubble_coefficients);
}

static taut_status triangularise(plate *p, const taut_monitor *monitor, taut_error *error)
{
    for (int a = 0; a < p->nodes; a++) {
        if (monitor != NULL && monitor->progress != NULL &&
            monitor->progress(monitor->context, 0.5 + 0.5 * a / p->nodes, "inner points") != 0) {
            return taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                             "stopped");
        }
        for (int b = 0; b < p->nodes; b++) {
            fill_node(p, a, b);
        }
        add_line(p, a);
    }
    add_all_rest(p);
    return TAUT_OK;
}

/* Rows of a small multiple of the identity below the triangle: freedoms that together move nothing,
 * as weights at the corners of four straight edges do, then stay together where they are. */
static void damp(int count, double *triangle)
{
    const double part = 1e-10; /* of the largest: what it moves of the others is its square */
    double block[(TAUT_PLATE_FREEDOMS + 1) * TAUT_PLATE_FREEDOMS] = {0}, largest = 0.0;
    for (int j = 0; j < count; j++) {
        largest = fmax(largest, fabs(triangle[j * (count + 1) + j]));
    }
    for (int j = 0; j < count; j++) {
        block[j * count + j] = part * largest;
    }
    taut_qr_append(count + 1, triangle, count, block);
}

static int solve_factors(int count, const double *triangle, double *factors)
{
    for (int j = 0; j < count; j++) {
        factors[j] = -triangle[count * (count + 1) + j];
    }
    return taut_triangle_solve(count, count + 1, triangle, factors);
}

/* The freedoms' factors: with the inner unknowns eliminated, what is left of each column stands
 * below them in the triangle; x, y and z are three blocks of rows of one small problem. r: its
 * triangle, or NULL. */
static int find_factors(plate *p, double *factors, double *r)
{
    const int rows = 3 * p->count + 3, count = p->count;
    int solved = 0;
    double *const small = p->small, *const block = p->reduced;
    memset(p->small, 0, sizeof p->small);
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j <= count; j++) {
            const int column = p->inner + 3 * j + k;
            for (int i = 0; i < rows; i++) {
                const int row = p->inner + i;
                block[j * rows + i] =
                    row <= column ? p->triangle[(int64_t)column * p->columns + row] : 0.0;
            }
        }
        taut_qr_append(count + 1, small, rows, block);
    }
    solved = solve_factors(count, small, factors);
    if (!solved) {
        damp(count, small);
        solved = solve_factors(count, small, factors);
    }
    for (int j = 0; j < count && r != NULL; j++) {
        memcpy(r + (int64_t)j * count, small + (int64_t)j * (count + 1), (size_t)count * sizeof *r);
    }
    return solved;
}

/* Adds the freedoms to the right-hand sides and to the patch's rows. */
static void apply_factors(const plate *p, const double *factors)
{
    const int last = p->inner + 3 * p->count;
    for (int j = 0; j < p->count; j++) {
        for (int k = 0; k < 3; k++) {
            const double *const from = p->triangle + (int64_t)(p->inner + 3 * j + k) * p->columns;
            double *const to = p->triangle + (int64_t)(last + k) * p->columns;
            for (int i = 0; i <= p->inner + 3 * j + k; i++) {
                to[i] += factors[j] * from[i];
            }
        }
        for (int i = 0; i < p->freedoms[j].parts; i++) {
            for (int k = 2; k <= p->patch->m - 2; k++) {
                taut_add_scaled(factors[j], p->freedoms[j].part[i].row[k],
                                taut_patch_at(p->patch, p->freedoms[j].part[i].edge, 1, k));
            }
        }
    }
}

/* Inner numerators from the bubble coefficients c of one component. */
static void add_bubbles(const plate *p, const double *c, int component)
{
    const int m = p->patch->m, per = m - 3;
    for (int k = 0; k < per; k++) {
        double row[LENGTH] = {0};
        for (int l = 0; l < per; l++) {
            for (int j = 2; j <= m - 2; j++) {
                row[j] += c[k * per + l] * p->bubble_coefficients[l * (m + 1) + j];
            }
        }
        for (int i = 2; i <= m - 2; i++) {
            for (int j = 2; j <= m - 2; j++) {
                p->patch->net[i * (m + 1) + j][component] +=
                    p->bubble_coefficients[k * (m + 1) + i] * row[j];
            }
        }
    }
}

static taut_status fail_singular(taut_error *error)
{
    return taut_fail(error, TAUT_NOT_CONVERGED, "ill-conditioned", NULL, taut_none, taut_none,
                     "the least-squares problem for the inner points is singular");
}

static taut_status solve_points(plate *p, double *factors, double *energy, taut_error *error)
{
    double sum = 0.0;
    int solved = p->count == 0 || find_factors(p, factors, NULL);
    if (solved && p->count > 0) {
        apply_factors(p, factors);
    }
    for (int k = 0; k < 3 && solved; k++) {
        double *const right = p->triangle + (int64_t)(p->inner + 3 * p->count + k) * p->columns;
        for (int i = 0; i < p->inner; i++) {
            right[i] = -right[i];
        }
        solved = taut_triangle_solve(p->inner, p->columns, p->triangle, right);
        for (int i = p->inner; i <= p->inner + 3 * p->count + k; i++) {
            sum += right[i] * right[i];
        }
        add_bubbles(p, right, k);
    }
    if (!solved || !isfinite(sum)) {
        return fail_singular(error);
    }
    *energy = sum;
    return TAUT_OK;
}

static void plate_free(plate *p)
{
    if (p != NULL) {
        taut_free(p->bubble_coefficients);
        taut_free(p->rest);
        taut_free(p->line);
        taut_free(p->narrow);
        taut_free(p->block);
        taut_free(p->triangle);
        taut_free(p);
    }
}

/* Room for a line's rows, and for the others' alone. */
static double *alloc_block(const plate *p)
{
    const size_t line = (size_t)p->columns * 3 * (size_t)p->per;
    const size_t rest = (size_t)p->others * (size_t)p->others;
    return taut_alloc_aligned(line > rest ? line : rest, sizeof(double));
}

/* The triangle of the whole least-squares problem. */
static taut_status plate_new(taut_patch *patch, int count, const taut_plate_freedom *freedoms,
                             const taut_plate_options *options, plate **made, taut_error *error)
{
    const int m = patch->m, per = m - 3;
    taut_status status = TAUT_OK;
    plate *const p = taut_alloc_zero(1, sizeof *p);
    if (p == NULL) {
        return taut_fail_memory(error);
    }
    p->patch = patch;
    p->count = count;
    p->freedoms = freedoms;
    p->per = per;
    p->inner = per * per;
    p->others = 3 * count + 3;
    p->columns = p->inner + p->others;
    p->narrow_columns = 3 * per + p->others;
    p->nodes = options->nodes > 0 ? options->nodes : 2 * m + 14;
    p->triangle = taut_alloc_zero((size_t)p->columns * (size_t)p->columns, sizeof(double));
    p->block = alloc_block(p);
    p->narrow =
        taut_alloc_aligned((size_t)p->narrow_columns * 3 * (size_t)p->nodes, sizeof(double));
    p->line =
        taut_alloc_aligned((size_t)p->narrow_columns * (size_t)p->narrow_columns, sizeof(double));
    p->rest = taut_alloc_zero((size_t)p->others * (size_t)p->others, sizeof(double));
    p->bubble_coefficients = taut_alloc((size_t)per * (size_t)(m + 1), sizeof(double));
    if (p->triangle == NULL || p->block == NULL || p->narrow == NULL || p->line == NULL ||
        p->rest == NULL || p->bubble_coefficients == NULL) {
        plate_free(p);
        return taut_fail_memory(error);
    }
    fill_tables(p);
    status = triangularise(p, options->monitor, error);
    if (status != TAUT_OK) {
        plate_free(p);
        return status;
    }
    *made = p;
    return TAUT_OK;
}

taut_status taut_plate_solve(taut_patch *patch, int count, const taut_plate_freedom *freedoms,
                             double *factors, const taut_plate_options *options, double *energy,
                             taut_error *error)
{
    plate *p = NULL;
    taut_status status = plate_new(patch, count, freedoms, options, &p, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = solve_points(p, factors, energy, error);
    plate_free(p);
    return status;
}

taut_status taut_plate_step(taut_patch *patch, int count, const taut_plate_freedom *freedoms,
                            double *factors, double *r, const taut_plate_options *options,
                            taut_error *error)
{
    plate *p = NULL;
    taut_status status = plate_new(patch, count, freedoms, options, &p, error);
    if (status == TAUT_OK && !find_factors(p, factors, r)) {
        status = fail_singular(error);
    }
    plate_free(p);
    return status;
}
