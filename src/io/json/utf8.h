/* utf8.h -- which bytes are UTF-8. */
#ifndef TAUT_IO_JSON_UTF8_H
#define TAUT_IO_JSON_UTF8_H

#include <stddef.h>

/* The length of the UTF-8 sequence at `text`, of which `room` bytes may be read; 0 where it is not
 * one (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF). */
static inline size_t taut_utf8_length(const char *text, size_t room)
{
    const unsigned char *b = (const unsigned char *)text;
    size_t length = 0;
    if (room == 0) {
        return 0;
    }
    length = b[0] < 0x80 ? 1 : b[0] < 0xc2 ? 0 : b[0] < 0xe0 ? 2 : b[0] < 0xf0 ? 3 : 4;
    if (b[0] > 0xf4 || length > room) {
        return 0;
    }
    for (size_t i = 1; i < length; i++) {
        if ((b[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    if ((b[0] == 0xe0 && b[1] < 0xa0) || (b[0] == 0xed && b[1] > 0x9f) ||
        (b[0] == 0xf0 && b[1] < 0x90) || (b[0] == 0xf4 && b[1] > 0x8f)) {
        return 0;
    }
    return length;
}

#endif /* TAUT_IO_JSON_UTF8_H */
