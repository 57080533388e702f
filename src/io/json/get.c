/* get.c -- typed getters. */
#include "core/fail.h"
#include "io/json/in.h"
#include "taut/read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* "\"mm\", \"m\" or \"cm\""; 0 where not all find room. */
static int list_words(const char *const *words, char *text, size_t size)
{
    size_t n = 0;
    text[0] = '\0';
    for (int i = 0; words[i] != NULL; i++) {
        const char *between = i == 0 ? "" : words[i + 1] == NULL ? " or " : ", ";
        const size_t more = strlen(between) + strlen(words[i]) + 2;
        if (n + more + 1 > size) {
            return 0;
        }
        n += (size_t)sprintf(text + n, "%s\"%s\"", between, words[i]);
    }
    return 1;
}

/* Refuses a member that the list does not have, and names the one it may have been meant for. */
static taut_status unknown_member(const taut_json *object, const char *key,
                                  const char *const *members, taut_error *error)
{
    const taut_json at = taut_json_member(object, key);
    int edits = 0;
    const char *near = taut_nearest_word(key, members, &edits);
    char list[512];
    /* no slip of a finger: what there is helps more */
    const int is_far = edits > (int)strnlen(key, 64) / 3 && list_words(members, list, sizeof list);
    const taut_status status =
        is_far ? taut_json_fail(&at, error, "unknown-member", taut_none, taut_none,
                                "there is no such member here, expected %s", list)
               : taut_json_fail(&at, error, "unknown-member", taut_none, taut_none,
                                "there is no such member here; the nearest one known is \"%s\"",
                                near != NULL ? near : "");
    if (error != NULL && near != NULL) {
        snprintf(error->expected, sizeof error->expected, "\"%s\"", near);
    }
    return status;
}

static int is_listed(const char *key, const char *const *members)
{
    while (*members != NULL && strcmp(*members, key) != 0) {
        members++;
    }
    return *members != NULL;
}

taut_status taut_json_object(const taut_json *at, const char *const *members, taut_error *error)
{
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        char list[512]; /* of few members which */
        const int are_few = list_words(members, list, sizeof list);
        return taut_json_refuse(at, error, "type", "an object%s%s", are_few ? " with " : "",
                                are_few ? list : "");
    }
    for (size_t i = 0; i < at->value->count; i++) {
        const char *key = at->value->as.members[i].key;
        if (!is_listed(key, members)) {
            return unknown_member(at, key, members, error);
        }
    }
    return TAUT_OK;
}

taut_status taut_json_array(const taut_json *at, size_t least, size_t most, const char *items,
                            size_t *count, taut_error *error)
{
    const int is_array = taut_json_kind_at(at) == TAUT_JSON_ARRAY;
    const size_t size = taut_json_count_at(at);
    const char *reason = is_array ? "size" : "type";
    if (is_array && size >= least && size <= most) {
        *count = size;
        return TAUT_OK;
    }
    if (least == 1 && most == 1) {
        return taut_json_refuse(at, error, reason, "an array of one item");
    }
    if (least == most) {
        return taut_json_refuse(at, error, reason, "an array of %zu %s", least, items);
    }
    if (is_array && size > most) {
        return taut_json_refuse(at, error, reason, "an array of at most %zu %s", most, items);
    }
    if (least == 1) {
        return taut_json_refuse(at, error, reason, "an array of %s, one at least", items);
    }
    if (least > 0) {
        return taut_json_refuse(at, error, reason, "an array of at least %zu %s", least, items);
    }
    return taut_json_refuse(at, error, reason, "an array of %s", items);
}

taut_status taut_json_number(const taut_json *at, double *value, taut_error *error)
{
    if (taut_json_kind_at(at) != TAUT_JSON_NUMBER) {
        return taut_json_refuse(at, error, "type", "a number");
    }
    *value = at->value->as.number; /* finite: the parser sees to that */
    return TAUT_OK;
}

taut_status taut_json_integer(const taut_json *at, int least, int most, int *value,
                              taut_error *error)
{
    const int is_number = taut_json_kind_at(at) == TAUT_JSON_NUMBER;
    const double number = taut_json_number_at(at);
    if (!is_number || number != floor(number) || number < least || number > most) {
        const taut_status status = taut_json_refuse(at, error, is_number ? "value" : "type",
                                                    "a whole number from %d to %d", least, most);
        if (error != NULL && is_number) {
            error->limit = number < least ? least : most;
        }
        return status;
    }
    *value = (int)number;
    return TAUT_OK;
}

taut_status taut_json_numbers(const taut_json *at, size_t count, double *values, taut_error *error)
{
    size_t size = 0;
    taut_status status = taut_json_array(at, count, count, "numbers", &size, error);
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json item = taut_json_item(at, i);
        status = taut_json_number(&item, &values[i], error);
    }
    return status;
}

taut_status taut_json_text(const taut_json *at, const char **text, taut_error *error)
{
    if (taut_json_kind_at(at) != TAUT_JSON_STRING) {
        return taut_json_refuse(at, error, "type", "a string");
    }
    *text = at->value->as.string;
    return TAUT_OK;
}

taut_status taut_json_word(const taut_json *at, const char *const *words, int *word,
                           taut_error *error)
{
    char list[512];
    const char *found = taut_json_text_at(at);
    for (int i = 0; found != NULL && words[i] != NULL; i++) {
        if (strcmp(found, words[i]) == 0) {
            *word = i;
            return TAUT_OK;
        }
    }
    list_words(words, list, sizeof list);
    return taut_json_refuse(at, error, found != NULL ? "name" : "type", "%s", list);
}

taut_status taut_json_flag(const taut_json *document, const char *key, int *value,
                           taut_error *error)
{
    const taut_json at = taut_json_member(document, key);
    const taut_json_kind kind = taut_json_kind_at(&at);
    if (at.value != NULL && kind != TAUT_JSON_TRUE && kind != TAUT_JSON_FALSE) {
        return taut_json_refuse(&at, error, "type", "true or false");
    }
    *value = kind == TAUT_JSON_TRUE;
    return TAUT_OK;
}

taut_status taut_json_each(const taut_json *at, size_t least, size_t most, const char *items,
                           taut_json_read *read, void *into, taut_error *error)
{
    size_t count = 0;
    taut_status status = taut_json_array(at, least, most, items, &count, error);
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json item = taut_json_item(at, i);
        status = read(&item, into, error);
    }
    return status;
}

taut_reader taut_reader_of(const taut_json *object, const char *const *members, taut_error *error)
{
    return (taut_reader){object, error,
                         members != NULL ? taut_json_object(object, members, error) : TAUT_OK};
}

taut_reader taut_reader_inside(const taut_reader *outer, const taut_json *object,
                               const char *const *members)
{
    return outer->status == TAUT_OK ? taut_reader_of(object, members, outer->error)
                                    : (taut_reader){object, outer->error, outer->status};
}

int taut_reader_has(const taut_reader *reader, const char *key)
{
    return taut_json_find(reader->object->value, key) != NULL;
}

void taut_reader_integer(taut_reader *reader, const char *key, int least, int most, int *value)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_integer(&at, least, most, value, reader->error);
    }
}

void taut_reader_number(taut_reader *reader, const char *key, double *value)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_number(&at, value, reader->error);
    }
}

void taut_reader_numbers(taut_reader *reader, const char *key, size_t count, double *values)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_numbers(&at, count, values, reader->error);
    }
}

void taut_reader_array(taut_reader *reader, const char *key, size_t least, size_t most,
                       const char *items, size_t *count)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_array(&at, least, most, items, count, reader->error);
    }
}

void taut_reader_text(taut_reader *reader, const char *key, const char **text)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_text(&at, text, reader->error);
    }
}

void taut_reader_word(taut_reader *reader, const char *key, const char *const *words, int *word)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_word(&at, words, word, reader->error);
    }
}

void taut_reader_flag(taut_reader *reader, const char *key, int *value)
{
    if (reader->status == TAUT_OK) {
        reader->status = taut_json_flag(reader->object, key, value, reader->error);
    }
}

void taut_reader_member(taut_reader *reader, const char *key, taut_json_read *read, void *into)
{
    const taut_json at = taut_json_member(reader->object, key);
    if (reader->status == TAUT_OK) {
        reader->status = read(&at, into, reader->error);
    }
}

void taut_reader_items(taut_reader *reader, const char *key, size_t count, const char *items,
                       taut_json_read *read, void *first, size_t size)
{
    const taut_json at = taut_json_member(reader->object, key);
    size_t found = 0;
    taut_reader_array(reader, key, count, count, items, &found);
    for (size_t i = 0; i < count && reader->status == TAUT_OK; i++) {
        const taut_json item = taut_json_item(&at, i);
        reader->status = read(&item, (char *)first + i * size, reader->error);
    }
}

void taut_reader_optional(taut_reader *reader, const char *key, taut_json_read *read, void *into)
{
    if (taut_reader_has(reader, key)) {
        taut_reader_member(reader, key, read, into);
    }
}

void taut_reader_optional_integer(taut_reader *reader, const char *key, int least, int most,
                                  int *value)
{
    if (taut_reader_has(reader, key)) {
        taut_reader_integer(reader, key, least, most, value);
    }
}

void taut_reader_optional_number(taut_reader *reader, const char *key, double *value)
{
    if (taut_reader_has(reader, key)) {
        taut_reader_number(reader, key, value);
    }
}

void taut_reader_optional_word(taut_reader *reader, const char *key, const char *const *words,
                               int *word)
{
    if (taut_reader_has(reader, key)) {
        taut_reader_word(reader, key, words, word);
    }
}
