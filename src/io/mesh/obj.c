/* obj.c -- the format `obj` (Wavefront): v, vt, vn and quads, an object and a group per surface. */
#include "core/fail.h"
#include "core/memory.h"
#include "io/format.h"
#include "io/mesh/out.h"

#include <string.h>

/* One line per item: the word, then `size` numbers. */
static void write_rows(taut_sink *sink, const char *word, size_t count, int size,
                       const double *values)
{
    for (size_t i = 0; i < count; i++) {
        taut_sink_text(sink, word);
        for (int c = 0; c < size; c++) {
            taut_sink_bytes(sink, " ", 1);
            taut_sink_number(sink, values[i * (size_t)size + (size_t)c]);
        }
        taut_sink_bytes(sink, "\n", 1);
    }
}

/* "f 1/1/1 2/2/2 ...": the three kinds of rows run in step, counted from 1. */
static void write_faces(taut_sink *sink, const taut_mesh_group *group, const uint32_t *quads)
{
    const size_t count = (size_t)(group->nu - 1) * (size_t)(group->nv - 1);

    for (size_t i = 0; i < count; i++) {
        taut_sink_bytes(sink, "f", 1);
        for (size_t c = 0; c < 4; c++) {
            const size_t vertex = (size_t)quads[4 * i + taut_mesh_out_corner(group, 4, c)] + 1;
            taut_sink_bytes(sink, " ", 1);
            taut_sink_count(sink, vertex);
            taut_sink_bytes(sink, "/", 1);
            taut_sink_count(sink, vertex);
            taut_sink_bytes(sink, "/", 1);
            taut_sink_count(sink, vertex);
        }
        taut_sink_bytes(sink, "\n", 1);
    }
}

/* A name ends at the line: white space and control characters become '_'. */
static void write_name(taut_sink *sink, const char *word, const taut_mesh_group *group)
{
    taut_sink_text(sink, word);
    if (group->name[0] == '\0') {
        taut_sink_text(sink, "surface");
        taut_sink_count(sink, (size_t)group->surface + 1);
    }
    for (const char *c = group->name; *c != '\0'; c++) {
        const unsigned char byte = (unsigned char)*c;
        taut_sink_bytes(sink, byte <= 0x20 || byte == 0x7f ? "_" : c, 1);
    }
    taut_sink_bytes(sink, "\n", 1);
}

static taut_status write_obj(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    taut_mesh *mesh = NULL;
    taut_sink sink;
    taut_status status = taut_mesh_out_new(model, options, &mesh, error);

    if (status != TAUT_OK) {
        return status;
    }
    const size_t vertices = taut_mesh_vertex_count(mesh);
    double *normals = taut_mesh_out_normals(mesh);
    if (normals == NULL) {
        taut_mesh_free(mesh);
        return taut_fail_memory(error);
    }
    sink = taut_sink_to(out);
    taut_sink_watch(&sink, &options->monitor);
    taut_sink_text(&sink, "# unit: ");
    taut_sink_text(&sink, taut_model_unit(model));
    taut_sink_text(&sink, "\n");
    write_rows(&sink, "v", vertices, 3, taut_mesh_positions(mesh));
    write_rows(&sink, "vt", vertices, 2, taut_mesh_parameters(mesh));
    write_rows(&sink, "vn", vertices, 3, normals);
    for (int i = 0; i < taut_mesh_group_count(mesh); i++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, i);
        write_name(&sink, "o ", group);
        write_name(&sink, "g ", group);
        write_faces(&sink, group, taut_mesh_quads(mesh) + 4 * group->first_quad);
    }
    taut_free(normals);
    taut_mesh_free(mesh);
    return taut_mesh_out_finish(&sink, error);
}

const taut_format_ops taut_format_obj = {.write = write_obj};
