#include "io/problem/boundary_document.h"

#include "core/fail.h"
#include "core/memory.h"
#include "taut/limits.h"
#include "taut/read.h"

#include <stdio.h>
#include <string.h>

enum { PATH_ROOM = 4096, HALVINGS_MAX = 16 };

static const double closed = 1e-6; /* the widest gap at a corner, of the size */

int taut_boundary_document_is(const taut_json *document)
{
    return taut_json_find(document->value, "boundary") != NULL;
}

/* The file's path: beside the document, unless it begins at the root. */
static taut_status find_path(const taut_json *at, const taut_problem *problem, char path[PATH_ROOM],
                             taut_error *error)
{
    const char *name = NULL;
    taut_status status = taut_json_text(at, &name, error);
    if (status == TAUT_OK && (name[0] == '\0' || strcmp(name, "-") == 0)) {
        status = taut_json_expected(at, error, "the name of a file");
    }
    if (status == TAUT_OK && snprintf(path, PATH_ROOM, "%s%s",
                                      name[0] == '/' ? "" : problem->folder, name) >= PATH_ROOM) {
        status = taut_json_expected(at, error, "a shorter name");
    }
    return status;
}

/* What is wrong with the file, told at the member that names it. */
static taut_status blame_file(const taut_json *at, const taut_error *found, taut_status status,
                              taut_error *error)
{
    char where[sizeof found->where];
    snprintf(where, sizeof where, "%s", found->where);
    taut_json_fail(at, error, "value", found->found, found->limit, "%s%s%s", where,
                   where[0] != '\0' ? ": " : "", found->message);
    if (error != NULL) {
        error->status = status;
    }
    return status;
}

taut_status taut_boundary_document_sides(const taut_json *document, const taut_problem *problem,
                                         taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    const taut_json at = taut_json_member(document, "boundary");
    const taut_curve *curves[TAUT_SIDES];
    taut_error found = {.status = TAUT_OK};
    taut_model *model = NULL;
    char path[PATH_ROOM];
    taut_status status = find_path(&at, problem, path, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_model_read(path, &model, &found);
    if (status != TAUT_OK) {
        return blame_file(&at, &found, status, error);
    }
    if (taut_model_curve_count(model) != TAUT_SIDES) {
        status = taut_json_fail(&at, error, "value", taut_model_curve_count(model), TAUT_SIDES,
                                "found %d curves in that file, expected %d",
                                taut_model_curve_count(model), TAUT_SIDES);
    }
    for (int i = 0; status == TAUT_OK && i < TAUT_SIDES; i++) {
        curves[i] = taut_model_curve(model, i);
    }
    if (status == TAUT_OK) {
        status = taut_boundary_order(curves, closed, sides, &found);
        status = status != TAUT_OK ? blame_file(&at, &found, status, error) : TAUT_OK;
    }
    taut_model_free(model);
    return status;
}

/* Two whole numbers, or 0 and 0 where the member is missing. */
static taut_status read_pair(const taut_json *document, const char *key, int most, int pair[2],
                             taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    size_t count = 0;
    taut_status status = TAUT_OK;
    pair[0] = pair[1] = 0;
    if (at.value == NULL) {
        return TAUT_OK;
    }
    status = taut_json_array(&at, 2, 2, "whole numbers, along u and v", &count, error);
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json item = taut_json_item(&at, i);
        status = taut_json_integer(&item, 0, most, &pair[i], error);
    }
    return status;
}

/* The file says what these members would. */
static taut_status check_alone(const taut_json *document, const char *const *others,
                               taut_error *error)
{
    for (; *others != NULL; others++) {
        const taut_json at = taut_json_member(document, *others);
        if (at.value != NULL) {
            return taut_json_fail(&at, error, "value", taut_none, taut_none,
                                  "found \"%s\" beside \"boundary\", which says it all", *others);
        }
    }
    return TAUT_OK;
}

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

static const taut_basis *keep_basis(const taut_curve *side, taut_arena *arena)
{
    taut_basis *copy = NULL;
    if (taut_basis_copy(taut_curve_t(side), &copy) != TAUT_OK ||
        !taut_arena_keep(arena, copy, release_basis)) {
        return NULL;
    }
    return copy;
}

static taut_status fill_net(taut_curve *const fitted[TAUT_SIDES], const taut_json *at,
                            taut_arena *arena, taut_net_document *net, taut_error *error)
{
    const size_t nu = (size_t)taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_V0]));
    const size_t nv = (size_t)taut_basis_count(taut_curve_t(fitted[TAUT_SIDE_U0]));
    const int is_rational = taut_boundary_is_rational(fitted);
    taut_net_document made = {NULL, NULL, NULL, NULL, NULL};

    if ((double)nu * (double)nv > TAUT_POINTS_MAX) {
        return taut_json_fail(at, error, "value", (double)nu * (double)nv, TAUT_POINTS_MAX,
                              "a net of %zu x %zu points, expected at most %d points", nu, nv,
                              TAUT_POINTS_MAX);
    }
    made.u = keep_basis(fitted[TAUT_SIDE_V0], arena);
    made.v = keep_basis(fitted[TAUT_SIDE_U0], arena);
    made.points = taut_arena_take(arena, 3 * nu * nv, sizeof(double));
    made.known = taut_arena_take(arena, nu * nv, 1);
    made.weights = is_rational ? taut_arena_take(arena, nu * nv, sizeof(double)) : NULL;
    if (made.u == NULL || made.v == NULL || made.points == NULL || made.known == NULL ||
        (is_rational && made.weights == NULL)) {
        return taut_fail_memory(error);
    }
    taut_boundary_net(fitted, made.points, made.known, made.weights);
    *net = made;
    return TAUT_OK;
}

taut_status taut_boundary_document_read(const taut_json *document, taut_problem *problem,
                                        taut_net_document *net, taut_error *error)
{
    static const char *const others[] = {"u", "v", "points", "weights", NULL};
    const taut_json at = taut_json_member(document, "boundary");
    taut_curve *sides[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_curve *fitted[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_error found = {.status = TAUT_OK};
    int degree[2], halvings[2];
    taut_status status = check_alone(document, others, error);

    if (status == TAUT_OK) {
        status = read_pair(document, "degree", TAUT_DEGREE_MAX, degree, error);
    }
    if (status == TAUT_OK) {
        status = read_pair(document, "refine", HALVINGS_MAX, halvings, error);
    }
    if (status == TAUT_OK) {
        status = taut_boundary_document_sides(document, problem, sides, error);
    }
    if (status == TAUT_OK) {
        status = taut_boundary_fit(sides, degree, halvings, fitted, &found);
        status = status != TAUT_OK ? blame_file(&at, &found, status, error) : TAUT_OK;
    }
    if (status == TAUT_OK) {
        status = fill_net(fitted, &at, problem->arena, net, error);
    }
    taut_boundary_free(sides);
    taut_boundary_free(fitted);
    return status;
}

static void release_curve(void *curve)
{
    taut_curve_free(curve);
}

taut_status taut_boundary_document_bezier(const taut_json *document, taut_problem *problem,
                                          const char *const *others, int agree,
                                          const taut_curve *sides[TAUT_SIDES], taut_error *error)
{
    const taut_json at = taut_json_member(document, "boundary");
    taut_curve *loose[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_curve *made[TAUT_SIDES] = {NULL, NULL, NULL, NULL};
    taut_error found = {.status = TAUT_OK};
    taut_status status = check_alone(document, others, error);

    if (status == TAUT_OK) {
        status = taut_boundary_document_sides(document, problem, loose, error);
    }
    if (status == TAUT_OK) {
        status = taut_boundary_bezier(loose, made, &found);
        if (status == TAUT_OK && agree) {
            status = taut_boundary_agree(made, &found);
        }
        status = status != TAUT_OK ? blame_file(&at, &found, status, error) : TAUT_OK;
    }
    for (int s = 0; status == TAUT_OK && s < TAUT_SIDES; s++) {
        if (taut_arena_keep(problem->arena, made[s], release_curve)) {
            sides[s] = made[s];
        } else {
            status = taut_fail_memory(error);
        }
        made[s] = NULL;
    }
    taut_boundary_free(loose);
    taut_boundary_free(made);
    return status;
}
