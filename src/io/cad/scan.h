/* scan.h -- what a STEP or IGES file says of itself, looked at before a library reads it: is it
 * whole, and are its numbers numbers? OpenCASCADE reads on where a file was cut off, and goes in
 * circles over a coordinate that is none. */
#ifndef TAUT_IO_CAD_SCAN_H
#define TAUT_IO_CAD_SCAN_H

#include "taut/status.h"

#include <stddef.h>

/* ISO 10303-21: begins and ends with its marks; strings, comments and parentheses are closed; what
 * stands unquoted inside parentheses is a number below 1e308, a reference, an enumeration, or a
 * keyword with parentheses of its own. TAUT_BAD_INPUT, with the line. */
taut_status taut_cad_scan_step(const char *text, size_t length, taut_error *error);

/* IGES 5.3: every line names its section in column 73; sections come in their order and the last
 * line tells how many lines each of them has; entities point at parameters that are there, and the
 * parameters of geometry are numbers below 1e308 or texts. TAUT_BAD_INPUT, with the line. */
taut_status taut_cad_scan_iges(const char *text, size_t length, taut_error *error);

/* The length of the number that begins at text[0..room-1], 0 if none or only half of one does; an
 * exponent follows one of the letters `exponents`. *is_huge: it is 1e308 or more. */
size_t taut_cad_number(const char *text, size_t room, const char *exponents, int *is_huge);

#endif /* TAUT_IO_CAD_SCAN_H */
