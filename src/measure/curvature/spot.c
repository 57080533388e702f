#include "measure/curvature/spot.h"

#include "geometry/exponent.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef struct patch {
    const double *points, *weights; /* at the first function alive */
    int columns;                    /* of the whole net */
    int local[2];
    double origin[3];
    double factor; /* 2^-scale, halved points apart */
} patch;

static const double inverse_factorial[4] = {1, 1, 0.5, 1.0 / 6};

/* values[k][a] = 2^(k shift) N_a^(k)(t) / k!; sums of absolute values in sum[k]. */
static void taylor_basis(const taut_basis *basis, int span, double t, int order, int shift,
                         double *values, double *sum)
{
    const int local = taut_basis_local(basis);
    taut_basis_eval(basis, span, t, order, values);
    for (int k = 0; k <= order; k++) {
        const double factor = ldexp(inverse_factorial[k], k * shift);
        sum[k] = 0;
        for (int a = 0; a < local; a++) {
            values[k * local + a] *= factor;
            sum[k] += fabs(values[k * local + a]);
        }
    }
}

/* What rounding is judged by: the largest coordinate, the extreme weights, and w with the absolute
 * values of the functions. */
typedef struct extent {
    double size, range[2];
    taut_jet gross;
} extent;

/* Adds row a of the net to the homogeneous jets h[0..3] and to the extent. */
static void add_row(const patch *p, int a, int order, const double *nu, const double *nv,
                    taut_jet h[4], extent *e)
{
    const double unit = p->weights != NULL ? p->weights[0] : 1;
    for (int b = 0; b < p->local[1]; b++) {
        const int64_t at = (int64_t)a * p->columns + b;
        const double w = p->weights != NULL ? p->weights[at] / unit : 1;
        double q[4] = {0, 0, 0, w};
        for (int c = 0; c < 3; c++) {
            const double value = (p->points[3 * at + c] / 2 - p->origin[c] / 2) * p->factor;
            e->size = fmax(e->size, fabs(value));
            q[c] = w * value;
        }
        e->range[0] = fmin(e->range[0], w);
        e->range[1] = fmax(e->range[1], w);
        for (int k = 0; k < (order + 1) * (order + 2) / 2; k++) {
            const double n = nu[taut_jet_power[k][0] * p->local[0] + a] *
                             nv[taut_jet_power[k][1] * p->local[1] + b];
            for (int c = 0; c < 4; c++) {
                h[c].c[k] += n * q[c];
            }
            e->gross.c[k] += fabs(n) * w;
        }
    }
}

/* The lesser of two bounds. Of the extreme weights, for those that are near each other; and for those
 * that are not, by the quotient rule with every term made positive,
 *
 *     b_k = (size g_k + sum_(l < k) b_l g_(k-l)) / w,   g = e->gross, g_0 = w, b_0 = size:
 *
 * a weight that is nothing beside w at this place adds nothing to its derivatives. */
static void bound_rounding(const extent *e, int is_rational, int count, const double *sum_u,
                           const double *sum_v, double *bound)
{
    taut_jet steep = {{e->size}};
    for (int k = 0; k < count; k++) {
        double sum = e->size * e->gross.c[k];
        for (int l = 0; l < k; l++) {
            const int i = taut_jet_power[k][0] - taut_jet_power[l][0];
            const int j = taut_jet_power[k][1] - taut_jet_power[l][1];
            sum += i >= 0 && j >= 0 ? steep.c[l] * e->gross.c[taut_jet_index(i, j)] : 0;
        }
        steep.c[k] = sum / e->gross.c[0];
        bound[k] = fmin(is_rational ? steep.c[k] : INFINITY, e->size * (e->range[1] / e->range[0]) *
                                                                 sum_u[taut_jet_power[k][0]] *
                                                                 sum_v[taut_jet_power[k][1]]);
    }
}

void taut_spot_at(const taut_surface *surface, int su, int sv, double u, double v, int order,
                  int scale, const int shift[2], taut_spot *spot)
{
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const double *weights = taut_surface_weights(surface);
    const int64_t first =
        (int64_t)taut_basis_first(bu, su) * taut_basis_count(bv) + taut_basis_first(bv, sv);
    patch p = {.points = taut_surface_points(surface) + 3 * first,
               .weights = weights != NULL ? weights + first : NULL,
               .columns = taut_basis_count(bv),
               .local = {taut_basis_local(bu), taut_basis_local(bv)},
               .factor = taut_half_factor(scale)};
    double nu[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    double nv[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    double sum_u[TAUT_ORDER_MAX + 1], sum_v[TAUT_ORDER_MAX + 1];
    extent e = {.size = 0, .range = {1, 1}};
    taut_jet h[4];

    memcpy(p.origin, p.points, sizeof p.origin);
    memset(h, 0, sizeof h);
    memset(spot, 0, sizeof *spot);
    taylor_basis(bu, su, u, order, shift[0], nu, sum_u);
    taylor_basis(bv, sv, v, order, shift[1], nv, sum_v);
    for (int a = 0; a < p.local[0]; a++) {
        add_row(&p, a, order, nu, nv, h, &e);
    }
    for (int c = 0; c < 3; c++) {
        spot->x[c] = weights != NULL ? taut_jet_divide(&h[c], &h[3]) : h[c];
        spot->x[c].c[0] += p.origin[c] / 2 * p.factor;
    }
    bound_rounding(&e, weights != NULL, (order + 1) * (order + 2) / 2, sum_u, sum_v, spot->bound);
    for (int c = 0; c < 3; c++) {
        memset(spot->x[c].c + (order + 1) * (order + 2) / 2, 0,
               (size_t)(TAUT_JET - (order + 1) * (order + 2) / 2) * sizeof(double));
    }
}
