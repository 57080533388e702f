/* table.h -- which table a model has.
 *
 * A model keeps what it is a list of in its details: cables of a film, say. One row a kind says under
 * which name that list stands, and which members of its objects are the columns.
 */
#ifndef TAUT_IO_CSV_TABLE_H
#define TAUT_IO_CSV_TABLE_H

#include "taut/model.h"

/* A column: a member of each object, and how the table calls it. */
typedef struct taut_csv_column {
    const char *member, *title; /* "a/b/0": members of members, and items of lists */
    int is_list; /* nonzero: of a list of lists the texts they begin with, with spaces between */
} taut_csv_column;

typedef struct taut_csv_kind {
    const char *list;               /* of objects, in the details */
    const taut_csv_column *columns; /* ended by a member that is NULL */
} taut_csv_kind;

/* The kind of the model's table, with *rows the list, which is not empty; NULL where it has none. */
const taut_csv_kind *taut_csv_table(const taut_model *model, const taut_record **rows);

#endif /* TAUT_IO_CSV_TABLE_H */
