/* figures.h -- figures of a certificate that are integrals, with their errors.
 *
 * A figure `name` comes with `name_error` where it is not good to 1e-10 of itself, and is null where
 * it leaves the range of doubles: a certificate prints no digit that it does not know.
 */
#ifndef TAUT_CERTIFY_COMMON_FIGURES_H
#define TAUT_CERTIFY_COMMON_FIGURES_H

#include "taut/record.h"

/* A number where count is 1, else a list; errors[i] is 0 where it is not worth a word, NaN where it
 * is not known. */
void taut_certify_add_integrals(taut_record *figures, const char *name, int count,
                                const double *values, const double *errors);

#endif /* TAUT_CERTIFY_COMMON_FIGURES_H */
