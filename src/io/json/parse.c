/* parse.c -- the tree of a JSON text.
 *
 * Items wait on a stack until their list or object ends; then they are copied, as many as there
 * are, into the document's pool.
 */
#include "core/fail.h"
#include "core/memory.h"
#include "io/json/scan.h"
#include "taut/limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct taut_json_document {
    taut_pool pool;
    taut_json_value root;
};

/* Entries of lists have no key. */
typedef struct parser {
    taut_json_scan scan;
    taut_json_entry *members; /* of all objects that are open, outermost first */
    size_t member_count, member_room;
    taut_json_value *items; /* of all lists that are open */
    size_t item_count, item_room;
} parser;

/* Room for one more on a stack; 0 when memory runs out. */
static int grow(parser *p, void **stack, size_t count, size_t *room, size_t size)
{
    if (count == *room) {
        const size_t more = *room > 0 ? 2 * *room : 64;
        void *larger = taut_realloc(*stack, more, size);
        if (larger == NULL) {
            return taut_json_stop_memory(&p->scan);
        }
        *stack = larger;
        *room = more;
    }
    return 1;
}

static int push_item(parser *p, const taut_json_value *value)
{
    void *stack = p->items;
    const int grown = grow(p, &stack, p->item_count, &p->item_room, sizeof *p->items);
    p->items = stack;
    if (grown) {
        p->items[p->item_count++] = *value;
    }
    return grown;
}

static int push_member(parser *p, const taut_json_entry *member)
{
    void *stack = p->members;
    const int grown = grow(p, &stack, p->member_count, &p->member_room, sizeof *p->members);
    p->members = stack;
    if (grown) {
        p->members[p->member_count++] = *member;
    }
    return grown;
}

/* Moves the topmost entries of a stack into the pool; NULL when memory runs out. */
static void *settle(parser *p, const void *from, size_t count, size_t size)
{
    void *to = taut_pool_take(p->scan.pool, count, size);
    if (to == NULL) {
        taut_json_stop_memory(&p->scan);
    } else if (count > 0) {
        memcpy(to, from, count * size);
    }
    return to;
}

/* Is the next thing this character? Moves past it. */
static int accept(parser *p, char c)
{
    taut_json_skip(&p->scan);
    if (p->scan.at < p->scan.end && *p->scan.at == c) {
        p->scan.at++;
        return 1;
    }
    return 0;
}

static int parse_value(parser *p, int depth, taut_json_value *value);

static int parse_array(parser *p, int depth, taut_json_value *value)
{
    const size_t base = p->item_count;
    int more = !accept(p, ']');
    while (more) {
        taut_json_value item;
        if (!parse_value(p, depth, &item) || !push_item(p, &item)) {
            return 0;
        }
        more = accept(p, ',');
        if (!more && !accept(p, ']')) {
            return taut_json_stop(&p->scan, p->scan.at,
                                  "this is not JSON: found %s, expected ',' or ']'");
        }
    }
    const size_t count = p->item_count - base;
    const taut_json_value *items =
        settle(p, count > 0 ? p->items + base : NULL, count, sizeof *items);
    p->item_count = base;
    *value = (taut_json_value){TAUT_JSON_ARRAY, (uint32_t)count, {.items = items}};
    return items != NULL;
}

static int compare_members(const void *a, const void *b)
{
    const taut_json_entry *const *x = a, *const *y = b;
    const int order = strcmp((*x)->key, (*y)->key);
    return order != 0 ? order : ((*x)->offset > (*y)->offset) - ((*x)->offset < (*y)->offset);
}

/* The first member that repeats an earlier one, or NULL. Few are compared each with each, many
 * sorted. */
static int check_twice(parser *p, const taut_json_entry *members, size_t count)
{
    enum { FEW = 16 };
    const taut_json_entry *twice = NULL;
    const taut_json_entry **sorted = NULL;

    if (count <= FEW) {
        for (size_t i = 1; i < count && twice == NULL; i++) {
            for (size_t j = 0; j < i && twice == NULL; j++) {
                twice = strcmp(members[i].key, members[j].key) == 0 ? &members[i] : NULL;
            }
        }
    } else {
        sorted = taut_alloc(count, sizeof *sorted);
        if (sorted == NULL) {
            return taut_json_stop_memory(&p->scan);
        }
        for (size_t i = 0; i < count; i++) {
            sorted[i] = &members[i];
        }
        qsort(sorted, count, sizeof *sorted, compare_members);
        for (size_t i = 1; i < count; i++) {
            if (strcmp(sorted[i - 1]->key, sorted[i]->key) == 0 &&
                (twice == NULL || sorted[i]->offset < twice->offset)) {
                twice = sorted[i];
            }
        }
        taut_free((void *)sorted);
    }
    return twice == NULL ||
           taut_json_stop(&p->scan, p->scan.begin + twice->offset, "the member %s is given twice");
}

/* One "key": value. */
static int parse_member(parser *p, int depth)
{
    taut_json_entry member = {NULL, 0, {0, 0, {.number = 0}}};
    taut_json_value key;

    taut_json_skip(&p->scan);
    if (p->scan.at == p->scan.end || *p->scan.at != '"') {
        return taut_json_stop(&p->scan, p->scan.at,
                              "this is not JSON: found %s, expected the name of a member, in "
                              "double quotes");
    }
    member.offset = (size_t)(p->scan.at - p->scan.begin);
    if (!taut_json_scan_string(&p->scan, &key)) {
        return 0;
    }
    member.key = key.as.string;
    if (!accept(p, ':')) {
        return taut_json_stop(&p->scan, p->scan.at, "this is not JSON: found %s, expected ':'");
    }
    return parse_value(p, depth, &member.value) && push_member(p, &member);
}

static int parse_object(parser *p, int depth, taut_json_value *value)
{
    const size_t base = p->member_count;
    int more = !accept(p, '}');
    while (more) {
        if (!parse_member(p, depth)) {
            return 0;
        }
        more = accept(p, ',');
        if (!more && !accept(p, '}')) {
            return taut_json_stop(&p->scan, p->scan.at,
                                  "this is not JSON: found %s, expected ',' or '}'");
        }
    }
    const size_t count = p->member_count - base;
    const taut_json_entry *members =
        settle(p, count > 0 ? p->members + base : NULL, count, sizeof *members);
    p->member_count = base;
    *value = (taut_json_value){TAUT_JSON_OBJECT, (uint32_t)count, {.members = members}};
    return members != NULL && check_twice(p, members, count);
}

static int parse_value(parser *p, int depth, taut_json_value *value)
{
    char c = '\0';
    taut_json_skip(&p->scan);
    if (p->scan.at == p->scan.end) {
        return taut_json_stop(&p->scan, p->scan.end, NULL);
    }
    c = *p->scan.at;
    if (c == '"') {
        return taut_json_scan_string(&p->scan, value);
    }
    if (c != '[' && c != '{') {
        return taut_json_scan_word(&p->scan, value);
    }
    if (depth == TAUT_JSON_DEPTH_MAX) {
        _Static_assert(TAUT_JSON_DEPTH_MAX == 256, "the message says the limit");
        return taut_json_stop(&p->scan, p->scan.at,
                              "lists and objects are nested too deep: more than 256 of them");
    }
    p->scan.at++;
    return c == '[' ? parse_array(p, depth + 1, value) : parse_object(p, depth + 1, value);
}

static int parse_all(parser *p, taut_json_value *root)
{
    taut_json_skip(&p->scan);
    if (p->scan.at == p->scan.end) {
        return taut_json_stop(&p->scan, p->scan.begin,
                              "the document is empty, expected a JSON object");
    }
    if (!parse_value(p, 0, root)) {
        return 0;
    }
    taut_json_skip(&p->scan);
    return p->scan.at == p->scan.end ||
           taut_json_stop(&p->scan, p->scan.at, "after the end of the document comes %s");
}

/* What stands at a place, in quotes: a word, or one character. */
static void quote(const char *at, const char *end, char quoted[32])
{
    enum { SHOWN = 24 };
    size_t n = 0, length = 1;
    while (length < SHOWN && at + length < end && strchr(" \t\r\n,:[]{}", *at) == NULL &&
           strchr(" \t\r\n,:[]{}", at[length]) == NULL) {
        length++;
    }
    quoted[n++] = '\'';
    for (size_t i = 0; i < length; i++) {
        quoted[n++] = at[i] >= 0x20 && at[i] < 0x7f ? at[i] : '?';
    }
    quoted[n++] = '\'';
    quoted[n] = '\0';
}

/* Line and column of a place, from 1; the column in characters. "file:line:column" goes to
 * error->where; of a long name the end is kept. */
static taut_status report(const taut_json_scan *scan, const char *name, taut_error *error)
{
    char where[sizeof error->where], numbers[48], quoted[32] = "the end", message[200];
    size_t line = 1, column = 1, length = strlen(name), room = 0;
    const int ended = scan->place == scan->end && scan->begin != scan->end;

    for (const char *c = scan->begin; c < scan->place; c++) {
        if (*c == '\n') {
            line++;
            column = 1;
        } else {
            column += ((unsigned char)*c & 0xc0) != 0x80; /* not inside a UTF-8 sequence */
        }
    }
    room = sizeof where - 1 - (size_t)snprintf(numbers, sizeof numbers, ":%zu:%zu", line, column);
    snprintf(where, sizeof where, "%s%s%s", length > room ? "..." : "",
             length > room ? name + (length - room + 3) : name, numbers);
    for (char *c = where; *c != '\0'; c++) {
        *c = (unsigned char)*c < 0x20 || *c == 0x7f ? '?' : *c;
    }
    if (ended || scan->reason == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none,
                         "the text ends before the document does");
    }
    if (scan->place < scan->end) {
        quote(scan->place, scan->end, quoted);
    }
    const char *hole = strstr(scan->reason, "%s");
    const int before = (int)(hole != NULL ? (size_t)(hole - scan->reason) : strlen(scan->reason));
    snprintf(message, sizeof message, "%.*s%s%s", before, scan->reason, hole != NULL ? quoted : "",
             hole != NULL ? hole + 2 : "");
    return taut_fail(error, TAUT_BAD_INPUT, "value", where, taut_none, taut_none, "%s", message);
}

taut_status taut_json_parse(const char *text, size_t length, const char *name,
                            taut_json_document **document, taut_error *error)
{
    static const char mark[] = "\xef\xbb\xbf"; /* a byte order mark may be ignored: RFC 8259, 8.1 */
    const size_t skip = length >= 3 && memcmp(text, mark, 3) == 0 ? 3 : 0;
    const char *begin = length > 0 ? text + skip : "";
    taut_json_document *made = NULL;
    taut_status status = TAUT_OK;
    parser p = {.scan = {.begin = begin, .at = begin, .end = begin + (length - skip)}};

    if ((double)length > TAUT_FILE_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", NULL, (double)length, TAUT_FILE_MAX,
                         "a document of %zu bytes, expected at most %.0f", length, TAUT_FILE_MAX);
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    p.scan.pool = &made->pool;
    if (!parse_all(&p, &made->root)) {
        status = p.scan.no_memory ? taut_fail_memory(error) : report(&p.scan, name, error);
    }
    taut_plain_locale_free(&p.scan.plain);
    taut_free(p.items);
    taut_free(p.members);
    if (status != TAUT_OK) {
        taut_json_document_free(made);
        return status;
    }
    *document = made;
    return TAUT_OK;
}

void taut_json_document_free(taut_json_document *document)
{
    if (document != NULL) {
        taut_pool_free(&document->pool);
        taut_free(document);
    }
}

const taut_json_value *taut_json_document_root(const taut_json_document *document)
{
    return &document->root;
}

const taut_json_value *taut_json_find(const taut_json_value *object, const char *key)
{
    if (object == NULL || object->kind != TAUT_JSON_OBJECT) {
        return NULL;
    }
    for (uint32_t i = 0; i < object->count; i++) {
        if (strcmp(object->as.members[i].key, key) == 0) {
            return &object->as.members[i].value;
        }
    }
    return NULL;
}
