/* flat_page.h -- the plan of flat pieces as more pages of a figure: one of its size, 1:1 or smaller; or 1:1 on sheets of paper that
 * are put together.
 *
 * Sheets have a frame 10 mm from the edges of the paper, 18 mm from the lower one, where their number and a ruler of 100 mm
 * are. Frames of neighbours overlap by 10 mm; in the middle of that, crosses lie on each other. Sheets with nothing on them
 * are left out; before them comes the plan of all, as small as the paper wants it.
 */
#ifndef TAUT_DRAW_FLAT_PAGE_H
#define TAUT_DRAW_FLAT_PAGE_H

#include "core/arena.h"
#include "draw/canvas.h"
#include "taut/model.h"
#include "taut/write.h"

/* Sheets of a plan. */
enum { TAUT_TILES_MAX = 10000 };

/* Of a model that has pieces, where a page unit is so many points; options: tiles and reduction. Nothing where a file is one page.
 * TAUT_NO_MEMORY, TAUT_BAD_INPUT; TAUT_BAD_ARGUMENT, reason "argument" (more sheets than TAUT_TILES_MAX). */
taut_status taut_flat_page(const taut_model *model, const taut_write_options *options, double point,
                           const taut_canvas_ops *ops, taut_canvas *canvas, taut_arena *arena,
                           taut_error *error);

#endif /* TAUT_DRAW_FLAT_PAGE_H */
