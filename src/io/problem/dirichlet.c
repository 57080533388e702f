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
static const char *const through_members[] = {"u", "v", "point", NULL};

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

static taut_status read_through_item(const taut_json *at, void *into, taut_error *error)
{
    taut_through *const to = into;
    taut_reader in = taut_reader_of(at, through_members, error);

    to->u = to->v = NAN;
    taut_reader_numbers(&in, "point", 3, to->point);
    if (taut_reader_has(&in, "u") || taut_reader_has(&in, "v")) {
        taut_reader_number(&in, "u", &to->u);
        taut_reader_number(&in, "v", &to->v);
    }
    return in.status;
}

static void read_through(taut_reader *document, taut_arena *arena, taut_dirichlet_problem *data)
{
    size_t count = 0;

    if (!taut_reader_has(document, "through")) {
        return;
    }
    taut_reader_array(document, "through", 1, TAUT_THROUGH_MAX, "points to pass through", &count);
    if (document->status != TAUT_OK) {
        return;
    }
    taut_through *all = taut_arena_take(arena, count, sizeof *all);
    if (all == NULL) {
        document->status = taut_fail_memory(document->error);
        return;
    }
    taut_reader_items(document, "through", count, "points to pass through", read_through_item, all,
                      sizeof *all);
    data->through = all;
    data->through_count = document->status == TAUT_OK ? (int)count : 0;
}

static void dirichlet_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_dirichlet_problem *const data = into;

    taut_member_name(document, problem->arena, &data->name);
    taut_reader_optional(document, "aspect", read_aspect, data);
    taut_member_regular(document, &data->regular);
    read_through(document, problem->arena, data);
    taut_boundary_document_net(document, problem, data);
    taut_net_document_check_bases(document, data->u, data->v);
}

const taut_document_ops taut_document_dirichlet = {
    .members = members,
    .size = sizeof(taut_dirichlet_problem),
    .read = dirichlet_read,
};
