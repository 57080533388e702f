/* exponent.h -- powers of two that bring numbers to size 1 and round nothing. */
#ifndef TAUT_GEOMETRY_EXPONENT_H
#define TAUT_GEOMETRY_EXPONENT_H

#include "taut/surface.h"

#include <math.h>
#include <stddef.h>

/* x = f 2^exponent with f in [1/2, 1); 0 for 0 and what is not finite. */
static inline int taut_exponent(double x)
{
    int exponent = 0;
    if (x > 0 && isfinite(x)) {
        frexp(x, &exponent);
    }
    return exponent;
}

/* The largest |coordinate|. */
static inline double taut_largest(size_t count, const double *points)
{
    double largest = 0;
    for (size_t k = 0; k < 3 * count; k++) {
        largest = fmax(largest, fabs(points[k]));
    }
    return largest;
}

/* Half the largest distance of a coordinate from the first point's. Half, as the whole may be twice
 * what a double holds. */
static inline double taut_half_size(size_t count, const double *points)
{
    double largest = 0;
    for (size_t k = 3; k < 3 * count; k++) {
        largest = fmax(largest, fabs(points[k] / 2 - points[k % 3] / 2));
    }
    return largest;
}

/* What halved points are to be multiplied by to be those divided by 2^scale; kept finite for points
 * too small to matter. */
static inline double taut_half_factor(int scale)
{
    return ldexp(1, 1 - scale > 1000 ? 1000 : 1 - scale);
}

/* The exponent of the length of a basis's range. */
static inline int taut_range_exponent(const taut_basis *basis)
{
    return taut_exponent(taut_basis_hi(basis) - taut_basis_lo(basis));
}

static inline size_t taut_point_count(const taut_surface *surface)
{
    return (size_t)taut_basis_count(taut_surface_u(surface)) *
           (size_t)taut_basis_count(taut_surface_v(surface));
}

#endif /* TAUT_GEOMETRY_EXPONENT_H */
