/* taut/status.h -- how every taut function says what happened.
 *
 * A function that can fail returns a taut_status. A function that can fail for a reason a person
 * must read also takes a `taut_error *error`, always last, which may be NULL. On success *error is
 * left alone; on failure it is filled whole. Nothing is printed, nothing is global.
 *
 * NULL where a function with a status needs something is TAUT_BAD_ARGUMENT. Functions without a
 * status (counts, names, what is borrowed) take objects that were made and numbers in their range,
 * but where they say that others are fine.
 */
#ifndef TAUT_STATUS_H
#define TAUT_STATUS_H

#include "taut/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One row per status: name, exit code of the command line, meaning. Values are never reused. */
#define TAUT_STATUS_LIST(X)                                                                        \
    X(TAUT_OK, 0, "done")                                                                          \
    X(TAUT_NOT_CONVERGED, 1, "an iteration stopped short of its tolerance")                        \
    X(TAUT_CHECK_FAILED, 1, "a result did not pass its own check")                                 \
    X(TAUT_BAD_ARGUMENT, 2, "an argument is outside its documented range")                         \
    X(TAUT_BAD_INPUT, 3, "a document is not what it should be")                                    \
    X(TAUT_NO_SOLUTION, 4, "what is asked for does not exist")                                     \
    X(TAUT_IO, 5, "a file could not be read or written")                                           \
    X(TAUT_NO_MEMORY, 6, "memory ran out")                                                         \
    X(TAUT_INTERNAL, 6, "a fault of taut's own")                                                   \
    X(TAUT_INTERRUPTED, 130, "stopped on request")

/* The names of the list above, from 0 on. */
typedef enum taut_status {
#define TAUT_STATUS_ENUM(name, exit_code, meaning) name,
    TAUT_STATUS_LIST(TAUT_STATUS_ENUM)
#undef TAUT_STATUS_ENUM
} taut_status;

/* Reasons that any call may give: word, meaning, remedy. What can be wrong with a document is
 * listed in taut/read.h, with a file in taut/write.h, and with what a construction is asked for in
 * its own header. docs/errors.md has them all. */
#define TAUT_REASON_LIST(X)                                                                        \
    X("argument", "an argument of a C call is NULL or outside its documented range",               \
      "see what the call takes, in its header or docstring")                                       \
    X("memory", "memory ran out", "take fewer points, or give the process more memory")            \
    X("interrupted", "the caller, or the person at the keyboard, asked it to stop",                \
      "start it again")                                                                            \
    X("time", "the time allowed was over before there was anything to show", "allow more time")    \
    X("not-installed", "a part of taut that needs a library on demand is not there",               \
      "install the package that the message names and build taut again")                           \
    X("no-rationals", "rational arithmetic was asked for where there is none",                     \
      "leave out `exact` (--exact)")                                                               \
    X("fault", "a fault of taut's own", "report it, with the document")

/* What went wrong, as data first. Plain data: copy it, keep it, no free. */
typedef struct taut_error {
    taut_status status;
    char reason[32];    /* one of the words listed with the call, such as "range"; never empty */
    double found;       /* the quantity that failed, NaN if none */
    double limit;       /* what it had to stay within, NaN if none */
    char expected[192]; /* what should have been there, in words; "" where `limit` says it */
    char where[192];    /* "" or a JSON pointer such as "/points/1/2", or file:line:column */
    char message[768];  /* one sentence: which condition, and a remedy */
} taut_error;

/* The meaning of a status; never NULL, even of other values. */
TAUT_API const char *taut_status_text(taut_status status);

/* The exit code of the command line for a status; 6 for other values. */
TAUT_API int taut_status_exit_code(taut_status status);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_STATUS_H */
