/* table.h -- which table a model has.
 *
 * A model keeps what it is a list of in its details: cables of a film, say. One row a kind says under which names these lists stand (one after
 * the other in the same columns: pieces of cloth, their seams and their roll), and which members of their objects are the columns.
 */
#ifndef TAUT_IO_CSV_TABLE_H
#define TAUT_IO_CSV_TABLE_H

#include "taut/model.h"

enum { TAUT_CSV_LISTS = 3 /* of a table, at most */ };

/* What a column shows of a member. */
typedef enum taut_csv_cell {
    TAUT_CSV_PLAIN = 0, /* a number or a text */
    TAUT_CSV_TEXTS, /* a list of texts, or of lists that begin with one: these, with spaces between */
    TAUT_CSV_KIND   /* the word of the row's list */
} taut_csv_cell;

/* A column: how the table calls it, and a member of the objects of each list; NULL: none, empty cells. */
typedef struct taut_csv_column {
    const char *title;
    const char *member[TAUT_CSV_LISTS]; /* "a/b/0": members of members, and items of lists */
    taut_csv_cell cell;
} taut_csv_column;

typedef struct taut_csv_kind {
    const char *list
        [TAUT_CSV_LISTS]; /* of objects, in the details, or one object; the first is not empty */
    const char *word[TAUT_CSV_LISTS];
    const taut_csv_column *columns; /* ended by a title that is NULL */
} taut_csv_kind;

/* The kind of the model's table; NULL where it has none. */
const taut_csv_kind *taut_csv_table(const taut_model *model);

#endif /* TAUT_IO_CSV_TABLE_H */
