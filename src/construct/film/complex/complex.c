/* complex.c -- films of many patches.
 *
 *     1. check the data
 *     2. nodes, holds, the start (construct/film/complex/layout.h); what can be told of them (balance.h, flat.h)
 *     3. Newton's steps to the least energy (construct/film/complex/solve.h), and again where it becomes its own reference
 *     4. a witness of how near it is to the least area of all (construct/film/complex/witness.h)
 *     5. a surface of each patch, and each cable as a curve, "NAME.u0", the row of points at its edge, bit for bit
 */
#include "construct/film/complex/complex.h"

#include "construct/common/build.h"
#include "construct/film/complex/balance.h"
#include "construct/film/complex/flat.h"
#include "construct/film/complex/refine.h"
#include "construct/film/complex/updates.h"
#include "construct/film/complex/witness.h"
#include "construct/film/edges.h"
#include "construct/film/images.h"
#include "construct/film/threads.h"
#include "construct/plateau/witness.h"
#include "core/fail.h"
#include "core/pace.h"
#include "core/vec3.h"
#include "problem/film_cells.h"
#include "problem/film_ropes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DEGREE_MOST = 10 };
static const char *const edge_names[4] = {"u0", "u1", "v0", "v1"};
static const char *const corner_names[4] = {"u0v0", "u1v0", "u0v1", "u1v1"};

static taut_status check_basis(const taut_basis *basis, int p, const char *member,
                               taut_error *error)
{
    char where[48];
    const char *type = taut_basis_type(basis);
    const int degree = taut_basis_degree(basis);

    if ((strcmp(type, "bezier") == 0 || strcmp(type, "bspline") == 0) && degree >= 2 &&
        degree <= DEGREE_MOST) {
        return TAUT_OK;
    }
    snprintf(where, sizeof where, "/patches/%d/%s", p, member);
    return taut_fail_expected(error, TAUT_BAD_INPUT, "basis", where, degree,
                              "bezier or bspline of degree 2 to 10",
                              "found a basis of type \"%s\" and degree %d", type, degree);
}

static taut_status check_positive(double value, double most, const char *where, const char *before,
                                  const char *member, taut_error *error)
{
    char at[96];

    if (value > 0 && value < most) {
        return TAUT_OK;
    }
    snprintf(at, sizeof at, "%.64s%s/%s", where, before, member);
    return taut_fail(error, TAUT_BAD_INPUT, "value", at, value, value > 0 ? most : 0,
                     "the %s of a cable is %.17g, expected a number above 0%s", member, value,
                     isfinite(most) ? " and below 1/2" : "");
}

static taut_status check_law(const taut_film_edge *edge, const char *where, const char *before,
                             taut_error *error)
{
    switch (edge->law) {
    case TAUT_FILM_FORCE:
        return check_positive(edge->force, INFINITY, where, before, "force", error);
    case TAUT_FILM_LENGTH:
        return check_positive(edge->length, INFINITY, where, before, "length", error);
    case TAUT_FILM_SAG:
        return check_positive(edge->sag, 0.5, where, before, "sag", error);
    case TAUT_FILM_ELASTIC: {
        const taut_status status =
            check_positive(edge->unstressed, INFINITY, where, before, "unstressed", error);
        return status == TAUT_OK
                   ? check_positive(edge->stiffness, INFINITY, where, before, "stiffness", error)
                   : status;
    }
    }
    return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                     "a cable has no law");
}

static taut_status check_edge(const taut_film_edge *edge, const char *where, taut_error *error)
{
    if (edge->kind == TAUT_FILM_CABLE && edge->along == 0) {
        const taut_status status = check_law(edge, where, "/cable", error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    const double size = taut_norm(edge->plane.direction), from = taut_norm(edge->plane.point);
    if ((edge->kind == TAUT_FILM_SLIDE || edge->has_plane) &&
        !(size > 0 && isfinite(size) && isfinite(from))) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "value", where, size,
                                  "a finite point, and a direction of a length above 0",
                                  "found a direction of length %.3g", size);
    }
    return TAUT_OK;
}

static taut_status check_threads(const taut_film_problem *patch, int p, taut_error *error)
{
    const taut_status status = taut_film_threads_check(patch, error);
    char member[32], where[64];

    if (status == TAUT_BAD_INPUT && error != NULL) {
        snprintf(member, sizeof member, "%.31s", error->where);
        snprintf(where, sizeof where, "/patches/%d%s", p, member);
        snprintf(error->where, sizeof error->where, "%s", where);
    }
    return status;
}

/* Is it the other name and primes, as images are called? */
static int is_image_name(const char *name, const char *of)
{
    const size_t length = strlen(of);
    return strncmp(name, of, length) == 0 && name[length] == '\'' &&
           strspn(name + length, "\'0123456789") == strlen(name + length);
}

static taut_status check_patch(const taut_film_problem *problem, int p, taut_error *error)
{
    const taut_film_problem *patch = &problem->patches[p];
    taut_status status = check_basis(patch->u, p, "u", error);
    char where[64];

    if (status == TAUT_OK) {
        status = check_basis(patch->v, p, "v", error);
    }
    for (int q = 0; status == TAUT_OK && q < p; q++) {
        if (strcmp(patch->name, problem->patches[q].name) == 0) {
            snprintf(where, sizeof where, "/patches/%d/name", p);
            return taut_fail(error, TAUT_BAD_INPUT, "name", where, q, p,
                             "patches %d and %d are both called %.80s: give each a name of its own",
                             q, p, patch->name);
        }
        if (problem->image_count > 0 && (is_image_name(patch->name, problem->patches[q].name) ||
                                         is_image_name(problem->patches[q].name, patch->name))) {
            snprintf(where, sizeof where, "/patches/%d/name", p);
            return taut_fail(error, TAUT_BAD_INPUT, "name", where, q, p,
                             "patches %d and %d are called %.80s and %.80s, as a patch and its "
                             "image are: give one of them another name",
                             q, p, problem->patches[q].name, patch->name);
        }
    }
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        snprintf(where, sizeof where, "/patches/%d/edges/%s", p, edge_names[e]);
        status = check_edge(&patch->edges[e], where, error);
    }
    for (int k = 0; status == TAUT_OK && k < 4; k++) {
        snprintf(where, sizeof where, "/patches/%d/corners/%s", p, corner_names[k]);
        if (patch->has_corner[k] && !isfinite(taut_norm(patch->corners[k]))) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none,
                             "corner %s is not a point of finite numbers", corner_names[k]);
        }
    }
    if (status == TAUT_OK) {
        status = check_threads(patch, p, error);
    }
    snprintf(where, sizeof where, "/patches/%d/tension", p);
    return status == TAUT_OK && patch->tension != 0 &&
                   !(patch->tension > 0 && isfinite(patch->tension))
               ? taut_fail(error, TAUT_BAD_INPUT, "value", where, patch->tension, 0,
                           "the tension is %.17g, expected a positive number", patch->tension)
               : status;
}

static taut_status check_cell(const taut_film_problem *problem, int c, taut_error *error)
{
    const taut_film_cell *cell = &problem->cells[c];
    const double given = cell->has_volume ? cell->volume : cell->pressure;
    char where[48];

    snprintf(where, sizeof where, "/cells/%d/%s", c, cell->has_volume ? "volume" : "pressure");
    if (!isfinite(given) || (cell->has_volume && given == 0)) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, given, taut_none,
                         "found %.17g, expected a finite number%s", given,
                         cell->has_volume ? " that is not 0" : "");
    }
    snprintf(where, sizeof where, "/cells/%d/from", c);
    if (!isfinite(taut_norm(cell->from))) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none,
                         "expected a point of finite numbers");
    }
    for (int other = 0; other < c; other++) {
        char names[2][TAUT_FILM_NAME];
        taut_film_cell_name(problem, other, names[0]);
        taut_film_cell_name(problem, c, names[1]);
        snprintf(where, sizeof where, "/cells/%d/name", c);
        if (strcmp(names[0], names[1]) == 0) {
            return taut_fail(error, TAUT_BAD_INPUT, "name", where, other, c,
                             "cells %d and %d are both called %s: give each a name of its own",
                             other, c, names[0]);
        }
    }
    return TAUT_OK;
}

static taut_status check_problem(const taut_film_problem *problem, taut_error *error)
{
    double points = 0;
    taut_status status = TAUT_OK;

    if (problem->cell_count < 0 || problem->cell_count > TAUT_FILM_CELLS_MAX ||
        (problem->cell_count > 0 && problem->cells == NULL)) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/cells", problem->cell_count,
                         TAUT_FILM_CELLS_MAX, "%d cells, expected 0 to %d", problem->cell_count,
                         TAUT_FILM_CELLS_MAX);
    }
    if (problem->refine < 0 || problem->refine > TAUT_FILM_REFINE_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", "/refine", problem->refine,
                         TAUT_FILM_REFINE_MAX, "found %d, expected 0 to %d", problem->refine,
                         TAUT_FILM_REFINE_MAX);
    }
    if (problem->patch_count > TAUT_FILM_PATCHES_MAX || problem->patches == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/patches", problem->patch_count,
                         TAUT_FILM_PATCHES_MAX, "%d patches, expected 1 to %d",
                         problem->patch_count, TAUT_FILM_PATCHES_MAX);
    }
    for (int p = 0; status == TAUT_OK && p < problem->patch_count; p++) {
        if (problem->patches[p].u == NULL || problem->patches[p].v == NULL ||
            problem->patches[p].name == NULL) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                             "a patch of a film needs a name and two bases");
        }
        points += (double)taut_basis_count(problem->patches[p].u) *
                  taut_basis_count(problem->patches[p].v);
        status = check_patch(problem, p, error);
    }
    if (status == TAUT_OK && points > TAUT_FILM_PATCHES_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/patches", points,
                         TAUT_FILM_PATCHES_POINTS_MAX,
                         "%.0f control points, expected at most %d: give fewer to the bases",
                         points, TAUT_FILM_PATCHES_POINTS_MAX);
    }
    if (status == TAUT_OK) {
        status = taut_film_images_check(problem, points, error);
    }
    for (int c = 0; status == TAUT_OK && c < problem->cell_count; c++) {
        status = check_cell(problem, c, error);
    }
    if (status == TAUT_OK &&
        (problem->along_count < 0 || problem->along_count > TAUT_FILM_ALONG_MAX ||
         (problem->along_count > 0 && problem->along == NULL))) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", "/cables", problem->along_count,
                         TAUT_FILM_ALONG_MAX, "%d cables, expected 0 to %d", problem->along_count,
                         TAUT_FILM_ALONG_MAX);
    }
    for (int a = 0; status == TAUT_OK && a < problem->along_count; a++) {
        char where[32];
        snprintf(where, sizeof where, "/cables/%d", a);
        status = check_law(&problem->along[a].edge, where, "", error);
    }
    for (int s = 0; status == TAUT_OK && s < problem->seam_count; s++) {
        char where[32];
        snprintf(where, sizeof where, "/seams/%d", s);
        status = check_edge(&problem->seams[s].edge, where, error);
    }
    if (status == TAUT_OK && problem->tolerance != 0 &&
        !(problem->tolerance >= 1e-14 && problem->tolerance <= 1e-3)) {
        status = taut_fail(error, TAUT_BAD_INPUT, "value", "/tolerance", problem->tolerance, 1e-14,
                           "found %.17g, expected a number from 1e-14 to 1e-3", problem->tolerance);
    }
    return status;
}

/* ---- the model ---- */

static taut_status add_patch(const taut_film_complex *c, int p, const double *points,
                             taut_arena *arena, taut_model *model, taut_error *error)
{
    const taut_film_problem *patch = &c->problem->patches[p];
    const int first = c->first[p], count = c->first[p + 1] - first;
    double *net = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_surface *surface = NULL;

    if (net == NULL) {
        return taut_fail_memory(error);
    }
    for (int k = 0; k < count; k++) {
        memcpy(net + 3 * k, points + 3 * c->node[first + k], 3 * sizeof(double));
    }
    const taut_status status =
        taut_surface_new(patch->name, patch->u, patch->v, net, NULL, &surface, error);
    return status == TAUT_OK ? taut_construct_add_surface(model, surface, error) : status;
}

static taut_status add_strand(const taut_film_complex *c, int k, const double *points,
                              taut_arena *arena, taut_model *model, taut_error *error)
{
    const taut_film_side *side = &c->strands[k].side;
    const taut_film_problem *patch = &c->problem->patches[side->patch];
    const taut_basis *basis = side->edge < 2 ? patch->v : patch->u;
    const int count = taut_basis_count(basis);
    double *row = taut_arena_take(arena, (size_t)count, 3 * sizeof(double));
    taut_curve *curve = NULL;
    char name[TAUT_FILM_NAME];

    if (row == NULL) {
        return taut_fail_memory(error);
    }
    for (int i = 0; i < count; i++) {
        memcpy(row + 3 * i, points + 3 * taut_film_complex_node(c, side, i), 3 * sizeof(double));
    }
    taut_film_complex_name(c->problem, side->patch, edge_names[side->edge], name);
    const taut_status status = taut_curve_new(name, basis, row, NULL, &curve, error);
    return status == TAUT_OK ? taut_construct_add_curve(model, curve, error) : status;
}

/* Corners that are held, each node once, by the first patch that has them. */
static void add_supports(const taut_film_complex *c, taut_record *details, unsigned char *seen)
{
    taut_record *supports = taut_record_add_list(details, "supports");

    for (int p = 0; p < c->problem->patch_count; p++) {
        for (int k = 0; k < 4; k++) {
            const int node = taut_film_complex_corner(c, p, k);
            char name[TAUT_FILM_NAME];
            if (c->holds[node].count == 3 && !seen[node]) {
                seen[node] = 1;
                taut_film_complex_name(c->problem, p, corner_names[k], name);
                taut_record_add_text(supports, NULL, name);
            }
        }
    }
}

static void add_rope(const taut_film_complex *c, int k, const taut_film_rest *rest,
                     taut_record *cables)
{
    const taut_film_rope *rope = &c->ropes[k];
    taut_record *cable = taut_record_add_object(cables, NULL);
    char name[TAUT_FILM_NAME];

    taut_film_rope_name(c, k, name);
    taut_record_add_text(cable, "edge", name);
    if (rope->along >= 0) {
        const taut_film_along *along = &c->problem->along[rope->along];
        taut_record *edges = taut_record_add_list(cable, "along");
        for (int i = 0; i < along->count; i++) {
            taut_film_complex_name(c->problem, along->sides[i].patch,
                                   edge_names[along->sides[i].edge], name);
            taut_record_add_text(edges, NULL, name);
        }
    }
    taut_record_add_number(cable, "force", rest->forces[k]);
    taut_record_add_number(cable, "length", rest->lengths[k]);
    if (rope->edge->law == TAUT_FILM_ELASTIC) {
        taut_record_add_number(cable, "unstressed", rope->edge->unstressed);
    }
}

/* Where it is one, which documents need not say; patches of threads have none. */
static void add_tension(const taut_film_problem *problem, taut_record *details)
{
    for (int p = 0; p < problem->patch_count; p++) {
        const taut_film_problem *patch = &problem->patches[p];
        if (taut_film_has_density(patch) ||
            taut_film_tension(patch) != taut_film_tension(&problem->patches[0])) {
            return;
        }
    }
    taut_record_add_number(details, "tension", taut_film_tension(&problem->patches[0]));
}

static const char doubt[] =
    "films end near this one, and finer spaces do not confirm it: the continuous problem may have "
    "none; take more points, bring rims together, or lower the pressure";

static taut_record *details_of(const taut_film_layout *l, const taut_film_rest *rest,
                               const double *changes, taut_arena *arena)
{
    const int updates = taut_film_complex_updates(l->complex.problem);
    const taut_film_complex *c = &l->complex;
    taut_record *details = taut_record_new();
    unsigned char *seen = taut_arena_take(arena, (size_t)c->nodes, 1);

    taut_record_add_number(details, "unknowns", rest->unknowns);
    taut_record_add_number(details, "iterations", rest->iterations);
    taut_record_add_text(details, "method", rest->method == TAUT_FILM_NORMAL ? "normal" : "full");
    taut_record_add_text(details, "solver", "fronts");
    taut_record_add_number(details, "residual", rest->residual);
    add_tension(c->problem, details);
    taut_record *cables = taut_record_add_list(details, "cables");
    for (int k = 0; k < c->rope_count; k++) {
        add_rope(c, k, rest, cables);
    }
    if (c->problem->cell_count > 0) {
        taut_record *cells = taut_record_add_list(details, "cells");
        for (int k = 0; k < c->problem->cell_count; k++) {
            char name[TAUT_FILM_NAME];
            taut_record *cell = taut_record_add_object(cells, NULL);
            taut_film_cell_name(c->problem, k, name);
            taut_record_add_text(cell, "name", name);
            taut_record_add_number(cell, "pressure", rest->pressures[k]);
        }
    }
    if (seen == NULL) {
        taut_record_free(details);
        return NULL;
    }
    add_supports(c, details, seen);
    if (rest->doubt != TAUT_FILM_CERTAIN) {
        taut_record_add_text(taut_record_add_list(details, "notes"), NULL, doubt);
    }
    taut_record *verdict = taut_record_add_object(details, "verdict");
    if (rest->doubt != TAUT_FILM_CERTAIN) {
        taut_record_add_null(verdict, "exists");
    } else {
        taut_record_add_text(verdict, "exists", "found");
    }
    if (rest->negative > 0) {
        taut_record_add_bool(verdict, "stable", 0);
    } else {
        taut_record_add_text(verdict, "stable", "found");
    }
    if (rest->rival > 0 && rest->rival < rest->area) {
        taut_record_add_bool(verdict, "least", 0);
    } else {
        taut_record_add_null(verdict, "least");
    }
    if (rest->rival > 0) {
        taut_record *rivals = taut_record_add_list(details, "rivals");
        if (rest->rival < rest->area) {
            taut_record *rival = taut_record_add_object(rivals, NULL);
            taut_record_add_text(rival, "kind", "discs");
            taut_record_add_number(rival, "area", rest->rival);
        }
    }
    if (updates > 0) {
        taut_record_add_numbers(details, "updates", updates, changes);
    }
    if (l->fitted > 0) {
        taut_record_add_number(details, "deviation", l->deviation);
    }
    return details;
}

typedef struct request {
    const taut_film_problem *problem;
    const taut_make_options *options;
    const taut_pace *pace;
} request;

static taut_status build(void *context, taut_arena *arena, taut_model *model, taut_error *error)
{
    const request *r = context;
    taut_film_layout layout;
    taut_film_rest rest;
    double changes[TAUT_FILM_UPDATES_MAX];
    taut_status status = taut_film_layout_new(r->problem, arena, &layout, error);

    if (status == TAUT_OK) {
        status = taut_film_balance_check(&layout, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_complex_flat_check(&layout, arena, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_rest_find(&layout, r->options, arena, &rest, error);
    }
    if (status == TAUT_OK && rest.doubt != TAUT_FILM_CERTAIN) {
        status = taut_film_complex_confirm(&layout, &rest, r->options, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_complex_update(&layout, &rest, r->options, changes, arena, error);
    }
    for (int p = 0; status == TAUT_OK && p < r->problem->patch_count; p++) {
        status = add_patch(&layout.complex, p, rest.points, arena, model, error);
    }
    if (status == TAUT_OK) {
        status = taut_film_images_add(r->problem, arena, model, error);
    }
    for (int k = 0; status == TAUT_OK && k < layout.complex.strand_count; k++) {
        status = add_strand(&layout.complex, k, rest.points, arena, model, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    taut_record *details = details_of(&layout, &rest, changes, arena);
    if (details != NULL && !r->problem->without_least) {
        status = taut_complex_witness_add(&layout, &rest, &r->options->monitor, details);
        status = status == TAUT_OK ? TAUT_OK : taut_plateau_witness_fail(status, error);
    }
    if (status == TAUT_OK && details != NULL && r->problem->refine > 0) {
        status = taut_film_complex_refine(&layout, &rest, r->options, details, error);
    }
    if (status == TAUT_OK || taut_pace_ends(r->pace, status, details)) {
        return taut_construct_set_details(model, details, error);
    }
    taut_record_free(details);
    return status;
}

taut_status taut_film_complex_make(const taut_film_problem *problem,
                                   const taut_make_options *options, taut_model **model,
                                   taut_error *error)
{
    static const taut_make_options none;
    taut_film_lone room;
    taut_pace pace;
    const taut_make_options own = taut_pace_options(&pace, options != NULL ? options : &none);
    request r = {.problem = taut_film_complex_of(problem, &room), .options = &own, .pace = &pace};
    const taut_error before = error != NULL ? *error : (taut_error){.status = TAUT_OK};
    taut_status status = check_problem(r.problem, error);

    if (status == TAUT_OK && model == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_film_make needs a place for the model");
    }
    if (status == TAUT_OK) {
        status = taut_pace_end(&pace, taut_construct_build(build, &r, model, error), error);
    }
    if (status != TAUT_OK) {
        taut_film_complex_where(r.problem, error);
    } else if (error != NULL) {
        *error = before; /* what ways say that led to no film, where another did */
    }
    return status;
}
