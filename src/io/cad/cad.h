/* cad.h -- reading STEP, for the format that writes it. */
#ifndef TAUT_IO_CAD_CAD_H
#define TAUT_IO_CAD_CAD_H

#include "taut/model.h"
#include "taut/status.h"

/* As taut_format_ops.read and read_edges; by taut-cad. */
taut_status taut_cad_read_step(const char *path, taut_model **model, taut_error *error);
taut_status taut_cad_read_step_edges(const char *path, taut_model **model, taut_error *error);

#endif /* TAUT_IO_CAD_CAD_H */
