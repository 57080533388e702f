/* vec3.h -- vectors of three numbers. Results may be the same array as an input where the
 * computation is per component. */
#ifndef TAUT_CORE_VEC3_H
#define TAUT_CORE_VEC3_H

#include "core/elementary/elementary.h"

#include <math.h>

static inline double taut_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void taut_cross(const double a[3], const double b[3], double out[3])
{
    const double x = a[1] * b[2] - a[2] * b[1];
    const double y = a[2] * b[0] - a[0] * b[2];
    const double z = a[0] * b[1] - a[1] * b[0];
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

static inline double taut_norm(const double a[3])
{
    return taut_hypot(taut_hypot(a[0], a[1]), a[2]);
}

/* The same at a fifth of the cost, where squares neither overflow nor vanish. */
static inline double taut_length(const double a[3])
{
    return sqrt(taut_dot(a, a));
}

/* The largest absolute value of a coordinate. */
static inline double taut_largest_coordinate(const double a[3])
{
    return fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
}

static inline double taut_det(const double a[3], const double b[3], const double c[3])
{
    double normal[3];
    taut_cross(a, b, normal);
    return taut_dot(normal, c);
}

/* out = a - b */
static inline void taut_difference(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = a[k] - b[k];
    }
}

/* y += s x */
static inline void taut_add_scaled(double s, const double x[3], double y[3])
{
    for (int k = 0; k < 3; k++) {
        y[k] += s * x[k];
    }
}

static inline double taut_distance(const double a[3], const double b[3])
{
    double d[3];
    taut_difference(a, b, d);
    return taut_norm(d);
}

/* The same by taut_length. */
static inline double taut_length_between(const double a[3], const double b[3])
{
    double d[3];
    taut_difference(a, b, d);
    return taut_length(d);
}

#endif /* TAUT_CORE_VEC3_H */
