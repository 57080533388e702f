/* fail.h -- filling a taut_error. */
#ifndef TAUT_CORE_FAIL_H
#define TAUT_CORE_FAIL_H

#include "core/printf.h"
#include "taut/status.h"

/* Fills *error (if not NULL) and returns `status`. `reason` is a word of the list of the room that
 * fails (TAUT_REASON_LIST and its like in include/taut), which tools/check_reasons.sh sees to.
 * `where` may be NULL; found and limit are taut_none if there are none. The message is one
 * sentence, cut if too long. */
taut_status taut_fail(taut_error *error, taut_status status, const char *reason, const char *where,
                      double found, double limit, const char *format, ...) TAUT_PRINTF(7, 8);
/* The same where words say what should have been there: the message is "<format>, expected
 * <expected>". */
taut_status taut_fail_expected(taut_error *error, taut_status status, const char *reason,
                               const char *where, double found, const char *expected,
                               const char *format, ...) TAUT_PRINTF(7, 8);

/* TAUT_NO_MEMORY with its usual sentence. */
taut_status taut_fail_memory(taut_error *error);

/* What is known is the status alone: its own sentence, and "memory", "argument", "interrupted" or
 * "fault". TAUT_OK is left alone. */
taut_status taut_fail_status(taut_error *error, taut_status status);

/* Puts `prefix` before error->where, as an outer reader knows more of the place. */
void taut_error_prefix(taut_error *error, const char *prefix);

extern const double taut_none; /* NaN: no number */

#endif /* TAUT_CORE_FAIL_H */
