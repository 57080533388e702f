/* record.c -- any JSON value as a record. */
#include "core/fail.h"
#include "io/json/in.h"
#include "taut/limits.h"
#include "taut/read.h"

static taut_status add_value(taut_record *record, const char *key, const taut_json *at,
                             taut_error *error);

/* A record looks its members up one by one: their number is bounded, so that a hostile document
 * costs no more than linear time. */
static taut_status add_members(taut_record *record, const taut_json *at, taut_error *error)
{
    const size_t count = taut_json_count_at(at);
    taut_status status = TAUT_OK;

    if (count > TAUT_MEMBERS_MAX) {
        return taut_json_fail(at, error, "size", (double)count, TAUT_MEMBERS_MAX,
                              "found an object of %zu members, expected at most %d", count,
                              TAUT_MEMBERS_MAX);
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json_entry *entry = &at->value->as.members[i];
        const taut_json member = {&entry->value, at, entry->key, 0, NULL};
        status = add_value(record, entry->key, &member, error);
    }
    return status;
}

static taut_status add_items(taut_record *record, const taut_json *at, taut_error *error)
{
    const size_t count = taut_json_count_at(at);
    taut_status status = TAUT_OK;
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json item = taut_json_item(at, i);
        status = add_value(record, NULL, &item, error);
    }
    return status;
}

/* The depth is that of the document, which the parser bounds. */
static taut_status add_value(taut_record *record, const char *key, const taut_json *at,
                             taut_error *error)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    taut_status status = TAUT_OK;
    if (kind == TAUT_JSON_OBJECT) {
        status = add_members(taut_record_add_object(record, key), at, error);
    } else if (kind == TAUT_JSON_ARRAY) {
        status = add_items(taut_record_add_list(record, key), at, error);
    } else if (kind == TAUT_JSON_STRING) {
        taut_record_add_text(record, key, taut_json_text_at(at));
    } else if (kind == TAUT_JSON_NUMBER) {
        taut_record_add_number(record, key, taut_json_number_at(at));
    } else if (kind == TAUT_JSON_NULL) {
        taut_record_add_null(record, key);
    } else {
        taut_record_add_bool(record, key, kind == TAUT_JSON_TRUE);
    }
    return status;
}

taut_status taut_json_record(const taut_json *at, taut_record **record, taut_error *error)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    taut_record *made = NULL;
    taut_status status = TAUT_OK;

    if (kind != TAUT_JSON_OBJECT && kind != TAUT_JSON_ARRAY) {
        return taut_json_refuse(at, error, "type", "an object");
    }
    made = kind == TAUT_JSON_OBJECT ? taut_record_new() : taut_record_new_list();
    status = kind == TAUT_JSON_OBJECT ? add_members(made, at, error) : add_items(made, at, error);
    if (status == TAUT_OK && taut_record_status(made) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status != TAUT_OK) {
        taut_record_free(made);
        return status;
    }
    *record = made;
    return TAUT_OK;
}

taut_status taut_json_record_object(const taut_json *at, taut_record **record, taut_error *error)
{
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "type", "an object");
    }
    return taut_json_record(at, record, error);
}

static taut_status read_root(const taut_json *at, void *record, taut_error *error)
{
    return taut_json_record(at, record, error);
}

taut_status taut_record_read_text(const char *text, size_t length, const char *name,
                                  taut_record **record, taut_error *error)
{
    if (text == NULL || name == NULL || record == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "reading needs a text, its name and a place for the record");
    }
    return taut_json_read_text(text, length, name, NULL, read_root, record, error);
}
