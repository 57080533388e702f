#include "geometry/net.h"

#include "core/fail.h"
#include "taut/surface.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* "/points/3/5", or "/points/3" when columns is 0. */
static void write_place(char *where, size_t size, const char *member, size_t index, int columns)
{
    if (columns > 0) {
        snprintf(where, size, "/%s/%zu/%zu", member, index / (size_t)columns,
                 index % (size_t)columns);
    } else {
        snprintf(where, size, "/%s/%zu", member, index);
    }
}

static taut_status check_points(size_t count, int columns, const double *points, taut_error *error)
{
    for (size_t i = 0; i < 3 * count; i++) {
        if (!isfinite(points[i])) {
            char where[64];
            write_place(where, sizeof where, "points", i / 3, columns);
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, points[i], taut_none,
                             "a coordinate is not a finite number");
        }
    }
    return TAUT_OK;
}

static taut_status check_weights(size_t count, int columns, const double *weights,
                                 taut_error *error)
{
    for (size_t i = 0; i < count; i++) {
        if (!(weights[i] > 0) || !isfinite(weights[i])) {
            char where[64];
            write_place(where, sizeof where, "weights", i, columns);
            return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, weights[i],
                                      "a positive number", "weight is %.17g", weights[i]);
        }
    }
    return TAUT_OK;
}

taut_status taut_net_check(const char *name, size_t count, int columns, const double *points,
                           const double *weights, const taut_basis *plain, taut_error *error)
{
    taut_status status = TAUT_OK;
    if (name != NULL && strlen(name) > TAUT_NAME_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/name", (double)strlen(name),
                         TAUT_NAME_MAX, "a name of %zu bytes, expected at most %d", strlen(name),
                         TAUT_NAME_MAX);
    }
    if (count > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/points", (double)count, TAUT_POINTS_MAX,
                         "%zu control points, expected at most %d", count, TAUT_POINTS_MAX);
    }
    status = check_points(count, columns, points, error);
    if (status != TAUT_OK || weights == NULL) {
        return status;
    }
    if (plain != NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/weights", taut_none, taut_none,
                         "a basis of type \"%s\" carries no weights", taut_basis_type(plain));
    }
    return check_weights(count, columns, weights, error);
}

static int is_rational(const char *text)
{
    static const char digits[] = "0123456789";
    const char *p = text + (*text == '-');
    const size_t top = strspn(p, digits);

    if (top == 0 || p[top] == '\0') {
        return top > 0;
    }
    p += top + 1;
    return p[-1] == '/' && p[strspn(p, "0")] != '\0' && p[strspn(p, digits)] == '\0';
}

taut_status taut_net_check_exact(size_t count, int columns, const char *const *exact,
                                 taut_error *error)
{
    for (size_t i = 0; i < 3 * count; i++) {
        if (exact[i] != NULL && !is_rational(exact[i])) {
            char where[64], whole[80];
            write_place(where, sizeof where, "points", i / 3, columns);
            snprintf(whole, sizeof whole, "%s/%zu", where, i % 3);
            return taut_fail_expected(error, TAUT_BAD_INPUT, "value", whole, taut_none,
                                      "a rational number as \"3/4\"", "found \"%.40s\"", exact[i]);
        }
    }
    return TAUT_OK;
}

void taut_net_homogeneous(size_t count, const double *points, const double *weights, double *net)
{
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            net[4 * i + c] = weights[i] * points[3 * i + c];
        }
        net[4 * i + 3] = weights[i];
    }
}

/* x = A/w, A = w x, so
 *     x_u  = (A_u  - w_u x) / w                              likewise x_v
 *     x_uu = (A_uu - 2 w_u x_u - w_uu x) / w                 likewise x_vv
 *     x_uv = (A_uv - w_u x_v - w_v x_u - w_uv x) / w         ([PieglTiller1997] eq. 4.20) */
void taut_net_project(int order, const double *h, double *values)
{
    const double w = h[3];
    double *x = values, *xu = values + 3, *xv = values + 6;

    for (int c = 0; c < 3; c++) {
        x[c] = h[c] / w;
    }
    if (order < 1) {
        return;
    }
    const double wu = h[4 * TAUT_XU + 3], wv = h[4 * TAUT_XV + 3];
    for (int c = 0; c < 3; c++) {
        xu[c] = (h[4 * TAUT_XU + c] - wu * x[c]) / w;
        xv[c] = (h[4 * TAUT_XV + c] - wv * x[c]) / w;
    }
    if (order < 2) {
        return;
    }
    const double wuu = h[4 * TAUT_XUU + 3], wuv = h[4 * TAUT_XUV + 3], wvv = h[4 * TAUT_XVV + 3];
    for (int c = 0; c < 3; c++) {
        values[3 * TAUT_XUU + c] = (h[4 * TAUT_XUU + c] - 2 * wu * xu[c] - wuu * x[c]) / w;
        values[3 * TAUT_XUV + c] = (h[4 * TAUT_XUV + c] - wu * xv[c] - wv * xu[c] - wuv * x[c]) / w;
        values[3 * TAUT_XVV + c] = (h[4 * TAUT_XVV + c] - 2 * wv * xv[c] - wvv * x[c]) / w;
    }
}

/* x^(k) = (A^(k) - sum_{i=1..k} C(k,i) w^(i) x^(k-i)) / w, A = w x ([PieglTiller1997] eq. 4.8). */
void taut_net_project_curve(int order, double h[TAUT_ORDER_MAX + 1][4], double *values)
{
    static const double binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    for (int k = 0; k <= order; k++) {
        for (int c = 0; c < 3; c++) {
            double sum = h[k][c];
            for (int i = 1; i <= k; i++) {
                sum -= binomial[k][i] * h[i][3] * values[3 * (k - i) + c];
            }
            values[3 * k + c] = sum / h[0][3];
        }
    }
}
