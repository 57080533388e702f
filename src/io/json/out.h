/* out.h -- JSON going out, piece by piece.
 *
 * Objects and lists are laid out one item a line, two spaces an indent, or all on one line
 * ("inline": nothing in them breaks the line any more). Commas are put where they belong.
 *
 *     taut_json_out out = taut_json_out_to(file);
 *     taut_json_open(&out, '{');
 *     taut_json_pair_number(&out, "taut", 1);
 *     taut_json_close(&out, '}');
 *     status = taut_json_out_finish(&out);
 */
#ifndef TAUT_IO_JSON_OUT_H
#define TAUT_IO_JSON_OUT_H

#include "io/file/sink.h"
#include "taut/certify.h"
#include "taut/record.h"

typedef struct taut_json_out {
    taut_sink sink;
    int depth;       /* objects and lists that are open */
    int inline_;     /* of these, how many since the outermost inline one; 0: lines are broken */
    int is_first;    /* nothing yet in the innermost */
    int has_key;     /* a key waits for its value */
    int short_knots; /* of B-splines: without the outermost two */
    int threads;     /* of large nets; 0: 1. The text is the same for any number */
} taut_json_out;

taut_json_out taut_json_out_to(FILE *file);      /* NULL: into memory */
void taut_json_open(taut_json_out *out, char c); /* '{' or '[' */
void taut_json_open_inline(taut_json_out *out, char c);
void taut_json_close(taut_json_out *out, char c); /* '}' or ']' */
void taut_json_key(taut_json_out *out, const char *key);
void taut_json_put_number(taut_json_out *out, double x); /* null where it is not finite */
void taut_json_put_numbers(taut_json_out *out, size_t count, const double *x); /* an inline list */
void taut_json_put_text(taut_json_out *out, const char *text);
void taut_json_put_verdict(taut_json_out *out, taut_verdict verdict); /* true, false, null */
/* double points[rows][columns][size], a row a line; rows 0: one inline list of columns items; size
 * 1: plain numbers. */
void taut_json_put_net(taut_json_out *out, size_t rows, size_t columns, size_t size,
                       const double *points);
void taut_json_put_record(taut_json_out *out, const taut_record *record);
/* A key and its value. */
void taut_json_open_pair(taut_json_out *out, const char *key, char c);
void taut_json_pair_number(taut_json_out *out, const char *key, double x);
void taut_json_pair_numbers(taut_json_out *out, const char *key, size_t count, const double *x);
void taut_json_pair_text(taut_json_out *out, const char *key, const char *text);
void taut_json_pair_verdict(taut_json_out *out, const char *key, taut_verdict verdict);
void taut_json_pair_net(taut_json_out *out, const char *key, size_t rows, size_t columns,
                        size_t size, const double *points);
void taut_json_pair_record(taut_json_out *out, const char *key, const taut_record *record);
/* Ends the last line; errors as taut_sink_finish, whose text it leaves in out->sink. */
taut_status taut_json_out_finish(taut_json_out *out);

#endif /* TAUT_IO_JSON_OUT_H */
