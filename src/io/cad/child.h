/* child.h -- the module `occt` in a process of its own.
 *
 * The child loads the module, works, and speaks through a pipe (io/cad/stream.h). Its memory and
 * time are bounded by the size of the file; what it prints is dropped; if it dies, that is a
 * failure like any other. The parent stays free of the library and of its settings, which are
 * global.
 */
#ifndef TAUT_IO_CAD_CHILD_H
#define TAUT_IO_CAD_CHILD_H

#include "io/cad/stream.h"

/* Writes items: count > 0. Reads into *result: items NULL. Errors as taut_cad_ops says;
 * TAUT_IO where the module is not installed or no process is to be had; TAUT_BAD_INPUT (reading) or
 * TAUT_INTERNAL (writing) where the child died; TAUT_NO_MEMORY. */
taut_status taut_cad_run(const taut_cad_job *job, int count, const taut_cad_item *items,
                         taut_cad_result *result, taut_error *error);

#endif /* TAUT_IO_CAD_CHILD_H */
