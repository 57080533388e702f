#include "io/mesh/glb_document.h"

#include "io/json/out.h"

#include <math.h>
#include <string.h>

/* Numbers that glTF gives to kinds of data. */
enum { UNSIGNED_SHORT = 5123, UNSIGNED_INT = 5125, FLOAT = 5126 };
enum { ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963 };
enum { VECTOR_BYTES = 12, COLOUR_BYTES = 8, INDEX_BYTES = 4, PLAIN_COLOURS = 8 };

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

double glb_linear(unsigned char byte)
{
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

/* Buffer views: positions, normals, colours if there are any, indices. Accessors: as many for each
 * group, in this order. */
static int views_of(const glb_plan *plan)
{
    return plan->values != NULL ? 4 : 3;
}

size_t glb_data_length(const glb_plan *plan)
{
    const size_t colour = plan->values != NULL ? COLOUR_BYTES : 0;
    return taut_mesh_vertex_count(plan->mesh) * (2 * VECTOR_BYTES + colour) +
           plan->index_count * INDEX_BYTES;
}

static void put_pair(taut_json_out *out, const char *key, double value)
{
    taut_json_key(out, key);
    taut_json_put_number(out, value);
}

static void put_word(taut_json_out *out, const char *key, const char *word)
{
    taut_json_key(out, key);
    taut_json_put_text(out, word);
}

static void put_asset(taut_json_out *out)
{
    taut_json_key(out, "asset");
    taut_json_open_inline(out, '{');
    put_word(out, "version", "2.0");
    put_word(out, "generator", "taut");
    taut_json_close(out, '}');
    put_pair(out, "scene", 0);
    taut_json_key(out, "scenes");
    taut_json_open_inline(out, '[');
    taut_json_open_inline(out, '{');
    taut_json_key(out, "nodes");
    taut_json_put_numbers(out, 1, (const double[]){0});
    taut_json_close(out, '}');
    taut_json_close(out, ']');
}

/* The root, which knows unit and axes, and a node for each surface. */
static void put_nodes(taut_json_out *out, const glb_plan *plan, const taut_model *model)
{
    const double metres = metres_of(taut_model_unit(model)), *origin = plan->origin;
    const double half = sqrt(0.5);
    taut_json_key(out, "nodes");
    taut_json_open(out, '[');
    taut_json_open_inline(out, '{');
    put_word(out, "name", "model");
    taut_json_key(out, "children");
    taut_json_open_inline(out, '[');
    for (int g = 0; g < plan->count; g++) {
        taut_json_put_number(out, g + 1);
    }
    taut_json_close(out, ']');
    taut_json_key(out, "translation");
    taut_json_put_numbers(
        out, 3, (const double[]){metres * origin[0], metres * origin[2], 0 - metres * origin[1]});
    taut_json_key(out, "rotation");
    taut_json_put_numbers(out, 4, (const double[]){-half, 0, 0, half});
    taut_json_key(out, "scale");
    taut_json_put_numbers(out, 3, (const double[]){metres, metres, metres});
    taut_json_close(out, '}');
    for (int g = 0; g < plan->count; g++) {
        char room[TAUT_NAME_MAX + 1];
        taut_json_open_inline(out, '{');
        put_word(out, "name", taut_mesh_out_name(taut_mesh_group_at(plan->mesh, g), room));
        put_pair(out, "mesh", g);
        taut_json_close(out, '}');
    }
    taut_json_close(out, ']');
}

static void put_meshes(taut_json_out *out, const glb_plan *plan)
{
    const int views = views_of(plan);
    taut_json_key(out, "meshes");
    taut_json_open(out, '[');
    for (int g = 0; g < plan->count; g++) {
        char room[TAUT_NAME_MAX + 1];
        taut_json_open_inline(out, '{');
        put_word(out, "name", taut_mesh_out_name(taut_mesh_group_at(plan->mesh, g), room));
        taut_json_key(out, "primitives");
        taut_json_open(out, '[');
        taut_json_open(out, '{');
        taut_json_key(out, "attributes");
        taut_json_open(out, '{');
        put_pair(out, "POSITION", views * g);
        put_pair(out, "NORMAL", views * g + 1);
        if (plan->values != NULL) {
            put_pair(out, "COLOR_0", views * g + 2);
        }
        taut_json_close(out, '}');
        put_pair(out, "indices", views * g + views - 1);
        put_pair(out, "material", plan->values != NULL ? 0 : g % PLAIN_COLOURS);
        taut_json_close(out, '}');
        taut_json_close(out, ']');
        taut_json_close(out, '}');
    }
    taut_json_close(out, ']');
}

/* One white one where the vertices carry the colour, with what the colours mean; else the plain
 * colours of figures. */
static void put_materials(taut_json_out *out, const glb_plan *plan)
{
    const int some = plan->count < PLAIN_COLOURS ? plan->count : PLAIN_COLOURS;
    const int count = plan->values != NULL ? 1 : some;
    taut_json_key(out, "materials");
    taut_json_open(out, '[');
    for (int i = 0; i < count; i++) {
        const taut_ink white = {255, 255, 255};
        const taut_ink ink = plan->values != NULL ? white : taut_colour_plain(i);
        taut_json_open_inline(out, '{');
        taut_json_key(out, "pbrMetallicRoughness");
        taut_json_open(out, '{');
        taut_json_key(out, "baseColorFactor");
        taut_json_put_numbers(
            out, 4, (const double[]){glb_linear(ink.r), glb_linear(ink.g), glb_linear(ink.b), 1});
        put_pair(out, "metallicFactor", 0);
        put_pair(out, "roughnessFactor", 0.6);
        taut_json_close(out, '}');
        taut_json_key(out, "doubleSided");
        taut_json_put_verdict(out, TAUT_TRUE);
        if (plan->values != NULL) {
            taut_json_key(out, "extras");
            taut_json_open(out, '{');
            put_word(out, "colour", plan->colour == TAUT_COLOUR_MEAN ? "H" : "K");
            put_pair(out, "limit", plan->limit);
            taut_json_close(out, '}');
        }
        taut_json_close(out, '}');
    }
    taut_json_close(out, ']');
}

/* One accessor: `offset` in bytes, box of three numbers or NULL. */
static void put_accessor(taut_json_out *out, int view, size_t offset, int component, size_t count,
                         const char *type, const glb_part *box)
{
    taut_json_open_inline(out, '{');
    put_pair(out, "bufferView", view);
    put_pair(out, "byteOffset", (double)offset);
    put_pair(out, "componentType", component);
    if (component == UNSIGNED_SHORT) {
        taut_json_key(out, "normalized");
        taut_json_put_verdict(out, TAUT_TRUE);
    }
    put_pair(out, "count", (double)count);
    put_word(out, "type", type);
    if (box != NULL) {
        taut_json_key(out, "min");
        taut_json_put_numbers(out, 3, box->lo);
        taut_json_key(out, "max");
        taut_json_put_numbers(out, 3, box->hi);
    }
    taut_json_close(out, '}');
}

static void put_accessors(taut_json_out *out, const glb_plan *plan)
{
    taut_json_key(out, "accessors");
    taut_json_open(out, '[');
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
    taut_json_close(out, ']');
}

/* One view after the other; stride 0: indices. Returns where it ends. */
static size_t put_view(taut_json_out *out, size_t offset, size_t length, int stride)
{
    taut_json_open_inline(out, '{');
    put_pair(out, "buffer", 0);
    put_pair(out, "byteOffset", (double)offset);
    put_pair(out, "byteLength", (double)length);
    if (stride > 0) {
        put_pair(out, "byteStride", stride);
    }
    put_pair(out, "target", stride > 0 ? ARRAY_BUFFER : ELEMENT_ARRAY_BUFFER);
    taut_json_close(out, '}');
    return offset + length;
}

static void put_buffers(taut_json_out *out, const glb_plan *plan)
{
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    size_t end = 0;
    taut_json_key(out, "bufferViews");
    taut_json_open(out, '[');
    end = put_view(out, end, VECTOR_BYTES * vertices, VECTOR_BYTES);
    end = put_view(out, end, VECTOR_BYTES * vertices, VECTOR_BYTES);
    if (plan->values != NULL) {
        end = put_view(out, end, COLOUR_BYTES * vertices, COLOUR_BYTES);
    }
    end = put_view(out, end, INDEX_BYTES * plan->index_count, 0);
    taut_json_close(out, ']');
    taut_json_key(out, "buffers");
    taut_json_open(out, '[');
    taut_json_open_inline(out, '{');
    put_pair(out, "byteLength", (double)end);
    taut_json_close(out, '}');
    taut_json_close(out, ']');
}

taut_status glb_document_text(const glb_plan *plan, const taut_model *model, char **text,
                              size_t *length)
{
    taut_json_out out = taut_json_out_to(NULL);
    taut_json_open(&out, '{');
    put_asset(&out);
    put_nodes(&out, plan, model);
    put_meshes(&out, plan);
    put_materials(&out, plan);
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
