#include "io/dxf/r12.h"

#include "core/constants.h"
#include "core/fail.h"
#include "core/number_text.h"
#include "io/flat/flat.h"
#include "io/mesh/out.h"

#include <stdio.h>
#include <string.h>

static void put(taut_sink *sink, int code, const char *word)
{
    char text[16];
    snprintf(text, sizeof text, "%3d\n", code);
    taut_sink_text(sink, text);
    taut_sink_text(sink, word);
    taut_sink_text(sink, "\n");
}

static void put_count(taut_sink *sink, int code, size_t count)
{
    char text[24];
    snprintf(text, sizeof text, "%zu", count);
    put(sink, code, text);
}

static void put_real(taut_sink *sink, int code, double x)
{
    char text[TAUT_NUMBER_ROOM + 2];
    text[taut_number_text(x, text)] = '\0';
    if (strpbrk(text, ".e") == NULL) {
        strcat(text, ".0");
    }
    put(sink, code, text);
}

static void put_point(taut_sink *sink, int code, const double at[2])
{
    put_real(sink, code, at[0]);
    put_real(sink, code + 10, at[1]);
    put_real(sink, code + 20, 0);
}

static void put_header(taut_sink *sink, const taut_flat *flat, const char *unit)
{
    static const double origin[2] = {0, 0};
    char remark[64];
    snprintf(remark, sizeof remark, "taut, unit %s", unit);
    put(sink, 999, remark);
    put(sink, 0, "SECTION");
    put(sink, 2, "HEADER");
    put(sink, 9, "$ACADVER");
    put(sink, 1, "AC1009");
    put(sink, 9, "$EXTMIN");
    put_point(sink, 10, origin);
    put(sink, 9, "$EXTMAX");
    put_point(sink, 10, flat->size);
    put(sink, 0, "ENDSEC");
}

static void put_tables(taut_sink *sink, const taut_flat *flat)
{
    put(sink, 0, "SECTION");
    put(sink, 2, "TABLES");
    put(sink, 0, "TABLE");
    put(sink, 2, "LTYPE");
    put(sink, 70, "1");
    put(sink, 0, "LTYPE");
    put(sink, 2, "CONTINUOUS");
    put(sink, 70, "0");
    put(sink, 3, "Solid line");
    put(sink, 72, "65");
    put(sink, 73, "0");
    put_real(sink, 40, 0);
    put(sink, 0, "ENDTAB");
    put(sink, 0, "TABLE");
    put(sink, 2, "LAYER");
    put_count(sink, 70, (size_t)flat->layer_count);
    for (int k = 0; k < flat->layer_count; k++) {
        put(sink, 0, "LAYER");
        put(sink, 2, flat->layers[k].name);
        put(sink, 70, "0");
        put(sink, 62, flat->layers[k].number);
        put(sink, 6, "CONTINUOUS");
    }
    put(sink, 0, "ENDTAB");
    put(sink, 0, "ENDSEC");
}

static void put_line(taut_sink *sink, const taut_flat *flat, const taut_flat_line *line)
{
    static const double origin[2] = {0, 0};
    const char *layer = flat->layers[line->layer].name;
    put(sink, 0, "POLYLINE");
    put(sink, 8, layer);
    put(sink, 66, "1");
    put_point(sink, 10, origin);
    put(sink, 70, line->is_closed ? "1" : "0");
    for (size_t k = 0; k < line->count; k++) {
        put(sink, 0, "VERTEX");
        put(sink, 8, layer);
        put_point(sink, 10, line->points[k]);
    }
    put(sink, 0, "SEQEND");
    put(sink, 8, layer);
}

/* Its middle, codes 72 and 73, is at the second point. */
static void put_text(taut_sink *sink, const taut_flat *flat, const taut_flat_text *text)
{
    put(sink, 0, "TEXT");
    put(sink, 8, flat->layers[flat->text_layer].name);
    put_point(sink, 10, text->at);
    put_real(sink, 40, text->height);
    put(sink, 1, text->text);
    put_real(sink, 50, text->angle * 180 / TAUT_PI);
    put(sink, 72, "1");
    put_point(sink, 11, text->at);
    put(sink, 73, "2");
}

taut_status taut_r12_write(const taut_model *model, FILE *out, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    taut_sink sink = taut_sink_to(out);
    taut_flat flat;
    taut_status status =
        arena != NULL ? taut_flat_read(model, arena, &flat, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        put_header(&sink, &flat, taut_model_unit(model));
        put_tables(&sink, &flat);
        put(&sink, 0, "SECTION");
        put(&sink, 2, "ENTITIES");
        for (size_t k = 0; k < flat.line_count; k++) {
            put_line(&sink, &flat, &flat.lines[k]);
        }
        for (size_t k = 0; k < flat.text_count; k++) {
            put_text(&sink, &flat, &flat.texts[k]);
        }
        put(&sink, 0, "ENDSEC");
        put(&sink, 0, "EOF");
    }
    const taut_status written = taut_mesh_out_finish(&sink, status == TAUT_OK ? error : NULL);
    taut_arena_free(arena);
    return status == TAUT_OK ? written : status;
}
