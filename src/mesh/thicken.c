/* thicken.c -- a sheet of a thickness T out of a mesh.
 *
 *     the largest curvature k at a vertex: T/2 k < 1, else the sheet folds over
 *     runs between two places along edges: one is open, two run against each other, anything else has no two sides
 *     at every place, of its normals n_i (turned as their surfaces are, those that are alike once):
 *         m = sum n_i,    o = T/2 m / mean(m . n_i)
 *     which is T/2 n where there is one, and with two or three at T/2 from the plane of each
 *     x + o, x - o, and strips along open edges
 *     no triangle may look the other way than where it comes from
 */
#include "core/fail.h"
#include "core/memory.h"
#include "core/vec3.h"
#include "mesh/parts.h"
#include "mesh/run.h"
#include "taut/limits.h"
#include "taut/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Normals nearer than this cosine (2.6 degrees) are one: what rounding, and poles, make of one tangent plane. */
static const double alike = 0.999;
/* A place moves by at most five times T/2: edges sharper than 23 degrees are none of a sheet's. */
static const double sharpest = 0.2;

/* Of a curvature: what is within that of folding folds. */
static const double rounding = 1e-9;

typedef struct thickening {
    const taut_mesh *thin;
    const taut_model *model;
    double half;         /* T/2 */
    double *moves;       /* double[vertices][3], at the first vertex of each place */
    unsigned char *open; /* [4 groups]: edges */
} thickening;

static taut_status fail_sheet(const thickening *work, int group, const char *what,
                              taut_error *error)
{
    return taut_fail(error, TAUT_NO_SOLUTION, "sheet", NULL, taut_none, taut_none,
                     "\"%.60s\" cannot be given a thickness: %s", work->thin->groups[group].name,
                     what);
}

/* The largest principal curvature, without its sign, of one row of points; 0 where there is no normal. */
static double curvature_of(int count, const taut_forms *forms)
{
    double most = 0;
    for (int j = 0; j < count; j++) {
        const double h = fabs(forms[j].mean);
        const double k = h + sqrt(fmax(h * h - forms[j].gaussian, 0));
        most = forms[j].regular && k > most ? k : most;
    }
    return most;
}

/* The largest curvature at the vertices of a group. */
static taut_status bend_group(const thickening *work, const taut_mesh_group *group, int threads,
                              double *most)
{
    const taut_surface *surface = taut_model_surface(work->model, group->surface);
    const double *parameters = work->thin->parameters + 2 * group->first_vertex;
    const size_t nv = (size_t)group->nv;
    double *v = taut_alloc(nv, sizeof *v);
    taut_forms *forms = taut_alloc(nv, sizeof *forms);
    taut_status status = v != NULL && forms != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (size_t j = 0; status == TAUT_OK && j < nv; j++) {
        v[j] = parameters[2 * j + 1];
    }
    for (size_t i = 0; status == TAUT_OK && i < (size_t)group->nu; i++) {
        status = taut_surface_forms_grid(surface, 1, parameters + 2 * i * nv, group->nv, v, threads,
                                         forms);
        if (status == TAUT_OK) {
            *most = fmax(*most, curvature_of(group->nv, forms));
        }
    }
    taut_free(v);
    taut_free(forms);
    return status;
}

static taut_status check_curvature(const thickening *work, int threads, taut_error *error)
{
    for (int g = 0; g < work->thin->group_count; g++) {
        double most = 0;
        if (bend_group(work, &work->thin->groups[g], threads, &most) != TAUT_OK) {
            return taut_fail_memory(error);
        }
        if (!(work->half * most < 1 - rounding)) {
            return taut_fail(error, TAUT_NO_SOLUTION, "fold", NULL, 2 * work->half, 2 / most,
                             "a thickness of %.6g folds \"%.60s\" over: its least radius of "
                             "curvature is %.6g, expected a thickness below %.6g",
                             2 * work->half, work->thin->groups[g].name, 1 / most, 2 / most);
        }
    }
    return TAUT_OK;
}

/* A cell's side along an edge: its two places, the lower first, and the way the sheet runs it. */
typedef struct side {
    uint32_t lo, hi;
    int edge, forwards;
} side;

static int by_places(const void *a, const void *b)
{
    const side *x = a, *y = b;
    if (x->lo != y->lo) {
        return x->lo < y->lo ? -1 : 1;
    }
    if (x->hi != y->hi) {
        return x->hi < y->hi ? -1 : 1;
    }
    return x->edge < y->edge ? -1 : x->edge > y->edge;
}

/* The sides along one edge, those that are points left out: how many. */
static size_t list_sides(const taut_mesh *thin, int edge, side *sides)
{
    const taut_edge_run run = taut_edge_run_of(thin->groups, edge);
    const int forwards = taut_edge_run_is_along(edge) != (thin->groups[edge / 4].turned != 0);
    size_t count = 0;
    for (int k = 0; k + 1 < run.count; k++) {
        const uint32_t a = thin->welded[taut_edge_run_at(&run, k)];
        const uint32_t b = thin->welded[taut_edge_run_at(&run, k + 1)];
        if (a != b) {
            sides[count++] = a < b ? (side){a, b, edge, forwards} : (side){b, a, edge, !forwards};
        }
    }
    return count;
}

/* Marks edges as open or joined from their sorted sides; an edge cannot be both. */
static taut_status judge_sides(const thickening *work, size_t count, const side *sides,
                               unsigned char *joined, taut_error *error)
{
    for (size_t i = 0, next = 0; i < count; i = next) {
        for (next = i;
             next < count && sides[next].lo == sides[i].lo && sides[next].hi == sides[i].hi;
             next++) {
        }
        const int group = sides[i].edge / 4;
        if (next - i > 2) {
            return fail_sheet(work, group, "three surfaces meet along an edge", error);
        }
        if (next - i == 2 && sides[i].forwards == sides[i + 1].forwards) {
            return fail_sheet(work, group, "it closes to a band with one side only", error);
        }
        for (size_t k = i; k < next; k++) {
            unsigned char *as = next - i == 1 ? work->open : joined;
            as[sides[k].edge] = 1;
        }
    }
    for (int e = 0; e < 4 * work->thin->group_count; e++) {
        if (work->open[e] && joined[e]) {
            return fail_sheet(work, e / 4, "an edge meets another one along a part of it", error);
        }
    }
    return TAUT_OK;
}

static taut_status find_open(thickening *work, taut_arena *scratch, taut_error *error)
{
    const taut_mesh *thin = work->thin;
    const int edges = 4 * thin->group_count;
    size_t room = 0, count = 0;
    for (int e = 0; e < edges; e++) {
        room += (size_t)taut_edge_run_of(thin->groups, e).count;
    }
    side *sides = taut_arena_take(scratch, room, sizeof *sides);
    unsigned char *joined = taut_arena_take(scratch, (size_t)edges, 1);
    work->open = taut_arena_take(scratch, (size_t)edges, 1);
    if (taut_arena_status(scratch) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int e = 0; e < edges; e++) {
        count += list_sides(thin, e, sides + count);
    }
    qsort(sides, count, sizeof *sides, by_places);
    return judge_sides(work, count, sides, joined, error);
}

/* The vertices of each place as chains: next[i], the place's first vertex first, -1 at the end. Vertices of one place come in
 * their order. */
static void chain_places(const taut_mesh *thin, int64_t *next, int64_t *last)
{
    for (size_t i = 0; i < thin->vertex_count; i++) {
        const size_t place = thin->welded[i];
        next[i] = -1;
        if (place != i) {
            next[last[place]] = (int64_t)i;
        }
        last[place] = (int64_t)i;
    }
}

static double sign_of(const taut_mesh *thin, const int32_t *owner, size_t vertex)
{
    return thin->groups[owner[vertex]].turned ? -1 : 1;
}

/* Has an earlier vertex of the place the normal of vertex i? */
static int is_known(const taut_mesh *thin, const int32_t *owner, const int64_t *next, size_t place,
                    size_t i)
{
    int64_t k = (int64_t)place;
    while (k != (int64_t)i && !(sign_of(thin, owner, (size_t)k) * sign_of(thin, owner, i) *
                                    taut_dot(thin->normals + 3 * k, thin->normals + 3 * i) >
                                alike)) {
        k = next[k];
    }
    return k != (int64_t)i;
}

/* The move of one place; 0 where its surfaces meet too sharply. */
static int find_move(const thickening *work, const int32_t *owner, const int64_t *next,
                     size_t place, double move[3])
{
    const taut_mesh *thin = work->thin;
    double least = INFINITY, sum = 0;
    int count = 0;

    memset(move, 0, 3 * sizeof *move);
    for (int64_t i = (int64_t)place; i >= 0; i = next[i]) {
        if (!is_known(thin, owner, next, place, (size_t)i)) {
            taut_add_scaled(sign_of(thin, owner, (size_t)i), thin->normals + 3 * i, move);
            count++;
        }
    }
    const double length = taut_length(move);
    for (int64_t i = (int64_t)place; i >= 0; i = next[i]) {
        if (!is_known(thin, owner, next, place, (size_t)i)) {
            const double along =
                sign_of(thin, owner, (size_t)i) * taut_dot(move, thin->normals + 3 * i);
            least = fmin(least, along);
            sum += along;
        }
    }
    for (int c = 0; c < 3; c++) {
        move[c] *= work->half * count / sum;
    }
    return least > sharpest * length;
}

static taut_status find_moves(thickening *work, taut_arena *scratch, taut_error *error)
{
    const taut_mesh *thin = work->thin;
    const size_t count = thin->vertex_count;
    int64_t *next = taut_arena_take(scratch, count, sizeof *next);
    int64_t *last = taut_arena_take(scratch, count, sizeof *last);
    int32_t *owner = taut_arena_take(scratch, count, sizeof *owner);
    work->moves = taut_arena_take(scratch, count, 3 * sizeof *work->moves);
    if (taut_arena_status(scratch) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    for (int g = 0; g < thin->group_count; g++) {
        const taut_mesh_group *group = &thin->groups[g];
        for (size_t i = 0; i < (size_t)group->nu * (size_t)group->nv; i++) {
            owner[group->first_vertex + i] = g;
        }
    }
    chain_places(thin, next, last);
    for (size_t i = 0; i < count; i++) {
        if (thin->welded[i] == i && !find_move(work, owner, next, i, work->moves + 3 * i)) {
            return fail_sheet(work, owner[i], "surfaces meet at an edge that is too sharp", error);
        }
    }
    return TAUT_OK;
}

/* The counts of the thick mesh. */
static taut_status count_parts(const thickening *work, taut_mesh *thick, size_t *strips,
                               taut_error *error)
{
    const taut_mesh *thin = work->thin;
    double vertices = 2.0 * (double)thin->vertex_count;
    *strips = 0;
    thick->quad_count = 2 * thin->quad_count;
    for (int e = 0; e < 4 * thin->group_count; e++) {
        if (work->open[e]) {
            const taut_edge_run run = taut_edge_run_of(thin->groups, e);
            vertices += 2.0 * run.count;
            thick->quad_count += (size_t)run.count - 1;
            (*strips)++;
        }
    }
    if (vertices > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "too-fine", NULL, vertices, TAUT_POINTS_MAX,
                         "a mesh of %.0f vertices, expected at most %d: ask for a coarser one",
                         vertices, TAUT_POINTS_MAX);
    }
    thick->vertex_count = (size_t)vertices;
    return TAUT_OK;
}

/* Side 0, which the sheet is turned to, or 1, the other one, of every group. */
static void fill_side(const thickening *work, int other, taut_mesh *thick)
{
    const taut_mesh *thin = work->thin;
    const size_t count = thin->vertex_count, first = other ? count : 0;
    for (size_t i = 0; i < count; i++) {
        double *x = thick->positions + 3 * (first + i);
        memcpy(x, thin->positions + 3 * i, 3 * sizeof *x);
        taut_add_scaled(other ? -1 : 1, work->moves + 3 * (size_t)thin->welded[i], x);
        thick->welded[first + i] = (uint32_t)first + thin->welded[i];
    }
    memcpy(thick->normals + 3 * first, thin->normals, 3 * count * sizeof(double));
    memcpy(thick->parameters + 2 * first, thin->parameters, 2 * count * sizeof(double));
    for (int g = 0; g < thin->group_count; g++) {
        taut_mesh_group *group = &thick->groups[thick->group_count++];
        *group = thin->groups[g];
        group->first_vertex += first;
        group->first_quad += other ? thin->quad_count : 0;
        group->turned = other ? !group->turned : group->turned;
    }
}

/* The strip along an open edge: its vertices of side 1, then of side 0, along the parameter that the edge is held at, so that
 * parameters are those of a grid. */
static void fill_strip(const thickening *work, int edge, taut_mesh *thick, size_t *vertex,
                       size_t *quad)
{
    const taut_mesh *thin = work->thin;
    const taut_edge_run run = taut_edge_run_of(thin->groups, edge);
    const int of_v =
        edge % 4 < 2; /* the edge runs along v, so the strip's u goes through the sheet */
    const int along = taut_edge_run_is_along(edge) == of_v;
    taut_mesh_group *group = &thick->groups[thick->group_count++];

    *group = thin->groups[edge / 4];
    group->nu = of_v ? 2 : run.count;
    group->nv = of_v ? run.count : 2;
    group->first_vertex = *vertex;
    group->first_quad = *quad;
    group->turned = along != (group->turned != 0);
    for (int through = 0; through < 2; through++) {
        for (int k = 0; k < run.count; k++) {
            const size_t at = taut_edge_run_at(&run, k);
            const size_t from = thick->welded[at + (through ? 0 : thin->vertex_count)];
            const size_t to = *vertex + (of_v ? (size_t)through * (size_t)run.count + (size_t)k
                                              : 2 * (size_t)k + (size_t)through);
            memcpy(thick->positions + 3 * to, thick->positions + 3 * from, 3 * sizeof(double));
            memcpy(thick->parameters + 2 * to, thin->parameters + 2 * at, 2 * sizeof(double));
            thick->welded[to] = (uint32_t)from;
        }
    }
    *vertex += 2 * (size_t)run.count;
    *quad += (size_t)run.count - 1;
}

static void area_of(const double *positions, const uint32_t *triangle, double area[3])
{
    double p[3], q[3];
    taut_difference(positions + 3 * (size_t)triangle[1], positions + 3 * (size_t)triangle[0], p);
    taut_difference(positions + 3 * (size_t)triangle[2], positions + 3 * (size_t)triangle[0], q);
    taut_cross(p, q, area);
}

/* Has every triangle of the thin mesh, moved to a side, the sense that it had? */
static taut_status check_folds(const thickening *work, const taut_mesh *thick, taut_error *error)
{
    const taut_mesh *thin = work->thin;
    for (int g = 0; g < thin->group_count; g++) {
        const size_t first = 2 * thin->groups[g].first_quad;
        const size_t count =
            2 * (size_t)(thin->groups[g].nu - 1) * (size_t)(thin->groups[g].nv - 1);
        for (size_t t = first; t < first + count; t++) {
            const uint32_t *triangle = thin->triangles + 3 * t;
            const uint32_t *w = thin->welded;
            double was[3], is[2][3];
            area_of(thin->positions, triangle, was);
            area_of(thick->positions, triangle, is[0]);
            area_of(thick->positions + 3 * thin->vertex_count, triangle, is[1]);
            if (w[triangle[0]] != w[triangle[1]] && w[triangle[1]] != w[triangle[2]] &&
                w[triangle[2]] != w[triangle[0]] &&
                !(taut_dot(was, is[0]) > 0 && taut_dot(was, is[1]) > 0)) {
                return taut_fail(error, TAUT_NO_SOLUTION, "fold", NULL, 2 * work->half, taut_none,
                                 "a thickness of %.6g folds \"%.60s\" over where it meets its "
                                 "neighbour, or in a cell smaller than that: take a smaller one, "
                                 "or a coarser mesh",
                                 2 * work->half, thin->groups[g].name);
            }
        }
    }
    return TAUT_OK;
}

static taut_status fill_thick(const thickening *work, taut_mesh *thick, taut_error *error)
{
    const taut_mesh *thin = work->thin;
    size_t strips = 0, vertex = 2 * thin->vertex_count, quad = 2 * thin->quad_count;
    taut_status status = count_parts(work, thick, &strips, error);
    if (status != TAUT_OK) {
        return status;
    }
    thick->groups = taut_arena_take(thick->arena, 2 * (size_t)thin->group_count + strips,
                                    sizeof *thick->groups);
    status = taut_mesh_take_arrays(thick, error);
    if (status != TAUT_OK) {
        return status;
    }
    fill_side(work, 0, thick);
    fill_side(work, 1, thick);
    status = check_folds(work, thick, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int e = 0; e < 4 * thin->group_count; e++) {
        if (work->open[e]) {
            fill_strip(work, e, thick, &vertex, &quad);
        }
    }
    for (int g = 0; g < thick->group_count; g++) {
        thick->groups[g].name = taut_arena_text(thick->arena, thick->groups[g].name);
        if (thick->groups[g].name == NULL) {
            return taut_fail_memory(error);
        }
        taut_mesh_fill_faces(thick, &thick->groups[g]);
    }
    return TAUT_OK;
}

static taut_status thicken(thickening *work, int threads, taut_arena *scratch, taut_mesh *thick,
                           taut_error *error)
{
    taut_status status = check_curvature(work, threads, error);
    if (status == TAUT_OK) {
        status = find_open(work, scratch, error);
    }
    if (status == TAUT_OK) {
        status = find_moves(work, scratch, error);
    }
    return status == TAUT_OK ? fill_thick(work, thick, error) : status;
}

taut_status taut_mesh_thicken(const taut_mesh *thin, const taut_model *model, double thickness,
                              int threads, taut_mesh *thick, taut_error *error)
{
    thickening work = {.thin = thin, .model = model, .half = thickness / 2};
    taut_arena *scratch = taut_arena_new();
    const taut_status status = thicken(&work, threads, scratch, thick, error);
    taut_arena_free(scratch);
    return status;
}
