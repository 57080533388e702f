/* strip.h -- the frames of a deformation, which are drawn side by side. */
#ifndef TAUT_DRAW_STRIP_H
#define TAUT_DRAW_STRIP_H

#include "core/arena.h"
#include "taut/model.h"

/* Are the surfaces of a model frames? So it is when `details.lambda` lists one number for each of
 * several surfaces. */
int taut_strip_is(const taut_model *model);
/* "lambda 0.2" for frame i of such a model, in the arena; NULL without memory. */
const char *taut_strip_label(const taut_model *model, int i, taut_arena *arena);

#endif /* TAUT_DRAW_STRIP_H */
