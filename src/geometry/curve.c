/* curve.c -- curves: the object and its evaluation. */
#include "taut/curve.h"

#include "basis/basis_ops.h"
#include "core/fail.h"
#include "core/memory.h"
#include "geometry/net.h"

#include <string.h>

struct taut_curve {
    char name[TAUT_NAME_MAX + 1];
    taut_basis *t;
    double *points;
    double *weights; /* or NULL */
};

taut_status taut_curve_new(const char *name, const taut_basis *t, const double *points,
                           const double *weights, taut_curve **curve, taut_error *error)
{
    taut_status status = TAUT_OK;
    taut_curve *made = NULL;

    if (t == NULL || points == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "a curve needs a basis and points");
    }
    const size_t count = (size_t)taut_basis_count(t);
    const taut_basis *plain = taut_basis_allows_weights(t) ? NULL : t;
    status = taut_net_check(name, count, 0, points, weights, plain, error);
    if (status != TAUT_OK) {
        return status;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(made->name, name != NULL ? name : "", name != NULL ? strlen(name) : 0);
    made->points = taut_alloc_aligned(3 * count, sizeof(double));
    made->weights = weights != NULL ? taut_alloc_aligned(count, sizeof(double)) : NULL;
    if (made->points == NULL || (weights != NULL && made->weights == NULL) ||
        taut_basis_copy(t, &made->t) != TAUT_OK) {
        taut_curve_free(made);
        return taut_fail_memory(error);
    }
    memcpy(made->points, points, 3 * count * sizeof(double));
    if (weights != NULL) {
        memcpy(made->weights, weights, count * sizeof(double));
    }
    *curve = made;
    return TAUT_OK;
}

taut_status taut_curve_copy(const taut_curve *curve, taut_curve **copy)
{
    if (curve == NULL || copy == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    return taut_curve_new(curve->name, curve->t, curve->points, curve->weights, copy, NULL);
}

void taut_curve_free(taut_curve *curve)
{
    if (curve != NULL) {
        taut_basis_free(curve->t);
        taut_free(curve->points);
        taut_free(curve->weights);
        taut_free(curve);
    }
}

const char *taut_curve_name(const taut_curve *curve)
{
    return curve->name;
}

const taut_basis *taut_curve_t(const taut_curve *curve)
{
    return curve->t;
}

const double *taut_curve_points(const taut_curve *curve)
{
    return curve->points;
}

const double *taut_curve_weights(const taut_curve *curve)
{
    return curve->weights;
}

taut_status taut_curve_eval(const taut_curve *curve, double t, int order, double *values)
{
    double n[(TAUT_ORDER_MAX + 1) * (TAUT_DEGREE_MAX + 1)];
    double h[TAUT_ORDER_MAX + 1][4];

    if (curve == NULL || values == NULL || order < 0 || order > TAUT_ORDER_MAX ||
        !(t >= taut_basis_lo(curve->t) && t <= taut_basis_hi(curve->t))) {
        return TAUT_BAD_ARGUMENT;
    }
    const int span = taut_basis_span(curve->t, t);
    const int local = curve->t->shape.local;
    const int first = curve->t->first[span];

    curve->t->ops->eval(curve->t, span, t, order, n);
    if (curve->weights == NULL) {
        for (int k = 0; k <= order; k++) {
            double sum[3] = {0, 0, 0};
            for (int a = 0; a < local; a++) {
                for (int c = 0; c < 3; c++) {
                    sum[c] += n[k * local + a] * curve->points[3 * (first + a) + c];
                }
            }
            memcpy(values + 3 * k, sum, sizeof sum);
        }
        return TAUT_OK;
    }
    memset(h, 0, sizeof h);
    for (int k = 0; k <= order; k++) {
        for (int a = 0; a < local; a++) {
            const double nw = n[k * local + a] * curve->weights[first + a];
            for (int c = 0; c < 3; c++) {
                h[k][c] += nw * curve->points[3 * (first + a) + c];
            }
            h[k][3] += nw;
        }
    }
    taut_net_project_curve(order, h, values);
    return TAUT_OK;
}
