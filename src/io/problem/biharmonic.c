/* biharmonic.c -- the problem `biharmonic`: four rows, or a surface and an edge
 * (docs/format.md). */
#include "taut/biharmonic.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "io/problem/net_document.h"

static const char *const members[] = {
    "name",   "u", "v", "points", "surface", "edge", "width", "contact", "allow_ill_conditioned",
    "insist", NULL};

static void read_rows(taut_reader *document, taut_arena *arena, taut_biharmonic_rows *rows)
{
    static const char *const strangers[] = {"edge",   "width", "contact", "allow_ill_conditioned",
                                            "insist", NULL};
    taut_net_document net = {NULL, NULL, NULL, NULL, NULL};

    taut_member_refuse(document, strangers, "without \"surface\"");
    taut_net_document_read(document, arena, &net);
    taut_member_name(document, arena, &rows->name);
    taut_member_check_bezier(document, "u", net.u);
    taut_member_check_bezier(document, "v", net.v);
    rows->u = net.u;
    rows->v = net.v;
    rows->points = net.points;
    rows->known = net.known;
}

static void read_neighbour(taut_reader *document, taut_arena *arena,
                           taut_biharmonic_neighbour *neighbour)
{
    static const char *const strangers[] = {"name", "u", "v", "points", NULL};
    static const char *const contacts[] = {"c1", "c2", NULL};
    int is_c2 = 0;

    taut_member_refuse(document, strangers, "beside \"surface\"");
    taut_member_surface(document, "surface", arena, &neighbour->surface);
    taut_member_edge(document, &neighbour->edge);
    taut_reader_optional_word(document, "contact", contacts, &is_c2);
    neighbour->contact = is_c2 ? 2 : 1;
    taut_member_width(document, &neighbour->width);
    taut_member_allow_ill_conditioned(document, &neighbour->allow_ill_conditioned);
}

static void biharmonic_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_biharmonic_problem *const data = into;

    if (taut_reader_has(document, "surface")) {
        data->given = TAUT_BIHARMONIC_NEIGHBOUR;
        read_neighbour(document, problem->arena, &data->neighbour);
    } else {
        data->given = TAUT_BIHARMONIC_ROWS;
        read_rows(document, problem->arena, &data->rows);
    }
}

const taut_document_ops taut_document_biharmonic = {
    .members = members,
    .size = sizeof(taut_biharmonic_problem),
    .read = biharmonic_read,
};
