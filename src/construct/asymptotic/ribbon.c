#include "construct/asymptotic/ribbon.h"

#include "construct/asymptotic/inflection.h"
#include "core/vec3.h"
#include "numeric/bernstein.h"

#include <string.h>

enum { LENGTH_P = 2 * TAUT_QUAD_DEGREE - 1, LENGTH_Q = 3 * TAUT_QUAD_DEGREE - 5 };

/* P = n (R_up W_lo - R_lo W_up), of degree 2n - 2 without cancelling leading terms, where x_lo =
 * (x_0 .. x_(n-1)) and x_up = (x_1 .. x_n). */
static void tangent_polynomial(int n, double (*h)[4], double (*p)[3])
{
    double lo[TAUT_QUAD_POINTS][3], up[TAUT_QUAD_POINTS][3], w_lo[TAUT_QUAD_POINTS];
    double w_up[TAUT_QUAD_POINTS], second[LENGTH_P][3];
    for (int j = 0; j < n; j++) {
        memcpy(lo[j], h[j], sizeof lo[j]);
        memcpy(up[j], h[j + 1], sizeof up[j]);
        w_lo[j] = h[j][3];
        w_up[j] = h[j + 1][3];
    }
    taut_bernstein_scale(n - 1, w_lo, n - 1, 3, &up[0][0], &p[0][0]);
    taut_bernstein_scale(n - 1, w_up, n - 1, 3, &lo[0][0], &second[0][0]);
    for (int j = 0; j <= 2 * n - 2; j++) {
        for (int k = 0; k < 3; k++) {
            p[j][k] = n * (p[j][k] - second[j][k]);
        }
    }
}

/* Q = n^2 (n-1) [a_w b x c + b_w c x a + c_w a x b] with a, b, c the coefficients from 0, 1, 2 on,
 * of degree 3n - 6. */
static void binormal_polynomial(int n, double (*h)[4], double (*q)[3])
{
    double part[3][TAUT_QUAD_POINTS][3], weight[3][TAUT_QUAD_POINTS];
    double cross[LENGTH_P][3], term[LENGTH_Q][3];
    for (int s = 0; s < 3; s++) {
        for (int j = 0; j <= n - 2; j++) {
            memcpy(part[s][j], h[j + s], sizeof part[s][j]);
            weight[s][j] = h[j + s][3];
        }
    }
    memset(q, 0, LENGTH_Q * sizeof *q);
    for (int s = 0; s < 3; s++) {
        taut_bernstein_cross(n - 2, &part[(s + 1) % 3][0][0], n - 2, &part[(s + 2) % 3][0][0],
                             &cross[0][0]);
        taut_bernstein_scale(n - 2, weight[s], 2 * n - 4, 3, &cross[0][0], &term[0][0]);
        for (int j = 0; j <= 3 * n - 6; j++) {
            taut_add_scaled(n * n * (n - 1.0), term[j], q[j]);
        }
    }
}

void taut_ribbon_fill(const taut_quad *quad, int edge, taut_ribbon *ribbon)
{
    const int n = quad->degree;
    double h[TAUT_QUAD_POINTS][4], q[LENGTH_Q][3];
    memset(ribbon, 0, sizeof *ribbon);
    ribbon->straight = quad->edges[edge].straight;
    taut_quad_homogeneous(&quad->edges[edge], n, h);
    tangent_polynomial(n, h, ribbon->p);
    for (int end = 0; end < 2; end++) {
        const double w = taut_quad_weight(quad, edge, end, 0);
        for (int k = 0; k < 3; k++) {
            ribbon->tangent[end][k] = ribbon->p[end == 0 ? 0 : 2 * n - 2][k] / (w * w);
        }
    }
    if (!ribbon->straight) {
        binormal_polynomial(n, h, q);
        ribbon->inflections = taut_inflections_remove(
            3 * n - 6, taut_quad_rounding(quad) / taut_quad_size(quad), q, ribbon->inflection);
        taut_bernstein_cross(3 * n - 6, &q[0][0], 2 * n - 2, &ribbon->p[0][0], &ribbon->qh[0][0]);
    }
}

void taut_ribbon_numerator(int n, taut_ribbon *ribbon)
{
    double second[TAUT_QUAD_PATCH + 1][3];
    const int m = 5 * n - 7;
    taut_bernstein_scale(3 * n - 5, ribbon->alpha, 2 * n - 2, 3, &ribbon->p[0][0],
                         &ribbon->numerator[0][0]);
    taut_bernstein_scale(1, ribbon->beta, 5 * n - 8, 3, &ribbon->qh[0][0], &second[0][0]);
    for (int k = 0; k <= m; k++) {
        taut_add_scaled(1.0, second[k], ribbon->numerator[k]);
    }
}

void taut_ribbon_ends(const taut_quad *quad, int edge, taut_ribbon ribbons[4])
{
    taut_ribbon *const ribbon = &ribbons[edge];
    const int n = quad->degree;
    memset(ribbon->alpha, 0, sizeof ribbon->alpha);
    if (ribbon->straight) {
        return;
    }
    for (int end = 0; end < 2; end++) {
        const taut_quad_meeting *const f = &taut_quad_partner[edge][end];
        const double *const target = ribbons[f->edge].tangent[f->end];
        const double *const tangent = ribbon->tangent[end];
        const double w = taut_quad_weight(quad, edge, end, 0);
        double q[3];
        for (int k = 0; k < 3; k++) {
            q[k] = ribbon->qh[end == 0 ? 0 : 5 * n - 8][k] / (w * w * w * w * w);
        }
        ribbon->alpha[end == 0 ? 0 : 3 * n - 5] =
            taut_dot(target, tangent) / (w * taut_dot(tangent, tangent));
        ribbon->beta[end] = taut_dot(target, q) / (w * w * w * w * taut_dot(q, q));
    }
    taut_ribbon_numerator(n, ribbon);
}

void taut_ribbon_slope(const taut_quad *quad, int edge, int end, const taut_ribbon *ribbon,
                       double slope[3])
{
    const int n = quad->degree, m = 5 * n - 7;
    const double w = taut_quad_weight(quad, edge, end, 0);
    const double inner = taut_quad_weight(quad, edge, end, 1);
    const double weight_slope = end == 0 ? n * (inner - w) : n * (w - inner);
    const double *const here = ribbon->numerator[end == 0 ? 0 : m];
    const double *const low = ribbon->numerator[end == 0 ? 0 : m - 1];
    const double *const high = ribbon->numerator[end == 0 ? 1 : m];
    for (int k = 0; k < 3; k++) {
        slope[k] = (m * (high[k] - low[k]) - here[k] / w * weight_slope) / w;
    }
}

double taut_ribbon_singular(const taut_ribbon *ribbon)
{
    if (ribbon->straight || ribbon->beta[0] * ribbon->beta[1] > 0) {
        return nan("");
    }
    return ribbon->beta[0] / (ribbon->beta[0] - ribbon->beta[1]);
}
