/* number_value.h -- the number that a text spells: a JSON number, or a rational one. */
#ifndef TAUT_IO_JSON_NUMBER_VALUE_H
#define TAUT_IO_JSON_NUMBER_VALUE_H

#include <stddef.h>

/* The length of the JSON number (RFC 8259, section 6) at the beginning of text[0..room-1]; 0 if
 * there is none. */
size_t taut_number_length(const char *text, size_t room);

/* The double nearest to the decimal text[0..length-1], a JSON number, whatever the locale: infinite
 * where it is too large. */
double taut_number_value(const char *text, size_t length);

enum { TAUT_RATIONAL_MAX = 20000 }; /* bytes */

/* A rational number: an optional minus, digits, and "/" with digits that are not all 0. The double
 * nearest to it, of two that are as near the even one; infinite where it is too large. 0, and *value untouched, if
 * the text is none or longer than TAUT_RATIONAL_MAX. */
int taut_rational_value(const char *text, double *value);

#endif /* TAUT_IO_JSON_NUMBER_VALUE_H */
