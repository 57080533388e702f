/* mesh.c -- from a model to its mesh: how many lines, then vertices, normals and faces. */
#include "taut/mesh.h"

#include "core/arena.h"
#include "core/fail.h"
#include "core/memory.h"
#include "mesh/faces.h"
#include "mesh/lines.h"

#include <math.h>
#include <string.h>

static const double default_tolerance = 1e-3;

struct taut_mesh {
    taut_arena *arena; /* owns all arrays */
    size_t vertex_count, quad_count;
    double *positions, *normals, *parameters;
    uint32_t *quads, *triangles;
    taut_mesh_group *groups;
    int group_count;
};

/* What is decided about one surface before memory is taken for its vertices. */
typedef struct mesh_plan {
    const taut_surface *surface;
    taut_bending bending;
    double *u, *v; /* the lines */
} mesh_plan;

/* The surfaces that are wanted, as groups. */
static taut_status choose_surfaces(taut_mesh *mesh, const taut_model *model, const char *name,
                                   mesh_plan **plans, taut_arena *scratch, taut_error *error)
{
    const int count = taut_model_surface_count(model);
    mesh->groups = taut_arena_take(mesh->arena, (size_t)count, sizeof *mesh->groups);
    *plans = taut_arena_take(scratch, (size_t)count, sizeof **plans);
    if (mesh->groups == NULL || *plans == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        if (name == NULL || strcmp(name, taut_surface_name(surface)) == 0) {
            taut_mesh_group *group = &mesh->groups[mesh->group_count];
            group->name = taut_arena_text(mesh->arena, taut_surface_name(surface));
            group->surface = i;
            (*plans)[mesh->group_count++].surface = surface;
            if (group->name == NULL) {
                return taut_fail_memory(error);
            }
        }
    }
    if (mesh->group_count == 0) {
        return taut_fail(error, TAUT_NO_SOLUTION, NULL, taut_none, taut_none,
                         "the model has no surface to make a mesh of");
    }
    return TAUT_OK;
}

/* The diagonal of the box around all. */
static double size_of(const mesh_plan *plans, int count)
{
    double lo[3], hi[3];
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        lo[c] = plans[0].bending.lo[c];
        hi[c] = plans[0].bending.hi[c];
        for (int i = 1; i < count; i++) {
            lo[c] = fmin(lo[c], plans[i].bending.lo[c]);
            hi[c] = fmax(hi[c], plans[i].bending.hi[c]);
        }
        sum += (hi[c] - lo[c]) * (hi[c] - lo[c]);
    }
    return sqrt(sum);
}

/* Cells of each span of one basis; their sum, which may be too large for any use. */
static double count_cells(const taut_basis *basis, const double *bending, double tolerance,
                          int divide, int *cells)
{
    const double *breaks = taut_basis_breaks(basis);
    double sum = 0;
    for (int s = 0; s < taut_basis_span_count(basis); s++) {
        const double wish =
            divide > 0 ? divide : taut_cells(breaks[s + 1] - breaks[s], bending[s], tolerance);
        cells[s] = wish < TAUT_POINTS_MAX ? (int)wish : TAUT_POINTS_MAX;
        sum += wish;
    }
    return sum;
}

/* The lines of one surface, in the plan; the counts in the group. */
static taut_status choose_lines(mesh_plan *plan, taut_mesh_group *group, double tolerance,
                                int divide, taut_arena *scratch, taut_error *error)
{
    const taut_basis *u = taut_surface_u(plan->surface), *v = taut_surface_v(plan->surface);
    int *cells_u = taut_arena_take(scratch, (size_t)taut_basis_span_count(u), sizeof(int));
    int *cells_v = taut_arena_take(scratch, (size_t)taut_basis_span_count(v), sizeof(int));
    double sum_u = 0, sum_v = 0;

    if (cells_u == NULL || cells_v == NULL) {
        return taut_fail_memory(error);
    }
    sum_u = count_cells(u, plan->bending.u, tolerance, divide, cells_u);
    sum_v = count_cells(v, plan->bending.v, tolerance, divide, cells_v);
    if (!((sum_u + 1) * (sum_v + 1) <= TAUT_POINTS_MAX)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, (sum_u + 1) * (sum_v + 1), TAUT_POINTS_MAX,
                         "a mesh of %.0f x %.0f vertices, expected at most %d in all: ask for a "
                         "coarser one",
                         sum_u + 1, sum_v + 1, TAUT_POINTS_MAX);
    }
    group->nu = (int)sum_u + 1;
    group->nv = (int)sum_v + 1;
    plan->u = taut_arena_take(scratch, (size_t)group->nu, sizeof(double));
    plan->v = taut_arena_take(scratch, (size_t)group->nv, sizeof(double));
    if (plan->u == NULL || plan->v == NULL) {
        return taut_fail_memory(error);
    }
    taut_lines_fill(u, cells_u, plan->u);
    taut_lines_fill(v, cells_v, plan->v);
    return TAUT_OK;
}

/* All lines, and the memory for what they carry. */
static taut_status plan_mesh(taut_mesh *mesh, mesh_plan *plans, const taut_mesh_options *options,
                             taut_arena *scratch, taut_error *error)
{
    const double relative = options->tolerance > 0 ? options->tolerance : default_tolerance;
    taut_status status = TAUT_OK;
    double tolerance = 0;

    for (int i = 0; i < mesh->group_count; i++) {
        status =
            taut_bending_sample(plans[i].surface, options->threads, scratch, &plans[i].bending);
        if (status != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    tolerance = relative * size_of(plans, mesh->group_count);
    for (int i = 0; i < mesh->group_count && status == TAUT_OK; i++) {
        taut_mesh_group *group = &mesh->groups[i];
        status = choose_lines(&plans[i], group, tolerance, options->divide, scratch, error);
        group->first_vertex = mesh->vertex_count;
        group->first_quad = mesh->quad_count;
        if (status == TAUT_OK) {
            mesh->vertex_count += (size_t)group->nu * (size_t)group->nv;
            mesh->quad_count += (size_t)(group->nu - 1) * (size_t)(group->nv - 1);
        }
        if (status == TAUT_OK && mesh->vertex_count > TAUT_POINTS_MAX) {
            status = taut_fail(error, TAUT_BAD_ARGUMENT, NULL, (double)mesh->vertex_count,
                               TAUT_POINTS_MAX,
                               "a mesh of %zu vertices and more, expected at most %d: ask for a "
                               "coarser one",
                               mesh->vertex_count, TAUT_POINTS_MAX);
        }
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
    if (mesh->positions == NULL || mesh->normals == NULL || mesh->parameters == NULL ||
        mesh->quads == NULL || mesh->triangles == NULL) {
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

/* Vertices and faces of one surface. */
static taut_status fill_group(taut_mesh *mesh, const mesh_plan *plan, const taut_mesh_group *group,
                              int threads, taut_error *error)
{
    double *positions = mesh->positions + 3 * group->first_vertex;
    double *normals = mesh->normals + 3 * group->first_vertex;
    double *parameters = mesh->parameters + 2 * group->first_vertex;
    const double speeds = plan->bending.longest_u * plan->bending.longest_v;
    const taut_status status =
        taut_vertices_fill(plan->surface, group->nu, plan->u, group->nv, plan->v, speeds, threads,
                           positions, normals, parameters);
    if (status != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_faces_fill(group->nu, group->nv, (uint32_t)group->first_vertex, mesh->positions,
                    mesh->quads + 4 * group->first_quad, mesh->triangles + 6 * group->first_quad);
    taut_normals_mend(group->nu, group->nv, positions, normals);
    return TAUT_OK;
}

static taut_status fill_mesh(taut_mesh *mesh, const mesh_plan *plans,
                             const taut_mesh_options *options, taut_error *error)
{
    const taut_monitor *monitor = &options->monitor;
    taut_status status = take_arrays(mesh, error);
    for (int i = 0; status == TAUT_OK && i < mesh->group_count; i++) {
        if (monitor->progress != NULL &&
            monitor->progress(monitor->context, (double)i / mesh->group_count, "mesh") != 0) {
            status = taut_fail(error, TAUT_INTERRUPTED, NULL, taut_none, taut_none,
                               "stopped on request");
        } else {
            status = fill_group(mesh, &plans[i], &mesh->groups[i], options->threads, error);
        }
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
    mesh_plan *plans = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || mesh == NULL || !(chosen->tolerance >= 0) || isinf(chosen->tolerance) ||
        chosen->divide < 0 || chosen->threads < 0 || chosen->threads > TAUT_THREADS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, NULL, taut_none, taut_none,
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
        status = choose_surfaces(made, model, chosen->surface, &plans, scratch, error);
    }
    if (status == TAUT_OK) {
        status = plan_mesh(made, plans, chosen, scratch, error);
    }
    if (status == TAUT_OK) {
        status = fill_mesh(made, plans, chosen, error);
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

int taut_mesh_group_count(const taut_mesh *mesh)
{
    return mesh->group_count;
}

const taut_mesh_group *taut_mesh_group_at(const taut_mesh *mesh, int i)
{
    return i >= 0 && i < mesh->group_count ? &mesh->groups[i] : NULL;
}
