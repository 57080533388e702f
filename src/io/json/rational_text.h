/* rational_text.h -- rational numbers as texts: an optional minus, digits, and "/" with digits that
 * are not all 0. */
#ifndef TAUT_IO_JSON_RATIONAL_TEXT_H
#define TAUT_IO_JSON_RATIONAL_TEXT_H

enum { TAUT_RATIONAL_MAX = 20000 }; /* bytes */

/* The double nearest to the number, to within 2^-60 of it; infinite where it is too large. 0, and
 * *value untouched, if the text is none or longer than TAUT_RATIONAL_MAX. */
int taut_rational_value(const char *text, double *value);

#endif /* TAUT_IO_JSON_RATIONAL_TEXT_H */
