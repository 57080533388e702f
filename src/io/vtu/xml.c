/* xml.c -- an array is base 64 of its length in bytes, eight of them, and its numbers, all with
 * the lowest byte first. */
#include "io/vtu/xml.h"

#include <string.h>

/* Three bytes wait to become four letters. */
typedef struct base64 {
    taut_sink *sink;
    unsigned char bytes[3];
    int count;
} base64;

static void put_letters(base64 *out)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned whole =
        (unsigned)out->bytes[0] << 16 | (unsigned)out->bytes[1] << 8 | out->bytes[2];
    char text[4];
    for (int i = 0; i < 4; i++) {
        text[i] = i <= out->count ? letters[whole >> (18 - 6 * i) & 63] : '=';
    }
    taut_sink_bytes(out->sink, text, 4);
    memset(out->bytes, 0, sizeof out->bytes);
    out->count = 0;
}

/* The `size` lowest bytes of a number. */
static void put_bytes(base64 *out, uint64_t bits, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        out->bytes[out->count++] = (unsigned char)(bits >> (8 * i) & 0xff);
        if (out->count == 3) {
            put_letters(out);
        }
    }
}

static base64 open_array(taut_sink *sink, const char *type, const char *name, int components,
                         size_t bytes)
{
    base64 out = {sink, {0, 0, 0}, 0};
    taut_sink_text(sink, "<DataArray type=\"");
    taut_sink_text(sink, type);
    taut_sink_text(sink, "\" Name=\"");
    taut_sink_text(sink, name);
    taut_sink_text(sink, "\" NumberOfComponents=\"");
    taut_sink_count(sink, (size_t)components);
    taut_sink_text(sink, "\" format=\"binary\">\n");
    put_bytes(&out, bytes, 8);
    return out;
}

static void close_array(base64 *out)
{
    if (out->count > 0) {
        put_letters(out);
    }
    taut_sink_text(out->sink, "\n</DataArray>\n");
}

/* Every `stride`-th number from `values` on, `components` of them at a time. */
static void put_doubles(taut_sink *sink, const char *name, int components, size_t count,
                        size_t stride, const double *values)
{
    base64 out = open_array(sink, "Float64", name, components, 8 * count * (size_t)components);
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < (size_t)components; c++) {
            uint64_t bits = 0;
            memcpy(&bits, &values[i * stride + c], sizeof bits);
            put_bytes(&out, bits, 8);
        }
    }
    close_array(&out);
}

static void put_long(taut_sink *sink, const char *name, size_t count, const int64_t *values)
{
    base64 out = open_array(sink, "Int64", name, 1, 8 * count);
    for (size_t i = 0; i < count; i++) {
        put_bytes(&out, (uint64_t)values[i], 8);
    }
    close_array(&out);
}

/* One value over and over where `values` is NULL. */
static void put_int(taut_sink *sink, const char *name, int components, size_t count,
                    const int32_t *values, int32_t same)
{
    base64 out = open_array(sink, "Int32", name, components, 4 * count * (size_t)components);
    for (size_t i = 0; i < count * (size_t)components; i++) {
        put_bytes(&out, (uint32_t)(values != NULL ? values[i] : same), 4);
    }
    close_array(&out);
}

static void put_small(taut_sink *sink, const char *name, size_t count, const uint8_t *values)
{
    base64 out = open_array(sink, "UInt8", name, 1, count);
    for (size_t i = 0; i < count; i++) {
        put_bytes(&out, values[i], 1);
    }
    close_array(&out);
}

void vtu_xml_begin(taut_sink *sink, const char *unit)
{
    taut_sink_text(sink, "<?xml version=\"1.0\"?>\n<!-- taut, unit ");
    taut_sink_text(sink, unit);
    taut_sink_text(sink, " -->\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" "
                         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                         "<UnstructuredGrid>\n");
}

void vtu_xml_piece(taut_sink *sink, const vtu_grid *grid, int part)
{
    static const char *const names[] = {"H", "K", "E_minus_G", "F", "isothermality"};
    _Static_assert(sizeof names / sizeof names[0] == TAUT_FIELDS, "a name for each field");
    taut_sink_text(sink, "<Piece NumberOfPoints=\"");
    taut_sink_count(sink, grid->points);
    taut_sink_text(sink, "\" NumberOfCells=\"");
    taut_sink_count(sink, grid->cells);
    taut_sink_text(sink, "\">\n<PointData RationalWeights=\"RationalWeights\">\n");
    for (size_t f = 0; f < TAUT_FIELDS; f++) {
        put_doubles(sink, names[f], 1, grid->points, TAUT_FIELDS, grid->fields + f);
    }
    put_doubles(sink, "RationalWeights", 1, grid->points, 1, grid->weights);
    taut_sink_text(sink, "</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n");
    put_int(sink, "HigherOrderDegrees", 3, grid->cells, grid->degrees, 0);
    put_int(sink, "part", 1, grid->cells, NULL, part);
    put_int(sink, "surface", 1, grid->cells, grid->surfaces, 0);
    taut_sink_text(sink, "</CellData>\n<Points>\n");
    put_doubles(sink, "Points", 3, grid->points, 3, grid->positions);
    taut_sink_text(sink, "</Points>\n<Cells>\n");
    put_long(sink, "connectivity", grid->corners, grid->connectivity);
    put_long(sink, "offsets", grid->cells, grid->offsets);
    put_small(sink, "types", grid->cells, grid->types);
    taut_sink_text(sink, "</Cells>\n</Piece>\n");
}

void vtu_xml_end(taut_sink *sink)
{
    taut_sink_text(sink, "</UnstructuredGrid>\n</VTKFile>\n");
}
