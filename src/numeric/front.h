/* front.h -- the first columns of a dense symmetric matrix are eliminated: A = L D L^T of them, and what is left of the others.
 *
 * Columns are taken in panels, and what is right of a panel is mended by it at once, in tiles that stay in registers
 * ([GolubVanLoan2013] 4.2.9). No pivots are exchanged.
 */
#ifndef TAUT_NUMERIC_FRONT_H
#define TAUT_NUMERIC_FRONT_H

#include "core/pulse.h"

#include <stddef.h>

/* Numbers from a row of the front to the next: tiles may stick out. */
size_t taut_front_stride(size_t rows);
/* Numbers of a front of so many rows, and of the scratch that goes with it. */
size_t taut_front_size(size_t rows);
size_t taut_front_scratch(size_t rows);

/* Zeros where the lower half and the tiles beyond it are. */
void taut_front_clear(size_t rows, double *front);

/* front: rows of the stride above, aligned to 64 bytes as the scratch is; its lower half is read. Afterwards columns 0 .. own - 1 hold L
 * below and D on the diagonal, and the lower half of the rest is what is left. A pivot below 2^-45 of what its column began with
 * counts as negative. Returns how many do, or are. Once the pulse says stop, nothing of it has a meaning. */
int taut_front_factor(size_t rows, size_t own, double *front, double *scratch, taut_pulse *pulse);

#endif /* TAUT_NUMERIC_FRONT_H */
