#include "io/step/part21.h"

#include "core/number_text.h"
#include "io/json/utf8.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { LINE = 72 };

static void put_bytes(taut_part21 *out, const char *bytes, size_t length)
{
    taut_sink_bytes(&out->sink, bytes, length);
    out->column += length;
}

static void put_word(taut_part21 *out, const char *text)
{
    put_bytes(out, text, strlen(text));
}

static void put_count(taut_part21 *out, size_t n)
{
    char digits[24];
    size_t at = sizeof digits;
    do {
        digits[--at] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    put_bytes(out, digits + at, sizeof digits - at);
}

static void put_ref(taut_part21 *out, size_t ref)
{
    put_bytes(out, "#", 1);
    put_count(out, ref);
}

static void put_real(taut_part21 *out, double x)
{
    char text[TAUT_NUMBER_ROOM];
    const size_t length = taut_number_text(x, text), digits = strcspn(text, "e");
    put_bytes(out, text, digits);
    if (memchr(text, '.', digits) == NULL) {
        put_bytes(out, ".", 1);
    }
    if (digits < length) {
        put_bytes(out, "E", 1);
        put_bytes(out, text + digits + 1, length - digits - 1);
    }
}

/* The character of a sequence of 2 to 4 bytes. */
static uint64_t decode(const char *bytes, size_t length)
{
    uint64_t code = (unsigned char)bytes[0] & (0xffU >> (length + 1));
    for (size_t i = 1; i < length; i++) {
        code = code << 6 | ((unsigned char)bytes[i] & 0x3fU);
    }
    return code;
}

static void put_character(taut_part21 *out, const char *bytes, size_t length)
{
    const unsigned char c = (unsigned char)bytes[0];
    char text[24];
    if (length == 0) {
        put_word(out, "?");
    } else if (length == 1 && (c == '\'' || c == '\\')) {
        put_bytes(out, bytes, 1);
        put_bytes(out, bytes, 1);
    } else if (length == 1 && c >= 0x20 && c < 0x7f) {
        put_bytes(out, bytes, 1);
    } else {
        const uint64_t code = length == 1 ? c : decode(bytes, length);
        snprintf(text, sizeof text,
                 length == 1   ? "\\X\\%02" PRIX64
                 : length == 4 ? "\\X4\\%08" PRIX64 "\\X0\\"
                               : "\\X2\\%04" PRIX64 "\\X0\\",
                 code);
        put_word(out, text);
    }
}

/* OpenCASCADE takes a quote before a comma or a bracket for the end of the string, doubled or not. */
static int looks_like_end(const char *text)
{
    const char after = text[0] == '\'' ? text[1 + strspn(text + 1, " \n\r")] : '\0';
    return after == ')' || after == ',';
}

static void put_text(taut_part21 *out, const char *text)
{
    const size_t length = strlen(text);
    size_t i = 0;
    put_bytes(out, "'", 1);
    while (i < length) {
        const size_t step = taut_utf8_length(text + i, length - i);
        if (looks_like_end(text + i)) {
            put_word(out, "\\X\\27");
        } else {
            put_character(out, text + i, step);
        }
        i += step > 0 ? step : 1;
    }
    put_bytes(out, "'", 1);
}

/* A comma between members, and a new line where the old one is full. */
static void begin_member(taut_part21 *out, int is_first)
{
    if (!is_first) {
        put_bytes(out, ",", 1);
    }
    if (!is_first && out->column > LINE) {
        put_bytes(out, "\n", 1);
        out->column = 0;
    }
}

static void put_list(taut_part21 *out, const taut_part21_value *value, size_t first)
{
    const int is_refs = value->kind == PART21_REFS;
    put_bytes(out, "(", 1);
    for (size_t i = 0; i < value->count; i++) {
        begin_member(out, i == 0);
        if (value->reals != NULL) {
            put_real(out, value->reals[first + i * value->step]);
        } else {
            put_ref(out, is_refs ? value->refs[i] : value->ref + first + i * value->step);
        }
    }
    put_bytes(out, ")", 1);
}

/* Rows of a grid of references or of reals, one after the other. */
static void put_rows(taut_part21 *out, const taut_part21_value *value)
{
    taut_part21_value row = *value;
    row.count = value->across;
    row.step = 1;
    put_bytes(out, "(", 1);
    for (size_t i = 0; i < value->count; i++) {
        begin_member(out, i == 0);
        put_list(out, &row, i * value->step);
    }
    put_bytes(out, ")", 1);
}

/* Distinct knots, or how often each is there. */
static void put_knots(taut_part21 *out, const taut_part21_value *value)
{
    size_t i = 0;
    put_bytes(out, "(", 1);
    while (i < value->count) {
        size_t times = 1;
        while (i + times < value->count && value->reals[i + times] == value->reals[i]) {
            times++;
        }
        begin_member(out, i == 0);
        if (value->kind == PART21_KNOTS) {
            put_real(out, value->reals[i]);
        } else {
            put_count(out, times + (i == 0) + (i + times == value->count));
        }
        i += times;
    }
    put_bytes(out, ")", 1);
}

static void put_value(taut_part21 *out, const taut_part21_value *value)
{
    switch (value->kind) {
    case PART21_REF:
        put_ref(out, value->ref);
        break;
    case PART21_NUMBER:
        put_count(out, value->count);
        break;
    case PART21_REAL:
        put_real(out, value->real);
        break;
    case PART21_TEXT:
        put_text(out, value->text);
        break;
    case PART21_WORD:
        put_word(out, value->text);
        break;
    case PART21_REFS:
    case PART21_RUN:
    case PART21_REALS:
        put_list(out, value, 0);
        break;
    case PART21_GRID:
    case PART21_TABLE:
        put_rows(out, value);
        break;
    case PART21_KNOTS:
    case PART21_TIMES:
        put_knots(out, value);
        break;
    }
}

void taut_part21_put(taut_part21 *out, const char *format, const taut_part21_value *values)
{
    for (const char *at = format; *at != '\0';) {
        const size_t plain = strcspn(at, "%");
        put_bytes(out, at, plain);
        at += plain;
        if (*at == '%') {
            put_value(out, values++);
            at++;
        }
    }
}

size_t taut_part21_new(taut_part21 *out, const char *format, const taut_part21_value *values)
{
    out->column = 0;
    out->count++;
    put_ref(out, out->count);
    put_bytes(out, "=", 1);
    taut_part21_put(out, format, values);
    put_bytes(out, ";\n", 2);
    return out->count;
}
