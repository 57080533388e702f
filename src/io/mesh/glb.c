/* glb.c -- the format `glb`: glTF 2.0 in one file, for renderers and the web.
 *
 *     header   "glTF", 2, length          chunk   length, "JSON", text          chunk   length,
 * "BIN", data
 *
 * The data is all positions, all normals, all colours (where asked for), all indices, in the order
 * of the groups; positions and normals in single precision. glTF is in metres with y up: the root
 * node scales, turns (x, y, z) to (x, z, -y) and, where a model lies far from the origin and single
 * precision would show, shifts back what was taken off the positions. */
#include "core/fail.h"
#include "core/memory.h"
#include "io/format.h"
#include "io/mesh/fields.h"
#include "io/mesh/glb_document.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double far_off = 16; /* sizes from the origin: four bits of 24 */

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
    for (int c = 0; c < 3; c++) {
        plan->origin[c] = reach > far_off * size ? lo[c] / 2 + hi[c] / 2 : 0;
    }
}

/* The box of one group as its positions are written: single precision, off the origin. */
static void choose_box(glb_plan *plan, const taut_mesh_group *group, glb_part *part)
{
    const double *positions = taut_mesh_positions(plan->mesh) + 3 * group->first_vertex;
    for (int c = 0; c < 3; c++) {
        part->lo[c] = INFINITY;
        part->hi[c] = -INFINITY;
    }
    for (size_t i = 0; i < 3 * (size_t)group->nu * (size_t)group->nv; i++) {
        const double x = (float)(positions[i] - plan->origin[i % 3]);
        part->lo[i % 3] = fmin(part->lo[i % 3], x);
        part->hi[i % 3] = fmax(part->hi[i % 3], x);
    }
}

/* The value of the colour at every vertex, and the range that the colours show. */
static taut_status choose_colours(glb_plan *plan, const taut_model *model, int threads)
{
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    static const int fields_of[] = {[TAUT_COLOUR_MEAN] = TAUT_FIELD_H,
                                    [TAUT_COLOUR_GAUSSIAN] = TAUT_FIELD_K,
                                    [TAUT_COLOUR_ISOTHERMALITY] = TAUT_FIELD_I};
    const int field = fields_of[plan->colour];
    double *fields = taut_alloc(vertices, TAUT_FIELDS * sizeof(double));
    double *sorted = taut_alloc(vertices, sizeof(double));
    taut_status status = TAUT_OK;
    int cut = 0;

    plan->values = taut_alloc(vertices, sizeof(double));
    if (fields == NULL || sorted == NULL || plan->values == NULL) {
        status = TAUT_NO_MEMORY;
    }
    for (int g = 0; status == TAUT_OK && g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        status = taut_mesh_fields(taut_model_surface(model, group->surface), plan->mesh, group,
                                  threads, fields + TAUT_FIELDS * group->first_vertex);
    }
    for (size_t i = 0; status == TAUT_OK && i < vertices; i++) {
        const double value = fields[TAUT_FIELDS * i + (size_t)field];
        plan->values[i] = sorted[i] = isfinite(value) ? value : nan("");
    }
    if (status == TAUT_OK) {
        plan->limit = taut_colour_limit(vertices, sorted, 0x1p-1000, &cut);
    }
    taut_free(fields);
    taut_free(sorted);
    return status;
}

/* What is where: every number of the JSON chunk. */
static taut_status plan_file(glb_plan *plan, const taut_model *model,
                             const taut_write_options *options)
{
    plan->count = taut_mesh_group_count(plan->mesh);
    plan->parts = taut_alloc_zero((size_t)plan->count, sizeof *plan->parts);
    if (plan->parts == NULL) {
        return TAUT_NO_MEMORY;
    }
    choose_origin(plan);
    for (int g = 0; g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        glb_part *part = &plan->parts[g];
        choose_box(plan, group, part);
        part->first_index = plan->index_count;
        part->index_count = 3 * taut_mesh_out_count(plan->mesh, group);
        part->keeps_all = part->index_count == 0; /* glTF has no primitive without an index */
        if (part->keeps_all) {
            taut_mesh_out_triangles(plan->mesh, group, &part->index_count);
            part->index_count *= 3;
        }
        plan->index_count += part->index_count;
    }
    return plan->colour != TAUT_COLOUR_PLAIN ? choose_colours(plan, model, options->threads)
                                             : TAUT_OK;
}

static void put_vertices(taut_sink *sink, const glb_plan *plan)
{
    const size_t vertices = taut_mesh_vertex_count(plan->mesh);
    const double *positions = taut_mesh_positions(plan->mesh);
    const double *normals = taut_mesh_normals(plan->mesh);
    for (size_t i = 0; i < 3 * vertices; i++) {
        taut_put_f32(sink, positions[i] - plan->origin[i % 3]);
    }
    for (size_t i = 0; i < 3 * vertices; i++) {
        taut_put_f32(sink, normals[i]);
    }
    for (size_t i = 0; plan->values != NULL && i < vertices; i++) {
        const taut_ink ink = taut_colour_diverging(plan->values[i] / plan->limit);
        taut_put_u16(sink, (unsigned)lround(65535 * glb_linear(ink.r)));
        taut_put_u16(sink, (unsigned)lround(65535 * glb_linear(ink.g)));
        taut_put_u16(sink, (unsigned)lround(65535 * glb_linear(ink.b)));
        taut_put_u16(sink, 65535);
    }
}

static void put_indices(taut_sink *sink, const glb_plan *plan)
{
    for (int g = 0; g < plan->count; g++) {
        const taut_mesh_group *group = taut_mesh_group_at(plan->mesh, g);
        size_t count = 0;
        const uint32_t *triangles = taut_mesh_out_triangles(plan->mesh, group, &count);
        for (size_t i = 0; i < 3 * count; i++) {
            if (plan->parts[g].keeps_all ||
                taut_mesh_out_is_kept(plan->mesh, triangles + i / 3 * 3)) {
                taut_put_u32(sink, triangles[i] - (uint32_t)group->first_vertex);
            }
        }
    }
}

static taut_status put_file(const glb_plan *plan, const taut_model *model, FILE *out,
                            taut_error *error)
{
    const size_t data = glb_data_length(plan);
    taut_sink sink;
    char *text = NULL;
    size_t length = 0;

    if (glb_document_text(plan, model, &text, &length) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    const size_t padded = (length + 3) / 4 * 4;
    sink = taut_sink_to(out);
    taut_sink_text(&sink, "glTF");
    taut_put_u32(&sink, 2);
    taut_put_u32(&sink, (uint32_t)(12 + 8 + padded + 8 + data));
    taut_put_u32(&sink, (uint32_t)padded);
    taut_sink_text(&sink, "JSON");
    taut_sink_bytes(&sink, text, length);
    taut_sink_bytes(&sink, "   ", padded - length);
    taut_put_u32(&sink, (uint32_t)data);
    taut_sink_bytes(&sink, "BIN", 4);
    put_vertices(&sink, plan);
    put_indices(&sink, plan);
    taut_free(text);
    return taut_mesh_out_finish(&sink, error);
}

static taut_status write_glb(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    taut_mesh *mesh = NULL;
    glb_plan plan = {.colour = options->colour};
    taut_status status = taut_mesh_out_new(model, options, &mesh, error);

    if (status == TAUT_OK) {
        status = taut_mesh_out_check_float(mesh, "glTF", error);
    }
    if (status == TAUT_OK) {
        plan.mesh = mesh;
        status = plan_file(&plan, model, options) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        status = put_file(&plan, model, out, error);
    }
    taut_free(plan.parts);
    taut_free(plan.values);
    taut_mesh_free(mesh);
    return status;
}

const taut_format_ops taut_format_glb = {.write = write_glb};
