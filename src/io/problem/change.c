/* change.c -- a problem with one value of its document replaced: the text is cut and joined, and read
 * as any other, so that nothing is accepted here that would be refused there. */
#include "core/fail.h"
#include "core/memory.h"
#include "io/json/slice.h"
#include "io/json/tree.h"
#include "io/problem/read.h"
#include "problem/problem.h"
#include "taut/read.h"

#include <string.h>

/* Text that grows within the room that was taken for it. */
typedef struct joined {
    char *text;
    size_t length;
} joined;

static void put(joined *j, const char *bytes, size_t length)
{
    memcpy(j->text + j->length, bytes, length);
    j->length += length;
}

/* The last word of the pointer as a key: ~0 is ~, ~1 is /, and what JSON has escapes for gets them. */
static void put_key(joined *j, const char *word, const char *end)
{
    put(j, "\"", 1);
    for (; word < end; word++) {
        char c = *word;
        if (c == '~' && word + 1 < end && (word[1] == '0' || word[1] == '1')) {
            c = *++word == '0' ? '~' : '/';
        }
        if (c == '"' || c == '\\') {
            put(j, "\\", 1);
        }
        put(j, &c, 1);
    }
    put(j, "\": ", 3);
}

/* The document with the value in its place, taut_alloc's. NULL: no memory. */
static char *join_text(const taut_problem *problem, const char *pointer,
                       const taut_json_slice *slice, const char *value, size_t length,
                       size_t *joined_length)
{
    const size_t key_room = 2 * (slice->key_end - slice->key) + 6; /* ", ", quotes, ": " */
    joined j = {taut_alloc(problem->length + length + key_room + 1, 1), 0};

    if (j.text == NULL) {
        return NULL;
    }
    put(&j, problem->text, slice->from);
    if (slice->place == TAUT_JSON_ABSENT) {
        put(&j, ", ", slice->is_empty ? 0 : 2);
        put_key(&j, pointer + slice->key, pointer + slice->key_end);
    }
    put(&j, value, length);
    put(&j, problem->text + slice->to, problem->length - slice->to);
    j.text[j.length] = '\0';
    *joined_length = j.length;
    return j.text;
}

/* The value by itself: so that what is wrong with it is told by its own line and column, and that no
 * piece of it is taken for something around it. */
static taut_status check_value(const char *value, size_t length, taut_error *error)
{
    taut_json_document *document = NULL;
    const taut_status status = taut_json_parse(value, length, "value", NULL, &document, error);
    taut_json_document_free(document);
    return status;
}

taut_status taut_problem_change(const taut_problem *problem, const char *pointer, const char *value,
                                size_t length, taut_problem **changed, taut_error *error)
{
    taut_json_slice slice;
    size_t joined_length = 0;

    if (problem == NULL || pointer == NULL || value == NULL || changed == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_change needs a problem, a pointer, a value and a place for "
                         "the other problem");
    }
    taut_status status = check_value(value, length, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (taut_json_slice_find(problem->text, problem->length, pointer, &slice) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    if (slice.place == TAUT_JSON_NOWHERE) {
        return taut_fail_expected(error, TAUT_BAD_INPUT, "missing", pointer, taut_none,
                                  "a place in the document",
                                  "found nothing there, expected a place in the document");
    }
    char *text = join_text(problem, pointer, &slice, value, length, &joined_length);
    if (text == NULL) {
        return taut_fail_memory(error);
    }
    status = taut_problem_read_from(text, joined_length, "the changed document", problem->folder,
                                    changed, error);
    taut_free(text);
    return status;
}
