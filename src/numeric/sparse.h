/* sparse.h -- symmetric systems of blocks, few of them not zero: A = L D L^T by fronts, and inertia.
 *
 * Rows come in nodes of 0 to 3. Which nodes meet is said by cliques, such as the functions alive on a cell:
 * two nodes of one clique have a block. The order is that of least degree in the quotient graph (George and Liu 1981), nodes with the
 * same neighbours left go together, and each such group is a dense front (Duff and Reid 1983). No pivots are exchanged: for matrices
 * that are definite, or that are told apart from those that are by their inertia alone; a pivot below 2^-45 of what its front began with counts as negative.
 * Same input, same bytes: ties go to the lower node.
 */
#ifndef TAUT_NUMERIC_SPARSE_H
#define TAUT_NUMERIC_SPARSE_H

#include "core/pulse.h"
#include "taut/status.h"

#include <stddef.h>

typedef struct taut_sparse taut_sparse;

/* sizes[nodes]; clique k has members[first[k]] to members[first[k + 1] - 1], each once. TAUT_NO_MEMORY. */
taut_status taut_sparse_new(int nodes, const unsigned char *sizes, int cliques, const int *first,
                            const int *members, taut_sparse **sparse);
void taut_sparse_free(taut_sparse *sparse); /* NULL is fine */

int taut_sparse_rows(const taut_sparse *sparse);
/* The first row of a node. */
int taut_sparse_row(const taut_sparse *sparse, int node);
/* Multiplications and additions of one factor, about. */
double taut_sparse_work(const taut_sparse *sparse);

/* Block (a, b) of the matrix, row by row: [size of a][size of b]; asked for either of (a, b), (b, a). */
typedef void taut_sparse_block(const void *context, int a, int b, double *block);

/* *negative: how many pivots are not positive. pulse, which may be NULL, is told of it. TAUT_NO_MEMORY; TAUT_INTERRUPTED: there
 * are no factors then. */
taut_status taut_sparse_factor(taut_sparse *sparse, taut_sparse_block *block, const void *context,
                               taut_pulse *pulse, int *negative);
/* x[rows]: the right side, then the solution of the last factor. */
void taut_sparse_solve(const taut_sparse *sparse, double *x);

#endif /* TAUT_NUMERIC_SPARSE_H */
