/* cloth.c
 *
 * A seam in the chords of a mesh would be hidden by them in part: it is drawn once above the surface, along one of its pieces, and once
 * below, along the other one. */
#include "io/mesh/cloth.h"

#include "io/mesh/out.h"
#include "measure/cloth/mounted.h"
#include "taut/curve.h"

#include <math.h>
#include <string.h>

enum { CHORDS = 4 /* of a span */, STEPS = 64 /* along an edge */, EDGES = 4 };
static const char *const edge_names[EDGES] = {"right", "end", "left", "start"};

static void strains_of(const taut_mounted *piece, const taut_mesh *mesh,
                       const taut_mesh_group *group, double *values)
{
    const double *at = taut_mesh_parameters(mesh) + 2 * group->first_vertex;
    for (size_t k = 0; k < (size_t)group->nu * (size_t)group->nv; k++) {
        double point[3], normal[3];
        values[k] = nan("");
        if (piece->flat != NULL) {
            taut_mounted_at(piece, at[2 * k], at[2 * k + 1], point, normal, &values[k]);
        }
    }
}

taut_status taut_mesh_strains(const taut_model *model, const taut_mesh *mesh, taut_arena *arena,
                              double *values)
{
    for (int g = 0; g < taut_mesh_group_count(mesh); g++) {
        const taut_mesh_group *group = taut_mesh_group_at(mesh, g);
        taut_mounted piece;
        const taut_status status =
            taut_mounted_new(model, taut_model_surface(model, group->surface), arena, &piece);
        if (status != TAUT_OK) {
            return status;
        }
        strains_of(&piece, mesh, group, values + group->first_vertex);
    }
    return TAUT_OK;
}

/* ---- lines ---- */

typedef struct lines {
    const taut_model *model;
    taut_arena *arena;
    double lift;
    taut_mesh_line *list;
    int count;
} lines;

static void add_line(lines *to, const char *name, size_t count, double (*points)[3])
{
    for (size_t k = 0; points != NULL && k < 3 * count; k++) {
        if (!isfinite(points[k / 3][k % 3])) {
            return;
        }
    }
    to->list[to->count++] = (taut_mesh_line){name, count, (const double(*)[3])points};
}

static void add_curve(lines *to, const taut_curve *curve)
{
    const double *breaks = taut_basis_breaks(taut_curve_t(curve));
    const size_t count = CHORDS * (size_t)taut_basis_span_count(taut_curve_t(curve)) + 1;
    double(*points)[3] = taut_arena_take(to->arena, count, sizeof *points);
    for (size_t k = 0; points != NULL && k < count; k++) {
        const size_t span = k / CHORDS - (k + 1 == count);
        const double share = (double)(k - span * CHORDS) / CHORDS;
        const double t =
            share < 1 ? breaks[span] + share * (breaks[span + 1] - breaks[span]) : breaks[span + 1];
        taut_curve_eval(curve, t, 0, points[k]);
    }
    add_line(to, taut_curve_name(curve), count, points);
}

static const taut_record *object_named(const taut_record *list, const char *name)
{
    for (size_t k = 0; k < taut_record_count(list); k++) {
        const taut_record *one = taut_record_at(list, k);
        if (strcmp(taut_record_text(taut_record_get(one, "name")), name) == 0) {
            return one;
        }
    }
    return NULL;
}

/* An edge of a piece that is sewn, where it is on the surface: right and end from above. */
static void add_edge(lines *to, const taut_mounted *piece, int e, const char *seam)
{
    double(*points)[3] = taut_arena_take(to->arena, STEPS + 1, sizeof *points);
    double(*normals)[3] = taut_arena_take(to->arena, STEPS + 1, sizeof *normals);
    double strain = 0;

    if (points == NULL || normals == NULL) {
        return;
    }
    for (int k = 0; k <= STEPS; k++) {
        const double x = (double)k / STEPS, across = e == 0 || e == 3 ? 0 : 1;
        taut_mounted_at(piece, e % 2 == 0 ? x : across, e % 2 == 0 ? across : x, points[k],
                        normals[k], &strain);
        for (int c = 0; c < 3; c++) {
            points[k][c] += (e < 2 ? to->lift : -to->lift) * normals[k][c];
        }
    }
    add_line(to, seam, STEPS + 1, points);
}

static taut_status add_seams(lines *to, const taut_surface *flat, const taut_record *piece)
{
    taut_mounted mounted;
    const taut_status status = taut_mounted_new(to->model, flat, to->arena, &mounted);
    for (int e = 0; status == TAUT_OK && mounted.flat != NULL && e < EDGES; e++) {
        const taut_record *edge = taut_record_get(taut_record_get(piece, "edges"), edge_names[e]);
        const taut_record *seam = taut_record_get(edge, "seam");
        if (seam != NULL) {
            add_edge(to, &mounted, e, taut_record_text(seam));
        }
    }
    return status;
}

taut_status taut_mesh_lines(const taut_model *model, double lift, taut_arena *arena, int *count,
                            const taut_mesh_line **list)
{
    const taut_record *details = taut_model_details(model);
    const taut_record *pieces = taut_record_get(details, "pieces");
    const int curves = taut_model_curve_count(model), surfaces = taut_model_surface_count(model);
    lines to = {model, arena, lift, NULL, 0};

    to.list =
        taut_arena_take(arena, (size_t)curves + EDGES * (size_t)surfaces + 1, sizeof *to.list);
    if (to.list == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < surfaces; k++) {
        const taut_surface *flat = taut_model_surface(model, k);
        const taut_record *piece = object_named(pieces, taut_surface_name(flat));
        if (piece != NULL && add_seams(&to, flat, piece) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
    }
    for (int k = 0; k < curves; k++) {
        const taut_curve *curve = taut_model_curve(model, k);
        if (object_named(taut_record_get(details, "seams"), taut_curve_name(curve)) == NULL) {
            add_curve(&to, curve);
        }
    }
    *count = to.count;
    *list = to.list;
    return taut_arena_status(arena);
}

void taut_mesh_put_line(taut_json_out *out, const char *name, int accessor, int material)
{
    enum { LINE_STRIP = 3 };
    taut_json_open_inline(out, '{');
    taut_json_pair_text(out, "name", name);
    taut_json_key(out, "primitives");
    taut_json_open_inline(out, '[');
    taut_json_open_inline(out, '{');
    taut_json_key(out, "attributes");
    taut_json_open_inline(out, '{');
    taut_json_pair_number(out, "POSITION", accessor);
    taut_json_close(out, '}');
    taut_json_pair_number(out, "mode", LINE_STRIP);
    taut_json_pair_number(out, "material", material);
    taut_json_close(out, '}');
    taut_json_close(out, ']');
    taut_json_close(out, '}');
}

void taut_mesh_write_lines(taut_sink *sink, int count, const taut_mesh_line *list,
                           const double origin[3])
{
    for (int i = 0; i < count; i++) {
        const double *points = list[i].points[0];
        for (size_t k = 0; k < 3 * list[i].count; k++) {
            taut_mesh_out_f32(sink, points[k] - origin[k % 3]);
        }
    }
}
