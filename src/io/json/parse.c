/* parse.c -- the tree of a JSON text: tokens, then values inside one another.
 *
 * Items wait on a stack until their list or object ends; then they are copied, as many as there
 * are, into the document's pool.
 */
#include "core/fail.h"
#include "core/memory.h"
#include "io/json/number_value.h"
#include "io/json/tree.h"
#include "io/json/utf8.h"
#include "taut/limits.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    FIRST_BLOCK = 1 << 12,
    LARGEST_BLOCK = 1 << 20,
    ALIGNMENT = 8,
    TOLD = 1 << 14, /* bytes that are told to a pulse at once, */
    BYTE_WORK = 4   /* each so many operations */
};

/* Many small pieces that live and die together. */
typedef struct pool_block {
    struct pool_block *next;
    size_t size; /* bytes after the header */
} pool_block;

typedef struct json_pool {
    pool_block *blocks; /* newest first */
    char *free;         /* what is left of the newest */
    size_t left;
} json_pool;

/* Blocks double up to a megabyte; a piece that is larger gets a block of its own. */
static int add_block(json_pool *pool, size_t bytes)
{
    size_t size = pool->blocks == NULL ? FIRST_BLOCK : 2 * pool->blocks->size;
    pool_block *block = NULL;
    size = size < LARGEST_BLOCK ? size : LARGEST_BLOCK;
    size = size > bytes ? size : bytes;
    block = taut_alloc(1, sizeof *block + size);
    if (block == NULL) {
        return 0;
    }
    *block = (pool_block){pool->blocks, size};
    pool->blocks = block;
    pool->free = (char *)(block + 1);
    pool->left = size;
    return 1;
}

/* count * size bytes, aligned to 8; NULL when memory runs out. */
static void *take_piece(json_pool *pool, size_t count, size_t size)
{
    size_t bytes = 0;
    void *piece = NULL;
    if (size != 0 && count > SIZE_MAX / 4 / size) {
        return NULL;
    }
    bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    bytes = bytes > 0 ? bytes : ALIGNMENT;
    if (bytes > pool->left && !add_block(pool, bytes)) {
        return NULL;
    }
    piece = pool->free;
    pool->free += bytes;
    pool->left -= bytes;
    return piece;
}

static void free_pool(json_pool *pool)
{
    while (pool->blocks != NULL) {
        pool_block *block = pool->blocks;
        pool->blocks = block->next;
        taut_free(block);
    }
    pool->free = NULL;
    pool->left = 0;
}

/* The text, how far it is read, and what stopped it, if anything did. What scans or parses returns
 * 0 where it stops. */
typedef struct json_scan {
    const char *begin, *at, *end;
    json_pool *pool; /* where strings go */
    int no_memory;
    const char *place;    /* in the text */
    const char *reason;   /* a word */
    const char *sentence; /* whose %s is what is found there, or NULL: the text ended */
} json_scan;

/* Stops at `place`. Always 0. */
static int stop_for(json_scan *scan, const char *reason, const char *place, const char *sentence)
{
    scan->place = place;
    scan->reason = reason;
    scan->sentence = sentence;
    return 0;
}

static int stop(json_scan *scan, const char *place, const char *sentence)
{
    return stop_for(scan, "syntax", place, sentence);
}

static int stop_memory(json_scan *scan)
{
    scan->no_memory = 1;
    return 0;
}

static void skip_space(json_scan *scan)
{
    const char *at = scan->at;
    while (at < scan->end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t')) {
        at++;
    }
    scan->at = at;
}

/* Four hexadecimal digits; -1 if they are not. */
static int64_t hex_digits(const char *at, const char *end)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    int64_t value = 0;
    for (int i = 0; i < 4; i++) {
        const char *digit = at + i < end && at[i] != '\0' ? strchr(digits, at[i]) : NULL;
        if (digit == NULL) {
            return -1;
        }
        value = 16 * value + (int)(digit - digits) % 16;
    }
    return value;
}

/* Appends a code point as UTF-8; returns its length. */
static size_t write_utf8(int64_t code, char *out)
{
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        out[0] = (char)(0xc0 | code >> 6);
        out[1] = (char)(0x80 | (code & 63));
        return 2;
    }
    if (code < 0x10000) {
        out[0] = (char)(0xe0 | code >> 12);
        out[1] = (char)(0x80 | (code >> 6 & 63));
        out[2] = (char)(0x80 | (code & 63));
        return 3;
    }
    out[0] = (char)(0xf0 | code >> 18);
    out[1] = (char)(0x80 | (code >> 12 & 63));
    out[2] = (char)(0x80 | (code >> 6 & 63));
    out[3] = (char)(0x80 | (code & 63));
    return 4;
}

/* The escape "\uXXXX", or a pair of them, at *at; moves past it. */
static int scan_code(json_scan *scan, const char **at, char *out, size_t *length)
{
    const char *from = *at, *next = from + 6;
    int64_t code = hex_digits(from + 2, scan->end);
    if (code >= 0xd800 && code <= 0xdfff) { /* half of a pair */
        const int paired = scan->end - next >= 6 && next[0] == '\\' && next[1] == 'u';
        const int64_t low = code < 0xdc00 && paired ? hex_digits(next + 2, scan->end) : -1;
        code = low >= 0xdc00 && low <= 0xdfff ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00)
                                              : -1;
        next += 6;
    }
    if (code <= 0) {
        return stop(scan, from, "this is not JSON: %s is no character of a string");
    }
    *length = write_utf8(code, out);
    *at = next;
    return 1;
}

/* One escape at *at; moves past it. */
static int scan_escape(json_scan *scan, const char **at, char *out, size_t *length)
{
    static const char letters[] = "\"\\/bfnrt", meanings[] = "\"\\/\b\f\n\r\t";
    const char letter = scan->end - *at >= 2 ? (*at)[1] : '\0';
    const char *known = letter != '\0' ? strchr(letters, letter) : NULL;
    if (letter == 'u') {
        return scan_code(scan, at, out, length);
    }
    if (known == NULL) {
        return stop(scan, *at, "this is not JSON: %s is no escape of a string");
    }
    out[0] = meanings[known - letters];
    *length = 1;
    *at += 2;
    return 1;
}

/* The quote that ends the string whose first byte is `at`, or what comes before it and does not
 * belong there: a control character, the end of the text. */
static const char *closing_quote(const char *at, const char *end)
{
    while (at < end && *at != '"' && (unsigned char)*at >= 0x20) {
        at += *at == '\\' && end - at > 1 ? 2 : 1;
    }
    return at;
}

/* A string that begins here, unescaped into the pool. */
static int scan_string(json_scan *scan, taut_json_value *value)
{
    const char *at = scan->at + 1;
    const char *close = closing_quote(at, scan->end);
    char *string = NULL;
    size_t n = 0;

    if (close == scan->end) {
        return stop(scan, scan->end, NULL);
    }
    if (*close != '"') {
        return stop(scan, close, "this is not JSON: a control character in a string");
    }
    string = take_piece(scan->pool, (size_t)(close - at) + 1, 1); /* unescaping only shortens */
    if (string == NULL) {
        return stop_memory(scan);
    }
    while (at < close) {
        size_t length = taut_utf8_length(at, (size_t)(close - at));
        if (*at == '\\') {
            if (!scan_escape(scan, &at, string + n, &length)) {
                return 0;
            }
        } else if (length == 0) {
            return stop(scan, at, "the text is not UTF-8");
        } else {
            memcpy(string + n, at, length);
            at += length;
        }
        n += length;
    }
    string[n] = '\0';
    scan->at = close + 1;
    *value = (taut_json_value){TAUT_JSON_STRING, (uint32_t)n, {.string = string}};
    return 1;
}

/* The length of the run of letters, digits and signs here: what a word or number could be. */
static size_t word_length(const char *at, const char *end)
{
    const char *from = at;
    while (at < end &&
           ((*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z') ||
            (*at >= '0' && *at <= '9') || strchr("+-._", *at) != NULL) &&
           *at != '\0') {
        at++;
    }
    return (size_t)(at - from);
}

static int is_word(const char *at, size_t length, const char *word)
{
    return length == strlen(word) && memcmp(at, word, length) == 0;
}

/* A number, true, false or null. */
static int scan_word(json_scan *scan, taut_json_value *value)
{
    static const struct {
        const char *word;
        taut_json_kind kind;
    } words[3] = {{"null", TAUT_JSON_NULL}, {"true", TAUT_JSON_TRUE}, {"false", TAUT_JSON_FALSE}};
    const size_t room = (size_t)(scan->end - scan->at);
    const size_t number = taut_number_length(scan->at, room);
    const char *after = scan->at + number;

    if (number > 0 && word_length(after, scan->end) == 0) {
        const double x = taut_number_value(scan->at, number);
        if (!isfinite(x)) {
            return stop_for(scan, "value", scan->at, "%s does not fit double precision");
        }
        *value = (taut_json_value){TAUT_JSON_NUMBER, 0, {.number = x}};
        scan->at = after;
        return 1;
    }
    const size_t length = word_length(scan->at, scan->end);
    for (int i = 0; i < 3; i++) {
        if (is_word(scan->at, length, words[i].word)) {
            *value = (taut_json_value){(uint32_t)words[i].kind, 0, {.number = 0}};
            scan->at += length;
            return 1;
        }
    }
    return stop(scan, scan->at, "this is not JSON: found %s, expected a value");
}

struct taut_json_document {
    json_pool pool;
    taut_json_value root;
};

/* Entries of lists have no key. */
typedef struct parser {
    json_scan scan;
    taut_json_entry *members; /* of all objects that are open, outermost first */
    size_t member_count, member_room;
    taut_json_value *items; /* of all lists that are open */
    size_t item_count, item_room;
    taut_pulse *pulse; /* or NULL */
    const char *told;  /* up to where */
} parser;

/* Room for one more on a stack; 0 when memory runs out. */
static int grow_stack(parser *p, void **stack, size_t count, size_t *room, size_t size)
{
    if (count == *room) {
        const size_t more = *room > 0 ? 2 * *room : 64;
        void *larger = taut_realloc(*stack, more, size);
        if (larger == NULL) {
            return stop_memory(&p->scan);
        }
        *stack = larger;
        *room = more;
    }
    return 1;
}

static int push_item(parser *p, const taut_json_value *value)
{
    void *stack = p->items;
    const int grown = grow_stack(p, &stack, p->item_count, &p->item_room, sizeof *p->items);
    p->items = stack;
    if (grown) {
        p->items[p->item_count++] = *value;
    }
    return grown;
}

static int push_member(parser *p, const taut_json_entry *member)
{
    void *stack = p->members;
    const int grown = grow_stack(p, &stack, p->member_count, &p->member_room, sizeof *p->members);
    p->members = stack;
    if (grown) {
        p->members[p->member_count++] = *member;
    }
    return grown;
}

/* Moves the topmost entries of a stack into the pool; NULL when memory runs out. */
static void *move_to_pool(parser *p, const void *from, size_t count, size_t size)
{
    void *to = take_piece(p->scan.pool, count, size);
    if (to == NULL) {
        stop_memory(&p->scan);
    } else if (count > 0) {
        memcpy(to, from, count * size);
    }
    return to;
}

/* Is the next thing this character? Moves past it. */
static int accept_char(parser *p, char c)
{
    skip_space(&p->scan);
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
    int more = !accept_char(p, ']');
    while (more) {
        taut_json_value item;
        if (!parse_value(p, depth, &item) || !push_item(p, &item)) {
            return 0;
        }
        more = accept_char(p, ',');
        if (!more && !accept_char(p, ']')) {
            return stop(&p->scan, p->scan.at, "this is not JSON: found %s, expected ',' or ']'");
        }
    }
    const size_t count = p->item_count - base;
    const taut_json_value *items =
        move_to_pool(p, count > 0 ? p->items + base : NULL, count, sizeof *items);
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
            return stop_memory(&p->scan);
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
    return twice == NULL || stop_for(&p->scan, "twice", p->scan.begin + twice->offset,
                                     "the member %s is given twice");
}

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* One "key": value. */
static int parse_member(parser *p, int depth)
{
    taut_json_entry member = {NULL, 0, {0, 0, {.number = 0}}};
    taut_json_value key;

    skip_space(&p->scan);
    if (p->scan.at == p->scan.end || *p->scan.at != '"') {
        const char *at = p->scan.at; /* "force": 1,5 */
        const int is_decimal = at < p->scan.end && is_digit(*at) && at - p->scan.begin > 1 &&
                               at[-1] == ',' && is_digit(at[-2]);
        return stop(&p->scan, p->scan.at,
                    is_decimal
                        ? "this is not JSON: found %s behind a comma, expected the name of a "
                          "member (decimal numbers have a point: 1.5, not 1,5)"
                        : "this is not JSON: found %s, expected the name of a member, in "
                          "double quotes");
    }
    member.offset = (size_t)(p->scan.at - p->scan.begin);
    if (!scan_string(&p->scan, &key)) {
        return 0;
    }
    member.key = key.as.string;
    if (!accept_char(p, ':')) {
        return stop(&p->scan, p->scan.at, "this is not JSON: found %s, expected ':'");
    }
    return parse_value(p, depth, &member.value) && push_member(p, &member);
}

static int parse_object(parser *p, int depth, taut_json_value *value)
{
    const size_t base = p->member_count;
    int more = !accept_char(p, '}');
    while (more) {
        if (!parse_member(p, depth)) {
            return 0;
        }
        more = accept_char(p, ',');
        if (!more && !accept_char(p, '}')) {
            return stop(&p->scan, p->scan.at, "this is not JSON: found %s, expected ',' or '}'");
        }
    }
    const size_t count = p->member_count - base;
    const taut_json_entry *members =
        move_to_pool(p, count > 0 ? p->members + base : NULL, count, sizeof *members);
    p->member_count = base;
    *value = (taut_json_value){TAUT_JSON_OBJECT, (uint32_t)count, {.members = members}};
    return members != NULL && check_twice(p, members, count);
}

/* Tells the pulse of what was scanned since; 0 where it is to end. */
static int tell(parser *p)
{
    const size_t bytes = (size_t)(p->scan.at - p->told);
    if (bytes < TOLD) {
        return 1;
    }
    p->told = p->scan.at;
    return !taut_pulse_beat(p->pulse, BYTE_WORK * (double)bytes);
}

static int parse_value(parser *p, int depth, taut_json_value *value)
{
    char c = '\0';
    if (!tell(p)) {
        return 0;
    }
    skip_space(&p->scan);
    if (p->scan.at == p->scan.end) {
        return stop(&p->scan, p->scan.end, NULL);
    }
    c = *p->scan.at;
    if (c == '"') {
        return scan_string(&p->scan, value);
    }
    if (c != '[' && c != '{') {
        return scan_word(&p->scan, value);
    }
    if (depth == TAUT_JSON_DEPTH_MAX) {
        _Static_assert(TAUT_JSON_DEPTH_MAX == 256, "the message says the limit");
        return stop_for(&p->scan, "depth", p->scan.at,
                        "lists and objects are nested too deep: more than 256 of them");
    }
    p->scan.at++;
    return c == '[' ? parse_array(p, depth + 1, value) : parse_object(p, depth + 1, value);
}

static int parse_all(parser *p, taut_json_value *root)
{
    skip_space(&p->scan);
    if (p->scan.at == p->scan.end) {
        return stop(&p->scan, p->scan.begin, "the document is empty, expected a JSON object");
    }
    if (!parse_value(p, 0, root)) {
        return 0;
    }
    skip_space(&p->scan);
    return p->scan.at == p->scan.end ||
           stop(&p->scan, p->scan.at, "after the end of the document comes %s");
}

/* What stands at a place, in quotes: a word, or one character. */
static void quote_place(const char *at, const char *end, char quoted[32])
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
static taut_status report_stop(const json_scan *scan, const char *name, taut_error *error)
{
    static const char between[] = ", expected ";
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
    if (ended || scan->sentence == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, "syntax", where, taut_none, taut_none,
                         "the text ends before the document does");
    }
    if (scan->place < scan->end) {
        quote_place(scan->place, scan->end, quoted);
    }
    const char *hole = strstr(scan->sentence, "%s");
    const int before =
        (int)(hole != NULL ? (size_t)(hole - scan->sentence) : strlen(scan->sentence));
    snprintf(message, sizeof message, "%.*s%s%s", before, scan->sentence,
             hole != NULL ? quoted : "", hole != NULL ? hole + 2 : "");
    char *wish = strstr(message, between);
    if (wish == NULL) {
        return taut_fail(error, TAUT_BAD_INPUT, scan->reason, where, taut_none, taut_none, "%s",
                         message);
    }
    *wish = '\0';
    return taut_fail_expected(error, TAUT_BAD_INPUT, scan->reason, where, taut_none,
                              wish + strlen(between), "%s", message);
}

taut_status taut_json_parse(const char *text, size_t length, const char *name, taut_pulse *pulse,
                            taut_json_document **document, taut_error *error)
{
    static const char mark[] = "\xef\xbb\xbf"; /* a byte order mark may be ignored: RFC 8259, 8.1 */
    const size_t skip = length >= 3 && memcmp(text, mark, 3) == 0 ? 3 : 0;
    const char *begin = length > 0 ? text + skip : "";
    taut_json_document *made = NULL;
    taut_status status = TAUT_OK;
    parser p = {.scan = {.begin = begin, .at = begin, .end = begin + (length - skip)},
                .pulse = pulse,
                .told = begin};

    if ((double)length > TAUT_FILE_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "size", NULL, (double)length, TAUT_FILE_MAX,
                         "a document of %zu bytes, expected at most %.0f", length, TAUT_FILE_MAX);
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    p.scan.pool = &made->pool;
    if (!parse_all(&p, &made->root)) {
        status = taut_pulse_is_stopped(pulse) ? taut_fail_status(error, TAUT_INTERRUPTED)
                 : p.scan.no_memory           ? taut_fail_memory(error)
                                              : report_stop(&p.scan, name, error);
    }
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
        free_pool(&document->pool);
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
