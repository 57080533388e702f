#include "io/dxf/pairs.h"

#include "core/fail.h"
#include "io/json/number_value.h"
#include "io/json/utf8.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { NUMBER_ROOM = 400, CODE_MAX = 1071 };

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* The next line, without white space around; *at is moved behind it. */
static taut_dxf_pair next_line(const char *text, size_t length, size_t *at)
{
    const char *end = memchr(text + *at, '\n', length - *at);
    size_t from = *at, to = end != NULL ? (size_t)(end - text) : length;
    *at = end != NULL ? to + 1 : length;
    while (from < to && is_blank(text[from])) {
        from++;
    }
    while (to > from && is_blank(text[to - 1])) {
        to--;
    }
    return (taut_dxf_pair){.value = text + from, .length = to - from};
}

static taut_status broken(size_t line, const char *what, taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "broken", NULL, (double)line, taut_none,
                     "line %zu: %s, as no DXF file has it", line, what);
}

/* A whole number up to CODE_MAX; -1. */
static int code_of(const taut_dxf_pair *line)
{
    int code = 0;
    for (size_t i = 0; i < line->length; i++) {
        if (line->value[i] < '0' || line->value[i] > '9' || code > CODE_MAX) {
            return -1;
        }
        code = 10 * code + line->value[i] - '0';
    }
    return line->length > 0 && code <= CODE_MAX ? code : -1;
}

taut_status taut_dxf_split(const char *text, size_t length, taut_arena *arena,
                           taut_dxf_pairs *pairs, taut_error *error)
{
    size_t lines = 0, at = 0, line = 0;
    for (size_t i = 0; i < length; i++) {
        lines += text[i] == '\n';
    }
    taut_dxf_pair *made = taut_arena_take(arena, lines / 2 + 1, sizeof *made);
    if (made == NULL) {
        return taut_fail_memory(error);
    }
    *pairs = (taut_dxf_pairs){.at = made};
    while (at < length) {
        const taut_dxf_pair first = next_line(text, length, &at);
        const int code = code_of(&first);
        line++;
        if (at >= length && first.length == 0) {
            break; /* an empty line at the end */
        }
        if (code < 0) {
            return broken(line, "there is no code", error);
        }
        if (at >= length) {
            return broken(line, "a code without a value ends the file", error);
        }
        taut_dxf_pair *pair = &made[pairs->count++];
        *pair = next_line(text, length, &at);
        pair->code = code;
        pair->line = ++line;
        if (taut_dxf_is(pair, 0, "EOF")) {
            return TAUT_OK;
        }
    }
    return broken(line, "the file is cut off: there is no EOF", error);
}

int taut_dxf_is(const taut_dxf_pair *pair, int code, const char *value)
{
    return pair->code == code && pair->length == strlen(value) &&
           memcmp(pair->value, value, pair->length) == 0;
}

/* What other programs write for numbers, "+1", ".5", "-.5", "1.", as JSON spells them. */
static size_t spell(const taut_dxf_pair *pair, char *out)
{
    size_t n = 0;
    for (size_t i = pair->length > 0 && pair->value[0] == '+'; i < pair->length; i++) {
        const char c = pair->value[i];
        const char before = n > 0 ? out[n - 1] : '-';
        const char after = i + 1 < pair->length ? pair->value[i + 1] : 'e';
        const int bare = c == '.' && (after < '0' || after > '9');
        if (c == '.' && (before < '0' || before > '9')) {
            out[n++] = '0';
        }
        out[n++] = c;
        if (bare) {
            out[n++] = '0';
        }
    }
    return n;
}

taut_status taut_dxf_number(const taut_dxf_pair *pair, double *value, taut_error *error)
{
    char spelled[2 * NUMBER_ROOM];
    size_t from = 0;
    if (pair->length == 0 || pair->length > NUMBER_ROOM / 2) {
        return broken(pair->line, "there is no number", error);
    }
    const size_t length = spell(pair, spelled);
    const size_t sign = spelled[0] == '-';
    while (sign + from + 1 < length && spelled[sign + from] == '0' &&
           spelled[sign + from + 1] >= '0' && spelled[sign + from + 1] <= '9') {
        from++; /* 007 */
    }
    if (from > 0) {
        memmove(spelled + sign, spelled + sign + from, length - sign - from);
    }
    if (taut_number_length(spelled, length - from) != length - from) {
        return broken(pair->line, "there is no number", error);
    }
    *value = taut_number_value(spelled, length - from);
    return isfinite(*value) ? TAUT_OK : broken(pair->line, "the number is too large", error);
}

const taut_dxf_pair *taut_dxf_first(taut_dxf_pairs pairs, int code)
{
    for (size_t i = 0; i < pairs.count; i++) {
        if (pairs.at[i].code == code) {
            return &pairs.at[i];
        }
    }
    return NULL;
}

taut_status taut_dxf_find(taut_dxf_pairs pairs, int code, double *value, taut_error *error)
{
    const taut_dxf_pair *pair = taut_dxf_first(pairs, code);
    return pair != NULL ? taut_dxf_number(pair, value, error) : TAUT_OK;
}

taut_status taut_dxf_find_point(taut_dxf_pairs pairs, int code, double point[3], taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        status = taut_dxf_find(pairs, code + 10 * k, &point[k], error);
    }
    return status;
}

/* The four hexadecimal digits of \U+XXXX; -1. */
static int escaped(const char *text, size_t room)
{
    int code = 0;
    if (room < 7 || memcmp(text, "\\U+", 3) != 0) {
        return -1;
    }
    for (int i = 3; i < 7; i++) {
        const char c = text[i];
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                                 : -1;
        if (digit < 0) {
            return -1;
        }
        code = 16 * code + digit;
    }
    return code;
}

static size_t encode(int code, char out[4])
{
    if (code < 0x20 || code == 0x7f || (code >= 0xd800 && code < 0xe000)) {
        out[0] = code < 0x80 ? ' ' : '?';
        return 1;
    }
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        out[0] = (char)(0xc0 | code >> 6);
        out[1] = (char)(0x80 | (code & 0x3f));
        return 2;
    }
    out[0] = (char)(0xe0 | code >> 12);
    out[1] = (char)(0x80 | (code >> 6 & 0x3f));
    out[2] = (char)(0x80 | (code & 0x3f));
    return 3;
}

void taut_dxf_name(const taut_dxf_pair *pair, char *name, size_t room)
{
    size_t n = 0, i = 0;
    while (i < pair->length) {
        const char *text = pair->value + i;
        const size_t left = pair->length - i, step = taut_utf8_length(text, left);
        const int code = escaped(text, left);
        char bytes[4];
        size_t count = 0;
        if (code >= 0) {
            count = encode(code, bytes);
        } else if (step > 1) {
            memcpy(bytes, text, step);
            count = step;
        } else {
            count = encode((unsigned char)text[0], bytes);
        }
        if (n + count >= room) {
            break;
        }
        memcpy(name + n, bytes, count);
        n += count;
        i += code >= 0 ? 7 : step > 1 ? step : 1;
    }
    name[n] = '\0';
}
