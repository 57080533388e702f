/* staged.h -- one output on its way: written where nobody looks, then put in its place.
 *
 * A regular file, there already or not, is written as a new file beside it and renamed over it.
 * Where the system allows it that new file has no name until it is whole: nothing is left of it
 * even when the process is killed.
 * Standard output, devices and pipes cannot be renamed over: what goes there is gathered in memory
 * and sent when all else has gone well.
 */
#ifndef TAUT_IO_FILE_STAGED_H
#define TAUT_IO_FILE_STAGED_H

#include "platform/system.h"
#include "taut/status.h"

typedef struct taut_staged {
    struct taut_staged *next;
    taut_target_kind kind;
    char *path;         /* as given, for messages */
    char *target;       /* links resolved; "" for standard output */
    taut_new_file made; /* of a file */
    int is_ready;       /* nonzero: written whole, not yet in place */
    FILE *file;         /* while it is written */
    char *spool;        /* what is to be sent; malloc's */
    size_t spool_length;
} taut_staged;

/* Looks at the path, takes memory, and touches nothing yet. TAUT_IO, TAUT_NO_MEMORY. */
taut_status taut_staged_new(const char *path, taut_staged **staged, taut_error *error);
/* Makes the temporary file, or the spool: staged->file is open. */
taut_status taut_staged_open(taut_staged *staged, taut_error *error);
/* Where somebody else may open the new file of a TAUT_TARGET_FILE to write it, in this process or a
 * child of it: its temporary name, or a path in `own` while it has none. */
const char *taut_staged_path(const taut_staged *staged, char own[TAUT_OWN_ROOM]);
/* Closes it; from here on it is ready. Errors of writing are seen here at the latest. */
taut_status taut_staged_close(taut_staged *staged, taut_error *error);
/* Puts it in its place. */
taut_status taut_staged_place(taut_staged *staged, taut_error *error);
/* Removes what is not in its place; it is not ready any more. */
void taut_staged_drop(taut_staged *staged);
void taut_staged_free(taut_staged *staged); /* NULL is fine; drops */

#endif /* TAUT_IO_FILE_STAGED_H */
