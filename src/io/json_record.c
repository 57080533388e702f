/* json_record.c -- any JSON value as a record. */
#include "core/fail.h"
#include "io/json_in.h"
#include "taut/limits.h"

static taut_status add_value(taut_record *record, const char *key, const taut_json *at,
                             taut_error *error);

/* A record looks its members up one by one: their number is bounded, so that a hostile document
 * costs no more than linear time. */
static taut_status add_members(taut_record *record, const taut_json *at, taut_error *error)
{
    json_t *object = (json_t *)(size_t)at->value; /* jansson iterates without const */
    taut_status status = TAUT_OK;
    const char *key = NULL;
    json_t *value = NULL;

    if (json_object_size(object) > TAUT_MEMBERS_MAX) {
        return taut_json_fail(at, error, (double)json_object_size(object), TAUT_MEMBERS_MAX,
                              "found an object of %zu members, expected at most %d",
                              json_object_size(object), TAUT_MEMBERS_MAX);
    }
    json_object_foreach(object, key, value)
    {
        if (status == TAUT_OK) {
            const taut_json member = {value, at, key, 0};
            status = add_value(record, key, &member, error);
        }
    }
    return status;
}

static taut_status add_items(taut_record *record, const taut_json *at, taut_error *error)
{
    const size_t count = json_array_size(at->value);
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
    taut_status status = TAUT_OK;
    if (json_is_object(at->value)) {
        status = add_members(taut_record_add_object(record, key), at, error);
    } else if (json_is_array(at->value)) {
        status = add_items(taut_record_add_list(record, key), at, error);
    } else if (json_is_string(at->value)) {
        taut_record_add_text(record, key, json_string_value(at->value));
    } else if (json_is_number(at->value)) {
        taut_record_add_number(record, key, json_number_value(at->value));
    } else if (json_is_boolean(at->value)) {
        taut_record_add_bool(record, key, json_is_true(at->value));
    } else {
        taut_record_add_null(record, key);
    }
    return status;
}

taut_status taut_json_record(const taut_json *at, taut_record **record, taut_error *error)
{
    taut_record *made = NULL;
    taut_status status = TAUT_OK;

    if (!json_is_object(at->value) && !json_is_array(at->value)) {
        return taut_json_expected(at, error, "an object");
    }
    made = json_is_object(at->value) ? taut_record_new() : taut_record_new_list();
    status = json_is_object(at->value) ? add_members(made, at, error) : add_items(made, at, error);
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
