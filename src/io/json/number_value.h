/* number_value.h -- the number a JSON number spells. */
#ifndef TAUT_IO_JSON_NUMBER_VALUE_H
#define TAUT_IO_JSON_NUMBER_VALUE_H

#include <locale.h>
#include <stddef.h>

/* A place for the "C" locale, made when it is first needed. Zero-initialise. */
typedef struct taut_plain_locale {
    locale_t locale;
} taut_plain_locale;

/* The length of the JSON number (RFC 8259, section 6) at the beginning of text[0..room-1]; 0 if
 * there is none. */
size_t taut_number_length(const char *text, size_t room);

/* The double nearest to the decimal text[0..length-1], a JSON number, whatever the locale: as
 * strtod, infinite where it is too large. 0 when memory runs out. */
int taut_number_value(const char *text, size_t length, taut_plain_locale *plain, double *value);

void taut_plain_locale_free(taut_plain_locale *plain);

#endif /* TAUT_IO_JSON_NUMBER_VALUE_H */
