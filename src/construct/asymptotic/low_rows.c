#include "construct/asymptotic/low.h"

#include "numeric/bernstein.h"
#include "numeric/dense.h"

#include <math.h>
#include <string.h>

enum { SWEEPS_MAX = 20000 };
static const double weight_margin = 0.2; /* of the boundary weight beside */
static const double cubic_margin = 0.4;  /* of the smaller end value of c */

/* a p + b p' + c p'' on a curved edge; the cubic through its end values and slopes on a straight
 * one. */
void taut_low_cross(const taut_low *l, int e, const double *x, double (*out)[4])
{
    const int n = l->quad->degree;
    double h[TAUT_QUAD_POINTS][4], abc[3][4], product[TAUT_LOW_LENGTH][4],
        raised[TAUT_LOW_LENGTH][4];
    memset(out, 0, (size_t)(n + 4) * sizeof *out);
    if (l->quad->edges[e].straight) {
        for (int end = 0; end < 2; end++) {
            const taut_quad_meeting *const f = &taut_quad_partner[e][end];
            const double *const value = l->ends[f->edge][f->end].p[1];
            double s[4];
            taut_low_s(l, f->corner, x, s);
            for (int k = 0; k < 4; k++) {
                product[end == 0 ? 0 : 3][k] = value[k];
                product[end == 0 ? 1 : 2][k] = value[k] + (end == 0 ? s[k] : -s[k]) / 3;
            }
        }
        taut_bernstein_raise(3, 4, &product[0][0], n, &out[0][0]);
        return;
    }
    taut_low_cubics(l, e, x, abc);
    taut_quad_homogeneous(&l->quad->edges[e], n, h);
    for (int order = 0; order < 3; order++) {
        taut_bernstein_scale(3, abc[order], n - order, 4, &h[0][0], &product[0][0]);
        taut_bernstein_raise(n - order + 3, 4, &product[0][0], order, &raised[0][0]);
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

void taut_low_write(const taut_low *l, const double *x, taut_patch *patch)
{
    const int m = patch->m;
    for (int e = 0; e < 4; e++) {
        for (int k = 1; k < m; k++) {
            memset(taut_patch_at(patch, e, 1, k), 0, 4 * sizeof(double));
        }
    }
    for (int e = 0; e < 4; e++) {
        const double sign = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0 ? 1.0 : -1.0;
        double row[TAUT_LOW_LENGTH][4];
        taut_low_cross(l, e, x, row);
        for (int k = 1; k < m; k++) {
            const double share = k == 1       ? patch->share[e][0] /* two edges give these */
                                 : k == m - 1 ? patch->share[e][1]
                                              : 1.0;
            double *const made = taut_patch_at(patch, e, 1, k);
            const double *const boundary = taut_patch_at(patch, e, 0, k);
            for (int d = 0; d < 4; d++) {
                made[d] += share * (boundary[d] + sign * row[k][d] / m);
            }
        }
    }
    for (int i = 2; i <= m - 2; i++) {
        for (int j = 2; j <= m - 2; j++) {
            double *const inner = patch->net[i * (m + 1) + j];
            memset(inner, 0, 3 * sizeof *inner);
            inner[3] = 1.0;
        }
    }
    for (int c = 0; c < 4; c++) {
        const taut_quad_meeting *const at = taut_quad_corner[c];
        double s[4];
        taut_low_s(l, c, x, s);
        taut_low_twist(l, c, s, patch->twist[c]);
        patch->weight[c] = taut_patch_at(patch, at->edge, 1, at->end == 0 ? 1 : m - 1)[3];
    }
}

/* The quantities that must not be negative, at x: weights beside the boundary less their margin,
 * over the boundary weight; inner coefficients of c less theirs, over the smaller end value. */
static int fill_slacks(const taut_low *l, const taut_patch *patch, const double *x, double *out)
{
    const int m = patch->m;
    int count = 0;
    for (int e = 0; e < 4; e++) {
        const double sign = e == TAUT_ASYMPTOTIC_V0 || e == TAUT_ASYMPTOTIC_U0 ? 1.0 : -1.0;
        double row[TAUT_LOW_LENGTH][4], abc[3][4];
        taut_low_cross(l, e, x, row);
        for (int k = 1; k < m; k++) {
            const double w = taut_patch_at(patch, e, 0, k)[3];
            out[count++] = 1.0 + sign * row[k][3] / (m * w) - weight_margin;
        }
        taut_low_cubics(l, e, x, abc);
        if (!l->quad->edges[e].straight && abc[2][0] * abc[2][3] > 0) {
            const double least = fmin(fabs(abc[2][0]), fabs(abc[2][3]));
            for (int k = 1; k <= 2; k++) {
                out[count++] = (abc[2][0] > 0 ? 1.0 : -1.0) * abc[2][k] / least - cubic_margin;
            }
        }
    }
    return count;
}

void taut_low_limit(const taut_low *low, const taut_patch *patch, taut_low_limits *limits)
{
    double unit[TAUT_LOW_FREE] = {0};
    limits->count = fill_slacks(low, patch, unit, limits->slack);
    for (int j = 0; j < TAUT_LOW_FREE; j++) {
        unit[j] = 1.0;
        (void)fill_slacks(low, patch, unit, limits->gradient[j]);
        unit[j] = 0.0;
        for (int i = 0; i < limits->count; i++) {
            limits->gradient[j][i] -= limits->slack[i];
        }
    }
}

/* y <- r'^-1 y: a constraint's gradient in the coordinates r x. */
static void to_metric(const double *r, double *y)
{
    for (int i = 0; i < TAUT_LOW_FREE; i++) {
        for (int k = 0; k < i; k++) {
            y[i] -= r[i * TAUT_LOW_FREE + k] * y[k];
        }
        y[i] /= r[i * TAUT_LOW_FREE + i];
    }
}

/* The projections, in coordinates y = r (x - target) in which distance is Euclidean: each
 * constraint in turn pulls y to its half-space and lets go of what it pulled too far. */
static int project_cyclically(int count, double (*normal)[TAUT_LOW_FREE], const double *slack,
                              double *y)
{
    double pull[TAUT_LOW_CONSTRAINTS] = {0}, square[TAUT_LOW_CONSTRAINTS] = {0};
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < TAUT_LOW_FREE; j++) {
            square[i] += normal[i][j] * normal[i][j];
        }
    }
    for (int sweep = 0; sweep < SWEEPS_MAX; sweep++) {
        double worst = 0.0;
        for (int i = 0; i < count; i++) {
            double here = slack[i], next = 0.0;
            for (int j = 0; j < TAUT_LOW_FREE; j++) {
                here += normal[i][j] * y[j];
            }
            worst = fmax(worst, -here);
            next = square[i] > 0 ? fmax(0.0, pull[i] - here / square[i]) : 0.0;
            for (int j = 0; j < TAUT_LOW_FREE; j++) {
                y[j] += (next - pull[i]) * normal[i][j];
            }
            pull[i] = next;
        }
        if (worst <= 1e-12) {
            return 1;
        }
    }
    return 0;
}

int taut_low_nearest(const taut_low_limits *limits, const double *r, const double *target,
                     double *x)
{
    double normal[TAUT_LOW_CONSTRAINTS][TAUT_LOW_FREE], slack[TAUT_LOW_CONSTRAINTS];
    double y[TAUT_LOW_FREE] = {0};
    for (int i = 0; i < limits->count; i++) {
        slack[i] = limits->slack[i];
        for (int j = 0; j < TAUT_LOW_FREE; j++) {
            normal[i][j] = limits->gradient[j][i];
            slack[i] += limits->gradient[j][i] * target[j];
        }
        if (r != NULL) {
            to_metric(r, normal[i]);
        }
    }
    if (!project_cyclically(limits->count, normal, slack, y)) {
        return 0;
    }
    if (r != NULL && !taut_triangle_solve(TAUT_LOW_FREE, TAUT_LOW_FREE, r, y)) {
        return 0;
    }
    for (int j = 0; j < TAUT_LOW_FREE; j++) {
        x[j] = target[j] + y[j];
    }
    return 1;
}
