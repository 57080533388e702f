/* model_document.h -- models as documents. */
#ifndef TAUT_IO_MODEL_DOCUMENT_H
#define TAUT_IO_MODEL_DOCUMENT_H

#include "io/json_in.h"
#include "io/json_out.h"
#include "taut/model.h"

/* Is the member `taut` there, and the version this reader knows? */
taut_status taut_version_document_check(const taut_json *document, taut_error *error);
/* The member `unit`, "mm" if it is missing: a word of the contract, borrowed. */
taut_status taut_unit_document_read(const taut_json *document, const char **unit,
                                    taut_error *error);

taut_status taut_certificate_document_read(const taut_json *at, taut_certificate **certificate,
                                           taut_error *error);
void taut_certificate_document_write(taut_json_out *out, const taut_certificate *certificate);

#endif /* TAUT_IO_MODEL_DOCUMENT_H */
