/* contract.h -- products of V or V^T with a net, a panel of columns at a time.
 *
 * A net double[..] seen along one direction is a matrix of `points` rows and any number of columns;
 * column c has its entries at  x[offset(c) + row * stride],  offset(c) = c / inner * outer + c %
 * inner. A panel holds some columns in slivers of kernel->tile_columns, as the tile kernel wants
 * them.
 */
#ifndef TAUT_NUMERIC_CONTRACT_H
#define TAUT_NUMERIC_CONTRACT_H

#include "numeric/modes.h"

#include <stddef.h>

typedef struct taut_lines {
    size_t columns;
    size_t stride, inner, outer;
} taut_lines;

/* Seen along the first direction of double[nu][nv][nrhs], and along the second. */
taut_lines taut_lines_first(size_t nu, size_t nv, size_t nrhs);
taut_lines taut_lines_second(size_t nu, size_t nv, size_t nrhs);

typedef struct taut_panel {
    const taut_modes *modes;
    size_t width; /* columns it can hold, a multiple of tile_columns */
    double *in;   /* packed, double[n + 1][width] in slivers, part by part */
    double *out;  /* double[padded n][width] */
} taut_panel;

/* Scratch for products with `modes`. TAUT_OK or TAUT_NO_MEMORY. taut_panel_clear also after a
 * failure. */
taut_status taut_panel_init(const taut_modes *modes, size_t columns, taut_panel *panel);
void taut_panel_clear(taut_panel *panel);

/* Columns first..first+count-1 of x, count <= panel->width, become V^T x in place; rows are then
 * modes. Rows of zeros in the middle of the panel cost nothing. */
void taut_panel_analyse(const taut_panel *panel, const taut_lines *lines, size_t first,
                        size_t count, double *x);
/* The same columns become V x. */
void taut_panel_synthesise(const taut_panel *panel, const taut_lines *lines, size_t first,
                           size_t count, double *x);

#endif /* TAUT_NUMERIC_CONTRACT_H */
