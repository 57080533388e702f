/* solver.h -- the linear system of a tensor-product energy, by diagonalising one direction.
 *
 *     su Ku X Mv + sv Mu X Kv = R,      X, R double[nu][nv][nrhs], one column of nrhs at a time
 *
 * With Ku V = Mu V Lambda, V^T Mu V = I (numeric/modes.h) and Y = V^-1 X the rows of Y part:
 *     (su lambda_i Mv + sv Kv) y_i = (V^T R)_i,    X = V Y
 * banded systems, many at once ([LynchRiceThomas1964]; one direction only, [BuzbeeGolubNielson1970]
 * 3).
 *
 * Every const call is safe from any thread where there is no pulse.
 */
#ifndef TAUT_NUMERIC_TENSOR_SOLVER_H
#define TAUT_NUMERIC_TENSOR_SOLVER_H

#include "core/crew.h"
#include "numeric/band.h"
#include "taut/status.h"

typedef struct taut_tensor_solver taut_tensor_solver;

/* ku, mu   nu x nu; kv, mv nv x nv; widths free. mu and mv positive definite, ku and kv positive
 *          semidefinite, not both singular. Copied.
 * su, sv   finite, > 0
 * crew     NULL, or the threads of every solve, and the pulse (or NULL) that this and every solve tell of their work; it must
 *          live as long. Calls of one solver are then for one thread at a time, and may return TAUT_INTERRUPTED, x of no
 *          meaning. Any number of threads solves to the same bits
 *
 * Cost: O(n^2 width^2) for the eigenvectors of the better direction. Memory: about 16 n^2 bytes,
 * half of that for knots that mirror. Returns TAUT_OK; TAUT_BAD_ARGUMENT; TAUT_NO_SOLUTION when the
 * system is singular or not definite to working precision; TAUT_CHECK_FAILED, TAUT_NO_MEMORY. *out
 * untouched on failure. */
taut_status taut_tensor_solver_new(const taut_band *ku, const taut_band *mu, const taut_band *kv,
                                   const taut_band *mv, double su, double sv, const taut_crew *crew,
                                   taut_tensor_solver **out);
void taut_tensor_solver_free(taut_tensor_solver *solver); /* NULL is fine */

/* Other weights, the same eigenvectors: cost O(n). Statuses as new; the solver is unchanged on
 * failure. */
taut_status taut_tensor_solver_rescale(taut_tensor_solver *solver, double su, double sv);

/* Solves in place: x double[nu][nv][nrhs] is R on entry. nrhs >= 1.
 * Accuracy: ||A X - R|| is a small multiple of 2^-53 (|| |A| |X| || + ||R||).
 * Cost: 4 nrhs n^3 multiply-adds, half for mirrored knots; half again where R is zero away from the
 * boundary. Memory: 1 MiB or O(nrhs n width) a thread, whichever is more.
 * Returns TAUT_OK, TAUT_BAD_ARGUMENT or TAUT_NO_MEMORY (x untouched). */
taut_status taut_tensor_solver_solve(const taut_tensor_solver *solver, int nrhs, double *x);

/* One step of iterative refinement: x += A^-1 (right - A x), the residual taken in twice the
 * precision. *before is the relative residual ||right - A x|| / ||right|| of x on entry. Memory: a
 * copy of x. Returns TAUT_OK, TAUT_BAD_ARGUMENT or TAUT_NO_MEMORY (x untouched). */
taut_status taut_tensor_solver_refine(const taut_tensor_solver *solver, int nrhs,
                                      const double *right, double *x, double *before);

#endif /* TAUT_NUMERIC_TENSOR_SOLVER_H */
