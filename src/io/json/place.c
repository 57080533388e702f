/* place.c -- the pointer of a place, and what is found there. */
#include "core/fail.h"
#include "core/number_text.h"
#include "io/json/in.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { DEPTH_MAX = 64, POINTER_ROOM = 192, SHOWN_KEY = 64 };

/* The bytes of `from` that fit into `room`, whole UTF-8 sequences only. */
static size_t whole_bytes(const char *from, size_t room)
{
    size_t length = strlen(from);
    if (length > room) {
        length = room;
        while (length > 0 && ((unsigned char)from[length] & 0xc0) == 0x80) {
            length--;
        }
    }
    return length;
}

/* Appends one step of a pointer: '~' and '/' escaped as RFC 6901 has it, control characters as JSON
 * has them, a name that is very long cut. Full is full. */
static size_t append_step(char *pointer, size_t n, const char *key)
{
    const size_t length = whole_bytes(key, SHOWN_KEY);
    char step[8 * SHOWN_KEY + 8];
    size_t k = 0;

    step[k++] = '/';
    for (size_t i = 0; i < length; i++) {
        const unsigned char byte = (unsigned char)key[i];
        if (byte == '~' || byte == '/') {
            step[k++] = '~';
            step[k++] = byte == '~' ? '0' : '1';
        } else if (byte < 0x20 || byte == 0x7f) {
            k += (size_t)snprintf(step + k, sizeof step - k, "\\u%04x", byte);
        } else {
            step[k++] = key[i];
        }
    }
    if (length < strlen(key)) {
        memcpy(step + k, "...", 3);
        k += 3;
    }
    step[k] = '\0';
    k = whole_bytes(step, POINTER_ROOM - 1 - n);
    memcpy(pointer + n, step, k);
    pointer[n + k] = '\0';
    return n + k;
}

/* The pointer of a place. A way too long is cut at its end. */
static void spell_pointer(const taut_json *at, char pointer[POINTER_ROOM])
{
    const taut_json *way[DEPTH_MAX];
    char index[32];
    size_t n = 0;
    int depth = 0;

    for (const taut_json *place = at; place->up != NULL; place = place->up) {
        if (depth == DEPTH_MAX) { /* keep the outer end */
            memmove(way, way + 1, (DEPTH_MAX - 1) * sizeof way[0]);
            depth--;
        }
        way[depth++] = place;
    }
    pointer[0] = '\0';
    while (depth > 0) {
        const taut_json *place = way[--depth];
        snprintf(index, sizeof index, "%zu", place->index);
        n = append_step(pointer, n, place->key != NULL ? place->key : index);
    }
}

/* A string in quotes, cut if it is long. */
static void describe_string(const char *string, char *text, size_t size)
{
    const size_t length = whole_bytes(string, SHOWN_KEY / 2);
    snprintf(text, size, "\"%.*s%s\"", (int)length, string, length < strlen(string) ? "..." : "");
    for (char *c = text; *c != '\0'; c++) {
        *c = (unsigned char)*c < 0x20 || *c == 0x7f ? '?' : *c;
    }
}

/* What is there, for a message. */
static void describe_value(const taut_json *at, char *text, size_t size)
{
    static const char *const kinds[] = {"nothing", "null", "false",    "true",
                                        NULL,      NULL,   "an array", "an object"};
    const taut_json_kind kind = taut_json_kind_at(at);
    char number[TAUT_NUMBER_ROOM];
    if (kind == TAUT_JSON_NUMBER) {
        taut_number_text(taut_json_number_at(at), number);
        snprintf(text, size, "%s", number);
    } else if (kind == TAUT_JSON_STRING) {
        describe_string(taut_json_text_at(at), text, size);
    } else if (kind == TAUT_JSON_ARRAY && taut_json_count_at(at) == 0) {
        snprintf(text, size, "an empty array");
    } else if (kind == TAUT_JSON_ARRAY) {
        snprintf(text, size, "an array of %zu", taut_json_count_at(at));
    } else {
        snprintf(text, size, "%s", kinds[kind]);
    }
}

static taut_status refuse_value(const taut_json *at, taut_error *error, const char *reason,
                                const char *expected, va_list arguments)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    char pointer[POINTER_ROOM], found[80], wish[200];

    vsnprintf(wish, sizeof wish, expected, arguments);
    spell_pointer(at, pointer);
    describe_value(at, found, sizeof found);
    return taut_fail_expected(
        error, TAUT_BAD_INPUT, kind == TAUT_JSON_MISSING ? "missing" : reason, pointer,
        kind == TAUT_JSON_NUMBER ? taut_json_number_at(at) : taut_none, wish, "found %s", found);
}

taut_status taut_json_refuse(const taut_json *at, taut_error *error, const char *reason,
                             const char *expected, ...)
{
    va_list arguments;
    taut_status status = TAUT_OK;
    va_start(arguments, expected);
    status = refuse_value(at, error, reason, expected, arguments);
    va_end(arguments);
    return status;
}

taut_status taut_json_expected(const taut_json *at, taut_error *error, const char *expected, ...)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    va_list arguments;
    taut_status status = TAUT_OK;
    va_start(arguments, expected);
    status = refuse_value(at, error,
                          kind == TAUT_JSON_NUMBER || kind == TAUT_JSON_ARRAY ? "value" : "type",
                          expected, arguments);
    va_end(arguments);
    return status;
}

taut_status taut_json_fail(const taut_json *at, taut_error *error, const char *reason, double found,
                           double limit, const char *format, ...)
{
    char pointer[POINTER_ROOM], sentence[sizeof error->message];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    spell_pointer(at, pointer);
    return taut_fail(error, TAUT_BAD_INPUT, reason, pointer, found, limit, "%s", sentence);
}

taut_status taut_json_within(const taut_json *at, taut_status status, taut_error *error)
{
    if (status != TAUT_OK && status != TAUT_NO_MEMORY) {
        char pointer[POINTER_ROOM];
        spell_pointer(at, pointer);
        taut_error_prefix(error, pointer);
    }
    return status;
}
