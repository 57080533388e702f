#include "io/file/xml.h"

#include "io/json/utf8.h"

#include <string.h>

static const char *name_of(char c)
{
    return c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : NULL;
}

/* U+FFFE and U+FFFF are no characters of XML. */
static int is_character(const char *bytes, size_t length)
{
    return length > 0 && !(length == 3 && memcmp(bytes, "\xef\xbf", 2) == 0 &&
                           ((unsigned char)bytes[2] & 0xfe) == 0xbe);
}

void taut_xml_text(taut_sink *sink, const char *text)
{
    size_t room = strlen(text);
    while (room > 0) {
        const size_t length = taut_utf8_length(text, room);
        const unsigned char byte = (unsigned char)*text;
        if (name_of(*text) != NULL) {
            taut_sink_text(sink, name_of(*text));
        } else if (byte < 0x20 || byte == 0x7f) {
            taut_sink_text(sink, "_");
        } else if (is_character(text, length)) {
            taut_sink_bytes(sink, text, length);
        } else {
            taut_sink_text(sink, "\xef\xbf\xbd");
        }
        text += length > 0 ? length : 1;
        room -= length > 0 ? length : 1;
    }
}
