/* taut/curve.h -- curves on any basis, optionally rational.
 *
 *     x(t) = sum_i w_i P_i N_i(t) / sum_i w_i N_i(t),   w = 1 without weights
 *
 * Immutable, deep copies of what they are given; every call is safe from any thread.
 */
#ifndef TAUT_CURVE_H
#define TAUT_CURVE_H

#include "taut/basis.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_curve taut_curve;

/* name     at most TAUT_NAME_MAX bytes of UTF-8 (else U+FFFD in JSON), NULL means ""
 * t        the basis, copied
 * points   double[n][3], finite, n the count of t
 * weights  double[n], finite and positive, or NULL; only on bases that allow them
 * TAUT_BAD_INPUT with error->where such as "/weights/3"; TAUT_NO_MEMORY. The caller owns *curve. */
TAUT_API taut_status taut_curve_new(const char *name, const taut_basis *t, const double *points,
                                    const double *weights, taut_curve **curve, taut_error *error);
/* A deep copy, the caller's. TAUT_NO_MEMORY. */
TAUT_API taut_status taut_curve_copy(const taut_curve *curve, taut_curve **copy);
TAUT_API void taut_curve_free(taut_curve *curve); /* NULL is fine */

TAUT_API const char *taut_curve_name(const taut_curve *curve);      /* borrowed, never NULL */
TAUT_API const taut_basis *taut_curve_t(const taut_curve *curve);   /* borrowed */
TAUT_API const double *taut_curve_points(const taut_curve *curve);  /* borrowed */
TAUT_API const double *taut_curve_weights(const taut_curve *curve); /* borrowed, or NULL */

/* values double[order+1][3]: position and derivatives at t, order 0..TAUT_ORDER_MAX; t in the
 * closed range, else TAUT_BAD_ARGUMENT. No allocation. */
TAUT_API taut_status taut_curve_eval(const taut_curve *curve, double t, int order, double *values);

/* The same at t[0] .. t[count-1], in any order: values double[count][order+1][3]. A parameter out of
 * range is TAUT_BAD_ARGUMENT, and nothing is written. threads 0 or 1: this thread; more: so many; the
 * result is the same for any number. No allocation. */
TAUT_API taut_status taut_curve_eval_points(const taut_curve *curve, int count, const double *t,
                                            int order, int threads, double *values);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_CURVE_H */
