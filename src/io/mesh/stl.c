/* stl.c -- the format `stl`, binary: 80 bytes of header, the number of triangles, then for each its
 * normal, three corners and two bytes of nothing, in single precision.
 *
 * Corners along seams are the same bytes, and surfaces that close a body are turned outwards: what
 * slicers ask for. */
#include "core/fail.h"
#include "core/vec3.h"
#include "io/format.h"
#include "io/mesh/out.h"

#include <math.h>
#include <string.h>

enum { HEADER = 80 };

/* Must not begin with "solid", which is how a text file begins. */
static void write_header(taut_sink *sink, const taut_model *model)
{
    char header[HEADER] = "taut, binary STL, unit ";
    memset(header + strlen(header), 0, HEADER - strlen(header));
    strcat(header, taut_model_unit(model));
    taut_sink_bytes(sink, header, HEADER);
}

/* Twice the area vector, made unit; 0 where there is no area. Of the corners as they are written: rounding turns slivers, and
 * readers hold the two against each other. */
static void normal_of(const double *a, const double *b, const double *c, double *normal)
{
    double p[3], q[3], length = 0;
    for (int k = 0; k < 3; k++) {
        p[k] = (double)(float)b[k] - (double)(float)a[k];
        q[k] = (double)(float)c[k] - (double)(float)a[k];
    }
    taut_cross(p, q, normal);
    length = taut_length(normal);
    for (int k = 0; k < 3; k++) {
        normal[k] = length > 0 && isfinite(length) ? normal[k] / length : 0;
    }
}

static void write_triangle(taut_sink *sink, const double *positions, const uint32_t *triangle,
                           int turned)
{
    const double *a = positions + 3 * (size_t)triangle[0];
    const double *b = positions + 3 * (size_t)triangle[turned ? 2 : 1];
    const double *c = positions + 3 * (size_t)triangle[turned ? 1 : 2];
    double row[12];
    normal_of(a, b, c, row);
    memcpy(row + 3, a, 3 * sizeof(double));
    memcpy(row + 6, b, 3 * sizeof(double));
    memcpy(row + 9, c, 3 * sizeof(double));
    for (int k = 0; k < 12; k++) {
        taut_mesh_out_f32(sink, row[k]);
    }
    taut_mesh_out_u16(sink, 0);
}

static taut_status write_mesh(const taut_model *model, const taut_mesh *mesh,
                              const taut_monitor *monitor, FILE *out, taut_error *error)
{
    taut_sink sink;
    const taut_status status = taut_mesh_out_check_float(mesh, "STL", error);
    if (status != TAUT_OK) {
        return status;
    }
    sink = taut_sink_to(out);
    taut_sink_watch(&sink, monitor);
    write_header(&sink, model);
    taut_mesh_out_u32(&sink, (uint32_t)taut_mesh_out_count(mesh, NULL));
    for (int g = 0; g < taut_mesh_group_count(mesh); g++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, g);
        size_t count = 0;
        const uint32_t *triangles = taut_mesh_out_triangles(mesh, group, &count);
        for (size_t i = 0; i < count; i++) {
            if (taut_mesh_out_is_kept(mesh, triangles + 3 * i)) {
                write_triangle(&sink, taut_mesh_positions(mesh), triangles + 3 * i, group->turned);
            }
        }
    }
    return taut_mesh_out_finish(&sink, error);
}

static taut_status write_stl(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    taut_mesh *mesh = NULL;
    taut_status status = taut_mesh_out_new(model, options, &mesh, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = write_mesh(model, mesh, &options->monitor, out, error);
    taut_mesh_free(mesh);
    return status;
}

const taut_format_ops taut_format_stl = {.write = write_stl};
