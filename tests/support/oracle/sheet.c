/* sheet.c -- points and derivatives of surfaces and curves: sums of products, then the quotient
 * rule where there are weights. Coordinates are taken about the middle of the net, which moves no
 * derivative and keeps the digits of nets far from the origin. */
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

oracle_real oracle_dot(const oracle_real a[3], const oracle_real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void oracle_cross(const oracle_real a[3], const oracle_real b[3], oracle_real out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

oracle_real oracle_norm(const oracle_real a[3])
{
    return sqrtl(oracle_dot(a, a));
}

int oracle_sheet_of(const taut_surface *surface, oracle_sheet *sheet)
{
    memset(sheet, 0, sizeof *sheet);
    if (surface == NULL || !oracle_basis_of(taut_surface_u(surface), &sheet->u) ||
        !oracle_basis_of(taut_surface_v(surface), &sheet->v)) {
        oracle_sheet_free(sheet);
        return 0;
    }
    sheet->points = taut_surface_points(surface);
    sheet->weights = taut_surface_weights(surface);
    sheet->net = calloc((size_t)(sheet->u.count * sheet->v.count), 4 * sizeof *sheet->net);
    if (sheet->net == NULL) {
        oracle_sheet_free(sheet);
        return 0;
    }
    oracle_sheet_about(sheet, 0, sheet->u.count - 1, 0, sheet->v.count - 1);
    sheet->size = sheet->extent;
    return 1;
}

void oracle_sheet_about(oracle_sheet *sheet, int from_u, int to_u, int from_v, int to_v)
{
    sheet->extent = 0;
    for (int k = 0; k < 3; k++) {
        oracle_real lo = INFINITY, hi = -INFINITY;
        for (int i = from_u; i <= to_u; i++) {
            for (int j = from_v; j <= to_v; j++) {
                const double x = sheet->points[3 * (i * sheet->v.count + j) + k];
                lo = fminl(lo, x);
                hi = fmaxl(hi, x);
            }
        }
        sheet->middle[k] = (lo + hi) / 2;
        sheet->extent = fmaxl(sheet->extent, hi - lo);
    }
    for (int i = 0; i < sheet->u.count * sheet->v.count; i++) {
        const oracle_real w = sheet->weights != NULL ? sheet->weights[i] : 1;
        for (int k = 0; k < 3; k++) {
            sheet->net[4 * i + k] = w * (sheet->points[3 * i + k] - sheet->middle[k]);
        }
        sheet->net[4 * i + 3] = w;
    }
}

void oracle_sheet_free(oracle_sheet *sheet)
{
    oracle_basis_free(&sheet->u);
    oracle_basis_free(&sheet->v);
    free(sheet->net);
    sheet->net = NULL;
}

/* Is any derivative up to `order` of function a other than 0? At an end few are. */
static int is_alive(const oracle_row *row, int order, int a)
{
    for (int k = 0; k <= order; k++) {
        if (row->n[k][a] != 0) {
            return 1;
        }
    }
    return 0;
}

/* Sums over the net of derivative i of the functions of u and j of those of v, i <= order_u,
 * j <= order_v: W x about the middle, and W. Along v first, then along u. */
static void add_up(const oracle_sheet *sheet, const oracle_row *u, const oracle_row *v, int order_u,
                   int order_v, oracle_real out[ORACLE_ORDER_MAX + 1][ORACLE_ORDER_MAX + 1][4])
{
    memset(out, 0, (size_t)(order_u + 1) * sizeof out[0]);
    for (int a = 0; a < u->local; a++) {
        oracle_real line[ORACLE_ORDER_MAX + 1][4] = {{0}};
        if (!is_alive(u, order_u, a)) {
            continue;
        }
        for (int b = 0; b < v->local; b++) {
            const oracle_real *at =
                sheet->net + 4 * ((u->first + a) * sheet->v.count + v->first + b);
            for (int j = 0; j <= order_v; j++) {
                const oracle_real n = v->n[j][b];
                for (int k = 0; k < 4 && n != 0; k++) {
                    line[j][k] += n * at[k];
                }
            }
        }
        for (int i = 0; i <= order_u; i++) {
            for (int j = 0; j <= order_v; j++) {
                for (int k = 0; k < 4; k++) {
                    out[i][j][k] += u->n[i][a] * line[j][k];
                }
            }
        }
    }
}

void oracle_sheet_at(const oracle_sheet *sheet, const oracle_row *u, const oracle_row *v, int order,
                     oracle_real out[6][3])
{
    static const int du[6] = {0, 1, 0, 2, 1, 0}, dv[6] = {0, 0, 1, 0, 1, 2};
    const int vectors = (order + 1) * (order + 2) / 2;
    oracle_real sum[6][4], all[ORACLE_ORDER_MAX + 1][ORACLE_ORDER_MAX + 1][4];

    add_up(sheet, u, v, order, order, all);
    for (int k = 0; k < vectors; k++) {
        memcpy(sum[k], all[du[k]][dv[k]], sizeof sum[k]);
    }
    for (int k = 0; k < 3; k++) {
        out[0][k] = sum[0][k] / sum[0][3];
        if (sheet->weights == NULL) {
            for (int i = 1; i < vectors; i++) {
                out[i][k] = sum[i][k];
            }
            continue;
        }
        if (order >= 1) {
            out[1][k] = (sum[1][k] - sum[1][3] * out[0][k]) / sum[0][3];
            out[2][k] = (sum[2][k] - sum[2][3] * out[0][k]) / sum[0][3];
        }
        if (order >= 2) {
            out[3][k] = (sum[3][k] - 2 * sum[1][3] * out[1][k] - sum[3][3] * out[0][k]) / sum[0][3];
            out[4][k] = (sum[4][k] - sum[1][3] * out[2][k] - sum[2][3] * out[1][k] -
                         sum[4][3] * out[0][k]) /
                        sum[0][3];
            out[5][k] = (sum[5][k] - 2 * sum[2][3] * out[2][k] - sum[5][3] * out[0][k]) / sum[0][3];
        }
    }
}

void oracle_sheet_eval(const oracle_sheet *sheet, oracle_real u, oracle_real v, int order,
                       oracle_real out[6][3])
{
    oracle_row row[2];

    oracle_basis_row(&sheet->u, oracle_basis_span(&sheet->u, u), u, order, &row[0]);
    oracle_basis_row(&sheet->v, oracle_basis_span(&sheet->v, v), v, order, &row[1]);
    oracle_sheet_at(sheet, &row[0], &row[1], order, out);
}

void oracle_sheet_mixed(const oracle_sheet *sheet, oracle_real u, oracle_real v, int i, int j,
                        oracle_real out[3])
{
    oracle_row row[2];
    oracle_real all[ORACLE_ORDER_MAX + 1][ORACLE_ORDER_MAX + 1][4];

    oracle_basis_row(&sheet->u, oracle_basis_span(&sheet->u, u), u, i, &row[0]);
    oracle_basis_row(&sheet->v, oracle_basis_span(&sheet->v, v), v, j, &row[1]);
    add_up(sheet, &row[0], &row[1], i, j, all);
    memcpy(out, all[i][j], 3 * sizeof out[0]);
}

int oracle_line_of(const taut_curve *curve, oracle_line *line)
{
    memset(line, 0, sizeof *line);
    if (curve == NULL || !oracle_basis_of(taut_curve_t(curve), &line->t)) {
        oracle_line_free(line);
        return 0;
    }
    line->points = taut_curve_points(curve);
    line->weights = taut_curve_weights(curve);
    return 1;
}

void oracle_line_free(oracle_line *line)
{
    oracle_basis_free(&line->t);
}

void oracle_line_eval(const oracle_line *line, oracle_real t, oracle_real out[3][3])
{
    oracle_row row;
    oracle_real sum[3][4] = {{0}};

    oracle_basis_row(&line->t, oracle_basis_span(&line->t, t), t, 2, &row);
    for (int order = 0; order <= 2; order++) {
        for (int a = 0; a < row.local; a++) {
            const int at = row.first + a;
            const oracle_real n = row.n[order][a] * (line->weights != NULL ? line->weights[at] : 1);
            for (int k = 0; k < 3; k++) {
                sum[order][k] += n * line->points[3 * at + k];
            }
            sum[order][3] += n;
        }
    }
    for (int k = 0; k < 3; k++) {
        out[0][k] = sum[0][k] / sum[0][3];
        if (line->weights == NULL) { /* the weights' sum is 1 but for rounding */
            out[1][k] = sum[1][k];
            out[2][k] = sum[2][k];
        } else {
            out[1][k] = (sum[1][k] - sum[1][3] * out[0][k]) / sum[0][3];
            out[2][k] = (sum[2][k] - 2 * sum[1][3] * out[1][k] - sum[2][3] * out[0][k]) / sum[0][3];
        }
    }
}
