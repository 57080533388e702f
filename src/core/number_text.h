/* number_text.h -- numbers as text that reads back as the same number.
 *
 * The decimal nearest to x of 15, 16 or 17 digits, the first of them that reads back as x bit for
 * bit (17 always do), without trailing zeros: what printf's %.15g, %.16g, %.17g give, but whatever
 * the locale, and about six times as fast for most numbers.
 */
#ifndef TAUT_CORE_NUMBER_TEXT_H
#define TAUT_CORE_NUMBER_TEXT_H

#include <stddef.h>

enum { TAUT_NUMBER_ROOM = 40 };

/* Writes the text, ended by a 0 byte, and returns its length; "null" where x is not finite. */
size_t taut_number_text(double x, char text[TAUT_NUMBER_ROOM]);

#endif /* TAUT_CORE_NUMBER_TEXT_H */
