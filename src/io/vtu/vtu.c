/* vtu.c -- the format `vtu`: VTK's XML for unstructured grids, with what engineers look at.
 *
 * Two pieces: the surfaces, and their control nets as lines (cell data `part` is 0 or 1). A
 * polynomial or rational surface goes as Bezier cells, exactly; any other as quads to the chord
 * tolerance. Point data: H and K, E_minus_G and F, the weights; NaN where there is no value.
 *
 * Or the surfaces alone, polynomial ones as Lagrange cells, in version 1.0, whose cells in two dimensions are those of 2.2:
 * meshio reads no later one, of several pieces the last alone, and no poly-lines.
 *
 * An array is base 64 of its length in bytes, eight of them, and its numbers, all with the lowest
 * byte first. */
#include "core/fail.h"
#include "io/format.h"
#include "io/mesh/out.h"
#include "io/vtu/grid.h"

#include <string.h>

/* One surface on its way. */
typedef struct vtu_part {
    const taut_surface *surface;
    int index, is_exact;
    taut_vtu_cells cells;
    const taut_mesh_group *group; /* of the mesh, where it is not exact */
} vtu_part;

typedef struct vtu_file {
    taut_arena *arena;
    vtu_part *parts;
    int count;
    taut_mesh *mesh; /* NULL where all is exact */
    taut_vtu_grid surfaces, nets;
} vtu_file;

static taut_status choose_parts(const taut_model *model, const taut_write_options *options,
                                vtu_file *file, taut_error *error)
{
    const int count = taut_model_surface_count(model);
    int inexact = 0;
    if (options->lagrange && options->coefficients) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "Lagrange cells have no coefficients: ask for one of both");
    }
    file->parts = taut_arena_take(file->arena, (size_t)count, sizeof *file->parts);
    if (file->parts == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        vtu_part *part = &file->parts[file->count];
        if (taut_format_wants(model, options, i)) {
            part->surface = taut_model_surface(model, i);
            part->index = i;
            part->is_exact = taut_vtu_cells_plan(part->surface, options, &part->cells);
            inexact += !part->is_exact;
            file->count++;
        }
    }
    if (file->count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "empty", NULL, taut_none, taut_none,
                         "the model has no surface to make a grid of");
    }
    taut_write_options thin = *options; /* as the exact cells are */
    thin.thickness = 0;
    return inexact > 0 ? taut_mesh_out_new(model, &thin, &file->mesh, error) : TAUT_OK;
}

static const taut_mesh_group *group_of(const taut_mesh *mesh, int surface)
{
    int g = 0;
    while (taut_mesh_group_at(mesh, g)->surface != surface) {
        g++;
    }
    return taut_mesh_group_at(mesh, g);
}

static size_t net_points(const taut_surface *surface)
{
    return (size_t)taut_basis_count(taut_surface_u(surface)) *
           (size_t)taut_basis_count(taut_surface_v(surface));
}

static taut_status take_grids(vtu_file *file, taut_error *error)
{
    double points = 0, cells = 0, corners = 0, of_nets = 0, lines = 0;
    for (int i = 0; i < file->count; i++) {
        vtu_part *part = &file->parts[i];
        if (part->is_exact) {
            const double count = (double)part->cells.count[0] * part->cells.count[1];
            const double each = (part->cells.degree[0] + 1.0) * (part->cells.degree[1] + 1.0);
            points += count * each;
            corners += count * each;
            cells += count;
        } else {
            part->group = group_of(file->mesh, part->index);
            points += (double)part->group->nu * part->group->nv;
            cells += (part->group->nu - 1.0) * (part->group->nv - 1.0);
            corners += 4 * (part->group->nu - 1.0) * (part->group->nv - 1.0);
        }
        of_nets += (double)net_points(part->surface);
        lines += taut_basis_count(taut_surface_u(part->surface)) +
                 taut_basis_count(taut_surface_v(part->surface));
    }
    if (points > TAUT_POINTS_MAX || of_nets > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "cells", NULL,
                         points > of_nets ? points : of_nets, TAUT_POINTS_MAX,
                         "a grid of %.0f points, expected at most %d: ask for a coarser one",
                         points > of_nets ? points : of_nets, TAUT_POINTS_MAX);
    }
    file->surfaces = taut_vtu_grid_of(file->arena, (size_t)points, (size_t)cells, (size_t)corners);
    file->nets = taut_vtu_grid_of(file->arena, (size_t)of_nets, (size_t)lines, 2 * (size_t)of_nets);
    return taut_arena_status(file->arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

enum { PLACE_WORK = 100 }; /* operations to note a place or a cell, as pulses count them */

/* The quads of the mesh of one surface. */
static taut_status add_mesh(const vtu_part *part, const taut_mesh *mesh, int threads,
                            taut_vtu_grid *grid)
{
    const taut_mesh_group *group = part->group;
    const size_t first = grid->points;
    const size_t quads = (size_t)(group->nu - 1) * (size_t)(group->nv - 1);
    const size_t vertices = (size_t)group->nu * (size_t)group->nv;
    const uint32_t *corners = taut_mesh_quads(mesh) + 4 * group->first_quad;
    for (size_t i = 0; i < vertices; i++) {
        taut_vtu_grid_add_point(grid, taut_mesh_positions(mesh) + 3 * (group->first_vertex + i), 1);
        (void)taut_pulse_beat(grid->pulse, PLACE_WORK);
    }
    for (size_t i = 0; i < quads; i++) {
        int64_t *cell = taut_vtu_grid_add_cell(grid, VTK_QUAD, 4, 1, 1, part->index);
        for (size_t c = 0; c < 4; c++) {
            cell[c] = (int64_t)(corners[4 * i + c] - group->first_vertex + first);
        }
        (void)taut_pulse_beat(grid->pulse, PLACE_WORK);
    }
    return taut_mesh_fields(part->surface, mesh, group, threads, grid->pulse,
                            grid->fields + TAUT_FIELDS * first);
}

/* The control net: a line for each of its rows and columns. */
static void add_net(const vtu_part *part, taut_vtu_grid *grid)
{
    const int nu = taut_basis_count(taut_surface_u(part->surface));
    const int nv = taut_basis_count(taut_surface_v(part->surface));
    const double *points = taut_surface_points(part->surface);
    const double *weights = taut_surface_weights(part->surface);
    const int64_t first = (int64_t)grid->points;
    for (size_t i = 0; i < net_points(part->surface); i++) {
        taut_vtu_grid_add_point(grid, points + 3 * i, weights != NULL ? weights[i] : 1);
    }
    for (int i = 0; i < nu; i++) {
        int64_t *cell = taut_vtu_grid_add_cell(grid, VTK_POLY_LINE, (size_t)nv, 1, 1, part->index);
        for (int j = 0; j < nv; j++) {
            cell[j] = first + (int64_t)i * nv + j;
        }
    }
    for (int j = 0; j < nv; j++) {
        int64_t *cell = taut_vtu_grid_add_cell(grid, VTK_POLY_LINE, (size_t)nu, 1, 1, part->index);
        for (int i = 0; i < nu; i++) {
            cell[i] = first + (int64_t)i * nv + j;
        }
    }
}

static taut_status fill_grids(const taut_write_options *options, vtu_file *file, taut_error *error)
{
    for (int i = 0; i < file->count; i++) {
        const vtu_part *part = &file->parts[i];
        taut_status status = TAUT_OK;
        if (part->is_exact) {
            status = taut_vtu_cells_add(part->surface, &part->cells, part->index, &file->surfaces,
                                        error);
        } else {
            status = taut_fail_status(
                error, add_mesh(part, file->mesh, options->threads, &file->surfaces));
        }
        if (status != TAUT_OK) {
            return status;
        }
        add_net(part, &file->nets);
    }
    return TAUT_OK;
}

/* A file that is being written. */
typedef struct vtu_out {
    taut_sink *sink;
    int lagrange;
} vtu_out;

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

static base64 open_array(const vtu_out *file, const char *type, const char *name, int components,
                         size_t bytes)
{
    taut_sink *sink = file->sink;
    base64 out = {sink, {0, 0, 0}, 0};
    taut_sink_text(sink, "<DataArray type=\"");
    taut_sink_text(sink, type);
    taut_sink_text(sink, "\" Name=\"");
    taut_sink_text(sink, name);
    if (!file->lagrange || components > 1) { /* meshio makes columns of arrays that say 1 */
        taut_sink_text(sink, "\" NumberOfComponents=\"");
        taut_sink_count(sink, (size_t)components);
    }
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
static void put_doubles(const vtu_out *file, const char *name, int components, size_t count,
                        size_t stride, const double *values)
{
    base64 out = open_array(file, "Float64", name, components, 8 * count * (size_t)components);
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < (size_t)components; c++) {
            uint64_t bits = 0;
            memcpy(&bits, &values[i * stride + c], sizeof bits);
            put_bytes(&out, bits, 8);
        }
    }
    close_array(&out);
}

static void put_long(const vtu_out *file, const char *name, size_t count, const int64_t *values)
{
    base64 out = open_array(file, "Int64", name, 1, 8 * count);
    for (size_t i = 0; i < count; i++) {
        put_bytes(&out, (uint64_t)values[i], 8);
    }
    close_array(&out);
}

/* One value over and over where `values` is NULL. */
static void put_int(const vtu_out *file, const char *name, int components, size_t count,
                    const int32_t *values, int32_t same)
{
    base64 out = open_array(file, "Int32", name, components, 4 * count * (size_t)components);
    for (size_t i = 0; i < count * (size_t)components; i++) {
        put_bytes(&out, (uint32_t)(values != NULL ? values[i] : same), 4);
    }
    close_array(&out);
}

static void put_small(const vtu_out *file, const char *name, size_t count, const uint8_t *values)
{
    base64 out = open_array(file, "UInt8", name, 1, count);
    for (size_t i = 0; i < count; i++) {
        put_bytes(&out, values[i], 1);
    }
    close_array(&out);
}

static void write_begin(const vtu_out *file, const char *unit)
{
    taut_sink *sink = file->sink;
    taut_sink_text(sink, "<?xml version=\"1.0\"?>\n<!-- taut, unit ");
    taut_sink_text(sink, unit);
    taut_sink_text(sink, " -->\n<VTKFile type=\"UnstructuredGrid\" version=\"");
    taut_sink_text(sink, file->lagrange ? "1.0" : "2.2");
    taut_sink_text(sink, "\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                         "<UnstructuredGrid>\n");
}

static void write_piece(const vtu_out *file, const taut_vtu_grid *grid, int part)
{
    static const char *const names[] = {"H", "K", "E_minus_G", "F", "isothermality"};
    _Static_assert(sizeof names / sizeof names[0] == TAUT_FIELDS, "a name for each field");
    taut_sink *sink = file->sink;
    taut_sink_text(sink, "<Piece NumberOfPoints=\"");
    taut_sink_count(sink, grid->points);
    taut_sink_text(sink, "\" NumberOfCells=\"");
    taut_sink_count(sink, grid->cells);
    taut_sink_text(sink, file->lagrange ? "\">\n<PointData>\n"
                                        : "\">\n<PointData RationalWeights=\"RationalWeights\">\n");
    for (size_t f = 0; f < TAUT_FIELDS; f++) {
        put_doubles(file, names[f], 1, grid->points, TAUT_FIELDS, grid->fields + f);
    }
    if (!file->lagrange) {
        put_doubles(file, "RationalWeights", 1, grid->points, 1, grid->weights);
    }
    taut_sink_text(sink, "</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n");
    put_int(file, "HigherOrderDegrees", 3, grid->cells, grid->degrees, 0);
    put_int(file, "part", 1, grid->cells, NULL, part);
    put_int(file, "surface", 1, grid->cells, grid->surfaces, 0);
    taut_sink_text(sink, "</CellData>\n<Points>\n");
    put_doubles(file, "Points", 3, grid->points, 3, grid->positions);
    taut_sink_text(sink, "</Points>\n<Cells>\n");
    put_long(file, "connectivity", grid->corners, grid->connectivity);
    put_long(file, "offsets", grid->cells, grid->offsets);
    put_small(file, "types", grid->cells, grid->types);
    taut_sink_text(sink, "</Cells>\n</Piece>\n");
}

static void write_end(taut_sink *sink)
{
    taut_sink_text(sink, "</UnstructuredGrid>\n</VTKFile>\n");
}

static taut_status write_file(vtu_file *file, const taut_model *model,
                              const taut_write_options *options, FILE *out, taut_error *error)
{
    taut_sink sink;
    taut_pulse pulse = {.monitor = &options->monitor, .what = "writing", .done = taut_none};
    taut_status status = choose_parts(model, options, file, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = take_grids(file, error);
    if (status != TAUT_OK) {
        return status;
    }
    file->surfaces.pulse = &pulse;
    status = fill_grids(options, file, error);
    if (status != TAUT_OK) {
        return status;
    }
    sink = taut_sink_to(out);
    taut_sink_watch(&sink, &options->monitor);
    const vtu_out written = {&sink, options->lagrange};
    write_begin(&written, taut_model_unit(model));
    write_piece(&written, &file->surfaces, 0);
    if (!options->lagrange) {
        write_piece(&written, &file->nets, 1);
    }
    write_end(&sink);
    return taut_mesh_out_finish(&sink, error);
}

static taut_status write_vtu(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    vtu_file file = {.arena = taut_arena_new()};
    const taut_status status = write_file(&file, model, options, out, error);
    taut_mesh_free(file.mesh);
    taut_arena_free(file.arena);
    return status;
}

const taut_format_ops taut_format_vtu = {.write = write_vtu};
