/* documents.h -- problems out of documents in the text of a test. */
#ifndef TAUT_TEST_DOCUMENTS_H
#define TAUT_TEST_DOCUMENTS_H

#include "taut/read.h"

/* The problem of a document that is right, which is checked; free it. */
taut_problem *problem_read(const char *text);

#endif /* TAUT_TEST_DOCUMENTS_H */
