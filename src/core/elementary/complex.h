/* complex.h -- size, angle and exponential of complex numbers by the functions of elementary.h. */
#ifndef TAUT_CORE_ELEMENTARY_COMPLEX_H
#define TAUT_CORE_ELEMENTARY_COMPLEX_H

#include "core/elementary/elementary.h"

#include <complex.h>

static inline double taut_cabs(double complex z)
{
    return taut_hypot(creal(z), cimag(z));
}

static inline double taut_carg(double complex z)
{
    return taut_atan2(cimag(z), creal(z));
}

static inline double complex taut_cexp(double complex z)
{
    const double size = taut_exp(creal(z));
    return size * taut_cos(cimag(z)) + I * (size * taut_sin(cimag(z)));
}

#endif /* TAUT_CORE_ELEMENTARY_COMPLEX_H */
