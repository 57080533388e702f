/* edge.c -- derivatives at an edge u0 or u1 of a surface, from differences of its points.
 *
 * With c_i(v) = sum_j R_j(v) p_ij the rings, which have the same weights, and e the ring at the
 * edge, sum N_i = 1 makes
 *
 *     x_u = sum_i N_i' (c_i - c_e),   x_uu = sum_i N_i'' (c_i - c_e),   c_i - c_e = sum_j R_j (p_ij
 * - p_ej)
 *
 * whose rounding is that of differences of points that are near each other: summed with the points
 * themselves it would be that of their coordinates, over a first ring that may be very near.
 */
#include "certify/pipe/parts.h"
#include "core/vec3.h"

#include <string.h>

enum { LOCAL = 10 }; /* functions alive on a span, at most */

/* R_j and R_j' on the span of v. */
typedef struct ring {
    int first, count;
    double r[2][LOCAL];
} ring;

static void functions(const taut_surface *s, int row, double v, ring *out)
{
    const taut_basis *basis = taut_surface_v(s);
    const double *weights = taut_surface_weights(s);
    const int span = taut_basis_span(basis, v), nv = taut_basis_count(basis);
    double sum[2] = {0, 0};
    out->count = taut_basis_degree(basis) + 1;
    out->first = taut_basis_first(basis, span);
    double n[2 * LOCAL];
    taut_basis_eval(basis, span, v, 1, n);
    for (int j = 0; j < out->count; j++) {
        const double w = weights != NULL ? weights[row * nv + out->first + j] : 1;
        for (int k = 0; k < 2; k++) {
            out->r[k][j] = w * n[k * out->count + j];
            sum[k] += out->r[k][j];
        }
    }
    for (int j = 0; j < out->count; j++) {
        out->r[0][j] /= sum[0];
        out->r[1][j] = (out->r[1][j] - out->r[0][j] * sum[1]) / sum[0];
    }
}

/* Do both rings have the same weights? */
static int alike(const taut_surface *s, int a, int b)
{
    const double *weights = taut_surface_weights(s);
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(s));
    return weights == NULL ||
           memcmp(weights + (size_t)a * nv, weights + (size_t)b * nv, nv * sizeof *weights) == 0;
}

void taut_pipe_edge_eval(const taut_surface *s, int last, double v, int order, double (*d)[3])
{
    const taut_basis *basis = taut_surface_u(s);
    const int nu = taut_basis_count(basis), nv = taut_basis_count(taut_surface_v(s));
    const int span = last ? taut_basis_span_count(basis) - 1 : 0, edge = last ? nu - 1 : 0;
    const int count = taut_basis_degree(basis) + 1, first = taut_basis_first(basis, span);
    const double u = last ? taut_basis_hi(basis) : taut_basis_lo(basis);
    const double *points = taut_surface_points(s);
    double n[3 * LOCAL], sums[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; /* x_u, x_uu, x_uv */
    ring around;

    taut_surface_eval(s, u, v, order, d[0]);
    if (count < 2 || count > LOCAL || taut_basis_degree(taut_surface_v(s)) + 1 > LOCAL ||
        taut_basis_degree(taut_surface_v(s)) < 1) {
        return;
    }
    functions(s, edge, v, &around);
    taut_basis_eval(basis, span, u, order, n);
    for (int a = 0; a < count; a++) {
        const double first_part = n[count + a], second = order > 1 ? n[2 * count + a] : 0;
        if (first + a == edge || (first_part == 0 && second == 0)) {
            continue;
        }
        if (!alike(s, first + a, edge)) {
            return;
        }
        for (int j = 0; j < around.count; j++) {
            const double *p = points + 3 * ((first + a) * nv + around.first + j);
            double way[3];
            taut_difference(p, points + 3 * (edge * nv + around.first + j), way);
            taut_add_scaled(first_part * around.r[0][j], way, sums[0]);
            taut_add_scaled(second * around.r[0][j], way, sums[1]);
            taut_add_scaled(first_part * around.r[1][j], way, sums[2]);
        }
    }
    memcpy(d[TAUT_XU], sums[0], sizeof sums[0]);
    if (order > 1) {
        memcpy(d[TAUT_XUU], sums[1], sizeof sums[1]);
        memcpy(d[TAUT_XUV], sums[2], sizeof sums[2]);
    }
}
