/* scan.h -- the parser's state, and its tokens. */
#ifndef TAUT_IO_JSON_SCAN_H
#define TAUT_IO_JSON_SCAN_H

#include "io/json/number_value.h"
#include "io/json/pool.h"
#include "io/json/tree.h"

typedef struct taut_json_scan {
    const char *begin, *at, *end; /* the text, and how far it is read */
    taut_pool *pool;              /* where strings go */
    taut_plain_locale plain;
    /* what stopped it, if anything did */
    int no_memory;
    const char *place;  /* in the text */
    const char *reason; /* a sentence, whose %s is what is found there, or NULL */
} taut_json_scan;

/* All of these return 0 when they fail, with the reason in the scan. */

/* Stops at `place` for this reason. Always 0. */
int taut_json_stop(taut_json_scan *scan, const char *place, const char *reason);
int taut_json_stop_memory(taut_json_scan *scan);
/* Skips white space. */
void taut_json_skip(taut_json_scan *scan);
/* A string that begins here, unescaped into the pool. */
int taut_json_scan_string(taut_json_scan *scan, taut_json_value *value);
/* A number, true, false or null. */
int taut_json_scan_word(taut_json_scan *scan, taut_json_value *value);

#endif /* TAUT_IO_JSON_SCAN_H */
