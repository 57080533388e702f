/* refused.h -- documents that cannot be made. */
#ifndef TAUT_TEST_REFUSED_H
#define TAUT_TEST_REFUSED_H

#include "taut/status.h"

/* Reading the document, or making it, ends with this status, reason and place; what was said of it. */
taut_error check_document_refused(const char *text, taut_status status, const char *reason,
                                  const char *where);

#endif /* TAUT_TEST_REFUSED_H */
