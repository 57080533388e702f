#include "io/problem/member.h"

#include "core/fail.h"
#include "geometry/keep.h"
#include "io/model/surface.h"

#include <string.h>

void taut_member_surface(taut_reader *document, const char *key, taut_arena *arena,
                         const taut_surface **surface)
{
    const taut_json at = taut_json_member(document->object, key);
    taut_surface *read = NULL;

    if (document->status == TAUT_OK) {
        document->status = taut_surface_document_read(&at, &read, document->error);
    }
    if (document->status == TAUT_OK && !taut_keep_surface(arena, read)) {
        document->status = taut_fail_memory(document->error);
    } else if (document->status == TAUT_OK) {
        *surface = read;
    }
}

void taut_member_curve(taut_reader *document, const char *key, taut_arena *arena,
                       const taut_curve **curve)
{
    const taut_json at = taut_json_member(document->object, key);
    taut_curve *read = NULL;

    if (document->status == TAUT_OK) {
        document->status = taut_curve_document_read(&at, &read, document->error);
    }
    if (document->status == TAUT_OK && !taut_keep_curve(arena, read)) {
        document->status = taut_fail_memory(document->error);
    } else if (document->status == TAUT_OK) {
        *curve = read;
    }
}

void taut_member_name(taut_reader *document, taut_arena *arena, const char **name)
{
    const char *text = "";

    if (document->status == TAUT_OK) {
        document->status = taut_name_document_read(document->object, &text, document->error);
    }
    if (document->status == TAUT_OK && text[0] != '\0') {
        *name = taut_arena_text(arena, text);
        document->status = *name != NULL ? TAUT_OK : taut_fail_memory(document->error);
    }
}

void taut_member_edge(taut_reader *document, taut_edge *edge)
{
    static const char *const edges[] = {"u0", "u1", "v0", "v1", NULL};
    int word = 0;

    taut_reader_word(document, "edge", edges, &word);
    *edge = (taut_edge)word;
}

void taut_member_width(taut_reader *document, double *width)
{
    const taut_json at = taut_json_member(document->object, "width");

    taut_reader_optional_number(document, "width", width);
    if (document->status == TAUT_OK && at.value != NULL && !(*width > 0)) {
        document->status = taut_json_expected(&at, document->error, "a positive number");
    }
}

void taut_member_check_bezier(taut_reader *document, const char *key, const taut_basis *basis)
{
    const taut_json at = taut_json_member(document->object, key);

    if (document->status == TAUT_OK && strcmp(taut_basis_type(basis), "bezier") != 0) {
        const taut_status status = taut_fail_expected(
            document->error, TAUT_BAD_INPUT, "not-bezier", "", taut_none, "\"bezier\"",
            "found a basis of type \"%s\"", taut_basis_type(basis));
        document->status = taut_json_within(&at, status, document->error);
    }
}

void taut_member_refuse(taut_reader *document, const char *const *strangers, const char *why)
{
    for (int i = 0; document->status == TAUT_OK && strangers[i] != NULL; i++) {
        const taut_json at = taut_json_member(document->object, strangers[i]);
        if (at.value != NULL) {
            document->status = taut_json_fail(&at, document->error, "conflict", taut_none,
                                              taut_none, "found \"%s\" %s", strangers[i], why);
        }
    }
}

void taut_member_allow_ill_conditioned(taut_reader *document, int *value)
{
    static const char now[] = "allow_ill_conditioned";
    const taut_json old = taut_json_member(document->object, "insist");

    if (document->status == TAUT_OK && old.value != NULL && taut_reader_has(document, now)) {
        document->status =
            taut_json_fail(&old, document->error, "conflict", taut_none, taut_none,
                           "found \"insist\" beside \"%s\", as it is called now", now);
    }
    taut_reader_flag(document, old.value != NULL ? "insist" : now, value);
}

void taut_member_regular(taut_reader *document, int *value)
{
    taut_reader_flag(document, "regular", value);
}
