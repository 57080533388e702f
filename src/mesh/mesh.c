/* mesh.c -- from a model to its mesh: how many lines, then vertices, normals and faces; then its thickness (thicken.c). */
#include "taut/mesh.h"

#include "core/arena.h"
#include "core/crew.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "geometry/whole.h"
#include "mesh/lines.h"
#include "mesh/parts.h"
#include "mesh/seams.h"

#include <math.h>
#include <string.h>

enum { ROWS_AT_ONCE = 32 }; /* of vertices evaluated */

static const double default_tolerance = 1e-3;
/* Surfaces thinner than the model by more than this are taken for slivers, and cut no finer. */
static const double thin_most = 1000;
static const double weld_of_tolerance = 0.01, weld_of_size = 1e-6;

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
    if (mesh->groups == NULL || plan->directions == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < (int)count; i++) {
        const taut_surface *surface = taut_model_surface(model, i);
        if (taut_model_shows(model, name, i)) {
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
        return taut_fail(error, TAUT_NO_SOLUTION, "no-surface", NULL, taut_none, taut_none,
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
        size = taut_hypot(size, hi - lo); /* whose squares need not be doubles */
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
            return taut_fail(error, TAUT_BAD_ARGUMENT, "too-fine", NULL, nu * nv, TAUT_POINTS_MAX,
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
            return taut_fail(error, TAUT_BAD_ARGUMENT, "too-fine", NULL, (double)mesh->vertex_count,
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

/* Of the surfaces so many are done. TAUT_INTERRUPTED as the monitor says. */
static taut_status tell(const taut_mesh *mesh, const taut_crew *crew, int done)
{
    crew->pulse->done = (double)done / mesh->group_count;
    return taut_pulse_report(crew->pulse) ? TAUT_INTERRUPTED : TAUT_OK;
}

static taut_status fail_as(taut_error *error, taut_status status)
{
    return status == TAUT_INTERRUPTED ? taut_fail(error, TAUT_INTERRUPTED, "interrupted", NULL,
                                                  taut_none, taut_none, "stopped on request")
                                      : taut_fail_memory(error);
}

/* How each surface bends, and along which edges they meet. */
static taut_status sample_surfaces(const taut_mesh *mesh, mesh_plan *plan,
                                   const taut_mesh_options *options, const taut_crew *crew,
                                   double relative, taut_arena *scratch)
{
    const double weld =
        options->divide > 0 ? weld_of_size : fmin(weld_of_size, weld_of_tolerance * relative);
    plan->own = options->divide == 1;
    for (int i = 0; i < mesh->group_count; i++) {
        const taut_surface *surface = plan->surfaces[i];
        plan->own &= is_own(surface);
        taut_bending *bending = &plan->bendings[i];
        const taut_status status = tell(mesh, crew, 0) == TAUT_OK
                                       ? taut_bending_sample(surface, crew, scratch, bending)
                                       : TAUT_INTERRUPTED;
        if (status != TAUT_OK) {
            return status;
        }
        plan->directions[2 * i] = (taut_direction){taut_surface_u(surface), bending->u, 0, NULL};
        plan->directions[2 * i + 1] =
            (taut_direction){taut_surface_v(surface), bending->v, 0, NULL};
    }
    plan->weld = weld * size_of(plan->bendings, mesh->group_count);
    return taut_seams_find(plan->surfaces, mesh->group_count, plan->weld, plan->weld, scratch,
                           &plan->seams, &plan->seam_count, &plan->collapsed);
}

/* The largest diagonal of the boxes around the rows of the net along one direction. */
static double size_along(const taut_surface *surface, int along_v)
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    const int rows = along_v ? nu : nv, length = along_v ? nv : nu;
    const double *points = taut_surface_points(surface);
    double most = 0;

    for (int r = 0; r < rows; r++) {
        double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
        for (int k = 0; k < length; k++) {
            const int i = along_v ? r : k, j = along_v ? k : r;
            const double *p = points + 3 * ((size_t)i * (size_t)nv + (size_t)j);
            for (int c = 0; c < 3; c++) {
                lo[c] = fmin(lo[c], p[c]);
                hi[c] = fmax(hi[c], p[c]);
            }
        }
        most = fmax(most, taut_hypot(taut_hypot(hi[0] - lo[0], hi[1] - lo[1]), hi[2] - lo[2]));
    }
    return most;
}

/* The chord error is a share of each surface's own size, that of a square on its shorter side, where this is less than the
 * model's: a long thin pipe would lose its roundness. A surface that bends f times as much is cut as for 1/f of the error. */
static void refine_thin(const taut_mesh *mesh, const mesh_plan *plan, double size)
{
    for (int i = 0; i < mesh->group_count; i++) {
        const taut_surface *surface = plan->surfaces[i];
        const taut_bending *bending = &plan->bendings[i];
        const double own =
            1.4142135623730951 * fmin(size_along(surface, 0), size_along(surface, 1));
        const double factor = own > 0 && own < size ? fmin(size / own, thin_most) : 1;
        for (int s = 0; s < taut_basis_span_count(taut_surface_u(surface)); s++) {
            bending->u[s] *= factor;
        }
        for (int s = 0; s < taut_basis_span_count(taut_surface_v(surface)); s++) {
            bending->v[s] *= factor;
        }
    }
}

/* All lines, and how many vertices they make. */
static taut_status plan_mesh(taut_mesh *mesh, mesh_plan *plan, const taut_mesh_options *options,
                             const taut_crew *crew, taut_arena *scratch, taut_error *error)
{
    const double relative = options->tolerance > 0 ? options->tolerance : default_tolerance;
    const int count = 2 * mesh->group_count;
    taut_chains chains;
    taut_status status = TAUT_OK;

    status = sample_surfaces(mesh, plan, options, crew, relative, scratch);
    if (status != TAUT_OK) {
        return fail_as(error, status);
    }
    refine_thin(mesh, plan, size_of(plan->bendings, mesh->group_count));
    if (taut_chains_new(plan->directions, count, plan->seams, plan->seam_count,
                        relative * size_of(plan->bendings, mesh->group_count), options->divide,
                        scratch, &chains) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_chains_cut(&chains, 0);
    status = count_vertices(mesh, plan, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int i = 0; i < count; i++) {
        taut_direction *direction = &plan->directions[i];
        direction->lines = taut_arena_take(scratch, (size_t)direction->wish + 1, sizeof(double));
    }
    if (taut_arena_status(scratch) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_chains_cut(&chains, 1);
    return TAUT_OK;
}

/* Position and unit normal out of x, x_u, x_v. */
static void make_vertex(const double *x, double speeds, double *position, double *normal)
{
    double n[3];
    taut_cross(x + 3 * TAUT_XU, x + 3 * TAUT_XV, n);
    const double size = taut_length(n);
    const int regular = size > 0x1p-40 * speeds && isfinite(size);
    memcpy(position, x, 3 * sizeof(double));
    for (int c = 0; c < 3; c++) {
        normal[c] = regular ? n[c] / size : 0;
    }
}

/* Vertices at lines u[nu] and v[nv]: positions and normals double[nu][nv][3], parameters
 * double[nu][nv][2]. A normal is (0, 0, 0) where |x_u x x_v| is less than 2^-40 of `speeds`, the
 * product of the largest |x_u| and |x_v|. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
static taut_status evaluate_vertices(const taut_surface *surface, int nu, const double *u, int nv,
                                     const double *v, double speeds, const taut_crew *crew,
                                     double *positions, double *normals, double *parameters)
{
    enum { OF_VERTEX = 200 }; /* operations, roughly */
    const size_t row = (size_t)nv;
    double *x = taut_alloc_aligned(ROWS_AT_ONCE * row, 9 * sizeof(double));
    taut_status status = x != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (int i = 0; status == TAUT_OK && i < nu; i += ROWS_AT_ONCE) {
        const int rows = nu - i < ROWS_AT_ONCE ? nu - i : ROWS_AT_ONCE;
        const size_t base = (size_t)i * row;
        status = taut_surface_eval_grid(surface, rows, u + i, nv, v, 1, crew->threads, x);
        for (size_t k = 0; status == TAUT_OK && k < (size_t)rows * row; k++) {
            make_vertex(x + 9 * k, speeds, positions + 3 * (base + k), normals + 3 * (base + k));
            parameters[2 * (base + k)] = u[(size_t)i + k / row];
            parameters[2 * (base + k) + 1] = v[k % row];
        }
        if (status == TAUT_OK && taut_crew_beat(crew, (double)OF_VERTEX * rows * nv)) {
            status = TAUT_INTERRUPTED;
        }
    }
    taut_free(x);
    return status;
}

/* The vertices of one surface. TAUT_NO_MEMORY, TAUT_INTERRUPTED. */
static taut_status fill_vertices(taut_mesh *mesh, const mesh_plan *plan, int i,
                                 const taut_crew *crew)
{
    const taut_mesh_group *group = &mesh->groups[i];
    const taut_bending *bending = &plan->bendings[i];
    const taut_surface *surface = plan->surfaces[i];
    double *positions = mesh->positions + 3 * group->first_vertex;

    const taut_status status = evaluate_vertices(
        surface, group->nu, plan->directions[2 * i].lines, group->nv,
        plan->directions[2 * i + 1].lines, bending->longest_u * bending->longest_v, crew, positions,
        mesh->normals + 3 * group->first_vertex, mesh->parameters + 2 * group->first_vertex);
    if (status != TAUT_OK) {
        return status;
    }
    /* where sizes run over 16 digits, sums lose the least */
    if (plan->own && group->nu == taut_basis_count(taut_surface_u(surface)) &&
        group->nv == taut_basis_count(taut_surface_v(surface))) {
        memcpy(positions, taut_surface_points(surface),
               3 * sizeof(double) * (size_t)group->nu * (size_t)group->nv);
    }
    return TAUT_OK;
}

static taut_status fill_mesh(taut_mesh *mesh, const mesh_plan *plan, const taut_crew *crew,
                             taut_error *error)
{
    const taut_weld weld = {plan->seams,  plan->seam_count,  plan->collapsed,   plan->weld,
                            plan->own,    mesh->groups,      mesh->group_count, mesh->positions,
                            mesh->welded, mesh->vertex_count};

    for (int i = 0; i < mesh->group_count; i++) {
        const taut_status status =
            tell(mesh, crew, i) == TAUT_OK ? fill_vertices(mesh, plan, i, crew) : TAUT_INTERRUPTED;
        if (status != TAUT_OK) {
            return fail_as(error, status);
        }
    }
    if (taut_weld_vertices(&weld) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < mesh->group_count; i++) {
        taut_mesh_fill_faces(mesh, &mesh->groups[i]);
    }
    return TAUT_OK;
}

/* Surfaces, lines, vertices: each step knows what the next one needs. */
static taut_status make_mesh(taut_mesh *mesh, const taut_model *model,
                             const taut_mesh_options *options, taut_arena *scratch,
                             taut_error *error)
{
    taut_pulse pulse = {.monitor = &options->monitor, .what = "mesh"};
    const taut_crew crew = {.threads = options->threads, .pulse = &pulse};
    mesh_plan plan = {.surfaces = NULL};
    taut_status status = choose_surfaces(mesh, model, options->surface, &plan, scratch, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = plan_mesh(mesh, &plan, options, &crew, scratch, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_mesh_take_arrays(mesh, error);
    return status == TAUT_OK ? fill_mesh(mesh, &plan, &crew, error) : status;
}

/* The mesh, thickened where that is asked for: then `thin` is what it stands on. */
static taut_status make_thick(taut_mesh *thin, const taut_model *model,
                              const taut_mesh_options *options, taut_mesh **made, taut_error *error)
{
    taut_mesh *thick = taut_alloc_zero(1, sizeof *thick);
    taut_status status = TAUT_OK;

    if (thick == NULL) {
        return taut_fail_memory(error);
    }
    thick->arena = taut_arena_new();
    status = taut_mesh_thicken(thin, model, options->thickness, options->threads, thick, error);
    if (status != TAUT_OK) {
        taut_mesh_free(thick);
        return status;
    }
    *made = thick;
    return TAUT_OK;
}

taut_status taut_mesh_new(const taut_model *model, const taut_mesh_options *options,
                          taut_mesh **mesh, taut_error *error)
{
    static const taut_mesh_options none;
    const taut_mesh_options *chosen = options != NULL ? options : &none;
    taut_arena *scratch = NULL;
    taut_mesh *made = NULL;
    taut_status status = TAUT_OK;

    if (model == NULL || mesh == NULL || !(chosen->tolerance >= 0) || isinf(chosen->tolerance) ||
        chosen->divide < 0 || chosen->threads < 0 || chosen->threads > TAUT_THREADS_MAX ||
        !(chosen->thickness >= 0) || isinf(chosen->thickness)) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "an argument of taut_mesh_new is out of its range");
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    made->arena = taut_arena_new();
    scratch = taut_arena_new();
    status = make_mesh(made, model, chosen, scratch, error);
    taut_arena_free(scratch);
    if (status == TAUT_OK && chosen->thickness > 0) {
        taut_mesh *thin = made;
        status = make_thick(thin, model, chosen, &made, error);
        if (status == TAUT_OK) {
            taut_mesh_free(thin);
        }
    }
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
