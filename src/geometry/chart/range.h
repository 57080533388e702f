/* range.h -- numbers between two others. Rounding is not counted: what begins with such ranges has room for it. */
#ifndef TAUT_GEOMETRY_CHART_RANGE_H
#define TAUT_GEOMETRY_CHART_RANGE_H

#include <math.h>

typedef struct taut_range {
    double lo, hi;
} taut_range;

static inline taut_range taut_range_of(double x)
{
    return (taut_range){x, x};
}
static inline taut_range taut_range_join(taut_range a, taut_range b)
{
    return (taut_range){fmin(a.lo, b.lo), fmax(a.hi, b.hi)};
}
static inline taut_range taut_range_add(taut_range a, taut_range b)
{
    return (taut_range){a.lo + b.lo, a.hi + b.hi};
}
static inline taut_range taut_range_minus(taut_range a, taut_range b)
{
    return (taut_range){a.lo - b.hi, a.hi - b.lo};
}
static inline taut_range taut_range_scale(double s, taut_range a)
{
    return s < 0 ? (taut_range){s * a.hi, s * a.lo} : (taut_range){s * a.lo, s * a.hi};
}
static inline taut_range taut_range_times(taut_range a, taut_range b)
{
    const double x[4] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    return (taut_range){fmin(fmin(x[0], x[1]), fmin(x[2], x[3])),
                        fmax(fmax(x[0], x[1]), fmax(x[2], x[3]))};
}
static inline double taut_range_size(taut_range a)
{
    return fmax(fabs(a.lo), fabs(a.hi));
}
static inline taut_range taut_range_square(taut_range a)
{
    const double least = a.lo > 0 ? a.lo : a.hi < 0 ? a.hi : 0, most = taut_range_size(a);
    return (taut_range){least * least, most * most};
}
static inline taut_range taut_range_dot(const taut_range a[3], const taut_range b[3])
{
    taut_range sum = {0, 0};
    for (int c = 0; c < 3; c++) {
        sum = taut_range_add(sum, a == b ? taut_range_square(a[c]) : taut_range_times(a[c], b[c]));
    }
    return sum;
}
static inline void taut_range_cross(const taut_range a[3], const taut_range b[3], taut_range out[3])
{
    for (int c = 0; c < 3; c++) {
        const int i = (c + 1) % 3, k = (c + 2) % 3;
        out[c] = taut_range_minus(taut_range_times(a[i], b[k]), taut_range_times(a[k], b[i]));
    }
}

#endif /* TAUT_GEOMETRY_CHART_RANGE_H */
