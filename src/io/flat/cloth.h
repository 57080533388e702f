/* cloth.h -- the pieces of a cutting pattern on their roll, from the lines of the model (P1.cut, P1.right, ...) and the places that
 * details.roll gives.
 *
 * Layers: CUT, outlines, closed; SEW, the lines to sew along where the cloth is cut with an allowance; FOLD, those of hems; MARK, marks across seams and the arrow
 * along the warp; TEXT, names of pieces and along each seam of the neighbour; ROLL, the border of the roll. Curved lines are polylines whose chords
 * are within 0.05 mm, and within 1e-5 of the roll.
 */
#ifndef TAUT_IO_FLAT_CLOTH_H
#define TAUT_IO_FLAT_CLOTH_H

#include "io/flat/flat.h"

int taut_flat_is_cloth(const taut_model *model);
/* As taut_flat_read. */
taut_status taut_flat_read_cloth(const taut_model *model, taut_arena *arena, taut_flat *flat,
                                 taut_error *error);

#endif /* TAUT_IO_FLAT_CLOTH_H */
