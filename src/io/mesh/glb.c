/* glb.c -- the format `glb`: glTF 2.0 in one file, for renderers and the web.
 *
 *     header   "glTF", 2, length
 *     chunk    length, "JSON", text
 *     chunk    length, "BIN", data
 *
 * The data is all positions, all normals, all colours (where asked for), all indices, in the order
 * of the groups, and of a cutting pattern all places of its lines; positions and normals in single precision. glTF is in metres with y up: the root
 * node scales, turns (x, y, z) to (x, z, -y) and, where a model lies far from the origin and single
 * precision would show, shifts back what was taken off the positions. */
#include "core/arena.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "io/flat/cloth.h"
#include "io/flat/spread.h"
#include "io/format.h"
#include "io/json/out.h"
#include "io/mesh/cloth.h"
#include "io/mesh/fields.h"
#include "io/mesh/out.h"
#include "mesh/colour.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What of the data is one group's. */
typedef struct glb_part {
    double lo[3], hi[3]; /* of its positions as written */
    size_t first_index, index_count;
    int keeps_all; /* all its triangles have a place twice, and are written all the same */
} glb_part;

typedef struct glb_plan {
    taut_arena *arena; /* parts and values, and the mesh */
    const taut_mesh *mesh;
    int count; /* groups */
    glb_part *parts;
    size_t index_count;
    double origin[3]; /* taken off the positions */
    double size;      /* of the box of all vertices */
    taut_colour colour;
    double *values; /* [vertices]: the curvature or the strain shown; NULL: plain colours */
    double limit;   /* of its colours */
    int is_cloth;   /* a cutting pattern: its strains are shown, unless a curvature is asked for */
    int line_count; /* of it */
    const taut_mesh_line *lines;
} glb_plan;

/* Numbers that glTF gives to kinds of data. */
enum { UNSIGNED_SHORT = 5123, UNSIGNED_INT = 5125, FLOAT = 5126 };
enum { ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963 };
enum { VECTOR_BYTES = 12, COLOUR_BYTES = 8, INDEX_BYTES = 4 };

static const struct {
    const char *unit;
    double metres;
} units[] = {{"mm", 1e-3}, {"m", 1}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}};

static double metres_of(const char *unit)
{
    double metres = 1e-3;
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(units[i].unit, unit) == 0) {
            metres = units[i].metres;
        }
    }
    return metres;
}

/* A byte of sRGB as the linear share that glTF wants. */
static double linear_share(unsigned char byte)
{
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : taut_pow((x + 0.055) / 1.055, 2.4);
}

/* Buffer views: positions, normals, colours if there are any, indices. Accessors: as many for each
 * group, in this order. Behind them one view of all lines, and an accessor each. */
static int views_of(const glb_plan *plan)
{
    return plan->values != NULL ? 4 : 3;
}

static size_t line_places(const glb_plan *plan)
{
    size_t count = 0;
    for (int i = 0; i < plan->line_count; i++) {
        count += plan->lines[i].count;
    }
    return count;
}

/* Bytes of the BIN chunk. */
static size_t data_length(const glb_plan *plan)
{
    const size_t colour = plan->values != NULL ? COLOUR_BYTES : 0;
    return taut_mesh_vertex_count(plan->mesh) * (2 * VECTOR_BYTES + colour) +
           plan->index_count * INDEX_BYTES + line_places(plan) * VECTOR_BYTES;
}

static void put_asset(taut_json_out *out)
{
    taut_json_key(out, "asset");
    taut_json_open_inline(out, '{');
    taut_json_pair_text(out, "version", "2.0");
    taut_json_pair_text(out, "generator", "taut");
    taut_json_close(out, '}');
    taut_json_pair_number(out, "scene", 0);
    taut_json_key(out, "scenes");
    taut_json_open_inline(out, '[');
    taut_json_open_inline(out, '{');
    taut_json_pair_numbers(out, "nodes", 1, (const double[]){0});
    taut_json_close(out, '}');
    taut_json_close(out, ']');
}

static void put_node(taut_json_out *out, const char *name, int mesh)
{
    taut_json_open_inline(out, '{');
    taut_json_pair_text(out, "name", name);
    taut_json_pair_number(out, "mesh", mesh);
    taut_json_close(out, '}');
}

/* The root, which knows unit and axes, and a node for each surface and each line. */
static void put_nodes(taut_json_out *out, const glb_plan *plan, const taut_model *model)
{
    const double metres = metres_of(taut_model_unit(model)), *origin = plan->origin;
    const double half = sqrt(0.5);
    taut_json_open_pair(out, "nodes", '[');
    taut_json_open_inline(out, '{');
    taut_json_pair_text(out, "name", "model");
    taut_json_key(out, "children");
    taut_json_open_inline(out, '[');
    for (int g = 0; g < plan->count + plan->line_count; g++) {
        taut_json_put_number(out, g + 1);
    }
    taut_json_close(out, ']');
    taut_json_pair_numbers(
        out, "translation", 3,
        (const double[]){metres * origin[0], metres * origin[2], 0 - metres * origin[1]});
    taut_json_pair_numbers(out, "rotation", 4, (const double[]){-half, 0, 0, half});
    taut_json_pair_numbers(out, "scale", 3, (const double[]){metres, metres, metres});
    taut_json_close(out, '}');
    for (int g = 0; g < plan->count; g++) {
        char room[TAUT_NAME_MAX + 1];
        put_node(out, taut_mesh_out_name(taut_mesh_group_at(plan->mesh, g), room), g);
    }
    for (int i = 0; i < plan->line_count; i++) {
        put_node(out, plan->lines[i].name, plan->count + i);
    }
    taut_json_close(out, ']');
}

static void put_meshes(taut_json_out *out, const glb_plan *plan)
{
    const int views = views_of(plan);
    taut_json_open_pair(out, "meshes", '[');
    for (int g = 0; g < plan->count; g++) {
        char room[TAUT_NAME_MAX + 1];
        taut_json_open_inline(out, '{');
        taut_json_pair_text(out, "name",
                            taut_mesh_out_name(taut_mesh_group_at(plan->mesh, g), room));
        taut_json_open_pair(out, "primitives", '[');
        taut_json_open(out, '{');
        taut_json_open_pair(out, "attributes", '{');
        taut_json_pair_number(out, "POSITION", views * g);
        taut_json_pair_number(out, "NORMAL", views * g + 1);
        if (plan->values != NULL) {
            taut_json_pair_number(out, "COLOR_0", views * g + 2);
        }
        taut_json_close(out, '}');
        taut_json_pair_number(out, "indices", views * g + views - 1);
        taut_json_pair_number(out, "material", plan->values != NULL ? 0 : g);
        taut_json_close(out, '}');
        taut_json_close(out, ']');
        taut_json_close(out, '}');
    }
    for (int i = 0; i < plan->line_count; i++) {
        taut_mesh_put_line(out, plan->lines[i].name, views_of(plan) * plan->count + i,
                           plan->values != NULL ? 1 : plan->count);
    }
    taut_json_close(out, ']');
}

static void put_paint(taut_json_out *out, taut_ink ink)
{
    taut_json_open_pair(out, "pbrMetallicRoughness", '{');
    taut_json_pair_numbers(
        out, "baseColorFactor", 4,
        (const double[]){linear_share(ink.r), linear_share(ink.g), linear_share(ink.b), 1});
    taut_json_pair_number(out, "metallicFactor", 0);
    taut_json_pair_number(out, "roughnessFactor", 0.6);
    taut_json_close(out, '}');
}

/* One white one where the vertices carry the colour, with what the colours mean; else one a surface, under
 * its name, in its colour of figures. Behind it that of lines. */
static void put_materials(taut_json_out *out, const glb_plan *plan, const taut_model *model)
{
    const int surfaces = taut_mesh_out_surfaces(plan->mesh);
    const int count = plan->values != NULL ? 1 : plan->count;
    static const char *const shown[] = {[TAUT_COLOUR_PLAIN] = "strain",
                                        [TAUT_COLOUR_MEAN] = "H",
                                        [TAUT_COLOUR_GAUSSIAN] = "K",
                                        [TAUT_COLOUR_ISOTHERMALITY] = "I"};
    taut_json_open_pair(out, "materials", '[');
    for (int i = 0; i < count; i++) {
        const taut_ink white = {255, 255, 255};
        const taut_ink ink =
            plan->values != NULL
                ? white
                : taut_colour_plain(taut_mesh_out_plain(model, plan->mesh, surfaces, i));
        char room[TAUT_NAME_MAX + 1];
        taut_json_open_inline(out, '{');
        if (plan->values == NULL) {
            taut_json_pair_text(out, "name",
                                taut_mesh_out_name(taut_mesh_group_at(plan->mesh, i), room));
        }
        put_paint(out, ink);
        taut_json_pair_verdict(out, "doubleSided", TAUT_TRUE);
        if (plan->values != NULL) {
            taut_json_open_pair(out, "extras", '{');
            taut_json_pair_text(out, "colour", shown[plan->colour]);
            taut_json_pair_number(out, "limit", plan->limit);
            taut_json_close(out, '}');
        }
        taut_json_close(out, '}');
    }
    if (plan->line_count > 0) {
        const taut_ink dark = {40, 40, 40};
        taut_json_open_inline(out, '{');
        taut_json_pair_text(out, "name", "lines");
        put_paint(out, dark);
        taut_json_close(out, '}');
    }
    taut_json_close(out, ']');
}

/* One accessor: `offset` in bytes, box of three numbers or NULL. */
static void put_accessor(taut_json_out *out, int view, size_t offset, int component, size_t count,
                         const char *type, const glb_part *box)
{
    taut_json_open_inline(out, '{');
    taut_json_pair_number(out, "bufferView", view);
    taut_json_pair_number(out, "byteOffset", (double)offset);
    taut_json_pair_number(out, "componentType", component);
    if (component == UNSIGNED_SHORT) {
        taut_json_pair_verdict(out, "normalized", TAUT_TRUE);
    }
    taut_json_pair_number(out, "count", (double)count);
    taut_json_pair_text(out, "type", type);
    if (box != NULL) {
        taut_json_pair_numbers(out, "min", 3, box->lo);
        taut_json_pair_numbers(out, "max", 3, box->hi);
    }
    taut_json_close(out, '}');
}

/* The box of places as they are written: single precision, off the origin. */
static void box_of(const glb_plan *plan, size_t count, const double *positions, glb_part *box)
{
    for (int c = 0; c < 3; c++) {
        box->lo[c] = INFINITY;
        box->hi[c] = -INFINITY;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        const double x = (float)(positions[i] - plan->origin[i % 3]);
        box->lo[i % 3] = fmin(box->lo[i % 3], x);
        box->hi[i % 3] = fmax(box->hi[i % 3], x);
    }
}

static void put_accessors(taut_json_out *out, const glb_plan *plan)
{
    taut_json_open_pair(out, "accessors", '[');
    for (int g = 0; g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        const glb_part *part = &plan->parts[g];
        const size_t first = group->first_vertex;
        const size_t count = (size_t)group->nu * (size_t)group->nv;
        put_accessor(out, 0, VECTOR_BYTES * first, FLOAT, count, "VEC3", part);
        put_accessor(out, 1, VECTOR_BYTES * first, FLOAT, count, "VEC3", NULL);
        if (plan->values != NULL) {
            put_accessor(out, 2, COLOUR_BYTES * first, UNSIGNED_SHORT, count, "VEC4", NULL);
        }
        put_accessor(out, views_of(plan) - 1, INDEX_BYTES * part->first_index, UNSIGNED_INT,
                     part->index_count, "SCALAR", NULL);
    }
    size_t first = 0;
    for (int i = 0; i < plan->line_count; i++) {
        const taut_mesh_line *line = &plan->lines[i];
        glb_part box;
        box_of(plan, line->count, line->points[0], &box);
        put_accessor(out, views_of(plan), VECTOR_BYTES * first, FLOAT, line->count, "VEC3", &box);
        first += line->count;
    }
    taut_json_close(out, ']');
}

/* One view after the other; stride 0: indices. Returns where it ends. */
static size_t put_view(taut_json_out *out, size_t offset, size_t length, int stride)
{
    taut_json_open_inline(out, '{');
    taut_json_pair_number(out, "buffer", 0);
    taut_json_pair_number(out, "byteOffset", (double)offset);
    taut_json_pair_number(out, "byteLength", (double)length);
    if (stride > 0) {
        taut_json_pair_number(out, "byteStride", stride);
    }
    taut_json_pair_number(out, "target", stride > 0 ? ARRAY_BUFFER : ELEMENT_ARRAY_BUFFER);
    taut_json_close(out, '}');
    return offset + length;
}

static void put_buffers(taut_json_out *out, const glb_plan *plan)
{
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    size_t end = 0;
    taut_json_open_pair(out, "bufferViews", '[');
    end = put_view(out, end, VECTOR_BYTES * vertices, VECTOR_BYTES);
    end = put_view(out, end, VECTOR_BYTES * vertices, VECTOR_BYTES);
    if (plan->values != NULL) {
        end = put_view(out, end, COLOUR_BYTES * vertices, COLOUR_BYTES);
    }
    end = put_view(out, end, INDEX_BYTES * plan->index_count, 0);
    if (plan->line_count > 0) {
        end = put_view(out, end, VECTOR_BYTES * line_places(plan), VECTOR_BYTES);
    }
    taut_json_close(out, ']');
    taut_json_open_pair(out, "buffers", '[');
    taut_json_open_inline(out, '{');
    taut_json_pair_number(out, "byteLength", (double)end);
    taut_json_close(out, '}');
    taut_json_close(out, ']');
}

/* The JSON chunk, freed by taut_free. TAUT_NO_MEMORY. */
static taut_status write_document(const glb_plan *plan, const taut_model *model, char **text,
                                  size_t *length)
{
    taut_json_out out = taut_json_out_to(NULL);
    taut_json_open(&out, '{');
    put_asset(&out);
    put_nodes(&out, plan, model);
    put_meshes(&out, plan);
    put_materials(&out, plan, model);
    put_accessors(&out, plan);
    put_buffers(&out, plan);
    taut_json_close(&out, '}');
    if (taut_json_out_finish(&out) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    *text = out.sink.text;
    *length = out.sink.length;
    return TAUT_OK;
}

static const double lift_share = 1e-3; /* of seams off the surface: what chords may be off it */
static const double no_strain = 1e-9;  /* rounding of pieces without any */
static const double far_off = 16;      /* sizes from the origin: four bits of 24 */

/* The box of all vertices, and the origin of the positions in the file. */
static void choose_origin(glb_plan *plan)
{
    const double *positions = taut_mesh_positions(plan->mesh);
    double size = 0, reach = 0;
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < 3 * taut_mesh_vertex_count(plan->mesh); i++) {
        lo[i % 3] = fmin(lo[i % 3], positions[i]);
        hi[i % 3] = fmax(hi[i % 3], positions[i]);
        reach = fmax(reach, fabs(positions[i]));
    }
    for (int c = 0; c < 3; c++) {
        size = fmax(size, hi[c] - lo[c]);
    }
    plan->size = size;
    for (int c = 0; c < 3; c++) {
        plan->origin[c] = reach > far_off * size ? lo[c] / 2 + hi[c] / 2 : 0;
    }
}

/* The curvature asked for at every vertex. */
static taut_status choose_curvature(const glb_plan *plan, const taut_model *model,
                                    const taut_write_options *options, double *values)
{
    taut_pulse pulse = {.monitor = &options->monitor, .what = "writing", .done = taut_none};
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    static const int fields_of[] = {[TAUT_COLOUR_MEAN] = TAUT_FIELD_H,
                                    [TAUT_COLOUR_GAUSSIAN] = TAUT_FIELD_K,
                                    [TAUT_COLOUR_ISOTHERMALITY] = TAUT_FIELD_I};
    const int field = fields_of[plan->colour];
    double *fields = taut_arena_take(plan->arena, vertices, TAUT_FIELDS * sizeof(double));
    taut_status status = taut_arena_status(plan->arena);

    for (int g = 0; status == TAUT_OK && g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        status =
            taut_mesh_fields(taut_model_surface(model, group->surface), plan->mesh, group,
                             options->threads, &pulse, fields + TAUT_FIELDS * group->first_vertex);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t i = 0; i < vertices; i++) {
        values[i] = fields[TAUT_FIELDS * i + (size_t)field];
    }
    return TAUT_OK;
}

/* The value of the colour at every vertex, and the range that the colours show. */
static taut_status choose_colours(glb_plan *plan, const taut_model *model,
                                  const taut_write_options *options)
{
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    const int is_strain = plan->colour == TAUT_COLOUR_PLAIN;
    double *sorted = taut_arena_take(plan->arena, vertices, sizeof(double));
    double *values = taut_arena_take(plan->arena, vertices, sizeof(double));
    taut_status status = taut_arena_status(plan->arena);
    int cut = 0;

    if (status == TAUT_OK) {
        status = is_strain ? taut_mesh_strains(model, plan->mesh, plan->arena, values)
                           : choose_curvature(plan, model, options, values);
    }
    if (status != TAUT_OK) {
        return status;
    }
    for (size_t i = 0; i < vertices; i++) {
        values[i] = sorted[i] = isfinite(values[i]) ? values[i] : nan("");
    }
    plan->values = values;
    plan->limit = taut_colour_limit(vertices, sorted, is_strain ? no_strain : 0x1p-1000, &cut);
    return TAUT_OK;
}

/* What is where: every number of the JSON chunk. */
static taut_status plan_file(glb_plan *plan, const taut_model *model,
                             const taut_write_options *options)
{
    plan->count = taut_mesh_group_count(plan->mesh);
    plan->parts = taut_arena_take(plan->arena, (size_t)plan->count, sizeof *plan->parts);
    if (plan->parts == NULL) {
        return TAUT_NO_MEMORY;
    }
    choose_origin(plan);
    for (int g = 0; g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        glb_part *part = &plan->parts[g];
        box_of(plan, (size_t)group->nu * (size_t)group->nv,
               taut_mesh_positions(plan->mesh) + 3 * group->first_vertex, part);
        part->first_index = plan->index_count;
        part->index_count = 3 * taut_mesh_out_count(plan->mesh, group);
        part->keeps_all = part->index_count == 0; /* glTF has no primitive without an index */
        if (part->keeps_all) {
            taut_mesh_out_triangles(plan->mesh, group, &part->index_count);
            part->index_count *= 3;
        }
        plan->index_count += part->index_count;
    }
    if (plan->is_cloth && options->surface == NULL &&
        taut_mesh_lines(model, lift_share * plan->size, plan->arena, &plan->line_count,
                        &plan->lines) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    return plan->is_cloth || plan->colour != TAUT_COLOUR_PLAIN
               ? choose_colours(plan, model, options)
               : TAUT_OK;
}

static void write_colour(taut_sink *sink, taut_ink ink)
{
    taut_mesh_out_u16(sink, (unsigned)lround(65535 * linear_share(ink.r)));
    taut_mesh_out_u16(sink, (unsigned)lround(65535 * linear_share(ink.g)));
    taut_mesh_out_u16(sink, (unsigned)lround(65535 * linear_share(ink.b)));
    taut_mesh_out_u16(sink, 65535);
}

static void write_vertices(taut_sink *sink, const glb_plan *plan, const double *normals)
{
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    const double *positions = taut_mesh_positions(plan->mesh);
    const taut_ink plain = taut_colour_plain(0);
    for (size_t i = 0; i < 3 * vertices; i++) {
        taut_mesh_out_f32(sink, positions[i] - plan->origin[i % 3]);
    }
    for (size_t i = 0; i < 3 * vertices; i++) {
        taut_mesh_out_f32(sink, normals[i]);
    }
    for (size_t i = 0; plan->values != NULL && i < vertices; i++) {
        const double value = plan->values[i];
        write_colour(sink, plan->colour == TAUT_COLOUR_PLAIN && isnan(value)
                               ? plain /* the surface that is cut */
                               : taut_colour_diverging(value / plan->limit));
    }
}

static void write_indices(taut_sink *sink, const glb_plan *plan)
{
    for (int g = 0; g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        size_t count = 0;
        const uint32_t *triangles = taut_mesh_out_triangles(plan->mesh, group, &count);
        for (size_t i = 0; i < 3 * count; i++) {
            const uint32_t *triangle = triangles + i / 3 * 3;
            if (plan->parts[g].keeps_all || taut_mesh_out_is_kept(plan->mesh, triangle)) {
                taut_mesh_out_u32(sink, triangle[taut_mesh_out_corner(group, 3, i % 3)] -
                                            (uint32_t)group->first_vertex);
            }
        }
    }
}

static taut_status write_file(const glb_plan *plan, const taut_model *model,
                              const taut_monitor *monitor, FILE *out, taut_error *error)
{
    const size_t data = data_length(plan);
    taut_sink sink;
    char *text = NULL;
    size_t length = 0;

    double *normals = taut_mesh_out_normals(plan->mesh);
    if (normals == NULL || write_document(plan, model, &text, &length) != TAUT_OK) {
        taut_free(normals);
        return taut_fail_memory(error);
    }
    const size_t padded = (length + 3) / 4 * 4;
    sink = taut_sink_to(out);
    taut_sink_watch(&sink, monitor);
    taut_sink_text(&sink, "glTF");
    taut_mesh_out_u32(&sink, 2);
    taut_mesh_out_u32(&sink, (uint32_t)(12 + 8 + padded + 8 + data));
    taut_mesh_out_u32(&sink, (uint32_t)padded);
    taut_sink_text(&sink, "JSON");
    taut_sink_bytes(&sink, text, length);
    taut_sink_bytes(&sink, "   ", padded - length);
    taut_mesh_out_u32(&sink, (uint32_t)data);
    taut_sink_bytes(&sink, "BIN", 4);
    write_vertices(&sink, plan, normals);
    write_indices(&sink, plan);
    taut_mesh_write_lines(&sink, plan->line_count, plan->lines, plan->origin);
    taut_free(text);
    taut_free(normals);
    return taut_mesh_out_finish(&sink, error);
}

static void release_mesh(void *mesh)
{
    taut_mesh_free(mesh);
}

static taut_status write_planned(glb_plan *plan, const taut_model *model,
                                 const taut_write_options *options, FILE *out, taut_error *error)
{
    taut_mesh *mesh = NULL;
    taut_status status = taut_mesh_out_new(model, options, &mesh, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_arena_keep(plan->arena, mesh, release_mesh)) {
        return taut_fail_memory(error);
    }
    status = taut_mesh_out_check_float(mesh, "glTF", error);
    if (status != TAUT_OK) {
        return status;
    }
    plan->mesh = mesh;
    status = plan_file(plan, model, options);
    if (status != TAUT_OK) {
        return taut_fail_status(error, status);
    }
    return write_file(plan, model, &options->monitor, out, error);
}

static taut_status write_glb(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    glb_plan plan = {.arena = NULL, .colour = options->colour};
    taut_model *spread = NULL;

    if (plan.colour == TAUT_COLOUR_STRAIN && taut_flat_is_cloth(model)) {
        plan.colour = TAUT_COLOUR_PLAIN; /* as they are without */
    }
    if (plan.colour >= TAUT_COLOUR_GAP) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "glb files show H, K or I");
    }
    if (taut_flat_spread(model, NULL, &spread) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    plan.is_cloth = spread != NULL;
    plan.arena = taut_arena_new();
    const taut_status status =
        write_planned(&plan, spread != NULL ? spread : model, options, out, error);
    taut_arena_free(plan.arena);
    taut_model_free(spread);
    return status;
}

const taut_format_ops taut_format_glb = {.write = write_glb};
