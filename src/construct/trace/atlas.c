/* atlas.c
 *
 *     edges whose ends meet, of two surfaces: are they joined with one tangent plane (taut_join_measure)?
 *     curves go on there, where the normals agree and no third edge is joined to one of the two
 */
#include "construct/trace/atlas.h"

#include "construct/common/of.h"
#include "core/fail.h"
#include "trace/seam.h"

#include <string.h>

enum { EDGES = 4 };
/* Over the size: ends of edges that are farther from each other than this are not looked at. */
static const double near_ends = 1e-9;

static taut_status check_names(const taut_model *model, taut_error *error)
{
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        const char *name = taut_surface_name(taut_model_surface(model, i));
        for (int k = 0; k < i; k++) {
            if (strcmp(taut_surface_name(taut_model_surface(model, k)), name) == 0) {
                return taut_fail(error, TAUT_BAD_INPUT, "name", "/of", taut_none, taut_none,
                                 "two surfaces have the name \"%.60s\", and a net across surfaces "
                                 "tells them by their names",
                                 name);
            }
        }
    }
    return TAUT_OK;
}

static taut_status add_seam(taut_atlas *atlas, taut_arena *arena, const taut_atlas_seam *found)
{
    if ((atlas->seam_count & (atlas->seam_count - 1)) == 0) { /* full at powers of two */
        const size_t room = atlas->seam_count > 0 ? 2 * (size_t)atlas->seam_count : 1;
        taut_atlas_seam *list = taut_arena_take(arena, room, sizeof *list);
        if (list == NULL) {
            return TAUT_NO_MEMORY;
        }
        if (atlas->seam_count > 0) {
            memcpy(list, atlas->seams, (size_t)atlas->seam_count * sizeof *list);
        }
        atlas->seams = list;
    }
    atlas->seams[atlas->seam_count++] = *found;
    return TAUT_OK;
}

/* The seam between two edges, if they are one. */
static taut_status look_at_edges(taut_atlas *atlas, taut_arena *arena, int i, int edge_i, int k,
                                 int edge_k, taut_error *error)
{
    static const taut_edge edges[EDGES] = {TAUT_EDGE_U0, TAUT_EDGE_U1, TAUT_EDGE_V0, TAUT_EDGE_V1};
    taut_carrier *a = atlas->carriers[i], *b = atlas->carriers[k];
    const int ends = taut_seam_ends_meet(a, edge_i, b, edge_k, near_ends);
    taut_join join;

    if (ends == 0 || a->wraps[edge_i / 2] || b->wraps[edge_k / 2]) {
        return TAUT_OK;
    }
    const taut_status status =
        taut_join_measure(a->surface, edges[edge_i], b->surface, edges[edge_k], &join, error);
    if (status != TAUT_OK || join.g_order < 1) {
        return status;
    }
    const taut_seam there = {b, edge_k, ends < 0};
    const taut_atlas_seam found = {{i, k},
                                   {edge_i, edge_k},
                                   taut_seam_agrees(a, edge_i, &there),
                                   join.kind == TAUT_JOIN_BOUND && join.c_order >= 1};
    return add_seam(atlas, arena, &found) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

/* How many seams an edge has. */
static int seams_of(const taut_atlas *atlas, int surface, int edge)
{
    int count = 0;
    for (int k = 0; k < atlas->seam_count; k++) {
        const taut_atlas_seam *seam = &atlas->seams[k];
        count += (seam->surfaces[0] == surface && seam->edges[0] == edge) ||
                 (seam->surfaces[1] == surface && seam->edges[1] == edge);
    }
    return count;
}

/* The carriers learn where curves go on. */
static taut_status connect(taut_atlas *atlas, taut_arena *arena)
{
    for (int k = 0; k < atlas->seam_count; k++) {
        taut_atlas_seam *seam = &atlas->seams[k];
        const int *s = seam->surfaces, *e = seam->edges;
        taut_seam *pair = taut_arena_take(arena, 2, sizeof *pair);
        if (pair == NULL) {
            return TAUT_NO_MEMORY;
        }
        seam->is_carried &= seams_of(atlas, s[0], e[0]) == 1 && seams_of(atlas, s[1], e[1]) == 1;
        for (int side = 0; seam->is_carried && side < 2; side++) {
            const taut_carrier *to = atlas->carriers[s[1 - side]];
            pair[side] = (taut_seam){to, e[1 - side],
                                     taut_seam_ends_meet(atlas->carriers[s[side]], e[side], to,
                                                         e[1 - side], near_ends) < 0};
            atlas->carriers[s[side]]->seams[e[side]] = &pair[side];
        }
    }
    return TAUT_OK;
}

static taut_status find_seams(taut_atlas *atlas, taut_arena *arena, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < atlas->count; i++) {
        for (int k = i + 1; k < atlas->count; k++) {
            for (int pair = 0; status == TAUT_OK && pair < EDGES * EDGES; pair++) {
                status = look_at_edges(atlas, arena, i, pair / EDGES, k, pair % EDGES, error);
            }
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    return connect(atlas, arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_atlas_new(taut_arena *arena, const taut_trace_problem *problem,
                           const taut_model *model, taut_atlas *atlas, taut_error *error)
{
    const int is_carried = problem->carry && taut_model_surface_count(model) > 1;
    const taut_surface *named = NULL;
    taut_status status = TAUT_OK;

    *atlas = (taut_atlas){.count = is_carried ? taut_model_surface_count(model) : 1};
    if (!is_carried || problem->surface != NULL) {
        status = taut_construct_choose(model, problem->surface, &named, error);
    }
    if (status == TAUT_OK && is_carried) {
        status = check_names(model, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    const taut_surface **surfaces = taut_arena_take(arena, (size_t)atlas->count, sizeof *surfaces);
    if (surfaces == NULL) {
        return taut_fail_memory(error);
    }
    surfaces[0] = named;
    for (int k = 0; is_carried && k < atlas->count; k++) {
        surfaces[k] = taut_model_surface(model, k);
        atlas->home = surfaces[k] == named ? k : atlas->home;
    }
    if (taut_carriers_new(arena, atlas->count, surfaces, &atlas->carriers) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    return find_seams(atlas, arena, error);
}

void taut_atlas_describe(const taut_atlas *atlas, taut_record *details)
{
    static const char *const names[EDGES] = {"u0", "u1", "v0", "v1"};
    taut_record *list = atlas->count > 1 ? taut_record_add_list(details, "joins") : NULL;
    for (int k = 0; k < atlas->seam_count; k++) {
        const taut_atlas_seam *seam = &atlas->seams[k];
        taut_record *at = taut_record_add_object(list, NULL);
        taut_record *surfaces = taut_record_add_list(at, "surfaces");
        for (int side = 0; side < 2; side++) {
            taut_record_add_text(surfaces, NULL,
                                 taut_surface_name(atlas->carriers[seam->surfaces[side]]->surface));
        }
        taut_record *edges = taut_record_add_list(at, "edges");
        taut_record_add_text(edges, NULL, names[seam->edges[0]]);
        taut_record_add_text(edges, NULL, names[seam->edges[1]]);
        taut_record_add_bool(at, "carried", seam->is_carried);
        taut_record_add_bool(at, "proved", seam->is_proved);
    }
}
