/* json_in.c -- parsing JSON text, and saying where it broke. */
#include "io/json_in.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/file_in.h"
#include "taut/limits.h"

#include <locale.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

/* Line and column, from 1, in characters. */
typedef struct text_place {
    int line, column;
} text_place;

/* "file:line:column" in error->where. Of a long name the end is kept. */
static taut_status fail_at(taut_error *error, const char *name, text_place place,
                           const char *message)
{
    char where[sizeof error->where];
    char numbers[32];
    size_t room = 0, length = strlen(name);
    const int digits = snprintf(numbers, sizeof numbers, ":%d:%d", place.line, place.column);

    room = sizeof where - 1 - (size_t)digits;
    if (length > room) {
        snprintf(where, sizeof where, "...%s%s", name + (length - room + 3), numbers);
    } else {
        snprintf(where, sizeof where, "%s%s", name, numbers);
    }
    for (char *c = where; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
    return taut_fail(error, TAUT_BAD_INPUT, where, taut_none, taut_none, "%s", message);
}

static text_place place_of(const char *text, size_t offset)
{
    text_place place = {1, 1};
    for (size_t i = 0; i < offset; i++) {
        if (text[i] == '\n') {
            place.line++;
            place.column = 1;
        } else if (((unsigned char)text[i] & 0xc0) != 0x80) { /* not inside a UTF-8 sequence */
            place.column++;
        }
    }
    return place;
}

/* jansson counts to the end of the token that surprised it, which its message quotes: step back to
 * where that token begins, if it is the one just read. */
static size_t token_start(const char *text, const json_error_t *broken)
{
    const size_t end = broken->position > 0 ? (size_t)broken->position : 0;
    const char *open = strstr(broken->text, " near '");
    const char *close = strrchr(broken->text, '\'');
    if (open != NULL && close >= open + 7) {
        const size_t length = (size_t)(close - open) - 7;
        if (length > 0 && length <= end && memcmp(text + end - length, open + 7, length) == 0) {
            return end - length;
        }
    }
    return end > 0 ? end - 1 : 0;
}

/* jansson's reason in our words. */
static taut_status fail_syntax(taut_error *error, const char *text, size_t length, const char *name,
                               const json_error_t *broken)
{
    const enum json_error_code code = json_error_code(broken);
    const int ended = strstr(broken->text, "near end of file") != NULL;
    char message[320];
    const char *rule = "";

    if (ended || code == json_error_premature_end_of_input) {
        return fail_at(error, name, place_of(text, length),
                       "the text ends before the document does");
    }
    if (code == json_error_duplicate_key) {
        rule = "a member is given twice: ";
    } else if (code == json_error_numeric_overflow) {
        rule = "a number does not fit double precision: ";
    } else if (code == json_error_stack_overflow) {
        rule = "lists and objects are nested too deep: ";
    } else if (code == json_error_end_of_input_expected) {
        rule = "text goes on after the end of the document: ";
    } else if (code == json_error_invalid_utf8) {
        rule = "the text is not UTF-8: ";
    } else {
        rule = "this is not JSON: ";
    }
    snprintf(message, sizeof message, "%s%s", rule, broken->text);
    for (char *c = message; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
    return fail_at(error, name, place_of(text, token_start(text, broken)), message);
}

static int is_blank(const char *text, size_t length)
{
    size_t i = 0;
    while (i < length && strchr(" \t\r\n", text[i]) != NULL && text[i] != '\0') {
        i++;
    }
    return i == length;
}

/* jansson says of some allocations that fail that the syntax is wrong, and of others nothing: a
 * number would lose its last digits. So its allocations are ours, as all others are, and one that
 * fails is remembered, each thread for itself, for the parse that is going on. */
static _Thread_local int ran_out;

static void *watched_alloc(size_t size)
{
    void *block = taut_alloc(size, 1);
    ran_out |= block == NULL;
    return block;
}

static void watch_memory(void)
{
    json_set_alloc_funcs(watched_alloc, taut_free);
}

/* NULL where the text is not JSON; or where memory ran out, and then *no_memory is set. jansson
 * reads numbers by the decimal point of the locale: this thread is put into the "C" locale
 * meanwhile. */
static json_t *parse(const char *text, size_t length, json_error_t *broken, int *no_memory)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    const size_t flags = JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL | JSON_DECODE_ANY;
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    locale_t before = (locale_t)0;
    json_t *root = NULL;

    pthread_once(&once, watch_memory);
    ran_out = plain == (locale_t)0;
    if (!ran_out) {
        before = uselocale(plain);
        root = json_loadb(text, length, flags, broken);
        uselocale(before);
        freelocale(plain);
    }
    if (ran_out) {
        json_decref(root);
        root = NULL;
    }
    *no_memory = ran_out;
    return root;
}

taut_status taut_json_load_text(const char *text, size_t length, const char *name, json_t **root,
                                taut_error *error)
{
    static const char mark[] = "\xef\xbb\xbf"; /* a byte order mark may be ignored: RFC 8259, 8.1 */
    const size_t skip = length >= 3 && memcmp(text, mark, 3) == 0 ? 3 : 0;
    const char *zero = length > 0 ? memchr(text, '\0', length) : NULL;
    json_error_t broken;
    json_t *parsed = NULL;
    int no_memory = 0;

    if ((double)length > TAUT_FILE_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, NULL, (double)length, TAUT_FILE_MAX,
                         "a document of %zu bytes, expected at most %.0f", length, TAUT_FILE_MAX);
    }
    if (zero != NULL) {
        return fail_at(error, name, place_of(text, (size_t)(zero - text)),
                       "this is not JSON: a byte that is 0, expected UTF-8 text");
    }
    if (is_blank(text + skip, length - skip)) {
        return fail_at(error, name, place_of(text, 0),
                       "the document is empty, expected a JSON object");
    }
    memset(&broken, 0, sizeof broken);
    parsed = parse(text + skip, length - skip, &broken, &no_memory);
    if (no_memory) {
        return taut_fail_memory(error);
    }
    if (parsed == NULL) {
        return fail_syntax(error, text + skip, length - skip, name, &broken);
    }
    *root = parsed;
    return TAUT_OK;
}

taut_status taut_json_load(const char *path, json_t **root, taut_error *error)
{
    char *text = NULL;
    size_t length = 0;
    taut_status status = taut_file_read(path, &text, &length, error);
    if (status == TAUT_OK) {
        status = taut_json_load_text(text, length, strcmp(path, "-") == 0 ? "standard input" : path,
                                     root, error);
    }
    taut_free(text);
    return status;
}
