/* contract.h -- products of V or V^T with a net, a panel of columns at a time.
 *
 * A net double[..] seen along one direction is a matrix of n rows and any number of columns;
 * column c has its entries at
 *     x[offset(c) + row * stride],    offset(c) = c / inner * outer + c % inner
 */
#ifndef TAUT_NUMERIC_TENSOR_CONTRACT_H
#define TAUT_NUMERIC_TENSOR_CONTRACT_H

#include "numeric/modes.h"

#include <stddef.h>

typedef struct taut_lines {
    size_t columns;
    size_t stride, inner, outer;
} taut_lines;

/* Seen along the first direction of double[nu][nv][nrhs], and along the second. */
taut_lines taut_lines_first(size_t nu, size_t nv, size_t nrhs);
taut_lines taut_lines_second(size_t nu, size_t nv, size_t nrhs);

/* Scratch: some columns in slivers of kernel->tile_columns, as the tile kernel wants them, and some
 * rows of their product. */
typedef struct taut_panel {
    const taut_modes *modes;
    double *in, *out;
} taut_panel;

/* TAUT_OK or TAUT_NO_MEMORY; clear also after a failure. Takes 1 MiB or so. */
taut_status taut_panel_init(const taut_modes *modes, taut_panel *panel);
void taut_panel_clear(taut_panel *panel);

/* x becomes V^T x in place; rows are then modes. Rows of zeros cost nothing in between. */
void taut_analyse(const taut_panel *panel, const taut_lines *lines, double *x);
/* x becomes V x. */
void taut_synthesise(const taut_panel *panel, const taut_lines *lines, double *x);

/* Rows of modes that are zero but at their ends: those of up to kernel->lanes modes of one part,
 * the same ends for all of them. */
typedef struct taut_tail_block {
    int first, used;   /* modes */
    size_t keep[2];    /* points at the start and at the end of each row */
    double *values[2]; /* double[used][keep][rhs] */
} taut_tail_block;

typedef struct taut_tails {
    size_t blocks[2];          /* of each part, in the order of its modes */
    taut_tail_block *block[2]; /* the second points into the first */
    size_t points, rhs;        /* a whole row is double[points][rhs] */
} taut_tails;

/* Blocks for all modes, nothing kept yet. TAUT_OK or TAUT_NO_MEMORY; clear also after a failure. */
taut_status taut_tails_init(const taut_modes *modes, size_t points, size_t rhs, taut_tails *out);
void taut_tails_clear(taut_tails *tails);

/* x becomes, or gains if not is_new, V times the tails. */
void taut_synthesise_tails(const taut_panel *panel, const taut_lines *lines,
                           const taut_tails *tails, int is_new, double *x);

#endif /* TAUT_NUMERIC_TENSOR_CONTRACT_H */
