/* threemf.c -- the format `3mf` (3MF Core Specification 1.3): a zip archive of three files, of which 3D/3dmodel.model is
 *
 *     <model unit>
 *       <resources>
 *         <basematerials>   a colour for each surface, under its name
 *         <object>          one for each body: surfaces that hang together, by their vertices
 *       <build>             every object once
 *
 * An object is of type "model" where it is closed: every run between two places is there once each way. Else it is of type
 * "surface", which may be open and cannot be printed. */
#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "io/file/xml.h"
#include "io/format.h"
#include "io/mesh/out.h"
#include "io/zip/zip.h"
#include "mesh/colour.h"

#include <stdlib.h>
#include <string.h>

static const char types_text[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";
static const char relations_text[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

/* A triangle's side between two places, the lower first, and its way. */
typedef struct side {
    uint32_t lo, hi;
    int forwards;
} side;

enum {
    SIDE_WORK = 100
}; /* operations to note a triangle, or to sort a side, as pulses count them */

typedef struct threemf {
    const taut_model *model;
    const taut_mesh *mesh;
    taut_sink sink; /* the model's text */
    int groups, surfaces;
    int *body;        /* [groups]: the first group of its body */
    uint32_t *vertex; /* [vertices]: the number of a place in its object */
    uint32_t *place;  /* [vertices]: the place of a number */
    side *sides;      /* [3 triangles], of the body at hand, as they come, */
    side *sorted;     /* [3 triangles], and by their lower place, */
    size_t *begin;    /* [vertices + 1]: which begin here */
    size_t side_count, vertex_count, triangle_count;
} threemf;

static const char *unit_word(const char *unit)
{
    static const char *const words[][2] = {
        {"cm", "centimeter"}, {"m", "meter"}, {"in", "inch"}, {"ft", "foot"}};
    const char *word = "millimeter";
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        word = strcmp(words[i][0], unit) == 0 ? words[i][1] : word;
    }
    return word;
}

static int root_of(int *body, int group)
{
    while (body[group] != group) {
        body[group] = body[body[group]];
        group = body[group];
    }
    return group;
}

static void unite(int *body, int a, int b)
{
    const int x = root_of(body, a), y = root_of(body, b);
    body[x < y ? y : x] = x < y ? x : y;
}

/* Groups with a place in common, and groups of one surface, are one body. */
static taut_status find_bodies(threemf *file, taut_arena *arena)
{
    const uint32_t *welded = taut_mesh_welded(file->mesh);
    const size_t vertices = taut_mesh_vertex_count(file->mesh);
    int *owner = taut_arena_take(arena, vertices, sizeof *owner);
    if (owner == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int g = 0; g < file->groups; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(file->mesh, g);
        file->body[g] = g;
        for (size_t i = 0; i < (size_t)group->nu * (size_t)group->nv; i++) {
            owner[group->first_vertex + i] = g;
        }
    }
    for (size_t i = 0; i < vertices; i++) {
        unite(file->body, owner[i], owner[welded[i]]);
        (void)taut_pulse_beat(&file->sink.pulse, SIDE_WORK);
    }
    for (int g = 0; g < file->groups; g++) {
        unite(file->body, g, taut_mesh_out_colour(file->mesh, file->surfaces, g));
    }
    for (int g = 0; g < file->groups; g++) {
        file->body[g] = root_of(file->body, g);
    }
    return TAUT_OK;
}

static void put_colour(taut_sink *sink, taut_ink ink)
{
    static const char digits[] = "0123456789ABCDEF";
    const unsigned char bytes[3] = {ink.r, ink.g, ink.b};
    taut_sink_text(sink, "#");
    for (int c = 0; c < 3; c++) {
        taut_sink_bytes(sink, &digits[bytes[c] / 16], 1);
        taut_sink_bytes(sink, &digits[bytes[c] % 16], 1);
    }
}

static void put_materials(threemf *file)
{
    taut_sink *sink = &file->sink;
    char room[TAUT_NAME_MAX + 1];
    taut_sink_text(sink, "<basematerials id=\"1\">\n");
    for (int g = 0; g < file->surfaces; g++) {
        taut_sink_text(sink, "<base name=\"");
        taut_xml_text(sink, taut_mesh_out_name(taut_mesh_group_at(file->mesh, g), room));
        taut_sink_text(sink, "\" displaycolor=\"");
        put_colour(sink, taut_colour_plain(
                             taut_mesh_out_plain(file->model, file->mesh, file->surfaces, g)));
        taut_sink_text(sink, "\"/>\n");
    }
    taut_sink_text(sink, "</basematerials>\n");
}

/* Calls `put` for each triangle of a body, its corners' places in their order. */
typedef void put_triangle(threemf *file, int group, const uint32_t places[3]);

static void each_triangle(threemf *file, int body, put_triangle *put)
{
    const uint32_t *welded = taut_mesh_welded(file->mesh);
    for (int g = body; g < file->groups; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(file->mesh, g);
        size_t count = 0;
        const uint32_t *triangle = taut_mesh_out_triangles(file->mesh, group, &count);
        for (size_t i = 0; file->body[g] == body && i < count; i++, triangle += 3) {
            uint32_t places[3];
            for (size_t k = 0; k < 3; k++) {
                places[k] = welded[triangle[taut_mesh_out_corner(group, 3, k)]];
            }
            if (taut_mesh_out_is_kept(file->mesh, triangle)) {
                put(file, g, places);
            }
        }
    }
}

static void add_side(threemf *file, uint32_t from, uint32_t to)
{
    file->sides[file->side_count++] = from < to ? (side){from, to, 1} : (side){to, from, 0};
}

/* Numbers the places in the order in which they come. */
static void look_at(threemf *file, int group, const uint32_t places[3])
{
    (void)group;
    for (int k = 0; k < 3; k++) {
        add_side(file, places[k], places[(k + 1) % 3]);
        const uint32_t number = file->vertex[places[k]];
        if (number >= file->vertex_count || file->place[number] != places[k]) {
            file->vertex[places[k]] = (uint32_t)file->vertex_count;
            file->place[file->vertex_count++] = places[k];
        }
    }
    file->triangle_count++;
    (void)taut_pulse_beat(&file->sink.pulse, SIDE_WORK);
}

static void put_number(taut_sink *sink, const char *before, size_t number)
{
    taut_sink_text(sink, before);
    taut_sink_count(sink, number);
    taut_sink_text(sink, "\"");
}

static void put_corners(threemf *file, int group, const uint32_t places[3])
{
    taut_sink *sink = &file->sink;
    put_number(sink, "<triangle v1=\"", file->vertex[places[0]]);
    put_number(sink, " v2=\"", file->vertex[places[1]]);
    put_number(sink, " v3=\"", file->vertex[places[2]]);
    put_number(sink, " pid=\"", 1);
    put_number(sink, " p1=\"", (size_t)taut_mesh_out_colour(file->mesh, file->surfaces, group));
    taut_sink_text(sink, "/>\n");
}

static int by_places(const void *a, const void *b)
{
    const side *x = a, *y = b;
    if (x->lo != y->lo) {
        return x->lo < y->lo ? -1 : 1;
    }
    if (x->hi != y->hi) {
        return x->hi < y->hi ? -1 : 1;
    }
    return x->forwards - y->forwards;
}

/* The sides in the order of their places: counted into those of each lower place, which are few. */
static void sort_sides(threemf *file)
{
    const size_t vertices = taut_mesh_vertex_count(file->mesh);
    size_t *begin = file->begin;

    memset(begin, 0, (vertices + 1) * sizeof *begin);
    for (size_t i = 0; i < file->side_count; i++) {
        begin[file->sides[i].lo + 1]++;
    }
    for (size_t i = 0; i < vertices; i++) {
        begin[i + 1] += begin[i];
    }
    for (size_t i = file->side_count;
         i-- > 0;) { /* from behind: begin[lo + 1] is the end, then where they begin */
        file->sorted[--begin[file->sides[i].lo + 1]] = file->sides[i];
    }
    for (size_t i = 0; i < vertices; i++) {
        const size_t end = i + 1 < vertices ? begin[i + 2] : file->side_count;
        const size_t count = end - begin[i + 1];
        qsort(file->sorted + begin[i + 1], count, sizeof *file->sorted, by_places);
        if (taut_pulse_beat(&file->sink.pulse, (double)SIDE_WORK * (double)count)) {
            return;
        }
    }
}

/* Is every side there once each way? */
static int is_closed(threemf *file)
{
    const side *s = file->sorted;
    size_t i = 0;
    sort_sides(file);
    while (i + 1 < file->side_count && s[i].lo == s[i + 1].lo && s[i].hi == s[i + 1].hi &&
           s[i].forwards != s[i + 1].forwards &&
           (i + 2 == file->side_count || s[i].lo != s[i + 2].lo || s[i].hi != s[i + 2].hi)) {
        i += 2;
    }
    return i == file->side_count;
}

static void put_vertices(threemf *file)
{
    static const char *const before[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
    const double *positions = taut_mesh_positions(file->mesh);
    for (size_t i = 0; i < file->vertex_count; i++) {
        for (size_t c = 0; c < 3; c++) {
            taut_sink_text(&file->sink, before[c]);
            taut_sink_number(&file->sink, positions[3 * (size_t)file->place[i] + c]);
        }
        taut_sink_text(&file->sink, "\"/>\n");
    }
}

/* The object of a body, under the name of its first surface; 0 where it has no triangle with an area. */
static int put_object(threemf *file, int body, size_t id)
{
    taut_sink *sink = &file->sink;
    char room[TAUT_NAME_MAX + 1];

    file->side_count = file->vertex_count = file->triangle_count = 0;
    each_triangle(file, body, look_at);
    if (file->triangle_count == 0) {
        return 0;
    }
    put_number(sink, "<object id=\"", id);
    taut_sink_text(sink, is_closed(file) ? " type=\"model\"" : " type=\"surface\"");
    taut_sink_text(sink, " name=\"");
    taut_xml_text(sink, taut_mesh_out_name(taut_mesh_group_at(file->mesh, body), room));
    put_number(sink, "\" pid=\"", 1);
    put_number(sink, " pindex=\"", (size_t)taut_mesh_out_colour(file->mesh, file->surfaces, body));
    taut_sink_text(sink, ">\n<mesh>\n<vertices>\n");
    put_vertices(file);
    taut_sink_text(sink, "</vertices>\n<triangles>\n");
    each_triangle(file, body, put_corners);
    taut_sink_text(sink, "</triangles>\n</mesh>\n</object>\n");
    return 1;
}

static void put_model(threemf *file, const char *unit)
{
    taut_sink *sink = &file->sink;
    size_t objects = 0;

    taut_sink_text(sink, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"");
    taut_sink_text(sink, unit_word(unit));
    taut_sink_text(sink, "\" xml:lang=\"en-US\" "
                         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                         "<metadata name=\"Application\">taut</metadata>\n<resources>\n");
    put_materials(file);
    for (int g = 0; g < file->groups; g++) {
        objects += file->body[g] == g ? (size_t)put_object(file, g, objects + 2) : 0;
    }
    taut_sink_text(sink, "</resources>\n<build>\n");
    for (size_t i = 0; i < objects; i++) {
        put_number(sink, "<item objectid=\"", i + 2);
        taut_sink_text(sink, "/>\n");
    }
    taut_sink_text(sink, "</build>\n</model>\n");
}

static taut_status write_archive(const char *text, size_t length, const taut_monitor *monitor,
                                 FILE *out, taut_error *error)
{
    taut_sink sink;
    taut_zip zip;

    if (!taut_zip_fits(length)) {
        return taut_fail(error, TAUT_IO, "large", NULL, (double)length, 4294967295.0,
                         "a 3MF file of %zu bytes, expected less than 4 GB: ask for a coarser mesh",
                         length);
    }
    sink = taut_sink_to(out);
    taut_sink_watch(&sink, monitor);
    zip = taut_zip_to(&sink);
    taut_zip_add(&zip, "[Content_Types].xml", types_text, strlen(types_text));
    taut_zip_add(&zip, "_rels/.rels", relations_text, strlen(relations_text));
    taut_zip_add(&zip, "3D/3dmodel.model", text, length);
    taut_zip_end(&zip);
    return taut_mesh_out_finish(&sink, error);
}

static taut_status write_mesh(threemf *file, const char *unit, taut_arena *arena,
                              const taut_monitor *monitor, FILE *out, taut_error *error)
{
    const size_t vertices = taut_mesh_vertex_count(file->mesh);
    file->groups = taut_mesh_group_count(file->mesh);
    file->surfaces = taut_mesh_out_surfaces(file->mesh);
    file->body = taut_arena_take(arena, (size_t)file->groups, sizeof *file->body);
    file->vertex = taut_arena_take(arena, vertices, sizeof *file->vertex);
    file->place = taut_arena_take(arena, vertices, sizeof *file->place);
    file->sides = taut_arena_take(arena, 6 * taut_mesh_quad_count(file->mesh), sizeof *file->sides);
    file->sorted =
        taut_arena_take(arena, 6 * taut_mesh_quad_count(file->mesh), sizeof *file->sorted);
    file->begin = taut_arena_take(arena, vertices + 1, sizeof *file->begin);
    file->sink = taut_sink_to(NULL);
    taut_sink_watch(&file->sink, monitor);
    if (taut_arena_status(arena) != TAUT_OK || find_bodies(file, arena) != TAUT_OK) {
        taut_free(file->sink.text);
        return taut_fail_memory(error);
    }
    put_model(file, unit);
    taut_status status = taut_mesh_out_finish(&file->sink, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = write_archive(file->sink.text, file->sink.length, monitor, out, error);
    taut_free(file->sink.text);
    return status;
}

static taut_status write_3mf(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    taut_mesh *mesh = NULL;
    taut_status status = taut_mesh_out_new(model, options, &mesh, error);
    if (status != TAUT_OK) {
        return status;
    }
    taut_arena *arena = taut_arena_new();
    threemf file = {.model = model, .mesh = mesh};
    status = write_mesh(&file, taut_model_unit(model), arena, &options->monitor, out, error);
    taut_arena_free(arena);
    taut_mesh_free(mesh);
    return status;
}

const taut_format_ops taut_format_threemf = {.write = write_3mf};
