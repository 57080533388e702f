/* record.c -- the tree of results. Children are arrays of nodes that grow by doubling; a failure to
 * grow is remembered in the root. */
#include "taut/record.h"

#include "core/memory.h"

#include <math.h>
#include <string.h>

struct taut_record {
    taut_record *root; /* where a failure is remembered */
    taut_record_kind kind;
    taut_status status; /* of the root only: what the first failed addition failed with */
    double number;
    char *text;
    char *key;
    taut_record **items;
    size_t count, room;
};

static taut_record *node_new(taut_record *root, taut_record_kind kind)
{
    taut_record *node = taut_alloc_zero(1, sizeof *node);
    if (node != NULL) {
        node->root = root != NULL ? root : node;
        node->kind = kind;
    }
    return node;
}

static char *text_copy(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = taut_alloc(size, 1);
    if (copy != NULL) {
        memcpy(copy, text, size);
    }
    return copy;
}

taut_record *taut_record_new(void)
{
    return node_new(NULL, TAUT_RECORD_OBJECT);
}

taut_record *taut_record_new_list(void)
{
    return node_new(NULL, TAUT_RECORD_LIST);
}

void taut_record_free(taut_record *record)
{
    if (record == NULL) {
        return;
    }
    for (size_t i = 0; i < record->count; i++) {
        taut_record_free(record->items[i]);
    }
    taut_free(record->items);
    taut_free(record->text);
    taut_free(record->key);
    taut_free(record);
}

/* Makes room for one more child. */
static int grow_room(taut_record *record)
{
    if (record->count == record->room) {
        const size_t room = record->room > 0 ? 2 * record->room : 4;
        taut_record **items = taut_realloc(record->items, room, sizeof(taut_record *));
        if (items == NULL) {
            return 0;
        }
        record->items = items;
        record->room = room;
    }
    return 1;
}

/* The slot of member `key` if it is there already, else the end. */
static size_t slot_of(const taut_record *record, const char *key)
{
    if (key != NULL) {
        for (size_t i = 0; i < record->count; i++) {
            if (strcmp(record->items[i]->key, key) == 0) {
                return i;
            }
        }
    }
    return record->count;
}

/* Adds a child of some kind and returns it, or NULL with the failure remembered. */
static taut_record *add_item(taut_record *record, const char *key, taut_record_kind kind)
{
    taut_record *child = NULL;
    size_t slot = 0;
    if (record == NULL || record->root->status != TAUT_OK) {
        return NULL;
    }
    if (record->kind != (key != NULL ? TAUT_RECORD_OBJECT : TAUT_RECORD_LIST)) {
        record->root->status = TAUT_BAD_ARGUMENT;
        return NULL;
    }
    slot = slot_of(record, key);
    child = node_new(record->root, kind);
    if (child == NULL || (key != NULL && (child->key = text_copy(key)) == NULL) ||
        !grow_room(record)) {
        record->root->status = TAUT_NO_MEMORY;
        taut_record_free(child);
        return NULL;
    }
    if (slot < record->count) {
        taut_record_free(record->items[slot]);
    } else {
        record->count++;
    }
    record->items[slot] = child;
    return child;
}

void taut_record_add_null(taut_record *record, const char *key)
{
    (void)add_item(record, key, TAUT_RECORD_NULL);
}

void taut_record_add_bool(taut_record *record, const char *key, int value)
{
    taut_record *child = add_item(record, key, TAUT_RECORD_BOOL);
    if (child != NULL) {
        child->number = value != 0;
    }
}

void taut_record_add_number(taut_record *record, const char *key, double value)
{
    taut_record *child =
        add_item(record, key, isfinite(value) ? TAUT_RECORD_NUMBER : TAUT_RECORD_NULL);
    if (child != NULL) {
        child->number = value;
    }
}

void taut_record_add_text(taut_record *record, const char *key, const char *value)
{
    taut_record *child = add_item(record, key, TAUT_RECORD_TEXT);
    if (child != NULL) {
        child->text = text_copy(value != NULL ? value : "");
        if (child->text == NULL) {
            child->root->status = TAUT_NO_MEMORY;
        }
    }
}

void taut_record_add_numbers(taut_record *record, const char *key, int count, const double *values)
{
    taut_record *list = add_item(record, key, TAUT_RECORD_LIST);
    for (int i = 0; i < count; i++) {
        taut_record_add_number(list, NULL, values[i]);
    }
}

taut_record *taut_record_add_list(taut_record *record, const char *key)
{
    return add_item(record, key, TAUT_RECORD_LIST);
}

taut_record *taut_record_add_object(taut_record *record, const char *key)
{
    return add_item(record, key, TAUT_RECORD_OBJECT);
}

/* Adds the children of `from` to `to`, of the same kind. */
static void copy_children(taut_record *to, const taut_record *from)
{
    for (size_t i = 0; i < from->count; i++) {
        taut_record_add_record(to, from->kind == TAUT_RECORD_OBJECT ? from->items[i]->key : NULL,
                               from->items[i]);
    }
}

void taut_record_add_record(taut_record *record, const char *key, const taut_record *child)
{
    taut_record *copy = NULL;
    if (child == NULL) {
        taut_record_add_null(record, key);
    } else if (record != NULL && child->root == record->root) { /* it may hold its own new place */
        copy = taut_record_copy(child);
        if (copy == NULL) {
            record->root->status = TAUT_NO_MEMORY;
        } else {
            taut_record_add_record(record, key, copy);
            taut_record_free(copy);
        }
    } else if (child->kind == TAUT_RECORD_TEXT) {
        taut_record_add_text(record, key, child->text);
    } else {
        copy = add_item(record, key, child->kind);
        if (copy != NULL) {
            copy->number = child->number;
            copy_children(copy, child);
        }
    }
}

taut_record *taut_record_copy(const taut_record *record)
{
    taut_record *copy = NULL;
    if (record == NULL) {
        return NULL;
    }
    copy = node_new(NULL, record->kind);
    if (copy != NULL) {
        copy->number = record->number;
        if (record->text != NULL && (copy->text = text_copy(record->text)) == NULL) {
            copy->status = TAUT_NO_MEMORY;
        }
        copy_children(copy, record);
    }
    if (taut_record_status(copy) != TAUT_OK) {
        taut_record_free(copy);
        copy = NULL;
    }
    return copy;
}

taut_status taut_record_status(const taut_record *root)
{
    return root != NULL ? root->root->status : TAUT_NO_MEMORY;
}

taut_record_kind taut_record_kind_of(const taut_record *record)
{
    return record != NULL ? record->kind : TAUT_RECORD_NULL;
}

int taut_record_bool(const taut_record *record)
{
    return taut_record_kind_of(record) == TAUT_RECORD_BOOL && record->number != 0;
}

double taut_record_number(const taut_record *record)
{
    return taut_record_kind_of(record) == TAUT_RECORD_NUMBER ? record->number : nan("");
}

const char *taut_record_text(const taut_record *record)
{
    return taut_record_kind_of(record) == TAUT_RECORD_TEXT && record->text != NULL ? record->text
                                                                                   : "";
}

size_t taut_record_count(const taut_record *record)
{
    return record != NULL ? record->count : 0;
}

const taut_record *taut_record_at(const taut_record *record, size_t i)
{
    return i < taut_record_count(record) ? record->items[i] : NULL;
}

const char *taut_record_key(const taut_record *record, size_t i)
{
    const taut_record *child = taut_record_at(record, i);
    return child != NULL && child->key != NULL ? child->key : "";
}

const taut_record *taut_record_get(const taut_record *record, const char *key)
{
    if (taut_record_kind_of(record) != TAUT_RECORD_OBJECT) {
        return NULL;
    }
    return taut_record_at(record, slot_of(record, key));
}
