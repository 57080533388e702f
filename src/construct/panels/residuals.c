#include "construct/panels/residuals.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static void minus(const double *a, const double *b, double *difference)
{
    for (int k = 0; k < 3; k++) {
        difference[k] = a[k] - b[k];
    }
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *product)
{
    for (int k = 0; k < 3; k++) {
        product[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
}

/* At `at`, between the directions to a and b. */
static double angle(const double *at, const double *a, const double *b)
{
    double p[3], q[3], n[3];
    minus(a, at, p);
    minus(b, at, q);
    cross(p, q, n);
    return atan2(sqrt(dot(n, n)), dot(p, q));
}

static void raise(double *largest, double value)
{
    if (!(value <= *largest)) {
        *largest = value;
    }
}

static void measure_panel(const double *const corner[4], taut_panels_residuals *r)
{
    double one[3], two[3], side[3], n[3];
    minus(corner[2], corner[0], one);
    minus(corner[3], corner[1], two);
    minus(corner[1], corner[0], side);
    cross(one, two, n);
    raise(&r->planarity,
          2 * fabs(dot(side, n)) / (sqrt(dot(n, n)) * (sqrt(dot(one, one)) + sqrt(dot(two, two)))));
    for (int k = 0; k < 2; k++) {
        raise(&r->circle, fabs(angle(corner[k], corner[k + 1], corner[(k + 3) % 4]) +
                               angle(corner[k + 2], corner[(k + 3) % 4], corner[k + 1]) - pi));
    }
}

void taut_panels_measure(int nu, int nv, const double *vertices, taut_panels_residuals *residuals)
{
    taut_panels_residuals r = {0, nu > 2 && nv > 2 ? 0 : (double)NAN, 0, 0};

    for (int i = 0; i + 1 < nu; i++) {
        for (int j = 0; j + 1 < nv; j++) {
            const double *const at = vertices + 3 * ((long)i * nv + j);
            const double *const corner[4] = {at, at + 3 * (long)nv, at + 3 * ((long)nv + 1),
                                             at + 3};
            measure_panel(corner, &r);
        }
    }
    for (int i = 1; i + 1 < nu; i++) {
        for (int j = 1; j + 1 < nv; j++) {
            const double *const at = vertices + 3 * ((long)i * nv + j);
            const double *const around[4] = {at + 3 * (long)nv, at + 3, at - 3 * (long)nv, at - 3};
            double sum = 0;
            for (int k = 0; k < 4; k++) {
                sum += (k % 2 == 0 ? 1 : -1) * angle(at, around[k], around[(k + 1) % 4]);
            }
            raise(&r.balance, fabs(sum));
        }
    }
    *residuals = r;
}
