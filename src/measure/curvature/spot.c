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

/* Adds row a of the net to the homogeneous jets h[0..3]; the largest coordinate goes to *size, the
 * extreme weights to range[]. */
static void add_row(const patch *p, int a, int order, const double *nu, const double *nv,
                    taut_jet h[4], double *size, double range[2])
{
    const double unit = p->weights != NULL ? p->weights[0] : 1;
    for (int b = 0; b < p->local[1]; b++) {
        const int64_t at = (int64_t)a * p->columns + b;
        const double w = p->weights != NULL ? p->weights[at] / unit : 1;
        double q[4] = {0, 0, 0, w};
        for (int c = 0; c < 3; c++) {
            const double value = (p->points[3 * at + c] / 2 - p->origin[c] / 2) * p->factor;
            *size = fmax(*size, fabs(value));
            q[c] = w * value;
        }
        range[0] = fmin(range[0], w);
        range[1] = fmax(range[1], w);
        for (int k = 0; k < (order + 1) * (order + 2) / 2; k++) {
            const double n = nu[taut_jet_power[k][0] * p->local[0] + a] *
                             nv[taut_jet_power[k][1] * p->local[1] + b];
            for (int c = 0; c < 4; c++) {
                h[c].c[k] += n * q[c];
            }
        }
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
    double size = 0, range[2] = {1, 1};
    taut_jet h[4];

    memcpy(p.origin, p.points, sizeof p.origin);
    memset(h, 0, sizeof h);
    memset(spot, 0, sizeof *spot);
    taylor_basis(bu, su, u, order, shift[0], nu, sum_u);
    taylor_basis(bv, sv, v, order, shift[1], nv, sum_v);
    for (int a = 0; a < p.local[0]; a++) {
        add_row(&p, a, order, nu, nv, h, &size, range);
    }
    for (int c = 0; c < 3; c++) {
        spot->x[c] = weights != NULL ? taut_jet_divide(&h[c], &h[3]) : h[c];
        spot->x[c].c[0] += p.origin[c] / 2 * p.factor;
    }
    for (int k = 0; k < (order + 1) * (order + 2) / 2; k++) {
        spot->bound[k] = size * (range[1] / range[0]) * sum_u[taut_jet_power[k][0]] *
                         sum_v[taut_jet_power[k][1]];
    }
    for (int c = 0; c < 3; c++) {
        memset(spot->x[c].c + (order + 1) * (order + 2) / 2, 0,
               (size_t)(TAUT_JET - (order + 1) * (order + 2) / 2) * sizeof(double));
    }
}
