/* apply.h -- the operator of a tensor-product energy, applied to a net.
 *
 *     A X = su Ku X Mv + sv Mu X Kv,      X double[nu][nv][nrhs], one column of nrhs at a time
 */
#ifndef TAUT_NUMERIC_TENSOR_APPLY_H
#define TAUT_NUMERIC_TENSOR_APPLY_H

#include "core/crew.h"
#include "numeric/band.h"

typedef struct taut_tensor {
    const taut_band *ku, *mu; /* nu rows */
    const taut_band *kv, *mv; /* nv rows */
    double su, sv;
    const taut_crew *
        crew; /* or NULL: its threads share the rows of both calls, to the same bits; its pulse is told of them, and
                            * they may return TAUT_INTERRUPTED */
} taut_tensor;

/* y = A x; x and y apart. Cost O(nu nv nrhs width). TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_tensor_apply(const taut_tensor *tensor, int nrhs, const double *x, double *y);

/* r = right - A x, every entry as if computed in about twice the working precision and then
 * rounded: for iterative refinement. r may be `right`. *norm, if not NULL: Euclidean norm of r over
 * that of right, 0 when both are zero. TAUT_OK or TAUT_NO_MEMORY. */
taut_status taut_tensor_residual(const taut_tensor *tensor, int nrhs, const double *right,
                                 const double *x, double *r, double *norm);

#endif /* TAUT_NUMERIC_TENSOR_APPLY_H */
