/* read.h -- problems as documents. */
#ifndef TAUT_IO_PROBLEM_READ_H
#define TAUT_IO_PROBLEM_READ_H

#include "io/json/in.h"
#include "taut/construct.h"

/* The problem of a document; path NULL: it came from no file. */
taut_status taut_problem_document_read(const taut_json *document, const char *path,
                                       taut_problem **problem, taut_error *error);

#endif /* TAUT_IO_PROBLEM_READ_H */
