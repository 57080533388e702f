/* child.h -- the module `occt` in a process of its own, and the pipe between.
 *
 * The child loads the module, works, and speaks through a pipe:
 *
 *     'U' unit[4]     'I' name, counts, numbers     'E' status, message: the end
 *
 * Its memory and time are bounded by the size of the file; what it prints is dropped; if it dies,
 * that is a failure like any other. The parent stays free of the library and of its settings, which
 * are global.
 */
#ifndef TAUT_IO_CAD_CHILD_H
#define TAUT_IO_CAD_CHILD_H

#include "io/cad/module_interface.h"
#include "taut/model.h"
#include "taut/record.h"

#include <stdio.h>

/* The child's side; 0 when the pipe is broken. */
int taut_cad_put_unit(void *file, const char *unit);
int taut_cad_put_item(void *file, const taut_cad_item *item);
int taut_cad_put_end(FILE *file, taut_status status, const taut_error *error);

/* What a parent makes of it. */
typedef struct taut_cad_result {
    taut_model *model;  /* surfaces and curves are added, the unit set; may be NULL when writing */
    taut_record *notes; /* a list of sentences, likewise */
    int has_ended;      /* the end was seen... */
    taut_status status; /* ...with this, and *error is filled */
} taut_cad_result;

/* Reads up to the end, which may be missing if the child died. What an item has wrong is
 * TAUT_BAD_INPUT; TAUT_NO_MEMORY. */
taut_status taut_cad_get_all(FILE *file, taut_cad_result *result, taut_error *error);

/* Writes items: count > 0. Reads into *result: items NULL. Errors as taut_cad_ops says;
 * TAUT_IO where the module is not installed or no process is to be had; TAUT_BAD_INPUT (reading) or
 * TAUT_INTERNAL (writing) where the child died; TAUT_NO_MEMORY. */
taut_status taut_cad_run(const taut_cad_job *job, int count, const taut_cad_item *items,
                         taut_cad_result *result, taut_error *error);

#endif /* TAUT_IO_CAD_CHILD_H */
