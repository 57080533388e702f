/* strip.h -- the frames of a deformation side by side, as one model to be drawn. */
#ifndef TAUT_DRAW_STRIP_H
#define TAUT_DRAW_STRIP_H

#include "taut/model.h"
#include "taut/write.h"

/* Are the surfaces of a model frames, and all of them to be drawn? So it is when `details.lambda`
 * lists one number for each of several surfaces. */
int taut_strip_is(const taut_model *model, const taut_write_options *options);

/* The frames moved in the plane of the page into rows, named by their lambda; the view goes into
 * *options if none was asked for. TAUT_NO_MEMORY, TAUT_BAD_ARGUMENT (nothing finite). */
taut_status taut_strip_new(const taut_model *model, taut_write_options *options,
                           taut_model **strip);

#endif /* TAUT_DRAW_STRIP_H */
