/* label.h -- words and numbers for figures. */
#ifndef TAUT_DRAW_LABEL_H
#define TAUT_DRAW_LABEL_H

#include <stddef.h>

/* value with `decimals` digits after the point (0..9), a true minus sign, no locale; |value| is
 * below 1e9. */
void taut_label_fixed(double value, int decimals, char *text, size_t size);

/* value to three digits, such as 0.125, 1340 or 2.5e-7; "?" where it is not finite. */
void taut_label_number(double value, char *text, size_t size);

/* A copy of at most `most` letters that every canvas can draw: what is not UTF-8 or not printable
 * becomes "?", what is too long ends in an ellipsis. */
void taut_label_clean(const char *from, size_t most, char *text, size_t size);

/* Of a number of one digit times a power of ten: as short as it can be said. */
void taut_label_short(double value, char *text, size_t size);
/* About how wide a text is in page units, in letters of this size: what no font need be asked for. */
double taut_label_width(const char *text, double size);

#endif /* TAUT_DRAW_LABEL_H */
