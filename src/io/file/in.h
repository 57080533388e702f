/* in.h -- a whole file into memory. */
#ifndef TAUT_IO_FILE_IN_H
#define TAUT_IO_FILE_IN_H

#include "taut/status.h"

#include <stddef.h>

/* Reads all of `path` ("-": standard input), at most TAUT_FILE_MAX bytes. *text, with a 0 behind its
 * *length bytes, is the caller's, freed by taut_free. TAUT_IO with path and reason, TAUT_NO_MEMORY. */
taut_status taut_file_read(const char *path, char **text, size_t *length, taut_error *error);

/* TAUT_IO about a path: "cannot <reason> <path>: <what errno `number` means>". The reason is "read"
 * or "write". */
taut_status taut_fail_file(taut_error *error, const char *path, const char *reason, int number);

#endif /* TAUT_IO_FILE_IN_H */
