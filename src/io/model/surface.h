/* surface.h -- SURFACE and CURVE in documents, from and to. */
#ifndef TAUT_IO_MODEL_SURFACE_H
#define TAUT_IO_MODEL_SURFACE_H

#include "io/json/in.h"
#include "io/json/out.h"
#include "taut/curve.h"
#include "taut/surface.h"

/* The results are the caller's. */
taut_status taut_surface_document_read(const taut_json *at, taut_surface **surface,
                                       taut_error *error);
taut_status taut_curve_document_read(const taut_json *at, taut_curve **curve, taut_error *error);

void taut_surface_document_write(taut_json_out *out, const taut_surface *surface);
void taut_curve_document_write(taut_json_out *out, const taut_curve *curve);

/* The member `name`, "" if it is missing: at most TAUT_NAME_MAX bytes, borrowed. */
taut_status taut_name_document_read(const taut_json *object, const char **name, taut_error *error);

#endif /* TAUT_IO_MODEL_SURFACE_H */
