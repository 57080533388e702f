/* harmonic_extension.c -- the problem `harmonic-extension`: a surface and an edge
 * (docs/format.md). */
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "taut/harmonic.h"

static const char *const members[] = {"surface", "edge",  "width", "contact", "neighbour",
                                      "c",       "alpha", "beta",  NULL};

/* c, alpha and beta belong to the contact of tangent planes. */
static taut_status read_contact(const taut_json *document, double width,
                                taut_harmonic_extension_problem *data, taut_error *error)
{
    static const char *const contacts[] = {"c1", "g1", NULL};
    static const char *const own[] = {"c", "alpha", "beta", NULL};
    taut_extension_g1 g1 = {.width = width, .c = 1};
    double *const values[] = {&g1.c, &g1.alpha, &g1.beta};
    int is_g1 = 0;
    taut_status status = taut_member_word(document, "contact", contacts, &is_g1, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!is_g1) {
        data->given = TAUT_EXTENSION_C1;
        data->c1.width = width;
        return taut_member_refuse(document, own, "without \"contact\": \"g1\"", error);
    }
    for (int i = 0; i < 3 && status == TAUT_OK; i++) {
        status = taut_member_number(document, own[i], values[i], error);
    }
    data->given = TAUT_EXTENSION_G1;
    data->g1 = g1;
    return status;
}

/* A neighbour that is given says its width, and is the surface carried on. */
static taut_status take_neighbour(const taut_surface *neighbour, double width,
                                  taut_harmonic_extension_problem *data, taut_error *error)
{
    if (width > 0 || data->given != TAUT_EXTENSION_C1) {
        return taut_fail(error, TAUT_BAD_INPUT, "conflict", "/neighbour", taut_none, taut_none,
                         "found \"neighbour\" beside \"width\" or contact \"g1\": it has a width, "
                         "and must be the surface carried on");
    }
    data->given = TAUT_EXTENSION_MERGE;
    data->merge.neighbour = neighbour;
    return TAUT_OK;
}

static taut_status read_members(const taut_json *document, taut_arena *arena,
                                taut_harmonic_extension_problem *data, taut_error *error)
{
    const taut_surface *neighbour = NULL;
    double width = 0;
    taut_status status = taut_member_surface(document, "surface", arena, &data->surface, error);

    if (status == TAUT_OK && taut_json_member(document, "neighbour").value != NULL) {
        status = taut_member_surface(document, "neighbour", arena, &neighbour, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_edge(document, &data->edge, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_member_width(document, &width, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = read_contact(document, width, data, error);
    return status == TAUT_OK && neighbour != NULL ? take_neighbour(neighbour, width, data, error)
                                                  : status;
}

static taut_status extension_read(const taut_json *document, taut_problem *problem,
                                  taut_error *error)
{
    taut_harmonic_extension_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);

    problem->data = data;
    return data != NULL ? read_members(document, problem->arena, data, error)
                        : taut_fail_memory(error);
}

const taut_document_ops taut_document_harmonic_extension = {
    .members = members,
    .read = extension_read,
};
