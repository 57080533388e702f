/* cad.h -- reading STEP, for the format that writes it. */
#ifndef TAUT_IO_CAD_CAD_H
#define TAUT_IO_CAD_CAD_H

#include "taut/read.h"

/* As taut_format_ops.read; by taut-cad. */
taut_status taut_cad_read_step(const char *path, const taut_read_options *options,
                               taut_model **model, taut_error *error);

#endif /* TAUT_IO_CAD_CAD_H */
