/* gram.h -- Gram matrices of clamped B-splines for tests and benchmarks, and knots of several
 * kinds. */
#ifndef TAUT_TESTS_GRAM_H
#define TAUT_TESTS_GRAM_H

#include "numeric/band.h"

typedef enum gram_knots {
    GRAM_UNIFORM,  /* 0, 1, 2, ... */
    GRAM_GRADED,   /* span lengths geometric over six decades */
    GRAM_RANDOM,   /* span lengths random in [0.1, 1] */
    GRAM_REPEATED, /* uniform, every third interior knot repeated `degree` times where possible */
    GRAM_MIRRORED, /* span lengths random, symmetric about the middle */
    GRAM_KINDS
} gram_knots;

extern const char *const gram_names[GRAM_KINDS];

/* Knots double[count + degree + 1] of `count` functions, clamped, count > degree; first 0. */
void gram_knots_make(gram_knots kind, int degree, int count, unsigned seed, double *knots);

/* stiff(i,j) = int N_i' N_j',  mass(i,j) = int N_i N_j  over functions first..last of `count`, by
 * Gauss-Legendre with degree + 1 nodes a span, which is exact. Returns 0 when memory runs out. */
int gram_make(int degree, int count, const double *knots, int first, int last, taut_band *stiff,
              taut_band *mass);

#endif
