/* flat_svg.h -- flat pieces as SVG, 1:1 in millimetres. */
#ifndef TAUT_DRAW_FLAT_SVG_H
#define TAUT_DRAW_FLAT_SVG_H

#include "taut/model.h"

#include <stdio.h>

/* A group a layer, with the layer's name as its id. */
taut_status taut_flat_svg_write(const taut_model *model, FILE *out, taut_error *error);

#endif /* TAUT_DRAW_FLAT_SVG_H */
