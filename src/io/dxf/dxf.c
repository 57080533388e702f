/* dxf.c -- pairs of lines, a code of what a value is and the value (AutoCAD 2000 DXF Reference).
 *
 * Everything has a handle, and says whose it is. Those of what every drawing has are fixed; entities count on. */
#include "io/dxf/dxf.h"

#include "core/number_text.h"
#include "io/json/utf8.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Handles, in hexadecimal in the file; layers from LAYER on, entities after them. */
enum {
    VIEWPORTS = 1,
    LINETYPES,
    LAYERS,
    STYLES,
    VIEWS,
    SYSTEMS,
    APPLICATIONS,
    DIMENSIONS,
    RECORDS,
    BY_BLOCK,
    BY_LAYER,
    CONTINUOUS,
    STANDARD,
    ACAD,
    TAUT,
    MODEL_SPACE,
    PAPER_SPACE,
    MODEL_BLOCK,
    MODEL_END,
    PAPER_BLOCK,
    PAPER_END,
    ROOT,
    GROUPS,
    LAYER
};

static void put_code(taut_dxf *dxf, int code)
{
    char text[16];
    snprintf(text, sizeof text, "%d\n", code);
    taut_sink_text(dxf->sink, text);
}

static void put_word(taut_dxf *dxf, int code, const char *word)
{
    put_code(dxf, code);
    taut_sink_text(dxf->sink, word);
    taut_sink_text(dxf->sink, "\n");
}

static void put_count(taut_dxf *dxf, int code, size_t count)
{
    put_code(dxf, code);
    taut_sink_count(dxf->sink, count);
    taut_sink_text(dxf->sink, "\n");
}

static void put_handle(taut_dxf *dxf, int code, size_t handle)
{
    char text[24];
    snprintf(text, sizeof text, "%zX", handle);
    put_word(dxf, code, text);
}

/* A real number has a point or an exponent. */
static void put_real(taut_dxf *dxf, int code, double x)
{
    char text[TAUT_NUMBER_ROOM + 2];
    const size_t length = taut_number_text(x, text);
    text[length] = '\0';
    if (strpbrk(text, ".e") == NULL) {
        strcat(text, ".0");
    }
    put_word(dxf, code, text);
}

/* Codes code, code + 10 and code + 20. */
static void put_point(taut_dxf *dxf, int code, double x, double y, double z)
{
    put_real(dxf, code, x);
    put_real(dxf, code + 10, y);
    put_real(dxf, code + 20, z);
}

/* The number of a character of two or three bytes. */
static unsigned code_point(const unsigned char *bytes, size_t length)
{
    return length == 2 ? (bytes[0] & 0x1fU) << 6 | (bytes[1] & 0x3fU)
                       : (bytes[0] & 0x0fU) << 12 | (bytes[1] & 0x3fU) << 6 | (bytes[2] & 0x3fU);
}

/* A text of one line: beyond ASCII as \U+00E4; what has no such number, control characters and those of `forbidden` as _. */
static void put_text(taut_dxf *dxf, int code, const char *text, const char *forbidden)
{
    put_code(dxf, code);
    for (size_t room = strlen(text); room > 0;) {
        const size_t length = taut_utf8_length(text, room);
        const unsigned char byte = (unsigned char)*text;
        if (length == 2 || length == 3) {
            char number[16];
            snprintf(number, sizeof number, "\\U+%04X",
                     code_point((const unsigned char *)text, length));
            taut_sink_text(dxf->sink, number);
        } else if (length != 1 || byte < 0x20 || byte == 0x7f || strchr(forbidden, *text) != NULL) {
            taut_sink_text(dxf->sink, "_");
        } else {
            taut_sink_bytes(dxf->sink, text, 1);
        }
        text += length > 0 ? length : 1;
        room -= length > 0 ? length : 1;
    }
    taut_sink_text(dxf->sink, "\n");
}

static const char not_in_layers[] = "<>/\\\":;?*|=,`";

/* The beginning of a thing: its type, handle, owner and class. */
static void put_thing(taut_dxf *dxf, const char *type, size_t handle, size_t owner)
{
    put_word(dxf, 0, type);
    put_handle(dxf, strcmp(type, "DIMSTYLE") == 0 ? 105 : 5, handle);
    put_handle(dxf, 330, owner);
}

static void open_table(taut_dxf *dxf, const char *name, size_t handle, size_t count)
{
    put_word(dxf, 0, "TABLE");
    put_word(dxf, 2, name);
    put_handle(dxf, 5, handle);
    put_handle(dxf, 330, 0);
    put_word(dxf, 100, "AcDbSymbolTable");
    put_count(dxf, 70, count);
}

/* An entry of a table, without flags. */
static void put_entry(taut_dxf *dxf, const char *type, size_t handle, size_t owner,
                      const char *class, const char *name)
{
    put_thing(dxf, type, handle, owner);
    put_word(dxf, 100, "AcDbSymbolTableRecord");
    put_word(dxf, 100, class);
    put_text(dxf, 2, name, strcmp(type, "LAYER") == 0 ? not_in_layers : "");
    if (strcmp(type, "BLOCK_RECORD") != 0) {
        put_count(dxf, 70, 0);
    }
}

static void close_table(taut_dxf *dxf)
{
    put_word(dxf, 0, "ENDTAB");
}

static void put_linetypes(taut_dxf *dxf)
{
    static const char *const names[] = {"ByBlock", "ByLayer", "Continuous"};
    open_table(dxf, "LTYPE", LINETYPES, 3);
    for (size_t i = 0; i < 3; i++) {
        put_entry(dxf, "LTYPE", BY_BLOCK + i, LINETYPES, "AcDbLinetypeTableRecord", names[i]);
        put_word(dxf, 3, "");
        put_count(dxf, 72, 65);
        put_count(dxf, 73, 0);
        put_real(dxf, 40, 0);
    }
    close_table(dxf);
}

static void put_layer(taut_dxf *dxf, size_t handle, const char *name, int colour)
{
    put_entry(dxf, "LAYER", handle, LAYERS, "AcDbLayerTableRecord", name);
    put_count(dxf, 62, (size_t)colour);
    put_word(dxf, 6, "Continuous");
}

static void put_layers(taut_dxf *dxf, int count)
{
    open_table(dxf, "LAYER", LAYERS, (size_t)count + 1);
    put_layer(dxf, LAYER, "0", 7);
    for (int i = 0; i < count; i++) {
        put_layer(dxf, ++dxf->handle, dxf->layers[i].name, dxf->layers[i].colour);
    }
    close_table(dxf);
}

static void put_style(taut_dxf *dxf)
{
    open_table(dxf, "STYLE", STYLES, 1);
    put_entry(dxf, "STYLE", STANDARD, STYLES, "AcDbTextStyleTableRecord", "Standard");
    put_real(dxf, 40, 0);
    put_real(dxf, 41, 1);
    put_real(dxf, 50, 0);
    put_count(dxf, 71, 0);
    put_real(dxf, 42, 1);
    put_word(dxf, 3, "txt");
    put_word(dxf, 4, "");
    close_table(dxf);
}

static void put_empty_table(taut_dxf *dxf, const char *name, size_t handle)
{
    open_table(dxf, name, handle, 0);
    if (handle == DIMENSIONS) {
        put_word(dxf, 100, "AcDbDimStyleTable");
    }
    close_table(dxf);
}

static void put_applications(taut_dxf *dxf)
{
    open_table(dxf, "APPID", APPLICATIONS, 2);
    put_entry(dxf, "APPID", ACAD, APPLICATIONS, "AcDbRegAppTableRecord", "ACAD");
    put_entry(dxf, "APPID", TAUT, APPLICATIONS, "AcDbRegAppTableRecord", "TAUT");
    close_table(dxf);
}

static void open_section(taut_dxf *dxf, const char *name)
{
    put_word(dxf, 0, "SECTION");
    put_word(dxf, 2, name);
}

static void put_tables(taut_dxf *dxf, int layers)
{
    open_section(dxf, "TABLES");
    put_empty_table(dxf, "VPORT", VIEWPORTS);
    put_linetypes(dxf);
    put_layers(dxf, layers);
    put_style(dxf);
    put_empty_table(dxf, "VIEW", VIEWS);
    put_empty_table(dxf, "UCS", SYSTEMS);
    put_applications(dxf);
    put_empty_table(dxf, "DIMSTYLE", DIMENSIONS);
    open_table(dxf, "BLOCK_RECORD", RECORDS, 2);
    put_entry(dxf, "BLOCK_RECORD", MODEL_SPACE, RECORDS, "AcDbBlockTableRecord", "*Model_Space");
    put_entry(dxf, "BLOCK_RECORD", PAPER_SPACE, RECORDS, "AcDbBlockTableRecord", "*Paper_Space");
    close_table(dxf);
    put_word(dxf, 0, "ENDSEC");
}

static void put_block(taut_dxf *dxf, size_t begin, size_t owner, const char *name)
{
    put_thing(dxf, "BLOCK", begin, owner);
    put_word(dxf, 100, "AcDbEntity");
    put_word(dxf, 8, "0");
    put_word(dxf, 100, "AcDbBlockBegin");
    put_word(dxf, 2, name);
    put_count(dxf, 70, 0);
    put_point(dxf, 10, 0, 0, 0);
    put_word(dxf, 3, name);
    put_word(dxf, 1, "");
    put_thing(dxf, "ENDBLK", begin + 1, owner);
    put_word(dxf, 100, "AcDbEntity");
    put_word(dxf, 8, "0");
    put_word(dxf, 100, "AcDbBlockEnd");
}

/* What $INSUNITS calls a unit. */
static size_t unit_number(const char *unit)
{
    static const struct {
        const char *unit;
        size_t number;
    } units[] = {{"in", 1}, {"ft", 2}, {"mm", 4}, {"cm", 5}, {"m", 6}};
    size_t number = 0; /* none */
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        number = strcmp(units[i].unit, unit) == 0 ? units[i].number : number;
    }
    return number;
}

static void put_header(taut_dxf *dxf, const char *unit)
{
    const size_t number = unit_number(unit);
    open_section(dxf, "HEADER");
    put_word(dxf, 9, "$ACADVER");
    put_word(dxf, 1, "AC1015");
    put_word(dxf, 9, "$DWGCODEPAGE");
    put_word(dxf, 3, "ANSI_1252");
    put_word(dxf, 9, "$INSUNITS");
    put_count(dxf, 70, number);
    put_word(dxf, 9, "$MEASUREMENT");
    put_count(dxf, 70, number > 2);
    put_word(dxf, 9, "$HANDSEED");
    put_word(dxf, 5, "FFFFFFFF");
    put_word(dxf, 0, "ENDSEC");
}

taut_dxf taut_dxf_begin(taut_sink *sink, const char *unit, int layer_count,
                        const taut_dxf_layer *layers)
{
    taut_dxf dxf = {sink, LAYER, layers};
    put_header(&dxf, unit);
    put_tables(&dxf, layer_count);
    open_section(&dxf, "BLOCKS");
    put_block(&dxf, MODEL_BLOCK, MODEL_SPACE, "*Model_Space");
    put_block(&dxf, PAPER_BLOCK, PAPER_SPACE, "*Paper_Space");
    put_word(&dxf, 0, "ENDSEC");
    open_section(&dxf, "ENTITIES");
    return dxf;
}

static void put_dictionary(taut_dxf *dxf, size_t handle, size_t owner)
{
    put_thing(dxf, "DICTIONARY", handle, owner);
    put_word(dxf, 100, "AcDbDictionary");
    put_count(dxf, 281, 1);
}

void taut_dxf_end(taut_dxf *dxf)
{
    put_word(dxf, 0, "ENDSEC");
    open_section(dxf, "OBJECTS");
    put_dictionary(dxf, ROOT, 0);
    put_word(dxf, 3, "ACAD_GROUP");
    put_handle(dxf, 350, GROUPS);
    put_dictionary(dxf, GROUPS, ROOT);
    put_word(dxf, 0, "ENDSEC");
    put_word(dxf, 0, "EOF");
}

static void open_entity(taut_dxf *dxf, const char *type, int layer, const char *class)
{
    put_thing(dxf, type, ++dxf->handle, MODEL_SPACE);
    put_word(dxf, 100, "AcDbEntity");
    put_text(dxf, 8, dxf->layers[layer].name, not_in_layers);
    put_word(dxf, 100, class);
}

static void close_entity(taut_dxf *dxf, const char *name)
{
    if (name != NULL && name[0] != '\0') {
        put_word(dxf, 1001, "TAUT");
        put_text(dxf, 1000, name, "");
    }
}

void taut_dxf_line(taut_dxf *dxf, int layer, const char *name, const double from[3],
                   const double to[3])
{
    open_entity(dxf, "LINE", layer, "AcDbLine");
    put_point(dxf, 10, from[0], from[1], from[2]);
    put_point(dxf, 11, to[0], to[1], to[2]);
    close_entity(dxf, name);
}

void taut_dxf_outline(taut_dxf *dxf, int layer, const char *name, size_t count,
                      const double *points, double z, int closed)
{
    open_entity(dxf, "LWPOLYLINE", layer, "AcDbPolyline");
    put_count(dxf, 90, count);
    put_count(dxf, 70, closed != 0);
    put_real(dxf, 38, z);
    for (size_t i = 0; i < count; i++) {
        put_real(dxf, 10, points[2 * i]);
        put_real(dxf, 20, points[2 * i + 1]);
    }
    close_entity(dxf, name);
}

void taut_dxf_polyline(taut_dxf *dxf, int layer, const char *name, size_t count,
                       const double *points)
{
    open_entity(dxf, "POLYLINE", layer, "AcDb3dPolyline");
    const size_t owner = dxf->handle;
    put_count(dxf, 66, 1);
    put_point(dxf, 10, 0, 0, 0);
    put_count(dxf, 70, 8);
    close_entity(dxf, name);
    for (size_t i = 0; i < count; i++) {
        put_thing(dxf, "VERTEX", ++dxf->handle, owner);
        put_word(dxf, 100, "AcDbEntity");
        put_text(dxf, 8, dxf->layers[layer].name, not_in_layers);
        put_word(dxf, 100, "AcDbVertex");
        put_word(dxf, 100, "AcDb3dPolylineVertex");
        put_point(dxf, 10, points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        put_count(dxf, 70, 32);
    }
    put_thing(dxf, "SEQEND", ++dxf->handle, owner);
    put_word(dxf, 100, "AcDbEntity");
    put_text(dxf, 8, dxf->layers[layer].name, not_in_layers);
}

void taut_dxf_spline(taut_dxf *dxf, int layer, const char *name, const taut_curve *curve)
{
    enum { CLOSED = 1, RATIONAL = 4 };
    const size_t count = (size_t)taut_basis_count(taut_curve_t(curve));
    const double *points = taut_curve_points(curve), *weights = taut_curve_weights(curve);
    const int closed = memcmp(points, points + 3 * (count - 1), 3 * sizeof *points) == 0;
    taut_basis_spec spec;

    taut_basis_spec_of(taut_curve_t(curve), &spec);
    open_entity(dxf, "SPLINE", layer, "AcDbSpline");
    put_count(dxf, 70, (size_t)((closed ? CLOSED : 0) + (weights != NULL ? RATIONAL : 0)));
    put_count(dxf, 71, (size_t)spec.degree);
    put_count(dxf, 72, (size_t)spec.knot_count);
    put_count(dxf, 73, count);
    put_count(dxf, 74, 0);
    for (int k = 0; k < spec.knot_count; k++) {
        put_real(dxf, 40, spec.knots[k]);
    }
    for (size_t i = 0; weights != NULL && i < count; i++) {
        put_real(dxf, 41, weights[i]);
    }
    for (size_t i = 0; i < count; i++) {
        put_point(dxf, 10, points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    }
    close_entity(dxf, name);
}

void taut_dxf_curve(taut_dxf *dxf, int layer, const taut_curve *curve)
{
    const taut_basis *basis = taut_curve_t(curve);
    const double *points = taut_curve_points(curve);
    const size_t count = (size_t)taut_basis_count(basis);
    const char *name = taut_curve_name(curve);

    if (taut_basis_degree(basis) != 1) {
        taut_dxf_spline(dxf, layer, name, curve);
    } else if (count == 2) { /* weights move nothing off a line */
        taut_dxf_line(dxf, layer, name, points, points + 3);
    } else {
        taut_dxf_polyline(dxf, layer, name, count, points);
    }
}

void taut_dxf_text(taut_dxf *dxf, int layer, const char *text, double x, double y, double height)
{
    enum { MIDDLE = 4 };
    open_entity(dxf, "TEXT", layer, "AcDbText");
    put_point(dxf, 10, x, y, 0);
    put_real(dxf, 40, height);
    put_text(dxf, 1, text, "");
    put_count(dxf, 72, MIDDLE);
    put_point(dxf, 11, x, y, 0);
    put_word(dxf, 100, "AcDbText");
}
