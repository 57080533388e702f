/* model.h -- models as documents. */
#ifndef TAUT_IO_MODEL_MODEL_H
#define TAUT_IO_MODEL_MODEL_H

#include "io/json/in.h"
#include "io/json/out.h"
#include "taut/construct.h"
#include "taut/model.h"

/* The model of a document. */
taut_status taut_model_document_read(const taut_json *document, taut_model **model,
                                     taut_error *error);

/* Is the member `taut` there, and the version this reader knows? */
taut_status taut_version_document_check(const taut_json *document, taut_error *error);
/* The member `unit`, "mm" if it is missing: a word of the contract, borrowed. */
taut_status taut_unit_document_read(const taut_json *document, const char **unit,
                                    taut_error *error);

taut_status taut_certificate_document_read(const taut_json *at, taut_certificate **certificate,
                                           taut_error *error);
void taut_certificate_document_write(taut_json_out *out, const taut_certificate *certificate);

#endif /* TAUT_IO_MODEL_MODEL_H */
