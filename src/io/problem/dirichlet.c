/* dirichlet.c -- the problem `dirichlet`: a net with holes (docs/format.md). */
#include "taut/dirichlet.h"
#include "core/fail.h"
#include "io/problem/boundary_document.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

#include <math.h>
#include <string.h>

static const char *const members[] = {
    "name", "u", "v", "points", "weights", "aspect", "regular", "through", TAUT_BOUNDARY_MEMBERS,
    NULL};

/* A positive number, or "auto". */
static taut_status read_aspect(const taut_json *at, void *into, taut_error *error)
{
    taut_dirichlet_problem *const data = into;
    if (taut_json_kind_at(at) == TAUT_JSON_STRING && strcmp(taut_json_text_at(at), "auto") == 0) {
        data->aspect_auto = 1;
        return TAUT_OK;
    }
    if (taut_json_kind_at(at) != TAUT_JSON_NUMBER || !(taut_json_number_at(at) > 0)) {
        return taut_json_expected(at, error, "a positive number or \"auto\"");
    }
    return taut_json_number(at, &data->aspect, error);
}

static void dirichlet_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_dirichlet_problem *const data = into;

    taut_member_name(document, problem->arena, &data->name);
    taut_reader_optional(document, "aspect", read_aspect, data);
    taut_member_regular(document, &data->regular);
    taut_net_document_through(document, problem->arena, data);
    taut_boundary_document_net(document, problem, data);
    taut_net_document_check_bases(document, data->u, data->v);
}

const taut_document_ops taut_document_dirichlet = {
    .members = members,
    .size = sizeof(taut_dirichlet_problem),
    .read = dirichlet_read,
};
