/* plateau.c -- the problem `plateau`: a net with holes, and how to go about it
 * (docs/format.md). */
#include "taut/plateau.h"
#include "core/fail.h"
#include "io/model/basis.h"
#include "io/model/surface.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/net_document.h"

#include <float.h>
#include <limits.h>
#include <string.h>

static const char *const members[] = {"name",           "u",      "v",      "points",
                                      "weights",        "curves", "start",  "tolerance",
                                      "max_iterations", "method", "refine", "tolerance_area",
                                      "boundary",       "degree", NULL};
static const char *const edge_members[] = {"u0", "u1", "v0", "v1", NULL};

static taut_status check_basis(const taut_json *document, const char *key, const taut_basis *basis,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    if (strcmp(taut_basis_type(basis), "ce-bezier") == 0) {
        return taut_json_fail(&at, error, "basis", taut_none, taut_none,
                              "found a basis of type \"ce-bezier\", expected any other: it is a "
                              "basis of pipe axes, not of surfaces that are solved for");
    }
    return TAUT_OK;
}

/* A number from `least` on and below 1, where the member is there. */
static taut_status read_share(const taut_json *at, double least, const char *expected,
                              double *share, taut_error *error)
{
    taut_status status = TAUT_OK;

    if (at->value == NULL) {
        return TAUT_OK;
    }
    status = taut_json_number(at, share, error);
    return status == TAUT_OK && !(*share >= least && *share < 1)
               ? taut_json_expected(at, error, expected)
               : status;
}

static taut_status read_spaces(const taut_json *document, taut_plateau_problem *data,
                               taut_error *error)
{
    const taut_json refine = taut_json_member(document, "refine");
    const taut_json tolerance = taut_json_member(document, "tolerance_area");

    if (refine.value != NULL && !taut_boundary_document_is(document)) { /* else it is a pair */
        const taut_status status =
            taut_json_integer(&refine, 0, TAUT_PLATEAU_REFINE_MAX, &data->refine, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    return read_share(&tolerance, TAUT_PLATEAU_AREA_MIN, "a number from 1e-11 on and below 1",
                      &data->tolerance_area, error);
}

static taut_status read_options(const taut_json *document, taut_plateau_problem *data,
                                taut_error *error)
{
    static const char *const methods[] = {"full", "normal", NULL};
    const taut_json tolerance = taut_json_member(document, "tolerance");
    const taut_json iterations = taut_json_member(document, "max_iterations");
    const taut_json method = taut_json_member(document, "method");
    int word = 0;
    taut_status status = read_share(&tolerance, DBL_TRUE_MIN, "a number above 0 and below 1",
                                    &data->tolerance, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (iterations.value != NULL) {
        status = taut_json_integer(&iterations, 1, INT_MAX, &data->max_iterations, error);
        if (status != TAUT_OK) {
            return status;
        }
    }
    if (method.value != NULL) {
        status = taut_json_word(&method, methods, &word, error);
        if (status != TAUT_OK) {
            return status;
        }
        data->method = word == 1 ? TAUT_PLATEAU_NORMAL : TAUT_PLATEAU_FULL;
    }
    return read_spaces(document, data, error);
}

/* The points of `start`, which must be a surface of the same net. */
static taut_status read_start(const taut_json *document, taut_arena *arena,
                              taut_plateau_problem *data, taut_error *error)
{
    const taut_json at = taut_json_member(document, "start");
    const size_t count =
        (size_t)taut_basis_count(data->net.u) * (size_t)taut_basis_count(data->net.v);
    taut_surface *surface = NULL;
    taut_status status = TAUT_OK;

    if (at.value == NULL) {
        return TAUT_OK;
    }
    status = taut_surface_document_read(&at, &surface, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_basis_equal(taut_surface_u(surface), data->net.u) ||
        !taut_basis_equal(taut_surface_v(surface), data->net.v)) {
        status = taut_json_fail(&at, error, "conflict", taut_none, taut_none,
                                "found a surface of %d by %d points on other bases, expected the "
                                "bases of the problem, %d by %d points",
                                taut_basis_count(taut_surface_u(surface)),
                                taut_basis_count(taut_surface_v(surface)),
                                taut_basis_count(data->net.u), taut_basis_count(data->net.v));
    } else {
        data->start =
            taut_arena_copy(arena, taut_surface_points(surface), count, 3 * sizeof(double));
        status = data->start != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    taut_surface_free(surface);
    return status;
}

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

static void release_curve(void *curve)
{
    taut_curve_free(curve);
}

static taut_status read_edge(const taut_json *curves, int e, taut_arena *arena,
                             taut_plateau_problem *data, taut_error *error)
{
    const taut_json at = taut_json_member(curves, edge_members[e]);
    taut_curve *made = NULL;
    const taut_status status = taut_curve_document_read(&at, &made, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_arena_keep(arena, made, release_curve)) {
        return taut_fail_memory(error);
    }
    data->curves[e] = made;
    return TAUT_OK;
}

static taut_status read_basis(const taut_json *document, const char *key, taut_arena *arena,
                              const taut_basis **basis, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    taut_basis *made = NULL;
    const taut_status status = taut_basis_document_read(&at, 0, &made, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_arena_keep(arena, made, release_basis)) {
        return taut_fail_memory(error);
    }
    *basis = made;
    return TAUT_OK;
}

/* Four curves, in place of points; the bases say how finely they are fitted. */
static taut_status read_curves(const taut_json *document, taut_arena *arena,
                               taut_plateau_problem *data, taut_error *error)
{
    static const char *const apart[] = {"points", "weights", "start"};
    const taut_json at = taut_json_member(document, "curves");
    taut_status status = taut_json_object(&at, edge_members, error);

    for (int k = 0; status == TAUT_OK && k < 3; k++) {
        const taut_json other = taut_json_member(document, apart[k]);
        if (other.value != NULL) {
            return taut_json_fail(&other, error, "conflict", taut_none, taut_none,
                                  "found \"%s\" beside \"curves\": curves that are given are the "
                                  "boundary",
                                  apart[k]);
        }
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(document, "u", arena, &data->net.u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_basis(document, "v", arena, &data->net.v, error);
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        status = read_edge(&at, e, arena, data, error);
    }
    return status;
}

/* Curves, a net or a boundary. */
static taut_status read_net(const taut_json *document, taut_problem *problem,
                            taut_plateau_problem *data, taut_error *error)
{
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    taut_status status = TAUT_OK;

    if (taut_json_member(document, "curves").value != NULL) {
        return read_curves(document, problem->arena, data, error);
    }
    status = taut_boundary_document_is(document)
                 ? taut_boundary_document_read(document, problem, &net, error)
                 : taut_net_document_read(document, problem->arena, &net, error);
    if (status != TAUT_OK) {
        return status;
    }
    data->net.u = net.u;
    data->net.v = net.v;
    data->net.points = net.points;
    data->net.known = net.known;
    data->net.weights = net.weights;
    return TAUT_OK;
}

static taut_status read_problem(const taut_json *document, taut_problem *problem,
                                taut_plateau_problem *data, taut_error *error)
{
    const char *name = "";
    taut_status status = read_options(document, data, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_name_document_read(document, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_net(document, problem, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_basis(document, "u", data->net.u, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_basis(document, "v", data->net.v, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (name[0] != '\0') {
        data->net.name = taut_arena_text(problem->arena, name);
        if (data->net.name == NULL) {
            return taut_fail_memory(error);
        }
    }
    return read_start(document, problem->arena, data, error);
}

static taut_status plateau_read(const taut_json *document, taut_problem *problem, taut_error *error)
{
    taut_plateau_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    taut_status status = TAUT_OK;

    if (data == NULL) {
        return taut_fail_memory(error);
    }
    status = read_problem(document, problem, data, error);
    if (status == TAUT_OK) {
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_plateau = {
    .members = members,
    .read = plateau_read,
};
