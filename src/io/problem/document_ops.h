/* document_ops.h -- what the document of one construction must provide. */
#ifndef TAUT_IO_PROBLEM_DOCUMENT_OPS_H
#define TAUT_IO_PROBLEM_DOCUMENT_OPS_H

#include "io/json/in.h"
#include "problem/problem.h"

typedef struct taut_document_ops {
    /* The members it has besides `taut`, `construct` and `unit`, at most TAUT_DOCUMENT_MEMBERS,
     * ended by NULL: others are refused before `read` is called. */
    const char *const *members;
    size_t size; /* of the struct that says what is asked for */
    /* Fills that struct: `data` is zeroed and of problem->arena, and what it points at is to be of
     * that arena too; problem->unit is in place. */
    void (*read)(taut_reader *document, taut_problem *problem, void *data);
} taut_document_ops;

enum { TAUT_DOCUMENT_MEMBERS = 32 };

#define TAUT_DOCUMENT_DECLARE(identifier, name)                                                    \
    extern const taut_document_ops taut_document_##identifier;
TAUT_CONSTRUCT_LIST(TAUT_DOCUMENT_DECLARE)
#undef TAUT_DOCUMENT_DECLARE

#endif /* TAUT_IO_PROBLEM_DOCUMENT_OPS_H */
