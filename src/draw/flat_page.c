#include "draw/flat_page.h"

#include "core/unit.h"
#include "io/flat/flat.h"

#include <string.h>

static const double line_width = 0.1; /* mm */

/* The colour of a layer, "#d00000". */
static taut_ink ink_of(const taut_flat *flat, int layer)
{
    static const char digits[] = "0123456789abcdef";
    unsigned char parts[3];
    for (int k = 0; k < 3; k++) {
        const char *pair = flat->layers[layer].colour + 1 + 2 * k;
        parts[k] = (unsigned char)(16 * (strchr(digits, pair[0]) - digits) +
                                   (strchr(digits, pair[1]) - digits));
    }
    return (taut_ink){parts[0], parts[1], parts[2]};
}

/* As many page units as scale says to the model's, and width units wide. A line with its first point once more where it is closed; y goes down. */
static taut_status put_line(const taut_flat *flat, const taut_flat_line *line, double scale,
                            double top, double width, const taut_canvas_ops *ops,
                            taut_canvas *canvas, taut_arena *arena)
{
    const size_t count = line->count + (size_t)(line->is_closed != 0);
    double(*xy)[2] = taut_arena_take(arena, count, sizeof *xy);
    if (xy == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        xy[k][0] = scale * line->points[k % line->count][0];
        xy[k][1] = top - scale * line->points[k % line->count][1];
    }
    ops->line(canvas, (int)count, (const double(*)[2])xy, ink_of(flat, line->layer), width);
    return TAUT_OK;
}

taut_status taut_flat_page(const taut_model *model, double point, const taut_canvas_ops *ops,
                           taut_canvas *canvas, taut_arena *arena, taut_error *error)
{
    const double per_millimetre = 72 / 25.4 / point;
    const double scale = taut_unit_ratio(taut_model_unit(model), "mm") * per_millimetre;
    taut_flat flat;

    if (ops->next_page == NULL) {
        return TAUT_OK;
    }
    taut_status status = taut_flat_read(model, arena, &flat, error);
    if (status != TAUT_OK) {
        return status;
    }
    const double top = scale * flat.size[1];
    ops->next_page(canvas, scale * flat.size[0], top);
    for (size_t k = 0; status == TAUT_OK && k < flat.line_count; k++) {
        status = put_line(&flat, &flat.lines[k], scale, top, line_width * per_millimetre, ops,
                          canvas, arena);
    }
    for (size_t k = 0; k < flat.text_count; k++) {
        const taut_flat_text *text = &flat.texts[k];
        ops->turned_text(canvas, scale * text->at[0], top - scale * text->at[1],
                         scale * text->height, -text->angle, ink_of(&flat, flat.text_layer),
                         text->text);
    }
    return status;
}
