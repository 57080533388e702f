/* read.h -- problems with the text they come from, which each keeps. */
#ifndef TAUT_IO_PROBLEM_READ_H
#define TAUT_IO_PROBLEM_READ_H

#include "io/json/in.h"
#include "taut/construct.h"

typedef struct taut_problem_source {
    const char *text; /* of the document alone */
    size_t length;
    char **owned; /* NULL: the text is copied; else it may be taken from there, NULL left behind */
} taut_problem_source;

/* The problem of a document; path NULL: it came from no file. */
taut_status taut_problem_document_read(const taut_json *document, const char *path,
                                       const taut_problem_source *source, taut_problem **problem,
                                       taut_error *error);

/* The same of a text; `name` stands for it in messages, `path` says where other files are. */
taut_status taut_problem_read_from(const char *text, size_t length, const char *name,
                                   const char *path, taut_problem **problem, taut_error *error);

/* taut_json_read_file with the text still there: *source, which `into` knows of, is filled first. */
taut_status taut_problem_read_file(const char *path, taut_pulse *pulse, taut_json_read *read,
                                   void *into, taut_problem_source *source, taut_error *error);

#endif /* TAUT_IO_PROBLEM_READ_H */
