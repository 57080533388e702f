/* tree.h -- a JSON text as a tree in memory.
 *
 * The parser is strict (RFC 8259): UTF-8 only, no comments, no member given twice, nothing after
 * the end; numbers are doubles, rounded correctly whatever the locale, and must fit. It takes 16
 * bytes for a number and allocates in blocks; all memory is core/memory's, so that a failure is
 * always seen. Why not a library: docs/decisions/0008-json-parser.md.
 */
#ifndef TAUT_IO_JSON_TREE_H
#define TAUT_IO_JSON_TREE_H

#include "core/pulse.h"
#include "taut/status.h"

#include <stddef.h>
#include <stdint.h>

enum { TAUT_JSON_DEPTH_MAX = 256 }; /* lists and objects inside one another */

typedef enum taut_json_kind {
    TAUT_JSON_MISSING, /* no value: a member that is not there */
    TAUT_JSON_NULL,
    TAUT_JSON_FALSE,
    TAUT_JSON_TRUE,
    TAUT_JSON_NUMBER,
    TAUT_JSON_STRING,
    TAUT_JSON_ARRAY,
    TAUT_JSON_OBJECT
} taut_json_kind;

typedef struct taut_json_entry taut_json_entry;

typedef struct taut_json_value {
    uint32_t kind;  /* a taut_json_kind */
    uint32_t count; /* items of an array, members of an object, bytes of a string */
    union {
        double number;
        const char *string; /* UTF-8, ended by a 0 byte, with none inside */
        const struct taut_json_value *items;
        const taut_json_entry *members;
    } as;
} taut_json_value;

/* A member: in the order of the text. */
struct taut_json_entry {
    const char *key;
    size_t offset; /* where its key begins in the text */
    taut_json_value value;
};

typedef struct taut_json_document taut_json_document;

/* Parses text; `name` stands for the file in messages. TAUT_BAD_INPUT with file:line:column where
 * JSON broke; TAUT_NO_MEMORY; TAUT_INTERRUPTED by the pulse, which may be NULL. Cost: linear (objects: n log n in their members). */
taut_status taut_json_parse(const char *text, size_t length, const char *name, taut_pulse *pulse,
                            taut_json_document **document, taut_error *error);
void taut_json_document_free(taut_json_document *document); /* NULL is fine */
/* The value of the whole text; lives as long as the document. */
const taut_json_value *taut_json_document_root(const taut_json_document *document);

/* The member `key`, or NULL: also where `object` is NULL or no object. Cost: linear. */
const taut_json_value *taut_json_find(const taut_json_value *object, const char *key);

#endif /* TAUT_IO_JSON_TREE_H */
