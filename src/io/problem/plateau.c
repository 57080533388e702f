/* plateau.c -- the problem `plateau`: a net with holes, and how to go about it
 * (docs/format.md). */
#include "taut/plateau.h"
#include "core/fail.h"
#include "io/model/basis.h"
#include "io/model/surface.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/net_document.h"

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
        return taut_json_fail(&at, error, "value", taut_none, taut_none,
                              "found a basis of type \"ce-bezier\", expected any other: it is a "
                              "basis of pipe axes, not of surfaces that are solved for");
    }
    return TAUT_OK;
}

static taut_status read_spaces(const taut_json *document, taut_plateau_problem *data,
                               taut_error *error)
{
    const taut_json refine = taut_json_member(document, "refine");
    const taut_json tolerance = taut_json_member(document, "tolerance_area");
    taut_status status = TAUT_OK;

    if (refine.value != NULL && !taut_boundary_document_is(document)) { /* else it is a pair */
        status = taut_json_integer(&refine, 0, TAUT_PLATEAU_REFINE_MAX, &data->refine, error);
    }
    if (status == TAUT_OK && tolerance.value != NULL) {
        status = taut_json_number(&tolerance, &data->tolerance_area, error);
        if (status == TAUT_OK &&
            !(data->tolerance_area >= TAUT_PLATEAU_AREA_MIN && data->tolerance_area < 1)) {
            status = taut_json_expected(&tolerance, error, "a number from 1e-11 on and below 1");
        }
    }
    return status;
}

static taut_status read_options(const taut_json *document, taut_plateau_problem *data,
                                taut_error *error)
{
    static const char *const methods[] = {"full", "normal", NULL};
    const taut_json tolerance = taut_json_member(document, "tolerance");
    const taut_json iterations = taut_json_member(document, "max_iterations");
    const taut_json method = taut_json_member(document, "method");
    int word = 0;
    taut_status status = TAUT_OK;

    if (tolerance.value != NULL) {
        status = taut_json_number(&tolerance, &data->tolerance, error);
        if (status == TAUT_OK && !(data->tolerance > 0 && data->tolerance < 1)) {
            status = taut_json_expected(&tolerance, error, "a number above 0 and below 1");
        }
    }
    if (status == TAUT_OK && iterations.value != NULL) {
        status = taut_json_integer(&iterations, 1, INT_MAX, &data->max_iterations, error);
    }
    if (status == TAUT_OK && method.value != NULL) {
        status = taut_json_word(&method, methods, &word, error);
        data->method = word == 1 ? TAUT_PLATEAU_NORMAL : TAUT_PLATEAU_FULL;
    }
    return status == TAUT_OK ? read_spaces(document, data, error) : status;
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
        status = taut_json_fail(&at, error, "value", taut_none, taut_none,
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

/* Four curves, in place of points; the bases say how finely they are fitted. */
static taut_status read_curves(const taut_json *document, taut_arena *arena,
                               taut_plateau_problem *data, taut_error *error)
{
    static const char *const apart[] = {"points", "weights", "start"};
    const taut_json at = taut_json_member(document, "curves");
    taut_basis *bases[2] = {NULL, NULL};
    taut_status status = taut_json_object(&at, edge_members, error);

    for (int k = 0; status == TAUT_OK && k < 3; k++) {
        const taut_json other = taut_json_member(document, apart[k]);
        if (other.value != NULL) {
            status = taut_json_fail(&other, error, "value", taut_none, taut_none,
                                    "found \"%s\" beside \"curves\": curves that are given are the "
                                    "boundary",
                                    apart[k]);
        }
    }
    for (int k = 0; status == TAUT_OK && k < 2; k++) {
        const taut_json basis = taut_json_member(document, k == 0 ? "u" : "v");
        status = taut_basis_document_read(&basis, 0, &bases[k], error);
        if (status == TAUT_OK && !taut_arena_keep(arena, bases[k], release_basis)) {
            status = taut_fail_memory(error);
        }
    }
    data->net.u = bases[0];
    data->net.v = bases[1];
    for (int e = 0; status == TAUT_OK && e < 4; e++) {
        const taut_json curve = taut_json_member(&at, edge_members[e]);
        taut_curve *made = NULL;
        status = taut_curve_document_read(&curve, &made, error);
        if (status == TAUT_OK && !taut_arena_keep(arena, made, release_curve)) {
            status = taut_fail_memory(error);
        }
        data->curves[e] = made;
    }
    return status;
}

static taut_status read_net(const taut_json *document, taut_problem *problem,
                            taut_plateau_problem *data, taut_error *error)
{
    const taut_json curves = taut_json_member(document, "curves");
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    const char *name = "";
    taut_status status = taut_name_document_read(document, &name, error);

    if (status == TAUT_OK && curves.value != NULL) {
        status = read_curves(document, problem->arena, data, error);
        net.u = data->net.u;
        net.v = data->net.v;
    } else if (status == TAUT_OK) {
        status = taut_boundary_document_is(document)
                     ? taut_boundary_document_read(document, problem, &net, error)
                     : taut_net_document_read(document, problem->arena, &net, error);
    }
    if (status == TAUT_OK) {
        status = check_basis(document, "u", net.u, error);
    }
    if (status == TAUT_OK) {
        status = check_basis(document, "v", net.v, error);
    }
    if (status == TAUT_OK && name[0] != '\0') {
        data->net.name = taut_arena_text(problem->arena, name);
        status = data->net.name != NULL ? TAUT_OK : taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        data->net.u = net.u;
        data->net.v = net.v;
        data->net.points = net.points;
        data->net.known = net.known;
        data->net.weights = net.weights;
    }
    return status;
}

static taut_status plateau_read(const taut_json *document, taut_problem *problem, taut_error *error)
{
    taut_plateau_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    taut_status status = data != NULL ? TAUT_OK : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = read_options(document, data, error);
    }
    if (status == TAUT_OK) {
        status = read_net(document, problem, data, error);
    }
    if (status == TAUT_OK) {
        status = read_start(document, problem->arena, data, error);
    }
    if (status == TAUT_OK) {
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_plateau = {
    .members = members,
    .read = plateau_read,
};
