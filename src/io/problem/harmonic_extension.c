/* harmonic_extension.c -- the problem `harmonic-extension`: a surface and an edge
 * (docs/format.md). */
#include "core/fail.h"
#include "io/problem/document_ops.h"
#include "io/problem/member.h"
#include "taut/harmonic.h"

static const char *const members[] = {"surface", "edge",  "width", "contact", "neighbour",
                                      "c",       "alpha", "beta",  NULL};

/* c, alpha and beta belong to the contact of tangent planes. */
static void read_contact(taut_reader *document, double width, taut_harmonic_extension_problem *data)
{
    static const char *const contacts[] = {"c1", "g1", NULL};
    static const char *const own[] = {"c", "alpha", "beta", NULL};
    taut_extension_g1 g1 = {.width = width, .c = 1};
    int is_g1 = 0;

    taut_reader_optional_word(document, "contact", contacts, &is_g1);
    if (!is_g1) {
        data->given = TAUT_EXTENSION_C1;
        data->c1.width = width;
        taut_member_refuse(document, own, "without \"contact\": \"g1\"");
        return;
    }
    taut_reader_optional_number(document, "c", &g1.c);
    taut_reader_optional_number(document, "alpha", &g1.alpha);
    taut_reader_optional_number(document, "beta", &g1.beta);
    data->given = TAUT_EXTENSION_G1;
    data->g1 = g1;
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

static void extension_read(taut_reader *document, taut_problem *problem, void *into)
{
    taut_harmonic_extension_problem *const data = into;
    const taut_surface *neighbour = NULL;
    double width = 0;

    taut_member_surface(document, "surface", problem->arena, &data->surface);
    if (taut_reader_has(document, "neighbour")) {
        taut_member_surface(document, "neighbour", problem->arena, &neighbour);
    }
    taut_member_edge(document, &data->edge);
    taut_member_width(document, &width);
    read_contact(document, width, data);
    if (document->status == TAUT_OK && neighbour != NULL) {
        document->status = take_neighbour(neighbour, width, data, document->error);
    }
}

const taut_document_ops taut_document_harmonic_extension = {
    .members = members,
    .size = sizeof(taut_harmonic_extension_problem),
    .read = extension_read,
};
