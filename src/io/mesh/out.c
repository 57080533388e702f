#include "io/mesh/out.h"

#include "core/fail.h"
#include "core/memory.h"
#include "mesh/colour.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

taut_status taut_mesh_out_new(const taut_model *model, const taut_write_options *options,
                              taut_mesh **mesh, taut_error *error)
{
    const taut_mesh_options wish = {options->tolerance, options->divide,  options->threads,
                                    options->surface,   options->monitor, options->thickness};
    return taut_mesh_new(model, &wish, mesh, error);
}

int taut_mesh_out_is_kept(const taut_mesh *mesh, const uint32_t *triangle)
{
    const uint32_t *welded = taut_mesh_welded(mesh);
    const uint32_t a = welded[triangle[0]], b = welded[triangle[1]], c = welded[triangle[2]];
    return a != b && b != c && c != a;
}

const uint32_t *taut_mesh_out_triangles(const taut_mesh *mesh, const taut_mesh_group *group,
                                        size_t *count)
{
    *count = 2 * (size_t)(group->nu - 1) * (size_t)(group->nv - 1);
    return taut_mesh_triangles(mesh) + 6 * group->first_quad;
}

size_t taut_mesh_out_count(const taut_mesh *mesh, const taut_mesh_group *group)
{
    size_t count = 2 * taut_mesh_quad_count(mesh), kept = 0;
    const uint32_t *triangles = taut_mesh_triangles(mesh);
    if (group != NULL) {
        triangles = taut_mesh_out_triangles(mesh, group, &count);
    }
    for (size_t i = 0; i < count; i++) {
        kept += (size_t)taut_mesh_out_is_kept(mesh, triangles + 3 * i);
    }
    return kept;
}

double *taut_mesh_out_normals(const taut_mesh *mesh)
{
    const size_t numbers = 3 * taut_mesh_vertex_count(mesh);
    double *normals = taut_alloc(numbers, sizeof *normals);

    if (normals == NULL) {
        return NULL;
    }
    memcpy(normals, taut_mesh_normals(mesh), numbers * sizeof *normals);
    for (int g = 0; g < taut_mesh_group_count(mesh); g++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, g);
        double *own = normals + 3 * group->first_vertex;
        for (size_t i = 0; group->turned && i < 3 * (size_t)group->nu * (size_t)group->nv; i++) {
            own[i] = 0 - own[i]; /* never -0 */
        }
    }
    return normals;
}

taut_status taut_mesh_out_check_float(const taut_mesh *mesh, const char *format, taut_error *error)
{
    const double *positions = taut_mesh_positions(mesh);
    for (size_t i = 0; i < 3 * taut_mesh_vertex_count(mesh); i++) {
        if (!(fabs(positions[i]) <= FLT_MAX)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "single-precision", NULL, positions[i],
                             FLT_MAX,
                             "a coordinate of %g is too large for %s, which has single precision: "
                             "write .ply or .obj",
                             positions[i], format);
        }
    }
    return TAUT_OK;
}

void taut_mesh_out_u16(taut_sink *sink, unsigned value)
{
    taut_sink_low_bytes(sink, value, 2);
}

void taut_mesh_out_u32(taut_sink *sink, uint32_t value)
{
    taut_sink_low_bytes(sink, value, 4);
}

void taut_mesh_out_f32(taut_sink *sink, double value)
{
    const float rounded = (float)value;
    uint32_t bits = 0;
    memcpy(&bits, &rounded, sizeof bits);
    taut_sink_low_bytes(sink, bits, 4);
}

void taut_mesh_out_f64(taut_sink *sink, double value)
{
    uint64_t bits = 0;
    memcpy(&bits, &value, sizeof bits);
    taut_sink_low_bytes(sink, bits, 8);
}

int taut_mesh_out_surfaces(const taut_mesh *mesh)
{
    const int groups = taut_mesh_group_count(mesh);
    int count = groups > 0;
    while (count < groups && taut_mesh_group_at(mesh, count)->surface >
                                 taut_mesh_group_at(mesh, count - 1)->surface) {
        count++;
    }
    return count;
}

int taut_mesh_out_colour(const taut_mesh *mesh, int surfaces, int g)
{
    const int wanted = taut_mesh_group_at(mesh, g)->surface;
    int lo = 0, hi = surfaces - 1;
    while (lo < hi) {
        const int middle = lo + (hi - lo) / 2;
        if (taut_mesh_group_at(mesh, middle)->surface < wanted) {
            lo = middle + 1;
        } else {
            hi = middle;
        }
    }
    return lo;
}

static const char *group_name(const void *of, int i)
{
    return taut_mesh_group_at(of, i)->name;
}

int taut_mesh_out_plain(const taut_model *model, const taut_mesh *mesh, int surfaces, int g)
{
    const int first = taut_mesh_out_colour(mesh, surfaces, g);
    const int said = taut_colour_said(model, taut_mesh_group_at(mesh, g)->surface);
    return said >= 0 ? said : taut_colour_group(group_name, mesh, surfaces, first);
}

const char *taut_mesh_out_name(const taut_mesh_group *group, char *room)
{
    if (group->name[0] != '\0') {
        return group->name;
    }
    snprintf(room, TAUT_NAME_MAX + 1, "surface%d", group->surface + 1);
    return room;
}

taut_status taut_mesh_out_finish(taut_sink *sink, taut_error *error)
{
    const taut_status status = taut_sink_finish(sink);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}
