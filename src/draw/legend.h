/* legend.h -- what stands around a figure: the scale of its colours, names, title, axes. */
#ifndef TAUT_DRAW_LEGEND_H
#define TAUT_DRAW_LEGEND_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "taut/write.h"

typedef struct taut_legend {
    const taut_canvas_ops *ops;
    taut_canvas *canvas;
    double width, height; /* of the page */
} taut_legend;

/* The scale from -limit to limit in 1/unit (H) or 1/unit^2 (K), or from 0 (isothermality); pointed
 * ends when values were cut off, a grey box when some points have none. */
void taut_legend_scale(const taut_legend *legend, taut_colour colour, double limit, int cut,
                       int has_grey, const char *unit);
/* Names beside their colours, row by row; at most TAUT_LEGEND_ROWS rows. */
enum { TAUT_LEGEND_ROWS = 12 };
void taut_legend_name(const taut_legend *legend, int row, taut_ink ink, int is_curve,
                      const char *name);
void taut_legend_title(const taut_legend *legend, const char *title);
/* What stands above one of several pictures, whose place is x0 y0 x1 y1. */
void taut_legend_label(const taut_legend *legend, const double place[4], const char *label);
/* A line below; "" for none. */
void taut_legend_note(const taut_legend *legend, const char *note);
void taut_legend_axes(const taut_legend *legend, const taut_camera *camera);

#endif /* TAUT_DRAW_LEGEND_H */
