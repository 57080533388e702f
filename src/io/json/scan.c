#include "io/json/scan.h"

#include "io/json/utf8.h"

#include <math.h>
#include <string.h>

int taut_json_stop(taut_json_scan *scan, const char *place, const char *reason)
{
    scan->place = place;
    scan->reason = reason;
    return 0;
}

int taut_json_stop_memory(taut_json_scan *scan)
{
    scan->no_memory = 1;
    return 0;
}

void taut_json_skip(taut_json_scan *scan)
{
    const char *at = scan->at;
    while (at < scan->end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t')) {
        at++;
    }
    scan->at = at;
}

/* Four hexadecimal digits; -1 if they are not. */
static long hex_digits(const char *at, const char *end)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    long value = 0;
    for (int i = 0; i < 4; i++) {
        const char *digit = at + i < end && at[i] != '\0' ? strchr(digits, at[i]) : NULL;
        if (digit == NULL) {
            return -1;
        }
        value = 16 * value + (digit - digits) % 16;
    }
    return value;
}

/* Appends a code point as UTF-8; returns its length. */
static size_t put_utf8(long code, char *out)
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
static int scan_code(taut_json_scan *scan, const char **at, char *out, size_t *length)
{
    const char *from = *at, *next = from + 6;
    long code = hex_digits(from + 2, scan->end);
    if (code >= 0xd800 && code <= 0xdfff) { /* half of a pair */
        const int paired = scan->end - next >= 6 && next[0] == '\\' && next[1] == 'u';
        const long low = code < 0xdc00 && paired ? hex_digits(next + 2, scan->end) : -1;
        code = low >= 0xdc00 && low <= 0xdfff ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00)
                                              : -1;
        next += 6;
    }
    if (code <= 0) {
        return taut_json_stop(scan, from, "this is not JSON: %s is no character of a string");
    }
    *length = put_utf8(code, out);
    *at = next;
    return 1;
}

/* One escape at *at; moves past it. */
static int scan_escape(taut_json_scan *scan, const char **at, char *out, size_t *length)
{
    static const char letters[] = "\"\\/bfnrt", meanings[] = "\"\\/\b\f\n\r\t";
    const char letter = scan->end - *at >= 2 ? (*at)[1] : '\0';
    const char *known = letter != '\0' ? strchr(letters, letter) : NULL;
    if (letter == 'u') {
        return scan_code(scan, at, out, length);
    }
    if (known == NULL) {
        return taut_json_stop(scan, *at, "this is not JSON: %s is no escape of a string");
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

int taut_json_scan_string(taut_json_scan *scan, taut_json_value *value)
{
    const char *at = scan->at + 1;
    const char *close = closing_quote(at, scan->end);
    char *string = NULL;
    size_t n = 0;

    if (close == scan->end) {
        return taut_json_stop(scan, scan->end, NULL);
    }
    if (*close != '"') {
        return taut_json_stop(scan, close, "this is not JSON: a control character in a string");
    }
    string = taut_pool_take(scan->pool, (size_t)(close - at) + 1, 1); /* unescaping only shortens */
    if (string == NULL) {
        return taut_json_stop_memory(scan);
    }
    while (at < close) {
        size_t length = taut_utf8_length(at, (size_t)(close - at));
        if (*at == '\\') {
            if (!scan_escape(scan, &at, string + n, &length)) {
                return 0;
            }
        } else if (length == 0) {
            return taut_json_stop(scan, at, "the text is not UTF-8");
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

int taut_json_scan_word(taut_json_scan *scan, taut_json_value *value)
{
    static const struct {
        const char *word;
        taut_json_kind kind;
    } words[3] = {{"null", TAUT_JSON_NULL}, {"true", TAUT_JSON_TRUE}, {"false", TAUT_JSON_FALSE}};
    const size_t room = (size_t)(scan->end - scan->at);
    const size_t number = taut_number_length(scan->at, room);
    const char *after = scan->at + number;
    double x = 0;

    if (number > 0 && word_length(after, scan->end) == 0) {
        if (!taut_number_value(scan->at, number, &scan->plain, &x)) {
            return taut_json_stop_memory(scan);
        }
        if (!isfinite(x)) {
            return taut_json_stop(scan, scan->at, "%s does not fit double precision");
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
    return taut_json_stop(scan, scan->at, "this is not JSON: found %s, expected a value");
}
