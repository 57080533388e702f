/* test_json.c -- the parser against jansson, another one: on texts that are JSON, nearly, or not at
 * all, both must say the same, and where they accept, the trees must be the same.
 * links: jansson
 */
#include "check.h"

#include "io/json/number_value.h"
#include "io/json/tree.h"

#include <jansson.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_ROOM = 4096 };

static int same_tree(const taut_json_value *a, json_t *b);

static int same_members(const taut_json_value *a, json_t *b)
{
    size_t i = 0;
    const char *key = NULL;
    json_t *value = NULL;
    if (a->count != json_object_size(b)) {
        return 0;
    }
    json_object_foreach(b, key, value)
    {
        if (strcmp(a->as.members[i].key, key) != 0 || taut_json_find(a, key) == NULL ||
            !same_tree(&a->as.members[i].value, value)) {
            return 0;
        }
        i++;
    }
    return 1;
}

static int same_tree(const taut_json_value *a, json_t *b)
{
    static const taut_json_kind kinds[] = {
        [JSON_OBJECT] = TAUT_JSON_OBJECT, [JSON_ARRAY] = TAUT_JSON_ARRAY,
        [JSON_STRING] = TAUT_JSON_STRING, [JSON_INTEGER] = TAUT_JSON_NUMBER,
        [JSON_REAL] = TAUT_JSON_NUMBER,   [JSON_TRUE] = TAUT_JSON_TRUE,
        [JSON_FALSE] = TAUT_JSON_FALSE,   [JSON_NULL] = TAUT_JSON_NULL};
    const double x = json_number_value(b);
    if (a->kind != kinds[json_typeof(b)]) {
        return 0;
    }
    if (a->kind == TAUT_JSON_NUMBER) {
        return memcmp(&a->as.number, &x, sizeof x) == 0;
    }
    if (a->kind == TAUT_JSON_STRING) {
        return a->count == json_string_length(b) && strcmp(a->as.string, json_string_value(b)) == 0;
    }
    if (a->kind == TAUT_JSON_OBJECT) {
        return same_members(a, b);
    }
    for (size_t i = 0; a->kind == TAUT_JSON_ARRAY && i < a->count; i++) {
        if (!same_tree(&a->as.items[i], json_array_get(b, i))) {
            return 0;
        }
    }
    return a->kind != TAUT_JSON_ARRAY || a->count == json_array_size(b);
}

/* Both parsers on one text; 1 if they accept it. */
static int compare(const char *text, size_t length)
{
    const size_t flags = JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL | JSON_DECODE_ANY;
    json_error_t broken;
    json_t *other = json_loadb(text, length, flags, &broken);
    taut_json_document *document = NULL;
    taut_error error = {.status = TAUT_OK};
    const taut_status status = taut_json_parse(text, length, "text", NULL, &document, &error);
    const int accepted = status == TAUT_OK;

    CHECK(accepted == (other != NULL), "we say \"%s %s\", jansson \"%s\", of %.*s", error.where,
          error.message, other == NULL ? broken.text : "", (int)length, text);
    if (accepted && other != NULL) {
        CHECK(same_tree(taut_json_document_root(document), other), "trees differ: %.*s",
              (int)length, text);
    }
    json_decref(other);
    taut_json_document_free(document);
    return accepted;
}

static void append(char *text, size_t *n, const char *more)
{
    const size_t length = strlen(more);
    if (*n + length < TEXT_ROOM) {
        memcpy(text + *n, more, length + 1);
        *n += length;
    }
}

static const char *any_of(const char *const *pieces, int count)
{
    return pieces[random_int(0, count - 1)];
}

static void append_string(char *text, size_t *n)
{
    static const char *const pieces[] = {
        "a",    "key",         " ",       "\\n",      "\\\"",           "\\\\",
        "\\/",  "\\u00e9",     "\\u20ac", "\xc3\xa9", "\\ud83d\\ude00", "\xf0\x9f\x98\x80",
        "\x7f", "\\b\\f\\r\\t"};
    append(text, n, "\"");
    for (int i = random_int(0, 3); i > 0; i--) {
        append(text, n, any_of(pieces, 14));
    }
    append(text, n, "\"");
}

static void append_number(char *text, size_t *n)
{
    static const char *const pieces[] = {
        "0",      "-0",    "1", "-12.5", "1e5", "1E-5", "0.1e+2", "123456789012345678901234567890",
        "5e-324", "1e-400"};
    char number[64];
    if (random_int(0, 1) == 0) {
        append(text, n, any_of(pieces, 10));
    } else {
        snprintf(number, sizeof number, "%.*g", random_int(1, 20),
                 random_in(-1, 1) * pow(10, random_int(-40, 40)));
        append(text, n, number);
    }
}

/* A random value, a few levels deep. */
static void append_value(char *text, size_t *n, int depth)
{
    static const char *const words[] = {"null", "true", "false"};
    static const char *const spaces[] = {"", "", " ", "\n", "\t\r\n "};
    const int pick = random_int(0, depth > 0 ? 5 : 3);
    append(text, n, any_of(spaces, 5));
    if (pick < 2) {
        append_number(text, n);
    } else if (pick == 2) {
        append_string(text, n);
    } else if (pick == 3) {
        append(text, n, any_of(words, 3));
    } else {
        append(text, n, pick == 4 ? "[" : "{");
        for (int i = random_int(0, 4); i > 0; i--) {
            if (pick == 5) {
                append_string(text, n);
                append(text, n, ":");
            }
            append_value(text, n, depth - 1);
            append(text, n, i > 1 ? "," : "");
        }
        append(text, n, pick == 4 ? "]" : "}");
    }
    append(text, n, any_of(spaces, 5));
}

/* Random documents, and the same with some bytes changed, dropped or doubled. */
static void test_against_jansson(void)
{
    static const char bytes[] = "{}[]:,\"\\ \n0123456789.eE+-tfnul\x80\xc3\xff\x01/";
    int accepted = 0, refused = 0;
    for (int trial = 0; trial < 40000; trial++) {
        char text[TEXT_ROOM];
        size_t n = 0;
        append_value(text, &n, 3);
        for (int i = random_int(0, 2); i > 0 && n > 0; i--) {
            const size_t at = (size_t)random_int(0, (int)n - 1);
            const int kind = random_int(0, 2);
            if (kind == 0) {
                text[at] = bytes[random_int(0, (int)sizeof bytes - 2)];
            } else if (kind == 1) {
                memmove(text + at, text + at + 1, n - at - 1);
                n--;
            } else if (n + 1 < TEXT_ROOM) {
                memmove(text + at + 1, text + at, n - at);
                n++;
            }
        }
        if (compare(text, n)) {
            accepted++;
        } else {
            refused++;
        }
    }
    CHECK(accepted > 5000 && refused > 5000, "%d accepted, %d refused", accepted, refused);
}

/* Objects of many members, with and without one that comes twice. */
static void test_many_members(void)
{
    for (int count = 1; count < 200; count += random_int(1, 9)) {
        for (int twice = 0; twice < 2; twice++) {
            char text[TEXT_ROOM];
            size_t n = 0;
            append(text, &n, "{");
            for (int i = 0; i < count; i++) {
                char member[32];
                snprintf(member, sizeof member, "%s\"%d\":0", i > 0 ? "," : "",
                         twice && i == count - 1 ? random_int(0, count - 1) : i * 7919);
                append(text, &n, member);
            }
            append(text, &n, "}");
            compare(text, n);
        }
    }
}

/* The deepest that is read, and one more. */
static void test_depth(void)
{
    char text[2 * TAUT_JSON_DEPTH_MAX + 4];
    for (int extra = 0; extra < 2; extra++) {
        const size_t depth = TAUT_JSON_DEPTH_MAX + (size_t)extra;
        taut_json_document *document = NULL;
        memset(text, '[', depth);
        memset(text + depth, ']', depth);
        CHECK((taut_json_parse(text, 2 * depth, "text", NULL, &document, NULL) == TAUT_OK) ==
                  !extra,
              "depth %zu", depth);
        taut_json_document_free(document);
    }
}

/* A decimal as strtod reads it. */
static void check_decimal(const char *text)
{
    const double expected = strtod(text, NULL);
    const size_t length = strlen(text);
    const double found = taut_number_value(text, length);
    CHECK(taut_number_length(text, length) == length, "%s is a number", text);
    CHECK(memcmp(&found, &expected, sizeof found) == 0, "%s: found %a, expected %a", text, found,
          expected);
}

/* Decimals of all lengths and sizes; those half way between two doubles, and beside it. */
static void test_decimals(void)
{
    char text[900];
    for (int i = 0; i < 200000; i++) {
        const int digits = random_int(1, 21);
        size_t n = 0;
        for (int k = 0; k < digits; k++) {
            text[n++] = (char)('0' + random_int(k == 0, 9));
            if (k == 0 && digits > 1) {
                text[n++] = '.';
            }
        }
        sprintf(text + n, "e%d",
                random_int(0, 3) > 0 ? random_int(-30, 30) : random_int(-330, 330));
        check_decimal(text);
    }
    for (int i = 0; i < 50000; i++) {
        /* (2 m + 1) / 2^q with m of 53 bits lies half way; written out in full it has too many
         * digits for short ways, so q is small or the digits are cut */
        const uint64_t m = (random_bits() >> 11) | (uint64_t)1 << 52;
        snprintf(text, sizeof text, "%.*f", random_int(0, 60),
                 ldexp((double)m, -random_int(0, 60)));
        check_decimal(text);
        snprintf(text, sizeof text, "%llu.5", (unsigned long long)m);
        check_decimal(text);
        snprintf(text, sizeof text, "%llu.25", (unsigned long long)(m >> 1));
        check_decimal(text);
        snprintf(text, sizeof text, "%llu.75", (unsigned long long)(m >> 1));
        check_decimal(text);
        snprintf(text, sizeof text, "%llu.250000001", (unsigned long long)(m >> 10));
        check_decimal(text);
    }
    check_decimal("9007199254740993");
    check_decimal("9007199254740993.0");
    check_decimal("-0.0e-5");
    check_decimal("0e99999999999999999999");
    check_decimal("1e-99999999999999999999");
    check_decimal("2.2250738585072011e-308");
    check_decimal("1.7976931348623158e308");
    check_decimal("18446744073709551615e-27");
    check_decimal("9999999999999999999e-27");
    memset(text, '7', 800);
    text[1] = '.';
    text[800] = '\0';
    check_decimal(text);
}

int main(void)
{
    random_seed(20240615);
    test_against_jansson();
    test_many_members();
    test_depth();
    test_decimals();
    return check_failures != 0;
}
