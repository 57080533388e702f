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
    double top;           /* what a title takes of it */
    double least;         /* no letter is smaller, in page units */
} taut_legend;

/* The scale from -limit to limit, or of values of one sign (1 or -1) from or to 0; pointed ends when
 * values were cut off, a grey box when some points have none. */
typedef struct taut_legend_range {
    double limit;
    int sign, cut, has_grey;
} taut_legend_range;

/* In 1/unit (H) or 1/unit^2 (K). */
void taut_legend_scale(const taut_legend *legend, taut_colour colour,
                       const taut_legend_range *range, const char *unit);
/* Names beside their colours, row by row; at most TAUT_LEGEND_ROWS rows. */
enum { TAUT_LEGEND_ROWS = 12 };
void taut_legend_name(const taut_legend *legend, int row, taut_ink ink, int is_curve,
                      const char *name);
void taut_legend_title(const taut_legend *legend, const char *title);
/* What stands above one of several pictures, whose place is x0 y0 x1 y1. */
void taut_legend_label(const taut_legend *legend, const double place[4], const char *label);
/* Lines below, broken at "; " where they would be wider than the page; "" for none. The first begins at x and ends at
 * the height y; returns how many lines there are, and draws none where canvas is NULL. */
enum { TAUT_LEGEND_LINE = 24 };
int taut_legend_note(const taut_legend *legend, double x, double y, const char *note);
/* The axes about a point: they reach TAUT_LEGEND_AXES from it. */
enum { TAUT_LEGEND_AXES = 62 };
void taut_legend_axes(const taut_legend *legend, const taut_camera *camera, const double at[2]);
/* A bar of a round length from (x, y) to the right; returns where it and its number end. */
double taut_legend_bar(const taut_legend *legend, const taut_camera *camera, double x, double y,
                       const char *unit);

#endif /* TAUT_DRAW_LEGEND_H */
