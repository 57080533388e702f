/* csv.c -- the format `csv` (RFC 4180): the table of the model's kind (io/csv/table.h).
 *
 * A line of titles, then one an object of each of the kind's lists, or of a pipe one a bend (io/csv/bends.h); a cell that its object has not is empty. Lengths are in the
 * model's unit, numbers the shortest that come back as the same doubles, lines end as in other text
 * of taut's. */
#include "core/fail.h"
#include "io/csv/bends.h"
#include "io/csv/table.h"
#include "io/file/sink.h"
#include "io/format.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Text with a comma, a quote or an end of line goes in quotes, its own doubled. */
static int is_plain(const char *text)
{
    return strpbrk(text, ",\"\r\n") == NULL;
}

static void write_inside(taut_sink *sink, const char *text)
{
    for (const char *c = text; *c != '\0'; c++) {
        taut_sink_bytes(sink, c, 1);
        taut_sink_text(sink, *c == '"' ? "\"" : "");
    }
}

static void write_text(taut_sink *sink, const char *text)
{
    const char *quote = is_plain(text) ? "" : "\"";

    taut_sink_text(sink, quote);
    write_inside(sink, text);
    taut_sink_text(sink, quote);
}

static void write_cell(taut_sink *sink, const taut_record *cell)
{
    const taut_record_kind kind = cell != NULL ? taut_record_kind_of(cell) : TAUT_RECORD_NULL;

    if (kind == TAUT_RECORD_NUMBER) {
        taut_sink_number(sink, taut_record_number(cell));
    } else if (kind == TAUT_RECORD_TEXT) {
        write_text(sink, taut_record_text(cell));
    }
}

static int is_kind(const taut_record *record, taut_record_kind kind)
{
    return record != NULL && taut_record_kind_of(record) == kind;
}

/* The text that item i of a list is, or begins with; "" where there is none. */
static const char *first_text(const taut_record *list, size_t i)
{
    const taut_record *item = taut_record_at(list, i);
    const taut_record *first = is_kind(item, TAUT_RECORD_LIST) && taut_record_count(item) > 0
                                   ? taut_record_at(item, 0)
                                   : item;
    return is_kind(first, TAUT_RECORD_TEXT) ? taut_record_text(first) : "";
}

static void write_list(taut_sink *sink, const taut_record *list)
{
    const size_t count = is_kind(list, TAUT_RECORD_LIST) ? taut_record_count(list) : 0;
    const char *quote = "";

    for (size_t i = 0; i < count; i++) {
        quote = is_plain(first_text(list, i)) ? quote : "\"";
    }
    taut_sink_text(sink, quote);
    for (size_t i = 0; i < count; i++) {
        taut_sink_text(sink, i > 0 ? " " : "");
        write_inside(sink, first_text(list, i));
    }
    taut_sink_text(sink, quote);
}

/* What a path of members and items leads to; NULL where it leads nowhere. */
static const taut_record *follow(const taut_record *row, const char *path)
{
    while (row != NULL && *path != '\0') {
        char name[32];
        const size_t length = strcspn(path, "/");
        snprintf(name, sizeof name, "%.*s", (int)length, path);
        if (is_kind(row, TAUT_RECORD_LIST)) {
            const size_t item = (size_t)(name[0] - '0');
            row = item < taut_record_count(row) ? taut_record_at(row, item) : NULL;
        } else {
            row = is_kind(row, TAUT_RECORD_OBJECT) ? taut_record_get(row, name) : NULL;
        }
        path += length + (path[length] == '/');
    }
    return row;
}

static void write_column(taut_sink *sink, const taut_csv_kind *kind, size_t list,
                         const taut_csv_column *column, const taut_record *row)
{
    const char *member = column->member[list];
    const taut_record *cell = member != NULL ? follow(row, member) : NULL;

    switch (column->cell) {
    case TAUT_CSV_TEXTS:
        write_list(sink, cell);
        break;
    case TAUT_CSV_KIND:
        write_text(sink, kind->word[list]);
        break;
    default:
        write_cell(sink, cell);
    }
}

static void write_titles(taut_sink *sink, const taut_csv_column *columns)
{
    for (int c = 0; columns[c].title != NULL; c++) {
        taut_sink_text(sink, columns[c].title);
        taut_sink_text(sink, columns[c + 1].title != NULL ? "," : "\n");
    }
}

static void write_row(taut_sink *sink, const taut_csv_kind *kind, size_t list,
                      const taut_record *row)
{
    for (int c = 0; kind->columns[c].title != NULL; c++) {
        taut_sink_text(sink, c > 0 ? "," : "");
        if (is_kind(row, TAUT_RECORD_OBJECT)) {
            write_column(sink, kind, list, &kind->columns[c], row);
        }
    }
    taut_sink_text(sink, "\n");
}

/* The rows of one list, or of the one object that is there in place of it. */
static void write_rows(taut_sink *sink, const taut_csv_kind *kind, size_t list,
                       const taut_record *rows)
{
    if (is_kind(rows, TAUT_RECORD_OBJECT)) {
        write_row(sink, kind, list, rows);
    }
    for (size_t i = 0; is_kind(rows, TAUT_RECORD_LIST) && i < taut_record_count(rows); i++) {
        write_row(sink, kind, list, taut_record_at(rows, i));
    }
}

/* The lines of a bend table; a number that is none is an empty cell. */
static void write_bends(taut_sink *sink, const taut_bend *bends, size_t count)
{
    taut_sink_text(sink, "point,x,y,z,length,rotation,angle,radius\n");
    for (size_t k = 0; k < count; k++) {
        const taut_bend *b = &bends[k];
        const double row[] = {b->point[0], b->point[1], b->point[2], b->length,
                              b->rotation, b->angle,    b->radius};
        taut_sink_count(sink, k + 1);
        for (size_t c = 0; c < sizeof row / sizeof row[0]; c++) {
            taut_sink_text(sink, ",");
            if (isfinite(row[c])) {
                taut_sink_number(sink, row[c]);
            }
        }
        taut_sink_text(sink, "\n");
    }
}

/* A model without a list of its own: the bends of a pipe, or nothing. */
static taut_status write_other(const taut_model *model, FILE *out, taut_error *error)
{
    taut_arena *arena = taut_arena_new();
    size_t count = 0;
    const taut_bend *bends = taut_bends_of(model, arena, &count);
    const taut_status memory = taut_arena_status(arena);
    taut_status status = TAUT_OK;
    if (bends != NULL) {
        taut_sink sink = taut_sink_to(out);
        write_bends(&sink, bends, count);
        status = taut_sink_finish(&sink) == TAUT_NO_MEMORY ? taut_fail_memory(error) : TAUT_OK;
    } else if (memory != TAUT_OK) {
        status = taut_fail_memory(error);
    } else {
        status = taut_fail(error, TAUT_NO_SOLUTION, "no-table", "/details", taut_none, taut_none,
                           "the model has no table, as cables of a film, curves of a net or elbows "
                           "of a pipe are one: write another format");
    }
    taut_arena_free(arena);
    return status;
}

static taut_status write_csv(const taut_model *model, const taut_write_options *options, FILE *out,
                             taut_error *error)
{
    const taut_record *details = taut_model_details(model);
    const taut_csv_kind *kind = taut_csv_table(model);
    taut_sink sink;

    (void)options; /* the table is of the whole model */
    if (kind == NULL) {
        return write_other(model, out, error);
    }
    sink = taut_sink_to(out);
    write_titles(&sink, kind->columns);
    for (size_t k = 0; k < TAUT_CSV_LISTS && kind->list[k] != NULL; k++) {
        write_rows(&sink, kind, k, taut_record_get(details, kind->list[k]));
    }
    return taut_sink_finish(&sink) == TAUT_NO_MEMORY ? taut_fail_memory(error) : TAUT_OK;
}

const taut_format_ops taut_format_csv = {.write = write_csv};
