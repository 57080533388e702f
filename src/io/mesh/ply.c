/* ply.c -- the format `ply`, binary and little-endian: vertices in double precision with normals
 * and parameters, triangles with the index of their surface. */
#include "core/fail.h"
#include "core/memory.h"
#include "io/format.h"
#include "io/mesh/out.h"

/* A comment ends at the line: control characters become '_'. */
static void put_comment_text(taut_sink *sink, const char *text)
{
    for (const char *c = text; *c != '\0'; c++) {
        const unsigned char byte = (unsigned char)*c;
        taut_sink_bytes(sink, byte < 0x20 || byte == 0x7f ? "_" : c, 1);
    }
    taut_sink_text(sink, "\n");
}

static void put_header(taut_sink *sink, const taut_model *model, const taut_mesh *mesh)
{
    char room[TAUT_NAME_MAX + 1];
    taut_sink_text(sink, "ply\nformat binary_little_endian 1.0\ncomment unit ");
    put_comment_text(sink, taut_model_unit(model));
    for (int i = 0; i < taut_mesh_group_count(mesh); i++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, i);
        taut_sink_text(sink, "comment surface ");
        taut_sink_count(sink, (size_t)group->surface);
        taut_sink_text(sink, " ");
        put_comment_text(sink, taut_mesh_out_name(group, room));
    }
    taut_sink_text(sink, "element vertex ");
    taut_sink_count(sink, taut_mesh_vertex_count(mesh));
    taut_sink_text(sink, "\nproperty double x\nproperty double y\nproperty double z\n"
                         "property double nx\nproperty double ny\nproperty double nz\n"
                         "property double u\nproperty double v\nelement face ");
    taut_sink_count(sink, taut_mesh_out_count(mesh, NULL));
    taut_sink_text(sink, "\nproperty list uchar int vertex_indices\nproperty int surface\n"
                         "end_header\n");
}

static void put_vertices(taut_sink *sink, const taut_mesh *mesh, const double *normals)
{
    const double *positions = taut_mesh_positions(mesh);
    const double *parameters = taut_mesh_parameters(mesh);
    for (size_t i = 0; i < taut_mesh_vertex_count(mesh); i++) {
        for (size_t c = 0; c < 3; c++) {
            taut_mesh_out_f64(sink, positions[3 * i + c]);
        }
        for (size_t c = 0; c < 3; c++) {
            taut_mesh_out_f64(sink, normals[3 * i + c]);
        }
        taut_mesh_out_f64(sink, parameters[2 * i]);
        taut_mesh_out_f64(sink, parameters[2 * i + 1]);
    }
}

static void put_faces(taut_sink *sink, const taut_mesh *mesh, const taut_mesh_group *group)
{
    size_t count = 0;
    const uint32_t *triangles = taut_mesh_out_triangles(mesh, group, &count);
    for (size_t i = 0; i < count; i++) {
        if (taut_mesh_out_is_kept(mesh, triangles + 3 * i)) {
            taut_sink_bytes(sink, "\3", 1);
            for (size_t c = 0; c < 3; c++) {
                taut_mesh_out_u32(sink, triangles[3 * i + taut_mesh_out_corner(group, 3, c)]);
            }
            taut_mesh_out_u32(sink, (uint32_t)group->surface);
        }
    }
}

static taut_status write_ply(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    taut_mesh *mesh = NULL;
    taut_sink sink;
    taut_status status = taut_mesh_out_new(model, options, &mesh, error);

    if (status != TAUT_OK) {
        return status;
    }
    double *normals = taut_mesh_out_normals(mesh);
    if (normals == NULL) {
        taut_mesh_free(mesh);
        return taut_fail_memory(error);
    }
    sink = taut_sink_to(out);
    taut_sink_watch(&sink, &options->monitor);
    put_header(&sink, model, mesh);
    put_vertices(&sink, mesh, normals);
    for (int i = 0; i < taut_mesh_group_count(mesh); i++) {
        put_faces(&sink, mesh, taut_mesh_group_at(mesh, i));
    }
    taut_free(normals);
    taut_mesh_free(mesh);
    return taut_mesh_out_finish(&sink, error);
}

const taut_format_ops taut_format_ply = {.write = write_ply};
