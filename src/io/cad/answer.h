/* answer.h -- reading what taut-cad says. */
#ifndef TAUT_IO_CAD_ANSWER_H
#define TAUT_IO_CAD_ANSWER_H

#include "io/cad/wire.h"
#include "taut/limits.h"
#include "taut/model.h"
#include "taut/record.h"

#include <stdio.h>

/* Where its bytes come from; all but `more` and `context` is 0 at first. */
typedef struct taut_cad_source {
    size_t (*more)(void *context, void *to, size_t room); /* how many are there; 0: no more */
    void *context;
    size_t at, end;
    int is_dry; /* more was wanted than came */
    char room[1 << 14];
} taut_cad_source;

typedef enum taut_cad_greeting {
    TAUT_CAD_GREETED,
    TAUT_CAD_SILENT, /* it ended before it had said who it is */
    TAUT_CAD_STRANGER,
    TAUT_CAD_OTHER_VERSION
} taut_cad_greeting;

/* What stands first; *hello is filled where it is a version's. */
taut_cad_greeting taut_cad_get_hello(taut_cad_source *source, taut_cad_hello *hello);

/* What libtaut makes of the rest. */
typedef struct taut_cad_result {
    taut_model *model;  /* surfaces and curves are added, the unit set; may be NULL when writing */
    taut_record *notes; /* a list of sentences, likewise */
    taut_record *products,
        *colours; /* of each surface: a text, "" where nothing is said; may be NULL likewise */
    taut_record *
        instances; /* of each surface, numbers; and of each use of a product its name and place, a list of objects; */
    taut_record *uses;               /* may be NULL likewise */
    char product[TAUT_NAME_MAX + 1]; /* the whole of an assembly; "" where nothing is said */
    int trimmed;                     /* surfaces of which the file has only a part */
    int edges;                       /* curves that are edges of such ones: the last */
    FILE *text;                      /* where the text of a file goes; NULL when reading */
    int has_ended;                   /* the end was seen... */
    taut_status status;              /* ...with this, and *error is filled */
} taut_cad_result;

/* Reads up to the end, which may be missing if taut-cad died. What an item has wrong is TAUT_BAD_INPUT; TAUT_IO where
 * the text cannot be written; TAUT_NO_MEMORY. */
taut_status taut_cad_get_all(taut_cad_source *source, taut_cad_result *result, taut_error *error);

#endif /* TAUT_IO_CAD_ANSWER_H */
