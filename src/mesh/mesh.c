/* mesh.c -- from a model to its mesh: how many lines, then vertices, normals and faces. */
#include "taut/mesh.h"

#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "mesh/faces.h"
#include "mesh/lines.h"
#include "mesh/share.h"
#include "mesh/weld.h"

#include <math.h>
#include <string.h>

static const double default_tolerance = 1e-3;
static const double weld_of_tolerance = 0.01, weld_of_size = 1e-6;

struct taut_mesh {
    taut_arena *arena; /* owns all arrays */
    size_t vertex_count, quad_count;
    double *positions, *normals, *parameters;
    uint32_t *quads, *triangles, *welded;
    taut_mesh_group *groups;
    int group_count;
};

/* What is decided about one surface before memory is taken for its vertices. */
typedef struct mesh_plan {
    const taut_surface **surfaces;
    taut_bending *bendings;
    taut_direction *directions; /* 2 i and 2 i + 1: u and v of surface i */
    taut_seam *seams;
    int seam_count;
    unsigned char *collapsed;
    double weld; /* vertices as near as this are welded along seams */
    int own;     /* nonzero: the vertices are the control points */
} mesh_plan;

/* The surfaces that are wanted, as groups. */
static taut_status choose_surfaces(taut_mesh *mesh, const taut_model *model, const char *name,
                                   mesh_plan *plan, taut_arena *scratch, taut_error *error)
{
    const size_t count = (size_t)taut_model_surface_count(model);
    mesh->groups = taut_arena_take(mesh->arena, count, sizeof *mesh->groups);
    plan->surfaces = taut_arena_take(scratch, count, sizeof *plan->surfaces);
    plan->bendings = taut_arena_take(scratch, count, sizeof *plan->bendings);
    plan->directions = taut_arena_take(scratch, count, 2 * sizeof *plan->directions);
    if (mesh->groups == NULL || plan->surfaces == NULL || plan->bendings == NULL ||
        plan->directions == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < (int)count; i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        if (name == NULL || strcmp(name, taut_surface_name(surface)) == 0) {
            taut_mesh_group *group = &mesh->groups[mesh->group_count];
            group->name = taut_arena_text(mesh->arena, taut_surface_name(surface));
            group->surface = i;
            plan->surfaces[mesh->group_count++] = surface;
            if (group->name == NULL) {
                return taut_fail_memory(error);
            }
        }
    }
    if (mesh->group_count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, "no-solution", NULL, taut_none, taut_none,
                         "the model has no surface to make a mesh of");
    }
    return TAUT_OK;
}

/* The diagonal of the box around all. */
static double size_of(const taut_bending *bendings, int count)
{
    double size = 0;
    for (int c = 0; c < 3; c++) {
        double lo = bendings[0].lo[c], hi = bendings[0].hi[c];
        for (int i = 1; i < count; i++) {
            lo = fmin(lo, bendings[i].lo[c]);
            hi = fmax(hi, bendings[i].hi[c]);
        }
        size = hypot(size, hi - lo); /* whose squares need not be doubles */
    }
    return size;
}

/* The vertices that the wishes come to, refused where they are too many. */
static taut_status count_vertices(taut_mesh *mesh, const mesh_plan *plan, taut_error *error)
{
    for (int i = 0; i < mesh->group_count; i++) {
        taut_mesh_group *group = &mesh->groups[i];
        const double nu = plan->directions[2 * i].wish + 1;
        const double nv = plan->directions[2 * i + 1].wish + 1;
        if (!(nu * nv <= TAUT_POINTS_MAX)) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, nu * nv, TAUT_POINTS_MAX,
                             "a mesh of %.0f x %.0f vertices, expected at most %d in all: ask for "
                             "a coarser one",
                             nu, nv, TAUT_POINTS_MAX);
        }
        group->nu = (int)nu;
        group->nv = (int)nv;
        group->first_vertex = mesh->vertex_count;
        group->first_quad = mesh->quad_count;
        mesh->vertex_count += (size_t)group->nu * (size_t)group->nv;
        mesh->quad_count += (size_t)(group->nu - 1) * (size_t)(group->nv - 1);
        if (mesh->vertex_count > TAUT_POINTS_MAX) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, (double)mesh->vertex_count,
                             TAUT_POINTS_MAX,
                             "a mesh of %zu vertices and more, expected at most %d: ask for a "
                             "coarser one",
                             mesh->vertex_count, TAUT_POINTS_MAX);
        }
    }
    return TAUT_OK;
}

/* Does a mesh of one cell a span have the control points as they are for vertices? */
static int is_own(const taut_surface *surface)
{
    return taut_surface_weights(surface) == NULL &&
           taut_basis_degree(taut_surface_u(surface)) == 1 &&
           taut_basis_degree(taut_surface_v(surface)) == 1;
}

/* How each surface bends, and along which edges they meet. */
static taut_status look_at_surfaces(const taut_mesh *mesh, mesh_plan *plan,
                                    const taut_mesh_options *options, double relative,
                                    taut_arena *scratch)
{
    const double weld =
        options->divide > 0 ? weld_of_size : fmin(weld_of_size, weld_of_tolerance * relative);
    plan->own = options->divide == 1;
    for (int i = 0; i < mesh->group_count; i++) {
        const taut_surface *surface = plan->surfaces[i];
        plan->own &= is_own(surface);
        taut_bending *bending = &plan->bendings[i];
        if (taut_bending_sample(surface, options->threads, scratch, bending) != TAUT_OK) {
            return TAUT_NO_MEMORY;
        }
        plan->directions[2 * i] = (taut_direction){taut_surface_u(surface), bending->u, 0, NULL};
        plan->directions[2 * i + 1] =
            (taut_direction){taut_surface_v(surface), bending->v, 0, NULL};
    }
    plan->weld = weld * size_of(plan->bendings, mesh->group_count);
    return taut_seams_find(plan->surfaces, mesh->group_count, plan->weld, scratch, &plan->seams,
                           &plan->seam_count, &plan->collapsed);
}

/* All lines, and how many vertices they make. */
static taut_status plan_mesh(taut_mesh *mesh, mesh_plan *plan, const taut_mesh_options *options,
                             taut_arena *scratch, taut_error *error)
{
    const double relative = options->tolerance > 0 ? options->tolerance : default_tolerance;
    const int count = 2 * mesh->group_count;
    taut_chains chains;
    taut_status status = look_at_surfaces(mesh, plan, options, relative, scratch);

    if (status == TAUT_OK) {
        status = taut_chains_new(plan->directions, count, plan->seams, plan->seam_count,
                                 relative * size_of(plan->bendings, mesh->group_count),
                                 options->divide, scratch, &chains);
    }
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_chains_cut(&chains, 0);
    status = count_vertices(mesh, plan, error);
    for (int i = 0; i < count && status == TAUT_OK; i++) {
        taut_direction *direction = &plan->directions[i];
        direction->lines = taut_arena_take(scratch, (size_t)direction->wish + 1, sizeof(double));
        status = direction->lines != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        taut_chains_cut(&chains, 1);
    }
    return status;
}

static taut_status take_arrays(taut_mesh *mesh, taut_error *error)
{
    mesh->positions = taut_arena_take(mesh->arena, mesh->vertex_count, 3 * sizeof(double));
    mesh->normals = taut_arena_take(mesh->arena, mesh->vertex_count, 3 * sizeof(double));
    mesh->parameters = taut_arena_take(mesh->arena, mesh->vertex_count, 2 * sizeof(double));
    mesh->quads = taut_arena_take(mesh->arena, mesh->quad_count, 4 * sizeof(uint32_t));
    mesh->triangles = taut_arena_take(mesh->arena, mesh->quad_count, 6 * sizeof(uint32_t));
    mesh->welded = taut_arena_take(mesh->arena, mesh->vertex_count, sizeof(uint32_t));
    if (mesh->positions == NULL || mesh->normals == NULL || mesh->parameters == NULL ||
        mesh->quads == NULL || mesh->triangles == NULL || mesh->welded == NULL) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

/* The vertices of one surface. */
static taut_status fill_vertices(taut_mesh *mesh, const mesh_plan *plan, int i, int threads,
                                 taut_error *error)
{
    const taut_mesh_group *group = &mesh->groups[i];
    const taut_bending *bending = &plan->bendings[i];
    const taut_surface *surface = plan->surfaces[i];
    const taut_status status = taut_vertices_fill(
        surface, group->nu, plan->directions[2 * i].lines, group->nv,
        plan->directions[2 * i + 1].lines, bending->longest_u * bending->longest_v, threads,
        mesh->positions + 3 * group->first_vertex, mesh->normals + 3 * group->first_vertex,
        mesh->parameters + 2 * group->first_vertex);
    if (status == TAUT_OK && plan->own && group->nu == taut_basis_count(taut_surface_u(surface)) &&
        group->nv == taut_basis_count(taut_surface_v(
                         surface))) { /* where sizes run over 16 digits, sums lose the least */
        memcpy(mesh->positions + 3 * group->first_vertex, taut_surface_points(surface),
               3 * sizeof(double) * (size_t)group->nu * (size_t)group->nv);
    }
    return status == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static void fill_faces(taut_mesh *mesh, const taut_mesh_group *group)
{
    taut_faces_fill(group->nu, group->nv, (uint32_t)group->first_vertex, mesh->positions,
                    mesh->quads + 4 * group->first_quad, mesh->triangles + 6 * group->first_quad);
    taut_normals_mend(group->nu, group->nv, mesh->positions + 3 * group->first_vertex,
                      mesh->normals + 3 * group->first_vertex);
}

static taut_status weld_mesh(taut_mesh *mesh, const mesh_plan *plan, taut_error *error)
{
    const taut_weld weld = {plan->seams,  plan->seam_count,  plan->collapsed,   plan->weld,
                            plan->own,    mesh->groups,      mesh->group_count, mesh->positions,
                            mesh->welded, mesh->vertex_count};
    return taut_weld_vertices(&weld) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status fill_mesh(taut_mesh *mesh, const mesh_plan *plan,
                             const taut_mesh_options *options, taut_error *error)
{
    const taut_monitor *monitor = &options->monitor;
    taut_status status = take_arrays(mesh, error);
    for (int i = 0; status == TAUT_OK && i < mesh->group_count; i++) {
        if (monitor->progress != NULL &&
            monitor->progress(monitor->context, (double)i / mesh->group_count, "mesh") != 0) {
            status = taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL, taut_none, taut_none,
                               "stopped on request");
        } else {
            status = fill_vertices(mesh, plan, i, options->threads, error);
        }
    }
    if (status == TAUT_OK) {
        status = weld_mesh(mesh, plan, error);
    }
    for (int i = 0; status == TAUT_OK && i < mesh->group_count; i++) {
        fill_faces(mesh, &mesh->groups[i]);
    }
    return status;
}

taut_status taut_mesh_new(const taut_model *model, const taut_mesh_options *options,
                          taut_mesh **mesh, taut_error *error)
{
    static const taut_mesh_options none;
    const taut_mesh_options *chosen = options != NULL ? options : &none;
    taut_arena *scratch = NULL;
    taut_mesh *made = NULL;
    mesh_plan plan = {.surfaces = NULL};
    taut_status status = TAUT_OK;

    if (model == NULL || mesh == NULL || !(chosen->tolerance >= 0) || isinf(chosen->tolerance) ||
        chosen->divide < 0 || chosen->threads < 0 || chosen->threads > TAUT_THREADS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an argument of taut_mesh_new is out of its range");
    }
    scratch = taut_arena_new();
    made = taut_alloc_zero(1, sizeof *made);
    if (made != NULL) {
        made->arena = taut_arena_new();
    }
    status =
        scratch != NULL && made != NULL && made->arena != NULL ? TAUT_OK : taut_fail_memory(error);
    if (status == TAUT_OK) {
        status = choose_surfaces(made, model, chosen->surface, &plan, scratch, error);
    }
    if (status == TAUT_OK) {
        status = plan_mesh(made, &plan, chosen, scratch, error);
    }
    if (status == TAUT_OK) {
        status = fill_mesh(made, &plan, chosen, error);
    }
    taut_arena_free(scratch);
    if (status != TAUT_OK) {
        taut_mesh_free(made);
        return status;
    }
    *mesh = made;
    return TAUT_OK;
}

void taut_mesh_free(taut_mesh *mesh)
{
    if (mesh != NULL) {
        taut_arena_free(mesh->arena);
        taut_free(mesh);
    }
}

size_t taut_mesh_vertex_count(const taut_mesh *mesh)
{
    return mesh->vertex_count;
}

const double *taut_mesh_positions(const taut_mesh *mesh)
{
    return mesh->positions;
}

const double *taut_mesh_normals(const taut_mesh *mesh)
{
    return mesh->normals;
}

const double *taut_mesh_parameters(const taut_mesh *mesh)
{
    return mesh->parameters;
}

size_t taut_mesh_quad_count(const taut_mesh *mesh)
{
    return mesh->quad_count;
}

const uint32_t *taut_mesh_quads(const taut_mesh *mesh)
{
    return mesh->quads;
}

const uint32_t *taut_mesh_triangles(const taut_mesh *mesh)
{
    return mesh->triangles;
}

const uint32_t *taut_mesh_welded(const taut_mesh *mesh)
{
    return mesh->welded;
}

int taut_mesh_group_count(const taut_mesh *mesh)
{
    return mesh->group_count;
}

const taut_mesh_group *taut_mesh_group_at(const taut_mesh *mesh, int i)
{
    return i >= 0 && i < mesh->group_count ? &mesh->groups[i] : NULL;
}
