/* taut/record.h -- a tree of named results: numbers, words, truth values, lists, objects.
 *
 * What a construction decided (`details`), what a certificate found (`figures`), what `measure`
 * returns: each is a record, so that one writer prints them all. A record knows nothing of JSON,
 * but has the same shape.
 *
 * Building never fails half way: each call returns void or the new child; when memory runs out the
 * root remembers it and later calls do nothing (a NULL record is accepted and ignored). Check
 * taut_record_status once, at the end. Reading is safe from any thread while nobody adds to any part
 * of the tree; adding is for one thread at a time.
 */
#ifndef TAUT_RECORD_H
#define TAUT_RECORD_H

#include "taut/status.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct taut_record taut_record;

/* What a record is; those of JSON. */
typedef enum taut_record_kind {
    TAUT_RECORD_NULL,
    TAUT_RECORD_BOOL,
    TAUT_RECORD_NUMBER,
    TAUT_RECORD_TEXT,
    TAUT_RECORD_LIST,
    TAUT_RECORD_OBJECT
} taut_record_kind;

/* A new empty object, or NULL when memory runs out. Free the root; children go with it. */
TAUT_API taut_record *taut_record_new(void);
/* A new empty list as root. */
TAUT_API taut_record *taut_record_new_list(void);
TAUT_API void taut_record_free(taut_record *record); /* NULL is fine */
/* A deep copy as a root of its own, or NULL when memory runs out or `record` is NULL. */
TAUT_API taut_record *taut_record_copy(const taut_record *record);

/* Add a member to an object (`key` is copied; a key already there is replaced) or, with key NULL,
 * an item to a list; a list with a key or an object without one adds nothing, and is remembered as
 * TAUT_BAD_ARGUMENT. A number that is not finite becomes null. */
TAUT_API void taut_record_add_null(taut_record *record, const char *key);
TAUT_API void taut_record_add_bool(taut_record *record, const char *key, int value);
TAUT_API void taut_record_add_number(taut_record *record, const char *key, double value);
TAUT_API void taut_record_add_text(taut_record *record, const char *key, const char *value);
TAUT_API void taut_record_add_numbers(taut_record *record, const char *key, int count,
                                      const double *values);
TAUT_API taut_record *taut_record_add_list(taut_record *record, const char *key);
TAUT_API taut_record *taut_record_add_object(taut_record *record, const char *key);
/* Adds a deep copy of `child`. */
TAUT_API void taut_record_add_record(taut_record *record, const char *key,
                                     const taut_record *child);

/* TAUT_OK, or what the first addition to its tree that failed did so with: TAUT_NO_MEMORY (also for
 * a root that is NULL), TAUT_BAD_ARGUMENT. */
TAUT_API taut_status taut_record_status(const taut_record *root);

/* Reading. NULL and wrong kinds are harmless: they give TAUT_RECORD_NULL, NaN, "", 0 or NULL. */
TAUT_API taut_record_kind taut_record_kind_of(const taut_record *record);
TAUT_API int taut_record_bool(const taut_record *record);
TAUT_API double taut_record_number(const taut_record *record);
TAUT_API const char *taut_record_text(const taut_record *record);
/* The number of members or items. */
TAUT_API size_t taut_record_count(const taut_record *record);
/* Member or item i, in the order added, and its key ("" in a list); borrowed. */
TAUT_API const taut_record *taut_record_at(const taut_record *record, size_t i);
TAUT_API const char *taut_record_key(const taut_record *record, size_t i);
/* The member `key` of an object, or NULL; borrowed. Cost: linear in the number of members. */
TAUT_API const taut_record *taut_record_get(const taut_record *record, const char *key);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_RECORD_H */
