#include "draw/flat_svg.h"

#include "core/constants.h"
#include "core/fail.h"
#include "core/unit.h"
#include "io/flat/flat.h"
#include "io/mesh/out.h"

/* SVG's y goes down. */
typedef struct drawing {
    taut_sink *sink;
    double scale, top;
} drawing;

static void put_text(const drawing *to, const char *text)
{
    taut_sink_text(to->sink, text);
}

static void put_pair(const drawing *to, const double at[2], const char *between)
{
    taut_sink_number(to->sink, at[0] * to->scale);
    put_text(to, between);
    taut_sink_number(to->sink, to->top - at[1] * to->scale);
}

static void put_line(const drawing *to, const taut_flat_line *line)
{
    put_text(to, "<path d=\"");
    for (size_t k = 0; k < line->count; k++) {
        put_text(to, k == 0 ? "M" : " L");
        put_pair(to, line->points[k], " ");
    }
    put_text(to, line->is_closed ? " Z\"/>\n" : "\"/>\n");
}

static void put_escaped(const drawing *to, const char *text)
{
    for (; *text != '\0'; text++) {
        if (*text == '<' || *text == '&') {
            put_text(to, *text == '<' ? "&lt;" : "&amp;");
        } else {
            taut_sink_bytes(to->sink, text, 1);
        }
    }
}

static void put_word(const drawing *to, const taut_flat_text *text)
{
    const double low[2] = {0, -0.35 * text->height}; /* the foot of letters whose middle is at 0 */
    put_text(to, "<text transform=\"translate(");
    put_pair(to, text->at, " ");
    put_text(to, ") rotate(");
    taut_sink_number(to->sink, -text->angle * 180 / TAUT_PI);
    put_text(to, ")\" y=\"");
    taut_sink_number(to->sink, -low[1] * to->scale);
    put_text(to, "\" font-size=\"");
    taut_sink_number(to->sink, text->height * to->scale);
    put_text(to, "\">");
    put_escaped(to, text->text);
    put_text(to, "</text>\n");
}

static void put_all(const drawing *to, const taut_flat *flat)
{
    put_text(to, "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"");
    taut_sink_number(to->sink, flat->size[0] * to->scale);
    put_text(to, "mm\" height=\"");
    taut_sink_number(to->sink, flat->size[1] * to->scale);
    put_text(to, "mm\" viewBox=\"0 0 ");
    taut_sink_number(to->sink, flat->size[0] * to->scale);
    put_text(to, " ");
    taut_sink_number(to->sink, flat->size[1] * to->scale);
    put_text(to, "\">\n");
    for (int layer = flat->layer_count - 1; layer >= 0; layer--) {
        put_text(to, "<g id=\"");
        put_text(to, flat->layers[layer].name);
        put_text(to, "\" fill=\"none\" stroke=\"");
        put_text(to, flat->layers[layer].colour);
        put_text(to, "\" stroke-width=\"0.1\">\n");
        for (size_t k = 0; k < flat->line_count; k++) {
            if (flat->lines[k].layer == layer) {
                put_line(to, &flat->lines[k]);
            }
        }
        if (layer == flat->text_layer && flat->text_count > 0) {
            put_text(
                to, "<g font-family=\"sans-serif\" text-anchor=\"middle\" stroke=\"none\" fill=\"");
            put_text(to, flat->layers[layer].colour);
            put_text(to, "\">\n");
            for (size_t k = 0; k < flat->text_count; k++) {
                put_word(to, &flat->texts[k]);
            }
            put_text(to, "</g>\n");
        }
        put_text(to, "</g>\n");
    }
    put_text(to, "</svg>\n");
}

taut_status taut_flat_svg_write(const taut_model *model, FILE *out, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_sink sink = taut_sink_to(out);
    drawing to = {.sink = &sink, .scale = taut_unit_ratio(taut_model_unit(model), "mm")};
    taut_flat flat;
    const taut_status status =
        arena != NULL ? taut_flat_read(model, arena, &flat, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        to.top = flat.size[1] * to.scale;
        put_all(&to, &flat);
    }
    const taut_status written = taut_mesh_out_finish(&sink, status == TAUT_OK ? error : NULL);
    taut_arena_free(arena);
    return status == TAUT_OK ? written : status;
}
