/* stream.h -- items through a pipe, from a child to its parent on the same machine.
 *
 *     'U' unit[4]     'I' name, counts, numbers     'E' status, message: the end
 */
#ifndef TAUT_IO_CAD_STREAM_H
#define TAUT_IO_CAD_STREAM_H

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

#endif /* TAUT_IO_CAD_STREAM_H */
