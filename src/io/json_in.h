/* json_in.h -- JSON documents in: loading, typed getters, and messages that name the place.
 *
 * A `taut_json` is a value together with the way to it, as a chain of places on the stack; the JSON
 * pointer (RFC 6901) is spelled only when something is wrong. Getters check everything: the kind,
 * finiteness, the range; they return TAUT_OK or TAUT_BAD_INPUT with found, expected and the pointer
 * in *error, their outputs untouched. jansson is used here and nowhere else.
 */
#ifndef TAUT_IO_JSON_IN_H
#define TAUT_IO_JSON_IN_H

#include "taut/record.h"
#include "taut/status.h"

#include <jansson.h>
#include <stddef.h>

typedef struct taut_json {
    const json_t *value;        /* borrowed; NULL: a member that is missing */
    const struct taut_json *up; /* the object or array it is in; NULL at the root */
    const char *key;            /* its name there, or NULL: item `index` */
    size_t index;
} taut_json;

/* Parses text; `name` stands for the file in messages. The root is the caller's (json_decref).
 * TAUT_BAD_INPUT with file:line:column where JSON broke; TAUT_NO_MEMORY. */
taut_status taut_json_load_text(const char *text, size_t length, const char *name, json_t **root,
                                taut_error *error);
/* The same from a file, "-" is standard input: also TAUT_IO. */
taut_status taut_json_load(const char *path, json_t **root, taut_error *error);

/* The place of the root. */
taut_json taut_json_root(const json_t *root);
/* Item i of an array: it must be there. */
taut_json taut_json_item(const taut_json *array, size_t i);
/* A member of an object; its value is NULL if it is missing. */
taut_json taut_json_member(const taut_json *object, const char *key);

/* Is it an object, and does it have only members of this list (ended by NULL)? */
taut_status taut_json_object(const taut_json *at, const char *const *members, taut_error *error);
/* Is it an array of least to most items? `items` says of what, in plural: "points". */
taut_status taut_json_array(const taut_json *at, size_t least, size_t most, const char *items,
                            size_t *count, taut_error *error);
taut_status taut_json_number(const taut_json *at, double *value, taut_error *error);
taut_status taut_json_integer(const taut_json *at, int least, int most, int *value,
                              taut_error *error);
/* An array of exactly `count` numbers. */
taut_status taut_json_numbers(const taut_json *at, size_t count, double *values, taut_error *error);
taut_status taut_json_text(const taut_json *at, const char **text, taut_error *error);
/* One of the words of a list ended by NULL; *word is its index. */
taut_status taut_json_word(const taut_json *at, const char *const *words, int *word,
                           taut_error *error);

/* TAUT_BAD_INPUT at this place: "found <what is there>, expected <expected>". */
taut_status taut_json_expected(const taut_json *at, taut_error *error, const char *expected, ...)
    __attribute__((format(printf, 3, 4)));
/* TAUT_BAD_INPUT at this place with a sentence of one's own. */
taut_status taut_json_fail(const taut_json *at, taut_error *error, double found, double limit,
                           const char *format, ...) __attribute__((format(printf, 5, 6)));
/* Puts the pointer of this place before error->where, and returns `status`: for errors that come
 * from checks below that know only the rest of the way. */
taut_status taut_json_within(const taut_json *at, taut_status status, taut_error *error);

/* Any value as a record: the root of *record is an object or a list. */
taut_status taut_json_record(const taut_json *at, taut_record **record, taut_error *error);

/* The name of a list (ended by NULL) that is nearest to `word`, in single edits; NULL if the list
 * is empty. */
const char *taut_nearest(const char *word, const char *const *names);

#endif /* TAUT_IO_JSON_IN_H */
