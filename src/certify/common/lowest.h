/* lowest.h -- the eigenvector of the lowest eigenvalue of K x = lambda M x, by Lanczos. */
#ifndef TAUT_CERTIFY_COMMON_LOWEST_H
#define TAUT_CERTIFY_COMMON_LOWEST_H

#include "core/arena.h"
#include "core/pulse.h"

/* M is positive definite, and so is K - shift M on what its conditions leave. */
typedef struct taut_lowest {
    int count;
    const void *of;
    void (*solve)(const void *of, double *x);                  /* x = (K - shift M)^-1 x */
    void (*weigh)(const void *of, const double *x, double *y); /* y = M x, apart */
    double work;                                               /* operations of both together */
} taut_lowest;

/* x double[count], of unit mass, x . M x = 1. Lanczos from a vector that no symmetry shares, all that was found kept orthogonal,
 * begun again at what 24 steps found; it ends where the residual is below 1e-7 of the eigenvalue, whose error then is about
 * 1e-14 over the relative gap to the next, or after 480 steps. Arrays 50 count in the arena.
 * [Parlett1998, chapter 13]
 * TAUT_NOT_CONVERGED: the numbers left the range. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
taut_status taut_certify_lowest(const taut_lowest *form, taut_arena *arena, taut_pulse *pulse,
                                double *x);

#endif /* TAUT_CERTIFY_COMMON_LOWEST_H */
