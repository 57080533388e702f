/* flat.h -- flat pieces to cut, as lines and texts on layers: laths, read from a model's details (`sheets` and `pieces`), and cloth, from
 * its lines (io/flat/cloth.h).
 *
 * Sheets stand side by side. Layers of laths: SHEET, the borders of sheets; CUT, outlines, closed; SLOT, closed too; ENGRAVE, lines
 * and texts.
 */
#ifndef TAUT_IO_FLAT_FLAT_H
#define TAUT_IO_FLAT_FLAT_H

#include "core/arena.h"
#include "taut/model.h"

/* A layer: its name, the number of its colour in DXF, and its colour in SVG. Drawn from the last to the first. */
typedef struct taut_flat_layer {
    const char *name, *number, *colour;
} taut_flat_layer;
enum { TAUT_FLAT_LAYERS_MAX = 6 };

typedef struct taut_flat_line {
    int layer;
    int is_closed;
    size_t count;
    const double (*points)[2];
} taut_flat_line;

typedef struct taut_flat_text {
    const char *text;            /* the model's */
    double at[2], angle, height; /* at: its middle */
} taut_flat_text;

typedef struct taut_flat {
    int layer_count, text_layer;
    const taut_flat_layer *layers;
    size_t line_count, text_count;
    taut_flat_line *lines;
    taut_flat_text *texts;
    double size[2]; /* of all sheets */
} taut_flat;

/* Does the model have pieces to cut? */
int taut_flat_is(const taut_model *model);
/* In the arena. TAUT_NO_MEMORY; TAUT_BAD_INPUT, reason "value". */
taut_status taut_flat_read(const taut_model *model, taut_arena *arena, taut_flat *flat,
                           taut_error *error);

#endif /* TAUT_IO_FLAT_FLAT_H */
