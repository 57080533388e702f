#include "certify/biharmonic/bending.h"

#include "certify/common/verdict.h"
#include "core/constants.h"
#include "core/vec3.h"
#include "numeric/quadrature.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

enum { DEGREE = 64, SIZE = DEGREE + 6, TERM_WORK = 20 /* operations, as pulses count them */ };

/* A direction, and the surface's axes on its edge. */
typedef struct series {
    int n;
    double c[SIZE][SIZE]; /* [k][l]: of x^k y^l */
    double scale;         /* x, y are parameter lengths over this */
} series;

/* The whole series from one term x^order y^power. */
static void fill_series(series *w, int order, int power)
{
    memset(w->c, 0, sizeof w->c);
    w->c[order][power] = 1;
    for (int k = order + 1; k <= w->n; k++) {
        for (int l = 0; l <= w->n && k >= 4; l++) {
            const double two = 2.0 * (k - 2) * (k - 3) * (l + 2) * (l + 1) * w->c[k - 2][l + 2];
            const double four = (double)(l + 4) * (l + 3) * (l + 2) * (l + 1) * w->c[k - 4][l + 4];
            w->c[k][l] = -(two + four) / ((double)k * (k - 1) * (k - 2) * (k - 3));
        }
    }
}

/* w_xx, w_xy, w_yy by parameter length. */
static void bend_of(const series *w, double x, double y, double bend[3])
{
    const double unit = w->scale * w->scale;
    double px[SIZE], py[SIZE];

    px[0] = py[0] = 1;
    for (int k = 1; k <= w->n; k++) {
        px[k] = px[k - 1] * x / w->scale;
        py[k] = py[k - 1] * y / w->scale;
    }
    bend[0] = bend[1] = bend[2] = 0;
    for (int k = 0; k <= w->n; k++) {
        for (int l = 0; l <= w->n; l++) {
            const double c = w->c[k][l] / unit;
            if (c != 0) {
                bend[0] += k > 1 ? c * k * (k - 1) * px[k - 2] * py[l] : 0;
                bend[1] += k > 0 && l > 0 ? c * k * l * px[k - 1] * py[l - 1] : 0;
                bend[2] += l > 1 ? c * l * (l - 1) * px[k] * py[l - 2] : 0;
            }
        }
    }
}

/* A Gauss point: where it is from the edge, and the surface's second derivatives there, across,
 * mixed and along. */
typedef struct node {
    double x, y, weight;
    double bend[3][3];
} node;

static void node_at(const taut_surface *surface, taut_edge edge, double s, double t, double weight,
                    node *at)
{
    const int across_u = edge == TAUT_EDGE_U0 || edge == TAUT_EDGE_U1;
    const int high = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1;
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const taut_basis *across = across_u ? u : v, *along = across_u ? v : u;
    const double width = taut_basis_hi(across) - taut_basis_lo(across);
    const double length = taut_basis_hi(along) - taut_basis_lo(along);
    const double share = (s + 1) / 2;
    const double a =
        high ? taut_basis_hi(across) - share * width : taut_basis_lo(across) + share * width;
    const double b = taut_basis_lo(along) + (t + 1) / 2 * length;
    double x[6][3];

    (void)taut_surface_eval(surface, across_u ? a : b, across_u ? b : a, 2, &x[0][0]);
    at->x = share * width;
    at->y = t * length / 2;
    at->weight = weight * width * length / 4;
    for (int c = 0; c < 3; c++) {
        at->bend[0][c] = x[across_u ? TAUT_XUU : TAUT_XVV][c];
        at->bend[1][c] = high ? -x[TAUT_XUV][c] : x[TAUT_XUV][c];
        at->bend[2][c] = x[across_u ? TAUT_XVV : TAUT_XUU][c];
    }
}

/* |slope| of the energy along w over the norm of w. */
static double slope_along(const taut_surface *surface, taut_edge edge, const series *w,
                          double *energy, taut_pulse *pulse)
{
    double t[TAUT_GAUSS_MAX], weight[TAUT_GAUSS_MAX], with[3] = {0, 0, 0}, own = 0;
    const int nodes = w->n + 1;

    *energy = 0;
    taut_gauss_rule(nodes, t, weight);
    for (int i = 0; i < nodes; i++) {
        if (taut_pulse_beat(pulse, (double)TERM_WORK * nodes * nodes * nodes)) {
            return 0;
        }
        for (int j = 0; j < nodes; j++) {
            static const double factor[3] = {1, 2, 1};
            double bend[3];
            node at;
            node_at(surface, edge, t[i], t[j], weight[i] * weight[j], &at);
            bend_of(w, at.x, at.y, bend);
            for (int k = 0; k < 3; k++) {
                const double share = at.weight * factor[k];
                own += share * bend[k] * bend[k];
                for (int c = 0; c < 3; c++) {
                    with[c] += share * bend[k] * at.bend[k][c];
                    *energy += share * at.bend[k][c] * at.bend[k][c];
                }
            }
        }
    }
    const double most = taut_largest_coordinate(with);
    return own > 0 ? most / sqrt(own) : 0;
}

/* Is x^order y^power the start of a series within bidegree (n, n)? Total degrees up to n are; of
 * those of degree n + 1 the one that reaches neither x^(n+1) nor y^(n+1). */
static int is_direction(int n, int order, int power)
{
    return order + power <= n || (order + power == n + 1 && power % 2 != 0);
}

taut_bending_slope taut_bending_slope_of(const taut_surface *surface, taut_edge edge, int contact,
                                         taut_pulse *pulse)
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double a = taut_basis_hi(u) - taut_basis_lo(u), b = taut_basis_hi(v) - taut_basis_lo(v);
    const int n = taut_basis_degree(u);
    taut_bending_slope found = {0, 0, contact + 1, 0};
    double energy = 0, reach = 0;
    series w;

    memset(&w, 0, sizeof w);
    w.n = n;
    w.scale = fmax(a, b);
    for (int k = 0; k < 3 * (n + 1) * (n + 1); k++) {
        reach = fmax(reach, fabs(taut_surface_points(surface)[k]));
    }
    for (int order = contact + 1; order <= 3 && order <= n; order++) {
        for (int power = 0; power <= n && !taut_pulse_is_stopped(pulse); power++) {
            if (is_direction(n, order, power)) {
                fill_series(&w, order, power);
                const double slope = slope_along(surface, edge, &w, &energy, pulse);
                const double size = energy > 0 ? slope / sqrt(energy) : 0;
                found.order = size > found.residual ? order : found.order;
                found.power = size > found.residual ? power : found.power;
                found.residual = taut_certify_max(found.residual, size);
            }
        }
    }
    /* points rounded by 2^-53 reach move second derivatives by 4 n^2 / a^2 times that */
    found.noise = energy > 0 ? 6 * TAUT_UNIT_ROUNDOFF * n * n * (1 / (a * a) + 1 / (b * b)) *
                                   reach * sqrt(a * b / energy)
                             : 0;
    return found;
}
