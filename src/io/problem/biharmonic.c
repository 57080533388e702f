/* biharmonic.c -- the problem `biharmonic`: four rows, or a surface and an edge
 * (docs/format.md). */
#include "taut/biharmonic.h"
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

static const char *const members[] = {
    "name",   "u", "v", "points", "surface", "edge", "width", "contact", "allow_ill_conditioned",
    "insist", NULL};

static taut_status read_rows(const taut_json *document, taut_arena *arena,
                             taut_biharmonic_rows *rows, taut_error *error)
{
    static const char *const strangers[] = {"edge",   "width", "contact", "allow_ill_conditioned",
                                            "insist", NULL};
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};
    taut_status status = taut_member_refuse(document, strangers, "without \"surface\"", error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_net_document_read(document, arena, &net, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_name(document, arena, &rows->name, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_check_bezier(document, "u", net.u, error);
    if (status != TAUT_OK) {
        return status;
    }
    rows->u = net.u;
    rows->v = net.v;
    rows->points = net.points;
    rows->known = net.known;
    return taut_member_check_bezier(document, "v", net.v, error);
}

static taut_status read_neighbour(const taut_json *document, taut_arena *arena,
                                  taut_biharmonic_neighbour *neighbour, taut_error *error)
{
    static const char *const strangers[] = {"name", "u", "v", "points", NULL};
    static const char *const contacts[] = {"c1", "c2", NULL};
    int is_c2 = 0;
    taut_status status = taut_member_refuse(document, strangers, "beside \"surface\"", error);

    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_surface(document, "surface", arena, &neighbour->surface, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_edge(document, &neighbour->edge, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_word(document, "contact", contacts, &is_c2, error);
    if (status != TAUT_OK) {
        return status;
    }
    neighbour->contact = is_c2 ? 2 : 1;
    status = taut_member_width(document, &neighbour->width, error);
    if (status != TAUT_OK) {
        return status;
    }
    return taut_member_allow_ill_conditioned(document, &neighbour->allow_ill_conditioned, error);
}

static taut_status biharmonic_read(const taut_json *document, taut_problem *problem,
                                   taut_error *error)
{
    taut_biharmonic_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);

    if (data == NULL) {
        return taut_fail_memory(error);
    }
    problem->data = data;
    if (taut_json_member(document, "surface").value == NULL) {
        data->given = TAUT_BIHARMONIC_ROWS;
        return read_rows(document, problem->arena, &data->rows, error);
    }
    data->given = TAUT_BIHARMONIC_NEIGHBOUR;
    return read_neighbour(document, problem->arena, &data->neighbour, error);
}

const taut_document_ops taut_document_biharmonic = {
    .members = members,
    .read = biharmonic_read,
};
