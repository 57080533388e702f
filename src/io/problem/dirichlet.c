/* dirichlet.c -- the problem `dirichlet`: a net with holes (docs/format.md). */
#include "taut/dirichlet.h"
#include "core/fail.h"
#include "io/model/surface.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/net_document.h"

#include <string.h>

static const char *const members[] = {
    "name", "u", "v", "points", "weights", "aspect", TAUT_BOUNDARY_MEMBERS, NULL};

/* A ce-bezier basis is one for curves, the axes of pipes. */
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

/* A positive number, or "auto". */
static taut_status read_aspect(const taut_json *document, taut_dirichlet_problem *data,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, "aspect");
    if (at.value == NULL) {
        return TAUT_OK;
    }
    if (taut_json_kind_at(&at) == TAUT_JSON_STRING && strcmp(taut_json_text_at(&at), "auto") == 0) {
        data->aspect_auto = 1;
        return TAUT_OK;
    }
    if (taut_json_kind_at(&at) != TAUT_JSON_NUMBER || !(taut_json_number_at(&at) > 0)) {
        return taut_json_expected(&at, error, "a positive number or \"auto\"");
    }
    return taut_json_number(&at, &data->aspect, error);
}

static taut_status read_net(const taut_json *document, taut_problem *problem,
                            taut_dirichlet_problem *data, taut_error *error)
{
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    taut_status status = taut_boundary_document_is(document)
                             ? taut_boundary_document_read(document, problem, &net, error)
                             : taut_net_document_read(document, problem->arena, &net, error);

    if (status != TAUT_OK) {
        return status;
    }
    data->u = net.u;
    data->v = net.v;
    data->points = net.points;
    data->known = net.known;
    data->weights = net.weights;
    status = check_basis(document, "u", net.u, error);
    return status == TAUT_OK ? check_basis(document, "v", net.v, error) : status;
}

static taut_status dirichlet_read(const taut_json *document, taut_problem *problem,
                                  taut_error *error)
{
    taut_dirichlet_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    const char *name = "";
    taut_status status = TAUT_OK;

    if (data == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_name_document_read(document, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_aspect(document, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_net(document, problem, data, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (name[0] != '\0') {
        data->name = taut_arena_text(problem->arena, name);
    }
    problem->data = data;
    return taut_arena_status(problem->arena) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

const taut_document_ops taut_document_dirichlet = {
    .members = members,
    .read = dirichlet_read,
};
