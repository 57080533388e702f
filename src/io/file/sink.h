/* sink.h -- text going out: to a file through a large buffer, or into memory.
 *
 * A failure is remembered; later calls do nothing. Check taut_sink_finish once, at the end.
 */
#ifndef TAUT_IO_FILE_SINK_H
#define TAUT_IO_FILE_SINK_H

#include "core/pulse.h"
#include "taut/status.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct taut_sink {
    FILE *file; /* NULL: into memory */
    char *text; /* the buffer, or all of the text */
    size_t length, room;
    taut_status status; /* TAUT_OK, TAUT_IO, TAUT_NO_MEMORY or TAUT_INTERRUPTED */
    int reason;         /* errno with TAUT_IO */
    taut_pulse pulse;   /* its monitor NULL: nobody watches */
} taut_sink;

/* file may be NULL: then the text grows in memory. */
taut_sink taut_sink_to(FILE *file);
/* From here on the monitor, which has to live as long, is told of what is written; an end is TAUT_INTERRUPTED. */
void taut_sink_watch(taut_sink *sink, const taut_monitor *monitor);
void taut_sink_bytes(taut_sink *sink, const char *bytes, size_t length);
void taut_sink_text(taut_sink *sink, const char *text);
void taut_sink_number(taut_sink *sink, double x); /* null where it is not finite */
void taut_sink_count(taut_sink *sink, size_t n);
/* The `count` lowest bytes of a number, the lowest first; 8 at most. */
void taut_sink_low_bytes(taut_sink *sink, uint64_t value, size_t count);
/* Sends what is left to the file and frees the buffer; errno is the reason with TAUT_IO. Into
 * memory: the text stays in sink->text, ended by a 0 byte, and is the caller's (taut_free), or is
 * freed on failure. */
taut_status taut_sink_finish(taut_sink *sink);

#endif /* TAUT_IO_FILE_SINK_H */
