/* canvas.h -- the few drawing operations a figure needs.
 *
 * Coordinates are in page units, x to the right, y down, from the page's upper left corner. Every
 * shape is opaque. Faults stick: after the first the operations do nothing and `finish` says what
 * it was. One table writes SVG (canvas_svg.c), another PDF and PNG (modules/cairo, loaded when
 * first wanted). The memory of a canvas is the caller's, so that a table allocates nothing itself.
 */
#ifndef TAUT_DRAW_CANVAS_H
#define TAUT_DRAW_CANVAS_H

#include "mesh/colour.h"
#include "taut/status.h"

#include <stddef.h>
#include <stdint.h>

typedef struct taut_page {
    const char *kind; /* "svg", "pdf" or "png" */
    double width, height;
    double point;      /* of a page unit, in points of 1/72 inch */
    int pixels;        /* png: across, the height in proportion */
    const char *title; /* UTF-8, or NULL */
    int64_t date;      /* seconds since 1970 for formats that carry a date, or -1: none */
    int (*write)(void *context, const void *bytes, size_t count); /* 0 when it failed */
    void *context;
} taut_page;

typedef enum taut_anchor { TAUT_ANCHOR_START, TAUT_ANCHOR_MIDDLE, TAUT_ANCHOR_END } taut_anchor;

typedef struct taut_canvas taut_canvas; /* a table's own */

typedef struct taut_canvas_ops {
    size_t size; /* bytes of a canvas, zeroed by the caller */
    /* Starts a white page, borrowed until finish. On failure there is nothing to finish. */
    taut_status (*begin)(taut_canvas *canvas, const taut_page *page);
    void (*polygon)(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink);
    /* an open line through the points, its ends and joins round */
    void (*line)(taut_canvas *canvas, int count, const double (*xy)[2], taut_ink ink, double width);
    void (*disc)(taut_canvas *canvas, const double xy[2], double radius, taut_ink ink, taut_ink rim,
                 double rim_width);
    /* one line of valid UTF-8 on the baseline through (x, y), `size` its em */
    void (*text)(taut_canvas *canvas, double x, double y, double size, taut_anchor anchor,
                 taut_ink ink, const char *text);
    /* Another page of so many page units, and text on it about the middle (x, y), turned to `angle` from the x
     * axis to the y axis; NULL where a file is one page. */
    void (*next_page)(taut_canvas *canvas, double width, double height);
    void (*turned_text)(taut_canvas *canvas, double x, double y, double size, double angle,
                        taut_ink ink, const char *text);
    /* Ends the page and gives back all but the canvas's own memory: TAUT_OK, TAUT_IO when a write
     * failed, TAUT_NO_MEMORY. To be called once after every begin that succeeded. */
    taut_status (*finish)(taut_canvas *canvas);
} taut_canvas_ops;

extern const taut_canvas_ops taut_canvas_svg;

#endif /* TAUT_DRAW_CANVAS_H */
