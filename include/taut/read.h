/* taut/read.h -- documents and files in.
 *
 * Problems and models are JSON (docs/format.md). Errors say the file, line and column where JSON
 * broke, or the JSON pointer of the member, what was found and what was expected:
 * TAUT_BAD_INPUT for a document that is wrong, TAUT_NO_SOLUTION for one that is well formed and
 * asks for what does not exist, TAUT_IO for a file that cannot be read, TAUT_NO_MEMORY. All input
 * is taken to be hostile.
 */
#ifndef TAUT_READ_H
#define TAUT_READ_H

#include "taut/construct.h"
#include "taut/model.h"
#include "taut/monitor.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What can be wrong with a document: word, meaning, remedy. */
#define TAUT_DOCUMENT_REASON_LIST(X)                                                               \
    X("syntax", "the text is not JSON in UTF-8, or ends before its document does",                 \
      "correct it at the line and column")                                                         \
    X("depth", "lists and objects are nested too deep", "nest them less")                          \
    X("twice", "an object has a member twice", "leave one of them out")                            \
    X("version", "the member `taut` is no version of the format that is known", "write 1")         \
    X("kind", "a model where a problem is expected, or a problem where a model is",                \
      "give the other document, or make a model from the problem first")                           \
    X("missing", "a member that must be there is not", "add it")                                   \
    X("unknown-member", "an object has a member that it does not take",                            \
      "spell it as docs/format.md does, or leave it out")                                          \
    X("conflict", "members that exclude each other", "leave one of them out")                      \
    X("type", "another JSON type, or another shape of a list, than expected",                      \
      "write what the message expects")                                                            \
    X("value", "the right type, but a value outside of its range",                                 \
      "stay within the limit of the message, or write what it expects")                            \
    X("size", "too many or too few items, points, bytes", "give as many as the message expects")   \
    X("name", "an unknown word", "take one that the message names")

/* path "-" is standard input. The results are the caller's. */
TAUT_API taut_status taut_problem_read(const char *path, taut_problem **problem, taut_error *error);
TAUT_API taut_status taut_model_read(const char *path, taut_model **model, taut_error *error);

/* What is read otherwise; zero: not. */
typedef struct taut_read_options {
    int untrim; /* nonzero: STEP and IGES: trimmed faces are read as the whole surfaces under them, which details.notes says */
    int edges; /* nonzero: STEP and IGES: of trimmed faces the edges, as the last details.edges curves, "FACE.1", "FACE.2", ... */
    taut_monitor
        monitor; /* TAUT_INTERRUPTED where it says stop, or enough. A file that a problem names is read untold */
} taut_read_options;

/* taut_model_read with options, which may be NULL. Faces that are trimmed by more than a box of parameters are TAUT_NO_SOLUTION,
 * reason "trimmed", unless they are untrimmed, or taken by their edges. */
TAUT_API taut_status taut_model_read_with(const char *path, const taut_read_options *options,
                                          taut_model **model, taut_error *error);

/* A file that may be either: *problem or *model is set, the other one to NULL. A document with a
 * member "construct" is a problem. */
TAUT_API taut_status taut_problem_or_model_read(const char *path, taut_problem **problem,
                                                taut_model **model, taut_error *error);

/* taut_problem_or_model_read with options, which may be NULL: those of taut_model_read_with. */
TAUT_API taut_status taut_problem_or_model_read_with(const char *path,
                                                     const taut_read_options *options,
                                                     taut_problem **problem, taut_model **model,
                                                     taut_error *error);

/* The same from memory; messages have `name` in place of the file. Only JSON. */
TAUT_API taut_status taut_problem_read_text(const char *text, size_t length, const char *name,
                                            taut_problem **problem, taut_error *error);
TAUT_API taut_status taut_model_read_text(const char *text, size_t length, const char *name,
                                          taut_model **model, taut_error *error);

/* The problem with another value in one place of its document: a point that was dragged, a number that
 * was typed.
 * pointer   a JSON pointer, such as "/points/0/3": what it leads to is there, or is a member that an
 *           object lacks, which is put in; "" is the whole document
 * value     JSON text of `length` bytes
 * *changed  the caller's; `problem` stays as it was
 * Refused as by taut_problem_read_text; TAUT_BAD_INPUT, reason "missing", at a pointer that leads
 * nowhere. Cost: that of reading the document. */
TAUT_API taut_status taut_problem_change(const taut_problem *problem, const char *pointer,
                                         const char *value, size_t length, taut_problem **changed,
                                         taut_error *error);

/* A document that is one problem, or a list of 1 .. TAUT_OBJECTS_MAX of them; in a list the
 * pointers of errors begin with the item, as "/2/points". */
typedef struct taut_problem_list taut_problem_list;
TAUT_API taut_status taut_problem_list_read(const char *path, taut_problem_list **list,
                                            taut_error *error);
TAUT_API taut_status taut_problem_list_read_text(const char *text, size_t length, const char *name,
                                                 taut_problem_list **list, taut_error *error);
TAUT_API void taut_problem_list_free(taut_problem_list *list); /* NULL is fine */
TAUT_API int taut_problem_list_count(const taut_problem_list *list);
/* Borrowed; i = 0 .. count-1, else NULL. */
TAUT_API const taut_problem *taut_problem_list_at(const taut_problem_list *list, int i);
/* Nonzero: the document is a list, if only of one; 0: it is a problem. */
TAUT_API int taut_problem_list_is_list(const taut_problem_list *list);

/* taut_model_read_text with options, which may be NULL; only the monitor is of use. */
TAUT_API taut_status taut_model_read_text_with(const char *text, size_t length, const char *name,
                                               const taut_read_options *options, taut_model **model,
                                               taut_error *error);

/* Any JSON text as a record; its root must be an object or a list. */
TAUT_API taut_status taut_record_read_text(const char *text, size_t length, const char *name,
                                           taut_record **record, taut_error *error);

/* The word of a list (ended by NULL) that a misspelt one is nearest to, the first of those equally
 * near; *edits (may be NULL): how many letters to put in, leave out or replace, of the first 64 of
 * each word. NULL, and *edits untouched, if the list is empty. */
TAUT_API const char *taut_nearest_word(const char *word, const char *const *words, int *edits);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_READ_H */
