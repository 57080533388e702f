/* in.c -- documents from files, and the places in them. */
#include "io/json/in.h"

#include "core/memory.h"
#include "io/file/in.h"

#include <string.h>

/* Of a text that is freed as soon as it is parsed, where it is `owned`. */
static taut_status read_root(const char *text, size_t length, const char *name, char *owned,
                             taut_pulse *pulse, taut_json_read *read, void *into, taut_error *error)
{
    taut_json_document *document = NULL;
    taut_status status = taut_json_parse(text, length, name, pulse, &document, error);
    taut_free(owned);
    if (status != TAUT_OK) {
        return status;
    }
    const taut_json root = {taut_json_document_root(document), NULL, NULL, 0, pulse};
    status = read(&root, into, error);
    taut_json_document_free(document);
    return status;
}

taut_status taut_json_read_text(const char *text, size_t length, const char *name,
                                taut_pulse *pulse, taut_json_read *read, void *into,
                                taut_error *error)
{
    return read_root(text, length, name, NULL, pulse, read, into, error);
}

taut_status taut_json_read_file(const char *path, taut_pulse *pulse, taut_json_read *read,
                                void *into, taut_error *error)
{
    const char *name = strcmp(path, "-") == 0 ? "standard input" : path;
    char *text = NULL;
    size_t length = 0;
    const taut_status status = taut_file_read(path, &text, &length, error);
    return status == TAUT_OK ? read_root(text, length, name, text, pulse, read, into, error)
                             : status;
}

taut_json taut_json_item(const taut_json *array, size_t i)
{
    const int is_there = taut_json_kind_at(array) == TAUT_JSON_ARRAY && i < array->value->count;
    return (taut_json){is_there ? array->value->as.items + i : NULL, array, NULL, i, array->pulse};
}

taut_json taut_json_member(const taut_json *object, const char *key)
{
    return (taut_json){taut_json_find(object->value, key), object, key, 0, object->pulse};
}

taut_json_kind taut_json_kind_at(const taut_json *at)
{
    return at->value != NULL ? (taut_json_kind)at->value->kind : TAUT_JSON_MISSING;
}

double taut_json_number_at(const taut_json *at)
{
    return taut_json_kind_at(at) == TAUT_JSON_NUMBER ? at->value->as.number : 0;
}

size_t taut_json_count_at(const taut_json *at)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    return kind == TAUT_JSON_ARRAY || kind == TAUT_JSON_OBJECT ? at->value->count : 0;
}

const char *taut_json_text_at(const taut_json *at)
{
    return taut_json_kind_at(at) == TAUT_JSON_STRING ? at->value->as.string : NULL;
}
