/* target.h -- where a path leads. */
#ifndef TAUT_IO_FILE_TARGET_H
#define TAUT_IO_FILE_TARGET_H

#include "taut/status.h"

typedef enum taut_target_kind {
    TAUT_TARGET_FILE,
    TAUT_TARGET_DEVICE,
    TAUT_TARGET_STANDARD
} taut_target_kind;

enum { TAUT_PATH_ROOM = 4096 };

/* What kind of place `path` names, and its full name with links resolved ("" for standard output).
 * TAUT_IO: a folder, a file that may not be written, a folder that is not there. */
taut_status taut_target_find(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM],
                             taut_error *error);

#endif /* TAUT_IO_FILE_TARGET_H */
