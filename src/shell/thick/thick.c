/* thick.c -- a sheet out of a shell.
 *
 *     shells of the surfaces, which also say how they are turned             (shell.h)
 *     knots that all have along shared edges                                 (lines.c)
 *     repeat: for each surface, splines x^ and n^ through x and n            (target.c, fit.c)
 *                 |x^ - x| + T/2 |n^ - n| between nodes of u, at those of v, and the other way round;
 *                 spans where it is above the tolerance are halved
 *         until there is none
 *     sides x^ + T/2 n^ and x^ - T/2 n^; walls between their edges where nothing meets
 *     how far the sides are from where they belong: found at places, and a bound (prove.c)
 */
#include "shell/thick/thick.h"

#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "shell/thick/parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    LOOKS = 4,
    ROUNDS_MAX = 24
}; /* places in a span; a span halved so often is 1e-7 of a line */

static const double one_place = 1e-7; /* of the size: nearer points are one */

/* ---- how surfaces meet ---- */

static void place_side(taut_thick_work *work, const taut_shell_edge *edge, int second)
{
    const int side = edge->side[second], against = second && edge->reversed;
    work->partner[side] = edge->side[1 - second];
    work->reversed[side] = (unsigned char)edge->reversed;
    for (int end = 0; end < 2; end++) {
        work->vertex[taut_shell_corner(side, end)] = edge->vertex[against ? 1 - end : end];
    }
}

static taut_status check_poles(const taut_thick_work *work, taut_error *error)
{
    for (int e = 0; e < 4 * work->count; e++) {
        if (work->shells->faces[e / 4].edge[e % 4] < 0) {
            return taut_fail(error, TAUT_NO_SOLUTION, "sheet", NULL, taut_none, taut_none,
                             "\"%.60s\" cannot be given a thickness for CAD: its edge %s is one "
                             "point (meshes take it: write .3mf, .stl or .obj)",
                             taut_surface_name(work->surfaces[e / 4]),
                             taut_edge_name((taut_edge)(e % 4)));
        }
    }
    return TAUT_OK;
}

static taut_status find_meetings(taut_thick_work *work)
{
    const size_t edges = 4 * (size_t)work->count;
    const taut_shells *shells = work->shells;
    work->partner = taut_arena_take(work->arena, edges, sizeof *work->partner);
    work->reversed = taut_arena_take(work->arena, edges, 1);
    work->vertex = taut_arena_take(work->arena, edges, sizeof *work->vertex);
    work->next = taut_arena_take(work->arena, edges, sizeof *work->next);
    work->first = taut_arena_take(work->arena, (size_t)shells->vertex_count, sizeof *work->first);
    if (taut_arena_status(work->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int e = 0; e < shells->edge_count; e++) {
        for (int second = 0; second < 2 && shells->edges[e].side[second] >= 0; second++) {
            place_side(work, &shells->edges[e], second);
        }
        if (shells->edges[e].side[1] < 0) {
            work->partner[shells->edges[e].side[0]] = -1;
        }
    }
    for (int i = 0; i < shells->vertex_count; i++) {
        work->first[i] = -1;
    }
    for (int c = 4 * work->count - 1; c >= 0; c--) {
        work->next[c] = work->first[work->vertex[c]];
        work->first[work->vertex[c]] = c;
    }
    return TAUT_OK;
}

/* A free edge, by where its middle is along a line that no edges are made for. */
typedef struct free_edge {
    double shadow;
    int edge;
    double middle[3],
        ends[3]; /* of the two ends: their mean, which does not ask which way it runs */
} free_edge;

static int by_shadow(const void *a, const void *b)
{
    const free_edge *x = a, *y = b;
    return x->shadow != y->shadow ? (x->shadow < y->shadow ? -1 : 1) : x->edge - y->edge;
}

static void place_free(const taut_surface *surface, int e, free_edge *edge)
{
    static const double line[3] = {0.5477, 0.6123, 0.5703};
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const taut_basis *along = e < 2 ? v : u, *across = e < 2 ? u : v;
    const double held = e % 2 == 0 ? taut_basis_lo(across) : taut_basis_hi(across);
    const double lo = taut_basis_lo(along), hi = taut_basis_hi(along);
    const double at[3] = {lo, lo + (hi - lo) / 2, hi};
    double x[3][3];
    for (int k = 0; k < 3; k++) {
        taut_surface_eval(surface, e < 2 ? held : at[k], e < 2 ? at[k] : held, 0, x[k]);
    }
    for (int c = 0; c < 3; c++) {
        edge->middle[c] = x[1][c];
        edge->ends[c] = x[0][c] / 2 + x[2][c] / 2;
    }
    edge->shadow = taut_dot(line, edge->middle);
}

/* Edges that meet no other, and yet lie on each other: three surfaces at a line, or two that no side of a sheet can join. */
static taut_status check_free(const taut_thick_work *work, taut_error *error)
{
    free_edge *list = taut_arena_take(work->arena, 4 * (size_t)work->count, sizeof *list);
    double size = 0;
    int count = 0;
    if (list == NULL) {
        return taut_fail_memory(error);
    }
    for (int f = 0; f < work->count; f++) {
        const taut_surface *surface = work->surfaces[f];
        size = fmax(size, taut_half_size(taut_point_count(surface), taut_surface_points(surface)));
    }
    for (int e = 0; e < 4 * work->count; e++) {
        if (work->partner[e] < 0) {
            list[count].edge = e;
            place_free(work->surfaces[e / 4], e % 4, &list[count++]);
        }
    }
    qsort(list, (size_t)count, sizeof *list, by_shadow);
    for (int i = 0; i < count; i++) {
        for (int k = i + 1; k < count && list[k].shadow - list[i].shadow <= one_place * size; k++) {
            if (taut_distance(list[i].middle, list[k].middle) <= one_place * size &&
                taut_distance(list[i].ends, list[k].ends) <= one_place * size) {
                return taut_fail(error, TAUT_NO_SOLUTION, "sheet", NULL, taut_none, taut_none,
                                 "\"%.60s\" cannot be given a thickness: its edge %s lies on "
                                 "%s of \"%.60s\", and on more, or cannot be joined to it",
                                 taut_surface_name(work->surfaces[list[i].edge / 4]),
                                 taut_edge_name((taut_edge)(list[i].edge % 4)),
                                 taut_edge_name((taut_edge)(list[k].edge % 4)),
                                 taut_surface_name(work->surfaces[list[k].edge / 4]));
            }
        }
    }
    return TAUT_OK;
}

/* ---- splines, and how near they come ---- */

static taut_status fit_face(taut_thick_work *work, int face, taut_arena *arena,
                            taut_thick_sides *fit, taut_error *error)
{
    taut_status status = taut_thick_basis(work, 2 * face, &fit->u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_thick_basis(work, 2 * face + 1, &fit->v, error);
    if (status != TAUT_OK) {
        return status;
    }
    const size_t nu = (size_t)taut_basis_count(fit->u), nv = (size_t)taut_basis_count(fit->v);
    double *u = taut_arena_take(arena, nu, sizeof *u), *v = taut_arena_take(arena, nv, sizeof *v);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_thick_nodes(fit->u, u);
    taut_thick_nodes(fit->v, v);
    taut_thick_grid grid = {.nu = (int)nu, .nv = (int)nv, .u = u, .v = v};
    status = taut_thick_fill_grid(work, face, arena, &grid, error);
    if (status == TAUT_OK && (taut_thick_fit(fit->u, fit->v, grid.places) != TAUT_OK ||
                              taut_thick_fit(fit->u, fit->v, grid.moves) != TAUT_OK)) {
        status = taut_fail_memory(error);
    }
    fit->places = grid.places;
    fit->moves = grid.moves;
    return status;
}

static void free_fit(taut_thick_sides *fit)
{
    taut_basis_free(fit->u);
    taut_basis_free(fit->v);
}

static taut_status eval_net(const taut_thick_sides *fit, const double *net,
                            const taut_thick_grid *grid, int threads, double *values,
                            taut_error *error)
{
    taut_surface *surface = NULL;
    taut_status status = taut_surface_new("", fit->u, fit->v, net, NULL, &surface, error);
    if (status == TAUT_OK && taut_surface_eval_grid(surface, grid->nu, grid->u, grid->nv, grid->v,
                                                    0, threads, values) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    taut_surface_free(surface);
    return status;
}

/* How far the splines are from a grid: off[nu][nv] from what they interpolate; in *most the largest from the sides themselves, and
 * what joining them to their neighbours takes of that. */
static taut_status compare(const taut_thick_work *work, const taut_thick_sides *fit,
                           const taut_thick_grid *grid, taut_arena *arena, double *off,
                           taut_thick *most, taut_error *error)
{
    const size_t count = (size_t)grid->nu * (size_t)grid->nv;
    double *x = taut_arena_take(arena, count, 3 * sizeof *x);
    double *n = taut_arena_take(arena, count, 3 * sizeof *n);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    taut_status status = eval_net(fit, fit->places, grid, work->threads, x, error);
    status = status == TAUT_OK ? eval_net(fit, fit->moves, grid, work->threads, n, error) : status;
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        off[i] = taut_distance(x + 3 * i, grid->places + 3 * i) +
                 work->half * taut_distance(n + 3 * i, grid->moves + 3 * i);
        for (int side = -1; side <= 1; side += 2) {
            double from[3];
            taut_difference(x + 3 * i, grid->surface + 3 * i, from);
            taut_add_scaled(side * work->half, n + 3 * i, from);
            taut_add_scaled(-side * work->half, grid->normals + 3 * i, from);
            most->distance = fmax(most->distance, taut_length(from));
            taut_difference(grid->places + 3 * i, grid->surface + 3 * i, from);
            taut_add_scaled(side * work->half, grid->moves + 3 * i, from);
            taut_add_scaled(-side * work->half, grid->normals + 3 * i, from);
            most->parted = fmax(most->parted, taut_length(from));
        }
    }
    return status;
}

/* LOOKS places in each span, and the ends; of the whole direction where `basis` is NULL, else the nodes. */
static int list_shares(taut_thick_work *work, int direction, const taut_basis *basis,
                       taut_arena *arena, double **shares)
{
    const int breaks = taut_thick_breaks_of(work, direction, NULL);
    const int count = basis != NULL ? taut_basis_count(basis) : LOOKS * (breaks - 1) + 2;
    double *at = taut_arena_take(arena, (size_t)breaks, sizeof *at);
    *shares = taut_arena_take(arena, (size_t)count, sizeof **shares);
    if (taut_arena_status(arena) != TAUT_OK) {
        return 0;
    }
    if (basis != NULL) {
        taut_thick_nodes(basis, *shares);
        return count;
    }
    taut_thick_breaks_of(work, direction, at);
    for (int i = 0; i < LOOKS * (breaks - 1); i++) {
        const double part = (i % LOOKS + 0.5) / LOOKS;
        (*shares)[i + 1] = at[i / LOOKS] + part * (at[i / LOOKS + 1] - at[i / LOOKS]);
    }
    (*shares)[count - 1] = 1;
    return count;
}

/* Marks the spans of one direction in which the splines are too far off. */
static void mark_spans(taut_thick_work *work, int face, int along, const taut_thick_grid *grid,
                       const double *off, double tolerance)
{
    for (int i = 0; i < grid->nu; i++) {
        for (int j = 0; j < grid->nv; j++) {
            const int at = along == 0 ? i : j, last = (along == 0 ? grid->nu : grid->nv) - 1;
            if (at > 0 && at < last && off[(size_t)i * (size_t)grid->nv + (size_t)j] > tolerance) {
                taut_thick_mark(work, 2 * face + along, (at - 1) / LOOKS);
            }
        }
    }
}

/* Looks along u (0), along v (1), or everywhere (2), which marks nothing. */
static taut_status look(taut_thick_work *work, int face, const taut_thick_sides *fit, int along,
                        double tolerance, taut_arena *arena, taut_thick *most, taut_error *error)
{
    double *u = NULL, *v = NULL;
    taut_thick_grid grid = {
        .nu = list_shares(work, 2 * face, along == 1 ? fit->u : NULL, arena, &u),
        .nv = list_shares(work, 2 * face + 1, along == 0 ? fit->v : NULL, arena, &v)};
    double *off = taut_arena_take(arena, (size_t)grid.nu * (size_t)grid.nv, sizeof *off);
    if (taut_arena_status(arena) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    grid.u = u;
    grid.v = v;
    taut_status status = taut_thick_fill_grid(work, face, arena, &grid, error);
    status = status == TAUT_OK ? compare(work, fit, &grid, arena, off, most, error) : status;
    if (status == TAUT_OK && along < 2) {
        mark_spans(work, face, along, &grid, off, tolerance);
    }
    return status;
}

/* One round over a surface: marks, or where there is a sheet its distance. */
static taut_status judge_face(taut_thick_work *work, int face, double tolerance, taut_thick *sheet,
                              taut_error *error)
{
    taut_thick_sides fit = {NULL, NULL, NULL, NULL};
    const int last = sheet != NULL;
    taut_thick ignored = {.distance = 0};
    taut_arena *arena = taut_arena_new();
    taut_status status = fit_face(work, face, arena, &fit, error);
    for (int along = last ? 2 : 0; along < (last ? 3 : 2) && status == TAUT_OK; along++) {
        status = look(work, face, &fit, along, tolerance, arena, last ? sheet : &ignored, error);
    }
    free_fit(&fit);
    taut_arena_free(arena);
    return status;
}

static taut_status refine(taut_thick_work *work, double tolerance, taut_error *error)
{
    for (int round = 0, halved = 1; halved > 0 && round < ROUNDS_MAX; round++) {
        for (int f = 0; f < work->count; f++) {
            const taut_status status = judge_face(work, f, tolerance, NULL, error);
            if (status != TAUT_OK) {
                return status;
            }
        }
        const taut_status status = taut_thick_halve_lines(work, &halved, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return TAUT_OK;
}

/* ---- the surfaces of the sheet ---- */

static taut_status add_surface(const char *of, const char *what, int from, const taut_basis *u,
                               const taut_basis *v, const double *net, taut_thick *sheet,
                               taut_error *error)
{
    char name[TAUT_NAME_MAX + 1];
    taut_surface *surface = NULL;
    snprintf(name, sizeof name, "%.240s%s%s", of, of[0] != '\0' ? "." : "", what);
    const taut_status status = taut_surface_new(name, u, v, net, NULL, &surface, error);
    if (status != TAUT_OK) {
        return status;
    }
    sheet->from[taut_model_surface_count(sheet->model)] = from;
    if (taut_model_add_surface(sheet->model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        return taut_fail_memory(error);
    }
    return TAUT_OK;
}

/* One side: x^ + height n^. */
static void lay_side(const taut_thick_sides *fit, double height, double *net)
{
    const size_t count = 3 * (size_t)taut_basis_count(fit->u) * (size_t)taut_basis_count(fit->v);
    for (size_t k = 0; k < count; k++) {
        net[k] = fit->places[k] + height * fit->moves[k];
    }
}

/* The wall along edge e: its own parameter first, then from the bottom to the top. */
static taut_status add_wall(const taut_thick_work *work, int face, int e,
                            const taut_thick_sides *fit, double *const sides[2], taut_arena *arena,
                            taut_thick *sheet, taut_error *error)
{
    static const double ends[4] = {0, 0, 1, 1};
    const taut_basis_spec through = {
        .type = "bspline", .degree = 1, .knot_count = 4, .knots = ends};
    const size_t nu = (size_t)taut_basis_count(fit->u), nv = (size_t)taut_basis_count(fit->v);
    const size_t count = e < 2 ? nv : nu, step = e < 2 ? 1 : nv;
    const size_t first = e % 2 == 0 ? 0 : e < 2 ? (nu - 1) * nv : nv - 1;
    double *net = taut_arena_take(arena, 2 * count, 3 * sizeof *net);
    taut_basis *across = NULL;
    taut_status status =
        net == NULL ? taut_fail_memory(error) : taut_basis_new(&through, 2, &across, error);
    for (size_t k = 0; status == TAUT_OK && k < 2 * count; k++) {
        memcpy(net + 3 * k, sides[1 - k % 2] + 3 * (first + k / 2 * step), 3 * sizeof *net);
    }
    if (status == TAUT_OK) {
        status = add_surface(taut_surface_name(work->surfaces[face]), taut_edge_name((taut_edge)e),
                             face, e < 2 ? fit->v : fit->u, across, net, sheet, error);
    }
    taut_basis_free(across);
    return status;
}

static taut_status add_face(taut_thick_work *work, int face, const taut_thick_sides *fit,
                            taut_arena *arena, taut_thick *sheet, taut_error *error)
{
    static const char *const names[2] = {"top", "bottom"};
    const size_t count = (size_t)taut_basis_count(fit->u) * (size_t)taut_basis_count(fit->v);
    double *sides[2];
    taut_status status = TAUT_OK;
    for (int k = 0; k < 2 && status == TAUT_OK; k++) {
        sides[k] = taut_arena_take(arena, count, 3 * sizeof *sides[k]);
        if (sides[k] == NULL) {
            return taut_fail_memory(error);
        }
        lay_side(fit, k == 0 ? work->half : -work->half, sides[k]);
        status = add_surface(taut_surface_name(work->surfaces[face]), names[k], face, fit->u,
                             fit->v, sides[k], sheet, error);
    }
    for (int e = 0; e < 4 && status == TAUT_OK; e++) {
        if (work->partner[4 * face + e] < 0) {
            status = add_wall(work, face, e, fit, sides, arena, sheet, error);
        }
    }
    return status;
}

static taut_status add_faces(taut_thick_work *work, double tolerance, taut_thick *sheet,
                             taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int f = 0; f < work->count && status == TAUT_OK; f++) {
        taut_thick_sides fit = {NULL, NULL, NULL, NULL};
        double bound = 0;
        taut_arena *arena = taut_arena_new();
        status = judge_face(work, f, 0, sheet, error);
        status = status == TAUT_OK ? fit_face(work, f, arena, &fit, error) : status;
        if (status == TAUT_OK &&
            taut_thick_prove(work, f, &fit, tolerance, sheet->distance, &bound) != TAUT_OK) {
            status = taut_fail_memory(error);
        }
        sheet->bound = fmax(sheet->bound, bound);
        status = status == TAUT_OK ? add_face(work, f, &fit, arena, sheet, error) : status;
        free_fit(&fit);
        taut_arena_free(arena);
    }
    return status;
}

/* All between the shells and the sheet. */
static taut_status make(taut_thick_work *work, const taut_thick_request *request, taut_thick *sheet,
                        taut_error *error)
{
    taut_status status = check_poles(work, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (find_meetings(work) != TAUT_OK || taut_thick_find_lines(work) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    status = check_free(work, error);
    if (status == TAUT_OK) {
        status = refine(work, request->tolerance, error);
    }
    return status == TAUT_OK ? add_faces(work, request->tolerance, sheet, error) : status;
}

taut_status taut_thick_new(const taut_model *nurbs, const taut_thick_request *request,
                           taut_arena *arena, taut_thick *sheet, taut_error *error)
{
    const int count = taut_model_surface_count(nurbs);
    taut_arena *scratch = taut_arena_new();
    taut_shells shells;
    const taut_surface **surfaces = taut_arena_take(scratch, (size_t)count, sizeof(taut_surface *));
    taut_thick_work work = {.surfaces = surfaces,
                            .count = count,
                            .half = request->thickness / 2,
                            .threads = request->threads,
                            .shells = &shells,
                            .arena = scratch};
    taut_thick made = {.from = taut_arena_take(arena, 6 * (size_t)count, sizeof(int))};
    taut_status status = TAUT_NO_MEMORY;
    for (int i = 0; surfaces != NULL && i < count; i++) {
        surfaces[i] = taut_model_surface(nurbs, i);
    }
    if (surfaces != NULL && made.from != NULL && taut_model_new(&made.model) == TAUT_OK) {
        taut_model_set_unit(made.model, taut_model_unit(nurbs));
        status = taut_shells_find(surfaces, count, request->moved, scratch, &shells);
    }
    status = status == TAUT_OK ? make(&work, request, &made, error) : taut_fail_memory(error);
    taut_arena_free(scratch);
    if (status != TAUT_OK) {
        taut_model_free(made.model);
        return status;
    }
    *sheet = made;
    return TAUT_OK;
}
