/* geomdl.h -- NURBS-Python's exchange JSON, told from a model by its member "shape". */
#ifndef TAUT_IO_GEOMDL_GEOMDL_H
#define TAUT_IO_GEOMDL_GEOMDL_H

#include "io/json/in.h"
#include "taut/model.h"

/* Is this document one of geomdl's? */
int taut_geomdl_is(const taut_json *document);
/* The model of such a document. */
taut_status taut_geomdl_read(const taut_json *document, taut_model **model, taut_error *error);

#endif /* TAUT_IO_GEOMDL_GEOMDL_H */
