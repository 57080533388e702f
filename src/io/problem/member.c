#include "io/problem/member.h"

#include "core/fail.h"
#include "io/model/surface.h"

#include <string.h>

taut_status taut_member_number(const taut_json *document, const char *key, double *value,
                               taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    return at.value == NULL ? TAUT_OK : taut_json_number(&at, value, error);
}

taut_status taut_member_word(const taut_json *document, const char *key, const char *const *words,
                             int *value, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    return at.value == NULL ? TAUT_OK : taut_json_word(&at, words, value, error);
}

static void release_surface(void *surface)
{
    taut_surface_free(surface);
}

taut_status taut_member_surface(const taut_json *document, const char *key, taut_arena *arena,
                                const taut_surface **surface, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    taut_surface *read = NULL;
    const taut_status status = taut_surface_document_read(&at, &read, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (!taut_arena_keep(arena, read, release_surface)) {
        return taut_fail_memory(error);
    }
    *surface = read;
    return TAUT_OK;
}

static void release_basis(void *basis)
{
    taut_basis_free(basis);
}

taut_status taut_member_keep_basis(taut_arena *arena, taut_basis *made, const taut_basis **basis,
                                   taut_error *error)
{
    if (!taut_arena_keep(arena, made, release_basis)) {
        return taut_fail_memory(error);
    }
    *basis = made;
    return TAUT_OK;
}

taut_status taut_member_name(const taut_json *document, taut_arena *arena, const char **name,
                             taut_error *error)
{
    const char *text = "";
    const taut_status status = taut_name_document_read(document, &text, error);

    if (status != TAUT_OK || text[0] == '\0') {
        return status;
    }
    *name = taut_arena_text(arena, text);
    return *name != NULL ? TAUT_OK : taut_fail_memory(error);
}

taut_status taut_member_edge(const taut_json *document, taut_edge *edge, taut_error *error)
{
    static const char *const edges[] = {"u0", "u1", "v0", "v1", NULL};
    const taut_json at = taut_json_member(document, "edge");
    int word = 0;
    const taut_status status = taut_json_word(&at, edges, &word, error);

    if (status == TAUT_OK) {
        *edge = (taut_edge)word;
    }
    return status;
}

taut_status taut_member_width(const taut_json *document, double *width, taut_error *error)
{
    const taut_json at = taut_json_member(document, "width");
    const taut_status status = taut_member_number(document, "width", width, error);

    if (status == TAUT_OK && at.value != NULL && !(*width > 0)) {
        return taut_json_expected(&at, error, "a positive number");
    }
    return status;
}

taut_status taut_member_check_bezier(const taut_json *document, const char *key,
                                     const taut_basis *basis, taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    if (strcmp(taut_basis_type(basis), "bezier") != 0) {
        const taut_status status =
            taut_fail_expected(error, TAUT_BAD_INPUT, "not-bezier", "", taut_none, "\"bezier\"",
                               "found a basis of type \"%s\"", taut_basis_type(basis));
        return taut_json_within(&at, status, error);
    }
    return TAUT_OK;
}

taut_status taut_member_refuse(const taut_json *document, const char *const *strangers,
                               const char *why, taut_error *error)
{
    for (int i = 0; strangers[i] != NULL; i++) {
        const taut_json at = taut_json_member(document, strangers[i]);
        if (at.value != NULL) {
            return taut_json_fail(&at, error, "conflict", taut_none, taut_none, "found \"%s\" %s",
                                  strangers[i], why);
        }
    }
    return TAUT_OK;
}

taut_status taut_member_allow_ill_conditioned(const taut_json *document, int *value,
                                              taut_error *error)
{
    static const char now[] = "allow_ill_conditioned";
    const taut_json old = taut_json_member(document, "insist");

    if (old.value == NULL) {
        return taut_json_flag(document, now, value, error);
    }
    if (taut_json_member(document, now).value != NULL) {
        return taut_json_fail(&old, error, "conflict", taut_none, taut_none,
                              "found \"insist\" beside \"%s\", as it is called now", now);
    }
    return taut_json_flag(document, "insist", value, error);
}
