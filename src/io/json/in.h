/* in.h -- JSON documents in: loading, typed getters, and messages that name the place.
 *
 * A `taut_json` is a value together with the way to it, as a chain of places on the stack; the JSON
 * pointer (RFC 6901) is spelled only when something is wrong. Getters check everything: the kind,
 * finiteness, the range; they return TAUT_OK or TAUT_BAD_INPUT with found, expected and the pointer
 * in *error, their outputs untouched.
 */
#ifndef TAUT_IO_JSON_IN_H
#define TAUT_IO_JSON_IN_H

#include "core/printf.h"
#include "io/json/tree.h"
#include "taut/record.h"

#include <stddef.h>

typedef struct taut_json {
    const taut_json_value *value; /* borrowed; NULL: a member that is missing */
    const struct taut_json *up;   /* the object or array it is in; NULL at the root */
    const char *key;              /* its name there, or NULL: item `index` */
    size_t index;
    taut_pulse *pulse; /* told of what is read, or NULL; whoever reads much tells it */
} taut_json;

/* How a value of one's own is read. */
typedef taut_status taut_json_read(const taut_json *at, void *into, taut_error *error);

/* Parses a text, or the file `path` ("-" is standard input), and reads its root: errors as
 * taut_json_parse, and TAUT_IO. The document lives until `read` returns. */
taut_status taut_json_read_text(const char *text, size_t length, const char *name,
                                taut_pulse *pulse, taut_json_read *read, void *into,
                                taut_error *error);
taut_status taut_json_read_file(const char *path, taut_pulse *pulse, taut_json_read *read,
                                void *into, taut_error *error);

/* Item i of an array; its value is NULL if it is missing. */
taut_json taut_json_item(const taut_json *array, size_t i);
/* A member of an object; its value is NULL if it is missing. */
taut_json taut_json_member(const taut_json *object, const char *key);

/* What is there. */
taut_json_kind taut_json_kind_at(const taut_json *at);
/* Its number, items or text; 0, 0 or NULL where it is something else. */
double taut_json_number_at(const taut_json *at);
size_t taut_json_count_at(const taut_json *at);
const char *taut_json_text_at(const taut_json *at);

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
/* The member `key` of an object: true, or false, or not there, which is false too. */
taut_status taut_json_flag(const taut_json *document, const char *key, int *value,
                           taut_error *error);

/* Reads every item of an array of least to most, in their order. */
taut_status taut_json_each(const taut_json *at, size_t least, size_t most, const char *items,
                           taut_json_read *read, void *into, taut_error *error);

/* The members of one object, read one after another: the first failure sticks and turns what comes
 * after it into nothing, so that a run of members is checked once, by the status. */
typedef struct taut_reader {
    const taut_json *object;
    taut_error *error;
    taut_status status;
} taut_reader;

/* Of an object that has only members of this list (ended by NULL; no list: any). */
taut_reader taut_reader_of(const taut_json *object, const char *const *members, taut_error *error);
/* The same of an object inside, where the outer reader has not failed: then it begins as failed. */
taut_reader taut_reader_inside(const taut_reader *outer, const taut_json *object,
                               const char *const *members);
/* Is the member there? */
int taut_reader_has(const taut_reader *reader, const char *key);
void taut_reader_integer(taut_reader *reader, const char *key, int least, int most, int *value);
void taut_reader_number(taut_reader *reader, const char *key, double *value);
/* An array of exactly `count` numbers. */
void taut_reader_numbers(taut_reader *reader, const char *key, size_t count, double *values);
void taut_reader_array(taut_reader *reader, const char *key, size_t least, size_t most,
                       const char *items, size_t *count);
void taut_reader_text(taut_reader *reader, const char *key, const char **text);
void taut_reader_word(taut_reader *reader, const char *key, const char *const *words, int *word);
void taut_reader_flag(taut_reader *reader, const char *key, int *value);
void taut_reader_member(taut_reader *reader, const char *key, taut_json_read *read, void *into);
/* An array of exactly `count` items, item i into the i-th place, of `size` bytes, from `first`. */
void taut_reader_items(taut_reader *reader, const char *key, size_t count, const char *items,
                       taut_json_read *read, void *first, size_t size);
/* The same where the member is there; else what it would fill stays as it is. */
void taut_reader_optional(taut_reader *reader, const char *key, taut_json_read *read, void *into);
void taut_reader_optional_integer(taut_reader *reader, const char *key, int least, int most,
                                  int *value);
void taut_reader_optional_number(taut_reader *reader, const char *key, double *value);
void taut_reader_optional_word(taut_reader *reader, const char *key, const char *const *words,
                               int *word);

/* TAUT_BAD_INPUT at this place: "found <what is there>, expected <expected>". The reason is
 * "missing" where nothing is there, else "value" where numbers or a list are, else "type". */
taut_status taut_json_expected(const taut_json *at, taut_error *error, const char *expected, ...)
    TAUT_PRINTF(3, 4);
/* The same for this reason, where something is there. */
taut_status taut_json_refuse(const taut_json *at, taut_error *error, const char *reason,
                             const char *expected, ...) TAUT_PRINTF(4, 5);
/* TAUT_BAD_INPUT at this place with a sentence of one's own. */
taut_status taut_json_fail(const taut_json *at, taut_error *error, const char *reason, double found,
                           double limit, const char *format, ...) TAUT_PRINTF(6, 7);
/* Puts the pointer of this place before error->where, and returns `status`: for errors that come
 * from checks below that know only the rest of the way. */
taut_status taut_json_within(const taut_json *at, taut_status status, taut_error *error);

/* Any value as a record: the root of *record is an object or a list. */
taut_status taut_json_record(const taut_json *at, taut_record **record, taut_error *error);
/* The same of an object only. */
taut_status taut_json_record_object(const taut_json *at, taut_record **record, taut_error *error);

#endif /* TAUT_IO_JSON_IN_H */
