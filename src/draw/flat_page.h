/* flat_page.h -- flat pieces as one more page of a figure, 1:1. */
#ifndef TAUT_DRAW_FLAT_PAGE_H
#define TAUT_DRAW_FLAT_PAGE_H

#include "core/arena.h"
#include "draw/canvas.h"
#include "taut/model.h"

/* All sheets of a model that has pieces, side by side, on a page of their size, where a page unit is so
 * many points. Nothing where a file is one page. TAUT_NO_MEMORY, TAUT_BAD_INPUT. */
taut_status taut_flat_page(const taut_model *model, double point, const taut_canvas_ops *ops,
                           taut_canvas *canvas, taut_arena *arena, taut_error *error);

#endif /* TAUT_DRAW_FLAT_PAGE_H */
