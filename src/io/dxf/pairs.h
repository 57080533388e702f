/* pairs.h -- the text of a DXF file: lines in pairs, a code of what a value is and the value. */
#ifndef TAUT_IO_DXF_PAIRS_H
#define TAUT_IO_DXF_PAIRS_H

#include "core/arena.h"
#include "taut/status.h"

#include <stddef.h>

typedef struct taut_dxf_pair {
    int code;
    size_t line;       /* of the value, from 1 */
    const char *value; /* within the text, without white space around */
    size_t length;
} taut_dxf_pair;

/* Pairs from `from` up to `to`. */
typedef struct taut_dxf_pairs {
    const taut_dxf_pair *at;
    size_t count;
} taut_dxf_pairs;

/* All of a text. TAUT_BAD_INPUT ("broken") with the line; TAUT_NO_MEMORY. */
taut_status taut_dxf_split(const char *text, size_t length, taut_arena *arena,
                           taut_dxf_pairs *pairs, taut_error *error);

/* Is a pair of this code and value? */
int taut_dxf_is(const taut_dxf_pair *pair, int code, const char *value);
/* The number of a pair. TAUT_BAD_INPUT where it is none, or not finite. */
taut_status taut_dxf_number(const taut_dxf_pair *pair, double *value, taut_error *error);
/* The number of the first pair of a code; *value stays where there is none. */
taut_status taut_dxf_find(taut_dxf_pairs pairs, int code, double *value, taut_error *error);
/* The same for the coordinates of a point: codes `code`, code + 10, code + 20. */
taut_status taut_dxf_find_point(taut_dxf_pairs pairs, int code, double point[3], taut_error *error);
/* The first pair of a code; NULL. */
const taut_dxf_pair *taut_dxf_first(taut_dxf_pairs pairs, int code);

/* A value as a name: UTF-8 (what is none is Windows-1252's), \U+XXXX decoded, in one line, cut to `room`. */
void taut_dxf_name(const taut_dxf_pair *pair, char *name, size_t room);

#endif /* TAUT_IO_DXF_PAIRS_H */
