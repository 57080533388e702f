/* fail.h -- filling a taut_error. */
#ifndef TAUT_CORE_FAIL_H
#define TAUT_CORE_FAIL_H

#include "taut/status.h"

/* Fills *error (if not NULL) and returns `status`. `where` may be NULL; found and limit NaN if
 * there are none: TAUT_NONE. The message is one sentence, cut if too long. */
taut_status taut_fail(taut_error *error, taut_status status, const char *where, double found,
                      double limit, const char *format, ...) __attribute__((format(printf, 6, 7)));

/* TAUT_NO_MEMORY with its usual sentence. */
taut_status taut_fail_memory(taut_error *error);

/* Puts `prefix` before error->where, as an outer reader knows more of the place. */
void taut_error_prefix(taut_error *error, const char *prefix);

extern const double taut_none; /* NaN: no number */

#endif /* TAUT_CORE_FAIL_H */
