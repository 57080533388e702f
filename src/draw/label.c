#include "draw/label.h"

#include "core/elementary/elementary.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void taut_label_fixed(double value, int decimals, char *text, size_t size)
{
    static const char minus[] = "\xe2\x88\x92"; /* U+2212 */
    const double unit = taut_pow(10, decimals);
    const int64_t scaled = llround(fabs(value) * unit);
    const int64_t whole = scaled / (int64_t)unit;
    int64_t part = scaled % (int64_t)unit;
    const char *sign = value < 0 && scaled > 0 ? minus : "";

    char digits[12] = "";

    assert(decimals >= 0 && decimals <= 9);
    for (int i = decimals; i > 0; i--, part /= 10) {
        digits[i] = (char)('0' + part % 10);
        digits[0] = '.';
    }
    snprintf(text, size, "%s%" PRId64 "%s", sign, whole, digits);
}

void taut_label_number(double value, char *text, size_t size)
{
    char digits[48];
    const int e = value < 0 || value > 0 ? (int)floor(taut_log10(fabs(value)) + 1e-9) : 0;
    if (!isfinite(value)) {
        snprintf(text, size, "?");
    } else if (e >= -3 && e <= 5) {
        taut_label_fixed(value, e < 2 ? 2 - e : 0, text, size);
    } else {
        taut_label_fixed(value / taut_pow(10, e), 2, digits, sizeof digits);
        snprintf(text, size, "%se%d", digits, e);
    }
}

/* The bytes of the letter at `s`, 0 when they are not well-formed UTF-8 (no overlong forms, no
 * surrogates, no code above U+10FFFF: Unicode 15, table 3-7). */
static size_t letter_length(const unsigned char *s)
{
    const size_t length = s[0] < 0x80   ? 1
                          : s[0] < 0xc2 ? 0
                          : s[0] < 0xe0 ? 2
                          : s[0] < 0xf0 ? 3
                          : s[0] < 0xf5 ? 4
                                        : 0;
    for (size_t i = 1; i < length; i++) {
        if (s[i] < 0x80 || s[i] > 0xbf) {
            return 0;
        }
    }
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f) ||
        (s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f)) {
        return 0;
    }
    return length;
}

/* Control codes, and the two codes no XML document may hold. */
static int is_unprintable(const unsigned char *s, size_t length)
{
    return (length == 1 && (s[0] < 0x20 || s[0] == 0x7f)) ||
           (length == 2 && s[0] == 0xc2 && s[1] < 0xa0) ||
           (length == 3 && s[0] == 0xef && s[1] == 0xbf && s[2] >= 0xbe);
}

void taut_label_clean(const char *from, size_t most, char *text, size_t size)
{
    static const char ellipsis[] = "\xe2\x80\xa6"; /* U+2026 */
    const unsigned char *s = (const unsigned char *)from;
    size_t at = 0, letters = 0;

    while (*s != 0) {
        const size_t length = letter_length(s);
        const int bad = length == 0 || is_unprintable(s, length);
        const size_t step = length > 0 ? length : 1;
        const int last = s[step] == 0;
        if (at + step + sizeof ellipsis > size || (letters + 1 >= most && !last)) {
            memcpy(text + at, ellipsis, sizeof ellipsis - 1);
            at += sizeof ellipsis - 1;
            break;
        }
        if (bad) {
            text[at++] = '?';
        } else {
            memcpy(text + at, s, step);
            at += step;
        }
        s += step;
        letters++;
    }
    text[at] = '\0';
}

/* Digits and most letters are 0.6 em wide; bytes that go on a letter are none. */
double taut_label_width(const char *text, double size)
{
    size_t letters = 0;
    for (const unsigned char *s = (const unsigned char *)text; *s != 0; s++) {
        letters += (*s & 0xc0) != 0x80;
    }
    return 0.61 * size * (double)letters;
}

void taut_label_short(double value, char *text, size_t size)
{
    const int e = (int)floor(taut_log10(value) + 1e-9);
    if (e >= -4 && e <= 5) {
        taut_label_fixed(value, e < 0 ? -e : 0, text, size);
    } else {
        char digits[48];
        taut_label_fixed(value / taut_pow(10, e), 0, digits, sizeof digits);
        snprintf(text, size, "%se%d", digits, e);
    }
}
