/* decimal.h -- doubles from decimals and decimals from doubles, rounded right whatever the C library.
 *
 * A decimal and a double are both a quotient N / M of whole numbers. Divided with the rest kept, in as many bits as there
 * are, the quotient is rounded once, half to even. Not every strtod does that: MinGW's reads 1.868775676978051e196 as 2^652,
 * which is one double too many.
 */
#ifndef TAUT_CORE_DECIMAL_H
#define TAUT_CORE_DECIMAL_H

#include <stddef.h>
#include <stdint.h>

/* The double nearest to text[0..length-1]: a sign or none, digits with a point or none, an exponent or none, as C and JSON
 * spell numbers. Infinite where it is too large. */
double taut_decimal_value(const char *text, size_t length);

/* The whole number of `precision` digits, at most 18, for which it times 10^*exponent is nearest to x, finite and above 0;
 * 10^precision may come out too. */
uint64_t taut_decimal_digits(double x, int precision, int *exponent);

#endif /* TAUT_CORE_DECIMAL_H */
