/* harmonic_extension.c -- the problem `harmonic-extension`: a surface and an edge
 * (docs/format.md). */
#include "core/fail.h"
#include "io/model/surface.h"
#include "io/problem/document_ops.h"
#include "taut/harmonic.h"

#include <string.h>

static const char *const members[] = {"surface", "edge",  "width", "contact", "neighbour",
                                      "c",       "alpha", "beta",  NULL};

static void release_surface(void *surface)
{
    taut_surface_free(surface);
}

/* A number; `value` stays as it is where the member is missing. */
static taut_status read_number(const taut_json *document, const char *key, double *value,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    return at.value == NULL ? TAUT_OK : taut_json_number(&at, value, error);
}

/* c, alpha and beta belong to the contact of tangent planes. */
static taut_status read_contact(const taut_json *document, taut_harmonic_extension_problem *data,
                                taut_error *error)
{
    static const char *const contacts[] = {"c1", "g1", NULL};
    static const char *const own[] = {"c", "alpha", "beta"};
    double *const values[] = {&data->c, &data->alpha, &data->beta};
    const taut_json at = taut_json_member(document, "contact");
    int word = TAUT_CONTACT_C1;
    taut_status status = at.value == NULL ? TAUT_OK : taut_json_word(&at, contacts, &word, error);

    data->contact = (taut_contact)word;
    data->c = 1;
    for (int i = 0; i < 3 && status == TAUT_OK; i++) {
        const taut_json number = taut_json_member(document, own[i]);
        if (number.value != NULL && word == TAUT_CONTACT_C1) {
            return taut_json_fail(&number, error, "value", taut_none, taut_none,
                                  "found \"%s\" without \"contact\": \"g1\"", own[i]);
        }
        status = read_number(document, own[i], values[i], error);
    }
    return status;
}

static taut_status read_surface(const taut_json *document, const char *key, taut_arena *arena,
                                const taut_surface **surface, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    taut_surface *read = NULL;
    taut_status status = taut_surface_document_read(&at, &read, error);

    if (status == TAUT_OK && !taut_arena_keep(arena, read, release_surface)) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        *surface = read;
    }
    return status;
}

static taut_status extension_read(const taut_json *document, taut_problem *problem,
                                  taut_error *error)
{
    static const char *const edges[] = {"u0", "u1", "v0", "v1", NULL};
    taut_harmonic_extension_problem *data = taut_arena_take(problem->arena, 1, sizeof *data);
    const taut_json neighbour = taut_json_member(document, "neighbour");
    const taut_json edge = taut_json_member(document, "edge");
    const taut_json width = taut_json_member(document, "width");
    int word = 0;
    taut_status status =
        data != NULL ? read_surface(document, "surface", problem->arena, &data->surface, error)
                     : taut_fail_memory(error);

    if (status == TAUT_OK && neighbour.value != NULL) {
        status = read_surface(document, "neighbour", problem->arena, &data->neighbour, error);
    }
    if (status == TAUT_OK) {
        status = taut_json_word(&edge, edges, &word, error);
    }
    if (status == TAUT_OK) {
        data->edge = (taut_edge)word;
        status = read_number(document, "width", &data->width, error);
    }
    if (status == TAUT_OK && width.value != NULL && !(data->width > 0)) {
        status = taut_json_expected(&width, error, "a positive number");
    }
    if (status == TAUT_OK) {
        status = read_contact(document, data, error);
    }
    if (status == TAUT_OK) {
        problem->data = data;
    }
    return status;
}

const taut_document_ops taut_document_harmonic_extension = {
    .members = members,
    .read = extension_read,
};
