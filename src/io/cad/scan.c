#include "io/cad/scan.h"

#include "core/fail.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { DEPTH_MAX = 100, EXPONENT_MAX = 308 };

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The whole part of a decimal logarithm: the number of digits before the point from the first that
 * is not 0 on, or less than nothing the zeros after the point; *seen if any is not 0. */
static size_t read_digits(const char *text, size_t room, int64_t *magnitude, int *seen)
{
    size_t i = 0, digits = 0;
    int point = 0;
    for (; i < room && (is_digit(text[i]) || (text[i] == '.' && !point)); i++) {
        if (text[i] == '.') {
            point = 1;
        } else {
            digits++;
            *seen |= text[i] != '0';
            *magnitude += *seen && !point;
            *magnitude -= !*seen && point;
        }
    }
    return digits > 0 ? i : 0;
}

size_t taut_cad_number(const char *text, size_t room, const char *exponents, int *is_huge)
{
    int64_t magnitude = 0, exponent = 0;
    int seen = 0, sign = 1;
    size_t i = room > 0 && (text[0] == '+' || text[0] == '-') ? 1 : 0, digits = 0;
    const size_t length = read_digits(text + i, room - i, &magnitude, &seen);
    if (length == 0) {
        return 0;
    }
    i += length;
    if (i < room && text[i] != '\0' && strchr(exponents, text[i]) != NULL) {
        i++;
        if (i < room && (text[i] == '+' || text[i] == '-')) {
            sign = text[i] == '-' ? -1 : 1;
            i++;
        }
        for (; i < room && is_digit(text[i]); i++, digits++) {
            exponent = exponent < 100000000 ? 10 * exponent + (text[i] - '0') : exponent;
        }
        if (digits == 0) {
            return 0;
        }
    }
    *is_huge = seen && magnitude + sign * exponent > EXPONENT_MAX;
    return i;
}

/* Where in the text we are. */
typedef struct scan {
    const char *text;
    size_t length, at;
    size_t line;   /* from 1 */
    int depth;     /* parentheses that are open */
    int has_ended; /* the mark of the end was there */
} scan;

static int is_letter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '!';
}

static int is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

static char peek(const scan *s, size_t ahead)
{
    return ahead < s->length - s->at ? s->text[s->at + ahead] : '\0';
}

static taut_status refuse_line(const scan *s, const char *what, taut_error *error)
{
    char where[32];
    snprintf(where, sizeof where, "line %zu", s->line);
    return taut_fail(error, TAUT_BAD_INPUT, "broken", where, taut_none, taut_none, "%s", what);
}

static void advance(scan *s, size_t count)
{
    for (; count > 0 && s->at < s->length; count--) {
        s->line += s->text[s->at] == '\n';
        s->at++;
    }
}

/* Past the next `mark`, which closes what begins here; 0 if there is none. */
static int skip_past(scan *s, size_t opening, const char *mark)
{
    const size_t size = strlen(mark);
    advance(s, opening);
    while (s->length - s->at >= size) {
        if (memcmp(s->text + s->at, mark, size) == 0) {
            advance(s, size);
            return 1;
        }
        advance(s, 1);
    }
    return 0;
}

/* Past blanks and comments; 0 if a comment is not closed. */
static int skip_blanks(scan *s)
{
    int closed = 1;
    while (closed && s->at < s->length) {
        if (is_space(peek(s, 0))) {
            advance(s, 1);
        } else if (peek(s, 0) == '/' && peek(s, 1) == '*') {
            closed = skip_past(s, 2, "*/");
        } else {
            return 1;
        }
    }
    return closed;
}

static taut_status scan_number(scan *s, taut_error *error)
{
    int is_huge = 0;
    const size_t size = taut_cad_number(s->text + s->at, s->length - s->at, "Ee", &is_huge);
    if (size == 0) {
        return refuse_line(s, "half a number", error);
    }
    if (is_huge) {
        return refuse_line(s, "a number of 1e308 or more", error);
    }
    advance(s, size);
    return TAUT_OK;
}

/* NAN and INF are keywords too: what has no parentheses is no value. */
static taut_status scan_keyword(scan *s, taut_error *error)
{
    static const char end[] = "END-ISO-10303-21";
    const size_t begin = s->at;
    while (is_letter(peek(s, 0)) || is_digit(peek(s, 0)) || peek(s, 0) == '-') {
        advance(s, 1);
    }
    const size_t size = s->at - begin;
    if (!skip_blanks(s)) {
        return refuse_line(s, "a comment that does not end", error);
    }
    if (s->depth > 0 && peek(s, 0) != '(') {
        return refuse_line(s, "found a word where a value is expected", error);
    }
    if (s->depth == 0 && size == strlen(end) && memcmp(s->text + begin, end, size) == 0 &&
        peek(s, 0) == ';') {
        s->has_ended = 1;
    }
    return TAUT_OK;
}

static taut_status scan_mark(scan *s, taut_error *error)
{
    const char c = peek(s, 0);
    s->depth += (c == '(') - (c == ')');
    if (s->depth < 0 || (c == ';' && s->depth > 0)) {
        return refuse_line(s, "parentheses that do not match", error);
    }
    if (s->depth > DEPTH_MAX) {
        return refuse_line(s, "more than 100 parentheses in one another", error);
    }
    if (c == '\0') {
        return refuse_line(s, "a byte that is 0", error);
    }
    advance(s, 1);
    return TAUT_OK;
}

static taut_status scan_token(scan *s, taut_error *error)
{
    const char c = peek(s, 0);
    if (c == '\'' || c == '"') {
        return skip_past(s, 1, c == '"' ? "\"" : "'")
                   ? TAUT_OK
                   : refuse_line(s, "a string that does not end", error);
    }
    if (c == '.' && is_letter(peek(s, 1))) {
        return skip_past(s, 1, ".") ? TAUT_OK
                                    : refuse_line(s, "an enumeration that does not end", error);
    }
    if (is_letter(c)) {
        return scan_keyword(s, error);
    }
    if (c == '#' && is_digit(peek(s, 1))) {
        for (advance(s, 1); is_digit(peek(s, 0)); advance(s, 1)) {
        }
        return TAUT_OK;
    }
    if (is_digit(c) || c == '+' || c == '-') {
        return scan_number(s, error);
    }
    return scan_mark(s, error);
}

taut_status taut_cad_scan_step(const char *text, size_t length, taut_error *error)
{
    static const char begin[] = "ISO-10303-21;";
    scan s = {.text = text, .length = length, .line = 1};
    taut_status status = TAUT_OK;

    if (!skip_blanks(&s) || length - s.at < strlen(begin) ||
        memcmp(text + s.at, begin, strlen(begin)) != 0) {
        return refuse_line(&s, "this is no STEP file: it does not begin with ISO-10303-21;", error);
    }
    while (status == TAUT_OK && !s.has_ended) {
        if (!skip_blanks(&s)) {
            status = refuse_line(&s, "a comment that does not end", error);
        } else if (s.at == s.length) {
            status = refuse_line(&s, "the file is broken off: END-ISO-10303-21; is missing", error);
        } else {
            status = scan_token(&s, error);
        }
    }
    return status;
}
