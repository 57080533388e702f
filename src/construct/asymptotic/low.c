/* low.c -- the rows of the patch of bidegree n + 3.
 *
 * At a corner the cross derivative of edge e is its partner's derivative, p_f' = a p + b p' + c p''
 * (4 equations, 3 unknowns, consistent by (C2)), and both edges must give the same
 *     S_uv = a' p + (a + b') p' + (b + c') p'' + c p'''
 * (consistent by (C3)). What is normal to the tangent plane in R_uv is forced; the tangential part
 *     R_uv = nu N + y_1 R_u + y_2 R_v,   W_uv = W_u W_v / W + y_3 W
 * is free at each corner. In coordinates x with |x|^2 = |slopes of a, b, c on both edges|^2 less
 * its minimum, which no affine or projective map changes, the twelve numbers are the smallest
 * that keep weights and c above their margins, found by projections ([Hildreth1957]).
 */
#include "construct/asymptotic/low.h"

#include "construct/asymptotic/conditions.h"
#include "construct/asymptotic/poly.h"
#include "construct/asymptotic/ribbon.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/dense.h"

#include <string.h>

enum {
    FREE = 12, /* three per corner */
    LENGTH = TAUT_QUAD_DEGREE + 4,
    CONSTRAINTS = 4 * (LENGTH + 2),
    SWEEPS_MAX = 20000
};
static const double weight_margin = 0.2; /* of the boundary weight beside */
static const double cubic_margin = 0.4;  /* of the smaller end value of c */
static const double plane_match = 1e-9;  /* relative: data that passed (C2), (C3) to 1e-10 */

/* An edge at one of its ends: p and its derivatives, and (a, b, c) there. */
typedef struct low_end {
    double p[4][4];
    double abc[3];
} low_end;

typedef struct low {
    const taut_quad *quad;
    low_end ends[4][2];
    double base[4][4];                   /* S_uv at the corners for x = 0 */
    double move[4][3][4];                /* its derivatives by the corner's x */
    double plane_u[4][3], plane_v[4][3]; /* R_u, R_v there */
} low;

/* a x = b for the 4 x 3 matrix of the columns p, p', p''; the part of b outside stays over. */
static void in_plane(const low_end *end, const double b[4], double x[3])
{
    double a[12], scale[3];
    for (int k = 0; k < 3; k++) {
        scale[k] = 0.0;
        for (int i = 0; i < 4; i++) {
            scale[k] = fmax(scale[k], fabs(end->p[k][i]));
        }
        for (int i = 0; i < 4; i++) {
            a[4 * k + i] = end->p[k][i] / scale[k];
        }
    }
    (void)taut_least_norm(4, 3, a, b, 1e-13, x, NULL);
    for (int k = 0; k < 3; k++) {
        x[k] /= scale[k];
    }
}

static void fill_end(const taut_quad *quad, int e, int end, low_end *made)
{
    const int n = quad->degree;
    double h[TAUT_QUAD_POINTS][4], factor = 1.0;
    taut_quad_homogeneous(&quad->edges[e], n, h);
    for (int order = 0; order <= 3; order++) {
        for (int k = 0; k < 4; k++) {
            made->p[order][k] = factor * h[end == 0 ? 0 : n - order][k];
        }
        factor *= n - order;
        for (int j = 0; j < n - order; j++) {
            for (int k = 0; k < 4; k++) {
                h[j][k] = h[j + 1][k] - h[j][k];
            }
        }
    }
}

/* a p' + b p'' + c p''': S_uv but for the slopes of a, b, c. */
static void fixed_part(const low_end *end, double out[4])
{
    for (int k = 0; k < 4; k++) {
        out[k] =
            end->abc[0] * end->p[1][k] + end->abc[1] * end->p[2][k] + end->abc[2] * end->p[3][k];
    }
}

/* R_uv from S_uv: (S_uv - W_uv R - W_u R_v - W_v R_u) / W. */
static void euclidean_twist(const low *l, int c, const double s[4], double twist[3])
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    const low_end *const u = &l->ends[m[0].edge][m[0].end], *const v =
                                                                &l->ends[m[1].edge][m[1].end];
    const double w = u->p[0][3];
    for (int k = 0; k < 3; k++) {
        twist[k] = (s[k] - s[3] * u->p[0][k] / w - u->p[1][3] * l->plane_v[c][k] -
                    v->p[1][3] * l->plane_u[c][k]) /
                   w;
    }
}

/* The normal part of R_uv: of the curved edges' agreeing values, of the bilinear twist if both are
 * straight. */
static taut_status normal_part(const low *l, int c, double part[3], taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    double normal[3], twist[3], found[2] = {0, 0}, sum = 0.0, size = 0.0;
    int count = 0;
    taut_cross(l->plane_u[c], l->plane_v[c], normal);
    for (int k = 0; k < 2; k++) {
        double s[4];
        if (!l->quad->edges[m[k].edge].straight) {
            fixed_part(&l->ends[m[k].edge][m[k].end], s);
            euclidean_twist(l, c, s, twist);
            found[k] = taut_dot(twist, normal);
            size = fmax(size, taut_norm(twist) * taut_norm(normal));
            sum += found[k];
            count++;
        }
    }
    if (count == 2 && !(fabs(found[0] - found[1]) <= plane_match * size)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "", (found[0] - found[1]) / size, plane_match,
                         "the edges have no common twist at corner %s, because their torsions are "
                         "not opposite",
                         taut_asymptotic_corner_name(c));
    }
    if (count == 0) {
        for (int k = 0; k < 3; k++) {
            twist[k] = taut_quad_point(l->quad, 0, 0, 0)[k] - taut_quad_point(l->quad, 0, 1, 0)[k] -
                       taut_quad_point(l->quad, 2, 0, 0)[k] + taut_quad_point(l->quad, 2, 1, 0)[k];
        }
        sum = taut_dot(twist, normal);
        count = 1;
    }
    memset(part, 0, 3 * sizeof *part);
    taut_add_scaled(sum / count / taut_dot(normal, normal), normal, part);
    return TAUT_OK;
}

static taut_status fill_corner(low *l, int c, taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    const low_end *const u = &l->ends[m[0].edge][m[0].end], *const v =
                                                                &l->ends[m[1].edge][m[1].end];
    const double w = u->p[0][3], w_uv = u->p[1][3] * v->p[1][3] / w;
    double part[3];
    taut_status status = TAUT_OK;
    for (int k = 0; k < 3; k++) {
        l->plane_u[c][k] = (u->p[1][k] - u->p[1][3] * u->p[0][k] / w) / w;
        l->plane_v[c][k] = (v->p[1][k] - v->p[1][3] * v->p[0][k] / w) / w;
    }
    status = normal_part(l, c, part, error);
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        l->base[c][k] = w * part[k] + u->p[1][3] * l->plane_v[c][k] +
                        v->p[1][3] * l->plane_u[c][k] + w_uv * u->p[0][k] / w;
        l->move[c][0][k] = w * l->plane_u[c][k];
        l->move[c][1][k] = w * l->plane_v[c][k];
        l->move[c][2][k] = u->p[0][k];
    }
    l->base[c][3] = w_uv;
    l->move[c][0][3] = l->move[c][1][3] = 0.0;
    l->move[c][2][3] = w;
    return status;
}

/* The slopes of a, b, c that S_uv = s asks of the curved edges at a corner: their number. */
static int corner_slopes(const low *l, int c, const double s[4], int derivative, double out[6])
{
    int count = 0;
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const m = &taut_quad_corner[c][k];
        double rest[4], fixed[4];
        if (l->quad->edges[m->edge].straight) {
            continue;
        }
        fixed_part(&l->ends[m->edge][m->end], fixed);
        for (int i = 0; i < 4; i++) {
            rest[i] = s[i] - (derivative ? 0.0 : fixed[i]);
        }
        in_plane(&l->ends[m->edge][m->end], rest, out + count);
        count += 3;
    }
    return count;
}

/* Changes the corner's three coordinates so that the slopes' squares are a constant plus |x|^2:
 * Gram-Schmidt on the slopes' derivatives, then a shift to their least. */
static void normalise_corner(low *l, int c)
{
    double slopes[6], along[3][6];
    const int count = corner_slopes(l, c, l->base[c], 0, slopes);
    if (count == 0) {
        return;
    }
    for (int j = 0; j < 3; j++) {
        double length = 0.0, shift = 0.0;
        (void)corner_slopes(l, c, l->move[c][j], 1, along[j]);
        for (int pass = 0; pass < 2; pass++) { /* twice is enough for orthogonality */
            for (int i = 0; i < j; i++) {
                double part = 0.0;
                for (int k = 0; k < count; k++) {
                    part += along[i][k] * along[j][k];
                }
                for (int k = 0; k < count; k++) {
                    along[j][k] -= part * along[i][k];
                }
                for (int k = 0; k < 4; k++) {
                    l->move[c][j][k] -= part * l->move[c][i][k];
                }
            }
        }
        for (int k = 0; k < count; k++) {
            length = hypot(length, along[j][k]);
        }
        for (int k = 0; k < count; k++) {
            along[j][k] /= length;
            shift += along[j][k] * slopes[k];
        }
        for (int k = 0; k < 4; k++) {
            l->move[c][j][k] /= length;
            l->base[c][k] -= shift * l->move[c][j][k];
        }
    }
}

static void corner_s(const low *l, int c, const double *x, double s[4])
{
    memcpy(s, l->base[c], 4 * sizeof *s);
    for (int j = 0; j < 3; j++) {
        for (int k = 0; k < 4; k++) {
            s[k] += x[3 * c + j] * l->move[c][j][k];
        }
    }
}

/* The Bernstein coefficients of a, b, c on edge e. */
static void cubics(const low *l, int e, const double *x, double abc[3][4])
{
    for (int end = 0; end < 2; end++) {
        const low_end *const at = &l->ends[e][end];
        double s[4], fixed[4], slope[3];
        corner_s(l, taut_quad_partner[e][end].corner, x, s);
        fixed_part(at, fixed);
        for (int k = 0; k < 4; k++) {
            s[k] -= fixed[k];
        }
        in_plane(at, s, slope);
        for (int k = 0; k < 3; k++) {
            abc[k][end == 0 ? 0 : 3] = at->abc[k];
            abc[k][end == 0 ? 1 : 2] = at->abc[k] + (end == 0 ? slope[k] : -slope[k]) / 3;
        }
    }
}

/* S_v along edge e at degree n + 3: a p + b p' + c p''; on a straight edge the cubic through its
 * end values and slopes. */
static void cross_derivative(const low *l, int e, const double *x, double (*out)[4])
{
    const int n = l->quad->degree;
    double h[TAUT_QUAD_POINTS][4], abc[3][4], product[LENGTH][4], raised[LENGTH][4];
    memset(out, 0, (size_t)(n + 4) * sizeof *out);
    if (l->quad->edges[e].straight) {
        for (int end = 0; end < 2; end++) {
            const taut_quad_meeting *const f = &taut_quad_partner[e][end];
            const double *const value = l->ends[f->edge][f->end].p[1];
            double s[4];
            corner_s(l, f->corner, x, s);
            for (int k = 0; k < 4; k++) {
                product[end == 0 ? 0 : 3][k] = value[k];
                product[end == 0 ? 1 : 2][k] = value[k] + (end == 0 ? s[k] : -s[k]) / 3;
            }
        }
        taut_poly_elevate(3, 4, &product[0][0], n, &out[0][0]);
        return;
    }
    cubics(l, e, x, abc);
    taut_quad_homogeneous(&l->quad->edges[e], n, h);
    for (int order = 0; order < 3; order++) {
        taut_poly_scale(3, abc[order], n - order, 4, &h[0][0], &product[0][0]);
        taut_poly_elevate(n - order + 3, 4, &product[0][0], order, &raised[0][0]);
        for (int j = 0; j <= n + 3; j++) {
            for (int k = 0; k < 4; k++) {
                out[j][k] += raised[j][k];
            }
        }
        for (int j = 0; j < n - order; j++) {
            for (int k = 0; k < 4; k++) {
                h[j][k] = (n - order) * (h[j + 1][k] - h[j][k]);
            }
        }
    }
}

/* The quantities that must not be negative, at x: weights beside the boundary less their margin,
 * over the boundary weight; inner coefficients of c less theirs, over the smaller end value. */
static int slacks(const low *l, const taut_patch *patch, const double *x, double *out)
{
    const int m = patch->m;
    int count = 0;
    for (int e = 0; e < 4; e++) {
        const double sign = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0 ? 1.0 : -1.0;
        double row[LENGTH][4], abc[3][4];
        cross_derivative(l, e, x, row);
        for (int k = 1; k < m; k++) {
            const double w = taut_patch_at(patch, e, 0, k)[3];
            out[count++] = 1.0 + sign * row[k][3] / (m * w) - weight_margin;
        }
        cubics(l, e, x, abc);
        if (!l->quad->edges[e].straight && abc[2][0] * abc[2][3] > 0) {
            const double least = fmin(fabs(abc[2][0]), fabs(abc[2][3]));
            for (int k = 1; k <= 2; k++) {
                out[count++] = (abc[2][0] > 0 ? 1.0 : -1.0) * abc[2][k] / least - cubic_margin;
            }
        }
    }
    return count;
}

/* The x nearest to 0 with all slacks >= 0; 0 if there is none. */
static int find_free(const low *l, const taut_patch *patch, double x[FREE])
{
    double at_zero[CONSTRAINTS], unit[FREE] = {0}, g[FREE][CONSTRAINTS], square[CONSTRAINTS];
    double pull[CONSTRAINTS] = {0}, worst = 0.0;
    const int count = slacks(l, patch, unit, at_zero);
    memset(square, 0, sizeof square);
    memset(x, 0, FREE * sizeof *x);
    for (int j = 0; j < FREE; j++) {
        unit[j] = 1.0;
        (void)slacks(l, patch, unit, g[j]);
        unit[j] = 0.0;
        for (int i = 0; i < count; i++) {
            g[j][i] -= at_zero[i];
            square[i] += g[j][i] * g[j][i];
        }
    }
    for (int sweep = 0; sweep < SWEEPS_MAX; sweep++) {
        worst = 0.0;
        for (int i = 0; i < count; i++) {
            double slack = at_zero[i], next = 0.0;
            for (int j = 0; j < FREE; j++) {
                slack += g[j][i] * x[j];
            }
            worst = fmax(worst, -slack);
            next = square[i] > 0 ? fmax(0.0, pull[i] - slack / square[i]) : 0.0;
            for (int j = 0; j < FREE; j++) {
                x[j] += (next - pull[i]) * g[j][i];
            }
            pull[i] = next;
        }
        if (worst <= 1e-12) {
            return 1;
        }
    }
    return 0;
}

/* (C4) for this patch: c must not change sign. */
static taut_status check_regular(const low *l, taut_error *error)
{
    const double zero[FREE] = {0};
    for (int e = 0; e < 4; e++) {
        double abc[3][4], from = 0.0, to = 1.0;
        if (l->quad->edges[e].straight) {
            continue;
        }
        cubics(l, e, zero, abc);
        if (abc[2][0] * abc[2][3] > 0) {
            continue;
        }
        for (int step = 0; step < 60; step++) {
            double value = 0.0;
            const double middle = 0.5 * (from + to);
            taut_poly_eval(3, 1, abc[2], middle, &value);
            if (value * abc[2][0] > 0) {
                from = middle;
            } else {
                to = middle;
            }
        }
        return taut_fail(error, TAUT_NO_SOLUTION, "", from, taut_none,
                         "edge %s is singular at parameter %.6f: its normal would have to turn "
                         "over (sigma %+d and %+d at its ends, no inflection between); other legs, "
                         "or \"singular\": \"report\", build it",
                         taut_asymptotic_edge_name(e), from, taut_quad_sigma(l->quad, e, 0),
                         taut_quad_sigma(l->quad, e, 1));
    }
    return TAUT_OK;
}

static taut_status check_inflections(const taut_quad *quad, taut_error *error)
{
    for (int e = 0; e < 4; e++) {
        taut_ribbon ribbon;
        taut_ribbon_fill(quad, e, &ribbon);
        if (ribbon.inflections > 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "", ribbon.inflection[0], taut_none,
                             "edge %s has an inflection at parameter %.6f, where the patch of "
                             "degree n+3 would be singular: take surface \"5n-7\"",
                             taut_asymptotic_edge_name(e), ribbon.inflection[0]);
        }
    }
    return TAUT_OK;
}

static taut_status fill(low *l, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            fill_end(l->quad, e, end, &l->ends[e][end]);
        }
    }
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            const taut_quad_meeting *const f = &taut_quad_partner[e][end];
            if (!l->quad->edges[e].straight) {
                in_plane(&l->ends[e][end], l->ends[f->edge][f->end].p[1], l->ends[e][end].abc);
            }
        }
    }
    for (int c = 0; c < 4 && status == TAUT_OK; c++) {
        status = fill_corner(l, c, error);
        if (status == TAUT_OK) {
            normalise_corner(l, c);
        }
    }
    return status;
}

static void write_rows(const low *l, const double *x, taut_patch *patch)
{
    const int m = patch->m;
    for (int e = 0; e < 4; e++) {
        const double sign = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0 ? 1.0 : -1.0;
        double row[LENGTH][4];
        cross_derivative(l, e, x, row);
        for (int k = 1; k < m; k++) {
            const double share = k == 1 || k == m - 1 ? 0.5 : 1.0; /* two edges share these */
            double *const made = taut_patch_at(patch, e, 1, k);
            const double *const boundary = taut_patch_at(patch, e, 0, k);
            for (int d = 0; d < 4; d++) {
                made[d] += share * (boundary[d] + sign * row[k][d] / m);
            }
        }
    }
    for (int i = 2; i <= m - 2; i++) {
        for (int j = 2; j <= m - 2; j++) {
            patch->net[i * (m + 1) + j][3] = 1.0;
        }
    }
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const at = taut_quad_corner[c];
        double s[4];
        corner_s(l, c, x, s);
        euclidean_twist(l, c, s, patch->twist[c]);
        patch->weight[c] = taut_patch_at(patch, at->edge, 1, at->end == 0 ? 1 : m - 1)[3];
    }
}

taut_status taut_low_fill(const taut_quad *quad, int report_singular, taut_patch *patch,
                          taut_error *error)
{
    low l = {.quad = quad};
    double x[FREE];
    taut_status status = check_inflections(quad, error);
    if (status == TAUT_OK) {
        status = fill(&l, error);
    }
    if (status == TAUT_OK && !report_singular) {
        status = check_regular(&l, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    taut_patch_boundary(quad, patch);
    if (!find_free(&l, patch, x)) {
        return taut_fail(error, TAUT_NO_SOLUTION, "", taut_none, taut_none,
                         "no corner twists keep the weights of the patch of degree n+3 positive "
                         "and its boundary regular: take surface \"5n-7\"");
    }
    write_rows(&l, x, patch);
    return TAUT_OK;
}
