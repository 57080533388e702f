/* slice.h -- where in a text a value stands.
 *
 * For a text that has been parsed: nothing is checked again, and nothing outside of it is read.
 */
#ifndef TAUT_IO_JSON_SLICE_H
#define TAUT_IO_JSON_SLICE_H

#include "taut/status.h"

#include <stddef.h>

typedef enum taut_json_place {
    TAUT_JSON_THERE,  /* the bytes from .. to-1 */
    TAUT_JSON_ABSENT, /* a member of an object that is there: it may stand at `from`, == to */
    TAUT_JSON_NOWHERE /* an item of a list, or something inside of what is not there */
} taut_json_place;

typedef struct taut_json_slice {
    taut_json_place place;
    size_t from, to;
    int is_empty;        /* ABSENT: the object has no members yet */
    size_t key, key_end; /* ABSENT: the last word of the pointer, as it is written there */
} taut_json_slice;

/* What a JSON pointer (RFC 6901) leads to: "" is the whole text, "/points/0/3" an item. Cost: linear.
 * TAUT_NO_MEMORY: a key with escapes could not be read. */
taut_status taut_json_slice_find(const char *text, size_t length, const char *pointer,
                                 taut_json_slice *slice);

/* The items of a text that is a list, one after the other: where the next one begins, and its
 * *length. Ask for as many as there are. A text that is no list has none. */
typedef struct taut_json_scan {
    const char *text;
    size_t length, at;
} taut_json_scan;

taut_json_scan taut_json_scan_items(const char *text, size_t length);
const char *taut_json_scan_next(taut_json_scan *scan, size_t *length);

#endif /* TAUT_IO_JSON_SLICE_H */
