/* problem.h -- a problem in memory: which construction, and the plain struct its header defines.
 *
 * Readers build it, constructions and certificates read it; neither knows the other.
 */
#ifndef TAUT_PROBLEM_H
#define TAUT_PROBLEM_H

#include "core/arena.h"
#include "problem/construct_list.h"
#include "taut/construct.h"
#include "taut/record.h"

#define TAUT_CONSTRUCT_INDEX(identifier, name) TAUT_CONSTRUCT_INDEX_##identifier,
typedef enum taut_construct_index {
    TAUT_CONSTRUCT_LIST(TAUT_CONSTRUCT_INDEX) TAUT_CONSTRUCT_COUNT
} taut_construct_index;
#undef TAUT_CONSTRUCT_INDEX

struct taut_problem {
    int construct;      /* a taut_construct_index */
    taut_arena *arena;  /* owns the data and all it points at */
    const void *data;   /* the construction's struct, such as taut_dirichlet_problem */
    char unit[4];       /* "mm" unless the document says otherwise */
    const char *folder; /* of its document, with a slash at the end, "" if it came from no file */
    char *text;         /* its document, ended by a 0 behind its bytes; the problem's */
    size_t length;
    taut_record *
        notes; /* NULL, or sentences on what its reader converted and chose, for the model's details */
};

/* An empty problem with its arena; data is set by the reader. */
taut_status taut_problem_new(int construct, taut_problem **problem);
/* Adds a sentence to its notes. TAUT_NO_MEMORY. */
taut_status taut_problem_note(taut_problem *problem, const char *sentence);
/* The index of a construction by its name in documents, or -1. */
int taut_construct_find(const char *name);

#endif /* TAUT_PROBLEM_H */
