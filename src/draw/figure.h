/* figure.h -- drawing a model: the picture that a person sees first. */
#ifndef TAUT_DRAW_FIGURE_H
#define TAUT_DRAW_FIGURE_H

#include "taut/model.h"
#include "taut/write.h"

#include <stdio.h>

/* Draws the model into an open file. kind: "svg", "pdf" or "png". */
taut_status taut_draw_figure(const taut_model *model, const taut_write_options *options,
                             const char *kind, FILE *out, taut_error *error);

#endif /* TAUT_DRAW_FIGURE_H */
