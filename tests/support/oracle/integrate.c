/* integrate.c -- integrals over a surface by the trapezoidal rule after t = (1 + tanh(pi/2 sinh s)) / 2
 * in both directions of every cell between breaks; the step is halved until the sums stay. Where
 * the integrand is a polynomial, by a Gauss rule that is exact for it: its nodes are found here, by
 * Newton's steps on the recurrence of Legendre's polynomials. */
#include "oracle/oracle.h"

#include <math.h>
#include <stdlib.h>

enum { NODES_MAX = 300 };

/* Nodes and weights on [0, 1] with step 0.2 / 2^level. */
static int rule(int level, oracle_real *nodes, oracle_real *weights)
{
    const oracle_real half_pi = 1.57079632679489661923L, step = 0.2L / (1 << level);
    const int reach = (int)(3.4L / step);
    int count = 0;

    for (int i = -reach; i <= reach; i++) {
        const oracle_real s = step * i, e = expl(-2 * half_pi * sinhl(fabsl(s)));
        const oracle_real near = e / (1 + e); /* distance from the nearer end */
        nodes[count] = s < 0 ? near : 1 - near;
        weights[count++] = step * 2 * half_pi * coshl(s) * e / ((1 + e) * (1 + e));
    }
    return count;
}

int oracle_gauss(int count, oracle_real *nodes, oracle_real *weights)
{
    for (int i = 0; i < count; i++) {
        oracle_real x = cosl(3.14159265358979323846L * (i + 0.75L) / (count + 0.5L)), slope = 1;
        for (int turn = 0; turn < 60; turn++) {
            oracle_real p = 1, before = 0;
            for (int k = 1; k <= count; k++) {
                const oracle_real next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = count * (x * p - before) / (x * x - 1);
            x -= p / slope;
            if (fabsl(p / slope) < 1e-19L) {
                break;
            }
        }
        nodes[i] = (1 + x) / 2;
        weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
    return count;
}

typedef struct node_table {
    int spans, count; /* nodes a span */
    oracle_row *row;
    oracle_real *weight;
} node_table;

/* level below 0: the Gauss rule of -level nodes. */
static int take_rows(const oracle_basis *basis, int level, int order, node_table *rows)
{
    oracle_real nodes[NODES_MAX], weights[NODES_MAX];

    rows->count = level < 0 ? oracle_gauss(-level, nodes, weights) : rule(level, nodes, weights);
    rows->spans = basis->spans;
    rows->row = calloc((size_t)rows->count * (size_t)basis->spans, sizeof *rows->row);
    rows->weight = calloc((size_t)rows->count * (size_t)basis->spans, sizeof *rows->weight);
    if (rows->row == NULL || rows->weight == NULL) {
        return 0;
    }
    for (int s = 0; s < basis->spans; s++) {
        const oracle_real lo = basis->breaks[s], width = basis->breaks[s + 1] - lo;
        for (int i = 0; i < rows->count; i++) {
            oracle_basis_row(basis, s, lo + width * nodes[i], order,
                             &rows->row[s * rows->count + i]);
            rows->weight[s * rows->count + i] = width * weights[i];
        }
    }
    return 1;
}

static void free_rows(node_table *rows)
{
    free(rows->row);
    free(rows->weight);
}

static int integrate_once(const oracle_sheet *sheet, int level, oracle_integrals *out)
{
    node_table u = {0}, v = {0};
    oracle_real trace = 0;
    const int ok = take_rows(&sheet->u, level, 2, &u) && take_rows(&sheet->v, level, 2, &v);

    *out = (oracle_integrals){0};
    for (int i = 0; ok && i < u.spans * u.count; i++) {
        for (int j = 0; j < v.spans * v.count; j++) {
            oracle_real x[6][3], n[3];
            const oracle_real w = u.weight[i] * v.weight[j];
            oracle_sheet_at(sheet, &u.row[i], &v.row[j], 2, x);
            oracle_cross(x[1], x[2], n);
            const oracle_real e = oracle_dot(x[1], x[1]), f = oracle_dot(x[1], x[2]),
                              gg = oracle_dot(x[2], x[2]);
            out->area += w * oracle_norm(n);
            trace += w * (e + gg);
            out->isothermality += w * sqrtl((e - gg) * (e - gg) + 4 * f * f);
            out->bending +=
                w * (oracle_dot(x[3], x[3]) + 2 * oracle_dot(x[4], x[4]) + oracle_dot(x[5], x[5]));
        }
    }
    out->dirichlet = trace / 2;
    free_rows(&u);
    free_rows(&v);
    return ok;
}

void oracle_integrate(const oracle_sheet *sheet, oracle_real relative, int levels,
                      oracle_integrals *out)
{
    oracle_integrals before;

    *out = (oracle_integrals){.area = NAN, .dirichlet = NAN, .area_error = INFINITY};
    out->dirichlet_error = INFINITY;
    if (!integrate_once(sheet, 0, out)) {
        return;
    }
    for (int level = 1; level <= levels; level++) {
        before = *out;
        if (!integrate_once(sheet, level, out)) {
            return;
        }
        out->area_error = fabsl(out->area - before.area);
        out->dirichlet_error = fabsl(out->dirichlet - before.dirichlet);
        if (out->area_error <= relative * fabsl(out->area) &&
            out->dirichlet_error <= relative * fabsl(out->dirichlet)) {
            return;
        }
    }
}

/* What the integrand multiplies derivatives of a point's function by: f_u and f_v. */
static int fluxes(oracle_real x[6][3], int area, oracle_real lambda, oracle_real fu[3],
                  oracle_real fv[3])
{
    const oracle_real e = oracle_dot(x[1], x[1]), f = oracle_dot(x[1], x[2]),
                      gg = oracle_dot(x[2], x[2]);
    oracle_real n[3];

    oracle_cross(x[1], x[2], n);
    const oracle_real w = oracle_norm(n);
    for (int k = 0; k < 3; k++) {
        fu[k] = area ? (gg * x[1][k] - f * x[2][k]) / w : lambda * x[1][k];
        fv[k] = area ? (e * x[2][k] - f * x[1][k]) / w : x[2][k] / lambda;
    }
    return !area || w > 0;
}

static void add_node(const oracle_sheet *sheet, const oracle_row *u, const oracle_row *v,
                     oracle_real weight, int area, oracle_real lambda, oracle_real *gradient)
{
    oracle_real x[6][3], fu[3], fv[3], total[3] = {1, 0, 0};

    oracle_sheet_at(sheet, u, v, 1, x);
    if (!fluxes(x, area, lambda, fu, fv)) {
        return;
    }
    if (sheet->weights != NULL) {
        total[0] = 0;
        for (int a = 0; a < u->local; a++) {
            for (int b = 0; b < v->local; b++) {
                const oracle_real w =
                    sheet->weights[(u->first + a) * sheet->v.count + v->first + b];
                total[0] += w * u->n[0][a] * v->n[0][b];
                total[1] += w * u->n[1][a] * v->n[0][b];
                total[2] += w * u->n[0][a] * v->n[1][b];
            }
        }
    }
    for (int a = 0; a < u->local; a++) {
        for (int b = 0; b < v->local; b++) {
            const int at = (u->first + a) * sheet->v.count + v->first + b;
            const oracle_real w = (sheet->weights != NULL ? sheet->weights[at] : 1) / total[0];
            const oracle_real phi = w * u->n[0][a] * v->n[0][b];
            const oracle_real pu = w * u->n[1][a] * v->n[0][b] - phi * total[1] / total[0];
            const oracle_real pv = w * u->n[0][a] * v->n[1][b] - phi * total[2] / total[0];
            for (int k = 0; k < 3; k++) {
                gradient[3 * at + k] += weight * (pu * fu[k] + pv * fv[k]);
            }
        }
    }
}

static int gradient_once(const oracle_sheet *sheet, int area, oracle_real lambda, int level,
                         oracle_real *gradient)
{
    node_table u = {0}, v = {0};
    const int ok = take_rows(&sheet->u, level, 1, &u) && take_rows(&sheet->v, level, 1, &v);

    for (int i = 0; i < 3 * sheet->u.count * sheet->v.count; i++) {
        gradient[i] = 0;
    }
    for (int i = 0; ok && i < u.spans * u.count; i++) {
        for (int j = 0; j < v.spans * v.count; j++) {
            add_node(sheet, &u.row[i], &v.row[j], u.weight[i] * v.weight[j], area, lambda,
                     gradient);
        }
    }
    free_rows(&u);
    free_rows(&v);
    return ok;
}

int oracle_gradient(const oracle_sheet *sheet, int area, oracle_real lambda, oracle_real *gradient,
                    oracle_real *error)
{
    const int n = 3 * sheet->u.count * sheet->v.count;
    oracle_real *before = calloc((size_t)n, sizeof *before);
    int ok = before != NULL;

    *error = INFINITY;
    if (ok && !area && sheet->weights == NULL && sheet->u.type == 'p' && sheet->v.type == 'p') {
        const int degree = sheet->u.degree > sheet->v.degree ? sheet->u.degree : sheet->v.degree;
        *error = 0;
        ok = gradient_once(sheet, 0, lambda, -(degree + 1), gradient);
        free(before);
        return ok;
    }
    /* Gauss rules: the integrand is smooth where there is a normal; where it is not, the error says so */
    static const int rules[] = {-14, -24, -40};
    ok = ok && gradient_once(sheet, area, lambda, rules[0], before);
    for (int i = 1; ok && i < 3; i++) {
        oracle_real largest = 0;
        ok = gradient_once(sheet, area, lambda, rules[i], gradient);
        *error = 0;
        for (int k = 0; k < n; k++) {
            *error = fmaxl(*error, fabsl(gradient[k] - before[k]));
            largest = fmaxl(largest, fabsl(gradient[k]));
            before[k] = gradient[k];
        }
        if (*error <= 1e-13L * largest) {
            break;
        }
    }
    free(before);
    return ok;
}
