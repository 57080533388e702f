#include "logistic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOCAL = 9 };

/* One place of a direction: the functions and their first two derivatives, and du/ds. */
typedef struct place {
    double n[3][LOCAL], weight;
} place;

/* B[n,i] = C(n,i) a^i b^(n-i); none for i outside 0..n. */
static double bernstein(int n, int i, double a, double b)
{
    double value = 1;
    if (i < 0 || i > n) {
        return 0;
    }
    for (int k = 1; k <= i; k++) {
        value *= a * (n - i + k) / k;
    }
    for (int k = 0; k < n - i; k++) {
        value *= b;
    }
    return value;
}

static void fill_place(int degree, double s, place *p)
{
    const double a = 1 / (1 + exp(-s)), b = 1 / (1 + exp(s));
    p->weight = a * b;
    for (int i = 0; i <= degree; i++) {
        p->n[0][i] = bernstein(degree, i, a, b);
        p->n[1][i] = degree * (bernstein(degree - 1, i - 1, a, b) - bernstein(degree - 1, i, a, b));
        p->n[2][i] = degree < 2 ? 0
                                : degree * (degree - 1) *
                                      (bernstein(degree - 2, i - 2, a, b) -
                                       2 * bernstein(degree - 2, i - 1, a, b) +
                                       bernstein(degree - 2, i, a, b));
    }
}

/* polygon[k][j]: derivative k in u of (w x, w y, w z, w) of column j, points from the first one. */
typedef double polygons[3][LOCAL][4];

static void fill_polygons(const taut_surface *s, const place *u, polygons p)
{
    const int nu = taut_basis_count(taut_surface_u(s)), nv = taut_basis_count(taut_surface_v(s));
    const double *x = taut_surface_points(s), *w = taut_surface_weights(s);
    memset(p, 0, sizeof(polygons));
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < nu; i++) {
            for (int j = 0; j < nv; j++) {
                const int at = i * nv + j;
                const double f = u->n[k][i] * (w != NULL ? w[at] : 1);
                for (int c = 0; c < 3; c++) {
                    p[k][j][c] += f * (x[3 * at + c] - x[c]);
                }
                p[k][j][3] += f;
            }
        }
    }
}

static void sum_polygon(int count, double p[LOCAL][4], const double *n, double h[4])
{
    memset(h, 0, 4 * sizeof(double));
    for (int j = 0; j < count; j++) {
        for (int c = 0; c < 4; c++) {
            h[c] += n[j] * p[j][c];
        }
    }
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* By the quotient rule; adds the four integrands times the weight. */
static void add_place(int count, polygons p, const place *v, double sums[LOGISTIC_FIGURES])
{
    double h[6][4], x[3], d[5][3];
    static const int order[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

    for (int k = 0; k < 6; k++) {
        sum_polygon(count, p[order[k][0]], v->n[order[k][1]], h[k]);
    }
    const double w = h[0][3], wu = h[1][3], wv = h[2][3];
    for (int c = 0; c < 3; c++) {
        x[c] = h[0][c] / w;
        d[0][c] = (h[1][c] - x[c] * wu) / w;
        d[1][c] = (h[2][c] - x[c] * wv) / w;
        d[2][c] = (h[3][c] - 2 * d[0][c] * wu - x[c] * h[3][3]) / w;
        d[3][c] = (h[4][c] - d[0][c] * wv - d[1][c] * wu - x[c] * h[4][3]) / w;
        d[4][c] = (h[5][c] - 2 * d[1][c] * wv - x[c] * h[5][3]) / w;
    }
    const double e = dot(d[0], d[0]), f = dot(d[0], d[1]), g = dot(d[1], d[1]);
    const double n[3] = {d[0][1] * d[1][2] - d[0][2] * d[1][1],
                         d[0][2] * d[1][0] - d[0][0] * d[1][2],
                         d[0][0] * d[1][1] - d[0][1] * d[1][0]};
    sums[0] += v->weight * sqrt(dot(n, n));
    sums[1] += v->weight * (e + g) / 2;
    sums[2] += v->weight * (dot(d[2], d[2]) + 2 * dot(d[3], d[3]) + dot(d[4], d[4]));
    sums[3] += v->weight * ((e - g) * (e - g) + 4 * f * f);
}

void logistic_integrals(const taut_surface *surface, double reach, double step,
                        double figures[LOGISTIC_FIGURES])
{
    const int half = (int)ceil(reach / step), count = 2 * half + 1;
    place *u = malloc((size_t)count * sizeof *u), *v = malloc((size_t)count * sizeof *v);
    double sums[LOGISTIC_FIGURES] = {0, 0, 0, 0};

    for (int i = 0; i < count; i++) {
        fill_place(taut_basis_count(taut_surface_u(surface)) - 1, step * (i - half), &u[i]);
        fill_place(taut_basis_count(taut_surface_v(surface)) - 1, step * (i - half), &v[i]);
    }
    for (int i = 0; i < count; i++) {
        double line[LOGISTIC_FIGURES] = {0, 0, 0, 0};
        polygons p;
        fill_polygons(surface, &u[i], p);
        for (int j = 0; j < count; j++) {
            add_place(taut_basis_count(taut_surface_v(surface)), p, &v[j], line);
        }
        for (int k = 0; k < LOGISTIC_FIGURES; k++) {
            sums[k] += u[i].weight * line[k];
        }
    }
    for (int k = 0; k < LOGISTIC_FIGURES; k++) {
        figures[k] = step * step * sums[k];
    }
    figures[LOGISTIC_ISOTHERMAL] =
        sqrt(figures[LOGISTIC_ISOTHERMAL]) / (2 * figures[LOGISTIC_DIRICHLET]);
    free(u);
    free(v);
}
